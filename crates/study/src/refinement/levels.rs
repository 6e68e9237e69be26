//! The loop from mesh to mesh.

use std::sync::Arc;

use super::distance::worst;
use super::growth::{Goal, Growth, next_seconds};
use super::level::SolvedLevel;
use super::next::{FIRST_UNKNOWNS, NextMesh};
use super::{Answer, Tell, ended, solved};
use crate::compile_error::CompileError;
use crate::estimate::Estimated;
use crate::film::{Film, Start};
use crate::grading::Graded;
use crate::model::Model;
use crate::no_answer::NoAnswer;
use crate::observer::{Reached, Watch};
use crate::quantities::Quantity;
use crate::reasons::{Cause, Distance, Limit};
use crate::result::{LevelFacts, Refinement};
use crate::run_options::RunOptions;
use crate::solved::{Errors, Solved};
use crate::targets::Targets;
use oilwedge_bearing::Moment;
use oilwedge_scene::Target;

/// A film that begins within these seconds [s] is solved whatever the limit is.
const MOMENT: f64 = 1.0;
/// Most meshes.
const MOST_LEVELS: usize = 30;
/// Most unknowns of a mesh over those of the one before.
const MOST_GROWTH: f64 = 16.0;
/// Most meshes for bars that are wanted but not required.
const MOST_WANTED_LEVELS: usize = 2;
/// Most unknowns of a mesh for such bars.
const MOST_WANTED_UNKNOWNS: usize = 40_000;
/// Most unknowns of such a mesh where position and tilt of a film that conserves oil are found: each position takes
/// long.
const MOST_WANTED_EXPENSIVE: usize = 20_000;
/// Most unknowns of such a mesh with a wall that gives way, which is closed at each position.
const MOST_WANTED_ON_WALL: usize = 5_000;
/// Most unknowns of such a mesh over those of the mesh before.
const MOST_WANTED_GROWTH: f64 = 2.0;

impl SolvedLevel {
    /// The level as the answer.
    fn answer(self, levels: Vec<LevelFacts>, limit: Option<Limit>) -> Answer {
        Answer { film: self.solved.film.clone(), outcome: Ok((self.solved, self.estimated)), levels, limit }
    }
}

/// What follows a mesh.
enum RefinementStep {
    Finer(NextMesh),
    Done(Box<Answer>),
}

/// A refinement towards a tolerance.
struct Refining<'a> {
    model: &'a Arc<Model>,
    targets: &'a Targets,
    options: &'a RunOptions,
    /// Time at which the run began, by its clock.
    begun: Moment,
    watch: Watch,
    /// Is told of each mesh but the last.
    best_so_far: Option<Tell<'a>>,
    levels: Vec<LevelFacts>,
    /// Seconds of the last mesh in which the position was found that it is graded for: known from then on [s].
    grading: f64,
    /// The film of the mesh before.
    best: Option<SolvedLevel>,
    /// Meshes made for bars that are wanted but not required.
    wanted_levels: usize,
    /// True if the mesh that all others were divided from was laid anew.
    is_laid_anew: bool,
}

/// Answers a model on meshes as fine as the targets ask for.
pub(super) fn towards(
    model: &Arc<Model>,
    targets: &Targets,
    options: &RunOptions,
    best_so_far: Option<Tell>,
) -> Result<Answer, CompileError> {
    let mut refining = Refining {
        model,
        targets,
        options,
        begun: options.clock.start(),
        watch: options.watch(),
        best_so_far,
        levels: Vec::new(),
        grading: 0.0,
        best: None,
        wanted_levels: 0,
        is_laid_anew: false,
    };
    let mut next = NextMesh::first(model);
    if refining.elapsed() > f64::max(options.max_seconds, MOMENT) {
        return Err(CompileError::Late { cause: options.cause().to_string() });
    }
    loop {
        match refining.level(&next)? {
            RefinementStep::Finer(finer) => next = finer,
            RefinementStep::Done(answer) => return Ok(*answer),
        }
    }
}

