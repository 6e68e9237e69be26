//! Fields for inspection: one VTU file of quadratic triangles that ParaView and PyVista open.
//!
//! Arrays stand in the file as base64 text: meshio mistakes some arrays of equal length for each other where they are
//! appended raw. PyVista, ParaView and VTK read every [`Compression`]; meshio does not know LZ4. Each array of a field
//! has its unit as VTK's information key `UNITS_LABEL`.

use quick_xml::events::BytesText;
use quick_xml::{Error as Xml, Writer};
use rayon::prelude::*;

use self::array::{Array, ArrayNumbers};
use crate::Error;
use oilwedge_study::fields::PRESSURE;
use oilwedge_study::picture::{FieldValues, FilmPicture, PictureField};

mod array;

/// VTK's number of the triangle with six nodes.
const QUADRATIC_TRIANGLE: u8 = 22;

/// How the arrays of a VTU file are compressed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Compression {
    /// No compression.
    None,
    /// LZ4: fast.
    Lz4,
    /// Compressed by zlib: the smallest files.
    Zlib,
}

impl Compression {
    /// Greatest number of nodes of a film that is not compressed by default.
    pub const MOST_PLAIN_NODES: usize = 100_000;

    /// The default for a film: none, or LZ4 where it has more nodes than [`Self::MOST_PLAIN_NODES`].
    pub fn usual(picture: &FilmPicture) -> Self {
        match picture.points.len() > Self::MOST_PLAIN_NODES {
            false => Self::None,
            true => Self::Lz4,
        }
    }

    /// VTK's name of the compressor.
    fn compressor(self) -> Option<&'static str> {
        match self {
            Self::None => None,
            Self::Lz4 => Some("vtkLZ4DataCompressor"),
            Self::Zlib => Some("vtkZLibDataCompressor"),
        }
    }
}

/// Bits of the numbers of a VTU file; the pressure and the places of nodes have 64 in any case.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Precision {
    /// 64 bits.
    #[default]
    Double,
    /// 32 bits.
    Single,
}

/// How the numbers of a VTU file are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct VtuForm {
    /// How they are compressed.
    pub compression: Compression,
    /// Bits of each.
    pub precision: Precision,
}

impl VtuForm {
    /// The default for a film: 64 bits, and [`Compression::usual`].
    pub fn usual(picture: &FilmPicture) -> Self {
        Self { compression: Compression::usual(picture), precision: Precision::Double }
    }
}

/// The bytes of a VTU file.
///
/// # Errors
/// [`Error`]: lengths that do not fit, a node that is not there, a value that is not finite.
pub fn to_vtu(picture: &FilmPicture, form: VtuForm) -> Result<Vec<u8>, Error> {
    check(picture)?;
    let mut file = Writer::new(Vec::new());
    let order = if cfg!(target_endian = "big") { "BigEndian" } else { "LittleEndian" };
    let head = [("type", "UnstructuredGrid"), ("version", "1.0"), ("byte_order", order), ("header_type", "UInt64")];
    let head = head.into_iter().chain(form.compression.compressor().map(|name| ("compressor", name)));
    let grid = |file: &mut Writer<Vec<u8>>| {
        write_lines(file, &picture.lines)?;
        write_piece(file, picture, form)
    };
    file.create_element("VTKFile")
        .with_attributes(head)
        .write_inner_content(|file| {
            file.create_element("UnstructuredGrid").write_inner_content(grid)?;
            Ok::<(), Xml>(())
        })
        .map_err(Error::format("VTU file"))?;
    Ok(file.into_inner())
}

/// The film: fields at the nodes and of the triangles, places of the nodes, triangles.
fn write_piece(file: &mut Writer<Vec<u8>>, picture: &FilmPicture, form: VtuForm) -> Result<(), Xml> {
    let offsets: Vec<u32> = (1..=picture.cells.len() as u32).map(|cell| 6 * cell).collect();
    let types = vec![QUADRATIC_TRIANGLE; picture.cells.len()];
    let points = ArrayNumbers::Float64(picture.points.as_flattened());
    let parts = [
        ("PointData", picture.point_data.iter().map(|field| array(field, form.precision)).collect()),
        ("CellData", picture.cell_data.iter().map(|field| array(field, form.precision)).collect()),
        ("Points", vec![Array::plain("Points", 3, points)]),
        (
            "Cells",
            vec![
                Array::plain("connectivity", 1, ArrayNumbers::UInt32(picture.cells.as_flattened())),
                Array::plain("offsets", 1, ArrayNumbers::UInt32(&offsets)),
                Array::plain("types", 1, ArrayNumbers::UInt8(&types)),
            ],
        ),
    ];
    let sizes = [picture.points.len(), picture.cells.len()].map(|size| size.to_string());
    let sizes = [("NumberOfPoints", sizes[0].as_str()), ("NumberOfCells", sizes[1].as_str())];
    let piece = file.create_element("Piece").with_attributes(sizes);
    piece.write_inner_content(|file| {
        for (name, arrays) in &parts {
            write_part(file, name, arrays, form.compression)?;
        }
        Ok::<(), Xml>(())
    })?;
    Ok(())
}

