//! # Contact of a tilted journal by the bearing curve
//!
//! **Equation.** The gap `h = c - (e + g z) cos phi` with its parabola in phi, `h = c - E + c phi^2/2`, `E = e + g z`,
//! meets `p_a = H ((r - h)/r)^2` over the depth `d(z) = E - (c - r)`, where that is positive:
//! ```text
//! dF/dz = k d^(5/2),  k = (16 sqrt 2/15) R H/(r^2 sqrt c)
//! F = 2 k/(7 g) [d^(7/2)],   M = k/g^2 [2/9 d^(9/2) - 2/7 d(0) d^(7/2)]    between the ends, d not below zero
//! ```
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | R, B, c | m | `bearing` |
//! | e, g | m, rad | `offset`, `tilt`, towards the contact |
//! | r, H | m, Pa | [`BearingCurve`] |
//!
//! **Source.** Zharov, dissertation, Moscow 1996. **Range.** A narrow zone of contact: `d << c`; no part of it under
//! the hardness. **Verified by** `tests/tests/contact/closed_forms.rs`.

use std::f64::consts::SQRT_2;

use crate::Bearing;
use crate::contact::BearingCurve;

/// Force [N] and moment about mid-length [N m] of the contact of a journal with this `offset` [m] and `tilt` [rad].
pub fn force_and_moment(bearing: &Bearing, curve: &BearingCurve, offset: f64, tilt: f64) -> [f64; 2] {
    let Bearing { radius, clearance, .. } = *bearing;
    let factor = 16.0 * SQRT_2 / 15.0 * radius * curve.hardness / (curve.depth.powi(2) * clearance.sqrt());
    let middle = offset - (clearance - curve.depth);
    if tilt == 0.0 {
        return [factor * middle.max(0.0).powf(2.5) * bearing.length, 0.0];
    }
    let [low, high] = bearing.ends().map(|z| (middle + tilt * z).max(0.0));
    let between = |power: f64| high.powf(power) - low.powf(power);
    let force = factor * 2.0 / (7.0 * tilt) * between(3.5);
    let moment = factor / tilt.powi(2) * (2.0 / 9.0 * between(4.5) - 2.0 / 7.0 * middle * between(3.5));
    [force, moment]
}
