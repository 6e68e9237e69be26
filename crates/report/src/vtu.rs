//! Fields for inspection: one VTU file of quadratic triangles that ParaView and PyVista open.
//!
//! vtkio writes the XML file with inline base64 data, LZ4 at level 1 (at level 0 it would silently not compress).
//! meshio cannot read LZ4; PyVista, ParaView and VTK can.

use oilwedge_study::picture::FilmPicture;
use vtkio::model::{
    Attribute, Attributes, ByteOrder, CellType, Cells, DataArray, DataSet, UnstructuredGridPiece, Version,
    VertexNumbers, Vtk,
};
use vtkio::xml::Compressor;

/// Why a picture was not written.
#[derive(Debug, thiserror::Error)]
pub enum PictureError {
    /// A field has another length than the nodes or triangles.
    #[error("the field {name} has {values} values for {wanted} places; this is a fault of the program")]
    Length {
        /// Name of the field.
        name: String,
        /// Its length.
        values: usize,
        /// Number of nodes or triangles.
        wanted: usize,
    },
    /// A triangle names a node that is not there.
    #[error("triangle {cell} names a node that is not there; this is a fault of the program")]
    Node {
        /// Number of the triangle.
        cell: usize,
    },
    /// A value is NaN or infinite.
    #[error("the field {name} is not a finite number at place {place}; this is a fault of the program")]
    NotFinite {
        /// Name of the field, or `points`.
        name: String,
        /// Number of the node or triangle.
        place: usize,
    },
    /// vtkio refused.
    #[error("the picture cannot be written: {0}")]
    Format(String),
}

/// The bytes of a VTU file.
///
/// # Errors
/// [`PictureError`]: lengths that do not fit, a node that is not there, a value that is not finite.
pub fn to_vtu(picture: FilmPicture) -> Result<Vec<u8>, PictureError> {
    check(&picture)?;
    let cell_count = picture.cells.len();
    let scalar =
        |(name, values): (String, Vec<f64>)| Attribute::DataArray(DataArray::scalars(name, 1).with_vec(values));
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
            point: picture.point_data.into_iter().map(scalar).collect(),
            cell: picture.cell_data.into_iter().map(scalar).collect(),
        },
    };
    let vtk = Vtk {
        version: Version::new_xml(1, 0),
        title: String::new(),
        byte_order: ByteOrder::LittleEndian,
        data: DataSet::inline(piece),
        file_path: None,
    };
    let file = vtk
        .try_into_xml_format(Compressor::LZ4, 1)
        .map_err(|error| PictureError::Format(error.to_string()))?;
    let mut bytes = Vec::new();
    file.write(&mut bytes)
        .map_err(|error| PictureError::Format(error.to_string()))?;
    Ok(bytes)
}

fn check(picture: &FilmPicture) -> Result<(), PictureError> {
    let nodes = picture.points.len();
    if let Some(cell) = picture
        .cells
        .iter()
        .position(|cell| cell.iter().any(|node| *node as usize >= nodes))
    {
        return Err(PictureError::Node { cell });
    }
    if let Some(place) = picture
        .points
        .iter()
        .position(|point| point.iter().any(|value| !value.is_finite()))
    {
        return Err(PictureError::NotFinite {
            name: "points".to_string(),
            place,
        });
    }
    let on_nodes = picture.point_data.iter().map(|field| (field, nodes));
    let on_cells = picture.cell_data.iter().map(|field| (field, picture.cells.len()));
    for ((name, values), wanted) in on_nodes.chain(on_cells) {
        if values.len() != wanted {
            return Err(PictureError::Length {
                name: name.clone(),
                values: values.len(),
                wanted,
            });
        }
        if let Some(place) = values.iter().position(|value| !value.is_finite()) {
            return Err(PictureError::NotFinite {
                name: name.clone(),
                place,
            });
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

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
            point_data: vec![(
                "pressure".into(),
                points.iter().map(|point| 1e5 + point[0] / 3.0).collect(),
            )],
            cell_data: vec![("error_indicator".into(), vec![0.25, 0.75])],
            points,
        }
    }

    #[test]
    fn what_is_written_is_read_back() -> Result<(), Box<dyn std::error::Error>> {
        let bytes = to_vtu(square())?;
        assert!(String::from_utf8_lossy(&bytes).contains("vtkLZ4DataCompressor"));
        let vtk = Vtk::parse_xml(bytes.as_slice())?;
        let DataSet::UnstructuredGrid { pieces, .. } = vtk.data else {
            panic!("no unstructured grid")
        };
        let piece = pieces
            .into_iter()
            .next()
            .ok_or("no piece")?
            .into_loaded_piece_data(None)?;
        let points: Vec<f64> = piece.points.into_vec().ok_or("points are not f64")?;
        assert_eq!(points, square().points.into_flattened());
        assert_eq!(piece.cells.types, vec![CellType::QuadraticTriangle; 2]);
        let (connectivity, offsets) = piece.cells.cell_verts.into_xml();
        assert_eq!(offsets, [6, 12]);
        assert_eq!(
            connectivity,
            square()
                .cells
                .into_flattened()
                .into_iter()
                .map(u64::from)
                .collect::<Vec<_>>()
        );
        for (read, (name, values)) in [
            (&piece.data.point, &square().point_data[0]),
            (&piece.data.cell, &square().cell_data[0]),
        ] {
            let Attribute::DataArray(array) = &read[0] else {
                panic!("no data array")
            };
            assert_eq!(&array.name, name);
            assert_eq!(array.data.clone().into_vec::<f64>().as_ref(), Some(values));
        }
        Ok(())
    }

    #[test]
    fn pictures_that_do_not_fit_together_are_refused() {
        let mut picture = square();
        picture.point_data[0].1.pop();
        assert!(matches!(
            to_vtu(picture),
            Err(PictureError::Length {
                values: 8,
                wanted: 9,
                ..
            })
        ));
        let mut picture = square();
        picture.cells[1][5] = 9;
        assert!(matches!(to_vtu(picture), Err(PictureError::Node { cell: 1 })));
        let mut picture = square();
        picture.cell_data[0].1[0] = f64::NAN;
        assert!(matches!(to_vtu(picture), Err(PictureError::NotFinite { place: 0, .. })));
    }
}
