//! # Elastic wall: the deflection by the pressure of the film that it makes room for
//!
//! **Equation.** `d = C f(p(d))` for the deflection of the wall, p the pressure of the film and that of contact, by
//! Newton's method: `(I - C dp/dd) step = C f - d`, each step by GMRES, whose products cost a back-solve with the
//! factor of the film, its cavity held. A search for a position closes the wall at each place that it tries.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | d | m | [`Deflection`] |
//! | C, f | m/N, N | [`Wall`](oilwedge_reynolds::wall::Wall) |
//!
//! The wall is bent by the film that is reported: the one in cubic elements, where errors are estimated by it. The
//! other film of a pair runs under the wall so bent, so that both have the same gap.
//!
//! **Source.** Knoll, Keyes, J. Comput. Phys. 193 (2004) 357 (Newton and Krylov). **Range.** Films that are reached
//! from one in the unbent wall by raising the eccentricity; beyond the clearance too where contact presses the ends of
//! the wall out. **Verified by** `tests/tests/liner`: a second method, the tangent against differences.

mod bordered;
mod close;
mod dynamics;
mod following;
mod gmres;
mod joint;
mod settled;
mod slow;
mod tangent;
mod touching;

pub(crate) use bordered::Bordered;
pub use close::{CLOSED, FilmsOnWall, closed_film, closed_pair};
pub(crate) use close::{WallResidual, closed_within, resting};
pub(crate) use dynamics::{MotionResponse, harmonic_response};
pub use following::following_wall;
pub(crate) use joint::{Joint, Moves};
pub(crate) use settled::settled;
pub use slow::{carried_slowly, hastened};
pub use tangent::EXACT;
pub(crate) use tangent::{Follower, NEARLY, contact_on_wall, contact_points};

use std::sync::Arc;

use oilwedge_fem::Error;
use oilwedge_fem::newton::NewtonFailure;
use oilwedge_reynolds::film_thickness::Deflection;
use oilwedge_reynolds::quantities::contact_points::ContactPoints;
use oilwedge_reynolds::quantities::load::{Resultant, load_change};
use oilwedge_reynolds::solve::Neighbour;
use oilwedge_reynolds::{FilmChange, FilmProblem, JournalChange, NoFilm, SolvedFilm};

/// Accuracy of the linear systems of films moved for bars of errors.
const FOR_BARS: f64 = 1e-6;

/// What a move of the journal changes, to first order.
#[derive(Debug, Clone)]
pub struct Carried {
    /// Change of what the journal carries.
    pub by_film: Resultant,
    /// Change of the coefficients of the deflection [m]; empty where the wall is rigid.
    pub deflection: Vec<f64>,
}

/// What each of some `changes` of the journal changes, to first order; a wall that gives way follows. Its linear
/// systems are solved until the norm of the residual is `accuracy` times that of the right-hand side [1].
///
/// # Errors
/// The linear systems could not be solved.
pub fn carried_changes(film: &SolvedFilm, changes: &[JournalChange], accuracy: f64) -> Result<Vec<Carried>, Error> {
    let contact = contact_on_wall(&film.problem, &film.system);
    carried_touching(film, contact, changes, accuracy)
}

/// What each of some changes of the journal changes, of a film with these points of contact; see
/// [`carried_changes`].
///
/// # Errors
/// The linear systems could not be solved.
pub(crate) fn carried_touching(
    film: &SolvedFilm,
    contact: Option<Arc<ContactPoints>>,
    changes: &[JournalChange],
    accuracy: f64,
) -> Result<Vec<Carried>, Error> {
    let Some(follower) = Follower::touching(film, contact)? else {
        let of = |change: &JournalChange| {
            let unknown = film.unknown_change(change)?;
            Ok(Carried { by_film: load_change(film, &[change.into()], &unknown), deflection: Vec::new() })
        };
        return changes.iter().map(of).collect();
    };
    let gradient = follower.load_gradient();
    let of = |change: &JournalChange| {
        let followed = follower.followed(follower.free(change)?, accuracy)?;
        Ok(Carried { by_film: followed.carried(&gradient), deflection: followed.deflection })
    };
    changes.iter().map(of).collect()
}

