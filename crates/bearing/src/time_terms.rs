//! What an implicit stage of a method in time adds to the balance of a journal.
//!
//! **Equation.** `v = (x - x_0)/(gamma dt)`, and with a mass m the force `m (v - v_0)/(gamma dt)`. Its tangent is
//! `m/(gamma dt)^2`; the film answers to `dv = dx/(gamma dt)`.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | 1/(gamma dt) | 1/s | `per_time` |
//! | x_0, v_0 | m, m/s | `offset`, `rate` |
//! | m | kg | `masses` |
//!
//! **Source.** Definition of a diagonally implicit method. **Verified by** `tests/tests/orbit`.

use oilwedge_reynolds::JournalState;

use crate::coordinates::{Coordinates, Vector, moved};

/// A stage: what the stages before leave to the place of the journal.
#[derive(Debug, Clone, Copy)]
pub(crate) struct TimeTerms {
    /// `1/(gamma dt)` [1/s].
    pub(crate) per_time: f64,
    /// Offsets that the stages before leave [m].
    pub(crate) offset: Vector,
    /// Rates that the stages before leave to a rotor with mass [m/s].
    pub(crate) rate: Vector,
    /// Mass in each coordinate [kg].
    pub(crate) masses: Vector,
}

impl TimeTerms {
    /// The rate of a journal at these coordinates [m/s].
    pub(crate) fn velocity(&self, at: Vector) -> Vector {
        moved(at, -1.0, self.offset).map(|way| way * self.per_time)
    }

    /// What the mass takes of the load at these coordinates [N].
    pub(crate) fn inertia(&self, at: Vector) -> Vector {
        let velocity = self.velocity(at);
        [0, 1, 2, 3].map(|k| self.masses[k] * (velocity[k] - self.rate[k]) * self.per_time)
    }

    /// How the force of the mass grows with each coordinate [N/m].
    pub(crate) fn stiffness(&self) -> Vector {
        self.masses.map(|mass| mass * self.per_time.powi(2))
    }

    /// A journal at these coordinates, moving as the stage has it.
    pub(crate) fn moving(&self, coordinates: Coordinates, journal: &JournalState, at: Vector) -> JournalState {
        coordinates.moving(coordinates.placed(journal, at), self.velocity(at))
    }
}
