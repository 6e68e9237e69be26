//! A convergence study: a scene solved on ever finer meshes by three strategies, for what accuracy costs.
//!
//! Reading order: [`strategy`], `first_mesh.rs`, `climb.rs` (one strategy from level to level, by [`oilwedge_study::level`]), [`budget`]
//! (when to stop), `reference.rs` (errors against the finest answer), [`price`] (what the next digit costs),
//! [`report`].

pub mod budget;
mod climb;
mod first_mesh;
pub mod observer;
pub mod price;
mod reference;
pub mod report;
pub mod strategy;

pub use budget::Budget;
pub use climb::MarkedMesh;
pub use observer::Observer;
pub use price::{Measure, Price};
pub use report::{ConvergenceReport, Course, LevelReport};
pub use strategy::Strategy;

use climb::Climb;
use price::{Bought, Offer, price_list};
use report::{CONVERGE_FORMAT, GoalFacts};

use crate::Error;
use oilwedge_scene::Scene;
use oilwedge_study::analysis::NoAnswer;
use oilwedge_study::effects::{Effects, Sockets};
use oilwedge_study::oil::Oil;
use oilwedge_study::quantities::main_quantity;
use oilwedge_study::result::Status;

/// A goal below this part of what is natural for it is rounding.
const NOTHING: f64 = 1e-9;

/// What a study found.
#[derive(Debug, Clone)]
pub struct Convergence {
    /// The numbers; the status tells whether there are any.
    pub report: ConvergenceReport,
    /// The adaptive mesh that is drawn.
    pub mesh: Option<MarkedMesh>,
}

/// Solves a scene by all strategies on ever finer meshes, the quickest next level first, as long as `budget` allows. That
/// there is no film is a result, with its reason.
///
/// # Errors
/// The mesh cannot be read or does not fit the scene, or the goal is zero: [`Error::NothingToConverge`].
pub fn converge(scene: &Scene, budget: &Budget, observer: &mut dyn Observer) -> Result<Convergence, Error> {
    let goal = main_quantity(scene).name;
    let report = blank(scene, budget, goal);
    let first = match first_mesh::first_mesh(scene, budget.deadline(true))? {
        Ok(first) => first,
        Err(reason) => return Ok(unanswered(report, &reason, budget)),
    };
    let climb = |strategy: Strategy| Climb::new(scene, &first, strategy, goal);
    // Both strategies of quadratic elements begin on the same mesh.
    let mut uniform = climb(Strategy::P2Uniform);
    uniform.step(budget, observer)?;
    let linear = climb(Strategy::P1Uniform).no_longer_than(&uniform);
    let adaptive = uniform.turned(Strategy::P2Adaptive);
    let mut climbs = [linear, uniform, adaptive];
    let next = |climbs: &[Climb]| {
        let open = climbs.iter().enumerate().filter(|(_, climb)| climb.ended.is_none());
        open.min_by(|(_, a), (_, b)| a.urgency().total_cmp(&b.urgency()))
            .map(|(place, _)| place)
    };
    while let Some(place) = next(&climbs) {
        climbs[place].step(budget, observer)?;
    }
    finish(report, climbs.into(), scene, budget)
}

/// A report without any levels.
fn blank(scene: &Scene, budget: &Budget, goal: &str) -> ConvergenceReport {
    ConvergenceReport {
        format: CONVERGE_FORMAT.to_owned(),
        title: scene.title.clone(),
        version: env!("CARGO_PKG_VERSION").to_owned(),
        scene_sha256: scene.sha256.clone(),
        status: Status::Converged,
        reason: None,
        effects: Effects::default(),
        goal: GoalFacts {
            name: goal.to_owned(),
            symbol: String::new(),
            unit: String::new(),
        },
        reference: None,
        strategies: Vec::new(),
        prices: Vec::new(),
        notes: Vec::new(),
        max_seconds: budget.max_seconds(),
        seconds: 0.0,
    }
}

/// What is told where there is no answer on any mesh.
fn unanswered(report: ConvergenceReport, reason: &NoAnswer, budget: &Budget) -> Convergence {
    Convergence {
        report: ConvergenceReport {
            status: reason.status(),
            reason: Some(reason.to_string()),
            seconds: budget.spent(),
            ..report
        },
        mesh: None,
    }
}

/// Errors, prices and facts of the levels.
fn finish(
    mut report: ConvergenceReport,
    mut climbs: Vec<Climb>,
    scene: &Scene,
    budget: &Budget,
) -> Result<Convergence, Error> {
    if climbs.iter().all(|climb| climb.levels.is_empty()) {
        // Quadratic elements come last, and are what a run solves with.
        return match climbs.iter_mut().rev().find_map(|climb| climb.failure.take()) {
            Some(reason) => Ok(unanswered(report, &reason, budget)),
            None => {
                report.status = Status::NotConverged;
                report.reason = climbs.into_iter().rev().find_map(|climb| climb.ended);
                Ok(Convergence { report, mesh: None })
            }
        };
    }
    let finest = climbs.iter().rev().find(|climb| !climb.levels.is_empty());
    if let Some(climb) = finest {
        report.effects = climb.effects.clone().unwrap_or_default();
        if let Some(quantity) = &climb.quantity {
            quantity.row.symbol.clone_into(&mut report.goal.symbol);
            quantity.unit().clone_into(&mut report.goal.unit);
            let natural = match scene.journal.load() {
                Some(_) => 1.0,
                None => natural_load(scene),
            };
            if quantity.value.abs() <= NOTHING * natural {
                return Err(Error::NothingToConverge {
                    goal: quantity.name.to_string(),
                });
            }
        }
    }
    let mesh = climbs.iter_mut().find_map(|climb| match climb.strategy {
        Strategy::P2Adaptive => climb.drawn.take(),
        _ => None,
    });
    report.strategies = (climbs.into_iter())
        .map(|climb| Course {
            strategy: climb.strategy,
            order: climb.strategy.order(scene),
            time_exponent: None,
            levels: climb.levels,
            ended: climb.ended.unwrap_or_default(),
        })
        .collect();
    report.reference = reference::finest(&report.strategies);
    if let Some(finest) = &report.reference {
        reference::measure(&mut report.strategies, finest);
        for measure in [Measure::Bar, Measure::Error] {
            let offers: Vec<Offer> = (report.strategies.iter())
                .map(|course| offer(course, finest, measure))
                .collect();
            report.prices.extend(price_list(&offers, measure));
            // Those by bars, where there are bars, are what is told of a course.
            for (course, offer) in report.strategies.iter_mut().zip(&offers) {
                if course.time_exponent.is_none() && !offer.levels.is_empty() {
                    course.order = offer.order();
                    course.time_exponent = Some(offer.exponent());
                }
            }
        }
        if finest.uncertainty.is_none() {
            let why =
                "errors are not known: the finest answer has no coarser one beside it; give more time (--max-seconds)";
            report.notes.push(why.to_owned());
        }
    }
    report.seconds = budget.spent();
    Ok(Convergence { report, mesh })
}

/// The load [N] that drag, a moving centre and given pressures would make of the whole projected area.
fn natural_load(scene: &Scene) -> f64 {
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

/// What a course sells: levels whose error is known by that measure.
fn offer(course: &Course, reference: &report::Reference, measure: Measure) -> Offer {
    let bought = |level: &LevelReport| {
        Some(Bought {
            unknowns: level.unknowns as f64,
            seconds: level.seconds.total,
            error: level.error(measure, reference)?,
        })
    };
    Offer {
        strategy: course.strategy,
        order: course.order,
        levels: course.levels.iter().filter_map(bought).collect(),
    }
}
