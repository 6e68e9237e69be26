//! Fields for inspection: one VTU file of quadratic triangles that ParaView, PyVista and meshio open.
//!
//! Few lines of XML tell what there is and where; the numbers follow as they stand in memory (appended raw data, VTK File
//! Formats, "XML File Formats"). As small as base64 of compressed numbers, and written at the speed of the disk.

use std::path::Path;

/// VTK's number of the quadratic triangle.
const QUADRATIC_TRIANGLE: u8 = 22;

/// A film on its triangles: where they are, and the fields on them.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct FilmPicture {
    /// Nodes [m].
    pub points: Vec<[f64; 3]>,
    /// Triangles by their nodes: three vertices, then the middles of edges 01, 12, 20 (as VTK and gmsh have it).
    pub cells: Vec<[u32; 6]>,
    /// Fields on the nodes: name and a value for each node, SI.
    pub point_data: Vec<(String, Vec<f64>)>,
    /// Fields on the triangles: name and a value for each triangle, SI.
    pub cell_data: Vec<(String, Vec<f64>)>,
}

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
    /// The file cannot be written.
    #[error("the picture cannot be written: {0}")]
    Format(String),
}

impl FilmPicture {
    /// The bytes of a VTU file.
    ///
    /// # Errors
    /// [`PictureError`]: lengths that do not fit, a node that is not there, a value that is not finite.
    pub fn to_vtu(self) -> Result<Vec<u8>, PictureError> {
        self.check()?;
        let cells = self.cells.len();
        let mut arrays = Arrays::default();
        let on_points = arrays.fields(&self.point_data);
        let on_cells = arrays.fields(&self.cell_data);
        let points = self.points.as_flattened().iter();
        let points = arrays.add("Float64", "Points", 3, points.map(|x| x.to_le_bytes()));
        let nodes = self.cells.as_flattened().iter();
        let nodes = arrays.add("Int32", "connectivity", 1, nodes.map(|node| node.to_le_bytes()));
        let ends = (0..cells as u32).map(|cell| (6 * (cell + 1)).to_le_bytes());
        let ends = arrays.add("Int32", "offsets", 1, ends);
        let kinds = arrays.add("UInt8", "types", 1, std::iter::repeat_n([QUADRATIC_TRIANGLE], cells));
        let head = format!(
            r#"<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" header_type="UInt64">
<UnstructuredGrid>
<Piece NumberOfPoints="{}" NumberOfCells="{cells}">
<PointData Scalars="pressure">
{on_points}</PointData>
<CellData>
{on_cells}</CellData>
<Points>
{points}</Points>
<Cells>
{nodes}{ends}{kinds}</Cells>
</Piece>
</UnstructuredGrid>
<AppendedData encoding="raw">
_"#,
            self.points.len()
        );
        let tail = "\n</AppendedData>\n</VTKFile>\n";
        let mut bytes = arrays.bytes;
        bytes.extend(tail.as_bytes());
        bytes.splice(0..0, head.into_bytes());
        Ok(bytes)
    }

    /// Writes the VTU file `path`, in one go.
    ///
    /// # Errors
    /// As [`Self::to_vtu`], and [`PictureError::Format`] where the file cannot be written.
    pub fn write(self, path: &Path) -> Result<(), PictureError> {
        let bytes = self.to_vtu()?;
        std::fs::write(path, bytes).map_err(|error| PictureError::Format(format!("{}: {error}", path.display())))
    }

