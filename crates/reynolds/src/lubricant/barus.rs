//! # Barus: viscosity grows exponentially with pressure
//!
//! **Equation.** `mu = mu0 exp(alpha p)`; `q = (1 - exp(-alpha p))/alpha`, `p = -ln(1 - alpha q)/alpha`.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | alpha | 1/Pa | `alpha` |
//! | p, q | Pa | `p`, `q` |
//!
//! **Source.** Barus, Am. J. Sci. 45 (1893) 87. **Range.** Up to some 100 MPa; a film exists only
//! while `alpha max q < 1`. **Verified by** `alpha_zero_is_constant`, the tests of `lubricant`, and
//! the reference of the FlexPDE study.

use super::PressureViscosity;

/// Pressure-viscosity coefficient.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Barus {
    /// Coefficient alpha [1/Pa], not negative.
    pub alpha: f64,
}

impl PressureViscosity for Barus {
    fn viscosity_ratio(&self, p: f64) -> f64 {
        (self.alpha * p).exp()
    }

    fn viscosity_slope(&self, p: f64) -> f64 {
        self.alpha * self.viscosity_ratio(p)
    }

    fn reduced_pressure(&self, p: f64) -> f64 {
        if self.alpha == 0.0 { p } else { -(-self.alpha * p).exp_m1() / self.alpha }
    }

    fn pressure(&self, q: f64) -> f64 {
        if self.alpha == 0.0 {
            q
        } else if self.alpha * q < 1.0 {
            -(-self.alpha * q).ln_1p() / self.alpha
        } else {
            f64::INFINITY
        }
    }

    fn pressure_of_ratio(&self, ratio: f64) -> f64 {
        ratio.ln() / self.alpha
    }

    fn limit(&self) -> f64 {
        1.0 / self.alpha
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reduced_pressure_inverts_and_slopes_match() {
        super::super::check(&Barus { alpha: 2.5e-8 });
    }

    #[test]
    fn alpha_zero_is_constant() {
        let law = Barus { alpha: 0.0 };
        assert_eq!((law.viscosity_ratio(1e9), law.reduced_pressure(3e6), law.pressure(3e6)), (1.0, 3e6, 3e6));
        assert_eq!(law.limit(), f64::INFINITY);
        let tiny = Barus { alpha: 1e-20 };
        assert!((tiny.pressure(3e6) - 3e6).abs() < 1e-6);
    }
}
