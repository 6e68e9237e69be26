//! What a run found, as scripts read it: `result.json`, and the facts that `oilwedge check` tells.
//!
//! Every number is SI, angles (degrees) and temperatures (degrees C) excepted. A number that is not finite is never written.

mod bars;
mod check;
mod heat;

pub use bars::{ErrorParts, LevelFacts, Refinement};
pub use check::{CHECK_FORMAT, CheckReport, Cost, RegionFacts};
pub use heat::{Criterion, HeatPoint, HeatReport};

use crate::cost::EffectCost;
use crate::regime::Regime;
use crate::standard::Standard;
use crate::theories::Theories;
use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

/// Name and version of the form of `result.json`.
pub const RESULT_FORMAT: &str = "oilwedge-result/1";

/// One reported number.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Quantity {
    /// Name of the contract, as `load` or `feed_flow.feed_hole`: the key in `quantities`.
    #[serde(skip)]
    pub name: String,
    /// Symbol, as `W`.
    pub symbol: String,
    /// The value in `unit`.
    pub value: f64,
    /// `N m m3/s N.m Pa Pa.s W deg degC rad/s` or `1`.
    pub unit: String,
    /// Half width of the error bar in `unit`, the sum of its parts; `None` where it is not estimated or not resolved.
    pub error: Option<f64>,
    /// Where the error comes from, wherever there is a bar.
    pub error_parts: Option<ErrorParts>,
}

impl Quantity {
    /// A number without an error bar.
    pub fn new(name: impl Into<String>, symbol: impl Into<String>, value: f64, unit: impl Into<String>) -> Self {
        Self {
            name: name.into(),
            symbol: symbol.into(),
            value,
            unit: unit.into(),
            error: None,
            error_parts: None,
        }
    }
}

/// How a run ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Status {
    /// Solved.
    Converged,
    /// The problem has no solution; the reason says why, and there are no quantities.
    NoSolution,
    /// A solution may exist but was not reached; or there is one, but a limit ended the refinement before its bars were
    /// small enough: the reason begins with `limit` then, and quantities and bars are there.
    NotConverged,
}

/// Names of what was computed and of what was left out.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize)]
pub struct Effects {
    /// In the order of the sockets, as `cavitation: guembel`.
    pub simulated: Vec<String>,
    /// In the same order.
    pub not_simulated: Vec<String>,
}

/// Facts about a mesh.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize)]
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
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize)]
pub struct Balances {
    /// Oil that enters minus oil that leaves, relative to the oil that passes.
    pub mass: f64,
    /// Power put in less heat, relative to the sum of all powers.
    pub power: f64,
    /// Load minus the force of the film, relative to the load; zero where the position is given.
    pub force: f64,
    /// Heat of friction less what is carried off, relative to it; zero where the temperature is given.
    pub heat: f64,
}

/// One step of the iteration.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize)]
pub struct HistoryStep {
    /// Number of the step, from 1.
    pub step: usize,
    /// Residual relative to the first one.
    pub residual: f64,
    /// Size of the active set (nodes held at the cavity pressure).
    pub active: usize,
}

/// How often the dear things were done.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize)]
pub struct Counts {
    /// Linear solves of the problem of the result.
    pub linear_solves: usize,
    /// Numerical factorisations of the problem of the result; with multigrid, of its coarsest level.
    pub factorisations: usize,
    /// Steps of the nonlinear iteration.
    pub nonlinear_iterations: usize,
    /// Solves on coarser levels.
    pub levels: usize,
    /// Solves for error bars.
    pub bars: usize,
    /// Positions of the journal that were tried.
    pub position_steps: usize,
}

/// How the linear systems of the problem of the result were solved.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct LinearSolver {
    /// `direct`: by a factor; `multigrid`; `switched`: by a factor, after multigrid was found to be slow.
    pub route: &'static str,
    /// Steps of conjugate gradients with multigrid.
    pub steps: usize,
}

