//! The tangent of the forces by the coordinates of the journal, none, two or four of each, and its inverse.

use std::ops::Index;

use crate::coordinates::{Vector, moved};

/// Least square of the sine of the angle between two steps that tell of two directions.
const NEARLY_PARALLEL: f64 = 1e-2;

/// `dW/de` [N/m] in the coordinates of [`crate::Coordinates`], row: force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stiffness {
    rows: [Vector; 4],
    order: usize,
}

impl Stiffness {
    /// The stiffness by this many coordinates, from the change of the forces by each.
    ///
    /// # Errors
    /// Those of the columns.
    pub fn by_columns<E>(order: usize, column: impl Fn(usize) -> Result<Vector, E>) -> Result<Self, E> {
        let mut rows = [[0.0; 4]; 4];
        for k in 0..order {
            let column = column(k)?;
            for (row, entry) in rows.iter_mut().zip(column).take(order) {
                row[k] = entry;
            }
        }
        Ok(Self { rows, order })
    }

    /// How many coordinates there are.
    pub fn order(&self) -> usize {
        self.order
    }

    /// The tangent with a force more for each coordinate [N/m].
    pub fn with_diagonal(mut self, more: Vector) -> Self {
        for (k, more) in more.into_iter().enumerate().take(self.order) {
            self.rows[k][k] += more;
        }
        self
    }

    /// The sum of this tangent and `factor` times another one.
    #[must_use]
    pub fn plus(mut self, factor: f64, other: &Self) -> Self {
        for (row, more) in self.rows.iter_mut().zip(&other.rows) {
            row.iter_mut().zip(more).for_each(|(entry, more)| *entry += factor * more);
        }
        self
    }

    /// The change of the forces by a `step`.
    pub fn times(&self, step: Vector) -> Vector {
        self.rows.map(|row| (0..self.order).fold(0.0, |sum, k| sum + row[k] * step[k]))
    }

    /// The tangent corrected by what it `missed` of the forces after a `step` (Broyden, Math. Comp. 19 (1965) 577).
    pub fn corrected(mut self, step: Vector, missed: Vector) -> Self {
        let square = (0..self.order).fold(0.0, |sum, k| sum + step[k] * step[k]);
        for (row, missed) in self.rows.iter_mut().zip(missed).take(self.order) {
            let per_step = missed / square;
            for (entry, step) in row.iter_mut().zip(step).take(self.order) {
                *entry += if square > 0.0 { per_step * step } else { 0.0 };
            }
        }
        self
    }

    /// The tangent corrected by what it `missed` of the forces after a `step`, so that it still gives what a step
    /// `before` has given: that part of the step counts which lies across the one before (Gay, Schnabel, Nonlinear
    /// Programming 3 (1978) 245); all of it where they are nearly parallel.
    pub fn corrected_beside(self, before: Vector, step: Vector, missed: Vector) -> Self {
        let product = |a: Vector, b: Vector| (0..self.order).fold(0.0, |sum, k| sum + a[k] * b[k]);
        let across = moved(step, -product(step, before) / product(before, before), before);
        let part = product(across, step) / product(step, step);
        match part > NEARLY_PARALLEL {
            // A correction along what lies across, by as much as the whole step missed.
            true => self.corrected(across, missed),
            false => self.corrected(step, missed),
        }
    }

    /// The step [m] by which the forces change as `wanted` [N]; not finite where the tangent is singular.
    pub fn solve(&self, wanted: Vector) -> Vector {
        match self.order {
            0 => [0.0; 4],
            2 => {
                let [x, y] = cramer(&self.rows, [wanted[0], wanted[1]]);
                [x, y, 0.0, 0.0]
            }
            _ => eliminate(self.rows, wanted),
        }
    }
}

impl Index<usize> for Stiffness {
    type Output = Vector;

    fn index(&self, row: usize) -> &Vector {
        &self.rows[row]
    }
}

