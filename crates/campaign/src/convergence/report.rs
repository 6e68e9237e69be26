//! What a convergence study found, as scripts read it: `converge.json`.
//!
//! Values are in the unit of the goal; errors, bars and accuracies are relative to the finest answer.

use serde::{Deserialize, Serialize};

use super::cost_model::{AccuracyMeasure, Price};
use super::strategy::Strategy;
use oilwedge_study::effects::Effects;
use oilwedge_study::result::{ResultHead, in_order};

/// Name and version of the form of `converge.json`.
pub const CONVERGE_FORMAT: &str = "oilwedge-converge/1";

/// Everything that a study found.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct ConvergenceReport {
    /// Scene and program; whether there are any levels, and why there are none.
    #[serde(flatten)]
    pub head: ResultHead,
    /// What was simulated, and what was not.
    pub effects: Effects,
    /// The number whose error is studied.
    pub goal: GoalFacts,
    /// The finest answer.
    pub reference: Option<Reference>,
    /// The ways to more accuracy.
    pub strategies: Vec<StrategyLevels>,
    /// What each digit costs: by error bars, where there are any, and then by true errors.
    pub prices: Vec<Price>,
    /// What to know of the study, in sentences.
    pub notes: Vec<String>,
    /// The time that was given [s].
    pub max_seconds: f64,
    /// The time that was taken [s], without drawing and writing.
    pub seconds: f64,
}

/// The number whose error is studied.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct GoalFacts {
    /// Name of the quantity: `load`, or `eccentricity` where a load is given.
    pub name: String,
    /// Symbol of the quantity.
    pub symbol: String,
    /// Unit of the quantity.
    pub unit: String,
}

/// The finest answer, which errors are measured against.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Reference {
    /// Strategy of the course.
    pub strategy: Strategy,
    /// Level on which the reference was computed.
    pub level: usize,
    /// Unknowns there.
    pub unknowns: usize,
    /// The value.
    pub value: f64,
    /// How well it is itself known, relative: its bar or, if that is less, what its distances from the levels before
    /// predict; `None` with one level and no bar. Errors below this mean nothing.
    pub uncertainty: Option<f64>,
}

/// The levels of one strategy.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StrategyLevels {
    /// The strategy.
    pub strategy: Strategy,
    /// The order s with which its price is extrapolated.
    pub order: f64,
    /// The exponent t with which its seconds are extrapolated; `None` without levels.
    pub time_exponent: Option<f64>,
    /// Levels of the course, from coarse to fine.
    pub levels: Vec<LevelReport>,
    /// Why there are no more.
    pub ended: String,
}

/// One level.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct LevelReport {
    /// Number of the level, from 1.
    pub level: usize,
    /// Triangles.
    pub cells: usize,
    /// Nodes whose pressure is not given.
    pub unknowns: usize,
    /// Value of the goal.
    pub value: f64,
    /// Half width of the error bar over the finest answer; `None` where it was not estimated.
    pub relative_bar: Option<f64>,
    /// Distance from the finest answer over that answer; `None` for the finest answer itself, or if it is not known
    /// well.
    pub relative_error: Option<f64>,
    /// The time from the scene to this answer.
    pub seconds: Timing,
}

impl LevelReport {
    /// The relative error by a measure: the bar, or the distance from the finest answer, but not less than
    /// that one is known to.
    pub fn error(&self, measure: AccuracyMeasure, reference: &Reference) -> Option<f64> {
        match measure {
            AccuracyMeasure::Bar => self.relative_bar,
            AccuracyMeasure::Error => Some(self.relative_error.unwrap_or(0.0).max(reference.uncertainty?)),
        }
    }
}

/// How long a level took [s].
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Timing {
    /// Median of the runs: from the scene to the answer.
    pub total: f64,
    /// The quickest run.
    pub least: f64,
    /// The slowest run.
    pub greatest: f64,
    /// How often the level was run.
    pub runs: usize,
    /// The parts of the total, medians: `mesh` is the making of all meshes up to this one, `earlier` the levels before
    /// that an adaptive mesh needs. An object keyed by part in JSON.
    #[serde(with = "in_order")]
    pub parts: Vec<(String, f64)>,
}

/// Parts of the time of a level, in the order of the work; the last is what remains.
pub const TIME_PARTS: [&str; 10] =
    ["mesh", "earlier", "order", "search", "assemble", "factorise", "solve", "bars", "measure", "other"];

impl Timing {
    /// Seconds of a part; zero where it was not needed.
    pub fn part(&self, name: &str) -> f64 {
        self.parts.iter().find(|(part, _)| part == name).map_or(0.0, |(_, seconds)| *seconds)
    }
}

impl ConvergenceReport {
    /// All levels, each with its course.
    pub fn levels(&self) -> impl Iterator<Item = (&StrategyLevels, &LevelReport)> {
        (self.strategies.iter()).flat_map(|course| course.levels.iter().map(move |level| (course, level)))
    }
}
