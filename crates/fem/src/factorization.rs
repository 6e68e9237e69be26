//! Sparse Cholesky factorisation: analysed once a mesh, factorised once a tangent.
//!
//! Wraps faer, whose threads do not pay on two-dimensional problems: it runs sequentially.

use std::sync::{Arc, OnceLock};

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::LltRegularization;
use faer::perm::PermRef;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, LltRef, SymbolicCholesky, SymbolicCholeskyRaw, SymmetricOrdering,
    factorize_symbolic_cholesky,
};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, MatMut, Par, Side};

use crate::{Error, Matrix, Pattern, Space, ordering};

/// The pattern of the Cholesky factor in the geometric elimination order.
#[derive(Debug)]
pub struct Analysis {
    symbolic: SymbolicCholesky<u32>,
    pattern: Arc<Pattern>,
}

impl Analysis {
    /// Orders and analyses the pattern of `space`.
    ///
    /// # Errors
    /// [`Error::TooLarge`] if the factor's indices or its memory do not fit.
    pub fn new(space: &Space, pattern: Arc<Pattern>) -> Result<Self, Error> {
        let order = ordering::elimination_order(space);
        let mut inverse = vec![0u32; order.len()];
        for (k, &dof) in order.iter().enumerate() {
            inverse[dof as usize] = k as u32;
        }
        let n = pattern.dimension();
        Self::ordered(pattern, SymmetricOrdering::Custom(PermRef::new_checked(&order, &inverse, n)))
    }

    /// Analyses a symmetric pattern of which no positions are known, in an order of minimum degree.
    ///
    /// # Errors
    /// [`Error::TooLarge`] if the factor's indices or its memory do not fit.
    pub(crate) fn of_pattern(pattern: Arc<Pattern>) -> Result<Self, Error> {
        Self::ordered(pattern, SymmetricOrdering::Amd)
    }

    fn ordered(pattern: Arc<Pattern>, order: SymmetricOrdering<'_, u32>) -> Result<Self, Error> {
        let unknowns = pattern.dimension();
        let symbolic = factorize_symbolic_cholesky(
            faer_pattern(&pattern),
            Side::Lower,
            order,
            // Blocks of columns pay from a thousand unknowns on, a half at five thousand.
            CholeskySymbolicParams {
                supernodal_flop_ratio_threshold: SupernodalThreshold::FORCE_SUPERNODAL,
                ..CholeskySymbolicParams::default()
            },
        )
        .map_err(|_| Error::TooLarge { unknowns })?;
        Ok(Self { symbolic, pattern })
    }

    /// Entries that are stored of the Cholesky factor: blocks of columns hold zeros above their diagonal too.
    pub fn factor_entries(&self) -> usize {
        self.symbolic.len_val()
    }

    /// Multiplications and additions of a factorisation: the sum of the squares of the column counts.
    pub fn factor_flops(&self) -> f64 {
        let squares = |longest: usize, columns: usize| -> f64 {
            let counts = (0..columns).map(|k| (longest - k) as f64);
            counts.map(|count| count * count).sum()
        };
        match self.symbolic.raw() {
            SymbolicCholeskyRaw::Simplicial(columns) => {
                let ends = columns.col_ptr().windows(2);
                ends.map(|ends| squares((ends[1] - ends[0]) as usize, 1)).sum()
            }
            SymbolicCholeskyRaw::Supernodal(blocks) => {
                let width = |s: usize| (blocks.supernode_end()[s] - blocks.supernode_begin()[s]) as usize;
                let below = |s: usize| blocks.supernode(s).pattern().len();
                let blocks = 0..blocks.n_supernodes();
                blocks.map(|s| squares(width(s) + below(s), width(s))).sum()
            }
        }
    }

    /// Factorises `matrix` with the rows and columns of fixed dofs replaced by those of the identity.
    ///
    /// # Errors
    /// [`Error::NotFinite`] if an entry is not finite, [`Error::NotPositiveDefinite`] if a pivot is not positive.
    pub fn factorise(self: &Arc<Self>, matrix: &Matrix, fixed: &[bool]) -> Result<Factorization, Error> {
        let masked = masked_values(matrix, fixed)?;
        let mut factor = vec![0.0; self.symbolic.len_val()];
        let requirement = self.symbolic.factorize_numeric_llt_scratch::<f64>(Par::Seq, Default::default());
        let unknowns = self.pattern.dimension();
        let mut memory = MemBuffer::try_new(requirement).map_err(|_| Error::TooLarge { unknowns })?;
        self.symbolic
            .factorize_numeric_llt(
                &mut factor,
                SparseColMatRef::new(faer_pattern(&self.pattern), &masked),
                Side::Lower,
                LltRegularization::default(),
                Par::Seq,
                MemStack::new(&mut memory),
                Default::default(),
            )
            .map_err(|_| Error::NotPositiveDefinite)?;
        Ok(Factorization { analysis: Arc::clone(self), factor })
    }
}

/// An analysis that is made when it is first asked for.
#[derive(Debug)]
pub struct LazyAnalysis {
    space: Space,
    pattern: Arc<Pattern>,
    made: OnceLock<Result<Arc<Analysis>, Error>>,
}

impl LazyAnalysis {
    /// The analysis of matrices with `pattern` on `space`.
    pub fn new(space: Space, pattern: Arc<Pattern>) -> Self {
        Self { space, pattern, made: OnceLock::new() }
    }

