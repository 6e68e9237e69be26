//! One implicit stage: the offset at which film, support and mass carry the load of its time.
//!
//! With `v = (x - x_0)/(gamma dt)` the residual is `W(x, v) + m (v - v_0)/(gamma dt) - F`, its tangent
//! `K + C/(gamma dt) + m/(gamma dt)^2`.

use std::sync::Arc;

use oilwedge_fem::newton::Failure;
use oilwedge_reynolds::film_thickness::{Deflection, WallStage};
use oilwedge_reynolds::solve::Neighbour;
use oilwedge_reynolds::{FilmProblem, NoFilm};

use super::motion::{Held, Instant, Motion, Moving};
use super::oil::Before;
use crate::coordinates::{Vector, dot, length, moved};
use crate::stiffness::Stiffness;

/// Most films of one stage; see `docs/theory/orbits.md` for other numbers tried.
pub(super) const MOST_FILMS: usize = 30;
/// No iteration leaves less than this part of the least gap.
pub(super) const LEAST_SHRINK: f64 = 0.4;
/// Shortest part of an iteration that is tried: cells that fill stiffen the film within a small part of one. With 0.05
/// the cycle of a half-grooved bearing ends in its first turn.
pub(super) const SHORTEST: f64 = 1e-3;
/// A stage is solved where the residual over the load, and the next change over the least gap, are below these parts of
/// the tolerance;
const BALANCED: f64 = 1e-3;
pub(super) const SETTLED: f64 = 3e-2;
/// of the residual not less than this, which is round-off;
const ROUND_OFF: f64 = 1e-11;
/// or below this where no shorter change brings it down.
pub(super) const NEARLY_BALANCED: f64 = 1e-8;

/// A tangent is corrected by what it missed, not made anew, where it has reduced the residual to less than this part.
const STEEP: f64 = 0.1;
/// The short time in which the motion of a film that conserves its oil begins, of the cycle.
const BEGINNING: f64 = 1e-7;

/// What is known of a stage before it is solved.
#[derive(Debug, Clone)]
pub(super) struct Known {
    /// Its time [s].
    pub(super) time: f64,
    /// `1/(gamma dt)` [1/s].
    pub(super) per_time: f64,
    /// `x_0` and `v_0`: offsets [m] and, for a rotor with mass, rates [m/s] from the stages before.
    pub(super) offset: Vector,
    pub(super) rate: Vector,
    /// What the stages before leave to a film that conserves its oil.
    pub(super) before: Option<Before>,
    /// What they leave to a wall that gives way, and where it is to be expected.
    pub(super) wall: Option<(WallStage, Vec<f64>)>,
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
    pub(super) fn balanced(&self) -> f64 {
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
        if let Some(wall) = known.wall_from(near) {
            return self.stage_with_wall((known, wall), start, near, accuracy, films);
        }
        let film = |at: Vector, near: Neighbour, films: &mut usize| {
            *films += 1;
            let moving = Moving { time: known.time, at, velocity: known.velocity(at) };
            let storage = known.before.as_ref().map(|before| &before.storage);
            self.trial(moving, Held { storage, wall: None }, near)
        };
        let at = self.inside(near.at, start);
        let mut here = film(at, Neighbour::Start(&near.film), films)?;
        let mut corrected: Option<Stiffness> = None;
        for _ in 1..MOST_FILMS {
            let residual = self.residual(known, &here);
            let tangent = match corrected.take() {
                Some(tangent) => tangent,
                None => self.stage_tangent(known, &here)?,
            };
            let step = tangent.solve(residual.map(|part| -part));
            let gap = self.least_gap(here.at);
            let balance = length(residual) / accuracy.scale;
            let change = length(step) / gap;
            if !change.is_finite() {
                return Err(NoStage::Diverged);
            }
            if balance < accuracy.balanced() && change < SETTLED * accuracy.tolerance {
                return self.found(known, here);
            }
            let mut part = 1.0;
            while self.least_gap(moved(here.at, part, step)) < LEAST_SHRINK * gap {
                part *= 0.8;
            }
            loop {
                let next = film(moved(here.at, part, step), Neighbour::Start(&here.film), films);
                let falls = |next: &Instant| {
                    let left = self.residual(known, next);
                    length(left) < length(residual) || dot(left, step).abs() < dot(residual, step).abs()
                };
                match next {
                    Ok(next) if falls(&next) => {
                        let left = self.residual(known, &next);
                        // The tangent of a film that conserves its oil costs more than what one film more does.
                        if known.before.is_some() && length(left) < STEEP * length(residual) {
                            let made = moved(next.at, -1.0, here.at);
                            let told = moved(residual, 1.0, tangent.times(made));
                            corrected = Some(tangent.corrected(made, moved(left, -1.0, told)));
                        }
                        here = next;
                        break;
                    }
                    Ok(_) if balance < NEARLY_BALANCED => return self.found(known, here),
                    Err(reason) if part < SHORTEST => return Err(reason.into()),
                    _ if part < SHORTEST => return Err(NoStage::Diverged),
                    _ => part *= 0.5,
                }
            }
        }
        Err(NoStage::Diverged)
    }

    /// The end of a stage, with the oil that the film holds.
    pub(super) fn found(&self, known: &Known, here: Instant) -> Result<Instant, NoStage> {
        let here = self.accepted(here)?;
        let Some(before) = &known.before else {
            return Ok(here);
        };
        let oil = before.oil(&here.film).map_err(Failure::from);
        Ok(Instant { oil: Some(Arc::new(oil.map_err(NoFilm::from)?)), ..here })
    }

