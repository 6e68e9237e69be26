//! # Newton's method for journal and wall around one film
//!
//! **Equation.** For the coordinates x of the journal and the deflection d of its wall
//!
//! ```text
//! W(x, d) + S x = F        C f(p(x, d)) = d        p: the film with the cavity of the step
//! ```
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | W, F, S x | N | `response`, `asked` |
//! | d, C f - d | m | `deflection`, `Left` |
//! | rate | 1/s | of pseudo-time |
//!
//! **Method.** A step assembles and factorises the film once, with the cavity that the step before foretells along its
//! tangent (a semismooth Newton method). The tangent is bordered by that of load and wall: [`Joint`], the journal
//! eliminated and the wall found by GMRES, or [`Bordered`], of the film in cubic elements. A step is as long as the gap
//! stays open and as the journal moves by half a clearance; nothing else shortens it.
//!
//! **Globalisation.** From a start that is not near, pseudo-time: the tangent, not the residual, has the squeeze of the
//! step, `dh/dt = rate dh`. The rate falls with what is left, and is zero at last.
//!
//! **Source.** Hintermueller, Ito, Kunisch, SIAM J. Optim. 13 (2003) 865 (active sets as Newton's method); Kelley,
//! Keyes, SIAM J. Numer. Anal. 35 (1998) 508 (pseudo-transient continuation). **Verified by** `tests/tests/liner`,
//! `tests/tests/equilibrium.rs`: balances of force and wall.

use std::borrow::Cow;

use oilwedge_fem::newton::Failure;
use oilwedge_reynolds::contact::Contact;
use oilwedge_reynolds::film_thickness::Closing;
use oilwedge_reynolds::quantities::load::{load, load_change, load_touching};
use oilwedge_reynolds::solve::{FilmStart, Neighbour};
use oilwedge_reynolds::{FilmChange, FilmProblem, JournalChange, JournalState, MixedChange, NoFilm, SolvedFilm};

use crate::coordinates::{Vector, length, moved, unit};
use crate::deflection::{Bordered, Follower, Joint, Left, Moves, NEARLY, contact_points, resting, settled};
use crate::equilibrium::NEAR;
use crate::no_equilibrium::SearchEnd;
use crate::search::{Search, Trial, fineness};
use crate::stiffness::Stiffness;
use crate::work::Work;

/// Most films from a start that is near, and from any other one.
const MOST_UNDAMPED: usize = 14;
/// Most films with pseudo-time.
const MOST_DAMPED: usize = 80;
/// Accuracy of the linear system of a step at the roughest.
const ROUGHEST: f64 = 1e-2;
/// Accuracy of the linear system of a step over what is left, which Newton's method squares.
const OF_LEFT: f64 = 0.3;
/// The system of a last step leaves this part of what may be left at last.
const SPARE: f64 = 0.3;
/// Least film after a step over that before.
const LEAST_SHRINK: f64 = 0.3;
/// Longest step over the clearance.
const LONGEST: f64 = 0.5;
/// A step that is too long is shortened by this factor,
const SHORTER: f64 = 0.8;
/// so often at most.
const MOST_SHORTENINGS: usize = 40;
/// A step that leaves more than [`STALLED`] below this part has reached round-off.
pub(crate) const ROUNDING: f64 = 1e-10;
/// The same of films in cubic elements, which are iterated.
pub(crate) const CUBIC_ROUNDING: f64 = 1e-8;
/// A step that leaves more than this part of what was left before is at round-off, or has not converged.
const STALLED: f64 = 0.5;
/// Rates of pseudo-time below this part of the first are none.
const LEAST_RATE: f64 = 1e-4;
/// A journal whose film is thinner than this part of the clearance touches.
const CONTACT: f64 = 1e-6;

/// What a balance may leave.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Goal {
    /// Difference of force and load over the load [1].
    pub(crate) balanced: f64,
    /// Part of the deflection [1].
    pub(crate) closed: f64,
    /// Difference of the journal's place over the least film [1].
    pub(crate) moved: f64,
    /// Differences of load and deflection where round-off keeps a balance from less [1].
    pub(crate) rounding: f64,
}

