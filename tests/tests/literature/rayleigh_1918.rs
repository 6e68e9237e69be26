//! Rayleigh, Phil. Mag. 35 (1918) 1: the step bearing.
//!
//! An arc of constant clearance with a deeper part before its end, long along the axis: at mid-length the
//! pressure is linear on both parts and highest at the step,
//! `p = 6 mu U (h1 - h2) / (h1^3/L1 + h2^3/L2)` with h1 over L1 upstream. The ends disturb it like
//! exp(-pi z/(L1 + L2)) at least; 12 arc lengths leave 1e-8 of that. The mesh has its edges on the step and
//! the solution is linear on each side, so only the disturbance by the ends is left: 1e-6 is asked.

use std::sync::Arc;

use oilwedge_mesh::developed::LinerDomain;
use oilwedge_mesh::generate::{Blueprint, Feature, RoundedRectangle, generate};
use oilwedge_reynolds::film_thickness::GrooveDepth;
use oilwedge_reynolds::supply::{BoundaryKind, SupplyRegion};
use oilwedge_reynolds::{FilmProblem, FilmSystem};
use oilwedge_tests::*;

const ARC: f64 = 0.5;
/// The groove leaves narrow lands at its ends: they stay clear of mid-length.
const STEP: f64 = 0.35;

/// The film over a step of that depth [m] and its system, so many arc lengths long.
fn step(depth: f64, arcs: f64) -> (FilmProblem, Arc<FilmSystem>) {
    let length = arcs * RADIUS * ARC;
    let liner = LinerDomain { radius: RADIUS, length, arc: Some((0.0, ARC)) };
    let margin = 0.002 * RADIUS;
    let shape = RoundedRectangle {
        centre: [0.5 * (margin + RADIUS * STEP), 0.0],
        half: [0.5 * (RADIUS * STEP - margin), 0.5 * length - margin],
        corner: 0.0,
    };
    let groove = Feature { name: "groove".into(), shape, meshed: true };
    let blueprint = Blueprint { liner, features: vec![groove], line: None };
    let mesh = generate(&blueprint, &|_| 0.1 * RADIUS * ARC).expect("a good drawing");
    let mut inside = vec![false; mesh.triangles().len()];
    for &cell in &mesh.region("groove").expect("the groove").cells {
        inside[cell as usize] = true;
    }
    let region = |(name, kind): (&str, BoundaryKind)| SupplyRegion {
        name: name.to_owned(),
        kind,
        pressure: 0.0,
        edges: mesh.region(name).expect("a group of the mesh").edges.clone(),
        cells: Vec::new(),
        disc: None,
        film_fraction: None,
    };
    let places = [
        ("end_low", BoundaryKind::End),
        ("end_high", BoundaryKind::End),
        ("arc_from", BoundaryKind::Line),
        ("arc_to", BoundaryKind::Line),
    ];
    let regions = places.map(region).into();
    let mut film = plain_film(length, 0.0, 0.0, SPEED);
    film.film_thickness.push(Arc::new(GrooveDepth { depth, inside }));
    let system = Arc::new(FilmSystem::new(Arc::new(mesh), 2, regions).expect("the mesh fits"));
    (film, system)
}

#[test]
fn pressure_at_the_step() {
    let depth = 0.87 * CLEARANCE;
    let (film, system) = step(depth, 12.0);
    let solved = film.solve(&system).unwrap();
    // The land before the groove is the film's own clearance: a three-part step bearing.
    let margin = 0.002 * RADIUS;
    let (h1, h2) = (CLEARANCE + depth, CLEARANCE);
    let lengths = [margin, RADIUS * STEP - margin, RADIUS * (ARC - STEP)];
    let heights = [h2, h1, h2];
    // Flow q per width: sum over parts of (12 mu / h^3) (U h / 2 - q) L = 0.
    let drive: f64 = (0..3).map(|k| 0.5 * SPEED * RADIUS * lengths[k] / heights[k].powi(2)).sum();
    let resistance: f64 = (0..3).map(|k| lengths[k] / heights[k].powi(3)).sum();
    let flow = drive / resistance;
    let expected = 12.0 * VISCOSITY / h2.powi(3) * (flow - 0.5 * SPEED * RADIUS * h2) * lengths[2];
    let dof = vertex_dof_at(system.space(), [RADIUS * STEP, 0.0]);
    let error = solved.solution.unknown[dof] / expected - 1.0;
    assert!(error.abs() < 1e-6, "{error:e}");
}

#[test]
fn depth_zero_is_no_groove() {
    let (mut film, system) = step(0.0, 2.0);
    let with = film.solve(&system).unwrap().solution.unknown.clone();
    film.film_thickness.pop();
    let without = film.solve(&system).unwrap().solution.unknown.clone();
    let greatest = with.iter().fold(0.0f64, |m, p| m.max(p.abs()));
    assert!(with.iter().zip(&without).all(|(a, b)| (a - b).abs() <= 1e-12 * greatest));
}
