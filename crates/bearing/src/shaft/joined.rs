//! # The balance of a shaft on the films of its journals
//!
//! **Equation.** The journals of the shaft are displaced by `u = e + C W`, with the offsets e in the films and the
//! compliance C of what holds the shells; the slopes likewise, with moments. The film pushes the journal with -W and
//! the shell with W:
//! ```text
//! K (e + C W) + W = F,        W = W(e, e')
//! ```
//! with the stiffness K of the shaft by its journals and the loads F moved to them. Its tangent is
//! `K + (1 + K C) dW/de`, where the films stand in blocks.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | e, and slopes times arms | m | `at` |
//! | W, F, moments over arms | N | `carried`, `asked` |
//! | C | m/N | `compliance` |
//!
//! **Source.** Definition. **Range.** Quasi-static shafts: their mass acts by the loads only. **Verified by**
//! `tests/tests/shaft/statics.rs`.

use super::frame::Shaft;
use super::matrix::SquareMatrix;
use crate::coordinates::{Vector, length, moved};
use crate::stiffness::Stiffness;

/// A shaft turned by an angle, under loads on its journals.
#[derive(Debug, Clone)]
pub struct ShaftBalance<'a> {
    /// The shaft.
    pub shaft: &'a Shaft,
    /// How much what holds each shell gives way in each coordinate [m/N].
    pub compliance: &'a [Vector],
    /// Angle by which the shaft is turned [rad].
    pub angle: f64,
    /// Loads as forces on the journals [N].
    pub asked: Vec<Vector>,
}

impl ShaftBalance<'_> {
    /// What is left of the balance [N] with journals at these offsets [m] in films that carry this [N].
    pub fn left(&self, at: &[Vector], carried: &[Vector]) -> Vec<Vector> {
        let by_shaft = self.shaft.forces(&self.displaced(at, carried), self.angle);
        all_moved(&all_moved(&by_shaft, 1.0, carried), -1.0, &self.asked)
    }

    /// How the journals are displaced [m] with these offsets in shells that give way to what the films carry [N].
    pub fn displaced(&self, at: &[Vector], carried: &[Vector]) -> Vec<Vector> {
        all_moved(at, 1.0, &self.yields(carried))
    }

    /// How far the shells give way [m] to what the films carry [N].
    pub fn yields(&self, carried: &[Vector]) -> Vec<Vector> {
        let shells = self.compliance.iter().zip(carried);
        shells.map(|(compliance, carried)| [0, 1, 2, 3].map(|k| compliance[k] * carried[k])).collect()
    }

    /// By how much the balance changes [N] where films carry so much more [N].
    pub fn by_films(&self, carried: &[Vector]) -> Vec<Vector> {
        all_moved(&self.shaft.forces(&self.yields(carried), self.angle), 1.0, carried)
    }

    /// The tangent of the balance, where each offset changes by `per_offset` [1] and the forces of the films by these
    /// `slopes`.
    pub fn tangent(&self, slopes: &[Stiffness], per_offset: f64) -> SquareMatrix {
        let mut tangent = self.shaft.stiffness(self.angle).scaled(per_offset);
        for (column, &(bearing, coordinate)) in self.shaft.rows().iter().enumerate() {
            let mut carried = vec![[0.0; 4]; slopes.len()];
            carried[bearing] = [0, 1, 2, 3].map(|row| slopes[bearing][row][coordinate]);
            let forces = self.shaft.gathered(&self.by_films(&carried));
            (0..).zip(forces).for_each(|(row, force)| tangent.add(row, column, force));
        }
        tangent
    }

    /// The change of all places [m] by which the balance changes so [N], the forces of the films by these `slopes`;
    /// `None` where the tangent is singular.
    pub fn solve(&self, slopes: &[Stiffness], wanted: &[Vector]) -> Option<Vec<Vector>> {
        let factors = self.tangent(slopes, 1.0).factors()?;
        let step = self.shaft.spread(&factors.solve(&self.shaft.gathered(wanted)));
        magnitude(&step).is_finite().then_some(step)
    }
}

/// Magnitude of a list of vectors.
pub fn magnitude(vectors: &[Vector]) -> f64 {
    vectors.iter().map(|&vector| length(vector).powi(2)).sum::<f64>().sqrt()
}

/// `a + part b`.
pub fn all_moved(a: &[Vector], part: f64, b: &[Vector]) -> Vec<Vector> {
    a.iter().zip(b).map(|(a, b)| moved(*a, part, *b)).collect()
}