    /// The analysis.
    ///
    /// # Errors
    /// [`Error::TooLarge`] as [`Analysis::new`].
    pub fn get(&self) -> Result<&Arc<Analysis>, Error> {
        let made = (self.made).get_or_init(|| Analysis::new(&self.space, self.pattern.clone()).map(Arc::new));
        made.as_ref().map_err(Clone::clone)
    }
}

/// The Cholesky factor of a masked matrix.
#[derive(Debug)]
pub struct Factorization {
    analysis: Arc<Analysis>,
    factor: Vec<f64>,
}

impl Factorization {
    /// Solves `A x = b` in place.
    ///
    /// # Errors
    /// [`Error::NotFinite`] if the solution is not finite.
    pub fn solve(&self, x: &mut [f64]) -> Result<(), Error> {
        let symbolic = &self.analysis.symbolic;
        let unknowns = x.len();
        let requirement = symbolic.solve_in_place_scratch::<f64>(1, Par::Seq);
        let mut memory = MemBuffer::try_new(requirement).map_err(|_| Error::TooLarge { unknowns })?;
        LltRef::new(symbolic, &self.factor).solve_in_place_with_conj(
            Conj::No,
            MatMut::from_column_major_slice_mut(x, unknowns, 1),
            Par::Seq,
            MemStack::new(&mut memory),
        );
        if x.iter().all(|x| x.is_finite()) {
            Ok(())
        } else {
            Err(Error::NotFinite { what: "solution of the linear system" })
        }
    }
}

/// The factor in single precision: half the bytes, for those who only need a rough inverse.
#[derive(Debug)]
pub struct SingleFactor {
    analysis: Arc<Analysis>,
    factor: Vec<f32>,
}

impl Factorization {
    /// The factor in single precision.
    pub fn single(&self) -> SingleFactor {
        SingleFactor {
            analysis: Arc::clone(&self.analysis),
            factor: self.factor.iter().map(|&value| value as f32).collect(),
        }
    }
}

impl SingleFactor {
    /// Solves `A x = b` in place to some seven digits, less the condition of `A`.
    ///
    /// # Errors
    /// [`Error::NotFinite`] if the solution is not finite.
    pub fn solve(&self, x: &mut [f64]) -> Result<(), Error> {
        let greatest = x.iter().fold(0.0, |greatest: f64, x| greatest.max(x.abs()));
        if greatest == 0.0 {
            return Ok(());
        }
        // The range of single precision is small.
        let mut rough: Vec<f32> = x.iter().map(|x| (x / greatest) as f32).collect();
        self.solve_rough(&mut rough)?;
        for (x, rough) in x.iter_mut().zip(&rough) {
            *x = greatest * f64::from(*rough);
        }
        Ok(())
    }

    /// [`SingleFactor::solve`] of numbers that have single precision already.
    ///
    /// # Errors
    /// [`Error::NotFinite`] if the solution is not finite.
    pub(crate) fn solve_rough(&self, x: &mut [f32]) -> Result<(), Error> {
        let symbolic = &self.analysis.symbolic;
        let unknowns = x.len();
        let requirement = symbolic.solve_in_place_scratch::<f32>(1, Par::Seq);
        let mut memory = MemBuffer::try_new(requirement).map_err(|_| Error::TooLarge { unknowns })?;
        LltRef::new(symbolic, &self.factor).solve_in_place_with_conj(
            Conj::No,
            MatMut::from_column_major_slice_mut(x, unknowns, 1),
            Par::Seq,
            MemStack::new(&mut memory),
        );
        match x.iter().all(|x| x.is_finite()) {
            true => Ok(()),
            false => Err(Error::NotFinite { what: "solution of the linear system" }),
        }
    }
}

/// The pattern as faer sees it: symmetric, so rows may be read as columns.
fn faer_pattern(pattern: &Pattern) -> SymbolicSparseColMatRef<'_, u32> {
    let n = pattern.dimension();
    SymbolicSparseColMatRef::new_unsorted_checked(n, n, &pattern.row_start, None, &pattern.columns)
}

/// The values of `matrix` with the rows and columns of fixed dofs replaced by those of the identity.
pub(crate) fn masked_values(matrix: &Matrix, fixed: &[bool]) -> Result<Vec<f64>, Error> {
    let Pattern { row_start, columns } = &*matrix.pattern;
    let mut masked = matrix.values.clone();
    for (i, &row_fixed) in fixed.iter().enumerate() {
        for k in row_start[i] as usize..row_start[i + 1] as usize {
            let j = columns[k] as usize;
            if row_fixed || fixed[j] {
                masked[k] = if i == j { 1.0 } else { 0.0 };
            }
        }
    }
    if masked.iter().all(|value| value.is_finite()) { Ok(masked) } else { Err(Error::NotFinite { what: "matrix" }) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Assembler;
    use oilwedge_mesh::{Mesh, RawMesh};

    /// All nodes of one triangle meet: the factor is one block of six columns, with 6, 5, ... 1 entries that are not
    /// zero.
    #[test]
    fn operations_are_the_squares_of_the_columns() {
        let raw = RawMesh {
            points: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]],
            triangles: vec![[0, 1, 2]],
            ..RawMesh::default()
        };
        let assembler = Assembler::new(Space::new(Arc::new(Mesh::build(raw).unwrap()), 2));
        let analysis = Analysis::new(assembler.space(), assembler.pattern().clone()).unwrap();
        assert_eq!(analysis.factor_entries(), 36);
        assert_eq!(analysis.factor_flops(), 91.0);
    }
}
