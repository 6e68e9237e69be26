//! A slider whose inlet is starved, one-dimensional: where its film re-forms, its load, and the oil in its cavity.
//!
//! Film `h(x)` linear from h1 to h2 < h1; the inlet brings the flow `q = theta1 h1 U/2 = h_f U/2`. In the cavity
//! `theta = h_f/h` at any depth. The film is full from `x_r` on, where `h = h_r > h_f`:
//! `dp/dx = 6 mu U (h - h_f)/h^3`, `p = 0` at `x_r` and at the outlet, so `1/h_r = 2/h_f - 1/h2`, and per width
//! `W = 6 mu U/s^2 (C (h_r - h2) + ln(h_r/h2) + h_f/2 (1/h_r - 1/h2))`, `C = h_f/(2 h_r^2) - 1/h_r`, `s = (h1 - h2)/L`.
//! With h1 = 2 h2 and theta1 = 0.6: h_r = 1.5 h2, midway.
//!
//! The slider is a ring of tiny radius whose journal slides along its axis. Fronts lie within a cell, 1/400 of the
//! length: of the load 2e-3 is asked.

use std::f64::consts::TAU;
use std::sync::Arc;

use oilwedge_reynolds::film_thickness::{FilmContribution, GrooveDepth};
use oilwedge_reynolds::quantities::{flow::flows, load::load};
use oilwedge_reynolds::supply::BoundaryKind;
use oilwedge_reynolds::{Bearing, Cavitation, FilmPoint, FilmProblem, FilmSystem, JournalState, SolvedFilm};
use oilwedge_tests::*;

const ROWS: u32 = 400;
const COLUMNS: u32 = 4;
const LENGTH: f64 = 0.02;
const INLET: f64 = 2e-5;
const OUTLET: f64 = 1e-5;
const SLIDING: f64 = 2.0;
const FRACTION: f64 = 0.6;

/// Thickness that falls linearly in the direction of sliding; `sense` is its sign along z.
#[derive(Debug, Clone, Copy)]
struct Wedge {
    sense: f64,
}

impl FilmContribution for Wedge {
    fn add(&self, _journal: &JournalState, _cell: usize, positions: &[[f64; 2]], film: &mut [FilmPoint]) {
        let slope = (OUTLET - INLET) / LENGTH * self.sense;
        for (&[_, z], point) in positions.iter().zip(film) {
            point.thickness += 0.5 * (INLET + OUTLET) + slope * z;
            point.slope[1] += slope;
        }
    }

    fn carried(&self, _parents: &[u32]) -> Arc<dyn FilmContribution> {
        Arc::new(*self)
    }
}

/// The slider, its system and its width [m]; `pocket` is a range of x [m] from the inlet and its depth [m].
fn slider(sense: f64, fraction: f64, pocket: Option<([f64; 2], f64)>) -> (FilmProblem, Arc<FilmSystem>, f64) {
    let width = LENGTH * f64::from(COLUMNS) / f64::from(ROWS);
    let radius = width / TAU;
    let mesh = ring_of_radius(radius, COLUMNS, ROWS, LENGTH, 0.0);
    let mut regions = ends(&mesh, LENGTH, None);
    let inlet = &mut regions[if sense > 0.0 { 0 } else { 1 }];
    inlet.kind = BoundaryKind::Line;
    inlet.film_fraction = Some(fraction);
    let mut film = plain_film(LENGTH, 0.0, 0.0, 0.0);
    film.bearing = Bearing { radius, length: LENGTH, clearance: OUTLET, end_pressure: 0.0 };
    film.journal.axial_velocity = sense * SLIDING;
    film.film_thickness = vec![Arc::new(Wedge { sense })];
    if let Some(([from, to], depth)) = pocket {
        let place = |t: usize| mesh.corners(t).iter().map(|c| c[1]).sum::<f64>() / 3.0 * sense + 0.5 * LENGTH;
        let inside = (0..mesh.triangles().len()).map(|t| place(t) > from && place(t) < to).collect();
        film.film_thickness.push(Arc::new(GrooveDepth { depth, inside }));
    }
    film.cavitation = Cavitation::Jfo { pressure: 0.0 };
    let system = Arc::new(FilmSystem::new(Arc::new(mesh), 2, regions).expect("the ends close the ring"));
    (film, system, width)
}

/// Load per width [N/m] by the closed form.
fn closed_form(fraction: f64) -> f64 {
    let (h_f, h2) = (fraction * INLET, OUTLET);
    let h_r = 1.0 / (2.0 / h_f - 1.0 / h2);
    let slope = (INLET - OUTLET) / LENGTH;
    let constant = 0.5 * h_f / (h_r * h_r) - 1.0 / h_r;
    let brackets = constant * (h_r - h2) + (h_r / h2).ln() + 0.5 * h_f * (1.0 / h_r - 1.0 / h2);
    6.0 * VISCOSITY * SLIDING / (slope * slope) * brackets
}

