//! The bearing's dimensions.

use crate::JournalState;

/// Radius, length and clearance of a journal bearing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bearing {
    /// Journal radius R [m].
    pub radius: f64,
    /// Axial length B [m], from `z = -B/2` to `z = B/2`.
    pub length: f64,
    /// Radial clearance c [m].
    pub clearance: f64,
    /// Pressure p_e at the ends [Pa gauge]; loads count the pressure above it.
    pub end_pressure: f64,
}

impl Bearing {
    /// `a - b` [m] for two places `x = R phi`, the shorter way around.
    pub fn around(&self, a: f64, b: f64) -> f64 {
        let turn = std::f64::consts::TAU * self.radius;
        (a - b) - turn * ((a - b) / turn).round()
    }

    /// Least film thickness [m] over the whole circumference with the journal in this state.
    pub fn least_gap(&self, journal: &JournalState) -> f64 {
        self.clearance - journal.eccentricity()
    }
}
