//! # Oval bore
//!
//! **Equation.** `d = d_0 cos 2(phi - a)`: wider by d_0 at a and opposite to it, closer by as much across.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | d_0 | m | `depth` |
//! | a | rad | `angle` |
//! | R | m | `radius` |
//!
//! **Source.** Definition: the second harmonic of a roundness profile (ISO 12181-1). **Range.** `|d_0|` below the clearance. **Verified by** `tests/tests/shapes`.

use super::profile::{Profile, Relief};

/// The second harmonic around the bore.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Oval {
    /// Radius R [m].
    pub radius: f64,
    /// Depth d_0 [m].
    pub depth: f64,
    /// Angle a at which the bore is widest [rad].
    pub angle: f64,
}

impl Profile for Oval {
    fn at(&self, [x, _]: [f64; 2]) -> Relief {
        let (sin, cos) = (2.0 * (x / self.radius - self.angle)).sin_cos();
        let per_radius = self.depth / self.radius;
        Relief {
            depth: self.depth * cos,
            slope: [-2.0 * per_radius * sin, 0.0],
        }
    }

    fn bends(&self, position: [f64; 2]) -> [f64; 2] {
        [-4.0 * self.at(position).depth / self.radius.powi(2), 0.0]
    }
}
