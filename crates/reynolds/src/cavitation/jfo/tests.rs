//! Pseudo-time, the last way out, which no film of the other tests needs.

use std::f64::consts::TAU;
use std::sync::Arc;

use oilwedge_fem::complementarity::WarmStart;
use oilwedge_mesh::{Mesh, RawMesh};

use super::{ActiveSetSearch, DiscreteFilm};
use crate::film_thickness::Eccentricity;
use crate::lubricant::{Lubricant, PressureLaw};
use crate::supply::{BoundaryKind, SupplyRegion};
use crate::terms::{Couette, Poiseuille};
use crate::{Bearing, Cavitation, FilmProblem, FilmSystem, Form, JournalState};

const RADIUS: f64 = 0.05;
const CLEARANCE: f64 = 5e-5;
const LENGTH: f64 = 0.05;
/// Pressure [Pa] of the ends, a tenth of `mu omega/psi^2`, that of the cavity being zero.
const AMBIENT: f64 = 2e5;

/// A ring of `columns` by `rows` cells between ends above the cavitation pressure.
fn ring(columns: u32, rows: u32) -> FilmSystem {
    let vertex = |i: u32, j: u32| (i % columns) * (rows + 1) + j;
    let step = TAU * RADIUS / f64::from(columns);
    let point = |k: u32| {
        let (i, j) = (k / (rows + 1), k % (rows + 1));
        [step * f64::from(i), LENGTH * (f64::from(j) / f64::from(rows) - 0.5)]
    };
    let cells = (0..columns).flat_map(|i| (0..rows).map(move |j| (i, j)));
    let triangles = cells.flat_map(|(i, j)| {
        let [a, b, c, d] = [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)];
        [[a, b, c], [a, c, d]]
    });
    let end = |j: u32| (0..columns).map(|i| [vertex(i, j), vertex(i + 1, j)]).collect();
    let raw = RawMesh {
        points: (0..columns * (rows + 1)).map(point).collect(),
        triangles: triangles.collect(),
        curves: vec![("low".into(), end(0)), ("high".into(), end(rows))],
        period: Some(TAU * RADIUS),
        ..RawMesh::default()
    };
    let mesh = Mesh::build(raw).expect("a structured ring has no defects");
    let regions = ["low", "high"].map(|name| SupplyRegion {
        name: name.into(),
        kind: BoundaryKind::End,
        pressure: AMBIENT,
        edges: mesh.region(name).expect("an end").edges.clone(),
        cells: Vec::new(),
        disc: None,
        film_fraction: None,
    });
    FilmSystem::new(Arc::new(mesh), 2, regions.into()).expect("the ends close the ring")
}

fn problem(eccentricity: f64) -> FilmProblem {
    FilmProblem {
        theory: crate::Theory::Full,
        bearing: Bearing { radius: RADIUS, length: LENGTH, clearance: CLEARANCE, end_pressure: AMBIENT },
        journal: JournalState::at_eccentricity(eccentricity, 1.0, CLEARANCE, 100.0),
        film_thickness: vec![Arc::new(Eccentricity { radius: RADIUS, clearance: CLEARANCE })],
        lubricant: Lubricant {
            viscosity: 0.02,
            pressure_law: PressureLaw::Constant,
            density: 850.0,
            temperature: None,
        },
        form: Form::Conservative,
        terms: vec![Arc::new(Poiseuille), Arc::new(Couette)],
        cavitation: Cavitation::Jfo { pressure: 0.0 },
        flow_factors: Vec::new(),
        storage: None,
        viscosity_across: None,
        contact: None,
    }
}

/// From an empty and from a full start pseudo-time arrives at the film that is found without it.
#[test]
fn pseudo_time_arrives_at_the_film_of_the_active_set() {
    let system = ring(48, 8);
    for eccentricity in [0.6, 0.9] {
        let problem = problem(eccentricity);
        let film = DiscreteFilm::new(&problem, &system, 1.0).expect("a supply");
        let start =
            |broken: bool| WarmStart { u: vec![0.0; system.space().dofs()], held: vec![broken; system.space().dofs()] };
        let expected = ActiveSetSearch::new(&film, start(false)).run().expect("a film");
        assert!(expected.state.cavity.contains(&true) && expected.fallbacks.is_empty());
        for broken in [false, true] {
            let found = ActiveSetSearch::new(&film, start(broken));
            let found = found.run_in_time().expect("a film");
            assert_eq!(found.state.cavity, expected.state.cavity);
            let off = |a: &[f64], b: &[f64]| a.iter().zip(b).fold(0.0f64, |most, (a, b)| most.max((a - b).abs()));
            let (p, theta) =
                (off(&found.state.p, &expected.state.p) / film.scale, off(&found.state.theta, &expected.state.theta));
            assert!(p < 1e-10 && theta < 1e-10, "{p:e} {theta:e}");
        }
    }
}
