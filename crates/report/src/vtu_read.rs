//! The film of a `film.vtu` that this program has written.

use oilwedge_study::picture::{FieldValues, FilmPicture, PictureField};
use vtkio::model::{Attribute, DataSet, Piece, Vtk};

use crate::Error;

/// Nodes, triangles, fields and lines of a VTU file.
///
/// # Errors
/// [`Error::Unreadable`]: it is not a file of quadratic triangles as this program writes them.
pub fn from_vtu(bytes: &[u8]) -> Result<FilmPicture, Error> {
    let bad = |why: &str| Error::Unreadable { format: "VTU file", message: why.to_owned() };
    let (rest, lines) = without_lines(bytes);
    let text = String::from_utf8_lossy(bytes);
    let vtk = Vtk::parse_xml(rest.as_slice()).map_err(|error| bad(&error.to_string()))?;
    let DataSet::UnstructuredGrid { pieces, .. } = vtk.data else {
        return Err(bad("it is no unstructured grid"));
    };
    let Some(Piece::Inline(piece)) = pieces.into_iter().next() else {
        return Err(bad("it has no piece"));
    };
    let points: Vec<f64> = piece.points.cast_into().ok_or_else(|| bad("its points are no numbers"))?;
    let points: Vec<[f64; 3]> = points.chunks_exact(3).map(|point| [point[0], point[1], point[2]]).collect();
    let (connectivity, offsets) = piece.cells.cell_verts.into_xml();
    let are_six = offsets.iter().zip(1..).all(|(offset, cell): (&u64, u64)| *offset == 6 * cell);
    let are_nodes = connectivity.iter().all(|node| (*node as usize) < points.len());
    if !are_six || !are_nodes || connectivity.len() != 6 * offsets.len() {
        return Err(bad("its cells are no quadratic triangles on its nodes"));
    }
    let cell = |cell: &[u64]| std::array::from_fn(|k| cell[k] as u32);
    let cells: Vec<[u32; 6]> = connectivity.chunks_exact(6).map(cell).collect();
    Ok(FilmPicture {
        point_data: fields(piece.data.point, points.len(), &text),
        cell_data: fields(piece.data.cell, cells.len(), &text),
        points,
        cells,
        lines,
    })
}

/// The arrays with a number, a vector or a row for each of `count` places, with the units that `text`, the file, has
/// for them.
fn fields(attributes: Vec<Attribute>, count: usize, text: &str) -> Vec<PictureField> {
    let field = |attribute| match attribute {
        Attribute::DataArray(array) => {
            let values: Vec<f64> = array.data.cast_into()?;
            let values = match values.len() {
                numbers if numbers == count => FieldValues::Scalars(values),
                numbers if numbers == 3 * count => {
                    FieldValues::Vectors(values.chunks_exact(3).map(|v| [v[0], v[1], v[2]]).collect())
                }
                numbers if numbers > 0 && numbers % count.max(1) == 0 => {
                    FieldValues::Rows(numbers / count.max(1), values)
                }
                _ => return None,
            };
            Some(PictureField { unit: unit(text, &array.name).to_owned().into(), name: array.name.into(), values })
        }
        Attribute::Field { .. } => None,
    };
    attributes.into_iter().filter_map(field).collect()
}

/// The unit of the array of this name; empty where the file gives none.
fn unit<'a>(text: &'a str, name: &str) -> &'a str {
    let array = text.split_once(&format!("Name=\"{name}\"")).map_or("", |(_, rest)| rest);
    let array = array.split("</DataArray>").next().unwrap_or_default();
    let key = array.split_once("UNITS_LABEL").and_then(|(_, rest)| rest.split_once('>'));
    key.and_then(|(_, rest)| rest.split('<').next()).unwrap_or_default()
}

/// Lines by name.
type Lines = Vec<(String, Vec<[[f64; 3]; 2]>)>;

/// The file without the data of the whole field, which vtkio does not read, and the lines in them.
fn without_lines(bytes: &[u8]) -> (Vec<u8>, Lines) {
    let find = |text: &[u8]| bytes.windows(text.len()).position(|part| part == text);
    let (Some(from), Some(to)) = (find(b"<FieldData>"), find(b"</FieldData>")) else {
        return (bytes.to_vec(), Vec::new());
    };
    if from > to {
        return (bytes.to_vec(), Vec::new());
    }
    let text = String::from_utf8_lossy(&bytes[from..to]);
    let lines = text.split("<DataArray ").skip(1).filter_map(|array| {
        let (head, rest) = array.split_once('>')?;
        let name = head.split("Name=\"").nth(1)?.split('"').next()?;
        let numbers = rest.split('<').next()?.split_whitespace().map(|number| number.parse().ok());
        let numbers: Vec<f64> = numbers.collect::<Option<_>>()?;
        let piece = |six: &[f64]| [[six[0], six[1], six[2]], [six[3], six[4], six[5]]];
        Some((read(name), numbers.chunks_exact(6).map(piece).collect()))
    });
    let lines = lines.collect();
    let rest = [&bytes[..from], &bytes[to + b"</FieldData>".len()..]].concat();
    (rest, lines)
}

/// An attribute of XML as a name.
fn read(name: &str) -> String {
    let name = name.replace("&lt;", "<").replace("&gt;", ">");
    name.replace("&quot;", "\"").replace("&amp;", "&")
}
