//! How the temperature of a film comes about, as textbooks on engines ask for it: curves that cross.

use serde::{Serialize, Serializer};

use super::Criterion;
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
    /// Writes the numbers as a map by the names of the quantities.
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
    /// Whether all that decides passes.
    pub is_fit: bool,
    /// Assumptions of the film that do not hold, each with a warning: a verdict stands under their reserve.
    pub broken_assumptions: usize,
}
