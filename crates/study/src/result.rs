//! What a run found, as scripts read it: `result.json`, and the facts that `oilwedge check` shows.
//!
//! Every number is SI, angles (degrees) and temperatures (degrees C) excepted. A number that is not finite is never
//! written.

mod criterion;
mod dynamics;
mod geometry;
mod head;
mod headlines;
pub mod in_order;
mod levels;
pub(crate) mod named;
mod tail;
mod temperature;

pub use criterion::{Accuracy, Criterion, CriterionSpread, Origin, Reserve, Verdict};
pub use dynamics::{CoefficientMatrix, CoefficientReport, DynamicsReport, Pair, RotorReport, Stable};
pub use geometry::Geometry;
pub use head::ResultHead;
pub use headlines::{MOST_HEADLINES, headlines};
pub use levels::{LevelFacts, Refinement};
pub use tail::ResultTail;
pub use temperature::{SECONDS_KEY, TemperatureAcross, TemperaturePoint, TemperatureReport};

use crate::effects::Effects;
use crate::no_answer::NoAnswer;
use crate::orbit::OrbitFacts;
use crate::quantities::{Quantity, Row, ToleranceCurve};
use crate::regime::Regime;
use serde::{Deserialize, Serialize};

/// Name and version of the form of `result.json`.
pub const RESULT_FORMAT: &str = "oilwedge-result/1";

/// How a run ended.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Status {
    /// The scene is solved.
    Converged,
    /// The problem has no solution; the reason says why, and there are no quantities.
    NoSolution,
    /// A solution may exist but was not reached; or there is one, but a limit ended the refinement before its bars were
    /// small enough: the reason begins with `limit` then, and quantities and bars are there.
    #[default]
    NotConverged,
}

impl Status {
    /// The status of a run without an answer.
    pub fn without(answer: &NoAnswer) -> Self {
        match answer.is_unreached() {
            true => Self::NotConverged,
            false => Self::NoSolution,
        }
    }

    /// Name of the status in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Converged => "converged",
            Self::NoSolution => "no_solution",
            Self::NotConverged => "not_converged",
        }
    }
}

/// Facts about a mesh.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct MeshFacts {
    /// Number of triangles.
    pub cells: usize,
    /// Number of nodes, mid-side nodes included.
    pub nodes: usize,
    /// Order of the unknown pressure on a triangle.
    pub order: usize,
    /// The smallest angle of all triangles [deg].
    pub min_angle_deg: f64,
}

/// What must vanish, and what was left of it [1].
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Balances {
    /// Oil that enters minus oil that leaves, relative to the oil that passes.
    pub mass: f64,
    /// Power put in less heat, relative to the sum of all powers.
    pub power: f64,
    /// `T - T_b - W e sin beta`, the moments on journal and bearing less that of the load, as the film's pressures have
    /// it, over the friction; zero where pockets deepen the film, and of a short bearing.
    pub moment: f64,
    /// Load minus the force of the film, relative to the load; zero where the position is given.
    pub force: f64,
    /// Moment of load and support less that of the film, over the load times half of the bearing's length; zero where
    /// the tilt is given.
    pub tilt: f64,
    /// Deflection of the elastic liner less that by the pressure of the film, relative to it; absent in JSON where the
    /// liner is rigid.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub deflection: Option<f64>,
    /// Heat of friction less what is carried off, relative to it; zero where the temperature is given.
    #[serde(rename = "heat")]
    pub thermal: f64,
    /// Energy over the cycle of an orbit: what turns the journal and the work of the load, less the heat, relative to
    /// the heat; absent in JSON without an orbit.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub energy: Option<f64>,
}

/// One step of the iteration.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct HistoryStep {
    /// Number of the step, from 1.
    pub step: usize,
    /// Residual relative to the first one.
    pub residual: f64,
    /// Size of the active set (nodes held at the cavity pressure).
    pub active: usize,
}

