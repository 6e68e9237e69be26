//! Fields for inspection: one VTU file of quadratic triangles that ParaView and PyVista open.
//!
//! vtkio writes the XML file with inline base64 data. PyVista, ParaView and VTK read every [`Compression`]; meshio does not know LZ4. Each array has its
//! unit as VTK's information key `UNITS_LABEL`, which vtkio cannot write.

use std::borrow::Cow;

use crate::Error;
use oilwedge_study::picture::{FieldValues, FilmPicture, PictureField};
use vtkio::model::{
    Attribute, Attributes, ByteOrder, CellType, Cells, DataArray, DataSet, UnstructuredGridPiece, Version,
    VertexNumbers, Vtk,
};
use vtkio::xml::Compressor;

/// How the arrays of a VTU file are compressed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Compression {
    /// Not at all.
    None,
    /// LZ4: fast.
    Lz4,
    /// zlib: the smallest files.
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

    /// The compressor of vtkio and its level. At level 0 vtkio would name a compressor, but not compress.
    fn of_vtkio(self) -> (Compressor, u32) {
        match self {
            Self::None => (Compressor::None, 0),
            Self::Lz4 => (Compressor::LZ4, 1),
            Self::Zlib => (Compressor::ZLib, 6),
        }
    }
}

/// The bytes of a VTU file.
///
/// # Errors
/// [`Error`]: lengths that do not fit, a node that is not there, a value that is not finite.
pub fn to_vtu(picture: FilmPicture, compression: Compression) -> Result<Vec<u8>, Error> {
    check(&picture)?;
    let cell_count = picture.cells.len();
    let lines = line_data(&picture.lines);
    let fields = picture.point_data.iter().chain(&picture.cell_data);
    let units: Vec<_> = fields.map(|field| (field.name.clone(), field.unit.clone())).collect();
    let piece = UnstructuredGridPiece {
        points: picture.points.into_flattened().into(),
        cells: Cells {
            cell_verts: VertexNumbers::XML {
                connectivity: picture.cells.into_flattened().into_iter().map(u64::from).collect(),
                offsets: (1..=cell_count as u64).map(|cell| 6 * cell).collect(),
            },
            types: vec![CellType::QuadraticTriangle; cell_count],
        },
        data: Attributes {
            point: picture.point_data.into_iter().map(attribute).collect(),
            cell: picture.cell_data.into_iter().map(attribute).collect(),
        },
    };
    let vtk = Vtk {
        version: Version::new_xml(1, 0),
        title: String::new(),
        byte_order: ByteOrder::LittleEndian,
        data: DataSet::inline(piece),
        file_path: None,
    };
    let (compressor, level) = compression.of_vtkio();
    let file = vtk
        .try_into_xml_format(compressor, level)
        .map_err(Error::format("VTU file"))?;
    let mut bytes = Vec::new();
    file.write(&mut bytes).map_err(Error::format("VTU file"))?;
    // vtkio writes no data of the field as a whole.
    const PLACE: &[u8] = b"<Piece ";
    let place = bytes.windows(PLACE.len()).position(|part| part == PLACE);
    let place = place.ok_or_else(|| Error::format("VTU file")("it has no piece"))?;
    bytes.splice(place..place, lines.into_bytes());
    Ok(with_units(bytes, &units))
}

fn attribute(field: PictureField) -> Attribute {
    Attribute::DataArray(match field.values {
        FieldValues::Scalars(values) => DataArray::scalars(field.name.into_owned(), 1).with_vec(values),
        FieldValues::Vectors(values) => DataArray::vectors(field.name.into_owned()).with_vec(values.into_flattened()),
    })
}

/// The file with the unit of each of these arrays at the end of its element.
fn with_units(file: Vec<u8>, units: &[(Cow<str>, Cow<str>)]) -> Vec<u8> {
    const END: &[u8] = b"</DataArray>";
    let find = |from: usize, what: &[u8]| {
        let place = file[from..].windows(what.len()).position(|window| window == what);
        place.map(|place| from + place)
    };
    let (mut whole, mut written) = (Vec::with_capacity(file.len() + 100 * units.len()), 0);
    for (name, unit) in units {
        // Arrays are in the order of the picture.
        let begin = find(written, format!("Name=\"{name}\"").as_bytes());
        let Some(end) = begin.and_then(|begin| find(begin, END)) else {
            continue;
        };
        whole.extend_from_slice(&file[written..end]);
        let key = format!("<InformationKey name=\"UNITS_LABEL\" location=\"vtkDataArray\">{unit}</InformationKey>");
        whole.extend_from_slice(key.as_bytes());
        written = end;
    }
    whole.extend_from_slice(&file[written..]);
    whole
}

