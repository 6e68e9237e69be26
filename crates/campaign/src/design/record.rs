//! A design as `result.json` has it.

use serde::{Deserialize, Serialize};

/// How the search of a design ended.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum DesignEnd {
    /// At an optimum.
    #[default]
    Optimum,
    /// Where no neighbouring film meets all criteria better.
    Infeasible,
    /// Where each further step leads to numbers without a film.
    NoFilm,
    /// After the most films allowed.
    Limit,
    /// Where no step is better although the gradient says so, or none can be computed.
    NoStep,
}

/// What a design has found.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct DesignRecord {
    /// Name of the quantity that is made least or greatest.
    pub objective: String,
    /// `minimise` or `maximise`.
    pub sense: String,
    /// The objective with the numbers of the scene, in its unit.
    pub start: f64,
    /// The objective at the optimum, on the mesh of the search.
    pub value: f64,
    /// The objective at the optimum, solved by itself on a mesh of its own; `None` where that has no film.
    pub solved: Option<f64>,
    /// Error bar of the latter; `None`: not estimated.
    pub error: Option<f64>,
    /// Whether all criteria are met there, up to the closeness of the search.
    pub is_met: bool,
    /// How the search ended.
    pub end: DesignEnd,
    /// Why it ended without an optimum.
    pub reason: Option<String>,
    /// The free keys.
    pub keys: Vec<ChosenKey>,
    /// The criteria at the optimum.
    pub constraints: Vec<Constraint>,
    /// Films of the search.
    pub films: usize,
    /// Films beside them that were solved for gradients.
    pub gradient_films: usize,
    /// The keys whose values are listed; absent in JSON where none are.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub choice_keys: Vec<String>,
    /// The optimum of each combination of them; absent in JSON likewise.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub choices: Vec<ListedChoice>,
    /// The films of the search; a table of its own.
    #[serde(skip)]
    pub path: Vec<DesignPoint>,
}

/// A number that was chosen, in the unit of its key.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct ChosenKey {
    /// The key with its tables.
    pub key: String,
    /// Unit; empty of plain numbers.
    pub unit: String,
    /// Number in the scene.
    pub start: f64,
    /// Number of the optimum.
    pub optimum: f64,
    /// Least and greatest number.
    pub bounds: [f64; 2],
    /// Whether the optimum is one of them.
    pub is_at_bound: bool,
}

/// A criterion as a constraint.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Constraint {
    /// What is compared, in words.
    pub what: String,
    /// Unit of the value, limit and spread.
    pub unit: String,
    /// The value.
    pub value: f64,
    /// The limit.
    pub limit: f64,
    /// How far the tolerances spread the value at worst; absent in JSON where they do not count.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub spread: Option<f64>,
    /// How far it is met beyond its spread, over the limit [1]; negative where it is not.
    pub left: f64,
    /// Whether it limits the objective.
    pub is_active: bool,
    /// What it costs: how much worse the objective is for a unit of the limit, in the unit of the objective.
    pub cost: f64,
}

/// The best film of one combination of listed values.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct ListedChoice {
    /// The values.
    pub values: Vec<String>,
    /// The objective at its optimum; `None` without a film.
    pub objective: Option<f64>,
    /// Whether all criteria are met there.
    pub is_met: bool,
}

/// A film of the search.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct DesignPoint {
    /// Numbers of the free keys, in their units.
    pub keys: Vec<f64>,
    /// The objective; `None` without a film.
    pub objective: Option<f64>,
    /// The criteria.
    pub constraints: Vec<Constraint>,
    /// Why there is no film.
    pub reason: Option<String>,
}
