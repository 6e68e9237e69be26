//! Conjugate gradients for cubic elements, preconditioned with the factor of the quadratic ones on the same mesh.
//!
//! `B r = P A_2^-1 P^T r + D^-1 r`: the quadratic part is solved, in single precision, the diagonal does for the rest. Some ten steps to
//! a thousandth, whatever the size of the mesh. Given dofs are masked on both sides.

use std::sync::Arc;

use crate::{Constraints, Error, Linearisation, Matrix, Prolongation};

/// Steps end when the residual has fallen to this part of the right-hand side.
const TOLERANCE: f64 = 1e-7;
/// A residual above this part of the right-hand side after [`MOST_STEPS`] steps is refused.
const REFUSE_ABOVE: f64 = 1e-3;
/// Most steps of one solve.
const MOST_STEPS: usize = 200;

/// What a cubic system is solved with.
#[derive(Debug, Clone)]
pub struct Nested {
    /// The tangent of the quadratic elements, factorised; its given dofs may differ from those of the cubic system.
    pub quadratic: Arc<Linearisation>,
    /// Between the two spaces.
    pub prolongation: Arc<Prolongation>,
}

impl Nested {
    /// Solves `matrix x = b` on the dofs that are not given; `x` is zero at given ones. A residual (Euclidean norm) of
    /// `enough` will do; zero stands for 1e-7 of that of `b`.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::NotPositiveDefinite`], or [`Error::Inaccurate`] if steps do not lead there.
    pub(crate) fn solve(
        &self,
        matrix: &Matrix,
        constraints: &Constraints,
        b: &[f64],
        enough: f64,
    ) -> Result<Vec<f64>, Error> {
        // Zero at given dofs, so that nothing comes from there.
        let inverse: Vec<f64> = (constraints.fixed.iter().enumerate())
            .map(|(i, &fixed)| if fixed { 0.0 } else { 1.0 / matrix.diagonal(i) })
            .collect();
        let mask = |v: &mut [f64]| {
            for (v, &inverse) in v.iter_mut().zip(&inverse) {
                *v = if inverse == 0.0 { 0.0 } else { *v };
            }
        };
        let mut r = b.to_vec();
        mask(&mut r);
        let first = dot(&r, &r).sqrt();
        let enough = if enough > 0.0 { enough } else { TOLERANCE * first };
        let mut x = vec![0.0; b.len()];
        if first <= enough {
            return Ok(x);
        }
        let mut z = self.precondition(&r, &inverse)?;
        let mut direction = z.clone();
        let mut product = dot(&r, &z);
        for _ in 0..MOST_STEPS {
            let mut image = matrix.multiply(&direction);
            mask(&mut image);
            let curvature = dot(&direction, &image);
            if !curvature.is_finite() || !product.is_finite() {
                return Err(Error::NotFinite {
                    what: "solution of the linear system",
                });
            }
            if curvature <= 0.0 {
                return Err(Error::NotPositiveDefinite);
            }
            let length = product / curvature;
            add(&mut x, length, &direction);
            add(&mut r, -length, &image);
            if dot(&r, &r).sqrt() <= enough {
                return Ok(x);
            }
            z = self.precondition(&r, &inverse)?;
            let next = dot(&r, &z);
            let turn = next / product;
            product = next;
            for (direction, z) in direction.iter_mut().zip(&z) {
                *direction = z + turn * *direction;
            }
        }
        let relative = dot(&r, &r).sqrt() / first;
        match relative < REFUSE_ABOVE {
            true => Ok(x),
            false => Err(Error::Inaccurate { relative }),
        }
    }

    /// `B r`; `inverse` is one over the diagonal, zero at given dofs.
    fn precondition(&self, r: &[f64], inverse: &[f64]) -> Result<Vec<f64>, Error> {
        let coarse = self.quadratic.apply_rough_factor(self.prolongation.restrict(r))?;
        let mut z = self.prolongation.prolong(&coarse);
        for ((z, r), &inverse) in z.iter_mut().zip(r).zip(inverse) {
            *z = if inverse == 0.0 { 0.0 } else { *z + inverse * r };
        }
        Ok(z)
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn add(x: &mut [f64], factor: f64, direction: &[f64]) {
    for (x, d) in x.iter_mut().zip(direction) {
        *x += factor * d;
    }
}