impl Refining<'_> {
    /// Makes and solves one mesh.
    fn level(&mut self, next: &NextMesh) -> Result<RefinementStep, CompileError> {
        let started = self.elapsed();
        let (refinement, graded) = match next.film(self.model, self.watch) {
            Ok(made) => made,
            Err(reason) => return self.last_resort(reason.to_string()).ok_or(reason),
        };
        let Graded { mut film, refused } = graded;
        self.grading = match next.finds_position() {
            true => self.elapsed() - started,
            false => 0.0,
        };
        if film.start == Start::Failed
            && let Some(finer) = next.finer_than_failed()
        {
            return Ok(RefinementStep::Finer(finer));
        }
        self.is_laid_anew |= film.origin.is_laid_anew;
        film.origin.is_laid_anew = self.is_laid_anew;
        if let Some(observer) = self.watch.observer {
            observer.level(self.levels.len() + 1, film.unknowns());
        }
        let outcome = match refused {
            Some(reason) => Err(reason.into()),
            // A film that is begun is finished: one whose mesh has taken the time up is not.
            None if self.is_late(film.unknowns()) => Err(NoAnswer::NotBegun { unknowns: film.unknowns() }),
            None => solved(&film, Errors::Estimated, self.watch),
        };
        Ok(match outcome {
            Err(reason) => self.unanswered(next, film, reason),
            // A load balanced on the mesh before is better than one that is not balanced on this one.
            Ok((solved, estimated)) => match self.best.take_if(|_| solved.is_ended()) {
                Some(best) => {
                    let limit = self.stopped(best.worst);
                    self.done(best, Some(limit))
                }
                None => self.answered(next, (refinement, started), solved, estimated),
            },
        })
    }

    /// Whether a limit or an interrupt ends the run before the film on a mesh that is made, of so many unknowns.
    fn is_late(&self, unknowns: usize) -> bool {
        let is_over = self.elapsed() > f64::max(self.options.max_seconds, MOMENT);
        self.options.interrupt.is_asked() || is_over && unknowns > FIRST_UNKNOWNS
    }

    /// The mesh before is the answer where the next has none, if there is one.
    fn last_resort(&mut self, reason: String) -> Option<RefinementStep> {
        let best = self.best.take()?;
        Some(self.done(best, Some(Limit::NoAnswer(reason))))
    }

    fn done(&mut self, level: SolvedLevel, limit: Option<Limit>) -> RefinementStep {
        // A mesh that meets what is required was followed by others only for more.
        let limit = limit.filter(|_| level.worst > 1.0);
        self.ended(level, limit)
    }

    fn ended(&mut self, level: SolvedLevel, limit: Option<Limit>) -> RefinementStep {
        RefinementStep::Done(Box::new(level.answer(std::mem::take(&mut self.levels), limit)))
    }

    /// What follows a mesh without an answer.
    fn unanswered(&mut self, next: &NextMesh, film: Film, reason: NoAnswer) -> RefinementStep {
        let may_divide = !self.watch.deadline.is_over() && 4 * film.unknowns() <= self.options.max_unknowns;
        // A finer mesh shows whether there is a film.
        if let Some(finer) = (reason.is_near_limit() && may_divide).then(|| NextMesh::divided(&film)).flatten() {
            return RefinementStep::Finer(finer);
        }
        // The mesh before is the answer of a run that ends.
        if matches!(reason, NoAnswer::NotBegun { .. })
            && let Some(best) = self.best.take()
        {
            let limit = self.stopped(best.worst);
            return self.done(best, Some(limit));
        }
        // The numbers of the mesh before are still good.
        if reason.is_unreached()
            && let Some(step) = self.last_resort(reason.to_string())
        {
            return step;
        }
        // The first mesh is coarse; what it cannot answer one as fine as usual may.
        let finer = next
            .finer_first(&film, &reason)
            .filter(|_| !reason.is_far_beyond() && !self.is_late(film.unknowns()))
            .or_else(|| next.finer_undecided(&film, &reason).filter(|_| may_divide));
        match (finer, self.best.take()) {
            (Some(finer), None) => RefinementStep::Finer(finer),
            _ => RefinementStep::Done(Box::new(Answer {
                film,
                outcome: Err(reason),
                levels: std::mem::take(&mut self.levels),
                limit: None,
            })),
        }
    }

    /// What follows a solved mesh.
    fn answered(
        &mut self,
        next: &NextMesh,
        (refinement, started): (Refinement, f64),
        solved: Solved,
        estimated: Estimated,
    ) -> RefinementStep {
        let error = |target: &Target| {
            let mut quantities = estimated.quantities.iter();
            let quantity = quantities.find(|quantity| quantity.name == target.quantity)?;
            Some((target.quantity.clone(), quantity.error()?))
        };
        self.levels.push(LevelFacts {
            unknowns: solved.film.unknowns(),
            cells: solved.film.system.space().mesh().triangles().len(),
            refinement,
            errors: self.targets.required.iter().filter_map(error).collect(),
            seconds: self.elapsed() - started,
        });
        let (wanted, _) = worst(&solved.film, &estimated, &self.targets.wanted);
        let (worst, name) = worst(&solved.film, &estimated, &self.targets.required);
        self.tell(&estimated.quantities, worst, name);
        let by_film = if self.targets.are_usual { worst * estimated.narrowed } else { worst };
        let level = SolvedLevel { solved, estimated, worst, by_film, worst_name: name.to_owned(), wanted };
        let finer = match ended(&level.solved, self.options) {
            None if worst > 1.0 => self.finer(next, &level).map_err(Some),
            None if by_film > 1.0 => self.finer_for_film(next, &level).ok_or(None),
            None if wanted > 1.0 => self.finer_if_cheap(next, &level).ok_or(None),
            limit => Err(limit),
        };
        match (finer, self.best.take()) {
            (_, Some(before)) if before.worst <= 1.0 && worst > 1.0 => self.done(before, None),
            (Ok(finer), _) => {
                self.tell_best(&level);
                self.best = Some(level);
                RefinementStep::Finer(finer)
            }
            // A mesh that resolves less than the one before, as may happen at the edge of a cavity.
            (Err(Some(limit)), Some(before)) if before.worst < worst => {
                let limit = Limit::Before(Box::new(limit), self.distance(before.worst));
                self.done(before, Some(limit))
            }
            (Err(limit), _) => self.ended(level, limit),
        }
    }

    /// Tells what the run answers if it ends on the mesh after this level.
    fn tell_best(&self, level: &SolvedLevel) {
        let Some(best) = self.best_so_far else { return };
        let limit = (level.worst > 1.0)
            .then(|| Limit::Unfinished(self.distance(level.worst), self.elapsed(), Cause::Interrupt));
        let found = (&level.solved, level.estimated.clone());
        best(found, &self.levels, limit.as_ref());
    }

    /// Tells the observer how far the last mesh is from the tolerance.
    fn tell(&self, quantities: &[Quantity], worst: f64, name: &str) {
        let (Some(observer), Some(last)) = (self.watch.observer, self.levels.last()) else {
            return;
        };
        let Some(quantity) = quantities.iter().find(|quantity| quantity.name == name) else {
            return;
        };
        let error = quantity.error().filter(|_| worst.is_finite());
        observer.reached(&Reached {
            level: self.levels.len(),
            unknowns: last.unknowns,
            quantity: name.to_owned(),
            unit: quantity.row.unit,
            error,
            asked: error.map(|error| error / worst),
            seconds: last.seconds,
        });
    }

    /// The mesh after that of a level, or why there must be none.
    fn finer(&self, last: &NextMesh, level: &SolvedLevel) -> Result<NextMesh, Limit> {
        let goal = Goal { worst: level.worst, most_unknowns: self.options.max_unknowns, most_growth: MOST_GROWTH };
        self.finer_for(&goal, last, level)
    }

    /// The mesh after that of a level which has what is required by its hill alone, if there may be one.
    fn finer_for_film(&self, last: &NextMesh, level: &SolvedLevel) -> Option<NextMesh> {
        let goal = Goal { worst: level.by_film, most_unknowns: self.options.max_unknowns, most_growth: MOST_GROWTH };
        self.finer_for(&goal, last, level).ok()
    }

    /// The mesh after that of a level which has what is required, for what is wanted beside it; none where that is
    /// expensive.
    fn finer_if_cheap(&mut self, last: &NextMesh, level: &SolvedLevel) -> Option<NextMesh> {
        self.wanted_levels += 1;
        let film = &level.solved.film;
        let most_unknowns = match film.load() {
            Some(_) if film.problem.deflection().is_some() => MOST_WANTED_ON_WALL,
            Some(load) if film.problem.cavitation.conserves_oil() && load.tilting.is_some() => MOST_WANTED_EXPENSIVE,
            _ => MOST_WANTED_UNKNOWNS,
        };
        let goal = Goal {
            worst: level.wanted,
            most_unknowns: self.options.max_unknowns.min(most_unknowns),
            most_growth: MOST_WANTED_GROWTH,
        };
        let is_allowed = self.wanted_levels <= MOST_WANTED_LEVELS;
        is_allowed.then(|| self.finer_for(&goal, last, level).ok()).flatten()
    }

    /// The mesh after that of a level for a goal, or why there must be none.
    fn finer_for(&self, goal: &Goal, last: &NextMesh, level: &SolvedLevel) -> Result<NextMesh, Limit> {
        let left = self.options.max_seconds - self.elapsed();
        let growth = Growth::of(level, goal, &self.levels, [left, self.seconds_again()]);
        let next = NextMesh::refined(last, level, &growth)?;
        let growth = next.growth(&level.solved.film).unwrap_or(growth.factor);
        self.limit(growth, goal).map_or(Ok(next), Err)
    }

    /// Seconds that the last mesh would take again [s].
    fn seconds_again(&self) -> f64 {
        self.levels.last().map_or(0.0, |last| last.seconds - self.grading)
    }

    /// Seconds of the run [s].
    fn elapsed(&self) -> f64 {
        self.begun.elapsed()
    }

    fn distance(&self, worst: f64) -> Distance {
        Distance {
            worst,
            unknowns: self.levels.last().map_or(0, |level| level.unknowns),
            is_usual: self.targets.are_usual,
        }
    }

    /// Why the mesh after the last one was not finished.
    fn stopped(&self, worst: f64) -> Limit {
        let elapsed = self.elapsed();
        Limit::Unfinished(self.distance(worst), elapsed, self.options.cause())
    }

    /// Why there must not be another mesh with so many times the unknowns, if so.
    fn limit(&self, growth: f64, goal: &Goal) -> Option<Limit> {
        let last = self.levels.last()?;
        let (distance, elapsed) = (self.distance(goal.worst), self.elapsed());
        let most = goal.most_unknowns;
        let wanted = growth * last.unknowns as f64;
        let (seconds, max_seconds) = (next_seconds(self.seconds_again(), growth), self.options.max_seconds);
        match self.options.cause() {
            Cause::Interrupt => Some(self.stopped(goal.worst)),
            // Time first: a mesh that is too large is made smaller where there is time for one (see `Growth::of`).
            cause if elapsed + seconds > max_seconds => {
                Some(Limit::Seconds { distance, seconds: [elapsed, seconds], cause })
            }
            _ if wanted > most as f64 => Some(Limit::Unknowns { distance, wanted, most }),
            _ => (self.levels.len() >= MOST_LEVELS).then_some(Limit::Meshes(distance, MOST_LEVELS)),
        }
    }
}
