//! What the tolerances of a scene make of a quantity.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

/// How far a quantity is spread by the tolerances of a scene, to first order.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct QuantitySpread {
    /// Half width where all numbers are at their worst ends, in the unit of the quantity: the sum of all effects.
    pub worst_case: f64,
    /// Root of the sum of the squared effects, in the unit of the quantity.
    pub rss: f64,
    /// Share of each key in the square of `rss` [1]; none where nothing is spread.
    pub shares: BTreeMap<String, f64>,
    /// How far the quantity at its worst corners departs from `worst_case`, the greater of both sides, relative to it;
    /// absent in JSON of all quantities but those of short tables, for which the corners are solved.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub nonlinearity: Option<f64>,
    /// The quantity at the corners at which it is least and greatest, to first order; absent in JSON where it was not
    /// solved there, or is linear enough.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub corners: Option<[f64; 2]>,
}

/// Films along the tolerance that spreads the first quantity of short tables most, all other numbers nominal.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct ToleranceCurve {
    /// The key.
    pub key: String,
    /// Unit of its numbers; empty of plain ones.
    pub unit: String,
    /// Numbers of the key, from the lower end of the tolerance to the upper one.
    pub numbers: Vec<f64>,
    /// Quantities of short tables at each number, by name, in their units.
    pub quantities: BTreeMap<String, Vec<f64>>,
}

/// The derivative of a quantity by the number of a key.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Sensitivity {
    /// Quantity over number, in the unit of the quantity and the unit of the key.
    pub value: f64,
    /// Unit of the derivative.
    pub unit: String,
    /// Relative change of the quantity over that of the number [1]; `None` where one of them is zero, an angle or a
    /// temperature.
    pub log: Option<f64>,
    /// True where two films solved again have shown it, false where it is exact to first order; absent in JSON where it
    /// is false.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub is_by_films: bool,
    /// True where the derivatives on both sides of the number differ, as the cavity of a mesh changes by steps; absent
    /// in JSON where it is false.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub has_kink: bool,
}