/// The film where the journal has moved by a small `change`, and with it a wall that gives way: along the tangent, but
/// for a mass-conserving one, which is solved again from the film that is there.
///
/// # Errors
/// [`NoFilm`]: the reason why there is none.
pub fn displaced(film: &SolvedFilm, change: &JournalChange) -> Result<SolvedFilm, NoFilm> {
    let wall = match Follower::of(film).map_err(NewtonFailure::from)? {
        None => Vec::new(),
        Some(follower) => {
            let followed = follower.free(change).and_then(|free| follower.followed(free, FOR_BARS));
            followed.map_err(NewtonFailure::from)?.deflection
        }
    };
    displaced_with_wall(film, change, &wall)
}

/// The film of [`displaced`], where it is known by which coefficients [m] the wall follows; none of a rigid one.
///
/// # Errors
/// [`NoFilm`]: the reason why there is none.
pub fn displaced_with_wall(film: &SolvedFilm, change: &JournalChange, wall: &[f64]) -> Result<SolvedFilm, NoFilm> {
    let problem = &film.problem;
    let Some(deflection) = problem.deflection() else {
        return film.displaced(change);
    };
    let moved = FilmProblem { journal: problem.journal.changed(change), ..problem.clone() }
        .deflected(Some(&deflection.with_more(wall)));
    let shape = deflection.change(wall.to_vec());
    let changes = [FilmChange::from(change), FilmChange::Gap(&shape)];
    let unknown = || {
        let mut unknown = vec![0.0; film.solution.unknown.len()];
        for change in changes {
            let more = film.unknown_change(change)?;
            unknown.iter_mut().zip(more).for_each(|(unknown, more)| *unknown += more);
        }
        Ok(unknown)
    };
    with_change(film, moved, &changes, unknown)
}

/// The film of a problem that is `moved` by small changes: along the tangent, by which the unknown changes so; one that
/// conserves oil is solved again from the film that is there.
fn with_change(
    film: &SolvedFilm,
    moved: FilmProblem,
    changes: &[FilmChange<'_>],
    unknown: impl FnOnce() -> Result<Vec<f64>, Error>,
) -> Result<SolvedFilm, NoFilm> {
    if film.solution.film_fraction.is_some() {
        return moved.solve_from(&film.system, Neighbour::Start(film));
    }
    let unknown = unknown().map_err(NewtonFailure::from)?;
    Ok(film.along_tangent(moved, changes, &unknown))
}

/// The film where the wall alone would move by coefficients `free` [m] under the pressure that is there, and both have
/// answered, to first order; none where the wall is rigid.
///
/// # Errors
/// [`NoFilm`]: the reason why there is none.
pub fn bent(film: &SolvedFilm, free: &[f64]) -> Result<Option<SolvedFilm>, NoFilm> {
    let Some(follower) = Follower::of(film).map_err(NewtonFailure::from)? else {
        return Ok(None);
    };
    let followed = follower.of_wall(free, FOR_BARS).map_err(NewtonFailure::from)?;
    follower.moved(&followed).map(Some)
}

/// The deflection where the wall moves by coefficients `free` [m] and contact has answered, the pressure of the film
/// held; none where the wall is rigid.
///
/// # Errors
/// A system that does not fit in memory.
pub fn touched(film: &SolvedFilm, free: &[f64]) -> Result<Option<Deflection>, Error> {
    let follower = Follower::of(film)?;
    Ok(follower.map(|follower| follower.deflection.with_more(&follower.solve_contact(free))))
}

impl Follower<'_> {
    /// The film under the wall that has followed.
    fn moved(&self, followed: &tangent::WallResponse) -> Result<SolvedFilm, NoFilm> {
        let shape = self.shape(&followed.deflection);
        let bent = self.deflection.with_more(&followed.deflection);
        let moved = self.film.problem.clone().deflected(Some(&bent));
        let changes = [FilmChange::Gap(&shape)];
        with_change(self.film, moved, &changes, || Ok(followed.unknown.clone()))
    }
}
