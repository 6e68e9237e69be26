//! Where rough surfaces touch: the pressure of contact as a function of the gap, one law a file, and the friction that
//! it makes.
//!
//! Contact is no term of Reynolds' equation: it adds to what the film carries and to what turns the journal, over the
//! whole liner, in cavities and at the ends too ([`crate::quantities::contact`]).

pub mod bearing_curve;
pub mod greenwood_tripp;

pub use bearing_curve::BearingCurve;
pub use greenwood_tripp::GreenwoodTripp;

use std::fmt::Debug;
use std::ops::Range;
use std::sync::Arc;

/// A pressure of contact and its derivative by the gap.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct ContactPressure {
    /// `p_a` [Pa], from zero to the hardness.
    pub pressure: f64,
    /// `dp_a/dh` [Pa/m], nowhere positive.
    pub slope: f64,
}

/// How the pressure of contact depends on the gap.
pub trait ContactLaw: Debug + Send + Sync {
    /// Pressure of contact at the gap `h` [m] between the mean planes of the surfaces.
    fn at(&self, gap: f64) -> ContactPressure;

    /// Gap [m] from which on there is no contact.
    fn reach(&self) -> f64;

    /// Change of the gap [m] over which the pressure of contact is nearly a polynomial.
    fn scale(&self) -> f64;

    /// Whether the curvature of the pressure jumps at a gap [m] between these two.
    fn has_kink_in(&self, gaps: Range<f64>) -> bool;

    /// Greatest pressure of contact [Pa].
    fn hardness(&self) -> f64;
}

/// Contact of journal and liner.
#[derive(Debug, Clone)]
pub struct Contact {
    /// The pressure of contact.
    pub law: Arc<dyn ContactLaw>,
    /// Friction coefficient mu_b of surfaces that touch [1].
    pub friction: f64,
    /// How finely it is integrated.
    pub fineness: Fineness,
}

/// How finely a pressure of contact is integrated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fineness {
    /// Fine enough for numbers that are reported: to about 1e-10 of the hardness.
    Reported,
    /// Fine enough for places on the way to a balance: to about 1e-6 of the hardness.
    Tried,
}

#[cfg(test)]
mod tests {
    use super::*;

    const LAWS: fn() -> [Box<dyn ContactLaw>; 2] = || {
        [
            Box::new(GreenwoodTripp::new(6e-7, 0.05, 0.01, 115e9, 1e9)),
            Box::new(BearingCurve { depth: 1.2e-6, hardness: 9e8 }),
        ]
    };

    #[test]
    fn slopes_are_derivatives_and_never_positive() {
        for law in LAWS() {
            for k in 0..60 {
                let gap = 0.02e-6 + 0.06e-6 * f64::from(k);
                let step = 1e-4 * law.scale();
                let (ahead, behind) = (law.at(gap + step).pressure, law.at(gap - step).pressure);
                let (slope, difference) = (law.at(gap).slope, (ahead - behind) / (2.0 * step));
                assert!(slope <= 0.0);
                let bend = 1e-6 * law.at(gap).pressure / law.scale() + 1e-8 * law.hardness() / law.scale();
                assert!((slope - difference).abs() < bend, "{law:?} {gap:e}: {slope:e} {difference:e}");
            }
        }
    }

    #[test]
    fn pressures_end_at_the_hardness_and_at_the_reach() {
        for law in LAWS() {
            let cap = ContactPressure { pressure: law.hardness(), slope: 0.0 };
            for gap in [-1e-3, -1e-5] {
                assert_eq!(law.at(gap), cap, "{law:?}");
            }
            for gap in [law.reach(), 1.0, f64::INFINITY] {
                assert_eq!(law.at(gap), ContactPressure::default(), "{law:?}");
            }
            let nearly = law.at(0.999 * law.reach()).pressure;
            assert!(nearly > 0.0 && nearly < 1e-5 * law.hardness(), "{nearly:e}");
        }
    }
}
