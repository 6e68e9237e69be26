//! Barus' law: viscosity grows exponentially with pressure; where mass balance has it, or as the FlexPDE study prints
//! it.

use oilwedge_reynolds::Form;
use oilwedge_reynolds::lubricant::PressureLaw as Law;
use oilwedge_reynolds::lubricant::barus::Barus;
use oilwedge_scene::Scene;
use oilwedge_scene::{BarusForm, PressureLawTable};

use super::{BLANK, Effect, PressureRule, Socket, Sockets, VISCOSITY_BY_PRESSURE, changed};
use crate::regime::beyond_pressure;
use crate::warning;

/// Pressure [Pa] to which the law holds within some ten percent for mineral oils.
const LIMIT: f64 = 0.3e9;

pub(super) const CONSERVATIVE: Effect = Effect {
    name: "barus",
    sentence: "viscosity grows with pressure, mu0 exp(alpha p)",
    is_in: |scene| form(scene) == Some(BarusForm::Conservative),
    install,
    ..ROW
};

pub(super) const AS_PRINTED: Effect = Effect {
    name: "barus: as-printed",
    sentence: "viscosity grows with pressure, where the FlexPDE study prints it: no mass balance",
    is_in: |scene| form(scene) == Some(BarusForm::AsPrinted),
    install: |scene, sockets| {
        install(scene, sockets);
        sockets.form = Form::AsPrinted;
    },
    warnings: |film, measured| {
        let no_balance = warning::UNBALANCED.says(format!(
            "the as-printed equation is no mass balance: in and out differ by {:.2} % of the oil that enters",
            100.0 * measured.flows.imbalance
        ));
        std::iter::once(no_balance).chain((ROW.warnings)(film, measured)).collect()
    },
    ..ROW
};

const ROW: Effect = Effect {
    socket: Socket::Lubricant,
    kind: VISCOSITY_BY_PRESSURE,
    instead: "constant viscosity",
    remove: |scene| changed(scene, |scene| scene.oil.pressure_law = PressureLawTable::Constant),
    no_proportion: Some([
        "oil.barus",
        "makes the viscosity grow with pressure, so that forces are not in proportion to rates",
        "remove it for the characteristics",
    ]),
    warnings: |_, measured| {
        beyond_pressure(measured, LIMIT, "Barus' law", "it overstates the viscosity there; take roelands")
    },
    ..BLANK
};

fn form(scene: &Scene) -> Option<BarusForm> {
    match scene.oil.pressure_law {
        PressureLawTable::Barus(barus) => Some(barus.form),
        _ => None,
    }
}

fn install(scene: &Scene, sockets: &mut Sockets) {
    if let PressureLawTable::Barus(barus) = scene.oil.pressure_law {
        sockets.pressure_rule = PressureRule::Fixed(Law::Barus(Barus { alpha: barus.alpha }));
    }
}
