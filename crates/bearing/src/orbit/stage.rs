//! One implicit stage: the offsets at which films, supports, masses and the shaft carry the loads of its time.
//!
//! With `v = (x - x_0)/(gamma dt)` the residual is `W(x, v) + m (v - v_0)/(gamma dt) - F`, its tangent
//! `K + C/(gamma dt) + m/(gamma dt)^2`.

use std::sync::Arc;

use oilwedge_fem::newton::NewtonFailure;
use oilwedge_reynolds::film_thickness::{Deflection, WallStage};
use oilwedge_reynolds::solve::Neighbour;
use oilwedge_reynolds::{FilmProblem, NoFilm};
use rayon::prelude::*;

use super::journals::Journals;
use super::motion::{Held, Instant, Motion, Moving, TiltSupport};
use super::oil::Before;
use super::path::PathStep;
use crate::coordinates::{Vector, moved};
use crate::coupled::FilmSolve;
use crate::deflection::{CLOSED, Moves};
use crate::duty_cycle::Duty;
use crate::load::{JournalLoad, Tilting};
use crate::newton::{BalanceTolerance, Damping};
use crate::search::{Search, Trial};
use crate::time_terms::TimeTerms;
use crate::together::Coupled;

/// A stage begins where this part of each least gap is left.
const LEAST_SHRINK: f64 = 0.4;
/// Shortest part of the way to the start of a stage.
const SHORTEST: f64 = 1e-3;
/// A stage is solved where the residual over the load is below this part of the tolerance.
const BALANCED: f64 = 1e-3;
/// A stage is solved where the next step over the least gap is below this part of the tolerance.
const SETTLED: f64 = 3e-2;
/// Least residual over the load that a stage is solved to: round-off.
const ROUND_OFF: f64 = 1e-11;
/// Residual over the load below which a stage is solved where no step brings it down.
const NEARLY_BALANCED: f64 = 1e-8;

/// The short time in which a motion begins, of the cycle.
const BEGINNING: f64 = 1e-7;

/// A stage before it is solved.
#[derive(Debug, Clone)]
pub(super) struct Stage {
    /// Time of the stage [s].
    pub(super) time: f64,
    /// `1/(gamma dt)` [1/s].
    pub(super) per_time: f64,
    /// What is known of each journal.
    pub(super) journals: Vec<StageHistory>,
}

/// What the stages before leave to a journal.
#[derive(Debug, Clone)]
pub(super) struct StageHistory {
    /// `x_0` and `v_0`: offsets [m] and, for a rotor with mass, rates [m/s] from the stages before.
    pub(super) offset: Vector,
    pub(super) rate: Vector,
    /// What they leave to a film that conserves its oil.
    pub(super) before: Option<Before>,
    /// What they leave to a wall that gives way, and where it is to be expected; none of a wall that has no memory.
    pub(super) wall: Option<(WallStage, Vec<f64>)>,
}

/// How exactly a stage is solved.
#[derive(Debug, Clone, Copy)]
pub(super) struct StageTolerance {
    /// Tolerance of the orbit [1].
    pub(super) tolerance: f64,
    /// Residuals are relative to this force [N].
    pub(super) scale: f64,
    /// Greatest residual over that force [1].
    pub(super) balanced: f64,
}

impl StageTolerance {
    /// Accuracy of the stages of an orbit of this tolerance [1].
    pub(super) fn of(tolerance: f64, scale: f64) -> Self {
        Self { tolerance, scale, balanced: (BALANCED * tolerance).max(ROUND_OFF) }
    }
}

/// Why a stage has no solution.
#[derive(Debug)]
pub(super) enum NoStage {
    /// There is no film for a journal, by its number.
    Film(usize, NoFilm),
    /// The iteration does not converge.
    Diverged,
}

impl Stage {
    /// A motion that begins at a time [s] in places [m], which takes a part of the cycle that is short beside all
    /// steps.
    fn beginning(time: f64, duration: f64, at: &[Vector]) -> Self {
        let known = |&offset: &Vector| StageHistory { offset, rate: [0.0; 4], before: None, wall: None };
        Self { time, per_time: 1.0 / (BEGINNING * duration), journals: at.iter().map(known).collect() }
    }

