//! A walk along a chain of neighbouring cases: each begins where the ones before it lead.
//!
//! What a case finds depends on its chain alone: not on the threads, nor on what was computed before the chain.

use std::sync::Arc;
use std::time::Instant;

use oilwedge_bearing::{Deadline, InitialGuess, OperatingPoint, Visited};
use oilwedge_reynolds::solve::Neighbour;
use oilwedge_reynolds::{FilmSolution, JournalState};

use oilwedge_scene::{Scene, ShaftScene};
use oilwedge_study::analysis::solve;
use oilwedge_study::compile::compile;
use oilwedge_study::compile_error::CompileError;
use oilwedge_study::estimate::{Estimated, estimate_errors};
use oilwedge_study::film::Film;
use oilwedge_study::grading::{graded, is_near};
use oilwedge_study::limits::design_criteria;
use oilwedge_study::model::Model;
use oilwedge_study::no_answer::NoAnswer;
use oilwedge_study::position::Position;
use oilwedge_study::quantities::Quantity;
use oilwedge_study::reasons::Limit;
use oilwedge_study::refinement::{answer, ended};
use oilwedge_study::result::{Criterion, RunResult, Status};
use oilwedge_study::run::run_telling;
use oilwedge_study::run_options::RunOptions;
use oilwedge_study::shaft::{BearingReport, ShaftResult, run_shaft};
use oilwedge_study::solved::{SolveOptions, Solved};
use oilwedge_study::warning::Warning;
use oilwedge_study::warnings::all_warnings;

/// Moves by less than this part of the least film thickness start from the film before.
const SHORT_MOVE: f64 = 0.2;

/// How a case ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CaseStatus {
    /// The status at the end of a run.
    Run(Status),
    /// The scene of the case does not fit its mesh, or cannot be meshed.
    BadScene,
}

/// What a case gives.
#[derive(Debug, Clone)]
pub struct CaseOutcome {
    /// How it ended.
    pub status: CaseStatus,
    /// Why it ended without an answer, or short of its tolerance.
    pub reason: Option<String>,
    /// Quantities of the case; none without a film.
    pub quantities: Vec<Quantity>,
    /// Warnings beside its numbers.
    pub warnings: Vec<Warning>,
    /// What it is judged by.
    pub criteria: Vec<Criterion>,
    /// Nodes whose pressure was not given, on the last mesh.
    pub unknowns: Option<usize>,
    /// Wall time [s].
    pub seconds: f64,
}

impl CaseOutcome {
    fn of((solved, estimated): (&Solved, Estimated), limit: Option<&Limit>, options: &RunOptions) -> Self {
        let model = solved.film.model.sockets.thermal.as_ref();
        let criteria = design_criteria(&solved.film, model, &estimated.quantities, options.bars);
        Self {
            status: CaseStatus::Run(match limit {
                Some(_) => Status::NotConverged,
                None => Status::Converged,
            }),
            reason: limit.map(Limit::to_string),
            warnings: all_warnings(&solved.film.model.oil, solved, &estimated, options.errors()),
            criteria,
            quantities: estimated.quantities,
            unknowns: Some(solved.film.unknowns()),
            seconds: 0.0,
        }
    }

    /// What is found of a case that is solved by itself.
    fn of_run(result: RunResult) -> Self {
        Self {
            status: CaseStatus::Run(result.head.status),
            criteria: result.criteria,
            reason: result.head.reason,
            quantities: result.quantities,
            warnings: result.tail.warnings,
            unknowns: Some(result.mesh.nodes),
            seconds: 0.0,
        }
    }

    /// What is found of each bearing of a crankshaft, in their order; where the shaft has no answer all have its
    /// reason.
    fn of_shaft(result: &ShaftResult, bearings: usize) -> Vec<Self> {
        let status = CaseStatus::Run(result.head.status);
        if result.bearings.is_empty() {
            let reason = result.head.reason.clone().unwrap_or_default();
            return vec![Self::without(status, reason, None); bearings];
        }
        let of_bearing = |bearing: &BearingReport| Self {
            status,
            reason: result.head.reason.clone(),
            quantities: bearing.quantities.clone(),
            warnings: result.warnings_of(bearing).cloned().collect(),
            criteria: bearing.criteria.clone(),
            unknowns: Some(bearing.unknowns),
            seconds: 0.0,
        };
        result.bearings.iter().map(of_bearing).collect()
    }

    fn without(status: CaseStatus, reason: String, unknowns: Option<usize>) -> Self {
        Self {
            status,
            reason: Some(reason),
            warnings: Vec::new(),
            criteria: Vec::new(),
            quantities: Vec::new(),
            unknowns,
            seconds: 0.0,
        }
    }

