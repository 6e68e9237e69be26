//! The map of a film of finite length: its force at many eccentricities and directions of the velocity, one film each,
//! as a part of that of the short film: the logarithm of the ratio of both forces, and the angle between them, are
//! smooth.
//!
//! Eccentricities are even in `-ln(1 - eps)`, joined by cubics; directions by periodic splines, the lower half plane
//! being the mirror image.

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use oilwedge_reynolds::quantities::load::load;
use oilwedge_reynolds::solve::Neighbour;
use oilwedge_reynolds::{FilmProblem, FilmSystem, JournalState, NoFilm, SolvedFilm};
use rayon::prelude::*;

use super::{FilmMap, ShortMap};
use crate::duty_cycle::{NoSpline, PeriodicSpline};

/// Directions of the velocity from 0 to pi.
const DIRECTIONS: u32 = 24;
/// Distance of eccentricities in `-ln(1 - eps)`.
const DISTANCE: f64 = 0.16;
/// Films of the least eccentricity are solved at this one.
const LEAST: f64 = 1e-3;
/// Speed of the journal's centre [1/s] over the clearance at which films are solved; the map is in proportion to it.
const SPEED: f64 = 1.0;

/// Why a film has no map.
#[derive(Debug, thiserror::Error)]
pub enum NoMap {
    /// There is no film at a place and velocity of the map.
    #[error(transparent)]
    Film(#[from] NoFilm),
    /// Forces of the film are not finite, or none.
    #[error("the forces of the film make no curve: {0}")]
    Force(#[from] NoSpline),
}

/// The map of a film of finite length.
#[derive(Debug, Clone)]
pub struct FiniteMap {
    /// Logarithm of the ratio of the forces, and angle between them, over the direction: at each eccentricity.
    levels: Vec<PeriodicSpline<2>>,
    /// Films that were solved.
    pub films: usize,
}

impl FiniteMap {
    /// Computes the map of a film up to an eccentricity [1] below 1.
    ///
    /// # Errors
    /// [`NoMap`]: why there is none.
    pub fn new(problem: &FilmProblem, system: &Arc<FilmSystem>, greatest: f64) -> Result<Self, NoMap> {
        let count = ((-(1.0 - greatest).ln() / DISTANCE).ceil() as usize).max(3);
        let levels: Result<Vec<_>, NoMap> = (0..=count)
            .into_par_iter()
            .map(|k| level(problem, system, (1.0 - (-DISTANCE * k as f64).exp()).max(LEAST)))
            .collect();
        Ok(Self { levels: levels?, films: (count + 1) * (DIRECTIONS as usize + 1) })
    }
}

/// The films at one eccentricity.
fn level(problem: &FilmProblem, system: &Arc<FilmSystem>, eccentricity: f64) -> Result<PeriodicSpline<2>, NoMap> {
    let bearing = &problem.bearing;
    let unit = problem.lubricant.viscosity * bearing.length.powi(3) * bearing.radius / bearing.clearance.powi(2);
    let mut before: Option<SolvedFilm> = None;
    let mut values = Vec::new();
    for k in 0..=DIRECTIONS {
        let angle = PI * f64::from(k) / f64::from(DIRECTIONS);
        let problem = FilmProblem {
            journal: JournalState {
                offset: [eccentricity * bearing.clearance, 0.0],
                velocity: [angle.cos(), angle.sin()].map(|part| SPEED * bearing.clearance * part),
                speed: 0.0,
                ..JournalState::default()
            },
            ..problem.clone()
        };
        let near = before.as_ref().map_or(Neighbour::None, Neighbour::Start);
        let film = problem.solve_from(system, near)?;
        let [x, y] = load(&film).total.resultant().force;
        let short = ShortMap.force(eccentricity, angle);
        let ratio = x.hypot(y) / (unit * SPEED * short[0].hypot(short[1]));
        // At both ends the force is along the line of centres.
        let turn = match k {
            0 | DIRECTIONS => 0.0,
            _ => (short[0] * y - short[1] * x).atan2(short[0] * x + short[1] * y),
        };
        values.push([ratio.ln(), turn]);
        before = Some(film);
    }
    let mirrored = (1..DIRECTIONS as usize).rev().map(|k| [values[k][0], -values[k][1]]);
    let values: Vec<_> = values.iter().copied().chain(mirrored).collect();
    let angles = (0..2 * DIRECTIONS).map(|k| PI * f64::from(k) / f64::from(DIRECTIONS));
    Ok(PeriodicSpline::new(angles.collect(), values, TAU)?)
}

impl FilmMap for FiniteMap {
    fn force(&self, eccentricity: f64, angle: f64) -> [f64; 2] {
        let place = -(1.0 - eccentricity).ln() / DISTANCE;
        let last = self.levels.len() - 1;
        // The four levels around the place, and Lagrange's cubic through them.
        let first = (place.floor().max(1.0) as usize - 1).min(last - 3);
        let t = place - first as f64;
        let weights = [
            -(t - 1.0) * (t - 2.0) * (t - 3.0) / 6.0,
            t * (t - 2.0) * (t - 3.0) / 2.0,
            -t * (t - 1.0) * (t - 3.0) / 2.0,
            t * (t - 1.0) * (t - 2.0) / 6.0,
        ];
        let mut sum = [0.0; 2];
        for (weight, level) in weights.iter().zip(&self.levels[first..]) {
            let [log, turn] = level.at(angle);
            sum[0] += weight * log;
            sum[1] += weight * turn;
        }
        let [x, y] = ShortMap.force(eccentricity, angle);
        let (size, (sin, cos)) = (sum[0].exp(), sum[1].sin_cos());
        [size * (cos * x - sin * y), size * (sin * x + cos * y)]
    }
}
