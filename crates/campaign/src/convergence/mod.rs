//! A convergence study: a scene solved on ever finer meshes by three strategies, for what accuracy costs.
//!
//! Reading order: [`strategy`], `first_mesh.rs`, `study_run.rs` (one strategy from level to level, by
//! [`oilwedge_study::level`]), [`budget`] (when to stop), `reference.rs` (errors against the finest answer),
//! [`cost_model`] (what the next digit costs), [`report`].

pub mod budget;
pub mod cost_model;
mod first_mesh;
pub mod observer;
mod reference;
pub mod report;
pub mod strategy;
mod study_run;

pub use budget::Budget;
pub use cost_model::{AccuracyMeasure, Price};
pub use observer::Observer;
pub use report::{ConvergenceReport, LevelReport, StrategyLevels, TIME_PARTS};
pub use strategy::Strategy;
pub use study_run::MarkedMesh;

use cost_model::{CostModel, LevelCost, price_list, with_errors};
use report::{CONVERGE_FORMAT, GoalFacts};
use study_run::StudyRun;

use crate::Error;
use oilwedge_scene::Scene;
use oilwedge_study::compile::compile;
use oilwedge_study::effects::Sockets;
use oilwedge_study::no_answer::NoAnswer;
use oilwedge_study::oil::Oil;
use oilwedge_study::quantities::main_quantity;
use oilwedge_study::result::{ResultHead, Status};
use oilwedge_study::scope::Scope;

/// A goal below this part of its reference value is zero to round-off.
const ZERO: f64 = 1e-9;

/// What a study found.
#[derive(Debug, Clone)]
pub struct Convergence {
    /// The numbers; `status` says whether there are any.
    pub report: ConvergenceReport,
    /// The adaptive mesh that is drawn.
    pub mesh: Option<MarkedMesh>,
}

/// Solves a scene by all strategies on ever finer meshes, the quickest next level first, as long as `budget` allows.
/// That there is no film is a result, with its reason.
///
/// # Errors
/// The mesh cannot be read or does not fit the scene, the goal is zero ([`Error::NothingToConverge`]), or the scene has
/// an orbit ([`Error::Orbit`]).
pub fn converge(scene: &Scene, budget: &Budget, observer: &mut dyn Observer) -> Result<Convergence, Error> {
    if scene.orbit.is_some() {
        return Err(Error::Orbit);
    }
    let goal = main_quantity(&Scope::of(scene)).name;
    let report = blank(scene, budget, goal);
    let model = compile(scene)?;
    let first = match first_mesh::first_mesh(&model, budget.deadline(true))? {
        Ok(first) => first,
        Err(reason) => return Ok(unanswered(report, &reason, budget)),
    };
    let begin = |strategy: Strategy| StudyRun::new(&model, &first, strategy, goal);
    // Both strategies of quadratic elements begin on the same mesh.
    let mut uniform = begin(Strategy::P2Uniform);
    uniform.step(budget, observer)?;
    let linear = begin(Strategy::P1Uniform).no_longer_than(&uniform);
    let adaptive = uniform.turned(Strategy::P2Adaptive);
    let mut runs = [linear, uniform, adaptive];
    let next = |runs: &[StudyRun]| {
        let open = runs.iter().enumerate().filter(|(_, run)| run.ended.is_none());
        open.min_by(|(_, a), (_, b)| a.urgency().total_cmp(&b.urgency())).map(|(place, _)| place)
    };
    while let Some(place) = next(&runs) {
        runs[place].step(budget, observer)?;
    }
    finish(report, runs, scene, budget)
}

/// A report without any levels.
fn blank(scene: &Scene, budget: &Budget, goal: &str) -> ConvergenceReport {
    ConvergenceReport {
        head: ResultHead::of(CONVERGE_FORMAT, [&scene.title, &scene.text, &scene.sha256]),
        goal: GoalFacts { name: goal.to_owned(), ..GoalFacts::default() },
        max_seconds: budget.max_seconds(),
        ..ConvergenceReport::default()
    }
}

/// The study of a scene that has no answer on any mesh.
fn unanswered(mut report: ConvergenceReport, reason: &NoAnswer, budget: &Budget) -> Convergence {
    report.head.end(Status::without(reason), reason);
    report.seconds = budget.spent();
    Convergence { report, mesh: None }
}

