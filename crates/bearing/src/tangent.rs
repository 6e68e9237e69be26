//! The tangent of a trial: how its forces, and a wall that gives way, change with the coordinates of the journal.

use std::sync::Arc;

use oilwedge_fem::newton::NewtonFailure;
use oilwedge_reynolds::NoFilm;

use crate::coordinates::{Vector, unit};
use crate::deflection::{Carried, carried_touching, contact_on_wall};
use crate::search::{Search, Trial};
use crate::stiffness::Stiffness;

/// Accuracy to which a wall that gives way follows in the tangent of a search: each step leaves about this part of the
/// difference.
const FOLLOWED: f64 = 1e-4;

/// How the coefficients of a deflection change with each coordinate of the journal [1]; nothing of a rigid wall.
#[derive(Debug, Clone, Default)]
pub struct WallByPlace(Arc<[Vec<f64>]>);

impl WallByPlace {
    /// Change of the coefficients [m] by a step [m] of the coordinates; none of a rigid wall.
    pub fn times(&self, step: Vector) -> Vec<f64> {
        let mut change = vec![0.0; self.0.first().map_or(0, Vec::len)];
        for (by_coordinate, part) in self.0.iter().zip(step) {
            (change.iter_mut().zip(by_coordinate)).for_each(|(sum, by)| *sum += part * by);
        }
        change
    }
}

/// How the forces and the wall change with each coordinate.
#[derive(Debug, Clone)]
pub(crate) struct Tangent {
    /// `dW/de` [N/m].
    pub(crate) stiffness: Stiffness,
    /// How the wall follows.
    pub(crate) wall: WallByPlace,
}

impl Search<'_> {
    /// The tangent of a trial, its cavity held.
    ///
    /// # Errors
    /// The linear systems could not be solved.
    pub(crate) fn tangent(&self, trial: &Trial) -> Result<Tangent, NoFilm> {
        let change = |k: usize| self.change_at(&trial.film.problem.journal, unit(k), 0.0);
        let changes: Vec<_> = (0..self.coordinates.order).map(change).collect();
        let contact = trial.contact.clone();
        let contact = contact.or_else(|| contact_on_wall(&trial.film.problem, self.system));
        let followed = carried_touching(&trial.film, contact, &changes, FOLLOWED);
        let followed: Vec<Carried> = followed.map_err(NewtonFailure::from)?;
        let stiffness = Stiffness::by_columns(self.coordinates.order, |k| {
            let mut column = self.coordinates.forces(&followed[k].by_film);
            column[k] += self.stiffness_beside()[k];
            Ok::<_, NoFilm>(column)
        })?;
        let wall = followed.into_iter().map(|change| change.deflection);
        Ok(Tangent { stiffness, wall: WallByPlace(wall.collect()) })
    }
}