    fn failed(reason: &NoAnswer, unknowns: usize) -> Self {
        let status = CaseStatus::Run(Status::without(reason));
        Self::without(status, reason.to_string(), Some(unknowns))
    }
}

/// The film of the case before.
struct PreviousFilm {
    film: Film,
    /// Position for which its mesh was graded.
    graded_for: JournalState,
    /// Solution of the film, if there is one.
    solution: Option<Arc<FilmSolution>>,
}

/// Walks along chains.
pub(crate) struct Walker<'a> {
    options: &'a RunOptions,
    /// Deadline of the case that is computed.
    deadline: Deadline,
    held: Option<PreviousFilm>,
    visited: Vec<Visited>,
    /// What was found of the bearings of a crankshaft, the last one first, whose cases are still to come.
    bearings: Vec<CaseOutcome>,
}

impl<'a> Walker<'a> {
    pub(crate) fn new(options: &'a RunOptions) -> Self {
        Self { options, deadline: Deadline::default(), held: None, visited: Vec::new(), bearings: Vec::new() }
    }

    /// Forgets all that a new chain must not know: a mesh that no position has shaped may stay.
    pub(crate) fn begin(&mut self) {
        self.visited.clear();
        self.bearings.clear();
        self.held = self.held.take().filter(|held| !held.film.model.mesh.is_graded());
        if let Some(held) = &mut self.held {
            held.solution = None;
        }
    }

    /// Computes the next case of the chain; `coordinate` is its value on the axis along which the chain runs.
    pub(crate) fn case(&mut self, scene: &Scene, coordinate: f64) -> CaseOutcome {
        self.case_asked(scene, coordinate, &mut |_| ())
    }

    /// Computes the next case of the chain, and hands on its film if it is one of a mesh that the chain keeps.
    pub(crate) fn case_asked(&mut self, scene: &Scene, coordinate: f64, film: &mut dyn FnMut(&Solved)) -> CaseOutcome {
        let clock = Instant::now();
        self.deadline = self.options.deadline();
        let found = compile(scene).and_then(|model| match model.targets.is_some() && self.options.bars {
            _ if model.scope.orbit.is_some() => {
                run_telling(&model, self.options, None).map(|run| CaseOutcome::of_run(run.result))
            }
            true => self.refined(&model),
            false => self.walked(&model, coordinate, film),
        });
        let mut found =
            found.unwrap_or_else(|error| CaseOutcome::without(CaseStatus::BadScene, error.to_string(), None));
        found.seconds = clock.elapsed().as_secs_f64();
        found
    }

    /// The next bearing of a crankshaft, which is solved with its first one; each takes its share of the time.
    pub(super) fn bearing(&mut self, shaft: &ShaftScene) -> CaseOutcome {
        if let Some(found) = self.bearings.pop() {
            return found;
        }
        let clock = Instant::now();
        let bearings = shaft.crankshaft.bearings.len();
        let mut found = match run_shaft(shaft, self.options) {
            Ok(run) => CaseOutcome::of_shaft(&run.result, bearings),
            Err(error) => vec![CaseOutcome::without(CaseStatus::BadScene, error.to_string(), None); bearings],
        };
        let seconds = clock.elapsed().as_secs_f64() / bearings as f64;
        found.iter_mut().for_each(|it| it.seconds = seconds);
        found.reverse();
        let first = found.pop();
        self.bearings = found;
        first.unwrap_or_else(|| CaseOutcome::without(CaseStatus::BadScene, "the shaft has no bearing".to_owned(), None))
    }

    /// With a tolerance each case has meshes of its own, as when it is solved by itself.
    fn refined(&mut self, model: &Arc<Model>) -> Result<CaseOutcome, CompileError> {
        let answer = answer(model, self.options)?;
        let size = answer.film.unknowns();
        Ok(match answer.outcome {
            Ok((solved, estimated)) => CaseOutcome::of((&solved, estimated), answer.limit.as_ref(), self.options),
            Err(reason) => CaseOutcome::failed(&reason, size),
        })
    }

    /// Solves a case on the mesh of its chain, from the case before if there is one.
    fn walked(
        &mut self,
        model: &Arc<Model>,
        coordinate: f64,
        told: &mut dyn FnMut(&Solved),
    ) -> Result<CaseOutcome, CompileError> {
        let (graded_for, outcome) = match self.following(model, coordinate)? {
            Some((graded_for, solved)) => (graded_for, Ok(solved)),
            None => {
                let film = self.by_itself(model)?;
                let outcome = solve(&film, &self.solve_options(InitialGuess::Cold));
                (film.problem.journal, outcome.map_err(|reason| (film, reason)))
            }
        };
        let (found, film, solution) = match outcome {
            Ok(solved) => {
                let estimated = estimate_errors(&solved);
                let limit = ended(&solved, self.options);
                let found = CaseOutcome::of((&solved, estimated), limit.as_ref(), self.options);
                told(&solved);
                let Solved { film, primary, .. } = solved;
                (found, film, limit.is_none().then_some(primary.solution))
            }
            Err((film, reason)) => (CaseOutcome::failed(&reason, film.unknowns()), film, None),
        };
        match solution {
            None => self.visited.clear(),
            Some(_) => self.visited.push(film.position().visited(point(model, coordinate))),
        }
        self.held = Some(PreviousFilm { film, graded_for, solution });
        Ok(found)
    }