/// Pressure [Pa] and film fraction at `x` [m] from the inlet.
fn state(film: &SolvedFilm, sense: f64, x: f64) -> (f64, f64) {
    let dof = vertex_dof_at(film.system.space(), [0.0, sense * (x - 0.5 * LENGTH)]);
    let fraction = film.solution.film_fraction.as_ref().expect("a mass-conserving film");
    (film.solution.unknown[dof], fraction.values[dof])
}

#[test]
fn starved_inlet_has_the_closed_form_in_either_sense() {
    let load_of = |sense: f64| {
        let (film, system, width) = slider(sense, FRACTION, None);
        let solved = film.solve(&system).unwrap_or_else(|reason| panic!("{reason}"));
        let flow = flows(&solved);
        assert!(flow.imbalance < 1e-12, "{:e}", flow.imbalance);
        // What the inlet was told to bring is what is reported.
        let told = FRACTION * INLET * SLIDING / 2.0 * width;
        assert!((flow.throughput / told - 1.0).abs() < 1e-9, "{:e} {told:e}", flow.throughput);
        for x in [0.1, 0.2, 0.4, 0.48] {
            let (p, theta) = state(&solved, sense, x * LENGTH);
            let expected = FRACTION * INLET / (INLET + x * (OUTLET - INLET));
            assert!(p == 0.0 && (theta - expected).abs() < 2e-3, "{p} {theta} {expected}");
        }
        for x in [0.505, 0.6, 0.95] {
            let (p, theta) = state(&solved, sense, x * LENGTH);
            assert!(p > 0.0 && theta == 1.0, "{p} {theta} at {x}");
        }
        load(&solved).total.pressure / width
    };
    let (ahead, back) = (load_of(1.0), load_of(-1.0));
    let expected = closed_form(FRACTION);
    assert!((ahead / expected - 1.0).abs() < 2e-3, "{ahead} {expected}");
    assert!((ahead / back - 1.0).abs() < 1e-10, "{ahead} {back}");
}

/// An inlet with more oil than the wedge can take: `q` of a flooded inlet is `U h1 h2/(h1 + h2)`, a film fraction of
/// 2/3.
#[test]
fn an_inlet_with_plenty_of_oil_is_full_and_has_pressure() {
    for fraction in [0.66, 0.67, 0.8] {
        let (film, system, _) = slider(1.0, fraction, None);
        let solved = film.solve(&system).unwrap_or_else(|reason| panic!("{reason}"));
        let (p, theta) = state(&solved, 1.0, 0.0);
        assert_eq!((p > 0.0, theta == 1.0), (fraction > 2.0 / 3.0, fraction > 2.0 / 3.0), "{fraction}: {p} {theta}");
        assert!(flows(&solved).imbalance < 1e-12);
    }
}

/// A pocket inside the cavity, and one at whose inlet edge the cavity would end: the flow passes, the oil
/// keeps its volume, the load behind the first is that without a pocket.
#[test]
fn jumps_of_the_film_in_the_cavity_and_at_its_edge() {
    let depth = 1.5e-5;
    let (film, system, width) = slider(1.0, FRACTION, Some(([0.1 * LENGTH, 0.3 * LENGTH], depth)));
    let solved = film.solve(&system).unwrap_or_else(|reason| panic!("{reason}"));
    for (x, more) in [(0.05, 0.0), (0.15, depth), (0.25, depth), (0.35, 0.0), (0.45, 0.0)] {
        let (p, theta) = state(&solved, 1.0, x * LENGTH);
        let expected = FRACTION * INLET / (INLET + x * (OUTLET - INLET) + more);
        assert!(p == 0.0 && (theta - expected).abs() < 2e-3, "{p} {theta} {expected}");
    }
    let carried = load(&solved).total.pressure / width;
    let expected = closed_form(FRACTION);
    assert!((carried / expected - 1.0).abs() < 2e-3, "{carried} {expected}");

    for pocket in [[0.3, 0.5], [0.5, 0.7], [0.45, 0.55], [0.9, 1.0]] {
        let (film, system, _) = slider(1.0, FRACTION, Some((pocket.map(|x| x * LENGTH), depth)));
        let solved = film.solve(&system).unwrap_or_else(|reason| panic!("{pocket:?}: {reason}"));
        let flow = flows(&solved);
        assert!(flow.imbalance < 1e-12, "{pocket:?}: {:e}", flow.imbalance);
        let fraction = solved.solution.film_fraction.as_ref().expect("a mass-conserving film");
        assert!(fraction.values.iter().all(|&theta| theta > 0.0 && theta <= 1.0 + 1e-12));
    }
}
