//! # Worn bore: a pit on the loaded side
//!
//! **Equation.** `d = d_0 max(0, 1 - ((phi - a)/w)^2)`. Its slope jumps by `2 d_0/(w R)` at the edges `phi = a -+ w`.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | d_0 | m | `depth` |
//! | a, w | rad | `angle`, `half_width` |
//! | R | m | `radius` |
//!
//! **Source.** Dufrane, Kannel, McCloskey, Trans. ASME J. Lubr. Tech. 105 (1983) 402: a journal wears its bearing to a
//! shape near its own, here to second order about its middle. **Range.** `w < pi`; d_0 of the order of the clearance.
//! **Verified by** `tests/tests/shapes`.

use super::profile::{Profile, Relief};
use crate::angles::wrapped;

/// Size of triangles at an edge of the pit, over its half width.
const AT_EDGE: f64 = 0.06;
/// Growth of triangles with the distance from that edge.
const GROWTH: f64 = 0.4;

/// A pit of parabolic section all along the axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Worn {
    /// Radius R [m].
    pub radius: f64,
    /// Greatest depth d_0 [m].
    pub depth: f64,
    /// Angle a of its middle [rad].
    pub angle: f64,
    /// Half of its width w [rad].
    pub half_width: f64,
}

impl Worn {
    /// Distance from the middle of the pit over half of its width [1].
    fn part(&self, x: f64) -> f64 {
        wrapped(x / self.radius - self.angle) / self.half_width
    }
}

impl Profile for Worn {
    fn at(&self, [x, _]: [f64; 2]) -> Relief {
        let part = self.part(x);
        if part.abs() >= 1.0 {
            return Relief::default();
        }
        let per_length = self.depth / (self.half_width * self.radius);
        Relief { depth: self.depth * (1.0 - part * part), slope: [-2.0 * per_length * part, 0.0] }
    }

    fn bends(&self, [x, _]: [f64; 2]) -> [f64; 2] {
        let inside = if self.part(x).abs() < 1.0 { 1.0 } else { 0.0 };
        [-2.0 * inside * self.depth / (self.half_width * self.radius).powi(2), 0.0]
    }

    fn finest(&self, [x, _]: [f64; 2]) -> f64 {
        let from_edge = (self.part(x).abs() - 1.0).abs();
        self.half_width * self.radius * (AT_EDGE + GROWTH * from_edge)
    }
}
