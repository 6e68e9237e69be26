//! # Contact by a bearing curve
//!
//! **Equation.** `p_a = H ((r - h)/r)^2` for `h < r`, no contact beyond, and H for `h <= 0`: the part of the area that
//! bears grows as the square of the approach, and every part that bears is under the pressure of the hardness.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | h (gap of the mean planes) | m | `gap` |
//! | r (depth at which the profiles first touch, `R_max/sqrt 2`) | m | `depth` |
//! | H (hardness of the softer surface) | Pa | `hardness` |
//!
//! **Source.** Zharov, dissertation, Moscow 1996 (contact of crankshaft journals and their bearings); Kragelskii,
//! Friction and Wear (1965), for bearing curves.
//! **Range.** Plastic contact of run-in profiles. **Verified by** `tests/tests/contact/closed_forms.rs`: the force and
//! the moment of [`crate::analytical::bearing_curve`].

use std::ops::Range;

use super::{ContactLaw, ContactPressure};

/// A profile whose bearing area grows as the square of the approach.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BearingCurve {
    /// Depth r [m].
    pub depth: f64,
    /// Hardness H [Pa].
    pub hardness: f64,
}

impl ContactLaw for BearingCurve {
    fn at(&self, gap: f64) -> ContactPressure {
        let approach = 1.0 - gap / self.depth;
        match approach {
            _ if approach <= 0.0 => ContactPressure::default(),
            _ if approach >= 1.0 => ContactPressure { pressure: self.hardness, slope: 0.0 },
            _ => ContactPressure {
                pressure: self.hardness * approach * approach,
                slope: -2.0 * self.hardness * approach / self.depth,
            },
        }
    }

    fn reach(&self) -> f64 {
        self.depth
    }

    fn scale(&self) -> f64 {
        self.depth
    }

    fn has_kink_in(&self, gaps: Range<f64>) -> bool {
        gaps.contains(&0.0) || gaps.contains(&self.depth)
    }

    fn hardness(&self) -> f64 {
        self.hardness
    }
}
