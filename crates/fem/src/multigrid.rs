//! The preconditioner of large symmetric systems of quadratic elements: p-multigrid with aggregation below.
//!
//! ```text
//! quadratic elements    forward sweep, restrict the rest to vertices, correct, backward sweep
//! vertices              two steps of flexible conjugate gradients around such a cycle (a K-cycle)
//! groups of vertices    the same, until a few thousand unknowns are left
//! those                 Cholesky factor
//! ```
//! All in single precision. Some ten steps of conjugate gradients take ten digits off a residual, whatever
//! the size of the mesh and the contrast of film thickness. Needles are not served: point sweeps do not see the stiff
//! direction.
//!
//! Source: Notay and Vassilevski, Numer. Linear Algebra Appl. 15 (2008) 473 (K-cycle); Sundar, Stadler, Biros, Numer.
//! Linear Algebra Appl. 22 (2015) 664 (degree first, then size). **Verified by** `steps_do_not_grow_with_the_mesh`
//! (`iterated`).

use std::sync::Arc;

use rayon::prelude::*;

use crate::aggregation::Groups;
use crate::factorization::SingleFactor;
use crate::in_order;
use crate::linear_prolongation::LinearProlongation;
use crate::sweeps::Sweeps;
use crate::{Analysis, Error, Matrix};

/// A level of at most this many unknowns is factorised: against a thousand this saves a step in sixteen and 5 % of the
/// instructions of assembly and solution at a hundred thousand unknowns.
const COARSEST: usize = 6000;
/// A second step on a level is left out where the first reduces the residual to this part.
const GOOD_STEP: f64 = 0.25;

/// The levels of one masked matrix.
#[derive(Debug)]
pub(crate) struct Multigrid {
    between: Arc<LinearProlongation>,
    quadratic: Sweeps,
    vertices: Below,
    /// Vertices that are masked.
    masked: Vec<bool>,
    /// The matrix is scaled by this, so that single precision holds it.
    scale: f64,
}

/// A level below quadratic elements.
#[derive(Debug)]
enum Below {
    /// Swept, with another one below.
    Swept(Box<AggregationLevel>),
    /// Factorised.
    Factorised(SingleFactor),
}

/// A level of which groups of unknowns make the next one.
#[derive(Debug)]
struct AggregationLevel {
    sweeps: Sweeps,
    /// The unknowns of the level below.
    groups: Groups,
    below: Below,
}

impl Multigrid {
    /// The levels below `matrix`, given dofs masked.
    ///
    /// # Errors
    /// [`Error::NotFinite`] or [`Error::NotPositiveDefinite`].
    pub(crate) fn new(between: Arc<LinearProlongation>, matrix: &Matrix, fixed: &[bool]) -> Result<Self, Error> {
        // Magnitudes of numbers are ordered as their bits are, and what is no number comes last.
        let magnitudes = matrix.values.par_iter().map(|value| value.abs().to_bits());
        let greatest = f64::from_bits(magnitudes.max().unwrap_or(0));
        let scale = 1.0 / greatest;
        if !scale.is_finite() || !greatest.is_finite() {
            return Err(Error::NotFinite { what: "matrix" });
        }
        let mut quadratic = Sweeps::new(matrix, scale);
        quadratic.mask(fixed);
        let masked = between.masked(fixed);
        let vertices = vertices(&between, matrix, fixed, scale)?;
        Ok(Self { between, quadratic, vertices, masked, scale })
    }

    /// The hierarchy of this matrix with other given dofs: only the levels below it are made anew.
    ///
    /// # Errors
    /// [`Error::NotPositiveDefinite`].
    pub(crate) fn mask(&mut self, matrix: &Matrix, fixed: &[bool]) -> Result<(), Error> {
        self.quadratic.mask(fixed);
        self.masked = self.between.masked(fixed);
        self.vertices = vertices(&self.between, matrix, fixed, self.scale)?;
        Ok(())
    }

