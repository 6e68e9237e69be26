//! The oil of a scene: its viscosity, by pressure and by temperature, and its density.

use oilwedge_reynolds::lubricant::density::ZERO_CELSIUS;
use oilwedge_reynolds::lubricant::{Density, ThermalOil};

/// The oil.
#[derive(Debug, Clone, PartialEq)]
pub struct Oil {
    /// Dynamic viscosity mu0 at gauge pressure zero [Pa.s]: the one given, or that of `thermal` at the temperature of the film.
    pub viscosity: f64,
    /// How the viscosity depends on pressure.
    pub pressure_law: PressureLaw,
    /// How it depends on temperature; `None`: there is one viscosity.
    pub thermal: Option<ThermalOil>,
    /// Temperature of the film [K], where the scene gives it.
    pub temperature: Option<f64>,
    /// Density, where the scene or its grade tells.
    pub density: Option<Density>,
}

impl Oil {
    /// Density [kg/m3] at the temperature of the film, 20 degrees C where there is none; `None` where the scene does not tell.
    pub fn film_density(&self) -> Option<f64> {
        let temperature = self.temperature.unwrap_or(ZERO_CELSIUS + 20.0);
        self.density.map(|density| density.at(temperature))
    }
}

/// How the viscosity depends on pressure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PressureLaw {
    /// mu = mu0.
    Constant,
    /// mu = mu0 exp(alpha p).
    Barus {
        /// Pressure-viscosity coefficient alpha [1/Pa], not negative.
        alpha: f64,
        /// Which equation is solved.
        form: BarusForm,
    },
    /// mu = mu0 exp((ln mu0 + 9.67) ((1 + p/p_r)^z - 1)), mu0 in Pa.s.
    Roelands {
        /// The exponent, directly or by the slope at zero pressure.
        exponent: RoelandsExponent,
        /// Reference pressure p_r [Pa].
        reference_pressure: f64,
    },
}

impl PressureLaw {
    /// Name among the effects of a report; `None` where the viscosity is constant.
    pub fn name(&self) -> Option<&'static str> {
        match self {
            Self::Constant => None,
            Self::Barus {
                form: BarusForm::Conservative,
                ..
            } => Some("barus"),
            Self::Barus {
                form: BarusForm::AsPrinted,
                ..
            } => Some("barus: as-printed"),
            Self::Roelands { .. } => Some("roelands"),
        }
    }
}

/// Where the viscosity stands in Reynolds' equation with Barus' law.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum BarusForm {
    /// Under the divergence: a balance of mass.
    #[default]
    Conservative,
    /// On the right-hand side, div(h^3 grad p) = 12 mu(p) (...), as the FlexPDE study prints it.
    AsPrinted,
}

/// How steep Roelands' law is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RoelandsExponent {
    /// Roelands' exponent z [1], not negative.
    Z(f64),
    /// Pressure-viscosity coefficient at zero pressure alpha [1/Pa], not negative: z = alpha p_r/(ln mu0 + 9.67).
    Alpha(f64),
}

impl Oil {
    /// Brings the oil to this temperature [K]; one whose viscosity does not depend on it stays as it is.
    pub fn heat_to(&mut self, temperature: f64) {
        if let Some(thermal) = &self.thermal {
            self.viscosity = thermal.viscosity(temperature);
            self.temperature = Some(temperature);
        }
    }
}
