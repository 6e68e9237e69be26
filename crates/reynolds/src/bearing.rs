//! The bearing's dimensions.

use crate::{JournalState, Thinnest};

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

    /// Axial positions of the ends [m].
    pub fn ends(&self) -> [f64; 2] {
        [-0.5 * self.length, 0.5 * self.length]
    }

    /// Where the gap of circular surfaces is least: at an end, for the offset `|e + z g|` is convex in z.
    pub(crate) fn thinnest(&self, journal: &JournalState) -> Thinnest {
        let [low, high] = self.ends().map(|z| self.thinnest_at(journal, z));
        if high.thickness < low.thickness { high } else { low }
    }

    /// Where the gap of circular surfaces is least at the axial position `z` [m].
    pub(crate) fn thinnest_at(&self, journal: &JournalState, z: f64) -> Thinnest {
        let [x, y] = journal.offset_at(z);
        Thinnest { thickness: self.clearance - x.hypot(y), angle: y.atan2(x), z }
    }

    /// Offset [m] towards `angle` [rad] at which a circular journal with this tilt touches a circular liner at one of
    /// its ends; zero where its tilt alone makes it touch.
    pub fn reach(&self, journal: &JournalState, angle: f64) -> f64 {
        let (sin, cos) = angle.sin_cos();
        let [x, y] = journal.tilt;
        let (along, across) = (x * cos + y * sin, y * cos - x * sin);
        let reach = self.ends().map(|z| {
            let square = self.clearance * self.clearance - z * z * across * across;
            square.max(0.0).sqrt() - z * along
        });
        reach[0].min(reach[1]).max(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BEARING: Bearing = Bearing { radius: 0.05, length: 0.04, clearance: 5e-5, end_pressure: 0.0 };

    #[test]
    fn a_tilted_journal_is_nearest_to_the_liner_at_an_end() {
        let journal = JournalState { offset: [1e-5, 0.0], tilt: [0.0, -1e-3], ..JournalState::default() };
        // e + z g = (1e-5, -+2e-5) at the ends: both are as far off.
        assert!((BEARING.thinnest(&journal).thickness - (5e-5 - 1e-5f64.hypot(2e-5))).abs() < 1e-20);
        let leaning = JournalState { tilt: [5e-4, 0.0], ..journal };
        let thinnest = BEARING.thinnest(&leaning);
        assert!((thinnest.thickness - 3e-5).abs() < 1e-20 && thinnest.z == 0.02 && thinnest.angle == 0.0);
    }

    #[test]
    fn the_reach_ends_where_the_gap_does() {
        for (tilt, angle) in [([0.0; 2], 0.3), ([1e-3, 4e-4], 1.1), ([-5e-4, 2e-3], 5.0)] {
            let journal = JournalState { tilt, ..JournalState::default() };
            let reach = BEARING.reach(&journal, angle);
            let offset = [reach * angle.cos(), reach * angle.sin()];
            let gap = BEARING.thinnest(&JournalState { offset, ..journal }).thickness;
            assert!(gap.abs() < 1e-15 * 5e-5 / 1e-5, "{tilt:?}: {gap:e}");
        }
        // The tilt alone makes it touch.
        let journal = JournalState { tilt: [3e-3, 0.0], ..JournalState::default() };
        assert_eq!(BEARING.reach(&journal, 0.0), 0.0);
    }
}
