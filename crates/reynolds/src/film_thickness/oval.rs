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
//! **Source.** Definition: the second harmonic of a roundness profile (ISO 12181-1). **Range.** `|d_0|` below the
//! clearance. **Verified by** `tests/tests/shapes`.

use oilwedge_fem::quadrature::MOST_POINTS;

use super::profile::{Profile, Relief};
use crate::angles::sines_and_cosines;

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
        Relief { depth: self.depth * cos, slope: [-2.0 * per_radius * sin, 0.0] }
    }

    /// Follows from the sine and cosine of the single angle, which are known for all positions at once.
    fn each(&self, positions: &[[f64; 2]], visit: &mut dyn FnMut(usize, Relief)) {
        let (turned_sin, turned_cos) = (2.0 * self.angle).sin_cos();
        let per_radius = self.depth / self.radius;
        for (first, positions) in (0..).step_by(MOST_POINTS).zip(positions.chunks(MOST_POINTS)) {
            let [sines, cosines] = sines_and_cosines(positions, self.radius);
            for (q, (s, c)) in sines.iter().zip(&cosines).take(positions.len()).enumerate() {
                let (sin, cos) = (2.0 * s * c, (c - s) * (c + s));
                let (sin, cos) = (sin * turned_cos - cos * turned_sin, cos * turned_cos + sin * turned_sin);
                let relief = Relief { depth: self.depth * cos, slope: [-2.0 * per_radius * sin, 0.0] };
                visit(first + q, relief);
            }
        }
    }

    fn bends(&self, position: [f64; 2]) -> [f64; 2] {
        [-4.0 * self.at(position).depth / self.radius.powi(2), 0.0]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn many_positions_have_the_profile_of_each() {
        let oval = Oval { radius: 0.05, depth: 1e-5, angle: 0.4 };
        let positions: Vec<[f64; 2]> = (0..2 * MOST_POINTS + 3).map(|k| [0.001 * k as f64, 0.01]).collect();
        let mut visited = 0;
        oval.each(&positions, &mut |q, Relief { depth, slope }| {
            let alone = oval.at(positions[q]);
            assert_eq!(q, visited);
            assert!((depth - alone.depth).abs() < 1e-14 * oval.depth, "{q}");
            assert!((slope[0] - alone.slope[0]).abs() < 1e-14 * oval.depth / oval.radius, "{q}");
            visited += 1;
        });
        assert_eq!(visited, positions.len());
    }
}
