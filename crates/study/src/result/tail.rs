//! The end of every file of results: how long the run took, and what is doubtful about it.

use serde::{Deserialize, Serialize};

use super::in_order;
use crate::warning::Warning;

/// Wall times and doubts of a run. A key that a file does not have is empty.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct ResultTail {
    /// Wall time of each part [s], in the order of the run; an object keyed by part in JSON.
    #[serde(with = "in_order")]
    pub timing_s: Vec<(String, f64)>,
    /// Doubts about the result, in sentences.
    pub warnings: Vec<Warning>,
}

impl ResultTail {
    /// Adds the wall time of a part [s].
    pub fn took(&mut self, part: &str, seconds: f64) {
        self.timing_s.push((part.to_owned(), seconds));
    }

    /// Wall time of a part [s]; zero where the run has none of this name.
    pub fn seconds(&self, part: &str) -> f64 {
        self.timing_s.iter().find(|(name, _)| name == part).map_or(0.0, |(_, seconds)| *seconds)
    }
}
