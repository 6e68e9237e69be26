//! The solved film as a picture: nodes of the quadratic triangles and the fields there.

use std::collections::HashMap;

use oilwedge_reynolds::FilmSolution;

use crate::film::Film;
use crate::film_lines::film_lines;

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
    /// Lines by name ([`crate::film_lines`]), each of pieces between two points [m].
    pub lines: Vec<(String, Vec<[[f64; 3]; 2]>)>,
}

/// Where a film is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Surface {
    /// On the cylinder `(R cos phi, R sin phi, z)`.
    Cylinder,
    /// Unrolled, `(R phi, z, 0)`.
    Developed,
}

/// Pressure [Pa] (nowhere below that of a cavity), film thickness [m], viscosity [Pa s] and, of a mass-conserving film,
/// film fraction at the nodes of the solved film, on the cylinder `(R cos phi, R sin phi, z)` or unrolled `(R phi, z, 0)`, where nodes on the cut of a ring stand on both sides of it.
/// Nodes on the edge of a pocket stand on both sides of it too, for the film is thicker on one. The indicator, a value for
/// each triangle, tells what each adds to the error.
pub fn picture(film: &Film, solution: &FilmSolution, indicator: Option<&[f64]>, surface: Surface) -> FilmPicture {
    let (nodes, cells) = numbered(film, surface);
    let radius = film.problem.bearing.radius;
    let place = |&[x, z]: &[f64; 2]| {
        if surface == Surface::Developed {
            return [x, z, 0.0];
        }
        let (sin, cos) = (x / radius).sin_cos();
        [radius * cos, radius * sin, z]
    };
    let problem = &film.problem;
    let floor = problem.cavitation.pressure().unwrap_or(f64::NEG_INFINITY);
    let pressure: Vec<f64> = nodes
        .dofs
        .iter()
        .map(|&dof| problem.pressure_at(solution.unknown[dof]).max(floor))
        .collect();
    let thickness = (nodes.cells.iter().zip(&nodes.positions))
        .flat_map(|(&cell, position)| problem.thickness_at(cell, &[*position]))
        .collect();
    let viscosity = pressure.iter().map(|&p| problem.viscosity_at(p)).collect();
    let mut point_data = vec![
        ("pressure".to_owned(), pressure),
        ("film_thickness".to_owned(), thickness),
        ("viscosity".to_owned(), viscosity),
    ];
    if let Some(fraction) = &solution.film_fraction {
        let values = nodes.dofs.iter().map(|&dof| fraction.values[dof]).collect();
        point_data.push(("film_fraction".to_owned(), values));
    }
    FilmPicture {
        points: nodes.positions.iter().map(place).collect(),
        cells,
        lines: (film_lines(film, solution).into_iter())
            .map(|(name, pieces)| {
                (
                    name,
                    pieces
                        .iter()
                        .map(|piece| [place(&piece[0]), place(&piece[1])])
                        .collect(),
                )
            })
            .collect(),
        point_data,
        cell_data: indicator
            .map(|values| ("error_indicator".to_owned(), values.to_vec()))
            .into_iter()
            .collect(),
    }
}

/// The nodes of the picture, and those of each triangle.
fn numbered(film: &Film, surface: Surface) -> (Nodes, Vec<[u32; 6]>) {
    let mesh = film.system.space().mesh();
    let leftmost = mesh.points().iter().map(|point| point[0]).fold(f64::INFINITY, f64::min);
    // The far side of the cut of a ring; rounding of the last column does not count.
    let cut = match mesh.period() {
        Some(period) if surface == Surface::Developed => leftmost + period * (1.0 - 1e-9),
        _ => f64::INFINITY,
    };
    let mut pocket_of = vec![0u8; mesh.triangles().len()];
    for (number, name) in (1..).zip(film.pockets()) {
        for &cell in mesh.region(name).map_or(&[][..], |region| &region.cells) {
            pocket_of[cell as usize] = number;
        }
    }
    let mut nodes = Nodes::on(film.system.space().dofs());
    let mut cells = Vec::with_capacity(mesh.triangles().len());
    for t in 0..mesh.triangles().len() {
        let dofs = film.system.space().element_dofs(t);
        let positions = mesh.nodes(t);
        let pocket = pocket_of[t];
        cells.push(std::array::from_fn(|i| {
            let side = (positions[i][0] >= cut, pocket);
            nodes.number(dofs[i], side, positions[i], t)
        }));
    }
    (nodes, cells)
}

/// On which side of the cut and in which pocket a node stands.
type Side = (bool, u8);

/// The side of most nodes.
const MAIN: Side = (false, 0);
/// Marks dofs not met yet.
const UNMET: u32 = u32::MAX;

/// Nodes numbered in the order in which they are met.
struct Nodes {
    /// Of each dof on the main side,
    on_main: Vec<u32>,
    /// and elsewhere.
    beside: HashMap<(usize, Side), u32>,
    dofs: Vec<usize>,
    positions: Vec<[f64; 2]>,
    /// A cell at each node, on its side.
    cells: Vec<usize>,
}

impl Nodes {
    fn on(dofs: usize) -> Self {
        Self {
            on_main: vec![UNMET; dofs],
            beside: HashMap::new(),
            dofs: Vec::with_capacity(dofs),
            positions: Vec::with_capacity(dofs),
            cells: Vec::with_capacity(dofs),
        }
    }

    fn number(&mut self, dof: usize, side: Side, position: [f64; 2], cell: usize) -> u32 {
        let number = match side {
            MAIN => &mut self.on_main[dof],
            _ => self.beside.entry((dof, side)).or_insert(UNMET),
        };
        if *number == UNMET {
            *number = self.dofs.len() as u32;
            self.dofs.push(dof);
            self.positions.push(position);
            self.cells.push(cell);
        }
        *number
    }
}
