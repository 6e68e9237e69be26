//! # Contact of two rough surfaces
//!
//! **Equation.** `p_a = (16 sqrt 2/15) pi (eta beta sigma)^2 sqrt(sigma/beta) E' F_5/2(h/sigma)`,
//! `F_n(l) = (2 pi)^(-1/2) Int_l^inf (s - l)^n exp(-s^2/2) ds`, at most the hardness H; `dF_5/2/dl = -5/2 F_3/2`.
//!
//! With `s = l + x^2` the integral is `(2 pi)^(-1/2) Int x^6 exp(-(x^2 + l)^2/2) dx` over the whole line: analytic, so
//! that the trapezoidal rule converges geometrically. [`integral`] sums it; films use the logarithm of the sums in
//! Chebyshev polynomials, made once.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | h (gap of the mean planes) | m | `gap` |
//! | sigma (root mean square roughness of both surfaces together) | m | `roughness` |
//! | eta (asperities per area) | 1/m2 | `density` is `eta beta sigma` |
//! | beta (radius of the tips of asperities) | m | `sharpness` is `sigma/beta` |
//! | E' (`1/E' = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2`) | Pa | `modulus` |
//! | H | Pa | `hardness` |
//!
//! **Source.** Greenwood, Tripp, Proc. Instn. Mech. Engrs. 185 (1970) 625; F_5/2 exactly, not by the power law
//! `4.4086e-5 (4 - l)^6.804`, which is 11 % low at l = 0 and 98 % at 3.5. **Range.** Gaussian heights, elastic
//! asperities; the cap stands for those that yield. **Verified by** `the_integral_is_exact`, `tests/tests/contact`.

use std::f64::consts::{PI, SQRT_2};
use std::ops::Range;
use std::sync::LazyLock;

use super::{ContactLaw, ContactPressure};
use crate::chebyshev::Piecewise;

/// Where the logarithm of F_5/2 is made of polynomials: beyond its end the pressure is below 1e-33 of `E'`, and none.
const FROM: f64 = -4.0;
/// End of that interval.
const TO: f64 = 12.0;
/// Pieces of it.
const PIECES: usize = 128;

static LOGARITHM: LazyLock<Piecewise> = LazyLock::new(|| Piecewise::new(FROM, TO, PIECES, |l| integral(5, l).ln()));

/// `F_(n/2)(l)` for odd `n`, by the trapezoidal rule, to round-off.
pub fn integral(n: i32, l: f64) -> f64 {
    /// Steps over the width of the integrand where that is a narrow peak.
    const STEPS: f64 = 8.0;
    // At the end x^2 + l is nine standard deviations.
    let end = (9.0 - l.min(0.0)).sqrt();
    let steps = (STEPS * end * end).ceil();
    let step = end / steps;
    let at = |k: u32| {
        let x = step * f64::from(k);
        // Even in x, for n + 1 is even.
        x.powi(n + 1) * (-0.5 * (x * x + l).powi(2)).exp()
    };
    let sum: f64 = (1..=steps as u32).map(at).sum();
    2.0 * step * sum / (2.0 * PI).sqrt()
}

/// Asperities of Gaussian heights.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GreenwoodTripp {
    /// Combined roughness sigma [m].
    roughness: f64,
    /// Hardness [Pa].
    hardness: f64,
    /// `(16 sqrt 2/15) pi (eta beta sigma)^2 sqrt(sigma/beta) E'` [Pa].
    factor: f64,
    /// `h/sigma` at which the pressure is the hardness; minus infinity where it never is.
    yields_at: f64,
}

impl GreenwoodTripp {
    /// A contact of a combined roughness sigma [m], `eta beta sigma` [1], `sigma/beta` [1], the modulus E' [Pa] and the
    /// hardness [Pa], all positive.
    pub fn new(roughness: f64, density: f64, sharpness: f64, modulus: f64, hardness: f64) -> Self {
        let factor = 16.0 * SQRT_2 / 15.0 * PI * density.powi(2) * sharpness.sqrt() * modulus;
        Self { roughness, hardness, factor, yields_at: ratio_of(hardness / factor) }
    }
}

