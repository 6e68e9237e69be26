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
//! tangent (a semismooth Newton method); the tangent is that of [`crate::coupled`]. A step is as long as the gap stays
//! open and as the journal moves by half a clearance; nothing else shortens it. Where the place of the journal is held
//! the wall alone is found. The numbers below are those that `docs/theory/balance.md` gives.
//!
//! **Globalisation.** From a start that is not near, pseudo-time: the tangent, not the residual, has the squeeze of the
//! step, `dh/dt = rate dh`. The rate falls with what is left, and is zero at last.
//!
//! **Source.** Hintermueller, Ito, Kunisch, SIAM J. Optim. 13 (2003) 865 (active sets as Newton's method); Kelley,
//! Keyes, SIAM J. Numer. Anal. 35 (1998) 508 (pseudo-transient continuation). **Verified by** `tests/tests/liner`,
//! `tests/tests/equilibrium.rs`: balances of force and wall.

use oilwedge_reynolds::{MixedChange, NoFilm};

use crate::coordinates::{length, moved};
use crate::coupled::{FilmSolve, counted};
use crate::deflection::{Left, resting};
use crate::equilibrium::NEAR;
use crate::no_equilibrium::SearchEnd;
use crate::search::{Search, Trial};
use crate::warming::{self, Warming};
use crate::work::Work;

/// Most films from a start that is near.
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
/// A step that is too long is shortened by this factor.
const SHORTER: f64 = 0.8;
/// A step is shortened so often at most.
const MOST_SHORTENINGS: usize = 40;
/// A step that leaves more than [`STALLED`] below this part has reached round-off.
pub(crate) const ROUNDING: f64 = 1e-10;
/// A step of films in cubic elements, which are iterated, that leaves more than [`STALLED`] below this part has reached
/// what their iterations leave.
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

impl Search<'_> {
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
        let mut here = first;
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
            let (now, is_settled) = (self.left(&here), here.film.solution.wrong.is_empty());
            let is_at_rounding = now > STALLED * last && force.max(wall) < goal.rounding;
            let is_balanced = force < goal.balanced && wall < goal.closed && ahead <= goal.moved;
            let is_heat_balanced = self.unbalanced_heat(&here) < warming::BALANCED.max(goal.balanced);
            if is_settled && is_heat_balanced && (is_balanced || is_at_rounding) {
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
            self.correct_row(&here, &next);
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
        let Warming { moves, kelvin } = self.with_heat(here, &tangents, moves)?;
        self.spend(Work {
            linear_solves: self.coordinates.order + usize::from(self.options.warming.is_some()) + tangents.products(),
            ..Work::default()
        });
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
            let bent = self.warmed(counted(bent, (0, tangents.products()), f64::INFINITY), part * kelvin);
            let next = match &here.cubic {
                Some(cubic) => self.open_cubic(&bent, at, (&here.film, Some(cubic))),
                None => {
                    let start = here.film.start_after(&MixedChange::sum([(part, &moves.film)]));
                    self.open(&bent, at, FilmSolve::Step(start), closed)
                }
            };
            match next {
                Ok(next) if self.left(&next).is_finite() => return Ok(Some((next, part))),
                Ok(_) | Err(_) => part *= SHORTER,
            }
        }
        Ok(None)
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
