//! The solved film as a picture: nodes of the quadratic triangles and the fields there.

use std::collections::HashMap;

use oilwedge_reynolds::FilmSolution;

use crate::compile::Study;
use crate::vtu::FilmPicture;

/// Pressure [Pa], film thickness [m] and viscosity [Pa s] at the nodes of the solved film, on the cylinder
/// `(R cos phi, R sin phi, z)` or unrolled `(R phi, z, 0)`, where nodes on the cut of a ring stand on both sides of it.
pub fn picture(study: &Study, film: &FilmSolution, unrolled: bool) -> FilmPicture {
    let mesh = study.system.space().mesh();
    let leftmost = mesh.points().iter().map(|point| point[0]).fold(f64::INFINITY, f64::min);
    // The far side of the cut of a ring; rounding of the last column does not count.
    let cut = match mesh.period() {
        Some(period) if unrolled => leftmost + period * (1.0 - 1e-9),
        _ => f64::INFINITY,
    };
    let mut nodes = Nodes::default();
    let mut cells = Vec::with_capacity(mesh.triangles().len());
    for t in 0..mesh.triangles().len() {
        let dofs = study.system.space().element_dofs(t);
        let positions = mesh.nodes(t);
        cells.push(std::array::from_fn(|i| {
            nodes.number(dofs[i], positions[i], positions[i][0] >= cut)
        }));
    }
    let radius = study.problem.bearing.radius;
    let place = |&[x, z]: &[f64; 2]| {
        if unrolled {
            return [x, z, 0.0];
        }
        let (sin, cos) = (x / radius).sin_cos();
        [radius * cos, radius * sin, z]
    };
    let problem = &study.problem;
    let pressure: Vec<f64> = nodes
        .dofs
        .iter()
        .map(|&dof| problem.pressure_at(film.unknown[dof]))
        .collect();
    let viscosity = pressure.iter().map(|&p| problem.viscosity_at(p)).collect();
    FilmPicture {
        points: nodes.positions.iter().map(place).collect(),
        cells,
        point_data: vec![
            ("pressure".to_owned(), pressure),
            ("film_thickness".to_owned(), problem.thickness_at(0, &nodes.positions)),
            ("viscosity".to_owned(), viscosity),
        ],
        cell_data: Vec::new(),
    }
}

/// Nodes numbered in the order in which they are met.
#[derive(Default)]
struct Nodes {
    numbers: HashMap<(usize, bool), u32>,
    dofs: Vec<usize>,
    positions: Vec<[f64; 2]>,
}

impl Nodes {
    fn number(&mut self, dof: usize, position: [f64; 2], beyond_cut: bool) -> u32 {
        *self.numbers.entry((dof, beyond_cut)).or_insert_with(|| {
            self.dofs.push(dof);
            self.positions.push(position);
            (self.dofs.len() - 1) as u32
        })
    }
}
