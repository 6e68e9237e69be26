//! Mesh files of a plain ring whose triangles follow the flow, or do not.

use std::f64::consts::TAU;
use std::path::Path;

use oilwedge_mesh::{Mesh, RawMesh, gmsh};

use oilwedge_tests::random_bearings::Dice;

/// How the nodes of a grid of columns and rows lie.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Points on the grid, its cells cut alike.
    Aligned,
    /// Points on the grid, its cells cut along either diagonal by chance.
    Flipped,
    /// Moved by up to a quarter of a cell in both directions.
    Random,
    /// Points as random, and nearer to each other towards the ends and the thinnest film.
    Graded,
}

impl Kind {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Aligned, Self::Flipped, Self::Random, Self::Graded];
}

/// Greatest move of a node, in cells.
const MOVE: f64 = 0.24;
/// Cells of a graded mesh are longer and shorter than others by up to this part.
const GRADING: f64 = 0.6;

/// The ring of radius and length [m], of so many columns and rows of cells, thinnest at 180 degrees.
///
/// # Panics
/// Never: the cells keep their orientation.
pub fn ring(kind: Kind, [radius, length]: [f64; 2], [columns, rows]: [u32; 2]) -> Mesh {
    let mut dice = Dice::new(u64::from(columns) * 1000 + u64::from(rows));
    let vertex = |i: u32, j: u32| (i % columns) * (rows + 1) + j;
    let is_graded = kind == Kind::Graded;
    // Places between 0 and 1, nearer to each other in the middle of the turn and at the ends.
    let graded = |place: f64, waves: f64, share: f64| place + share / (waves * TAU) * (waves * TAU * place).sin();
    let mut points = Vec::new();
    for i in 0..columns {
        for j in 0..=rows {
            let mut place = [f64::from(i), f64::from(j)];
            if matches!(kind, Kind::Random | Kind::Graded) {
                place[0] += MOVE * dice.between(-1.0, 1.0);
                if j > 0 && j < rows {
                    place[1] += MOVE * dice.between(-1.0, 1.0);
                }
            }
            let [mut x, mut z] = [place[0] / f64::from(columns), place[1] / f64::from(rows)];
            if is_graded {
                (x, z) = (graded(x, 1.0, GRADING), graded(z, 1.0, -GRADING));
            }
            points.push([TAU * radius * x, length * (z - 0.5)]);
        }
    }
    let mut triangles = Vec::new();
    for i in 0..columns {
        for j in 0..rows {
            let [a, b, c, d] = [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)];
            let rising = kind == Kind::Aligned || dice.chance(0.5);
            triangles.extend(if rising { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] });
        }
    }
    let end = |j: u32| (0..columns).map(|i| [vertex(i, j), vertex(i + 1, j)]).collect();
    let raw = RawMesh {
        points,
        triangles,
        curves: vec![("end_low".into(), end(0)), ("end_high".into(), end(rows))],
        period: Some(TAU * radius),
        ..RawMesh::default()
    };
    Mesh::build(raw).expect("a grid has no defects")
}

/// Writes a mesh as a gmsh file.
///
/// # Panics
/// If the file cannot be written.
pub fn write(mesh: &Mesh, path: &Path) {
    std::fs::write(path, gmsh::to_text(mesh)).expect("a folder for tests can be written to");
}
