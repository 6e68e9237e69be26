//! The least film of any surfaces against closed forms and dense samples.

use std::f64::consts::{FRAC_PI_2, TAU};

use oilwedge_mesh::RawMesh;

use super::*;
use crate::film_thickness::{Eccentricity, Tilt};
use crate::lubricant::{Lubricant, PressureLaw};
use crate::{Cavitation, Form, Theory};

const BEARING: Bearing = Bearing { radius: 0.05, length: 0.05, clearance: 5e-5, end_pressure: 0.0 };

/// A shape of the liner: some function of angle and axial position [m].
#[derive(Debug)]
struct LinerShape(fn(f64, f64) -> f64);

impl FilmContribution for LinerShape {
    fn add(&self, _journal: &JournalState, _cell: usize, positions: &[[f64; 2]], film: &mut [FilmPoint]) {
        for ([x, z], point) in positions.iter().zip(film) {
            point.thickness += (self.0)(x / BEARING.radius, *z);
        }
    }

    fn carried(&self, _parents: &[u32]) -> Arc<dyn FilmContribution> {
        Arc::new(Self(self.0))
    }
}

/// The liner from `first` over `turn` [rad], in columns and rows of squares cut in two.
fn mesh(first: f64, turn: f64) -> Arc<Mesh> {
    const COLUMNS: u32 = 40;
    const ROWS: u32 = 6;
    let is_ring = turn == TAU;
    let across = if is_ring { COLUMNS } else { COLUMNS + 1 };
    let vertex = |i: u32, j: u32| (i % across) * (ROWS + 1) + j;
    let point = |k: u32| {
        let (i, j) = (k / (ROWS + 1), k % (ROWS + 1));
        let angle = first + turn * f64::from(i) / f64::from(COLUMNS);
        [BEARING.radius * angle, BEARING.length * (f64::from(j) / f64::from(ROWS) - 0.5)]
    };
    let cells = (0..COLUMNS).flat_map(|i| (0..ROWS).map(move |j| (i, j)));
    let triangles = cells.flat_map(|(i, j)| {
        let [a, b, c, d] = [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)];
        [[a, b, c], [a, c, d]]
    });
    let raw = RawMesh {
        points: (0..across * (ROWS + 1)).map(point).collect(),
        triangles: triangles.collect(),
        period: is_ring.then_some(TAU * BEARING.radius),
        ..RawMesh::default()
    };
    Arc::new(Mesh::build(raw).expect("a structured liner has no defects"))
}

/// The gap with this shape, searched on the mesh.
fn gap(shape: fn(f64, f64) -> f64, mesh: &Arc<Mesh>) -> Gap {
    let problem = FilmProblem {
        theory: Theory::Full,
        bearing: BEARING,
        journal: JournalState::default(),
        film_thickness: vec![
            Arc::new(Eccentricity { radius: BEARING.radius, clearance: BEARING.clearance }),
            Arc::new(Tilt { radius: BEARING.radius }),
            Arc::new(LinerShape(shape)),
        ],
        lubricant: Lubricant {
            viscosity: 0.02,
            pressure_law: PressureLaw::Constant,
            density: 850.0,
            temperature: None,
        },
        form: Form::Conservative,
        terms: Vec::new(),
        cavitation: Cavitation::None,
        storage: None,
        viscosity_across: None,
        contact: None,
        flow_factors: Vec::new(),
    };
    Gap { bearing: BEARING, shaped: Some(Arc::new(Shaped::of(&problem, mesh))) }
}

fn journals() -> [JournalState; 4] {
    let at = |offset: [f64; 2], tilt: [f64; 2]| JournalState { offset, tilt, ..JournalState::default() };
    [
        at([0.0; 2], [0.0; 2]),
        at([3e-5, -2e-5], [0.0; 2]),
        at([-1e-5, 4.5e-5], [1e-4, -6e-5]),
        at([2e-5, 0.0], [-8e-4, 3e-4]),
    ]
}

#[test]
fn circles_searched_on_the_mesh_have_their_closed_form() {
    let gap = gap(|_, _| 0.0, &mesh(0.0, TAU));
    for journal in journals() {
        let (found, closed) = (gap.thinnest(&journal), BEARING.thinnest(&journal));
        let off = (found.thickness - closed.thickness).abs();
        assert!(off < 1e-13 * BEARING.clearance, "{journal:?}: {off:e}");
        if !journal.is_parallel() {
            assert!((found.z - closed.z).abs() < 1e-12, "{found:?} {closed:?}");
        }
        for angle in [0.3, 2.0, 5.1] {
            let (found, closed) = (gap.reach(&journal, angle), BEARING.reach(&journal, angle));
            assert!((found - closed).abs() < 1e-10 * BEARING.clearance, "{found:e} {closed:e}");
        }
    }
}