/// Everything that a run found: the whole of `result.json`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RunResult {
    /// [`RESULT_FORMAT`].
    pub format: String,
    /// Title of the scene.
    pub title: String,
    /// Version of the program.
    pub version: String,
    /// SHA-256 of the scene's text, hexadecimal.
    pub scene_sha256: String,
    /// SHA-256 of the mesh file, hexadecimal.
    pub mesh_sha256: String,
    /// How the run ended.
    pub status: Status,
    /// Why there is no solution, or why it was not reached.
    pub reason: Option<String>,
    /// What was computed and what was not.
    pub effects: Effects,
    /// The mesh of the result.
    pub mesh: MeshFacts,
    /// The numbers, in the order of the report; an object keyed by name in JSON.
    #[serde(serialize_with = "by_name")]
    pub quantities: Vec<Quantity>,
    /// Whether error bars were asked for and estimated; one that is missing then could not be resolved.
    pub bars: bool,
    /// The meshes on the way to a tolerance, the last being that of the result; none without a tolerance.
    pub levels: Vec<LevelFacts>,
    /// What must vanish.
    pub balances: Balances,
    /// Which assumptions the film meets; `null` where there is none.
    pub regime: Option<Regime>,
    /// How the temperature of the film comes about, and whether the bearing will do; absent in JSON where it was not sought.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub heat: Option<HeatReport>,
    /// The nonlinear iteration.
    pub history: Vec<HistoryStep>,
    /// How often the dear things were done.
    pub counts: Counts,
    /// How linear systems were solved; `null` where there is no film.
    pub linear_solver: Option<LinearSolver>,
    /// Wall time of each part [s], in the order of the run; an object keyed by part in JSON.
    #[serde(serialize_with = "in_parts")]
    pub timing_s: Vec<(String, f64)>,
    /// Doubts about the result, in sentences.
    pub warnings: Vec<String>,
    /// What each effect changes and costs; `None`, and absent in JSON, where that was not asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cost: Option<Vec<EffectCost>>,
    /// The bearing by ISO 7902; `None`, and absent in JSON, where that was not asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub standard: Option<Standard>,
    /// The film as a short, a full and a long one; `None`, and absent in JSON, where that was not asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub theories: Option<Theories>,
}

/// Why a result was not written.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ReportError {
    /// A number is NaN or infinite.
    #[error("{name} is {value}, which is no number to report; this is a fault of the program, please report the scene")]
    NotFinite {
        /// Where the number stands in the result.
        name: String,
        /// The number.
        value: f64,
    },
    /// Two quantities bear one name.
    #[error("the quantity {name} is reported twice; this is a fault of the program, please report the scene")]
    Twice {
        /// The name.
        name: String,
    },
    /// The writer of JSON failed.
    #[error("the result cannot be written as JSON: {0}")]
    Json(String),
}

impl RunResult {
    /// The quantity of this name.
    pub fn quantity(&self, name: &str) -> Option<&Quantity> {
        self.quantities.iter().find(|quantity| quantity.name == name)
    }

    /// The text of `result.json`, with a line break at its end.
    ///
    /// # Errors
    /// [`ReportError`] where a number is not finite or two quantities bear one name.
    pub fn to_json(&self) -> Result<String, ReportError> {
        for (index, quantity) in self.quantities.iter().enumerate() {
            if self.quantities[..index].iter().any(|other| other.name == quantity.name) {
                return Err(ReportError::Twice {
                    name: quantity.name.clone(),
                });
            }
            finite(&format!("quantities.{}.value", quantity.name), quantity.value)?;
            finite(
                &format!("quantities.{}.error", quantity.name),
                quantity.error.unwrap_or(0.0),
            )?;
            for (part, value) in quantity.error_parts.iter().flat_map(ErrorParts::by_name) {
                finite(&format!("quantities.{}.error_parts.{part}", quantity.name), value)?;
            }
        }
        for (number, level) in (1..).zip(&self.levels) {
            for (name, error) in &level.errors {
                finite(&format!("levels, level {number}, error of {name}"), *error)?;
            }
            finite(&format!("levels, level {number}, seconds"), level.seconds)?;
        }
        finite("mesh.min_angle_deg", self.mesh.min_angle_deg)?;
        finite("balances.mass", self.balances.mass)?;
        for (name, value) in self.regime.iter().flat_map(Regime::by_name) {
            finite(&format!("regime.{name}"), value)?;
        }
        finite("balances.power", self.balances.power)?;
        finite("balances.force", self.balances.force)?;
        finite("balances.heat", self.balances.heat)?;
        for (name, value) in self.heat.iter().flat_map(HeatReport::numbers) {
            finite(&format!("heat.{name}"), value)?;
        }
        for step in &self.history {
            finite(&format!("history, step {}, residual", step.step), step.residual)?;
        }
        for (part, seconds) in &self.timing_s {
            finite(&format!("timing_s.{part}"), *seconds)?;
        }
        for (name, number) in self.cost.iter().flatten().flat_map(EffectCost::numbers) {
            finite(&name, number)?;
        }
        for (name, number) in self.standard.iter().flat_map(Standard::numbers) {
            finite(&format!("standard.{name}"), number)?;
        }
        for (name, number) in self.theories.iter().flat_map(Theories::numbers) {
            finite(&name, number)?;
        }
        json(self)
    }
}

fn finite(name: &str, value: f64) -> Result<(), ReportError> {
    match value.is_finite() {
        true => Ok(()),
        false => Err(ReportError::NotFinite {
            name: name.to_string(),
            value,
        }),
    }
}