/// The lines as data of the whole field: of each an array of its name, in each row the two points of a piece.
fn line_data(lines: &[(String, Vec<[[f64; 3]; 2]>)]) -> String {
    if lines.is_empty() {
        return String::new();
    }
    let mut text = String::from("<FieldData>");
    for (name, pieces) in lines {
        text += &format!(
            "<DataArray type=\"Float64\" Name=\"{}\" NumberOfComponents=\"6\" NumberOfTuples=\"{}\" format=\"ascii\">",
            escaped(name),
            pieces.len()
        );
        for number in pieces.iter().flatten().flatten() {
            text += &format!("{number:e} ");
        }
        text += "</DataArray>";
    }
    text + "</FieldData>"
}

/// A name as an attribute of XML.
fn escaped(name: &str) -> String {
    let letters = name.chars().filter(|letter| !letter.is_control());
    letters
        .map(|letter| match letter {
            '&' => "&amp;".to_owned(),
            '<' => "&lt;".to_owned(),
            '>' => "&gt;".to_owned(),
            '"' => "&quot;".to_owned(),
            letter => letter.to_string(),
        })
        .collect()
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
            return Err(Error::Length {
                name: field.name.to_string(),
                values: field.values.len(),
                wanted,
            });
        }
        all_finite(&field.name, field.values.numbers())
    })
}

fn all_finite(name: &str, values: &[f64]) -> Result<(), Error> {
    match values.iter().position(|value| !value.is_finite()) {
        None => Ok(()),
        Some(place) => Err(Error::NotFinite {
            name: format!("value {place} of the field {name}"),
            value: values[place],
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vtu_read::from_vtu;

    /// The unit square in two quadratic triangles.
    fn square() -> FilmPicture {
        let plane = [
            (0., 0.),
            (1., 0.),
            (1., 1.),
            (0., 1.),
            (0.5, 0.),
            (1., 0.5),
            (0.5, 0.5),
            (0.5, 1.),
            (0., 0.5),
        ];
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
            let bytes = to_vtu(square(), compression)?;
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
        let without = FilmPicture {
            lines: Vec::new(),
            ..square()
        };
        assert_eq!(from_vtu(&to_vtu(without.clone(), Compression::None)?)?, without);
        assert!(matches!(from_vtu(b"<VTKFile"), Err(Error::Unreadable { .. })));
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
        assert!(matches!(
            to_vtu(picture, Compression::None),
            Err(Error::Length {
                values: 8,
                wanted: 9,
                ..
            })
        ));
        let mut picture = square();
        picture.cells[1][5] = 9;
        assert!(matches!(
            to_vtu(picture, Compression::None),
            Err(Error::Node { cell: 1 })
        ));
        let mut picture = square();
        picture.cell_data[0].values = FieldValues::Scalars(vec![f64::NAN, 0.75]);
        assert!(matches!(
            to_vtu(picture, Compression::None),
            Err(Error::NotFinite { .. })
        ));
    }

    /// vtkio compresses blocks of 32 768 bytes, and writes an empty one where the last is full.
    #[test]
    fn arrays_of_whole_blocks_are_read_back() -> Result<(), Box<dyn std::error::Error>> {
        let mut picture = square();
        picture.points = (0..4096).map(|node| [f64::from(node), 0.0, 0.0]).collect();
        picture.point_data.truncate(1);
        picture.point_data[0].values = FieldValues::Scalars((1..=4096).map(|node| 1.0 / f64::from(node)).collect());
        for compression in [Compression::Lz4, Compression::Zlib] {
            assert_eq!(from_vtu(&to_vtu(picture.clone(), compression)?)?, picture);
        }
        Ok(())
    }
}
