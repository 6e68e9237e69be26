//! The socket `lubricant`: one law of pressure, at the viscosity of the film.

use oilwedge_reynolds::Form;
use oilwedge_reynolds::lubricant::barus::Barus;
use oilwedge_reynolds::lubricant::roelands::Roelands;
use oilwedge_reynolds::lubricant::{Lubricant, PressureLaw};

use crate::scene::{self, BarusForm, RoelandsExponent};

/// The oil at the temperature of the film.
pub fn lubricant(oil: &scene::Oil) -> Lubricant {
    let viscosity = oil.viscosity;
    let pressure_law = match oil.pressure_law {
        scene::PressureLaw::Constant => PressureLaw::Constant,
        scene::PressureLaw::Barus { alpha, .. } => PressureLaw::Barus(Barus { alpha }),
        scene::PressureLaw::Roelands {
            exponent,
            reference_pressure,
        } => {
            let index = match exponent {
                RoelandsExponent::Z(z) => z,
                RoelandsExponent::Alpha(alpha) => Roelands::index_of(alpha, viscosity, reference_pressure),
            };
            PressureLaw::Roelands(Roelands::new(viscosity, index, reference_pressure))
        }
    };
    Lubricant {
        viscosity,
        pressure_law,
    }
}

/// How its viscosity enters the equation.
pub fn form(oil: &scene::Oil) -> Form {
    match oil.pressure_law {
        scene::PressureLaw::Barus {
            form: BarusForm::AsPrinted,
            ..
        } => Form::AsPrinted,
        _ => Form::Conservative,
    }
}
