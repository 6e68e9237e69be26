//! One implicit stage: the offset at which film, support and mass carry the load of its time.
//!
//! With `v = (x - x_0)/(gamma dt)` the residual is `W(x, v) + m (v - v_0)/(gamma dt) - F`, its tangent `K + C/(gamma dt) + m/(gamma dt)^2`.

use oilwedge_reynolds::NoFilm;
use oilwedge_reynolds::solve::Neighbour;

use super::motion::{Instant, Motion};
use crate::coordinates::{Vector, length, moved};
use crate::stiffness::Stiffness;

/// Most films of one stage.
const MOST_FILMS: usize = 14;
/// No iteration leaves less than this part of the least gap.
const LEAST_SHRINK: f64 = 0.4;
/// Shortest part of an iteration that is tried.
const SHORTEST: f64 = 0.05;
/// A stage is solved where the residual over the load, and the next change over the least gap, are below these parts of the tolerance;
const BALANCED: f64 = 1e-3;
const SETTLED: f64 = 3e-2;
/// of the residual not less than this, which is round-off;
const ROUND_OFF: f64 = 1e-11;
/// or below this where no shorter change brings it down.
const NEARLY_BALANCED: f64 = 1e-8;

/// What is known of a stage before it is solved.
#[derive(Debug, Clone, Copy)]
pub(super) struct Known {
    /// Its time [s].
    pub(super) time: f64,
    /// `1/(gamma dt)` [1/s].
    pub(super) per_time: f64,
    /// `x_0` and `v_0`: offsets [m] and, for a rotor with mass, rates [m/s] from the stages before.
    pub(super) offset: Vector,
    pub(super) rate: Vector,
}

/// How exactly a stage is solved.
#[derive(Debug, Clone, Copy)]
pub(super) struct Accuracy {
    /// Tolerance of the orbit [1].
    pub(super) tolerance: f64,
    /// Residuals are relative to this force [N].
    pub(super) scale: f64,
}

impl Accuracy {
    /// Residual over the load at which a stage is solved [1].
    fn balanced(&self) -> f64 {
        (BALANCED * self.tolerance).max(ROUND_OFF)
    }
}

/// Why a stage has no solution.
#[derive(Debug)]
pub(super) enum NoStage {
    /// There is no film.
    Film(NoFilm),
    /// The iteration does not converge.
    Diverged,
}

impl From<NoFilm> for NoStage {
    fn from(reason: NoFilm) -> Self {
        Self::Film(reason)
    }
}

impl Motion<'_> {
    /// Solves a stage from a `start` and a film nearby; `films` counts those solved.
    pub(super) fn stage(
        &self,
        known: &Known,
        start: Vector,
        near: &Instant,
        accuracy: Accuracy,
        films: &mut usize,
    ) -> Result<Instant, NoStage> {
        let film = |at: Vector, near: &Instant, films: &mut usize| {
            *films += 1;
            let velocity = known.velocity(at);
            self.film(known.time, at, velocity, Neighbour::Start(&near.film))
        };
        let mut here = film(self.inside(near.at, start), near, films)?;
        for _ in 1..MOST_FILMS {
            let residual = self.residual(known, &here);
            let step = self.stage_tangent(known, &here)?.solve(residual.map(|part| -part));
            let gap = self.gap(here.at);
            let balance = length(residual) / accuracy.scale;
            let change = length(step) / gap;
            if !change.is_finite() {
                return Err(NoStage::Diverged);
            }
            if balance < accuracy.balanced() && change < SETTLED * accuracy.tolerance {
                return Ok(here);
            }
            let mut part = 1.0;
            while self.gap(moved(here.at, part, step)) < LEAST_SHRINK * gap {
                part *= 0.8;
            }
            loop {
                let next = film(moved(here.at, part, step), &here, films);
                let falls = |next: &Instant| length(self.residual(known, next)) < length(residual);
                match next {
                    Ok(next) if falls(&next) => {
                        here = next;
                        break;
                    }
                    Ok(_) if balance < NEARLY_BALANCED => return Ok(here),
                    Err(reason) if part < SHORTEST => return Err(reason.into()),
                    _ if part < SHORTEST => return Err(NoStage::Diverged),
                    _ => part *= 0.5,
                }
            }
        }
        Err(NoStage::Diverged)
    }

    /// The velocity at a given place in which film and support carry the load, sought from a `guess`.
    pub(super) fn carried(
        &self,
        (time, at): (f64, Vector),
        guess: Vector,
        accuracy: Accuracy,
        films: &mut usize,
    ) -> Result<Instant, NoStage> {
        let mut here = self.film(time, at, guess, Neighbour::None)?;
        *films += 1;
        for _ in 1..MOST_FILMS {
            let balance = length(here.excess) / accuracy.scale;
            if balance < accuracy.balanced() {
                return Ok(here);
            }
            let step = (self.tangent(&here, 0.0, 1.0)?).solve(here.excess.map(|part| -part));
            if !length(step).is_finite() {
                return Err(NoStage::Diverged);
            }
            let mut part = 1.0;
            loop {
                let velocity = moved(here.velocity, part, step);
                *films += 1;
                let next = self.film(time, at, velocity, Neighbour::Start(&here.film))?;
                if length(next.excess) < length(here.excess) {
                    here = next;
                    break;
                }
                part *= 0.5;
                match part < SHORTEST {
                    true if balance < NEARLY_BALANCED => return Ok(here),
                    true => return Err(NoStage::Diverged),
                    false => {}
                }
            }
        }
        Err(NoStage::Diverged)
    }

    /// What is left of the equation of motion [N].
    fn residual(&self, known: &Known, here: &Instant) -> Vector {
        let masses = self.masses();
        [0, 1, 2, 3].map(|k| here.excess[k] + masses[k] * (here.velocity[k] - known.rate[k]) * known.per_time)
    }

    fn stage_tangent(&self, known: &Known, here: &Instant) -> Result<Stiffness, NoFilm> {
        let tangent = self.tangent(here, 1.0, known.per_time)?;
        let inertia = self.masses().map(|mass| mass * known.per_time.powi(2));
        Ok(tangent.with_diagonal(inertia))
    }

    /// A start, or a place on the way to it that leaves enough of the film.
    fn inside(&self, from: Vector, to: Vector) -> Vector {
        let gap = self.gap(from);
        let way: Vector = moved(to, -1.0, from);
        let mut part = 1.0;
        while self.gap(moved(from, part, way)) < LEAST_SHRINK * gap {
            part *= 0.8;
        }
        moved(from, part, way)
    }
}

impl Known {
    /// The rate of a journal at these coordinates.
    fn velocity(&self, at: Vector) -> Vector {
        moved(at, -1.0, self.offset).map(|way| way * self.per_time)
    }
}
