//! The tangent of a trial, how its forces, and a wall that gives way, change with the coordinates of the journal; and
//! films beside a solved one along its tangent.

use std::sync::Arc;

use oilwedge_fem::Error;
use oilwedge_fem::newton::NewtonFailure;
use oilwedge_reynolds::{FilmProblem, FilmSystem, NoFilm, SolvedFilm};

use crate::coordinates::{Vector, unit};
use crate::deflection::{Carried, EXACT, Follower, WallResidual, carried_touching, contact_on_wall};
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

/// The neighbourhood of a solved film: films of problems that differ a little, each by one back-substitution.
pub struct Neighbourhood<'a> {
    film: &'a SolvedFilm,
    /// None where the wall is rigid.
    follower: Option<Follower<'a>>,
}

impl<'a> Neighbourhood<'a> {
    /// The neighbourhood of a film.
    ///
    /// # Errors
    /// A system that does not fit in memory.
    pub fn of(film: &'a SolvedFilm) -> Result<Self, Error> {
        Ok(Self { film, follower: Follower::of(film)? })
    }

    /// The film of a neighbouring `problem`, its wall bent as that of the film at hand and by these coefficients [m]
    /// more; none where its wall has another number of them.
    ///
    /// # Errors
    /// [`NoFilm`]: the linear system could not be solved.
    pub fn film(
        &self,
        problem: FilmProblem,
        system: &Arc<FilmSystem>,
        more: &[f64],
    ) -> Result<Option<SolvedFilm>, NoFilm> {
        let bent = match problem.deflection().zip(self.film.problem.deflection()) {
            Some((wall, known)) if wall.coefficients.len() != known.coefficients.len() => return Ok(None),
            Some((wall, known)) => Some(wall.with(known.coefficients.to_vec()).with_more(more)),
            None => None,
        };
        self.film.chord(problem.deflected(bent.as_ref()), system).map(Some)
    }

    /// By which coefficients [m] the wall of a neighbouring film follows to first order from the deflection that the
    /// film has, its journal held; none of a rigid wall.
    ///
    /// # Errors
    /// [`NoFilm`]: the linear systems could not be solved.
    pub fn followed(&self, film: &SolvedFilm) -> Result<Vec<f64>, NoFilm> {
        let Some(follower) = &self.follower else { return Ok(Vec::new()) };
        let left = WallResidual::of_film(film).wall;
        Ok(follower.of_wall(&left, EXACT).map_err(NewtonFailure::from)?.deflection)
    }
}
