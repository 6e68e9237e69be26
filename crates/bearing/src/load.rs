//! What a balance asks of the film: a force and, where the tilt of the journal is free, a moment.

/// Force on the journal, and what tilts it where its tilt is found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Load {
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

impl Load {
    /// Magnitude of the force [N].
    pub fn magnitude(&self) -> f64 {
        self.force[0].hypot(self.force[1])
    }

    /// This load with `part` of what tilts the journal: a part of the moment, and of the slope of the support.
    pub(crate) fn with_part_of_tilting(self, part: f64) -> Self {
        let scaled = |vector: [f64; 2]| vector.map(|value| part * value);
        let tilting = self.tilting.map(|tilting| Tilting {
            moment: scaled(tilting.moment),
            support: scaled(tilting.support),
            ..tilting
        });
        Self { tilting, ..self }
    }
}

impl From<[f64; 2]> for Load {
    /// A force [N] on a journal of given tilt.
    fn from(force: [f64; 2]) -> Self {
        Self { force, tilting: None }
    }
}
