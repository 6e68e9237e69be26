//! Sommerfeld, Z. Math. Phys. 50 (1904) 97: the infinitely long bearing.
//!
//! The ends disturb a long film only near themselves (the disturbance decays like
//! exp(-z/R) at least), so at mid-length the closed form is exact to rounding of the mesh error;
//! the load approaches it like 1 - k D/B.

use std::f64::consts::PI;

use oilwedge_reynolds::analytical::sommerfeld;
use oilwedge_reynolds::quantities::{load::load, similarity};
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
    let solution = film.solve(&system).unwrap();
    let greatest = pressure_scale() * sommerfeld::pressure(ECCENTRICITY, 2.0);
    for k in 0..24 {
        let theta = 2.0 * PI * f64::from(k) / 24.0;
        let dof = vertex_dof_at(system.space(), [RADIUS * theta, 0.0]);
        let expected = pressure_scale() * sommerfeld::pressure(ECCENTRICITY, theta);
        let error = (solution.unknown[dof] - expected) / greatest;
        assert!(error.abs() < 1e-6, "theta {theta}: {error:.2e}");
    }
}

/// So(B) = So_inf (1 - k D/B) up to exponentially small terms: two lengths give So_inf.
#[test]
fn load_approaches_the_limit_like_the_inverse_length() {
    let deficit = |slenderness: f64| {
        let length = slenderness * 2.0 * RADIUS;
        let film = plain_film(length, ECCENTRICITY, PI, SPEED);
        let rows = (16.0 * slenderness) as u32;
        let system = ring_system(96, rows, length, Some(0.0));
        let solution = film.solve(&system).unwrap();
        let load = load(&film, &system, &solution);
        let number = similarity::sommerfeld_number(&film.bearing, VISCOSITY, &film.journal, load.magnitude());
        1.0 - number.unwrap() / sommerfeld::sommerfeld_number(ECCENTRICITY)
    };
    let (short, long) = (deficit(6.0), deficit(12.0));
    assert!((short / long - 2.0).abs() < 1e-4, "{short} {long}");
    assert!((2.0 * long - short).abs() < 1e-6, "{short} {long}");
}
