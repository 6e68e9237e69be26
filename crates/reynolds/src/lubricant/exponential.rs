//! # Reynolds' exponential law: viscosity falls with temperature by one constant
//!
//! **Equation.** `mu = mu_1 exp(-beta (T - T_1))`.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | mu | Pa s | `viscosity` |
//! | T | K | `temperature` |
//! | mu_1, T_1 | Pa s, K | `reference`, `at` |
//! | beta | 1/K | `rate` |
//!
//! **Source.** Reynolds, Phil. Trans. R. Soc. 177 (1886) 157, sec. 9; the law of most published thermal films.
//! **Range.** A few tens of kelvin around T_1. **Verified by** `the_law_falls_by_its_rate` below.

/// The exponential law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ExponentialLaw {
    /// Viscosity mu_1 [Pa s] at the temperature T_1.
    pub reference: f64,
    /// Temperature T_1 [K].
    pub at: f64,
    /// Relative fall of the viscosity beta [1/K].
    pub rate: f64,
}

impl ExponentialLaw {
    /// Viscosity mu [Pa s] at the temperature T [K].
    pub fn viscosity(self, temperature: f64) -> f64 {
        self.reference * (-self.rate * (temperature - self.at)).exp()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_law_falls_by_its_rate() {
        let law = ExponentialLaw { reference: 0.0277, at: 313.15, rate: 0.034 };
        assert_eq!(law.viscosity(313.15), 0.0277);
        let slope = (law.viscosity(330.01).ln() - law.viscosity(329.99).ln()) / 0.02;
        assert!((slope + 0.034).abs() < 1e-10);
    }
}