/// What keeps steps from a start short.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Damping {
    /// Nothing: the start is near.
    None,
    /// Pseudo-time.
    PseudoTime,
}

/// Where Newton's method ended without a balance.
pub(crate) struct Unbalanced {
    /// The trial reached.
    pub(crate) trial: Box<Trial>,
    /// What stopped there.
    pub(crate) end: SearchEnd,
}

/// How the film of a trial is solved.
pub(crate) enum Begin<'a> {
    /// Until its cavity is settled, from a film nearby.
    Near(Neighbour<'a>),
    /// By one step.
    Step(FilmStart),
}

/// How the journal of a film, and a wall that gives way, move where their balances are to change.
pub(crate) enum Tangents<'a> {
    /// The wall is rigid.
    Rigid(Rigid),
    /// It gives way.
    Yielding(Box<Joint<'a>>),
    /// It gives way, and the film in cubic elements carries the load.
    OfCubic(Box<Bordered<'a>>),
}

/// How force and film change with each coordinate of a journal in a rigid wall.
pub(crate) struct Rigid {
    stiffness: Stiffness,
    columns: Vec<MixedChange>,
}

impl Tangents<'_> {
    /// The moves by which forces change by `force` [N], and the wall by `wall` [m] more than film and contact bend it,
    /// or by no more.
    ///
    /// # Errors
    /// The linear systems could not be solved.
    pub(crate) fn solve(&self, force: Vector, wall: Option<&[f64]>) -> Result<Moves, NoFilm> {
        match self {
            Self::Rigid(rigid) => {
                let place = rigid.stiffness.solve(force);
                let film = MixedChange::sum(place.into_iter().zip(&rigid.columns));
                Ok(Moves { place, wall: Vec::new(), contact: Vec::new(), film })
            }
            Self::Yielding(joint) => Ok(joint.solve(force, wall).map_err(Failure::from)?),
            Self::OfCubic(bordered) => Ok(bordered.solve(force, wall).map_err(Failure::from)?),
        }
    }

    /// How many products with the tangent that took.
    fn products(&self) -> usize {
        match self {
            Self::Rigid(..) => 0,
            Self::Yielding(joint) => joint.products(),
            Self::OfCubic(bordered) => bordered.products(),
        }
    }
}

