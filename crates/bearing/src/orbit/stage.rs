//! One implicit stage: the offset at which film, support and mass carry the load of its time.
//!
//! With `v = (x - x_0)/(gamma dt)` the residual is `W(x, v) + m (v - v_0)/(gamma dt) - F`, its tangent
//! `K + C/(gamma dt) + m/(gamma dt)^2`.

use std::sync::Arc;

use oilwedge_fem::Error;
use oilwedge_fem::newton::Failure;
use oilwedge_reynolds::film_thickness::{Deflection, WallStage};
use oilwedge_reynolds::solve::Neighbour;
use oilwedge_reynolds::{FilmProblem, MixedChange, NoFilm};

use super::motion::{Held, Instant, Motion, Moving, TiltSupport};
use super::oil::Before;
use crate::coordinates::{Vector, length, moved};
use crate::coupled::FilmSolve;
use crate::deflection::{CLOSED, Moves};
use crate::duty_cycle::Duty;
use crate::load::{Load, Tilting};
use crate::newton::{Damping, Goal};
use crate::search::Search;
use crate::time_terms::TimeTerms;

/// Most films of the search for a velocity at a given place.
const MOST_FILMS: usize = 30;
/// No iteration leaves less than this part of the least gap.
const LEAST_SHRINK: f64 = 0.4;
/// Shortest part of a step that is tried in the search for a velocity, and of the way to the start of a stage.
const SHORTEST: f64 = 1e-3;
/// A stage is solved where the residual over the load is below this part of the tolerance.
const BALANCED: f64 = 1e-3;
/// A stage is solved where the next step over the least gap is below this part of the tolerance.
const SETTLED: f64 = 3e-2;
/// Least residual over the load that a stage is solved to: round-off.
const ROUND_OFF: f64 = 1e-11;
/// Residual over the load below which a stage is solved where no step brings it down.
const NEARLY_BALANCED: f64 = 1e-8;

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

impl From<Error> for NoStage {
    fn from(reason: Error) -> Self {
        Self::Film(Failure::from(reason).into())
    }
}

impl From<NoFilm> for NoStage {
    fn from(reason: NoFilm) -> Self {
        Self::Film(reason)
    }
}

impl Motion<'_> {
    /// Solves a stage from a `start` and a film nearby by the one Newton's method ([`crate::newton`]), in which place,
    /// wall and film move as the stage has it; `films` counts those solved.
    pub(super) fn stage(
        &self,
        known: &Known,
        start: Vector,
        near: &Instant,
        accuracy: Accuracy,
        films: &mut usize,
    ) -> Result<Instant, NoStage> {
        let search = self.search(known, accuracy);
        let (at, wall) = self.begun(known, near, start);
        let moving = Moving { time: known.time, at, velocity: known.velocity(at) };
        let storage = known.before.as_ref().map(|before| &before.storage);
        let problem = self.problem_of(moving, Held { storage, wall: wall.as_ref() });
        *films += 1;
        let first = search.open(&problem, at, FilmSolve::Settled(Neighbour::Start(&near.film)), CLOSED)?;
        let goal = Goal {
            balanced: accuracy.balanced(),
            closed: accuracy.balanced(),
            moved: SETTLED * accuracy.tolerance,
            rounding: NEARLY_BALANCED,
        };
        let found = search.newton(first, goal, Damping::None, films).map_err(|_| NoStage::Diverged)?;
        let at = search.coordinates.at(&found.film.problem.journal);
        let moving = Moving { at, velocity: known.velocity(at), ..moving };
        let instant = self.instant(moving, found.film, &found.carried);
        self.found(known, instant)
    }

    /// The search for the place in a stage.
    fn search(&self, known: &Known, accuracy: Accuracy) -> Search<'_> {
        let Duty { force, moment, .. } = self.duty(known.time);
        let tilting = |support: TiltSupport| Tilting { moment, stiffness: support.stiffness, support: support.slope };
        let load = Load { force, tilting: self.support.map(tilting) };
        let stage =
            TimeTerms { per_time: known.per_time, offset: known.offset, rate: known.rate, masses: self.masses() };
        Search::in_stage(self.problem, (self.system, self.gap.clone()), (load, accuracy.scale), stage)
    }

    /// Where a stage begins from a film nearby: at a start and under the wall expected there, or on the way to both,
    /// where enough of the film is left.
    fn begun(&self, known: &Known, near: &Instant, start: Vector) -> (Vector, Option<Deflection>) {
        let expected = known.wall_from(near);
        let here = near.wall();
        let apart = expected.iter().zip(here).flat_map(|(there, here)| {
            (there.coefficients.iter().zip(&*here.coefficients)).map(|(there, here)| there - here)
        });
        let moves = Moves {
            place: moved(start, -1.0, near.at),
            wall: apart.collect(),
            contact: Vec::new(),
            film: MixedChange::default(),
        };
        let made = |part: f64| {
            let (at, bent) = (moved(near.at, part, moves.place), here.map(|here| moves.made(near.at, here, part).1));
            let wall = expected.as_ref().zip(bent).map(|(there, bent)| there.with(bent.coefficients.to_vec()));
            (at, wall)
        };
        let gap = self.least_gap_under(here, near.at);
        let mut part = 1.0;
        loop {
            let (at, wall) = made(part);
            if part < SHORTEST || self.least_gap_under(wall.as_ref(), at) >= LEAST_SHRINK * gap {
                return (at, wall);
            }
            part *= 0.8;
        }
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
}

impl Known {
    /// The rate of a journal at these coordinates.
    pub(super) fn velocity(&self, at: Vector) -> Vector {
        moved(at, -1.0, self.offset).map(|way| way * self.per_time)
    }

    /// The wall with which the stage begins: where it is expected, or that of a film nearby; none where it is rigid.
    fn wall_from(&self, near: &Instant) -> Option<Deflection> {
        let deflection = near.film.problem.deflection()?;
        Some(match &self.wall {
            Some((stage, expected)) => deflection.with(expected.clone()).in_stage(stage.clone()),
            None => deflection.clone(),
        })
    }
}
