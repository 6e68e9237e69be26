//! # Density: oil expands with temperature
//!
//! **Equation.** `rho = rho_20 [1 - k_v (T - 293.15 K)]`.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | rho_20 | kg/m3 | `at_20` |
//! | k_v | 1/K | `expansion` |
//! | T | K | `temperature` |
//!
//! **Source.** Textbooks on engine design, k_v = 68.8e-5 1/K for engine oils; ISO 91 (petroleum measurement tables) is
//! finer by some 0.1 %.
//! **Range.** Liquid oil, some 0 to 150 degrees C; pressure is left out (1 % at 20 MPa). **Verified by**
//! `a_density_at_15_is_given_back`.

/// Temperature [K] of the ice point.
pub const ZERO_CELSIUS: f64 = 273.15;
/// Relative expansion [1/K] of mineral engine oils.
pub const EXPANSION: f64 = 68.8e-5;
/// Density [kg/m3] of a mineral oil of which nothing is known.
pub const MINERAL_OIL: f64 = 870.0;

/// Density by temperature.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Density {
    /// Density rho_20 [kg/m3] at 20 degrees C.
    pub at_20: f64,
    /// Relative expansion k_v [1/K].
    pub expansion: f64,
}

impl Density {
    /// The density of an oil of this density [kg/m3] at the temperature [K].
    pub fn of(density: f64, temperature: f64, expansion: f64) -> Self {
        let at_20 = density / (1.0 - expansion * (temperature - ZERO_CELSIUS - 20.0));
        Self { at_20, expansion }
    }

    /// Density rho [kg/m3] at the temperature T [K].
    pub fn at(self, temperature: f64) -> f64 {
        self.at_20 * (1.0 - self.expansion * (temperature - ZERO_CELSIUS - 20.0))
    }
}

impl Default for Density {
    fn default() -> Self {
        Self { at_20: MINERAL_OIL, expansion: EXPANSION }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_density_at_15_is_given_back() {
        let density = Density::of(868.0, ZERO_CELSIUS + 15.0, EXPANSION);
        assert!((density.at(ZERO_CELSIUS + 15.0) - 868.0).abs() < 1e-12);
        assert!(density.at_20 < 868.0);
        // 1 - 68.8e-5 80, as printed for an oil at 100 degrees C.
        assert!((density.at(ZERO_CELSIUS + 100.0) / density.at_20 - 0.94496).abs() < 1e-12);
    }
}
