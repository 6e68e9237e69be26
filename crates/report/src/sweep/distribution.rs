//! How quantities are distributed over the draws of a sweep, as `sweep.json` has it.

use std::collections::BTreeMap;

use oilwedge_campaign::statistics::SampleEstimate;
use oilwedge_scene::KeyTolerance;
use oilwedge_scene::sweep::AxisValue;
use serde::{Deserialize, Serialize};

use crate::digits::significant;
use crate::sheet::without_zeros;

/// Digits of numbers in words.
const DIGITS: usize = 6;

/// A tolerance that was drawn, in the unit of its key.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ToleranceRecord {
    /// The key, as an axis names it.
    pub key: String,
    /// The nominal number.
    pub nominal: f64,
    /// Half of the width.
    pub half_width: f64,
    /// Unit of both; empty for plain numbers.
    pub unit: String,
}

impl ToleranceRecord {
    /// The key, its number and the half width: `bearing.clearance 27 +- 3 um`.
    pub fn told(&self) -> String {
        let [nominal, half] = [self.nominal, self.half_width].map(|number| without_zeros(significant(number, DIGITS)));
        format!("{} {nominal} +- {half} {}", self.key, self.unit).trim_end().to_owned()
    }
}

impl From<&KeyTolerance> for ToleranceRecord {
    fn from(tolerance: &KeyTolerance) -> Self {
        Self {
            key: tolerance.key.clone(),
            nominal: tolerance.in_unit(tolerance.nominal),
            half_width: tolerance.half_width / tolerance.unit_size(),
            unit: tolerance.unit.clone(),
        }
    }
}

/// What the draws at one point of a sweep found.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Distribution {
    /// The values on the other axes, by the names of these.
    pub inputs: BTreeMap<String, AxisValue>,
    /// Number of draws.
    pub draws: usize,
    /// How many of them have an answer.
    pub answered: usize,
    /// Share of the draws that meet all criteria, with its sampling error; `None` where the scene has no criteria. A
    /// draw without an answer does not meet them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub meet_criteria: Option<SampledNumber>,
    /// How each quantity is distributed, by the name of its column.
    pub quantities: BTreeMap<String, SampledQuantity>,
}

/// A number that was estimated from draws.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct SampledNumber {
    /// The number.
    pub value: f64,
    /// Half width of the interval that holds the true one for 95 % of all seeds; `None` where there are too few draws.
    pub error: Option<f64>,
}

/// How a quantity is distributed.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct SampledQuantity {
    /// Unit of all numbers.
    pub unit: String,
    /// Mean.
    pub mean: SampledNumber,
    /// Standard deviation.
    pub deviation: SampledNumber,
    /// Percentiles, by `p1` to `p99`.
    pub percentiles: BTreeMap<String, SampledNumber>,
}

impl From<SampleEstimate> for SampledNumber {
    fn from(estimate: SampleEstimate) -> Self {
        Self { value: estimate.value, error: estimate.error }
    }
}
