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
//! | d, C f - d | m | `deflection`, `WallResidual` |
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

use std::borrow::Cow;

use oilwedge_reynolds::NoFilm;

use crate::coordinates::length;
use crate::deflection::{Moves, WallResidual};
use crate::equilibrium::NEAR;
use crate::no_equilibrium::SearchEnd;
use crate::search::{Search, Trial};
use crate::together::{Coupled, greatest};
use crate::warming;

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
pub(crate) struct BalanceTolerance {
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
        goal: BalanceTolerance,
        damping: Damping,
        tried: &mut usize,
    ) -> Result<Trial, Unbalanced> {
        let alone = Coupled { searches: std::slice::from_ref(self), shaft: None };
        let (trials, end) = alone.newton(vec![first], goal, damping, tried);
        let trial = trials.into_iter().next().expect("as many trials as searches");
        match end {
            None => Ok(trial),
            Some(end) => Err(Unbalanced { trial: Box::new(trial), end }),
        }
    }
}

impl Coupled<'_, '_> {
    /// The balance of all films from trials on by Newton's method, each step with one factorisation of each film: the
    /// trials reached, and what stopped there without a balance.
    pub(crate) fn newton(
        &self,
        first: Vec<Trial>,
        goal: BalanceTolerance,
        damping: Damping,
        tried: &mut usize,
    ) -> (Vec<Trial>, Option<SearchEnd>) {
        let mut here = first;
        // Of pseudo-time, over the rate at which the motion changes the film.
        let (mut rate, most) = match damping {
            Damping::None => (0.0, MOST_UNDAMPED),
            Damping::PseudoTime => (1.0, MOST_DAMPED),
        };
        // What was left of the load before, and the way still to go over the least film.
        let (mut last, mut ahead) = (f64::INFINITY, f64::INFINITY);
        for _ in 0..most {
            let walls = self.left_of_walls(&here);
            let (force, wall) = (self.residual(&here), greatest(walls.iter().map(|left| left.residual)));
            let (now, is_settled) = (self.left(&here), here.iter().all(|trial| trial.film.solution.wrong.is_empty()));
            let is_at_rounding = now > STALLED * last && force.max(wall) < goal.rounding;
            let is_balanced = force < goal.balanced && wall < goal.closed && ahead <= goal.moved;
            let is_warmth_balanced = self.part_left_over(&here) < warming::BALANCED.max(goal.balanced);
            if is_settled && is_warmth_balanced && (is_balanced || is_at_rounding) {
                return (here, None);
            }
            if self.searches.iter().any(|search| search.options.deadline.is_over()) {
                return (here, Some(SearchEnd::Ended));
            }
            if self.least_film(&here) < CONTACT {
                return (here, Some(SearchEnd::Touching));
            }
            let accuracy = (OF_LEFT * now).max(SPARE * goal.closed / now).min(ROUGHEST);
            let in_time = if rate < LEAST_RATE { 0.0 } else { rate };
            let Ok(Some((next, part))) = self.stepped(&here, (&walls, goal.closed), (accuracy, in_time), tried) else {
                return (here, Some(SearchEnd::NoStep));
            };
            let left_over = self.left(&next);
            self.correct_rows(&here, &next);
            // Newton's method reduces the steps as it reduces what is left.
            ahead = self.way(&here, &next) / part * (1.0 - part + left_over / now);
            rate = next_rate(rate, part, [now, left_over], damping);
            (here, last) = (next, now);
        }
        (here, Some(SearchEnd::NoProgress))
    }

    /// The trials after a step of Newton's method, and which part of it was taken: as much as keeps all gaps open. None
    /// where there is no film on the way.
    fn stepped(
        &self,
        here: &[Trial],
        (walls, closed): (&[Cow<'_, WallResidual>], f64),
        (accuracy, rate): (f64, f64),
        tried: &mut usize,
    ) -> Result<Option<(Vec<Trial>, f64)>, NoFilm> {
        let Some(moves) = self.moves(here, walls, (accuracy, rate))? else {
            return Ok(None);
        };
        let longest =
            |(trial, moves): (&Trial, &Moves)| LONGEST * trial.film.problem.bearing.clearance / length(moves.place);
        let mut part = here.iter().zip(&moves).map(longest).fold(1.0, f64::min);
        for _ in 0..MOST_SHORTENINGS {
            if part.is_nan() || part <= 0.0 {
                return Ok(None);
            }
            let Some(led) = self.led_on(here, &moves, part, LEAST_SHRINK) else {
                part *= SHORTER;
                continue;
            };
            *tried += here.len();
            match self.opened(here, led, (&moves, part), closed) {
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
