//! Fowell, Olver, Gosman, Spikes, Pegg, J. Tribol. 129 (2007) 336: a slider with a pocket that cavitates.
//!
//! One-dimensional, steady, mass conserving; ambient pressure 1 bar above the cavitation pressure. The film ruptures at
//! the inlet edge of the pocket and re-forms inside it; the flow is the same everywhere, also through the cavity.
//! Numbers from the closed form (`tests/data/journal_bearings.json`). The pad is a ring of tiny radius whose journal
//! slides along its axis: z is the direction of sliding, and around the ring nothing changes. The conductance of a cell
//! is that of its middle, so errors are of order 2 with 1000 steps along the pad: 1e-4 of the flow and 1e-3 of the
//! length, pressure and load are asked.

use std::f64::consts::TAU;
use std::sync::Arc;

use oilwedge_reynolds::film_thickness::{FilmContribution, GrooveDepth};
use oilwedge_reynolds::quantities::{flow::flows, load::load};
use oilwedge_reynolds::{Bearing, Cavitation, FilmPoint, FilmProblem, FilmSystem, JournalState};
use oilwedge_tests::journal_bearings::{block, number};
use oilwedge_tests::*;
use serde_json::Value;

/// Cells along the pad, and around the ring; the edges of the pocket are on edges of cells.
const ROWS: u32 = 500;
const COLUMNS: u32 = 4;

/// A film that grows linearly from `start` [m] at z = 0 with `slope`.
#[derive(Debug, Clone, Copy)]
struct Pad {
    start: f64,
    slope: f64,
}

impl FilmContribution for Pad {
    fn add(&self, _journal: &JournalState, _cell: usize, positions: &[[f64; 2]], film: &mut [FilmPoint]) {
        for (&[_, z], point) in positions.iter().zip(film) {
            point.thickness += self.start + self.slope * z;
            point.slope[1] += self.slope;
        }
    }

    fn carried(&self, _parents: &[u32]) -> Arc<dyn FilmContribution> {
        Arc::new(*self)
    }
}

/// The pad, its system and its width [m].
fn pad(setup: &Value, depth: f64, cavitation: Cavitation) -> (FilmProblem, Arc<FilmSystem>, f64) {
    let length = number(setup, "L");
    let width = length * f64::from(COLUMNS) / f64::from(ROWS);
    let radius = width / TAU;
    let mesh = ring_of_radius(radius, COLUMNS, ROWS, length, 0.0);
    let mut regions = ends(&mesh, length, None);
    let ambient = number(setup, "p_amb");
    for region in &mut regions {
        region.pressure = ambient;
    }
    let (from, to) = (number(setup, "pocket_start"), number(setup, "pocket_length"));
    let inside = (0..mesh.triangles().len())
        .map(|t| {
            let x = mesh.corners(t).iter().map(|corner| corner[1]).sum::<f64>() / 3.0 + 0.5 * length;
            x > from && x < from + to
        })
        .collect();
    let (inlet, outlet) = (number(setup, "h_max"), number(setup, "h_min"));
    let mut film = plain_film(length, 0.0, 0.0, 0.0);
    film.bearing = Bearing { radius, length, clearance: outlet, end_pressure: ambient };
    film.journal.axial_velocity = number(setup, "U");
    film.lubricant.viscosity = number(setup, "mu");
    film.film_thickness = vec![
        Arc::new(Pad { start: 0.5 * (inlet + outlet), slope: (outlet - inlet) / length }),
        Arc::new(GrooveDepth { depth, inside }),
    ];
    film.cavitation = cavitation;
    let system = Arc::new(FilmSystem::new(Arc::new(mesh), 2, regions).expect("the ends close the ring"));
    (film, system, width)
}

