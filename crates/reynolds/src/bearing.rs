//! The bearing's dimensions.

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
