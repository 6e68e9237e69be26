//! Ocvirk, NACA TN 2808 (1952): the infinitely short bearing, full and half film.
//!
//! The closed form drops `d/dx (h^3 dp/dx)`, of relative size (B/D)^2: the load approaches it at
//! order 2 in B/D.

use std::f64::consts::PI;

use oilwedge_reynolds::Cavitation;
use oilwedge_reynolds::analytical::ocvirk;
use oilwedge_reynolds::quantities::{load::load, similarity};
use oilwedge_tests::*;

const ECCENTRICITY: f64 = 0.5;

/// So over (B/D)^2 and attitude angle [rad].
fn short_film(slenderness: f64, cavitation: Cavitation) -> [f64; 2] {
    let length = slenderness * 2.0 * RADIUS;
    let film = oilwedge_reynolds::FilmProblem {
        cavitation,
        ..plain_film(length, ECCENTRICITY, PI, SPEED)
    };
    let system = ring_system(360, 8, length, None);
    let solution = film.solve(&system).unwrap();
    let load = load(&film, &system, &solution);
    let number = similarity::sommerfeld_number(&film.bearing, VISCOSITY, &film.journal, load.magnitude());
    [
        number.unwrap() / slenderness.powi(2),
        similarity::attitude_angle(&film.journal, load.angle()),
    ]
}

#[test]
fn full_film_approaches_the_limit_at_order_two() {
    let errors =
        [0.2, 0.1, 0.05].map(|b| (short_film(b, Cavitation::None)[0] / ocvirk::full_film(ECCENTRICITY) - 1.0).abs());
    assert!((order(&errors) - 2.0).abs() < 0.1, "{errors:?}");
    assert!(errors[2] < 4e-3, "{errors:?}");
    let attitude = short_film(0.1, Cavitation::None)[1];
    assert!(
        (attitude - PI / 2.0).abs() < 1e-6,
        "full film: the load stands across the line of centres"
    );
}

#[test]
fn half_film_approaches_the_limit_at_order_two() {
    let (load, attitude) = ocvirk::half_film(ECCENTRICITY);
    let films = [0.2, 0.1, 0.05].map(|b| short_film(b, Cavitation::Guembel { pressure: 0.0 }));
    let loads = films.map(|film| (film[0] / load - 1.0).abs());
    assert!((order(&loads) - 2.0).abs() < 0.1, "{loads:?}");
    let angles = films.map(|film| (film[1] - attitude).abs());
    assert!((order(&angles) - 2.0).abs() < 0.1, "{angles:?}");
}