impl ContactLaw for GreenwoodTripp {
    fn at(&self, gap: f64) -> ContactPressure {
        let l = gap / self.roughness;
        if l <= self.yields_at {
            return ContactPressure { pressure: self.hardness, slope: 0.0 };
        }
        if l >= TO {
            return ContactPressure::default();
        }
        if l < FROM {
            return ContactPressure {
                pressure: self.factor * integral(5, l),
                slope: -2.5 * self.factor * integral(3, l) / self.roughness,
            };
        }
        let [logarithm, slope] = LOGARITHM.at(l);
        let pressure = self.factor * logarithm.exp();
        ContactPressure { pressure, slope: pressure * slope / self.roughness }
    }

    fn reach(&self) -> f64 {
        TO * self.roughness
    }

    fn scale(&self) -> f64 {
        self.roughness
    }

    fn has_kink_in(&self, gaps: Range<f64>) -> bool {
        gaps.contains(&(self.yields_at * self.roughness))
    }

    fn hardness(&self) -> f64 {
        self.hardness
    }
}

/// Where F_5/2, which falls with l, has this value, which is positive; minus infinity where that is far below any film.
fn ratio_of(value: f64) -> f64 {
    /// Farthest `h/sigma` below the mean planes that is searched.
    const FARTHEST: f64 = -1e3;
    const HALVINGS: usize = 80;
    if integral(5, FARTHEST) < value {
        return f64::NEG_INFINITY;
    }
    let (mut low, mut high) = (FARTHEST, TO);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        match integral(5, middle) > value {
            true => low = middle,
            false => high = middle,
        }
    }
    low
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `Int_0^inf t^n exp(-(t + l)^2/2) dt / sqrt(2 pi)` by the double exponential substitution `t = exp(u - exp(-u))`
    /// (Takahasi, Mori, Publ. RIMS 9 (1974) 721).
    fn double_exponential(n: f64, l: f64) -> f64 {
        let step = 1.0 / 256.0;
        let at = |k: i32| {
            let u = step * f64::from(k);
            let t = (u - (-u).exp()).exp();
            t.powf(n + 1.0) * (1.0 + (-u).exp()) * (-0.5 * (t + l).powi(2)).exp()
        };
        step * (-1500..1500).map(at).sum::<f64>() / (2.0 * PI).sqrt()
    }

    #[test]
    fn the_integral_is_exact() {
        // E[s^(5/2)] of the positive half of a Gaussian is 2^(5/4) Gamma(7/4)/(2 sqrt pi).
        let at_zero = 2f64.powf(1.25) * 0.919_062_526_848_883_2 / (2.0 * PI.sqrt());
        assert!((integral(5, 0.0) / at_zero - 1.0).abs() < 1e-14, "{}", integral(5, 0.0));
        for k in 0..=80 {
            let l = -2.0 + 0.1 * f64::from(k);
            for n in [3, 5] {
                let ratio = integral(n, l) / double_exponential(0.5 * f64::from(n), l);
                assert!((ratio - 1.0).abs() < 1e-12, "F_{n}/2({l}): {ratio}");
            }
        }
    }

    #[test]
    fn the_expansion_is_the_integral() {
        // A factor of one, and no cap.
        let law = GreenwoodTripp { roughness: 1.0, hardness: f64::INFINITY, factor: 1.0, yields_at: f64::NEG_INFINITY };
        for k in 0..=1600 {
            let l = -4.5 + 0.01 * f64::from(k);
            let ContactPressure { pressure, slope } = law.at(l);
            assert!((pressure / integral(5, l) - 1.0).abs() < 1e-12, "{l}: {pressure:e}");
            assert!((slope / (-2.5 * integral(3, l)) - 1.0).abs() < 1e-10, "{l}: {slope:e}");
        }
    }

    #[test]
    fn the_cap_begins_where_the_hardness_is_reached() {
        let law = GreenwoodTripp::new(6e-7, 0.05, 0.01, 115e9, 3e8);
        let (above, below) = (law.yields_at + 1e-9, law.yields_at - 1e-9);
        assert!(law.at(below * law.roughness).pressure == 3e8);
        assert!((law.at(above * law.roughness).pressure / 3e8 - 1.0).abs() < 1e-8);
    }
}