#[test]
fn a_pit_with_edges_has_its_least_film_there() {
    // A journal that sinks into a pit of a parabola 0.4 rad to each side touches its edges first, where the slope
    // jumps.
    let pit = |phi: f64, _: f64| 3e-5 * (1.0 - ((phi.rem_euclid(TAU) - 1.0) / 0.4).powi(2)).max(0.0);
    let e = 4e-5;
    let journal = JournalState { offset: [e * 1f64.cos(), e * 1f64.sin()], ..JournalState::default() };
    let edge = BEARING.clearance - e * 0.4f64.cos();
    // The edge lies elsewhere in the triangles of each mesh; along it the film is the same.
    for first in 0..8 {
        let gap = gap(pit, &mesh(0.02 * f64::from(first), TAU));
        let places = [gap.thinnest(&journal), gap.thinnest_at(&journal, -0.025), gap.thinnest_at(&journal, 0.011)];
        for found in places {
            assert!((found.thickness / edge - 1.0).abs() < 1e-9, "{first}: {found:?} {edge:e}");
            assert!(((found.angle.rem_euclid(TAU) - 1.0).abs() - 0.4).abs() < 1e-9, "{first}: {found:?}");
        }
        let reach = gap.reach(&journal, 1.0);
        assert!((reach * 0.4f64.cos() / BEARING.clearance - 1.0).abs() < 1e-9, "{first}: {reach:e}");
    }
}

#[test]
fn the_least_film_of_a_shape_is_that_of_dense_samples() {
    let shape = |phi: f64, z: f64| 1e-5 * (2.0 * (phi - 0.7)).cos() + 2e-5 * (z / 0.025).powi(2);
    let gap = gap(shape, &mesh(0.0, TAU));
    for journal in journals() {
        let found = gap.thinnest(&journal);
        let film = |phi: f64, z: f64| {
            let [x, y] = journal.offset_at(z);
            BEARING.clearance - x * phi.cos() - y * phi.sin() + shape(phi, z)
        };
        assert!((film(found.angle, found.z) - found.thickness).abs() < 1e-18);
        let grid = (0..2000).flat_map(|i| (0..=200).map(move |j| (f64::from(i), f64::from(j))));
        let least = grid.map(|(i, j)| film(TAU * i / 2000.0, BEARING.length * (j / 200.0 - 0.5)));
        let least = least.fold(f64::INFINITY, f64::min);
        let above = (least - found.thickness) / BEARING.clearance;
        assert!((0.0..1e-5).contains(&above), "{journal:?}: {above:e}");
        let reach = gap.reach(&journal, 0.4);
        let there = JournalState { offset: [reach * 0.4f64.cos(), reach * 0.4f64.sin()], ..journal };
        assert!(gap.least(&there).abs() < 1e-11 * BEARING.clearance);
    }
}

#[test]
fn a_section_has_the_least_film_at_its_place() {
    let (circle, crowned) = (gap(|_, _| 0.0, &mesh(0.0, TAU)), gap(|_, z| 0.02 * z * z, &mesh(0.0, TAU)));
    for journal in journals() {
        for z in [-0.025, -0.004, 0.0, 0.025] {
            let closed = BEARING.thinnest_at(&journal, z);
            let found = circle.thinnest_at(&journal, z);
            assert!((found.thickness - closed.thickness).abs() < 1e-13 * BEARING.clearance);
            let crown = crowned.thinnest_at(&journal, z).thickness;
            assert!((crown - closed.thickness - 0.02 * z * z).abs() < 1e-13 * BEARING.clearance);
            assert!(found.z == z);
        }
    }
}

#[test]
fn beside_the_liner_of_an_arc_the_bore_is_circular() {
    let gap = gap(|_, _| 1e-5, &mesh(0.0, FRAC_PI_2));
    for (angle, reach) in [(0.7, 6e-5), (4.0, 5e-5)] {
        let found = gap.reach(&JournalState::default(), angle);
        assert!((found / reach - 1.0).abs() < 1e-10, "{angle}: {found:e}");
    }
}
