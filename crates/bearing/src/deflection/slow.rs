//! How film and wall answer to slow motions of the journal: the wall follows by `A x + B x'`, and what its own motion
//! `A x'` does to the film is in B.
//!
//! ```text
//! A = C (p_x + p_d A)        B = C (p_v + p_d' A + p_d B)
//! ```
//!
//! These are the answers of `dynamics.rs` at the frequency zero, where place and rate do not depend on each other. The
//! rate that the wall has is held.

use oilwedge_fem::Error;
use oilwedge_fem::newton::NewtonFailure;
use oilwedge_reynolds::film_thickness::Deflection;
use oilwedge_reynolds::quantities::load::{Resultant, load_change};
use oilwedge_reynolds::{FilmChange, FilmProblem, JournalChange, NoFilm, SolvedFilm};

use super::tangent::{Follower, WallResponse};

/// Accuracy to which the wall follows a rate: what a rate changes is asked for by bars of errors alone.
const FOLLOWED: f64 = 1e-4;

/// The answer of film and wall to a slow motion of the journal.
struct Slow {
    /// Answer to the motion as place.
    by_place: WallResponse,
    /// Answer to the motion as rate.
    by_rate: WallResponse,
    /// The motion as rate.
    rate: JournalChange,
    /// A of the motion: the rate of the wall.
    of_wall: Deflection,
}

impl Follower<'_> {
    fn slow(&self, place: &JournalChange, accuracy: f64) -> Result<Slow, Error> {
        let by_place = self.followed(self.free(place)?, accuracy)?;
        let of_wall = self.shape(&by_place.deflection);
        let rate = place.as_rate();
        let mut free = self.free(&rate)?;
        let more = self.film.unknown_change(FilmChange::GapRate(&of_wall))?;
        (free.unknown.iter_mut()).zip(more).for_each(|(unknown, more)| *unknown += more);
        Ok(Slow { by_rate: self.followed(free, accuracy)?, by_place, rate, of_wall })
    }
}

/// First-order changes of what the journal carries with a slow motion by `place`: with it as place, and with it as rate
/// [1/s]. A wall that gives way follows; its linear systems are solved to an `accuracy`.
///
/// # Errors
/// The linear systems could not be solved.
pub fn carried_slowly(film: &SolvedFilm, place: &JournalChange, accuracy: f64) -> Result<[Resultant; 2], Error> {
    let Some(follower) = Follower::of(film)? else {
        let rate = place.as_rate();
        let of = |motion: &JournalChange| {
            let unknown = film.unknown_change(motion)?;
            Ok::<_, Error>(load_change(film, &[motion.into()], &unknown))
        };
        return Ok([of(place)?, of(&rate)?]);
    };
    let gradient = follower.load_gradient();
    let slow = follower.slow(place, accuracy)?;
    Ok([slow.by_place.carried(&gradient), slow.by_rate.carried(&gradient)])
}

/// The film of a journal that moves faster by `motion` as a rate [1/s], and of a wall that follows it slowly: along the
/// tangent.
///
/// # Errors
/// [`NoFilm`]: the reason why there is none.
pub fn hastened(film: &SolvedFilm, motion: &JournalChange) -> Result<SolvedFilm, NoFilm> {
    let Some(follower) = Follower::of(film).map_err(NewtonFailure::from)? else {
        return film.displaced(&motion.as_rate());
    };
    let slow = follower.slow(motion, FOLLOWED).map_err(NewtonFailure::from)?;
    let of_rate = follower.shape(&slow.by_rate.deflection);
    let bent = (follower.deflection.with_more(&slow.by_rate.deflection)).faster(&slow.of_wall.coefficients);
    let hastened = FilmProblem { journal: film.problem.journal.changed(&slow.rate), ..film.problem.clone() }
        .deflected(Some(&bent));
    let changes = [FilmChange::from(&slow.rate), FilmChange::GapRate(&slow.of_wall), FilmChange::Gap(&of_rate)];
    Ok(film.along_tangent(hastened, &changes, &slow.by_rate.unknown))
}
