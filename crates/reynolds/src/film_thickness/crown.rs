//! # Crown: a surface that falls off towards its ends
//!
//! **Equation.** `d = d_0 (z/b)^2`, `b = B/2`: a bore that widens towards its ends, or a barrel-shaped shaft.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | d_0 | m | `depth` |
//! | b | m | `half_length` |
//!
//! **Source.** Zharov, Modelling of the tribosystem crankshaft - bearings - supports (dissertation, VNIIZhT Moscow,
//! 1996), the hyperbolic bore, whose depth at the ends is that by which the film of a tilted journal is thinner there.
//! **Range.** `d_0 << b`; negative: closer at its ends. **Verified by** `tests/tests/shapes`.

use super::profile::{Profile, Relief};

/// A parabola along the axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Crown {
    /// Depth d_0 at the ends [m].
    pub depth: f64,
    /// Half of the bearing's length b [m].
    pub half_length: f64,
}

impl Profile for Crown {
    fn at(&self, [_, z]: [f64; 2]) -> Relief {
        let (part, per_length) = (z / self.half_length, self.depth / self.half_length);
        Relief { depth: self.depth * part * part, slope: [0.0, 2.0 * per_length * part] }
    }

    fn bends(&self, _position: [f64; 2]) -> [f64; 2] {
        [0.0, 2.0 * self.depth / self.half_length.powi(2)]
    }
}