/// Errors, costs and facts of the levels.
fn finish(
    mut report: ConvergenceReport,
    mut runs: [StudyRun; 3],
    scene: &Scene,
    budget: &Budget,
) -> Result<Convergence, Error> {
    // Quadratic elements come last, and are what a run solves with.
    let Some(finest) = runs.iter().rev().find(|run| !run.levels.is_empty()) else {
        return Ok(match runs.iter_mut().rev().find_map(|run| run.failure.take()) {
            Some(reason) => unanswered(report, &reason, budget),
            None => {
                report.head.status = Status::NotConverged;
                report.head.reason = runs.into_iter().rev().find_map(|run| run.ended);
                Convergence { report, mesh: None }
            }
        });
    };
    report.effects = finest.effects.clone().unwrap_or_default();
    if let Some(quantity) = &finest.quantity {
        quantity.row.symbol.clone_into(&mut report.goal.symbol);
        quantity.unit().clone_into(&mut report.goal.unit);
        let scale = match scene.journal.load() {
            Some(_) => 1.0,
            None => reference_load(scene),
        };
        if quantity.value.abs() <= ZERO * scale {
            let goal = quantity.name.to_string();
            return Err(Error::NothingToConverge { goal });
        }
    }
    let adaptive = runs.iter_mut().find(|run| run.strategy == Strategy::P2Adaptive);
    let mesh = adaptive.and_then(|run| run.drawn.take());
    let course = |run: StudyRun| StrategyLevels {
        strategy: run.strategy,
        order: run.strategy.order(run.model),
        time_exponent: None,
        levels: run.levels,
        ended: run.ended.unwrap_or_default(),
    };
    report.strategies = runs.into_iter().map(course).collect();
    evaluate(&mut report);
    report.seconds = budget.spent();
    Ok(Convergence { report, mesh })
}

/// Errors against the finest answer, and what each accuracy costs.
fn evaluate(report: &mut ConvergenceReport) {
    report.reference = reference::finest(&report.strategies);
    let Some(finest) = &report.reference else { return };
    reference::measure(&mut report.strategies, finest);
    for measure in [AccuracyMeasure::Bar, AccuracyMeasure::Error] {
        let courses = report.strategies.iter();
        let models: Vec<CostModel> = courses.map(|course| cost_model(course, finest, measure)).collect();
        let prices = price_list(&models, measure);
        report.prices = match measure {
            AccuracyMeasure::Bar => prices,
            AccuracyMeasure::Error => with_errors(&report.prices, prices),
        };
        // The model by error bars is reported for a strategy, where it has bars.
        for (course, model) in report.strategies.iter_mut().zip(&models) {
            if course.time_exponent.is_none() && !model.levels.is_empty() {
                course.order = model.order();
                course.time_exponent = Some(model.exponent());
            }
        }
    }
    if finest.uncertainty.is_none() {
        let note = "errors are not known: the finest answer has no coarser one beside it; allow the study more time";
        report.notes.push(note.to_owned());
    }
}

/// The load [N] that drag, a moving centre and given pressures would produce on the whole projected area.
fn reference_load(scene: &Scene) -> f64 {
    let (bearing, journal) = (&scene.bearing, &scene.journal);
    let centre = Sockets::of(scene).centre_velocity;
    let motion = centre.radial.hypot(centre.tangential) / bearing.clearance;
    let dragged =
        Oil::of(scene).viscosity * (journal.speed.abs() + motion) * (bearing.radius() / bearing.clearance).powi(2);
    let given = scene.feeds.iter().filter_map(|feed| feed.pressure);
    let given = given.chain(scene.cavitation.map(|cavitation| cavitation.pressure));
    let driven = given.map(|pressure| (pressure - scene.ends.pressure).abs());
    driven.fold(dragged, f64::max) * bearing.diameter * bearing.length
}

/// Cost and error of the levels of a strategy whose error is known by that measure.
fn cost_model(course: &StrategyLevels, reference: &report::Reference, measure: AccuracyMeasure) -> CostModel {
    let level_cost = |level: &LevelReport| {
        Some(LevelCost {
            unknowns: level.unknowns as f64,
            seconds: level.seconds.total,
            error: level.error(measure, reference)?,
        })
    };
    CostModel {
        strategy: course.strategy,
        order: course.order,
        levels: course.levels.iter().filter_map(level_cost).collect(),
    }
}
