//! Obstacles that are no zero, and an equation that is not linear, under the model of Swift and Stieber.

use std::sync::Arc;

use oilwedge_reynolds::lubricant::PressureLaw;
use oilwedge_reynolds::lubricant::barus::Barus;
use oilwedge_reynolds::quantities::{cavity::cavity, load::load};
use oilwedge_reynolds::{Cavitation, FilmProblem, FilmSystem, Form, SolvedFilm};
use oilwedge_tests::*;

const LENGTH: f64 = 0.08;

fn film(eccentricity: f64, pressure: f64) -> FilmProblem {
    let mut film = plain_film(LENGTH, eccentricity, 0.3, SPEED);
    film.cavitation = Cavitation::Reynolds { pressure };
    film
}

/// The system of a ring with its ends at `pressure`, with coarser ones behind it.
fn system(film: &FilmProblem, pressure: f64) -> Arc<FilmSystem> {
    let mesh = ring(64, 16, LENGTH, 0.0);
    let mut regions = ends(&mesh, LENGTH, None);
    regions.iter_mut().for_each(|region| region.pressure = pressure);
    let system = FilmSystem::new(Arc::new(mesh), 2, regions).expect("the ends close the ring");
    Arc::new(system.with_coarser(film, oilwedge_reynolds::levels::LevelLayout::Rows))
}

/// Solves, and checks the signs at the middles of edges and the number of iterations.
#[track_caller]
fn solved(film: &FilmProblem, system: &Arc<FilmSystem>, most: usize) -> SolvedFilm {
    let solved = film.solve(system).unwrap_or_else(|reason| panic!("{reason}"));
    let cavity = film.unknown_at(film.cavitation.pressure().expect("a cavity"));
    let flow = solved.solution.inflow.iter().fold(0.0f64, |most, flow| most.max(flow.abs()));
    for edge in 0..system.space().mesh().topology().edges.len() as u32 {
        let dof = system.space().edge_dof(edge);
        let (unknown, inflow) = (solved.solution.unknown[dof], solved.solution.inflow[dof]);
        assert!(unknown >= cavity - 1e-10 * pressure_scale(), "{unknown} at {dof}");
        assert!(!solved.solution.cavity[dof] || inflow >= -1e-9 * flow, "{inflow} of {flow} at {dof}");
    }
    assert!(solved.solution.cavity.contains(&true));
    assert!(solved.solution.history.len() <= most, "{} iterations", solved.solution.history.len());
    solved
}

#[track_caller]
fn same(a: &[f64], b: &[f64], tolerance: f64) {
    let off = a.iter().zip(b).fold(0.0f64, |most, (a, b)| most.max((a - b).abs()));
    assert!(off < tolerance * pressure_scale(), "{off:e}");
}

/// All pressures may be counted from another zero.
#[test]
fn obstacle_above_and_below_zero() {
    for eccentricity in [0.4, 0.95] {
        let zero = film(eccentricity, 0.0);
        let reference = solved(&zero, &system(&zero, 0.0), 12);
        for level in [5e4, -3e5] {
            let shifted = film(eccentricity, level);
            let found = solved(&shifted, &system(&shifted, level), 12);
            assert_eq!(found.solution.cavity, reference.solution.cavity);
            let back: Vec<f64> = found.solution.unknown.iter().map(|p| p - level).collect();
            same(&back, &reference.solution.unknown, 1e-10);
        }
    }
}

/// Barus oil, conservative: linear in the reduced pressure, for any obstacle.
#[test]
fn barus_film_is_that_of_constant_viscosity_in_the_reduced_pressure() {
    let law = Barus { alpha: 1e-8 };
    let mut thick = film(0.6, -5e4);
    thick.lubricant.pressure_law = PressureLaw::Barus(law);
    let found = solved(&thick, &system(&thick, 2e4), 12);
    let level = thick.unknown_at(-5e4);
    let thin = film(0.6, level);
    let expected = solved(&thin, &system(&thin, thick.unknown_at(2e4)), 12);
    same(&found.solution.unknown, &expected.solution.unknown, 1e-10);
}

/// The as-printed form is not linear; towards constant viscosity its film changes in proportion to alpha.
#[test]
fn as_printed_barus_film() {
    for (eccentricity, pressure) in [(0.6, 0.0), (0.6, 3e4), (0.9, 0.0)] {
        let thin = film(eccentricity, pressure);
        let system = system(&thin, pressure);
        let reference = solved(&thin, &system, 12);
        let greatest = reference.solution.unknown.iter().fold(0.0f64, |most, p| most.max(*p));
        let change = |share: f64| {
            let mut thick = thin.clone();
            let law = Barus { alpha: share / greatest };
            thick.lubricant.pressure_law = PressureLaw::Barus(law);
            thick.form = Form::AsPrinted;
            let solved = solved(&thick, &system, 20);
            let raised = solved.solution.unknown.iter().fold(0.0f64, |most, p| most.max(*p));
            raised / greatest - 1.0
        };
        let (small, half, large) = (change(1e-4), change(2e-4), change(0.1));
        assert!(small > 0.0 && (half / small - 2.0).abs() < 0.02, "{small:e} {half:e}");
        assert!(large > 500.0 * small && large < 1.0, "{large}");
    }
}

/// Linear elements ask at their vertices. Both their load and their cavity come to those of quadratic elements on the
/// finest mesh; the load at order 2 in the size, of which 1.6 leaves room for a front that moves from vertex to vertex.
#[test]
fn linear_elements_come_to_the_same_film() {
    let film = film(0.6, 0.0);
    let of_degree = |degree: usize, rows: u32| {
        let mesh = ring(4 * rows, rows, LENGTH, 0.0);
        let regions = ends(&mesh, LENGTH, None);
        let system = FilmSystem::new(Arc::new(mesh), degree, regions).expect("the ends close the ring");
        let system = Arc::new(system.with_coarser(&film, oilwedge_reynolds::levels::LevelLayout::Rows));
        let solved = film.solve(&system).unwrap_or_else(|reason| panic!("{reason}"));
        let least = solved.solution.unknown.iter().copied().fold(f64::INFINITY, f64::min);
        assert!(least >= -1e-10 * pressure_scale() || degree > 1, "{least}");
        (load(&solved).magnitude(), cavity(&solved).share)
    };
    let (exact, share) = of_degree(2, 64);
    let linear = [8, 16, 32].map(|rows| of_degree(1, rows));
    let errors = linear.map(|(load, _)| (load / exact - 1.0).abs());
    assert!(order(&errors) > 1.6 && errors[2] < 3e-3, "{errors:?}");
    assert!((linear[2].1 / share - 1.0).abs() < 0.03, "{} {share}", linear[2].1);
}