    fn solve_options<'b>(&self, guess: InitialGuess<'b>) -> SolveOptions<'b> {
        SolveOptions { errors: self.options.errors(), deadline: self.deadline, guess, ..SolveOptions::default() }
    }

    /// The film as the case is solved by itself; on the system at hand where that is the same and no position has
    /// shaped it.
    fn by_itself(&mut self, model: &Arc<Model>) -> Result<Film, CompileError> {
        let held = self.held.take();
        let ungraded = held.filter(|held| !model.mesh.is_graded() && held.film.model.has_same_system(model));
        let reused = ungraded.and_then(|held| held.film.reused(model, &model.start()));
        reused.map_or_else(|| graded(model, model.mesh.longest, self.deadline.into()), Ok)
    }

    /// Solves a case from the case before, if there is one and it leads to an answer; with the position for which the
    /// mesh was graded.
    fn following(
        &mut self,
        model: &Arc<Model>,
        coordinate: f64,
    ) -> Result<Option<(JournalState, Solved)>, CompileError> {
        let position = match model.scope.is_loaded {
            false => Some(Position::start(model)),
            true => Position::predicted(model, &self.visited, point(model, coordinate)),
        };
        let is_neighbour = |held: &mut PreviousFilm| held.solution.is_some() && held.film.model.has_same_system(model);
        let Some(position) = position else { return Ok(None) };
        let Some(before) = self.held.take_if(is_neighbour) else {
            return Ok(None);
        };
        let offset = relative(&before.film);
        let Some(film) = before.film.reused(model, &model.state_at(position)) else {
            return Ok(None);
        };
        let mut held = PreviousFilm {
            solution: before.solution.filter(|_| is_short(offset, relative(&film))),
            graded_for: before.graded_for,
            film,
        };
        if !suits(&held.graded_for, &held.film) {
            held = redrawn(model, position)?;
        }
        for _ in 0..2 {
            let near = held.solution.clone().map(|solution| held.film.solved_by(solution));
            let near = near.as_ref().map_or(Neighbour::None, Neighbour::Start);
            let Ok(solved) = solve(&held.film, &self.solve_options(InitialGuess::Near(near))) else {
                // A mesh that a film has not shaped is good for another start.
                self.held = Some(held);
                return Ok(None);
            };
            if suits(&held.graded_for, &solved.film) {
                return Ok(Some((held.graded_for, solved)));
            }
            held = redrawn(model, solved.film.position())?;
        }
        Ok(None)
    }
}

/// Whether the mesh of a film, graded for one position, suits its own.
fn suits(graded_for: &JournalState, film: &Film) -> bool {
    !film.model.mesh.is_graded() || is_near(&film.gap(), graded_for, &film.problem.journal)
}

/// The case on a mesh drawn for this position.
fn redrawn(model: &Arc<Model>, position: Position) -> Result<PreviousFilm, CompileError> {
    let film = model.film_near(model.mesh.longest, &model.state_at(position))?;
    Ok(PreviousFilm { graded_for: film.problem.journal, film, solution: None })
}

/// Coordinate and duty of a case, by which its position is predicted from those of its neighbours.
fn point(model: &Model, coordinate: f64) -> OperatingPoint {
    let bearing = &model.mesh.bearing;
    let [x, y] = model.sockets.load.unwrap_or_default();
    let slenderness = bearing.radius / bearing.clearance;
    let diameter = 2.0 * bearing.radius;
    let drag = model.oil.viscosity * model.scope.speed.abs() * slenderness.powi(2) * diameter * bearing.length;
    let duty = (x.hypot(y) / drag).ln();
    OperatingPoint { coordinate, duty: if duty.is_finite() { duty } else { 0.0 } }
}

/// Offset of the journal over the clearance.
fn relative(film: &Film) -> [f64; 2] {
    film.problem.journal.offset.map(|e| e / film.problem.bearing.clearance)
}

/// Whether a film is a good start after the journal has moved so far.
fn is_short(before: [f64; 2], after: [f64; 2]) -> bool {
    let gap = 1.0 - before[0].hypot(before[1]);
    (after[0] - before[0]).hypot(after[1] - before[1]) < SHORT_MOVE * gap
}
