//! One axis of a sweep: a key of the scene, and the values it takes one after the other.

use std::ops::Range;

use serde::{Deserialize, Serialize};

/// Short names of the keys that are swept most, and where they stand.
pub const SHORT_NAMES: [(&str, &str); 9] = [
    ("eccentricity", "journal.eccentricity"),
    ("min_film_angle", "journal.min_film_angle"),
    ("speed", "journal.speed"),
    ("force", "load.force"),
    ("load_angle", "load.angle"),
    ("viscosity", "oil.viscosity"),
    ("clearance", "bearing.clearance"),
    ("diameter", "bearing.diameter"),
    ("length", "bearing.length"),
];

/// Short names of the keys of a crankshaft that are swept most, and where they stand.
pub const SHAFT_SHORT_NAMES: [(&str, &str); 1] = [("speed", "crankshaft.speed")];

/// Axis of the bearings of a crankshaft, which follows those of its sweep, and where their names stand.
pub const BEARING: (&str, &str) = ("bearing", "crankshaft.bearing.name");

/// A key of the scene and its values.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SweepAxis {
    /// The key as it is written below `[sweep]`, tables before it: `speed`, `oil.barus.alpha`,
    /// `feed.feed_hole.pressure`.
    pub name: String,
    /// Where it stands in the scene, `journal.speed`; a feed by its group.
    #[serde(rename = "key")]
    pub path: String,
    /// Unit in which the values are written; empty for plain numbers and words.
    pub unit: String,
    /// The values, in their order; never none.
    pub values: Vec<AxisValue>,
    /// Bytes of the scene's text where they are written.
    #[serde(skip)]
    pub span: Range<usize>,
}

/// What a key is set to.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum AxisValue {
    /// A number, in the unit of the axis.
    Number(f64),
    /// A choice, as `jfo`.
    Word(String),
}

impl SweepAxis {
    /// Heading of its column: `speed [rpm]`; the name alone for plain numbers and words.
    pub fn heading(&self) -> String {
        match self.unit.is_empty() {
            true => self.name.clone(),
            false => format!("{} [{}]", self.name, self.unit),
        }
    }

    /// Value `index` in words: `3000 rpm`.
    pub fn told(&self, index: usize) -> String {
        match &self.values[index] {
            AxisValue::Number(number) if self.unit.is_empty() => format!("{number}"),
            AxisValue::Number(number) => format!("{number} {}", self.unit),
            AxisValue::Word(word) => word.clone(),
        }
    }

    /// Whether all its values are numbers.
    pub fn is_numeric(&self) -> bool {
        self.values.iter().all(|value| matches!(value, AxisValue::Number(_)))
    }

    /// Value `index` as a number, by which its distance from the others is measured; its place in the list for words.
    pub fn coordinate(&self, index: usize) -> f64 {
        match self.values[index] {
            AxisValue::Number(number) => number,
            AxisValue::Word(_) => index as f64,
        }
    }
}
