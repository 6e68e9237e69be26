//! What a balance asks of the film: a force and, where the tilt of the journal is free, a moment.

use oilwedge_reynolds::JournalState;
use oilwedge_reynolds::quantities::load::Resultant;

use crate::coordinates::{Coordinates, Vector, moved};

/// Force on the journal, and what tilts it where its tilt is found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JournalLoad {
    /// Force `(F_x, F_y)` [N].
    pub force: [f64; 2],
    /// What tilts the journal; `None`: its tilt is given.
    pub tilting: Option<Tilting>,
}

/// What tilts a journal: the film carries the moment `M + k (g_0 - g)` at the slope g of the axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tilting {
    /// Moment `M` about mid-length [N m], that of a force off the middle included: `z_F F`.
    pub moment: [f64; 2],
    /// Stiffness `k` of what supports the shaft [N m/rad]; zero: the journal tilts freely.
    pub stiffness: f64,
    /// Slope `g_0` that the support would give the axis [rad].
    pub support: [f64; 2],
}

impl JournalLoad {
    /// Magnitude of the force [N].
    pub fn magnitude(&self) -> f64 {
        self.force[0].hypot(self.force[1])
    }
}

impl JournalLoad {
    /// The load, and what tilts the journal where it is parallel to the bearing, in coordinates with this `arm` [m] of
    /// moments [N].
    pub(crate) fn asked(&self, arm: f64) -> Vector {
        let tilting = self.tilting.map_or([0.0; 2], |tilting| {
            [0, 1].map(|d| (tilting.moment[d] + tilting.stiffness * tilting.support[d]) / arm)
        });
        [self.force[0], self.force[1], tilting[0], tilting[1]]
    }

    /// Stiffness [N/m] of the support in these coordinates.
    pub(crate) fn support_stiffness(&self, arm: f64) -> f64 {
        self.tilting.map_or(0.0, |tilting| tilting.stiffness / (arm * arm))
    }

    /// What a film carries at a place of the journal, and its support there, less this load [N]: nothing where the
    /// journal is in balance.
    pub fn excess(&self, coordinates: &Coordinates, journal: &JournalState, carried: &Resultant) -> Vector {
        let [_, _, z_x, z_y] = coordinates.at(journal);
        let support = [0.0, 0.0, z_x, z_y].map(|slope| self.support_stiffness(coordinates.arm) * slope);
        moved(moved(coordinates.forces(carried), 1.0, support), -1.0, self.asked(coordinates.arm))
    }

    /// This load with further forces in coordinates whose slopes are multiplied by `arm` [m].
    pub(crate) fn with(self, [x, y, z_x, z_y]: Vector, arm: f64) -> Self {
        let [force_x, force_y] = self.force;
        let tilting = self.tilting.map(|tilting| Tilting {
            moment: [tilting.moment[0] + arm * z_x, tilting.moment[1] + arm * z_y],
            ..tilting
        });
        Self { force: [force_x + x, force_y + y], tilting }
    }
}

impl From<[f64; 2]> for JournalLoad {
    /// A force [N] on a journal of given tilt.
    fn from(force: [f64; 2]) -> Self {
        Self { force, tilting: None }
    }
}