    /// The rate of a journal at these coordinates.
    pub(super) fn velocity(&self, number: usize, at: Vector) -> Vector {
        moved(at, -1.0, self.journals[number].offset).map(|way| way * self.per_time)
    }
}

/// A result of journal `number`.
pub(super) fn of_journal<T>(number: usize, result: Result<T, NoFilm>) -> Result<T, NoStage> {
    result.map_err(|reason| NoStage::Film(number, reason))
}

impl Journals<'_> {
    /// Solves a stage from `starts` and films nearby by the one Newton's method ([`crate::newton`]), in which places,
    /// walls and films move as the stage has it; `films` counts those solved.
    pub(super) fn stage(
        &self,
        stage: &Stage,
        starts: &[Vector],
        (near, damping): (&[Instant], Damping),
        accuracy: StageTolerance,
        films: &mut usize,
    ) -> Result<Vec<Instant>, NoStage> {
        let searches = self.searches(stage, accuracy);
        let begun = self.begun(stage, near, starts);
        let numbers = 0..self.motions.len();
        let open = |number: usize| {
            let (motion, search, (at, wall)) = (&self.motions[number], &searches[number], &begun[number]);
            let moving = Moving { time: stage.time, at: *at, velocity: stage.velocity(number, *at) };
            let storage = stage.journals[number].before.as_ref().map(|before| &before.storage);
            let problem = motion.problem_of(moving, Held { storage, wall: wall.as_ref() });
            let near = FilmSolve::Settled(Neighbour::Start(&near[number].film));
            of_journal(number, search.open(&problem, *at, near, CLOSED))
        };
        *films += searches.len();
        let first: Vec<Trial> = numbers.clone().into_par_iter().map(open).collect::<Result<_, NoStage>>()?;
        let StageTolerance { balanced, .. } = accuracy;
        let moved = SETTLED * accuracy.tolerance;
        let goal = BalanceTolerance { balanced, closed: balanced, moved, rounding: NEARLY_BALANCED };
        let shaft = self.shaft.as_ref().map(|drive| drive.balance(stage.time));
        let coupled = Coupled { searches: &searches, shaft: shaft.as_ref() };
        let (found, end) = coupled.newton(first, goal, damping, films);
        if end.is_some() {
            return Err(NoStage::Diverged);
        }
        let ended = |(number, found): (usize, Trial)| self.ended(stage, number, &searches[number], found);
        numbers.zip(found).map(ended).collect()
    }

    /// The end of a stage for one journal, with the oil that its film holds.
    fn ended(&self, stage: &Stage, number: usize, search: &Search, found: Trial) -> Result<Instant, NoStage> {
        let motion = &self.motions[number];
        let at = search.place(&found);
        let moving = Moving { time: stage.time, at, velocity: stage.velocity(number, at) };
        let here = motion.accepted(motion.instant(moving, found.film, &found.carried));
        let known = &stage.journals[number];
        of_journal(number, here.and_then(|here| known.with_oil(here)))
    }

    /// The searches for the places in a stage.
    pub(super) fn searches(&self, stage: &Stage, accuracy: StageTolerance) -> Vec<Search<'_>> {
        let motions = self.motions.iter().zip(&stage.journals);
        motions.map(|(motion, known)| motion.search(known, (stage.time, stage.per_time), accuracy.scale)).collect()
    }

    /// Where a stage begins from films nearby: at starts and under the walls expected there, or on the way to both,
    /// where enough of each film is left.
    fn begun(&self, stage: &Stage, near: &[Instant], starts: &[Vector]) -> Vec<(Vector, Option<Deflection>)> {
        let ways: Vec<(Option<Deflection>, Moves, f64)> = (self.motions.iter().zip(near).enumerate())
            .map(|(number, (motion, near))| {
                let expected = stage.journals[number].wall_from(near);
                let here = near.wall();
                let apart = expected.iter().zip(here).flat_map(|(there, here)| {
                    (there.coefficients.iter().zip(&*here.coefficients)).map(|(there, here)| there - here)
                });
                let place = moved(starts[number], -1.0, near.at);
                let moves = Moves { place, wall: apart.collect(), ..Moves::default() };
                (expected, moves, motion.least_gap_under(here, near.at))
            })
            .collect();
        let made = |number: usize, part: f64| {
            let ((expected, moves, _), near) = (&ways[number], &near[number]);
            let bent = near.wall().map(|here| moves.made(near.at, here, part).1);
            let wall = expected.as_ref().zip(bent).map(|(there, bent)| there.with(bent.coefficients.to_vec()));
            (moved(near.at, part, moves.place), wall)
        };
        let leaves_enough = |number: usize, part: f64| {
            let (at, wall) = made(number, part);
            self.motions[number].least_gap_under(wall.as_ref(), at) >= LEAST_SHRINK * ways[number].2
        };
        let numbers = 0..self.motions.len();
        let mut part = 1.0;
        while part >= SHORTEST && !numbers.clone().all(|number| leaves_enough(number, part)) {
            part *= 0.8;
        }
        numbers.map(|number| made(number, part)).collect()
    }

    /// Where a motion begins: at the velocities in which films, supports and shaft carry the loads, found as a stage of
    /// a short time. Films that conserve their oil are full then; walls are bent as films without memory bend them.
    pub(super) fn beginning(
        &self,
        at: &[Vector],
        accuracy: StageTolerance,
        films: &mut usize,
    ) -> Result<Vec<Instant>, NoStage> {
        let massless: Vec<Motion> = self.motions.iter().map(|motion| Motion { mass: 0.0, ..motion.clone() }).collect();
        let journals = Journals { motions: &massless, shaft: self.shaft };
        let stage = Stage::beginning(0.0, self.duration(), at);
        let conserves = |motion: &Motion| motion.problem.cavitation.conserves_oil();
        if !massless.iter().any(conserves) {
            return journals.begun_at(&stage, None, accuracy, films);
        }
        let is_wall_bent = massless.iter().any(|motion| motion.problem.deflection().is_some());
        let without_memory = match is_wall_bent {
            false => None,
            true => {
                let guide = |motion: &Motion| FilmProblem {
                    cavitation: motion.problem.cavitation.guide().unwrap_or(motion.problem.cavitation),
                    ..motion.problem.clone()
                };
                let problems: Vec<FilmProblem> = massless.iter().map(guide).collect();
                let motions = massless.iter().zip(&problems);
                let motions: Vec<Motion> =
                    motions.map(|(motion, problem)| Motion { problem, ..motion.clone() }).collect();
                let journals = Journals { motions: &motions, shaft: self.shaft };
                Some(journals.begun_at(&stage, None, accuracy, films)?)
            }
        };
        journals.begun_at(&stage, without_memory.as_deref(), accuracy, films)
    }

    /// Where a motion is led on from steps of another one, whose law may be another: a stage of a short time, in which
    /// films that conserve their oil, their walls, and masses keep what they have.
    pub(super) fn beginning_after(
        &self,
        steps: &[PathStep],
        accuracy: StageTolerance,
        films: &mut usize,
    ) -> Result<Vec<Instant>, NoStage> {
        let places: Vec<Vector> = steps.iter().map(|step| step.at).collect();
        let mut stage = Stage::beginning(0.0, self.duration(), &places);
        let (mut near, mut starts) = (Vec::new(), Vec::new());
        for (number, (motion, step)) in self.motions.iter().zip(steps).enumerate() {
            let known = &mut stage.journals[number];
            known.rate = step.velocity;
            let begin = match &step.history {
                // A wall without oil that is kept follows its film at once.
                None => {
                    let kept = |wall: &Deflection| Deflection::none(wall.wall.clone()).with(wall.coefficients.to_vec());
                    let wall = step.wall.as_ref().map(kept);
                    let held = Held { storage: None, wall: wall.as_ref() };
                    motion.trial(Moving { time: 0.0, ..step.moving() }, held, Neighbour::None)
                }
                Some(history) => {
                    known.before = Some(history.oil.at_rest(stage.per_time));
                    let resting = |wall: &Deflection| (wall.resting(stage.per_time), wall.coefficients.to_vec());
                    known.wall = step.wall.as_ref().map(resting);
                    motion.film_at(step, Neighbour::None)
                }
            };
            near.push(of_journal(number, begin)?);
            starts.push(moved(step.at, 1.0 / stage.per_time, step.velocity));
        }
        *films += near.len();
        self.stage(&stage, &starts, (&near, Damping::PseudoTime), accuracy, films)
    }

    /// The end of the stage with which a motion begins: in films without memory or, where their films are known, in
    /// those that conserve their oil.
    fn begun_at(
        &self,
        stage: &Stage,
        without_memory: Option<&[Instant]>,
        accuracy: StageTolerance,
        films: &mut usize,
    ) -> Result<Vec<Instant>, NoStage> {
        let (mut stage, mut near, mut starts) = (stage.clone(), Vec::new(), Vec::new());
        for (number, motion) in self.motions.iter().enumerate() {
            let known = &mut stage.journals[number];
            let begin = without_memory.map(|films| &films[number]);
            let velocity = begin.map_or([0.0; 4], |begin| begin.velocity);
            let moving = Moving { time: stage.time, at: known.offset, velocity };
            let wall = begin.and_then(Instant::wall);
            if motion.problem.cavitation.conserves_oil() {
                let journal = motion.journal(moving.time, moving.at, velocity);
                let full = FilmProblem { journal, ..motion.problem.clone() }.deflected(wall);
                let oil = full.oil_of_full_film(motion.system).map_err(NewtonFailure::from).map_err(NoFilm::from);
                known.before = Some(Before::at_rest(stage.per_time, of_journal(number, oil)?));
            }
            known.wall = wall.map(|wall| (wall.resting(stage.per_time), wall.coefficients.to_vec()));
            let held = Held { storage: known.before.as_ref().map(|before| &before.storage), wall };
            near.push(of_journal(number, motion.trial(moving, held, Neighbour::None))?);
            starts.push(moved(known.offset, 1.0 / stage.per_time, velocity));
        }
        *films += near.len();
        self.stage(&stage, &starts, (&near, Damping::PseudoTime), accuracy, films)
    }

    /// The journals at given places [m], at the velocities in which films, supports and shaft carry the loads, sought
    /// from a guess [m/s].
    pub(super) fn carried(
        &self,
        (time, at): (f64, &[Vector]),
        guess: &[Vector],
        accuracy: StageTolerance,
    ) -> Result<Vec<Instant>, NoStage> {
        let mut stage = Stage::beginning(time, self.duration(), at);
        let massless: Vec<Motion> = self.motions.iter().map(|motion| Motion { mass: 0.0, ..motion.clone() }).collect();
        let near = |number: usize| {
            let moving = Moving { time, at: at[number], velocity: guess[number] };
            of_journal(number, massless[number].trial(moving, Held::default(), Neighbour::None))
        };
        let near = (0..massless.len()).map(near).collect::<Result<Vec<Instant>, NoStage>>()?;
        for (known, guess) in stage.journals.iter_mut().zip(guess) {
            known.offset = moved(known.offset, -1.0 / stage.per_time, *guess);
        }
        let journals = Journals { motions: &massless, shaft: self.shaft };
        journals.stage(&stage, at, (&near, Damping::PseudoTime), accuracy, &mut 0)
    }
}

impl Motion<'_> {
    /// The search for the place in a stage, at this time [s] and of this `1/(gamma dt)` [1/s]; residuals are relative
    /// to the force `scale` [N].
    fn search(&self, known: &StageHistory, (time, per_time): (f64, f64), scale: f64) -> Search<'_> {
        let Duty { force, moment, .. } = self.duty(time);
        let tilting = |support: TiltSupport| Tilting { moment, stiffness: support.stiffness, support: support.slope };
        let load = JournalLoad { force, tilting: self.support.map(tilting) };
        let terms = TimeTerms { per_time, offset: known.offset, rate: known.rate, masses: self.masses() };
        Search::in_stage(self.problem, (self.system, self.gap.clone()), (load, scale), terms)
    }
}

impl StageHistory {
    /// An instant with the oil that its film holds at the end of the stage.
    pub(super) fn with_oil(&self, here: Instant) -> Result<Instant, NoFilm> {
        let Some(before) = &self.before else {
            return Ok(here);
        };
        let oil = before.oil(&here.film).map_err(NewtonFailure::from)?;
        Ok(Instant { oil: Some(Arc::new(oil)), ..here })
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
