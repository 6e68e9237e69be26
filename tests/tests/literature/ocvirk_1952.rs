//! Ocvirk, NACA TN 2808 (1952): the infinitely short bearing, full and half film, turning and squeezed.
//!
//! The closed form drops `d/dx (h^3 dp/dx)`, of relative size (B/D)^2: the load approaches it at
//! order 2 in B/D.

use std::f64::consts::PI;
use std::sync::Arc;

use oilwedge_reynolds::analytical::ocvirk::{ShortFilm, ShortLoad};
use oilwedge_reynolds::quantities::{load::load, similarity};
use oilwedge_reynolds::terms::squeeze::Squeeze;
use oilwedge_reynolds::{Cavitation, CentreVelocity};
use oilwedge_tests::*;

const STEADY: ShortFilm = ShortFilm { eccentricity: 0.5, rotation: 1.0, closing: 0.0 };
/// The narrowest film closes while the line of centres turns with the journal, and opens while it turns against it.
const SQUEEZED: [ShortFilm; 2] = [
    ShortFilm { eccentricity: 0.5, rotation: 0.7, closing: 0.4 },
    ShortFilm { eccentricity: 0.5, rotation: 1.3, closing: -0.3 },
];

/// Sommerfeld number So over (B/D)^2 and attitude angle [rad] of a film with B/D, by finite elements.
fn film_of_length(slenderness: f64, short: ShortFilm, cavitation: Cavitation) -> [f64; 2] {
    let length = slenderness * 2.0 * RADIUS;
    let mut film = oilwedge_reynolds::FilmProblem { cavitation, ..plain_film(length, short.eccentricity, PI, SPEED) };
    let radial = 0.5 * short.closing * SPEED * CLEARANCE;
    let tangential = 0.5 * (1.0 - short.rotation) * SPEED * short.eccentricity * CLEARANCE;
    film.journal = film.journal.with_centre_velocity(CentreVelocity { radial, tangential }, PI);
    film.terms.push(Arc::new(Squeeze));
    let system = ring_system(360, 8, length, None);
    let solution = film.solve(&system).unwrap();
    let load = load(&solution);
    let number = similarity::sommerfeld_number(&film.bearing, VISCOSITY, &film.journal, load.magnitude());
    [number.unwrap() / slenderness.powi(2), similarity::attitude_angle(&film.journal, load.angle())]
}

/// Asks for order 2 in B/D, and for an error of 0.4 % at B/D = 0.05.
fn approaches(short: ShortFilm, limit: ShortLoad, cavitation: Cavitation) {
    let films = [0.2, 0.1, 0.05].map(|b| film_of_length(b, short, cavitation));
    let loads = films.map(|film| (film[0] / limit.magnitude() - 1.0).abs());
    assert!((order(&loads) - 2.0).abs() < 0.1, "{short:?}: {loads:?}");
    assert!(loads[2] < 4e-3, "{short:?}: {loads:?}");
    let angles = films.map(|film| (film[1] - limit.attitude()).abs());
    assert!(angles[2] < 4e-3, "{short:?}: {angles:?}");
    // A full film that is not squeezed keeps its angle at any length.
    assert!(angles[0] < 1e-6 || (order(&angles) - 2.0).abs() < 0.1, "{short:?}: {angles:?}");
}

#[test]
fn full_film_approaches_the_limit_at_order_two() {
    approaches(STEADY, STEADY.full_film(), Cavitation::None);
    let attitude = film_of_length(0.1, STEADY, Cavitation::None)[1];
    assert!((attitude - PI / 2.0).abs() < 1e-6, "full film: the load stands across the line of centres");
}

#[test]
fn half_film_approaches_the_limit_at_order_two() {
    approaches(STEADY, STEADY.half_film(), Cavitation::Guembel { pressure: 0.0 });
}

#[test]
fn squeezed_films_approach_the_limit_at_order_two() {
    for short in SQUEEZED {
        approaches(short, short.full_film(), Cavitation::None);
        approaches(short, short.half_film(), Cavitation::Guembel { pressure: 0.0 });
    }
}
