//! Sommerfeld, Z. Math. Phys. 50 (1904) 97: the infinitely long bearing.
//!
//! The ends disturb a long film only near themselves (the disturbance decays like
//! exp(-z/R) at least), so at mid-length the closed form is exact to rounding of the mesh error;
//! the load approaches it like 1 - k D/B.

use std::f64::consts::PI;
use std::sync::Arc;

use oilwedge_reynolds::analytical::sommerfeld;
use oilwedge_reynolds::quantities::{load::load, similarity};
use oilwedge_reynolds::supply::BoundaryKind;
use oilwedge_reynolds::{FilmProblem, FilmSystem, Theory};
use oilwedge_tests::*;

const ECCENTRICITY: f64 = 0.5;

/// B/D = 20: exp(-20) = 2e-9 of the disturbance by the ends is left at
/// mid-length, what remains is the mesh error: 1e-6 of the greatest pressure is asked.
#[test]
fn pressure_at_mid_length() {
    let length = 40.0 * RADIUS;
    // Widest film at 0, the sense of rotation positive, film start at the widest film.
    let film = plain_film(length, ECCENTRICITY, PI, SPEED);
    let system = ring_system(768, 64, length, Some(0.0));
    let solved = film.solve(&system).unwrap();
    let greatest = pressure_scale() * sommerfeld::pressure(ECCENTRICITY, 2.0);
    for k in 0..24 {
        let theta = 2.0 * PI * f64::from(k) / 24.0;
        let dof = vertex_dof_at(system.space(), [RADIUS * theta, 0.0]);
        let expected = pressure_scale() * sommerfeld::pressure(ECCENTRICITY, theta);
        let error = (solved.solution.unknown[dof] - expected) / greatest;
        assert!(error.abs() < 1e-6, "theta {theta}: {error:.2e}");
    }
}

/// Sommerfeld numbers follow So(B) = So_inf (1 - k D/B) up to exponentially small terms: two lengths give So_inf.
#[test]
fn load_approaches_the_limit_like_the_inverse_length() {
    let deficit = |slenderness: f64| {
        let length = slenderness * 2.0 * RADIUS;
        let film = plain_film(length, ECCENTRICITY, PI, SPEED);
        let rows = (16.0 * slenderness) as u32;
        let system = ring_system(96, rows, length, Some(0.0));
        let solved = film.solve(&system).unwrap();
        let load = load(&solved);
        let number = similarity::sommerfeld_number(&film.bearing, VISCOSITY, &film.journal, load.magnitude());
        1.0 - number.unwrap() / sommerfeld::sommerfeld_number(ECCENTRICITY)
    };
    let (short, long) = (deficit(6.0), deficit(12.0));
    assert!((short / long - 2.0).abs() < 1e-4, "{short} {long}");
    assert!((2.0 * long - short).abs() < 1e-6, "{short} {long}");
}

/// B [m] of the films of the theory of long bearings: as short as films are, for it does not count.
const SHORT: f64 = 0.2 * RADIUS;

/// Sommerfeld number of a film between sealed ends, and its greatest error of pressure, over the greatest one.
fn long_film(columns: u32) -> [f64; 2] {
    let film = FilmProblem { theory: Theory::Long, ..plain_film(SHORT, ECCENTRICITY, PI, SPEED) };
    let mesh = ring(columns, 4, SHORT, 0.0);
    let mut regions = ends(&mesh, SHORT, Some(0.0));
    for region in regions.iter_mut().filter(|region| region.kind == BoundaryKind::End) {
        region.kind = BoundaryKind::Sealed;
    }
    let system = Arc::new(FilmSystem::new(Arc::new(mesh), 2, regions).expect("the film start closes the ring"));
    let solved = film.solve(&system).unwrap();
    let greatest = sommerfeld::pressure(ECCENTRICITY, 2.0);
    let errors = (0..24).flat_map(|k| [-0.5, 0.0, 0.5].map(|z| (2.0 * PI * f64::from(k) / 24.0, z * SHORT)));
    let errors = errors.map(|(theta, z)| {
        let dof = vertex_dof_at(system.space(), [RADIUS * theta, z]);
        (solved.solution.unknown[dof] / pressure_scale() - sommerfeld::pressure(ECCENTRICITY, theta)).abs() / greatest
    });
    let load = load(&solved);
    let number = similarity::sommerfeld_number(&film.bearing, VISCOSITY, &film.journal, load.magnitude());
    [number.unwrap(), errors.fold(0.0, f64::max)]
}

/// Quadratic elements have nodal pressures and load at an order above 3 (4 if there were one line of them): 1e-6 is
/// there with 192 columns, 1e-7 with 384.
#[test]
fn the_theory_of_long_bearings_is_sommerfelds() {
    let exact = sommerfeld::sommerfeld_number(ECCENTRICITY);
    let films = [96, 192, 384].map(long_film);
    let loads = films.map(|[number, _]| (number / exact - 1.0).abs());
    let pressures = films.map(|[_, error]| error);
    for errors in [loads, pressures] {
        assert!(errors[1] < 1e-6 && errors[2] < 1e-7, "{errors:?}");
        assert!(order(&errors) > 3.0, "{errors:?}");
    }
}

/// Films of finite length come to it from below, twice as near at twice the length.
#[test]
fn finite_length_tends_to_the_theory_of_long_bearings() {
    let [long, _] = long_film(96);
    let deficits = [4.0, 8.0, 16.0].map(|slenderness| {
        let length = slenderness * 2.0 * RADIUS;
        let film = plain_film(length, ECCENTRICITY, PI, SPEED);
        let system = ring_system(96, (16.0 * slenderness) as u32, length, Some(0.0));
        let solved = film.solve(&system).unwrap();
        let load = load(&solved).magnitude();
        1.0 - similarity::sommerfeld_number(&film.bearing, VISCOSITY, &film.journal, load).unwrap() / long
    });
    assert!(deficits.iter().all(|deficit| *deficit > 0.0), "{deficits:?}");
    for pair in deficits.windows(2) {
        assert!((pair[0] / pair[1] - 2.0).abs() < 1e-3, "{deficits:?}");
    }
}
