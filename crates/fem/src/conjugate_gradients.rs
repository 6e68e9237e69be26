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
    let first = dot(&r, &r).sqrt();
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
        let next = dot(&r, &z);
        if steps == 0 {
            direction = z;
        } else {
            // (z, r - r before) over (z before, r before): exact also for a preconditioner that varies.
            let turn = -length * dot(&z, &image) / product;
            update(&mut direction, |i, d| z[i] + turn * d);
        }
        product = next;
        matrix.multiply_free(&direction, fixed, &mut image);
        let curvature = dot(&direction, &image);
        if !curvature.is_finite() || !product.is_finite() {
            return Err(Error::NotFinite { what: "solution of the linear system" });
        }
        if curvature <= 0.0 || product <= 0.0 {
            return Err(Error::NotPositiveDefinite);
        }
        length = product / curvature;
        update(&mut x, |i, x| x + length * direction[i]);
        update(&mut r, |i, r| r - length * image[i]);
        residual = dot(&r, &r).sqrt();
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

fn dot(a: &[f64], b: &[f64]) -> f64 {
    let portions = a.par_chunks(PORTION).zip(b.par_chunks(PORTION));
    let portions = portions.map(|(a, b)| a.iter().zip(b).map(|(a, b)| a * b).sum());
    in_order::<f64>(portions).iter().sum()
}

/// Replaces each entry by a function of its place and itself.
fn update(x: &mut [f64], new: impl Fn(usize, f64) -> f64 + Sync) {
    x.par_chunks_mut(PORTION).enumerate().for_each(|(portion, x)| {
        for (k, x) in x.iter_mut().enumerate() {
            *x = new(portion * PORTION + k, *x);
        }
    });
}