    /// One cycle from zero: an approximate inverse, times `r`.
    pub(crate) fn cycle(&self, r: &[f64]) -> Result<Vec<f64>, Error> {
        let greatest = r.par_iter().map(|r| r.abs()).reduce(|| 0.0, f64::max);
        if greatest == 0.0 {
            return Ok(vec![0.0; r.len()]);
        }
        let rough: Vec<f32> = in_order(r.par_iter().map(|r| (r / greatest) as f32));
        let [mut z, left] = self.quadratic.forward(&rough);
        let mut left = self.between.restrict(&left);
        for (left, &masked) in left.iter_mut().zip(&self.masked) {
            *left = if masked { 0.0 } else { *left };
        }
        self.between.add_prolonged(&self.vertices.solve(&left)?, &mut z);
        self.quadratic.backward(&rough, &mut z);
        drop(rough);
        let size = greatest * self.scale;
        Ok(in_order(z.par_iter().map(|&z| size * f64::from(z))))
    }
}

fn vertices(between: &LinearProlongation, matrix: &Matrix, fixed: &[bool], scale: f64) -> Result<Below, Error> {
    let mut linear = between.galerkin(matrix, fixed);
    linear.values.iter_mut().for_each(|value| *value *= scale);
    Below::new(linear, &between.masked(fixed))
}

impl Below {
    fn new(matrix: Matrix, masked: &[bool]) -> Result<Self, Error> {
        let unknowns = masked.iter().filter(|masked| !**masked).count();
        let factorised = |matrix: &Matrix| -> Result<Self, Error> {
            let analysis = Arc::new(Analysis::of_pattern(matrix.pattern.clone())?);
            Ok(Self::Factorised(analysis.factorise(matrix, masked)?.single()))
        };
        if unknowns <= COARSEST {
            return factorised(&matrix);
        }
        let groups = Groups::new(&matrix, masked);
        // Groups of one are no coarser level.
        if 2 * groups.count > unknowns {
            return factorised(&matrix);
        }
        let below = Self::new(groups.galerkin(&matrix), &vec![false; groups.count])?;
        let mut sweeps = Sweeps::new(&matrix, 1.0);
        sweeps.mask(masked);
        Ok(Self::Swept(Box::new(AggregationLevel { sweeps, groups, below })))
    }

    /// An approximate solution on this level.
    fn solve(&self, r: &[f32]) -> Result<Vec<f32>, Error> {
        match self {
            Self::Swept(grid) => grid.two_steps(r),
            Self::Factorised(factor) => {
                let mut x = r.to_vec();
                factor.solve_rough(&mut x)?;
                Ok(x)
            }
        }
    }
}

impl AggregationLevel {
    /// Two steps of flexible conjugate gradients, or one if that does.
    fn two_steps(&self, r: &[f32]) -> Result<Vec<f32>, Error> {
        let mut first = self.cycle(r)?;
        let image = self.sweeps.multiply(&first);
        let curvature = dot(&first, &image);
        if curvature <= 0.0 {
            return Ok(first);
        }
        let length = dot(&first, r) / curvature;
        let mut left = r.to_vec();
        add(&mut left, -length, &image);
        if dot(&left, &left) <= GOOD_STEP * GOOD_STEP * dot(r, r) {
            first.iter_mut().for_each(|x| *x *= length as f32);
            return Ok(first);
        }
        let second = self.cycle(&left)?;
        let second_image = self.sweeps.multiply(&second);
        let mixed = dot(&second, &image);
        let rest = dot(&second, &second_image) - mixed * mixed / curvature;
        let second_length = if rest > 0.0 { dot(&second, &left) / rest } else { 0.0 };
        let first_length = length - mixed * second_length / curvature;
        first.iter_mut().for_each(|x| *x *= first_length as f32);
        add(&mut first, second_length, &second);
        Ok(first)
    }

    /// Forward sweep, correction by the level below, backward sweep.
    fn cycle(&self, r: &[f32]) -> Result<Vec<f32>, Error> {
        let [mut z, left] = self.sweeps.forward(r);
        let left = self.groups.restrict(&left);
        self.groups.add_prolonged(&self.below.solve(&left)?, &mut z);
        self.sweeps.backward(r, &mut z);
        Ok(z)
    }
}

/// Entries that one task sums.
const PORTION: usize = 16_384;

fn dot(a: &[f32], b: &[f32]) -> f64 {
    let portions = a.par_chunks(PORTION).zip(b.par_chunks(PORTION));
    let portions = portions.map(|(a, b)| a.iter().zip(b).map(|(a, b)| f64::from(*a) * f64::from(*b)).sum());
    in_order::<f64>(portions).iter().sum()
}

fn add(x: &mut [f32], factor: f64, direction: &[f32]) {
    for (x, d) in x.iter_mut().zip(direction) {
        *x += (factor * f64::from(*d)) as f32;
    }
}
