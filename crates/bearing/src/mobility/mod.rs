//! # Mobility: orbits by a map of the film
//!
//! **Equation.** The film of an aligned ring whose cavity has the pressure of its ends sees rotation and motion as one
//! velocity,
//! ```text
//! v = e' - (omega/2) k x e              W = F:   e' = V(e, F) + (omega/2) k x e
//! ```
//! and its force W is in proportion to v. So the film is a map of two numbers, the eccentricity and the direction of v
//! against the line of centres; its inverse V is the mobility. A map is computed once for a slenderness B/D, and serves
//! every load, speed, viscosity and clearance.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | e, v over the clearance | 1, 1/s | `place`, `velocity` |
//! | W over mu B^3 R/c^2 | 1/s | `force` |
//!
//! | file | what |
//! |---|---|
//! | `short.rs` | the map of the short half film, in closed form |
//! | `finite.rs` | that of a film of finite length, computed on its mesh |
//! | `travel.rs` | the orbit by a map |
//!
//! **Source.** Booker, Trans. ASME J. Basic Eng. 87 (1965) 537; Childs, Moes, van Leeuwen, Trans. ASME J. Lubr. Tech.
//! 99 (1977) 198. **Range.** Full rings without feeds and tilt; half films (Guembel) and those of Swift and Stieber
//! with the pressure of the ends in the cavity; constant viscosity; no mass. **Verified by**
//! `tests/tests/orbit/mobility.rs`.

mod finite;
mod short;
mod travel;

pub use finite::{FiniteMap, NoMap};
pub use short::ShortMap;
pub use travel::{MapOrbit, Travel};

use std::f64::consts::PI;

/// Bisections by which the direction of a velocity is sought at most, between secants.
const MOST_STEPS: usize = 80;
/// Accuracy of the direction [rad].
const ANGLE: f64 = 1e-13;

/// A film as a map.
pub trait FilmMap: Sync {
    /// Force [1] for the unit of velocity in the direction `angle` in [0, pi] against the line of centres, along that
    /// line and across it, at an eccentricity [1].
    fn force(&self, eccentricity: f64, angle: f64) -> [f64; 2];

    /// The velocity [1/s] along the line of centres and across it for which the film has the force [1/s] of this size
    /// in the direction `angle` in [0, pi].
    ///
    /// The force of a half film is the gradient of a convex function of the velocity, so that its direction grows with
    /// that of the velocity.
    fn mobility(&self, eccentricity: f64, size: f64, angle: f64) -> [f64; 2] {
        let off = |direction: f64| {
            let [along, across] = self.force(eccentricity, direction);
            across.atan2(along) - angle
        };
        let (mut low, mut high) = ((0.0, -angle), (PI, PI - angle));
        let mut found = if angle > 0.0 { low.0 + angle } else { 0.0 };
        // Illinois: false position that halves the value of an end that stays.
        let mut stayed = 0;
        for _ in 0..MOST_STEPS {
            if high.0 - low.0 < ANGLE {
                break;
            }
            let value = off(found);
            if value.abs() < ANGLE {
                break;
            }
            match value < 0.0 {
                true => {
                    low = (found, value);
                    high.1 *= if stayed == -1 { 0.5 } else { 1.0 };
                    stayed = -1;
                }
                false => {
                    high = (found, value);
                    low.1 *= if stayed == 1 { 0.5 } else { 1.0 };
                    stayed = 1;
                }
            }
            found = (low.0 * high.1 - high.0 * low.1) / (high.1 - low.1);
            if !(found > low.0 && found < high.0) {
                found = 0.5 * (low.0 + high.0);
            }
        }
        let [along, across] = self.force(eccentricity, found);
        let speed = size / along.hypot(across);
        [speed * found.cos(), speed * found.sin()]
    }
}