/// Pressure [Pa] at the vertices along the pad, at `x` from its inlet.
fn pressures(film: &FilmProblem, system: &Arc<FilmSystem>, unknown: &[f64]) -> Vec<[f64; 2]> {
    let length = film.bearing.length;
    let step = length / f64::from(ROWS);
    (0..=ROWS)
        .map(|k| {
            let x = step * f64::from(k);
            let dof = vertex_dof_at(system.space(), [0.0, x - 0.5 * length]);
            [x, film.pressure_at(unknown[dof])]
        })
        .collect()
}

#[track_caller]
fn close(value: f64, expected: f64, tolerance: f64) {
    let error = (value - expected).abs();
    assert!(error < tolerance, "{value:e} is {error:.3e} off {expected:e}");
}

#[test]
fn pocketed_pad() {
    let case = block("fowell_2007_pocket_slider");
    let (setup, results) = (&case["setup"], &case["results"]);
    let depth = number(setup, "pocket_depth");
    let (film, system, width) = pad(setup, depth, Cavitation::Jfo { pressure: 0.0 });
    let solved = film.solve(&system).unwrap_or_else(|reason| panic!("{reason}"));
    let flow = number(results, "flow_per_width_m2_s");
    let found = flows(&solved);
    assert!(found.imbalance < 1e-12, "{:e}", found.imbalance);
    close(found.regions[0].net / width, flow, 1e-4 * flow);
    close(-found.regions[1].net / width, flow, 1e-4 * flow);

    let line = pressures(&film, &system, &solved.solution.unknown);
    let at = |x: f64| {
        let nearest = line.iter().min_by(|a, b| (a[0] - x).abs().total_cmp(&(b[0] - x).abs()));
        nearest.map_or(f64::NAN, |node| node[1])
    };
    let exit = number(results, "p_pocket_exit_Pa");
    close(at(0.005), exit, 1e-3 * exit);
    let before = number(results, "p_at_x_1mm_Pa");
    close(at(0.001), before, 1e-3 * before);
    // The film is full up to the pocket, and again from where its pressure, carried on, is zero.
    let near = 1e-6 * exit;
    let pocket = number(setup, "pocket_start");
    assert!(line.iter().all(|[x, p]| *x > pocket - 1e-9 || *p > near));
    assert!(at(0.0025).abs() < near && at(0.0035).abs() < near);
    let full: Vec<_> = line.iter().filter(|[x, p]| *x > 0.0025 && *p > near).collect();
    let [[x1, p1], [x2, p2]] = [full[1], full[2]];
    let front = x1 - p1 * (x2 - x1) / (p2 - p1);
    close(front, number(results, "reformation_x_m"), 1e-3 * number(setup, "L"));

    let carried = number(results, "load_N_per_m_gauge");
    let above_ambient = load(&solved).total.pressure / width - number(setup, "p_amb") * film.bearing.length;
    close(above_ambient, carried, 1e-3 * carried);
}

/// A pad without pocket and cavitation: the flow is U/2 Int h^-2 dx / Int h^-3 dx, and the pressure rises nowhere below
/// ambient.
#[test]
fn plain_pad() {
    let case = block("fowell_2007_pocket_slider");
    let setup = &case["setup"];
    let (h1, h2) = (number(setup, "h_max"), number(setup, "h_min"));
    // Integrals over a linear film: (1/h2 - 1/h1), (1/h2^2 - 1/h1^2)/2, both over the slope.
    let flow = 0.5 * number(setup, "U") * (1.0 / h2 - 1.0 / h1) / (0.5 * (h2.powi(-2) - h1.powi(-2)));
    for cavitation in [Cavitation::None, Cavitation::Jfo { pressure: 0.0 }] {
        let (film, system, width) = pad(setup, 0.0, cavitation);
        let solved = film.solve(&system).unwrap_or_else(|reason| panic!("{reason}"));
        close(flows(&solved).regions[0].net / width, flow, 1e-6 * flow);
        let lowest = pressures(&film, &system, &solved.solution.unknown);
        let lowest = lowest.iter().map(|node| node[1]).fold(f64::INFINITY, f64::min);
        close(lowest, 1e5, 1.0);
    }
}
