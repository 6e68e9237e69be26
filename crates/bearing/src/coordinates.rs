//! Coordinates of the journal and the forces that do work on them, one type for a balance of force alone and for one of
//! force and moment.
//!
//! | order | coordinates [m] | forces [N] |
//! |---|---|---|
//! | 0 | | |
//! | 2 | e_x, e_y | W_x, W_y |
//! | 4 | e_x, e_y, l g_x, l g_y | W_x, W_y, m_x/l, m_y/l |
//!
//! The slopes g are multiplied by the arm l, half of the bearing's length, so that all coordinates are offsets [m] and
//! all forces are in newtons.

use oilwedge_reynolds::quantities::load::Resultant;
use oilwedge_reynolds::{Bearing, CentreVelocity, JournalChange, JournalState};

use crate::JournalLoad;

/// Coordinates or forces; with two coordinates the last two are zero.
pub type Vector = [f64; 4];

/// Which coordinates of the journal are free.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coordinates {
    /// How many: 0, 2 or 4.
    pub order: usize,
    /// Arm l of moments [m].
    pub arm: f64,
}

impl Coordinates {
    /// The coordinates that are free under a load.
    pub fn of(load: &JournalLoad, bearing: &Bearing) -> Self {
        Self { order: if load.tilting.is_some() { 4 } else { 2 }, arm: 0.5 * bearing.length }
    }

    /// A pair of parts towards x and y, and one of moments or slopes times `per_arm`, if these are free.
    fn vector(&self, [x, y]: [f64; 2], of_tilt: [f64; 2], per_arm: f64) -> Vector {
        let [z_x, z_y] = of_tilt.map(|part| per_arm * part);
        match self.order {
            0 => [0.0; 4],
            2 => [x, y, 0.0, 0.0],
            _ => [x, y, z_x, z_y],
        }
    }

    /// Where a journal is.
    pub fn at(&self, journal: &JournalState) -> Vector {
        self.vector(journal.offset, journal.tilt, self.arm)
    }

    /// Force and moment of a film.
    pub fn forces(&self, carried: &Resultant) -> Vector {
        self.vector(carried.force, carried.moment, 1.0 / self.arm)
    }

    /// The journal in another place; a given tilt stays.
    pub fn placed(&self, journal: &JournalState, [x, y, z_x, z_y]: Vector) -> JournalState {
        let tilt = match self.order {
            4 => [z_x, z_y].map(|part| part / self.arm),
            _ => journal.tilt,
        };
        match self.order {
            0 => *journal,
            _ => JournalState { offset: [x, y], tilt, ..*journal },
        }
    }

    /// A journal whose coordinates change at these rates [m/s]; the rate of a given tilt stays.
    pub fn moving(&self, journal: JournalState, [x, y, z_x, z_y]: Vector) -> JournalState {
        let tilt_rate = match self.order {
            4 => [z_x, z_y].map(|part| part / self.arm),
            _ => journal.tilt_rate,
        };
        JournalState { velocity: [x, y], tilt_rate, ..journal }
    }

    /// The change of a journal that moves by `step`; its velocity turns with the line of centres.
    pub fn change(&self, journal: &JournalState, velocity: &CentreVelocity, [x, y, z_x, z_y]: Vector) -> JournalChange {
        JournalChange {
            tilt: match self.order {
                4 => [z_x, z_y].map(|part| part / self.arm),
                _ => [0.0; 2],
            },
            ..velocity.change(journal, [x, y])
        }
    }
}

/// Magnitude of a vector.
pub fn length([x, y, z_x, z_y]: Vector) -> f64 {
    x.hypot(y).hypot(z_x.hypot(z_y))
}

/// Scalar product of two vectors.
pub fn dot(a: Vector, b: Vector) -> f64 {
    (0..4).map(|k| a[k] * b[k]).sum()
}

/// `a + part b`.
pub fn moved(a: Vector, part: f64, b: Vector) -> Vector {
    [0, 1, 2, 3].map(|k| a[k] + part * b[k])
}

/// The unit vector `k`.
pub fn unit(k: usize) -> Vector {
    let mut unit = [0.0; 4];
    unit[k] = 1.0;
    unit
}