/// Solves two equations by Cramer's rule.
fn cramer(a: &[Vector; 4], b: [f64; 2]) -> [f64; 2] {
    let determinant = a[0][0] * a[1][1] - a[0][1] * a[1][0];
    [(a[1][1] * b[0] - a[0][1] * b[1]) / determinant, (a[0][0] * b[1] - a[1][0] * b[0]) / determinant]
}

/// Solves a few equations by elimination with row pivots; not finite where they are singular.
pub fn eliminate<const N: usize>(mut a: [[f64; N]; N], mut b: [f64; N]) -> [f64; N] {
    for k in 0..N {
        let pivot = (k..N).fold(k, |best, row| if a[row][k].abs() > a[best][k].abs() { row } else { best });
        a.swap(k, pivot);
        b.swap(k, pivot);
        let (upper, above) = (a[k], b[k]);
        for row in k + 1..N {
            let factor = a[row][k] / upper[k];
            for (entry, upper) in a[row].iter_mut().zip(upper) {
                *entry -= factor * upper;
            }
            b[row] -= factor * above;
        }
    }
    let mut x = [0.0; N];
    for k in (0..N).rev() {
        let known: f64 = (k + 1..N).map(|j| a[k][j] * x[j]).sum();
        x[k] = (b[k] - known) / a[k][k];
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A matrix that needs pivots.
    const ROWS: [Vector; 4] =
        [[0.0, 2.0, 1.0, -1.0], [3.0, 0.0, 0.5, 2.0], [1.0, -1.0, 0.0, 4.0], [2.0, 0.3, 7.0, 0.0]];

    fn matrix(order: usize) -> Stiffness {
        let column = |k: usize| Ok::<_, ()>(ROWS.map(|row| row[k]));
        Stiffness::by_columns(order, column).expect("numbers")
    }

    #[test]
    fn what_is_solved_gives_the_forces_back() {
        let wanted = [1.0, -2.0, 0.7, 3.0];
        let back = matrix(4).times(matrix(4).solve(wanted));
        assert!((0..4).all(|k| (back[k] - wanted[k]).abs() < 1e-14), "{back:?}");
        let two = matrix(2).times(matrix(2).solve(wanted));
        assert!((0..2).all(|k| (two[k] - wanted[k]).abs() < 1e-14) && two[2] == 0.0, "{two:?}");
    }

    #[test]
    fn a_correction_makes_the_step_exact() {
        let step = [0.1, -0.2, 0.3, 0.05];
        let forces = [1.0, 2.0, 3.0, 4.0];
        let told = matrix(4).times(step);
        let missed = [0, 1, 2, 3].map(|k| forces[k] - told[k]);
        let corrected = matrix(4).corrected(step, missed).times(step);
        assert!((0..4).all(|k| (corrected[k] - forces[k]).abs() < 1e-14), "{corrected:?}");
    }

    #[test]
    fn a_second_correction_leaves_the_first_exact() {
        let steps = [[0.1, -0.2, 0.3, 0.05], [0.2, 0.1, -0.1, 0.02]];
        let forces = [[1.0, 2.0, 3.0, 4.0], [0.5, -1.0, 2.0, 0.0]];
        let missed = |of: Stiffness, k: usize| moved(forces[k], -1.0, of.times(steps[k]));
        let first = matrix(4).corrected(steps[0], missed(matrix(4), 0));
        let both = first.corrected_beside(steps[0], steps[1], missed(first, 1));
        for k in 0..2 {
            assert!(missed(both, k).iter().all(|off| off.abs() < 1e-14), "{k}");
        }
    }

    #[test]
    fn a_singular_tangent_gives_no_number() {
        let zero = Stiffness::by_columns(4, |_| Ok::<_, ()>([0.0; 4])).expect("numbers");
        assert!(zero.solve([1.0; 4]).iter().any(|x| !x.is_finite()));
    }
}