pub(crate) fn json(value: &impl Serialize) -> Result<String, ReportError> {
    let text = serde_json::to_string_pretty(value).map_err(|error| ReportError::Json(error.to_string()))?;
    Ok(text + "\n")
}

fn by_name<S: Serializer>(quantities: &[Quantity], serializer: S) -> Result<S::Ok, S::Error> {
    let mut map = serializer.serialize_map(Some(quantities.len()))?;
    for quantity in quantities {
        map.serialize_entry(&quantity.name, quantity)?;
    }
    map.end()
}

fn in_parts<S: Serializer>(parts: &[(String, f64)], serializer: S) -> Result<S::Ok, S::Error> {
    let mut map = serializer.serialize_map(Some(parts.len()))?;
    for (part, seconds) in parts {
        map.serialize_entry(part, seconds)?;
    }
    map.end()
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    pub(crate) fn example() -> RunResult {
        RunResult {
            format: RESULT_FORMAT.into(),
            title: "example".into(),
            version: "0.1.0".into(),
            scene_sha256: "ab".into(),
            mesh_sha256: "cd".into(),
            status: Status::NotConverged,
            reason: None,
            effects: Effects {
                simulated: vec!["poiseuille".into()],
                not_simulated: vec!["squeeze".into()],
            },
            mesh: MeshFacts {
                cells: 592,
                nodes: 1245,
                order: 2,
                min_angle_deg: 31.0,
            },
            quantities: vec![
                Quantity::new("load", "W", 12910.0, "N"),
                Quantity::new("attitude_angle", "beta", 49.29, "deg"),
            ],
            bars: false,
            levels: vec![],
            balances: Balances {
                mass: 1e-12,
                power: 1e-12,
                force: 0.0,
                heat: 0.0,
            },
            regime: None,
            heat: None,
            history: vec![HistoryStep {
                step: 1,
                residual: 1.0,
                active: 0,
            }],
            counts: Counts::default(),
            linear_solver: None,
            timing_s: vec![("read".into(), 0.25), ("assemble".into(), 0.5)],
            warnings: vec![],
            cost: None,
            standard: None,
            theories: None,
        }
    }

    #[test]
    fn the_json_is_that_of_the_contract() {
        let text = example().to_json().expect("all numbers are finite");
        let value: serde_json::Value = serde_json::from_str(&text).expect("it is JSON");
        assert_eq!(value["status"], "not_converged");
        assert_eq!(value["reason"], serde_json::Value::Null);
        let load =
            serde_json::json!({ "symbol": "W", "value": 12910.0, "unit": "N", "error": null, "error_parts": null });
        assert_eq!(value["quantities"]["load"], load);
        assert_eq!(value["timing_s"]["assemble"], 0.5);
        let place = |word: &str| text.find(word).expect(word);
        let order = [
            "format",
            "title",
            "version",
            "scene_sha256",
            "mesh_sha256",
            "status",
            "reason",
            "effects",
            "mesh\"",
            "quantities",
            "\"load",
            "attitude_angle",
            "bars",
            "levels",
            "balances",
            "regime",
            "history",
            "counts",
            "linear_solver",
            "timing_s",
            "read",
            "assemble",
            "warnings",
        ];
        assert!(order.windows(2).all(|pair| place(pair[0]) < place(pair[1])), "{text}");
    }

    #[test]
    fn what_is_not_finite_is_not_written() {
        let level = |result: &mut RunResult, error: f64, seconds: f64| {
            result.levels = vec![LevelFacts {
                errors: vec![("load".into(), error)],
                seconds,
                ..LevelFacts::default()
            }];
        };
        let spoil: [&dyn Fn(&mut RunResult); 10] = [
            &|result| result.quantities[1].value = f64::NAN,
            &|result| result.quantities[0].error = Some(f64::INFINITY),
            &|result| result.balances.mass = f64::NAN,
            &|result| result.balances.power = f64::NAN,
            &|result| result.history[0].residual = f64::INFINITY,
            &|result| result.timing_s[1].1 = f64::NAN,
            &|result| result.mesh.min_angle_deg = f64::NAN,
            &|result| {
                let front = f64::NAN;
                result.quantities[0].error_parts = Some(ErrorParts {
                    front,
                    ..ErrorParts::default()
                });
            },
            &|result| level(result, f64::INFINITY, 0.0),
            &|result| level(result, 0.0, f64::NAN),
        ];
        for spoil in spoil {
            let mut result = example();
            spoil(&mut result);
            assert!(matches!(result.to_json(), Err(ReportError::NotFinite { .. })));
        }
        let mut result = example();
        result.quantities[1].name = "load".into();
        assert!(matches!(result.to_json(), Err(ReportError::Twice { .. })));
    }
}