    /// Where an orbit begins: in films without memory at the velocity in which film and support carry the load, full
    /// ones that conserve their oil after a time that is short beside all steps.
    pub(super) fn beginning(
        &self,
        at: Vector,
        period: f64,
        accuracy: Accuracy,
        films: &mut usize,
    ) -> Result<Instant, NoStage> {
        if !self.problem.cavitation.conserves_oil() {
            return self.carried((0.0, at), [0.0; 4], accuracy, films);
        }
        let (velocity, wall) = self.without_memory(at, accuracy, films)?;
        let moving = Moving { time: 0.0, at, velocity };
        let full = FilmProblem { journal: self.journal(0.0, at, velocity), ..self.problem.clone() };
        let full = full.deflected(wall.as_ref());
        let held = full.oil_of_full_film(self.system).map_err(Failure::from);
        let per_time = 1.0 / (BEGINNING * period);
        let before = Before::at_rest(per_time, held.map_err(NoFilm::from)?);
        let held = Held { storage: Some(&before.storage), wall: wall.as_ref() };
        let (near, _) = self.trial_under(moving, held, Neighbour::None)?;
        let known = Known {
            time: 0.0,
            per_time,
            offset: at,
            rate: [0.0; 4],
            before: Some(before),
            wall: wall.map(|wall| (wall.resting(per_time), wall.coefficients.to_vec())),
        };
        self.stage(&known, moved(at, 1.0 / per_time, velocity), &near, accuracy, films)
    }

    /// How the motion of a film that conserves its oil begins: in a rigid liner at rest. In one that gives way the wall
    /// has no time to move, so it is where a film without memory bends it, which carries the load in this velocity.
    fn without_memory(
        &self,
        at: Vector,
        accuracy: Accuracy,
        films: &mut usize,
    ) -> Result<(Vector, Option<Deflection>), NoStage> {
        if self.problem.deflection().is_none() {
            return Ok(([0.0; 4], None));
        }
        let problem = FilmProblem {
            cavitation: self.problem.cavitation.guide().unwrap_or(self.problem.cavitation),
            ..self.problem.clone()
        };
        let motion = Motion { problem: &problem, gap: self.gap.clone(), ..*self };
        let begin = motion.carried((0.0, at), [0.0; 4], accuracy, films)?;
        Ok((begin.velocity, begin.film.problem.deflection().cloned()))
    }

    /// The velocity at a given place in which film and support carry the load, sought from a `guess`.
    pub(super) fn carried(
        &self,
        (time, at): (f64, Vector),
        guess: Vector,
        accuracy: Accuracy,
        films: &mut usize,
    ) -> Result<Instant, NoStage> {
        let moving = |velocity: Vector| Moving { time, at, velocity };
        let mut here = self.trial(moving(guess), Held::default(), Neighbour::None)?;
        *films += 1;
        for _ in 1..MOST_FILMS {
            let balance = length(here.excess) / accuracy.scale;
            if balance < accuracy.balanced() {
                return Ok(self.accepted(here)?);
            }
            let step = (self.tangent(&here, 0.0, 1.0)?).solve(here.excess.map(|part| -part));
            if !length(step).is_finite() {
                return Err(NoStage::Diverged);
            }
            let mut part = 1.0;
            loop {
                let velocity = moved(here.velocity, part, step);
                *films += 1;
                let held = Held { storage: None, wall: here.film.problem.deflection() };
                match self.trial(moving(velocity), held, Neighbour::Start(&here.film)) {
                    Ok(next) if length(next.excess) < length(here.excess) => {
                        here = next;
                        break;
                    }
                    // A wall is bent step by step where it is not at once.
                    Err(reason) if part < SHORTEST || here.film.problem.deflection().is_none() => {
                        return Err(reason.into());
                    }
                    _ => part *= 0.5,
                }
                match part < SHORTEST {
                    true if balance < NEARLY_BALANCED => return Ok(self.accepted(here)?),
                    true => return Err(NoStage::Diverged),
                    false => {}
                }
            }
        }
        Err(NoStage::Diverged)
    }

    /// What is left of the equation of motion [N].
    pub(super) fn residual(&self, known: &Known, here: &Instant) -> Vector {
        let masses = self.masses();
        [0, 1, 2, 3].map(|k| here.excess[k] + masses[k] * (here.velocity[k] - known.rate[k]) * known.per_time)
    }

    fn stage_tangent(&self, known: &Known, here: &Instant) -> Result<Stiffness, NoFilm> {
        let tangent = self.tangent(here, 1.0, known.per_time)?;
        let inertia = self.masses().map(|mass| mass * known.per_time.powi(2));
        Ok(tangent.with_diagonal(inertia))
    }

    /// A start, or a place on the way to it that leaves enough of the film.
    pub(super) fn inside(&self, from: Vector, to: Vector) -> Vector {
        let gap = self.least_gap(from);
        let way: Vector = moved(to, -1.0, from);
        let mut part = 1.0;
        while self.least_gap(moved(from, part, way)) < LEAST_SHRINK * gap {
            part *= 0.8;
        }
        moved(from, part, way)
    }
}

impl Known {
    /// The rate of a journal at these coordinates.
    pub(super) fn velocity(&self, at: Vector) -> Vector {
        moved(at, -1.0, self.offset).map(|way| way * self.per_time)
    }
}