/// How often expensive operations were done.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct Counts {
    /// Linear solves on the mesh of the result, those at all positions and temperatures included.
    pub linear_solves: usize,
    /// Numerical factorisations on the mesh of the result, likewise; with multigrid, of its coarsest level.
    pub factorisations: usize,
    /// Films solved on the mesh of the result and on the coarser ones of its searches.
    pub films: usize,
    /// Steps of the nonlinear iteration.
    pub nonlinear_iterations: usize,
    /// Solves on coarser levels.
    pub levels: usize,
    /// Solves for error bars.
    pub bars: usize,
    /// Positions of the journal that were tried, at all temperatures together.
    pub position_steps: usize,
    /// Temperatures of the film that were tried.
    pub temperature_steps: usize,
    /// Films solved for the deflection of an elastic liner at the position of the result; absent in JSON where the
    /// liner is rigid.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub deflection_steps: Option<usize>,
    /// Products with the tangent of film and liner on the way; absent likewise.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub deflection_products: Option<usize>,
}

/// How linear systems are solved.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum LinearRoute {
    /// By a factor.
    Direct,
    /// By conjugate gradients with multigrid.
    Multigrid,
    /// By a factor, after multigrid was found to be slow.
    Switched,
}

/// How the linear systems of the problem of the result were solved.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct LinearSolverFacts {
    /// The way.
    pub route: LinearRoute,
    /// Steps of conjugate gradients with multigrid.
    pub steps: usize,
}

/// Everything that a run found: the whole of `result.json`. A key that a file does not have is empty.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct RunResult {
    /// Scene, program and end of the run.
    #[serde(flatten)]
    pub head: ResultHead,
    /// What was computed and what was not.
    pub effects: Effects,
    /// The shape of the bearing.
    pub geometry: Geometry,
    /// The mesh of the result.
    pub mesh: MeshFacts,
    /// The numbers, in the order of the report; an object keyed by name in JSON.
    #[serde(with = "named")]
    pub quantities: Vec<Quantity>,
    /// Whether error bars were asked for and estimated; one that is missing then could not be resolved.
    pub bars: bool,
    /// Names of quantities that are those of the sharp hill of a mass-conserving film; what follows from them is, too.
    /// Absent in JSON where there are none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub of_hill: Vec<String>,
    /// The meshes on the way to a tolerance, the last being that of the result; none without a tolerance.
    pub levels: Vec<LevelFacts>,
    /// What must vanish.
    pub balances: Balances,
    /// Assumptions that the film meets; `null` where there is none.
    pub regime: Option<Regime>,
    /// How the orbit was followed; absent in JSON where none was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub orbit: Option<OrbitFacts>,
    /// How the temperature of the film comes about, and whether the bearing will do; absent in JSON where it was not
    /// sought.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[serde(rename = "heat")]
    pub temperature: Option<TemperatureReport>,
    /// The temperature across the film where it is hottest; absent in JSON where the film has one temperature.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub temperature_across: Option<TemperatureAcross>,
    /// Films along the tolerance that matters most; absent in JSON where the scene has none, or a film was not found.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tolerance_curve: Option<ToleranceCurve>,
    /// What the bearing is judged by, and what is usual; absent in JSON where the scene sets no limit and nothing is
    /// usual.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub criteria: Vec<Criterion>,
    /// How the film answers to small motions of the journal; absent in JSON where that is not asked, or could not be
    /// computed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub dynamics: Option<DynamicsReport>,
    /// The nonlinear iteration.
    pub history: Vec<HistoryStep>,
    /// How often expensive operations were done.
    pub counts: Counts,
    /// How linear systems were solved; `null` where there is no film.
    pub linear_solver: Option<LinearSolverFacts>,
    /// Times and warnings.
    #[serde(flatten)]
    pub tail: ResultTail,
}

impl RunResult {
    /// A quantity.
    pub fn quantity(&self, row: &Row) -> Option<&Quantity> {
        self.by_name(row.name)
    }

    /// The quantity of this name.
    pub fn by_name(&self, name: &str) -> Option<&Quantity> {
        self.quantities.iter().find(|quantity| quantity.name == name)
    }
}
