//! The whirl of a rigid rotor on a film whose coefficients depend on the frequency: the ratio nu that is that of the
//! threshold which K(nu) and C(nu) give.
//!
//! The zero of `omega_w^2(nu)/omega^2 - nu^2` is bracketed and found by the rule of false position (Illinois variant:
//! Dowell, Jarratt, BIT 11 (1971) 168).

use oilwedge_fem::Error;

use super::AtWhirl;
use super::rotor::threshold;

/// No whirl is sought above this many times the speed.
const HIGHEST: f64 = 4.0;
/// A whirl of half of the speed, about which oil whirls.
const HALF: f64 = 0.5;
/// The ratio is found within so much.
const ACCURACY: f64 = 1e-9;
/// Most ratios tried within a bracket.
const MOST_STEPS: usize = 30;

/// The coefficients `at` the whirl ratio of the threshold at the journal's `speed` [rad/s]; in the limit of slow
/// motions where the rotor is stable with any mass, and nothing where no ratio below [`HIGHEST`] is its own.
///
/// # Errors
/// Those of the coefficients.
pub(super) fn own_whirl(at: impl Fn(f64) -> Result<AtWhirl, Error>, speed: f64) -> Result<Option<AtWhirl>, Error> {
    let excess = |at: &AtWhirl| threshold(&at.coefficients)[1] / (speed * speed) - at.whirl * at.whirl;
    let slow = at(0.0)?;
    let mut low = (slow, excess(&slow));
    if low.1 <= 0.0 || low.1.is_nan() {
        let half = at(HALF)?;
        if excess(&half) <= 0.0 || excess(&half).is_nan() {
            return Ok(Some(slow));
        }
        low = (half, excess(&half));
    }
    let mut ratio = 1.2 * (low.1 + low.0.whirl * low.0.whirl).sqrt();
    let mut high = loop {
        let above = at(ratio)?;
        let over = excess(&above);
        match over > 0.0 {
            true if ratio >= HIGHEST => return Ok(None),
            true => (low, ratio) = ((above, over), f64::min(1.5 * ratio, HIGHEST)),
            false => break (above, over),
        }
    };
    let mut was_low = None;
    for _ in 0..MOST_STEPS {
        let between = (low.0.whirl * high.1 - high.0.whirl * low.1) / (high.1 - low.1);
        let next = at(between)?;
        let found = excess(&next);
        if high.0.whirl - low.0.whirl < ACCURACY || found.abs() < ACCURACY * between {
            return Ok(Some(next));
        }
        let is_low = found > 0.0;
        // An end that stays twice counts half, so that it does not stay for ever.
        let weight = if was_low.replace(is_low) == Some(is_low) { 0.5 } else { 1.0 };
        match is_low {
            true => (low, high.1) = ((next, found), weight * high.1),
            false => (high, low.1) = ((next, found), weight * low.1),
        }
    }
    Ok(None)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::{Coefficients, Stability, stability};

    /// A bearing whose cross stiffness, and with it the whirl, falls with the frequency.
    fn bearing(whirl: f64) -> AtWhirl {
        let cross = 2.0 - whirl;
        let mut coefficients = Coefficients { order: 2, ..Coefficients::default() };
        for d in 0..2 {
            (coefficients.stiffness[d][d], coefficients.damping[d][d]) = (1.0, 2.0);
        }
        (coefficients.stiffness[0][1], coefficients.stiffness[1][0]) = (cross, -cross);
        AtWhirl { whirl, coefficients }
    }

    /// With equal axes the whirl is `K_xy/C_xx` over the speed: `nu = (2 - nu)/(2 omega)`.
    #[test]
    fn the_whirl_is_its_own() {
        for speed in [0.4, 1.0, 3.0] {
            let found = own_whirl(|whirl| Ok(bearing(whirl)), speed).expect("solved").expect("a whirl");
            let wanted = 2.0 / (2.0 * speed + 1.0);
            assert!((found.whirl - wanted).abs() < 1e-8, "{speed}: {} {wanted}", found.whirl);
            assert!(matches!(stability(&found.coefficients), Stability::Below(_)));
        }
    }

    #[test]
    fn a_bearing_that_is_always_stable_is_judged_by_slow_motions() {
        let stable = |whirl: f64| {
            let mut at = bearing(whirl);
            (at.coefficients.stiffness[0][1], at.coefficients.stiffness[1][0]) = (0.1, 0.1);
            at
        };
        let found = own_whirl(|whirl| Ok(stable(whirl)), 1.0).expect("solved").expect("judged");
        assert_eq!((found.whirl, stability(&found.coefficients)), (0.0, Stability::Always));
    }
}
