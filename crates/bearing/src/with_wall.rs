//! Journal and wall found together, where the wall gives way and the balance is near: each step solves one film.
//!
//! ```text
//! W(x, d) = F        C f(p(x, d)) = d
//! ```
//!
//! **Method.** Newton's, with the tangent of both: [`Joint`], the journal eliminated and the wall found by GMRES, or
//! [`Bordered`], of the film in cubic elements. Under a load the wall answers less than at a place, so that it is found
//! under soft walls in contact too, where no place that is held has one near. Far from the balance the wall is closed
//! at each place that is tried. **Verified by** `tests/tests/liner`: balances of force and wall.

use std::borrow::Cow;

use oilwedge_fem::newton::Failure;
use oilwedge_reynolds::contact::Contact;
use oilwedge_reynolds::film_thickness::Closing;
use oilwedge_reynolds::quantities::load::{load, load_touching};
use oilwedge_reynolds::solve::Neighbour;
use oilwedge_reynolds::{FilmProblem, NoFilm, SolvedFilm};

use crate::coordinates::{Vector, moved, unit};
use crate::deflection::{Bordered, Follower, Joint, Left, Moves, NEARLY, contact_points, settled};
use crate::search::{Search, Trial, fineness};
use crate::stiffness::Stiffness;

/// Part of load and deflection that a film may leave from which on both are found together.
pub(crate) const WITHIN: f64 = 1.0;
/// Most films of one balance.
const MOST_FILMS: usize = 40;
/// Most lengths of a step, each half of the one before.
const MOST_LENGTHS: i32 = 7;
/// Accuracy of the linear system of a step at the roughest;
const ROUGHEST: f64 = 1e-2;
/// over what is left, which Newton's method squares;
const OF_LEFT: f64 = 0.3;
/// The system of a last step leaves this part of what may be left at last.
const SPARE: f64 = 0.3;
/// Least film after a step over that before.
const LEAST_SHRINK: f64 = 0.3;
/// Below this part a step that leaves more has reached round-off.
const AT_ROUNDING: f64 = 1e-10;

/// How the journal of a film, and a wall that gives way, move where their balances are to change.
pub(crate) enum Tangents<'a> {
    /// The wall is rigid.
    Rigid(Stiffness),
    /// It gives way.
    Yielding(Box<Joint<'a>>),
    /// It gives way, and the film in cubic elements carries the load.
    OfCubic(Box<Bordered<'a>>),
}

impl Tangents<'_> {
    /// The moves by which forces change by `force` [N], and the wall by `wall` [m] more than film and contact bend it,
    /// or by no more.
    ///
    /// # Errors
    /// The linear systems could not be solved.
    pub(crate) fn solve(&self, force: Vector, wall: Option<&[f64]>) -> Result<Moves, NoFilm> {
        match self {
            Self::Rigid(stiffness) => {
                Ok(Moves { place: stiffness.solve(force), wall: Vec::new(), contact: Vec::new() })
            }
            Self::Yielding(joint) => Ok(joint.solve(force, wall).map_err(Failure::from)?),
            Self::OfCubic(bordered) => Ok(bordered.solve(force, wall).map_err(Failure::from)?),
        }
    }

    /// How many products with the tangent that took.
    fn products(&self) -> usize {
        match self {
            Self::Rigid(_) => 0,
            Self::Yielding(joint) => joint.products(),
            Self::OfCubic(bordered) => bordered.products(),
        }
    }
}

