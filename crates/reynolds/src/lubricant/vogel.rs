//! # Vogel: viscosity falls with temperature by three constants
//!
//! **Equation.** `mu = a exp(b/(t + c))`, t in degrees C; with the temperature T in K `mu = a exp(b/(T - T_0))`,
//! `T_0 = 273.15 K - c`.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | mu | Pa s | `viscosity` |
//! | T | K | `temperature` |
//! | a | Pa s | `factor` |
//! | b | K | `exponent` |
//! | T_0 | K | `singular` |
//!
//! **Source.** Vogel, Physik. Z. 22 (1921) 645; in this form Cameron, The Principles of Lubrication (1966), c = 95 K
//! for mineral oils.
//! **Range.** T well above T_0, where the law has no meaning. **Verified by** `the_law_falls_towards_its_factor` and
//! `through_three_points` below.

/// Vogel's law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Vogel {
    /// Viscosity a [Pa s] at infinite temperature, positive.
    pub factor: f64,
    /// Constant b [K], not negative.
    pub exponent: f64,
    /// Temperature T_0 [K] at which the law has no meaning any more.
    pub singular: f64,
}

impl Vogel {
    /// Viscosity mu [Pa s] at the temperature T [K], above T_0; not a number below it.
    pub fn viscosity(self, temperature: f64) -> f64 {
        match temperature > self.singular {
            true => self.factor * (self.exponent / (temperature - self.singular)).exp(),
            false => f64::NAN,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_law_falls_towards_its_factor() {
        let law = Vogel { factor: 5e-5, exponent: 1000.0, singular: 178.15 };
        let mut last = f64::INFINITY;
        for temperature in [250.0, 300.0, 350.0, 400.0, 1e3, 1e6] {
            let viscosity = law.viscosity(temperature);
            assert!(viscosity < last && viscosity > law.factor);
            last = viscosity;
        }
        assert!((law.viscosity(1e12) / law.factor - 1.0).abs() < 1e-8);
        assert!(law.viscosity(178.15).is_nan());
        let constant = Vogel { exponent: 0.0, ..law };
        assert_eq!(constant.viscosity(300.0), constant.factor);
    }

    /// The formula `ln mu = ln a + b/(T - T_0)` at three points gives a, b and T_0 back.
    #[test]
    fn through_three_points() {
        let law = Vogel { factor: 7e-5, exponent: 900.0, singular: 180.0 };
        let [x, y, z] = [313.15, 343.15, 373.15f64];
        let logs = [x, y, z].map(|t| law.viscosity(t).ln());
        let ratio = (logs[0] - logs[1]) / (logs[1] - logs[2]);
        // (y - x)(z - T_0) = ratio (z - y)(x - T_0)
        let singular = ((y - x) * z - ratio * (z - y) * x) / ((y - x) - ratio * (z - y));
        assert!((singular - 180.0).abs() < 1e-9, "{singular}");
    }
}
