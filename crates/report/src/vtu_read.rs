//! The film of a `film.vtu` that this program has written.

use oilwedge_study::picture::{FieldValues, FilmPicture, PictureField};
use quick_xml::events::{BytesStart, Event};
use quick_xml::{Error as Xml, Reader};

use crate::Error;
use crate::vtu::Compression;
use crate::vtu::array::bytes_of;

/// An array of the file.
#[derive(Default)]
struct ReadArray {
    /// The element in which it stands.
    part: String,
    name: String,
    /// VTK's name of its type.
    kind: String,
    format: String,
    text: String,
    unit: String,
}

/// Nodes, triangles, fields and lines of a VTU file.
///
/// # Errors
/// [`Error::Unreadable`]: it is not a file of quadratic triangles as this program writes them.
pub fn from_vtu(bytes: &[u8]) -> Result<FilmPicture, Error> {
    let bad = |message: String| Error::Unreadable {
        format: "VTU file",
        message,
    };
    let (arrays, compressor) = arrays(bytes).map_err(|error| bad(error.to_string()))?;
    let compressions = [Compression::None, Compression::Lz4, Compression::Zlib];
    let compression = compressions
        .into_iter()
        .find(|it| it.compressor() == compressor.as_deref());
    let compression = compression.ok_or_else(|| bad("its compressor is not known".to_owned()))?;
    let numbers = |array: &ReadArray| {
        let numbers = array.numbers(compression);
        numbers.ok_or_else(|| bad(format!("its array \"{}\" is not as this program writes it", array.name)))
    };
    let of = |part: &'static str| arrays.iter().filter(move |array| array.part == part);
    let cells = |name: &str| {
        let array = of("Cells").find(|array| array.name == name);
        array.map_or(Ok(Vec::new()), numbers)
    };
    let points = of("Points").next().ok_or_else(|| bad("it has no points".to_owned()))?;
    let points = rows(&numbers(points)?);
    let (nodes, offsets) = (cells("connectivity")?, cells("offsets")?);
    let are_six = offsets
        .iter()
        .zip(1..)
        .all(|(offset, cell)| *offset == f64::from(6 * cell));
    let are_nodes = nodes.iter().all(|node| *node < points.len() as f64);
    if !are_six || !are_nodes || nodes.len() != 6 * offsets.len() {
        return Err(bad("its cells are no quadratic triangles on its nodes".to_owned()));
    }
    let cells: Vec<[u32; 6]> = rows(&nodes)
        .into_iter()
        .map(|cell| cell.map(|node| node as u32))
        .collect();
    let fields = |part, count| {
        let fields = of(part).filter_map(|array| field(array, numbers(array), count).transpose());
        fields.collect::<Result<_, Error>>()
    };
    let line = |array: &ReadArray| {
        let pieces = rows(&numbers(array)?).into_iter();
        let pieces = pieces.map(|[a, b, c, d, e, f]| [[a, b, c], [d, e, f]]);
        Ok((array.name.clone(), pieces.collect()))
    };
    Ok(FilmPicture {
        point_data: fields("PointData", points.len())?,
        cell_data: fields("CellData", cells.len())?,
        lines: of("FieldData").map(line).collect::<Result<_, Error>>()?,
        points,
        cells,
    })
}

/// The arrays of a file, in their order, and its compressor.
fn arrays(bytes: &[u8]) -> Result<(Vec<ReadArray>, Option<String>), Xml> {
    let (mut arrays, mut compressor) = (Vec::new(), None);
    let (mut part, mut open, mut is_unit) = (String::new(), ReadArray::default(), false);
    let mut reader = Reader::from_reader(bytes);
    loop {
        match reader.read_event()? {
            Event::Start(element) => match element.name().as_ref() {
                b"VTKFile" => compressor = attribute(&element, "compressor")?,
                b"InformationKey" => is_unit = attribute(&element, "name")?.as_deref() == Some("UNITS_LABEL"),
                b"DataArray" => {
                    let text = |name| Ok::<_, Xml>(attribute(&element, name)?.unwrap_or_default());
                    open = ReadArray {
                        part: part.clone(),
                        name: text("Name")?,
                        kind: text("type")?,
                        format: text("format")?,
                        ..ReadArray::default()
                    };
                }
                name => part = String::from_utf8_lossy(name).into_owned(),
            },
            Event::Text(text) if is_unit => open.unit += &text.unescape()?,
            Event::Text(text) => open.text += &text.unescape()?,
            Event::End(element) => match element.name().as_ref() {
                b"InformationKey" => is_unit = false,
                b"DataArray" => arrays.push(std::mem::take(&mut open)),
                _ => (),
            },
            Event::Eof => return Ok((arrays, compressor)),
            _ => (),
        }
    }
}

fn attribute(element: &BytesStart, name: &str) -> Result<Option<String>, Xml> {
    let value = element.try_get_attribute(name)?;
    value.map(|value| Ok(value.unescape_value()?.into_owned())).transpose()
}

impl ReadArray {
    /// Its numbers; `None` where it is not as this program writes it.
    fn numbers(&self, compression: Compression) -> Option<Vec<f64>> {
        if self.format == "ascii" {
            let numbers = self.text.split_whitespace().map(|number| number.parse().ok());
            return numbers.collect();
        }
        let bytes = bytes_of(self.text.trim_ascii().as_bytes(), compression)?;
        let (eights, rest) = bytes.as_chunks::<8>();
        match self.kind.as_str() {
            "Float64" if rest.is_empty() => Some(eights.iter().map(|number| f64::from_le_bytes(*number)).collect()),
            "UInt64" if rest.is_empty() => {
                Some(eights.iter().map(|number| u64::from_le_bytes(*number) as f64).collect())
            }
            "UInt8" => Some(bytes.into_iter().map(f64::from).collect()),
            _ => None,
        }
    }
}

/// The numbers in rows of `N`.
fn rows<const N: usize>(numbers: &[f64]) -> Vec<[f64; N]> {
    numbers.as_chunks::<N>().0.to_vec()
}

/// The field of an array that has a number or a vector for each of `count` places; `None` of others.
fn field(array: &ReadArray, numbers: Result<Vec<f64>, Error>, count: usize) -> Result<Option<PictureField>, Error> {
    let numbers = numbers?;
    let values = match numbers.len() {
        length if length == count => FieldValues::Scalars(numbers),
        length if length == 3 * count => FieldValues::Vectors(rows(&numbers)),
        _ => return Ok(None),
    };
    Ok(Some(PictureField {
        name: array.name.clone().into(),
        unit: array.unit.clone().into(),
        values,
    }))
}
