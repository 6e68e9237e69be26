//! The elastic liners of `tests/data/elastic_liner.json`, numbers of a second, independent code; films on structured
//! rings with a wall.

use std::sync::Arc;

use oilwedge_bearing::deflection::closed_film;
use oilwedge_reynolds::film_thickness::Deflection;
use oilwedge_reynolds::quantities::load::{Resultant, load};
use oilwedge_reynolds::solve::Neighbour;
use oilwedge_reynolds::wall::Wall;
use oilwedge_reynolds::{Cavitation, FilmProblem, FilmSystem, SolvedFilm};
use serde_json::Value;

use crate::program::repository;
use crate::{CLEARANCE, RADIUS, SPEED, plain_film, pressure_scale};

/// A block of the reference.
///
/// # Panics
/// If there is none of that name.
pub fn block(name: &str) -> Value {
    let path = repository().join("tests/data/elastic_liner.json");
    let text = std::fs::read_to_string(path).expect("reference of elastic liners");
    let data: Value = serde_json::from_str(&text).expect("reference is JSON");
    data.get(name).unwrap_or_else(|| panic!("no block {name}")).clone()
}

/// Compliance [m/Pa] of a layer that moves by `lambda` clearances under the pressure scale.
pub fn layer(lambda: f64) -> f64 {
    lambda * CLEARANCE / pressure_scale()
}

/// A film of this cavitation model, its wall at rest, which moves by `by_wave(n)` [m/Pa] under `cos(n phi)`.
///
/// # Panics
/// If the bearing has no length.
pub fn walled(length: f64, eccentricity: f64, cavitation: Cavitation, by_wave: impl Fn(usize) -> f64) -> FilmProblem {
    let mut problem = plain_film(length, eccentricity, 0.0, SPEED);
    problem.cavitation = cavitation;
    let wall = Wall::of_slices(&problem.bearing, by_wave).expect("a bearing with a length");
    with_wall(problem, wall)
}

/// A film with a wall at rest.
pub fn with_wall(mut problem: FilmProblem, wall: Wall) -> FilmProblem {
    problem.film_thickness.push(Arc::new(Deflection::none(Arc::new(wall))));
    problem
}

/// The film, its wall bent by it.
///
/// # Panics
/// If there is none.
pub fn closed(problem: FilmProblem, system: &Arc<FilmSystem>) -> SolvedFilm {
    closed_film(problem, system, Neighbour::None).unwrap_or_else(|reason| panic!("{reason}"))
}

/// Force and moment of a film.
pub fn carried(film: &SolvedFilm) -> Resultant {
    load(film).total.resultant()
}

/// Unit of force `mu omega R^2/psi^2` [N].
pub fn force_scale() -> f64 {
    pressure_scale() * RADIUS * RADIUS
}
