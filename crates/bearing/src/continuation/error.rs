//! How far the part of a branch at its end is from that of the limit of fine meshes.
//!
//! **Equation.** Another film under the same wall carries forces that differ by m at the same place x. With K the
//! tangent of the forces, g the gradient of the least film, the wall following, and R_0 as in [`super`], its branch
//! reaches the same least film where
//! ```text
//! K dx + m = -dpart R_0,    g . dx = 0:    dpart = -(g . K^-1 m)/(g . K^-1 R_0)
//! ```
//! for a film that conserves oil, in contact: near it K is stiff, so that a great difference at one place moves the
//! branch by little. Where such a branch ends before contact, for its next balance was not found or it turns, it may
//! lead on on another mesh: no error is known. Other films may turn before contact on one mesh and not on another:
//! their error is m over R_0.
//! **Verified by** `tests/tests/tilt/balance.rs`: finer meshes.

use oilwedge_reynolds::SolvedFilm;
use oilwedge_reynolds::quantities::load::load;

use super::{Branch, BranchPoint, FOLLOWED};
use crate::Purpose;
use crate::coordinates::{Vector, length, moved};
use crate::deflection::Moves;
use crate::search::Trial;

/// Error at most over that to first order by the tangent at the end of the branch, of a film that conserves oil: up to
/// 1 was seen on twelve rows of cells and more, 4 on six.
const OF_FIRST_ORDER: f64 = 2.0;
/// Error over that by the forces at one place, of films whose branch may turn: where it does on another mesh the
/// tangent at the end does not show. Up to 4.5 was seen.
const OF_FORCES: f64 = 5.0;
/// Step of a difference, over the least film.
const STEP: f64 = 1e-3;

impl Branch<'_, '_> {
    /// Part of what grows that is balanced at this part of the branch [1]: at its beginning the film may carry some of
    /// it already.
    pub(super) fn carried(&self, part: f64) -> f64 {
        let growing = |[x, y, z_x, z_y]: Vector| match self.search.load.tilting {
            Some(_) => z_x.hypot(z_y),
            None => x.hypot(y),
        };
        let (asked, left) = (growing(self.search.asked()), (1.0 - part) * growing(self.first));
        if asked > 0.0 { 1.0 - left / asked } else { part }
    }

    /// The part of what grows that is balanced at a point, and its error at most, by another film under the same wall.
    /// The error is not known where there is no other film, of a mass-conserving film before contact, and in a search
    /// whose reason is a start at most.
    pub(super) fn carried_with_error(&self, at: &BranchPoint) -> (f64, Option<f64>) {
        let (search, Trial { film, .. }) = (self.search, &at.trial);
        let carried = self.carried(at.part);
        let conserves_oil = film.problem.cavitation.conserves_oil();
        let is_known = !conserves_oil || search.is_in_contact(&at.trial);
        let missed = match search.options.purpose {
            Purpose::Answer | Purpose::Branch if is_known => self.missed(film),
            Purpose::Start | Purpose::Answer | Purpose::Branch => None,
        };
        let part = |missed: Vector| match conserves_oil {
            true => OF_FIRST_ORDER * self.missed_part(at, missed),
            false => OF_FORCES * length(missed) / length(self.first),
        };
        let error = |missed| self.carried(at.part + part(missed)) - carried;
        (carried, missed.map(error).filter(|error| error.is_finite()))
    }

    /// By how much forces [N] of another film under the same wall differ from those of a film: the one in cubic
    /// elements or, of a film that conserves oil, the one on the coarser mesh, which is further from the limit of fine
    /// meshes. None where there is no such film.
    fn missed(&self, film: &SolvedFilm) -> Option<Vector> {
        let search = self.search;
        let other = match film.problem.cavitation.conserves_oil() {
            false => film.cubic_film(None).ok()?,
            true => {
                let coarser = search.system.coarser.as_ref()?;
                coarser.problem(&film.problem).solve(&coarser.system).ok()?
            }
        };
        let [other, of_film] = [&other, film].map(|film| search.coordinates.forces(&load(film).total.resultant()));
        Some(moved(other, -1.0, of_film))
    }

    /// By how much the part at a point differs for a film whose forces differ by `missed` [N] [1].
    fn missed_part(&self, at: &BranchPoint, missed: Vector) -> f64 {
        let search = self.search;
        let tangents =
            search.tangents(&at.trial, &at.trial.film, &search.left_of_wall(&at.trial), (FOLLOWED, 0.0)).ok();
        let shrink = |force: Vector| {
            let moves = tangents.as_ref().and_then(|tangents| tangents.solve(force, None).ok());
            moves.map_or(f64::NAN, |moves| self.growth(at, &moves))
        };
        (shrink(missed) / shrink(self.first)).abs()
    }

    /// Growth of the least film along `moves`, over the change of the coordinates [1].
    fn growth(&self, at: &BranchPoint, moves: &Moves) -> f64 {
        let search = self.search;
        let least = search.least_film(&at.trial);
        let step = STEP * least / length(moves.place);
        let (bent, place) = search.led_to(&at.trial, moves, step);
        let journal = search.coordinates.placed(&bent.journal, place);
        (search.least_under(&bent, &journal) - least) / step
    }
}
