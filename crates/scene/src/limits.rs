//! `[limits]`: the engineering limits of a bearing. A result that exceeds one has a warning, or a criterion of the heat balance that is not met.

use crate::reader::TableReader;
use crate::unit::Dimension;
use crate::{Complaints, Scene};

keys! {
    "limits" = Table; "", "no limits; with `[heat]` its defaults", "",
        "what the bearing must keep; nothing is computed with it";
    "limits.film_min" = Quantity(Length); "4 um", "no limit; with `[heat]` 4 um", "> 0",
        "the film must be thicker than this everywhere";
    "limits.temperature_max" = Quantity(Temperature); "115 C", "no limit; with `[heat]` 115 C", "-60 to 350 C, where the film has a temperature",
        "the temperature of the film must stay below this";
    "limits.outlet_max" = Quantity(Temperature); "125 C", "no limit; with `[heat]` 125 C", "-60 to 350 C, with `[heat]`",
        "the temperature of the oil that leaves must stay below this; 125 C is the greatest that ISO 7902-3 permits";
    "limits.pressure_max" = Quantity(Pressure); "600 bar", "no limit", "> 0",
        "the pressure must stay below this everywhere";
}

/// Limits that a bearing must keep; `None`: there is no such limit.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Limits {
    /// Least film thickness that is admissible [m].
    pub least_film: Option<f64>,
    /// Mean temperature of the film that must not be reached [K].
    pub greatest_temperature: Option<f64>,
    /// Temperature of the oil that leaves, which must not be reached [K].
    pub greatest_outlet: Option<f64>,
    /// Greatest pressure that is admissible [Pa].
    pub greatest_pressure: Option<f64>,
}

impl Limits {
    /// These limits, and those of `other` where there are none.
    pub(crate) fn or(self, other: Self) -> Self {
        Self {
            least_film: self.least_film.or(other.least_film),
            greatest_temperature: self.greatest_temperature.or(other.greatest_temperature),
            greatest_outlet: self.greatest_outlet.or(other.greatest_outlet),
            greatest_pressure: self.greatest_pressure.or(other.greatest_pressure),
        }
    }
}

pub(crate) fn read(mut table: TableReader<'_>) -> Limits {
    Limits {
        greatest_pressure: table.positive_if_given("pressure_max", Dimension::Pressure, "600 bar"),
        ..read_old(&mut table)
    }
}

/// The keys that may also stand in `[heat]`.
pub(crate) fn read_old(table: &mut TableReader<'_>) -> Limits {
    Limits {
        least_film: table.positive_if_given("film_min", Dimension::Length, "4 um"),
        greatest_temperature: table.oil_temperature("temperature_max", "115 C").given(),
        greatest_outlet: table.oil_temperature("outlet_max", "125 C").given(),
        greatest_pressure: None,
    }
}

/// A limit of the temperature has something to be compared with.
pub(crate) fn check(scene: &Scene, complaints: &mut Complaints) {
    complaints.refuse_if(
        complaints.has("limits.temperature_max") && scene.given_temperature().is_none(),
        "limits.temperature_max",
        "has nothing to be compared with: the film of this scene has no temperature",
        "add [heat], which finds it, or give oil.temperature with a law of temperature; or remove the limit",
    );
    complaints.refuse_if(
        complaints.has("limits.outlet_max") && scene.inlet_temperature().is_none(),
        "limits.outlet_max",
        "has nothing to be compared with: without [heat] the oil leaves as warm as it enters",
        "add [heat], which finds the temperature, or remove the limit",
    );
}
