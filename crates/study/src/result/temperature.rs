//! How the temperature of a film comes about, as textbooks on engines ask for it: curves that cross, and criteria.

use oilwedge_reynolds::existence::readable;
use serde::{Serialize, Serializer};

use crate::quantities::{ECCENTRICITY, FRICTION_POWER, HEAT_CARRIED, HEAT_HOUSING};

/// Key of the seconds that films at other temperatures took.
pub const SECONDS_KEY: &str = "heat";

/// Friction and what carries its heat off at one temperature.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TemperaturePoint {
    /// Mean temperature of the film [degrees C].
    pub temperature: f64,
    /// Viscosity there [Pa.s].
    pub viscosity: f64,
    /// Power of friction [W].
    pub friction_power: f64,
    /// Heat that the oil carries off [W].
    pub carried: f64,
    /// Heat that the housing gives off [W].
    pub given_off: f64,
    /// Eccentricity [1].
    pub eccentricity: f64,
}

impl Serialize for TemperaturePoint {
    /// By the names of the quantities.
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map([
            ("temperature", self.temperature),
            ("viscosity", self.viscosity),
            (FRICTION_POWER.name, self.friction_power),
            (HEAT_CARRIED.name, self.carried),
            (HEAT_HOUSING.name, self.given_off),
            (ECCENTRICITY.name, self.eccentricity),
        ])
    }
}

/// What a bearing must meet.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Criterion {
    /// What is asked, in words.
    pub what: String,
    /// The value found, in `unit`.
    pub value: f64,
    /// From which value on it is met; `None`: there is no such bound.
    pub least: Option<f64>,
    /// Up to which value.
    pub most: Option<f64>,
    /// Unit of all three, one that people read.
    pub unit: String,
    /// Whether the bearing is refused where it is not met; else it is only unusual.
    pub decides: bool,
    /// Whether it is met.
    pub is_met: bool,
}

impl Criterion {
    /// `value` must lie between `least` and `most`; a limit that `decides` is not met by itself.
    pub fn new(what: &str, unit: &str, value: f64, limits: [Option<f64>; 2], decides: bool) -> Self {
        // What is given to a few digits may be off by rounding.
        let room = if decides { -1e-9 } else { 1e-9 } * value.abs();
        let [least, most] = limits.map(|limit| Some(format!("{:.11e}", limit?).parse().unwrap_or(limit?)));
        Self {
            what: what.to_owned(),
            value,
            least,
            most,
            unit: unit.to_owned(),
            decides,
            is_met: least.is_none_or(|least| value >= least - room) && most.is_none_or(|most| value <= most + room),
        }
    }
}

impl Criterion {
    /// How it is missed: `thinnest film below 4 um`.
    pub fn fault(&self) -> String {
        let (side, bound) = match (self.least, self.most) {
            (Some(least), _) if self.value <= least => ("below", least),
            (_, Some(most)) => ("above", most),
            (least, None) => ("below", least.unwrap_or(self.value)),
        };
        format!("{} {side} {} {}", self.what, readable(bound), self.unit)
    }

    /// True if the bearing is refused for it.
    pub fn is_missed(&self) -> bool {
        self.decides && !self.is_met
    }
}

/// The heat balance of a film.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct TemperatureReport {
    /// Name of the engine whose usual values were taken; `None`: none.
    pub preset: Option<&'static str>,
    /// Temperature of the oil that is fed [degrees C].
    pub inlet_temperature: f64,
    /// Heat capacity per volume [J/(m3 K)].
    pub heat_capacity: f64,
    /// Specific load, load over projected area [Pa].
    pub specific_load: f64,
    /// Films at temperatures around that of the balance, ascending; where there is no film there is no point.
    pub curve: Vec<TemperaturePoint>,
    /// What the bearing must meet, and what is usual.
    pub criteria: Vec<Criterion>,
    /// Whether all that decides is met.
    pub is_fit: bool,
    /// Assumptions of the film that do not hold, each with a warning: a verdict stands under their reserve.
    pub broken_assumptions: usize,
}
