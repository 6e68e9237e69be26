//! Roelands' law: viscosity grows with a power of pressure in the exponent.

use oilwedge_reynolds::lubricant::PressureLaw as Law;
use oilwedge_reynolds::lubricant::roelands::Roelands;
use oilwedge_scene::{PressureLawTable, RoelandsExponent};

use super::{Effect, PressureRule, Socket, VISCOSITY_BY_PRESSURE, changed};
use crate::regime::beyond_pressure;

/// Pressure [Pa] of the roller contacts from which the law was read.
const LIMIT: f64 = 1.2e9;

pub(super) const ROW: Effect = Effect {
    name: "roelands",
    sentence: "viscosity grows with a power of pressure in the exponent",
    socket: Socket::Lubricant,
    kind: VISCOSITY_BY_PRESSURE,
    is_in: |scene| matches!(scene.oil.pressure_law, PressureLawTable::Roelands(_)),
    install: |scene, sockets| {
        if let PressureLawTable::Roelands(law) = scene.oil.pressure_law {
            sockets.pressure_rule = PressureRule::Roelands(law);
        }
    },
    instead: "constant viscosity",
    remove: |scene| changed(scene, |scene| scene.oil.pressure_law = PressureLawTable::Constant),
    no_proportion: Some([
        "oil.roelands",
        "makes the viscosity grow with pressure, so that forces are not in proportion to rates",
        "remove it for the characteristics",
    ]),
    warnings: |_, measured| beyond_pressure(measured, LIMIT, "Roelands' law", "nothing was measured there"),
};

impl PressureRule {
    /// The law of an oil with this viscosity [Pa.s] at no pressure.
    pub(crate) fn at(&self, viscosity: f64) -> Law {
        match self {
            Self::Fixed(law) => law.clone(),
            Self::Roelands(law) => {
                let reference = law.reference_pressure;
                let index = match law.exponent {
                    RoelandsExponent::Z(z) => z,
                    RoelandsExponent::Alpha(alpha) => Roelands::index_of(alpha, viscosity, reference),
                };
                Law::Roelands(Roelands::new(viscosity, index, reference))
            }
        }
    }
}
