//! The oil of a film at the temperature of the film.

use oilwedge_reynolds::lubricant::density::ZERO_CELSIUS;
use oilwedge_reynolds::lubricant::{Density, ThermalOil};

/// The film's temperature is first taken to be so much above that of the oil fed [K].
const FIRST_RISE: f64 = 10.0;

/// An oil at one temperature.
#[derive(Debug, Clone, PartialEq)]
pub struct Oil {
    /// Dynamic viscosity mu0 at gauge pressure zero [Pa.s].
    pub viscosity: f64,
    /// Temperature of the film [K]; `None` where nothing depends on it.
    pub temperature: Option<f64>,
    /// Viscosity and density by temperature; `None`: there is one viscosity.
    pub thermal: Option<ThermalOil>,
    /// Density, where the scene or its grade gives it.
    pub density: Option<Density>,
    /// The multigrade oil that it is, where what high shear leaves of its viscosity is not given.
    pub unsheared: Option<&'static str>,
}

impl Oil {
    /// The oil at this temperature [K]; an oil whose viscosity does not depend on it as it is.
    pub fn at(&self, temperature: f64) -> Self {
        let Some(thermal) = &self.thermal else {
            return self.clone();
        };
        Self { viscosity: thermal.viscosity(temperature), temperature: Some(temperature), ..self.clone() }
    }

    /// Density [kg/m3] at the temperature of the film, 20 degrees C where there is none; `None` where it is not known.
    pub fn film_density(&self) -> Option<f64> {
        let temperature = self.temperature.unwrap_or(ZERO_CELSIUS + 20.0);
        self.density.map(|density| density.at(temperature))
    }
}

/// Temperature [K] at which the search for that of a film begins; `inlet` [K] is that of the oil fed.
pub fn first_temperature(inlet: f64) -> f64 {
    inlet + FIRST_RISE
}
