//! # Saturating viscosity: that of trial films
//!
//! **Equation.** Up to the pressure p_s the viscosity mu of another law; above it `mu = r mu0`, so that
//! `p = p_s + r (q - q_s)`.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | r = mu(p_s)/mu0 | - | [`GREATEST_RATIO`] |
//! | p_s, q_s = q(p_s) | Pa | `pressure`, `reduced` |
//!
//! A search for the position of a journal tries films beyond the limit of the viscosity law. Here they have a pressure,
//! by which the search finds back. No oil is like that: what a search has found counts by the law itself. Up to q_s
//! both are one; with Barus' law q_s is `(1 - 1/r)` times its limit.
//!
//! **Source.** A device of this program. **Range.** Films that are tried, not reported. **Verified by** the tests of
//! `lubricant`.

use super::{PressureLaw, PressureViscosity};

/// Viscosity at which it saturates, over mu0 [1]. Films that are accepted end there: with Barus' law at a reduced
/// pressure 1e-4 below its limit. Other values were not tried.
const GREATEST_RATIO: f64 = 1e4;

/// A law whose viscosity saturates.
#[derive(Debug, Clone, PartialEq)]
pub struct Saturating {
    law: Box<PressureLaw>,
    /// Pressure [Pa] at which it saturates.
    pressure: f64,
    /// Reduced pressure [Pa] at which it saturates.
    reduced: f64,
}

impl Saturating {
    /// The saturating law beside a law; `None` where the law does not reach this viscosity.
    pub(super) fn of(law: &PressureLaw) -> Option<Self> {
        let pressure = law.pressure_of_ratio(GREATEST_RATIO);
        let reduced = law.reduced_pressure(pressure);
        pressure.is_finite().then(|| Self { law: Box::new(law.clone()), pressure, reduced })
    }

    /// Whether it is the law itself up to this reduced pressure [Pa].
    pub(crate) fn is_exact(&self, reduced: f64) -> bool {
        reduced <= self.reduced
    }
}

impl PressureViscosity for Saturating {
    fn viscosity_ratio(&self, p: f64) -> f64 {
        if p < self.pressure { self.law.viscosity_ratio(p) } else { GREATEST_RATIO }
    }

    fn viscosity_slope(&self, p: f64) -> f64 {
        if p < self.pressure { self.law.viscosity_slope(p) } else { 0.0 }
    }

    fn reduced_pressure(&self, p: f64) -> f64 {
        match p < self.pressure {
            true => self.law.reduced_pressure(p),
            false => self.reduced + (p - self.pressure) / GREATEST_RATIO,
        }
    }

    fn pressure(&self, q: f64) -> f64 {
        match q < self.reduced {
            true => self.law.pressure(q),
            false => self.pressure + (q - self.reduced) * GREATEST_RATIO,
        }
    }

    fn pressure_of_ratio(&self, ratio: f64) -> f64 {
        if ratio < GREATEST_RATIO { self.law.pressure_of_ratio(ratio) } else { f64::INFINITY }
    }

    fn floor(&self) -> f64 {
        self.law.floor()
    }
}

#[cfg(test)]
mod tests {
    use super::super::barus::Barus;
    use super::super::roelands::Roelands;
    use super::*;

    #[test]
    fn it_is_the_law_below_its_end_and_has_a_pressure_above_the_limit() {
        for law in
            [PressureLaw::Barus(Barus { alpha: 2.5e-8 }), PressureLaw::Roelands(Roelands::new(0.04, 0.6, 196.2e6))]
        {
            let saturating = Saturating::of(&law).expect("a law that grows");
            super::super::check(&saturating);
            let end = saturating.pressure;
            assert!((law.viscosity_ratio(end) / GREATEST_RATIO - 1.0).abs() < 1e-12, "{law:?}");
            assert!(saturating.reduced < law.limit() && saturating.reduced > 0.99 * law.limit(), "{law:?}");
            for p in [-1e7, 0.0, 5e7, 0.999 * end] {
                assert_eq!(saturating.reduced_pressure(p), law.reduced_pressure(p));
                assert_eq!(saturating.viscosity_ratio(p), law.viscosity_ratio(p));
            }
            let beyond = 2.0 * law.limit();
            let p = saturating.pressure(beyond);
            assert!((saturating.reduced_pressure(p) / beyond - 1.0).abs() < 1e-12, "{p}");
        }
    }

    #[test]
    fn a_law_that_does_not_grow_stays() {
        let constant = [PressureLaw::Constant, PressureLaw::Barus(Barus { alpha: 0.0 })];
        assert!(constant.iter().all(|law| Saturating::of(law).is_none() && law.saturating() == *law));
    }
}