/// An element of a piece with its arrays. The first scalar and the first vector are those that a viewer shows.
fn write_part(file: &mut Writer<Vec<u8>>, name: &str, arrays: &[Array], compression: Compression) -> Result<(), Xml> {
    let first = |components| arrays.iter().find(|array| array.components == components && array.unit.is_some());
    let shown = [("Scalars", first(1)), ("Vectors", first(3))];
    let shown = shown.iter().filter_map(|(key, array)| Some((*key, array.as_ref()?.name)));
    let texts: Vec<_> = arrays.par_iter().map(|array| array.text(compression)).collect();
    file.get_mut().reserve(texts.iter().map(String::len).sum());
    let part = file.create_element(name).with_attributes(shown);
    part.write_inner_content(|file| {
        for (array, text) in arrays.iter().zip(texts) {
            array.write(file, text)?;
        }
        Ok::<(), Xml>(())
    })?;
    Ok(())
}

fn array(field: &PictureField, precision: Precision) -> Array<'_> {
    let (components, numbers) = match &field.values {
        FieldValues::Scalars(values) => (1, values.as_slice()),
        FieldValues::Vectors(values) => (3, values.as_flattened()),
        FieldValues::Rows(width, values) => (*width, values.as_slice()),
    };
    let numbers = match precision {
        Precision::Single if field.name != PRESSURE.name => ArrayNumbers::Float32(numbers),
        Precision::Single | Precision::Double => ArrayNumbers::Float64(numbers),
    };
    Array { name: &field.name, unit: Some(&field.unit), components, numbers }
}

/// The lines as data of the whole field: of each an array of its name, in each row the two points of a piece.
fn write_lines(file: &mut Writer<Vec<u8>>, lines: &[(String, Vec<[[f64; 3]; 2]>)]) -> Result<(), Xml> {
    if lines.is_empty() {
        return Ok(());
    }
    file.create_element("FieldData").write_inner_content(|file| {
        for (name, pieces) in lines {
            let name: String = name.chars().filter(|letter| !letter.is_control()).collect();
            let rows = pieces.len().to_string();
            let numbers = pieces.as_flattened().as_flattened().iter();
            let numbers: String = numbers.map(|number| format!("{number:e} ")).collect();
            file.create_element("DataArray")
                .with_attributes([
                    ("type", "Float64"),
                    ("Name", name.as_str()),
                    ("NumberOfComponents", "6"),
                    ("NumberOfTuples", rows.as_str()),
                    ("format", "ascii"),
                ])
                .write_text_content(BytesText::from_escaped(numbers))?;
        }
        Ok::<(), Xml>(())
    })?;
    Ok(())
}

fn check(picture: &FilmPicture) -> Result<(), Error> {
    let nodes = picture.points.len();
    let is_missing = |node: &u32| *node as usize >= nodes;
    if let Some(cell) = picture.cells.iter().position(|cell| cell.iter().any(is_missing)) {
        return Err(Error::Node { cell });
    }
    all_finite("points", picture.points.as_flattened())?;
    for (name, pieces) in &picture.lines {
        all_finite(name, pieces.as_flattened().as_flattened())?;
    }
    let on_nodes = picture.point_data.iter().map(|field| (field, nodes));
    let on_cells = picture.cell_data.iter().map(|field| (field, picture.cells.len()));
    on_nodes.chain(on_cells).try_for_each(|(field, wanted)| {
        if field.values.len() != wanted {
            return Err(Error::Length { name: field.name.to_string(), values: field.values.len(), wanted });
        }
        all_finite(&field.name, field.values.numbers())
    })
}