impl Search<'_> {
    /// The film `at` these coordinates under the wall of a problem as it is, what it leaves of the balance of that wall
    /// included. Contact is integrated as finely as a balance to the `part` asks for.
    pub(crate) fn open(&self, problem: &FilmProblem, at: Vector, begin: Begin, part: f64) -> Result<Trial, NoFilm> {
        let problem = self.placed(problem, at).tried().with_contact(fineness(part));
        let film = match begin {
            Begin::Near(near) => problem.solve_from(self.system, near)?,
            Begin::Step(start) => problem.step(self.system, start)?,
        };
        let left = Left::of(&film, contact_points(&problem, self.system));
        let carried = load_touching(&film, left.contact.as_deref());
        let film = SolvedFilm { problem: counted(problem, (1, 0), left.residual), ..film };
        Ok(self.recorded(Trial {
            contact: left.contact.clone(),
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
        Ok(self.of_pair(film, cubic))
    }

    /// The trial of a film and of the same film in cubic elements, whose force counts.
    pub(crate) fn of_pair(&self, film: SolvedFilm, cubic: SolvedFilm) -> Trial {
        let left = Left::of(&cubic, contact_points(&film.problem, self.system));
        let problem = counted(film.problem.clone(), (1, 0), left.residual);
        let (film, cubic) = (SolvedFilm { problem: problem.clone(), ..film }, SolvedFilm { problem, ..cubic });
        let carried = load(&cubic).total.resultant();
        self.recorded(Trial {
            cubic: Some(cubic),
            contact: left.contact.clone(),
            left: Some(left),
            ..Trial::of(film, carried)
        })
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

    /// How journal and wall of a trial move in pseudo-time, in which its `film` rests; see [`Tangents`]. Its linear
    /// systems are solved to an `accuracy`.
    ///
    /// # Errors
    /// The linear systems could not be solved.
    pub(crate) fn tangents<'t>(
        &'t self,
        trial: &'t Trial,
        film: &'t SolvedFilm,
        left: &Left,
        (accuracy, rate): (f64, f64),
    ) -> Result<Tangents<'t>, NoFilm> {
        let of = |film| Follower::touching(film, left.contact.clone()).map_err(Failure::from);
        let Some(follower) = of(film)? else {
            return Ok(Tangents::Rigid(self.rigid(film, rate)?));
        };
        let (journal, velocity, held) =
            (&trial.film.problem.journal, self.options.centre_velocity, self.stiffness_beside());
        let change = |k: usize| self.change_at(journal, unit(k), rate);
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

    /// The tangent of a film in a rigid wall whose journal moves in pseudo-time.
    fn rigid(&self, film: &SolvedFilm, rate: f64) -> Result<Rigid, NoFilm> {
        let changes: Vec<FilmChange> = (0..self.coordinates.order)
            .map(|k| FilmChange::Journal(self.change_at(&film.problem.journal, unit(k), rate)))
            .collect();
        let columns = film.mixed_changes(&changes).map_err(Failure::from)?;
        let stiffness = Stiffness::by_columns(self.coordinates.order, |k| {
            let carried = load_change(film, &changes[k..=k], &film.unknown_in(&columns[k]));
            let mut column = self.coordinates.forces(&carried);
            column[k] += self.stiffness_beside()[k];
            Ok::<_, NoFilm>(column)
        })?;
        Ok(Rigid { stiffness, columns })
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

    /// The balance from a trial on by Newton's method, each step with one factorisation.
    ///
    /// # Errors
    /// [`Unbalanced`]: the trial reached, and what stopped there.
    pub(crate) fn newton(
        &self,
        first: Trial,
        goal: Goal,
        damping: Damping,
        tried: &mut usize,
    ) -> Result<Trial, Unbalanced> {
        let mut here = self.as_fine(first, goal.closed, tried);
        // Of pseudo-time, over the rate at which the motion changes the film.
        let (mut rate, most) = match damping {
            Damping::None => (0.0, MOST_UNDAMPED),
            Damping::PseudoTime => (1.0, MOST_DAMPED),
        };
        let ended = |trial: Trial, end: SearchEnd| Err(Unbalanced { trial: Box::new(trial), end });
        // What was left of the load before, and the way still to go over the least film.
        let (mut last, mut ahead) = (f64::INFINITY, f64::INFINITY);
        for _ in 0..most {
            let left = self.left_of_wall(&here).into_owned();
            let (force, wall) = (self.residual(&here), left.residual);
            let (now, is_settled) = (force.hypot(wall), here.film.solution.wrong.is_empty());
            let is_at_rounding = now > STALLED * last && force.max(wall) < goal.rounding;
            let is_balanced = force < goal.balanced && wall < goal.closed && ahead <= goal.moved;
            if is_settled && (is_balanced || is_at_rounding) {
                return Ok(here);
            }
            if self.options.deadline.is_over() {
                return ended(here, SearchEnd::Ended);
            }
            if self.least_film(&here) < CONTACT * here.film.problem.bearing.clearance {
                return ended(here, SearchEnd::Touching);
            }
            let accuracy = (OF_LEFT * now).max(SPARE * goal.closed / now).min(ROUGHEST);
            let in_time = if rate < LEAST_RATE { 0.0 } else { rate * self.reference_rate };
            let stepped = self.stepped(&here, (&left, goal.closed), (accuracy, in_time), tried);
            let Ok(Some((next, part))) = stepped else {
                return ended(here, SearchEnd::NoStep);
            };
            let left_over = self.left(&next);
            let way = moved(self.place(&next), -1.0, self.place(&here));
            // Newton's method reduces the steps as it reduces what is left.
            ahead = length(way) / part * (1.0 - part + left_over / now) / self.least_film(&here);
            rate = next_rate(rate, part, [now, left_over], damping);
            (here, last) = (next, now);
        }
        ended(here, SearchEnd::NoProgress)
    }

    /// The trial after a step of Newton's method, and which part of it was taken: as much as keeps the gap open. None
    /// where there is no film on the way.
    fn stepped(
        &self,
        here: &Trial,
        (left, closed): (&Left, f64),
        (accuracy, rate): (f64, f64),
        tried: &mut usize,
    ) -> Result<Option<(Trial, f64)>, NoFilm> {
        let film = resting(&here.film, rate);
        let tangents = self.tangents(here, &film, left, (accuracy, rate))?;
        let moves = tangents.solve(self.excess(here).map(|excess| -excess), Some(&left.wall))?;
        self.spend(Work { linear_solves: self.coordinates.order + tangents.products(), ..Work::default() });
        let (gap, length) = (self.least_film(here), length(moves.place));
        if !length.is_finite() {
            return Ok(None);
        }
        let mut part = (LONGEST * here.film.problem.bearing.clearance / length).min(1.0);
        for _ in 0..MOST_SHORTENINGS {
            let Some((bent, at)) = self.led_on(here, &moves, part, LEAST_SHRINK * gap) else {
                part *= SHORTER;
                continue;
            };
            *tried += 1;
            let bent = counted(bent, (0, tangents.products()), f64::INFINITY);
            let next = match &here.cubic {
                Some(cubic) => self.open_cubic(&bent, at, (&here.film, Some(cubic))),
                None => {
                    let start = here.film.start_after(&MixedChange::sum([(part, &moves.film)]));
                    self.open(&bent, at, Begin::Step(start), closed)
                }
            };
            match next {
                Ok(next) if self.left(&next).is_finite() => return Ok(Some((next, part))),
                Ok(_) | Err(_) => part *= SHORTER,
            }
        }
        Ok(None)
    }

    /// Coordinates of a trial [m].
    fn place(&self, trial: &Trial) -> Vector {
        self.coordinates.at(&trial.film.problem.journal)
    }

    /// The change of a journal that moves by `place` [m] within the pseudo-time `1/rate` [s] and in the time of a stage.
    pub(crate) fn change_at(&self, journal: &JournalState, place: Vector, rate: f64) -> JournalChange {
        let rate = rate + self.time.map_or(0.0, |time| time.per_time);
        let steady = self.coordinates.change(journal, &self.options.centre_velocity, place);
        let [v, w] = [steady.offset, steady.tilt].map(|way| way.map(|x| rate * x));
        let sum = |a: [f64; 2], b: [f64; 2]| [a[0] + b[0], a[1] + b[1]];
        JournalChange { velocity: sum(steady.velocity, v), tilt_rate: sum(steady.tilt_rate, w), ..steady }
    }

    /// A trial whose contact is not integrated as finely as a balance asks for, with it so: films of one balance are
    /// compared.
    fn as_fine(&self, trial: Trial, closed: f64, tried: &mut usize) -> Trial {
        let is_fine = |contact: Contact| contact.fineness == fineness(closed);
        if trial.film.problem.contact.is_none_or(is_fine) || trial.cubic.is_some() {
            return trial;
        }
        *tried += 1;
        let here = self.coordinates.at(&trial.film.problem.journal);
        let near = Begin::Near(Neighbour::Start(&trial.film));
        self.open(&trial.film.problem, here, near, closed).unwrap_or(trial)
    }
}

/// The rate of pseudo-time after a step of which a `part` was taken, by what was left before and after it.
fn next_rate(rate: f64, part: f64, [before, after]: [f64; 2], damping: Damping) -> f64 {
    match damping {
        Damping::None => 0.0,
        Damping::PseudoTime if part <= 0.3 => 2.0 * rate,
        Damping::PseudoTime if part <= 0.9 => rate,
        Damping::PseudoTime if after >= before => 4.0 * rate.max(LEAST_RATE),
        Damping::PseudoTime => {
            let near = if part == 1.0 && after < NEAR { 0.1 } else { 1.0 };
            rate * near * (0.5 * after / before).max(0.1)
        }
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