    fn check(&self) -> Result<(), PictureError> {
        let nodes = self.points.len();
        if let Some(cell) = self
            .cells
            .iter()
            .position(|cell| cell.iter().any(|node| *node as usize >= nodes))
        {
            return Err(PictureError::Node { cell });
        }
        if let Some(place) = self
            .points
            .iter()
            .position(|point| point.iter().any(|value| !value.is_finite()))
        {
            return Err(PictureError::NotFinite {
                name: "points".to_string(),
                place,
            });
        }
        let on_nodes = self.point_data.iter().map(|field| (field, nodes));
        let on_cells = self.cell_data.iter().map(|field| (field, self.cells.len()));
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
}

/// Arrays one behind the other, each after its length in bytes.
#[derive(Default)]
struct Arrays {
    bytes: Vec<u8>,
}

impl Arrays {
    /// Appends an array and returns its line of XML.
    fn add<const N: usize>(
        &mut self,
        kind: &str,
        name: &str,
        components: usize,
        numbers: impl ExactSizeIterator<Item = [u8; N]>,
    ) -> String {
        let offset = self.bytes.len();
        let length = N * numbers.len();
        self.bytes.reserve(size_of::<u64>() + length);
        self.bytes.extend((length as u64).to_le_bytes());
        for number in numbers {
            self.bytes.extend_from_slice(&number);
        }
        format!(
            "<DataArray type=\"{kind}\" Name=\"{name}\" NumberOfComponents=\"{components}\" format=\"appended\" offset=\"{offset}\"/>\n"
        )
    }

    fn fields(&mut self, fields: &[(String, Vec<f64>)]) -> String {
        let mut lines = String::new();
        for (name, values) in fields {
            lines += &self.add("Float64", name, 1, values.iter().map(|value| value.to_le_bytes()));
        }
        lines
    }
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

    /// The numbers of the array of that name, as the XML says where they are.
    fn array<const N: usize>(file: &[u8], name: &str) -> Vec<[u8; N]> {
        let mark = b"<AppendedData encoding=\"raw\">\n_";
        let head = file.windows(mark.len()).position(|part| part == mark).expect("a mark") + mark.len();
        let xml = String::from_utf8_lossy(&file[..head]);
        let line = xml
            .lines()
            .find(|line| line.contains(&format!("Name=\"{name}\"")))
            .expect(name);
        let (_, offset) = line.split_once("offset=\"").expect("an offset");
        let offset: usize = offset.trim_end_matches("\"/>").parse().expect("a number");
        let (length, rest) = file[head + offset..].split_first_chunk().expect("a length");
        let (numbers, rest) = rest[..u64::from_le_bytes(*length) as usize].as_chunks();
        assert!(rest.is_empty());
        numbers.to_vec()
    }

    /// `test_pyvista.py` reads it with VTK itself.
    #[test]
    fn what_is_written_is_read_back() -> Result<(), PictureError> {
        let (bytes, square) = (square().to_vtu()?, square());
        let reals = |name: &str| Vec::from_iter(array(&bytes, name).into_iter().map(f64::from_le_bytes));
        let whole = |name: &str| Vec::from_iter(array(&bytes, name).into_iter().map(u32::from_le_bytes));
        assert_eq!(reals("Points"), square.points.as_flattened());
        assert_eq!(whole("connectivity"), square.cells.as_flattened());
        assert_eq!(whole("offsets"), [6, 12]);
        assert_eq!(array(&bytes, "types"), [[QUADRATIC_TRIANGLE]; 2]);
        for (name, values) in square.point_data.iter().chain(&square.cell_data) {
            assert_eq!(&reals(name), values);
        }
        assert!(bytes.ends_with(b"</VTKFile>\n"));
        Ok(())
    }

    #[test]
    fn pictures_that_do_not_fit_together_are_refused() {
        let mut picture = square();
        picture.point_data[0].1.pop();
        assert!(matches!(
            picture.to_vtu(),
            Err(PictureError::Length {
                values: 8,
                wanted: 9,
                ..
            })
        ));
        let mut picture = square();
        picture.cells[1][5] = 9;
        assert!(matches!(picture.to_vtu(), Err(PictureError::Node { cell: 1 })));
        let mut picture = square();
        picture.cell_data[0].1[0] = f64::NAN;
        assert!(matches!(
            picture.to_vtu(),
            Err(PictureError::NotFinite { place: 0, .. })
        ));
    }
}