impl Search<'_> {
    /// The film `at` these coordinates under the wall of a problem as it is, what it leaves of the balance of that wall
    /// included. Contact is integrated as finely as a balance to the `part` asks for.
    pub(crate) fn open(&self, problem: &FilmProblem, at: Vector, near: Neighbour, part: f64) -> Result<Trial, NoFilm> {
        let problem = self.placed(problem, at).with_contact(fineness(part));
        let film = problem.solve_from(self.system, near)?;
        let left = Left::of(&film, contact_points(&problem, self.system));
        let carried = load_touching(&film, left.contact.as_deref());
        let film = SolvedFilm { problem: counted(problem, (1, 0), left.residual), ..film };
        Ok(self.recorded(Trial {
            contact: left.contact.clone(),
            may_leave: left.residual,
            left: Some(left),
            ..Trial::of(film, carried.total.resultant())
        }))
    }

    /// As [`Self::open`], by the film in cubic elements, started from films of a neighbouring place.
    pub(crate) fn open_cubic(
        &self,
        problem: &FilmProblem,
        at: Vector,
        (film, cubic): (&SolvedFilm, Option<&SolvedFilm>),
    ) -> Result<Trial, NoFilm> {
        let problem = self.placed(problem, at);
        let film = problem.solve_from(self.system, Neighbour::Start(film))?;
        let cubic = film.cubic_film(cubic)?;
        let left = Left::of(&cubic, contact_points(&problem, self.system));
        let problem = counted(problem, (1, 0), left.residual);
        let (film, cubic) = (SolvedFilm { problem: problem.clone(), ..film }, SolvedFilm { problem, ..cubic });
        let carried = load(&cubic).total.resultant();
        Ok(self.recorded(Trial {
            cubic: Some(cubic),
            contact: left.contact.clone(),
            may_leave: left.residual,
            left: Some(left),
            ..Trial::of(film, carried)
        }))
    }

    /// The film of [`Self::open`], where the wall is bent and the balance is so near that both are found together.
    pub(crate) fn opened(&self, problem: &FilmProblem, at: Vector, near: Neighbour, part: f64) -> Option<Trial> {
        let trial = problem.has_bent_wall().then(|| self.open(problem, at, near, part).ok());
        trial.flatten().filter(|trial| self.left(trial) < WITHIN)
    }

    /// What a trial leaves of load and deflection, as parts of them [1].
    pub(crate) fn left(&self, trial: &Trial) -> f64 {
        let wall = trial.left.as_ref().map_or(0.0, |left| left.residual);
        self.residual(trial).hypot(wall)
    }

    /// What a trial leaves of the balance of its wall.
    pub(crate) fn left_of_wall<'t>(&self, trial: &'t Trial) -> Cow<'t, Left> {
        let of = || Left::of(&trial.film, contact_points(&trial.film.problem, self.system));
        trial.left.as_ref().map_or_else(|| Cow::Owned(of()), Cow::Borrowed)
    }

    /// How journal and wall of a trial move; see [`Tangents`]. Its linear systems are solved to an `accuracy`.
    ///
    /// # Errors
    /// The linear systems could not be solved.
    pub(crate) fn tangents<'t>(&'t self, trial: &'t Trial, left: &Left, accuracy: f64) -> Result<Tangents<'t>, NoFilm> {
        let of = |film| Follower::touching(film, left.contact.clone()).map_err(Failure::from);
        let Some(follower) = of(&trial.film)? else {
            return Ok(Tangents::Rigid(self.tangent(trial)?.stiffness));
        };
        let (journal, velocity, support) =
            (&trial.film.problem.journal, self.options.centre_velocity, self.support_stiffness());
        let held = [0.0, 0.0, support, support];
        let change = |k: usize| self.coordinates.change(journal, &velocity, unit(k));
        let joint = |accuracy| Joint::of(follower, self.coordinates, change, held, accuracy).map_err(Failure::from);
        let cubic = match &trial.cubic {
            None => None,
            Some(cubic) => of(cubic)?,
        };
        Ok(match cubic {
            None => Tangents::Yielding(Box::new(joint(accuracy)?)),
            Some(cubic) => {
                let weight = left.size.max(f64::MIN_POSITIVE) / self.scale;
                let moving = (self.coordinates, velocity, held);
                let bordered = Bordered::of(cubic, moving, (weight, accuracy), joint(NEARLY)?);
                Tangents::OfCubic(Box::new(bordered))
            }
        })
    }

    /// Where a part of moves leads: the problem under the wall there, and the coordinates.
    pub(crate) fn led_to(&self, trial: &Trial, moves: &Moves, part: f64) -> (FilmProblem, Vector) {
        let (problem, at) = (trial.film.problem.clone(), self.coordinates.at(&trial.film.problem.journal));
        match trial.film.problem.deflection() {
            None => (problem, moved(at, part, moves.place)),
            Some(wall) => {
                let (at, bent) = moves.made(at, wall, part);
                (problem.deflected(Some(&bent)), at)
            }
        }
    }

    /// As [`Self::led_to`], contact settled under the wall there; none where the film along the tangent is thinner than
    /// `least` [m].
    pub(crate) fn led_on(&self, trial: &Trial, moves: &Moves, part: f64, least: f64) -> Option<(FilmProblem, Vector)> {
        let (bent, at) = self.led_to(trial, moves, part);
        let led = FilmProblem { journal: self.coordinates.placed(&trial.film.problem.journal, at), ..bent };
        (self.least_under(&led, &led.journal) >= least).then_some(())?;
        let contact = (trial.contact.clone()).or_else(|| contact_points(&trial.film.problem, self.system));
        let settled = contact.filter(|_| !moves.contact.is_empty()).and_then(|contact| {
            let along = contact.forces().into_iter().zip(&moves.contact);
            let forces: Vec<f64> = along.map(|(force, more)| force + part * more).collect();
            settled(&led, self.system, &forces)
        });
        Some(match settled {
            None => (led, at),
            Some(deflection) => (led.deflected(Some(&deflection)), at),
        })
    }

    /// The balance of force and wall near a trial, until force and load differ by less than `balanced` of the load, and
    /// less than the part `closed` of the deflection is left.
    ///
    /// # Errors
    /// The trial itself, where the balance is not near; that which is nearest to it, where the search was ended.
    pub(crate) fn with_wall(
        &self,
        from: Trial,
        (balanced, closed): (f64, f64),
        tried: &mut usize,
    ) -> Result<Trial, Box<Trial>> {
        let mut found = self.as_fine(&from, closed, tried);
        for _ in 0..MOST_FILMS {
            let here = found.as_ref().unwrap_or(&from);
            let left = self.left_of_wall(here);
            let (force, wall) = (self.residual(here), left.residual);
            let is_within = |balanced: f64, closed: f64| force < balanced && wall < closed;
            if is_within(balanced, closed) {
                return Ok(found.unwrap_or(from));
            }
            if self.options.deadline.is_over() {
                return Err(Box::new(found.unwrap_or(from)));
            }
            match self.nearer(here, &left, closed, tried) {
                Ok(Some(next)) => found = Some(next),
                _ if is_within(balanced.max(AT_ROUNDING), closed.max(AT_ROUNDING)) => return Ok(found.unwrap_or(from)),
                _ => break,
            }
        }
        Err(Box::new(from))
    }

    /// A trial whose contact is not integrated as finely as a balance asks for, with it so: films of one balance are
    /// compared. None where it is, or there is no such film.
    fn as_fine(&self, trial: &Trial, closed: f64, tried: &mut usize) -> Option<Trial> {
        let is_fine = |contact: Contact| contact.fineness == fineness(closed);
        if trial.film.problem.contact.is_none_or(is_fine) || trial.cubic.is_some() {
            return None;
        }
        *tried += 1;
        let here = self.coordinates.at(&trial.film.problem.journal);
        self.open(&trial.film.problem, here, Neighbour::Start(&trial.film), closed).ok()
    }

    /// The film after the longest of the halved steps of Newton's method that leaves less, the gap kept open; none
    /// where no step does.
    fn nearer(&self, trial: &Trial, left: &Left, closed: f64, tried: &mut usize) -> Result<Option<Trial>, NoFilm> {
        let before = self.residual(trial).hypot(left.residual);
        let accuracy = (OF_LEFT * before).max(SPARE * closed / before).min(ROUGHEST);
        let wanted = self.excess(trial).map(|excess| -excess);
        let tangents = self.tangents(trial, left, accuracy)?;
        let moves = tangents.solve(wanted, Some(&left.wall))?;
        let least = LEAST_SHRINK * self.least_film(trial);
        let mut films = 0;
        for part in (0..MOST_LENGTHS).map(|times| 0.5f64.powi(times)) {
            let Some((bent, at)) = self.led_on(trial, &moves, part, least) else {
                continue;
            };
            *tried += 1;
            let bent = counted(bent, (films, tangents.products()), f64::INFINITY);
            let next = match &trial.cubic {
                Some(cubic) => self.open_cubic(&bent, at, (&trial.film, Some(cubic))),
                None => self.open(&bent, at, Neighbour::Start(&trial.film), closed),
            };
            films += 1;
            if let Ok(next) = next
                && self.left(&next) < before
            {
                return Ok(Some(next));
            }
            if before < AT_ROUNDING {
                break;
            }
        }
        Ok(None)
    }
}

/// A problem whose wall took so many films and products more, and leaves this part of its balance.
fn counted(problem: FilmProblem, (films, products): (usize, usize), residual: f64) -> FilmProblem {
    let before = problem.deflection().map(|deflection| deflection.closing);
    match before {
        None => problem,
        Some(before) => {
            problem.closed_by(Closing { residual, outer: before.outer + films, inner: before.inner + products })
        }
    }
}
