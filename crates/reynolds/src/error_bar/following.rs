//! # What an error of the pressure does through the wall that follows it
//!
//! **Equation.** An error e of the pressure under a held wall moves the wall by x with `x = C F (e + p_d x) + C A x`,
//! and with it film and contact. So a force or moment J, its weight w under the integral of the pressure, is off by
//! ```text
//! Int (w + mu) e dA,    mu = C (g + p_d^T F^T mu + A mu),    g = p_d^T j + J_d
//! ```
//! mu is a function of the splines of the wall: where a wall is soft it is nearly -w, for the wall gives way to what
//! the film presses too much.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | mu | 1, m | [`FollowingWall`] |
//! | w | 1, m | `cos phi`, `sin phi`, `z cos phi`, `z sin phi` |
//! | C, F | m/N, m2 | [`crate::wall::Compliance`], [`crate::wall::Grid::forces_change`] |
//! | A, J_d | N/m | [`crate::wall::ContactTangent`], [`crate::quantities::LoadGradient`] |
//!
//! **Source.** Becker and Rannacher, Acta Numerica 10 (2001) 1: the dual of film and wall, of which the wall is
//! eliminated. **Range.** Errors small enough for the tangent.
//! **Verified by** `liner::bars`: it is the change of film and wall together.

use crate::wall::Grid;

/// Goals of the force towards x and y, which are the first.
pub const FORCES: usize = 2;
/// Goals of force and moments.
pub const GOALS: usize = 4;

/// What the wall adds to the weights of force and moment.
#[derive(Debug, Clone)]
pub struct FollowingWall {
    /// The splines.
    pub grid: Grid,
    /// Coefficients mu of the force towards x and y [1], and of its moments [m]: zero of a journal that cannot tilt.
    /// One coefficient stands for each spline.
    pub coefficients: [Vec<f64>; GOALS],
}

impl FollowingWall {
    /// Weights mu at a position [m].
    #[inline]
    pub(crate) fn at(&self, position: [f64; 2]) -> [f64; GOALS] {
        let mut sums = [0.0; GOALS];
        self.grid.splines_at(position).each(self.grid.numbers(), |spline, value| {
            for (sum, coefficients) in sums.iter_mut().zip(&self.coefficients) {
                *sum += value * coefficients[spline];
            }
        });
        sums
    }
}
