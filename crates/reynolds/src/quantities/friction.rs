//! # Friction: the torque that turns the journal
//!
//! **Equation.** On the journal `T = R Int (theta mu U/h + h/2 dp/dx) dA`, on the bearing
//! `T_b = R Int (theta mu U/h - h/2 dp/dx) dA`; where the viscosity varies across the film, [`crate::ViscosityAcross`]
//! has the parts of h that stand for h/2; on a ring of one film `T - T_b = W_y e_x - W_x e_y`, the moment of the
//! load about the bearing's centre. `f = T/(R W)`.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | T, T_b | N m | `on_journal`, `on_bearing` |
//! | T omega | W | [`Power::friction`] |
//! | f | 1 | `coefficient` |
//!
//! Contact adds `R mu_b Int p_a dA` to both ([`super::contact`]).
//!
//! **Source.** Raimondi, Boyd, Trans. ASLE 1 (1958) 159: the drag of the whole film, cavity included. **Range.** A
//! turning journal; the torque is positive against the rotation. **Verified by** `tests/tests/friction.rs`.

use super::power::Power;
use crate::{Bearing, JournalState};

/// Torques [N m] against the rotation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Friction {
    /// Torque on the journal.
    pub on_journal: f64,
    /// Torque on the bearing.
    pub on_bearing: f64,
}

/// Friction of a film with these powers; none at rest.
pub fn friction(journal: &JournalState, power: &Power) -> Option<Friction> {
    let speed = journal.speed.abs();
    (speed > 0.0).then(|| Friction {
        on_journal: power.friction() / speed,
        on_bearing: (power.shear - power.pressure + 2.0 * power.uneven + power.contact) / speed,
    })
}

impl Friction {
    /// Coefficient of friction f under the load `force` [N].
    pub fn coefficient(&self, bearing: &Bearing, force: f64) -> f64 {
        self.on_journal / (bearing.radius * force)
    }
}
