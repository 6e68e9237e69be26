//! Preconditioned conjugate gradients on the dofs that are not given.
//!
//! Flexible (Golub and Ye, SIAM J. Sci. Comput. 21 (1999) 1305): the preconditioner may be rounded to single precision,
//! or be an iteration itself. Sums are made in fixed portions, so that threads do not change a bit.

use rayon::prelude::*;

use crate::in_order;
use crate::{Error, Matrix};

/// Entries that one task sums or updates.
const PORTION: usize = 16_384;
/// Steps after which it is known how quickly residuals fall.
const TRIAL_STEPS: usize = 5;

/// Part of the right-hand side to which a residual is brought where nothing else is asked for.
pub(crate) const TOLERANCE: f64 = 1e-11;

/// The accuracy to which an iteration solves a linear system.
#[derive(Debug, Clone, Copy)]
pub struct Enough {
    /// Euclidean norm of the residual; zero stands for what is usual.
    pub residual: f64,
    /// Sum of the residual: what a conservation law loses.
    pub imbalance: f64,
    /// Euclidean norm of a residual whose sum is round-off and does not count.
    pub round_off: f64,
}

impl Enough {
    /// A Euclidean norm of the residual, whatever its sum.
    pub fn residual(residual: f64) -> Self {
        Self { residual, imbalance: f64::INFINITY, round_off: 0.0 }
    }
}

/// Conditions on which an iteration ends.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Ending {
    /// The accuracy that will do.
    pub(crate) enough: Enough,
    /// Most steps; the iteration ends as soon as its pace shows that these will not suffice.
    pub(crate) most_steps: usize,
}

/// Solves `matrix x = b`; nothing where residuals fall too slowly. `fixed` dofs are given: rows and columns there do
/// not count, and `x` is zero there. `precondition` gives zero there.
///
/// # Errors
/// [`Error::NotFinite`], [`Error::NotPositiveDefinite`], or an error of `precondition`.
pub(crate) fn conjugate_gradients(
    matrix: &Matrix,
    fixed: &[bool],
    b: &[f64],
    ending: Ending,
    precondition: impl Fn(&[f64]) -> Result<Vec<f64>, Error>,
) -> Result<Option<Vec<f64>>, Error> {
    let mut r = b.to_vec();
    for (r, &fixed) in r.iter_mut().zip(fixed) {
        *r = if fixed { 0.0 } else { *r };
    }
    let mut x = vec![0.0; r.len()];
    let first = products(&r, [&r, &r])[0].sqrt();
    let mut residual = first;
    let mut direction: Vec<f64> = Vec::new();
    let mut image = vec![0.0; r.len()];
    let (mut product, mut length) = (0.0, 0.0);
    for steps in 0.. {
        if is_enough(ending.enough, residual, &r) {
            return Ok(Some(x));
        }
        if steps >= ending.most_steps || is_slow(ending, first, residual, steps) {
            return Ok(None);
        }
        let z = precondition(&r)?;
        let [next, turned] = products(&z, [&r, &image]);
        if steps == 0 {
            direction = z;
        } else {
            // (z, r - r before) over (z before, r before): exact also for a preconditioner that varies.
            turn(&mut direction, -length * turned / product, &z);
        }
        product = next;
        let curvature = matrix.multiply_free(&direction, fixed, &mut image);
        if !curvature.is_finite() || !product.is_finite() {
            return Err(Error::NotFinite { what: "solution of the linear system" });
        }
        if curvature <= 0.0 || product <= 0.0 {
            return Err(Error::NotPositiveDefinite);
        }
        length = product / curvature;
        residual = step([&mut x, &mut r], length, [&direction, &image]).sqrt();
    }
    unreachable!("the steps are bounded")
}

/// True if the Euclidean norm `residual` of `r` and the sum of `r` are small enough.
fn is_enough(enough: Enough, residual: f64, r: &[f64]) -> bool {
    let sum = || {
        let portions = r.par_chunks(PORTION).map(|r| r.iter().sum());
        in_order::<f64>(portions).iter().sum::<f64>()
    };
    residual <= enough.residual && (residual <= enough.round_off || sum().abs() <= enough.imbalance)
}

/// True if at the pace so far more steps than allowed would be needed.
fn is_slow(ending: Ending, first: f64, residual: f64, steps: usize) -> bool {
    if steps < TRIAL_STEPS {
        return false;
    }
    let pace = (residual / first).ln() / steps as f64;
    let left = (ending.enough.residual / residual).ln() / pace;
    pace >= 0.0 || steps as f64 + left > ending.most_steps as f64
}

/// Scalar products of a vector with two others, by one pass.
fn products(z: &[f64], [a, b]: [&[f64]; 2]) -> [f64; 2] {
    let portions = z.par_chunks(PORTION).zip(a.par_chunks(PORTION)).zip(b.par_chunks(PORTION));
    let portions = portions.map(|((z, a), b)| {
        let add = |[with_a, with_b]: [f64; 2], ((z, a), b): ((&f64, &f64), &f64)| [with_a + z * a, with_b + z * b];
        z.iter().zip(a).zip(b).fold([0.0; 2], add)
    });
    in_order(portions).iter().fold([0.0; 2], |[a, b], [more_a, more_b]| [a + more_a, b + more_b])
}

/// `z + factor direction` instead of the direction.
fn turn(direction: &mut [f64], factor: f64, z: &[f64]) {
    direction.par_chunks_mut(PORTION).zip(z.par_chunks(PORTION)).for_each(|(direction, z)| {
        for (direction, z) in direction.iter_mut().zip(z) {
            *direction = z + factor * *direction;
        }
    });
}

/// A step of this `length` of solution and residual; what is returned is the square of the new residual.
fn step([x, r]: [&mut [f64]; 2], length: f64, [direction, image]: [&[f64]; 2]) -> f64 {
    let before = x.par_chunks_mut(PORTION).zip(r.par_chunks_mut(PORTION));
    let portions = before.zip(direction.par_chunks(PORTION)).zip(image.par_chunks(PORTION));
    let squares = portions.map(|(((x, r), direction), image)| {
        let mut square = 0.0;
        for (((x, r), direction), image) in x.iter_mut().zip(r).zip(direction).zip(image) {
            *x += length * direction;
            *r -= length * image;
            square += *r * *r;
        }
        square
    });
    in_order::<f64>(squares).iter().sum()
}
