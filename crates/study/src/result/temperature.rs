//! How the temperature of a film comes about, as textbooks on engines ask for it: curves that cross; and the
//! temperature across a film at its hottest place.

use oilwedge_bearing::film_heat::FilmHeat;
use oilwedge_heat::Layers;
use oilwedge_reynolds::lubricant::density::ZERO_CELSIUS;
use serde::{Deserialize, Serialize};

use super::Criterion;

/// Key of the seconds that films at other temperatures took.
pub const SECONDS_KEY: &str = "heat";

/// Friction and what carries its heat off at one temperature, by the names of the quantities in JSON.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct TemperaturePoint {
    /// Mean temperature of the film [degrees C].
    pub temperature: f64,
    /// Viscosity there [Pa.s].
    pub viscosity: f64,
    /// Power of friction [W].
    pub friction_power: f64,
    /// Heat that the oil carries off [W].
    pub heat_carried: f64,
    /// Heat that the housing gives off [W].
    pub heat_housing: f64,
    /// Eccentricity [1].
    pub eccentricity: f64,
}

impl TemperaturePoint {
    /// A point at which the oil carries off and the housing gives off these powers [W].
    pub fn removing(carried: f64, given_off: f64) -> Self {
        Self { heat_carried: carried, heat_housing: given_off, ..Self::default() }
    }

    /// What oil and housing remove together [W].
    pub fn removed(&self) -> f64 {
        self.heat_carried + self.heat_housing
    }
}

/// The heat balance of a film.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct TemperatureReport {
    /// Name of the engine whose usual values were taken; `None`: none.
    pub preset: Option<String>,
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quantities::{ECCENTRICITY, FRICTION_POWER, HEAT_CARRIED, HEAT_HOUSING};

    #[test]
    fn the_numbers_of_a_point_have_the_names_of_their_quantities() {
        let point = serde_json::to_value(TemperaturePoint::default()).expect("numbers");
        let rows = [&FRICTION_POWER, &HEAT_CARRIED, &HEAT_HOUSING, &ECCENTRICITY];
        assert!(rows.iter().all(|row| point[row.name] == 0.0), "{point}");
    }
}

/// Temperatures from the bush to the journal: of a laminar film at the points between which they are one polynomial, of
/// a turbulent one at more points, which lie dense at the walls.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct TemperatureAcross {
    /// Angle of the place [deg].
    pub angle: f64,
    /// Place along the axis, zero midway between the ends [m].
    pub z: f64,
    /// Distance of each point from the bush over the film thickness [1].
    pub eta: Vec<f64>,
    /// Temperature at each point [degrees C].
    pub temperature: Vec<f64>,
}

impl TemperatureAcross {
    /// The temperatures across the film where it is hottest, in a bearing of this length [m].
    pub fn hottest(heat: &FilmHeat, length: f64) -> Self {
        let spot = heat.hottest();
        let across = heat.temperatures.of_cell(&heat.layers, spot.cell);
        let (eta, across): (Vec<f64>, Vec<f64>) = match &heat.profiles[spot.cell].eddies {
            None => (heat.layers.points.clone(), across.to_vec()),
            Some(eddies) => eddies.places().into_iter().map(|[eta, xi]| (eta, heat.layers.at(across, xi))).unzip(),
        };
        Self {
            angle: spot.angle.to_degrees().rem_euclid(360.0),
            z: spot.along * length,
            eta,
            temperature: across.iter().map(|t| t - ZERO_CELSIUS).collect(),
        }
    }

    /// The temperature [degrees C] at a distance eta from the bush; none of points that are not those of a film.
    pub fn at(&self, eta: f64) -> Option<f64> {
        if let Some(layers) = Layers::new(self.temperature.len().checked_sub(1)?) {
            return Some(layers.at(&self.temperature, eta));
        }
        let right = self.eta.iter().position(|at| *at >= eta)?.max(1);
        let [[a, b], [from, to]] = [&self.eta, &self.temperature].map(|values| [values[right - 1], values[right]]);
        Some(from + (eta - a) / (b - a) * (to - from))
    }
}