fn all_finite(name: &str, values: &[f64]) -> Result<(), Error> {
    match values.iter().position(|value| !value.is_finite()) {
        None => Ok(()),
        Some(place) => {
            Err(Error::NotFinite { name: format!("value {place} of the field {name}"), value: values[place] })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vtu_read::from_vtu;

    /// ArrayNumbers of 64 bits, so compressed.
    fn plain(compression: Compression) -> VtuForm {
        VtuForm { compression, precision: Precision::Double }
    }

    /// The unit square in two quadratic triangles.
    fn square() -> FilmPicture {
        let plane = [(0., 0.), (1., 0.), (1., 1.), (0., 1.), (0.5, 0.), (1., 0.5), (0.5, 0.5), (0.5, 1.), (0., 0.5)];
        let points: Vec<_> = plane.iter().map(|(x, z)| [*x, *z, 0.0]).collect();
        FilmPicture {
            cells: vec![[0, 1, 2, 4, 5, 6], [0, 2, 3, 6, 7, 8]],
            point_data: vec![
                PictureField {
                    name: "pressure".into(),
                    unit: "Pa".into(),
                    values: FieldValues::Scalars(points.iter().map(|point| 1e5 + point[0] / 3.0).collect()),
                },
                PictureField {
                    name: "volume_flow [m2/s]".into(),
                    unit: "m2/s".into(),
                    values: FieldValues::Vectors(points.clone()),
                },
            ],
            cell_data: vec![PictureField {
                name: "error_indicator".into(),
                unit: "N".into(),
                values: FieldValues::Scalars(vec![0.25, 0.75]),
            }],
            lines: vec![("rim.a&b".into(), vec![[[0.0; 3], [1.0, 0.5, 0.0]]])],
            points,
        }
    }

    #[test]
    fn what_is_written_is_read_back() -> Result<(), Box<dyn std::error::Error>> {
        for (compression, name) in [
            (Compression::None, None),
            (Compression::Lz4, Some("vtkLZ4DataCompressor")),
            (Compression::Zlib, Some("vtkZLibDataCompressor")),
        ] {
            let bytes = to_vtu(&square(), plain(compression))?;
            let text = String::from_utf8_lossy(&bytes);
            assert_eq!(text.contains("compressor="), name.is_some());
            assert!(text.contains(name.unwrap_or_default()));
            for unit in ["Pa", "m2/s", "N"] {
                let key = format!("location=\"vtkDataArray\">{unit}</InformationKey></DataArray>");
                assert_eq!(text.matches(&key).count(), 1, "{unit}");
            }
            assert!(text.contains("Name=\"volume_flow [m2/s]\" NumberOfComponents=\"3\""));
            assert_eq!(from_vtu(&bytes)?, square());
        }
        let without = FilmPicture { lines: Vec::new(), ..square() };
        assert_eq!(from_vtu(&to_vtu(&without, plain(Compression::None))?)?, without);
        assert!(matches!(from_vtu(b"<VTKFile"), Err(Error::Unreadable { .. })));
        Ok(())
    }

    #[test]
    fn numbers_of_32_bits_are_those_of_64_rounded() -> Result<(), Box<dyn std::error::Error>> {
        let read = from_vtu(&to_vtu(&square(), VtuForm { precision: Precision::Single, ..plain(Compression::Lz4) })?)?;
        assert_eq!((&read.points, read.at_points("pressure")), (&square().points, square().at_points("pressure")));
        let (flow, exact) = (read.point_data[1].values.numbers(), square());
        let exact = exact.point_data[1].values.numbers();
        assert!(flow.iter().zip(exact).all(|(flow, exact)| *flow == f64::from(*exact as f32)));
        Ok(())
    }

    #[test]
    fn a_film_of_many_nodes_is_compressed() {
        let mut picture = square();
        picture.points.resize(Compression::MOST_PLAIN_NODES, [0.0; 3]);
        assert_eq!(Compression::usual(&picture), Compression::None);
        picture.points.push([0.0; 3]);
        assert_eq!(Compression::usual(&picture), Compression::Lz4);
    }

    #[test]
    fn pictures_that_do_not_fit_together_are_refused() {
        let mut picture = square();
        picture.point_data[0].values = FieldValues::Scalars(vec![0.0; 8]);
        assert!(matches!(to_vtu(&picture, plain(Compression::None)), Err(Error::Length { values: 8, wanted: 9, .. })));
        let mut picture = square();
        picture.cells[1][5] = 9;
        assert!(matches!(to_vtu(&picture, plain(Compression::None)), Err(Error::Node { cell: 1 })));
        let mut picture = square();
        picture.cell_data[0].values = FieldValues::Scalars(vec![f64::NAN, 0.75]);
        assert!(matches!(to_vtu(&picture, plain(Compression::None)), Err(Error::NotFinite { .. })));
    }

    /// Arrays whose last block is full have no rest behind it.
    #[test]
    fn arrays_of_whole_blocks_are_read_back() -> Result<(), Box<dyn std::error::Error>> {
        let mut picture = square();
        picture.points = (0..4096).map(|node| [f64::from(node), 0.0, 0.0]).collect();
        picture.point_data.truncate(1);
        picture.point_data[0].values = FieldValues::Scalars((1..=4096).map(|node| 1.0 / f64::from(node)).collect());
        for compression in [Compression::Lz4, Compression::Zlib] {
            assert_eq!(from_vtu(&to_vtu(&picture, plain(compression))?)?, picture);
        }
        Ok(())
    }
}
