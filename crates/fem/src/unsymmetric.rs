//! Sparse LU factorisation of unsymmetric matrices on a symmetric pattern: analysed once a mesh, factorised once a
//! tangent.
//!
//! Multifrontal: dofs that are eliminated together, and those that they touch, make a dense front (`front.rs`); what
//! its elimination leaves is added to the front above. Fronts are those of the Cholesky factor of the same pattern, in
//! the geometric order of elimination, and faer finds them. There is no pivoting, and a singular matrix is not noticed
//! here: every solve is followed by a check of its residual ([`crate::Linearisation`]).
//!
//! A factor that has served is renewed for the next matrix: fronts into which nothing comes that has changed stay. A
//! film that breaks a little elsewhere costs a fraction of a new factor, and the factor is the same to the last bit.
//!
//! Duff, Reid, ACM Trans. Math. Softw. 9 (1983) 302 (the method); SIAM J. Sci. Stat. Comput. 5 (1984) 633
//! (unsymmetric).

mod factors;

use std::sync::Arc;

use faer::Side;
use faer::perm::PermRef;
use faer::sparse::SymbolicSparseColMatRef;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, SymbolicCholeskyRaw, SymmetricOrdering, factorize_symbolic_cholesky,
};

use crate::factorization::masked_values;
use crate::front::FrontExtent;
use crate::{Error, Matrix, Pattern};

pub use factors::UnsymmetricFactorization;

/// The analysed pattern of an unsymmetric matrix whose pattern is symmetric.
#[derive(Debug)]
pub struct UnsymmetricAnalysis {
    pattern: Arc<Pattern>,
    /// The dof that is eliminated `k`-th.
    order: Vec<u32>,
    /// The fronts from the leaves up: each stands before its parent.
    fronts: Vec<FrontalMatrix>,
    /// The rows below the own ones of each front, by their place in the order.
    below: Vec<u32>,
    /// Places of the rows of `below` in the parent front.
    in_parent: Vec<u32>,
    /// Entries of the matrix, front by front, and their places among the panels.
    entries: Vec<u32>,
    places: Vec<u32>,
    /// The numbers of all entries of panels and of updates.
    panels: usize,
    updates: usize,
}

/// A front and where its parts begin.
#[derive(Debug, Clone, Copy)]
struct FrontalMatrix {
    extent: FrontExtent,
    /// The first of its own dofs, by its place in the order.
    first: usize,
    below: usize,
    entries: usize,
    panel: usize,
    update: usize,
    /// The front to which its update is added.
    parent: Option<usize>,
}

impl UnsymmetricAnalysis {
    /// Analyses `pattern`, which must be symmetric; the dof `order[k]` is eliminated `k`-th.
    ///
    /// # Errors
    /// [`Error::TooLarge`] if indices or memory do not fit.
    // Long: the steps of a symbolic analysis, each of which needs what the last one found.
    pub fn new(pattern: Arc<Pattern>, order: Vec<u32>) -> Result<Self, Error> {
        let unknowns = pattern.dimension();
        let too_large = || Error::TooLarge { unknowns };
        let mut rank = vec![0u32; unknowns];
        for (k, &dof) in (0u32..).zip(&order) {
            rank[dof as usize] = k;
        }
        let faer_pattern = SymbolicSparseColMatRef::new_unsorted_checked(
            unknowns,
            unknowns,
            &pattern.row_start,
            None,
            &pattern.columns,
        );
        let symbolic = factorize_symbolic_cholesky(
            faer_pattern,
            Side::Lower,
            SymmetricOrdering::Custom(PermRef::new_checked(&order, &rank, unknowns)),
            CholeskySymbolicParams {
                supernodal_flop_ratio_threshold: SupernodalThreshold::FORCE_SUPERNODAL,
                ..CholeskySymbolicParams::default()
            },
        )
        .map_err(|_| too_large())?;
        let SymbolicCholeskyRaw::Supernodal(supernodes) = symbolic.raw() else {
            return Err(too_large());
        };
        let mut analysis = Self {
            below: supernodes.row_idx().to_vec(),
            in_parent: Vec::new(),
            entries: vec![0; pattern.columns.len()],
            places: vec![0; pattern.columns.len()],
            fronts: Vec::with_capacity(supernodes.n_supernodes()),
            pattern,
            order,
            panels: 0,
            updates: 0,
        };
        for s in 0..supernodes.n_supernodes() {
            let (first, end) = (supernodes.supernode_begin()[s] as usize, supernodes.supernode_end()[s] as usize);
            let below = supernodes.col_ptr_for_row_idx()[s] as usize;
            let extent =
                FrontExtent { own: end - first, below: supernodes.col_ptr_for_row_idx()[s + 1] as usize - below };
            analysis.fronts.push(FrontalMatrix {
                extent,
                first,
                below,
                entries: 0,
                panel: analysis.panels,
                update: analysis.updates,
                parent: None,
            });
            analysis.panels += extent.panel();
            analysis.updates += extent.update();
        }
        if u32::try_from(analysis.panels).is_err() {
            return Err(too_large());
        }
        let mut front_of = vec![0u32; unknowns];
        for (s, front) in (0u32..).zip(&analysis.fronts) {
            front_of[front.first..front.first + front.extent.own].fill(s);
        }
        analysis.find_parents(&front_of);
        analysis.place_entries(&front_of, &rank);
        Ok(analysis)
    }

    /// The pattern.
    pub(crate) fn pattern(&self) -> &Pattern {
        &self.pattern
    }

    /// The dofs in the order of their elimination.
    pub(crate) fn order(&self) -> &[u32] {
        &self.order
    }

    /// Rows below a front, by their place in the order.
    fn rows_below(&self, front: &FrontalMatrix) -> &[u32] {
        &self.below[front.below..front.below + front.extent.below]
    }

    /// The place in `front` of the dof eliminated `k`-th.
    fn local(&self, front: &FrontalMatrix, k: u32) -> usize {
        match (k as usize) < front.first + front.extent.own {
            true => k as usize - front.first,
            false => front.extent.own + self.rows_below(front).partition_point(|&row| row < k),
        }
    }

    fn find_parents(&mut self, front_of: &[u32]) {
        let mut in_parent = Vec::with_capacity(self.below.len());
        for s in 0..self.fronts.len() {
            let rows = self.rows_below(&self.fronts[s]);
            let parent = rows.first().map(|&row| front_of[row as usize] as usize);
            if let Some(parent) = parent {
                let local = |&row: &u32| self.local(&self.fronts[parent], row) as u32;
                in_parent.extend(rows.iter().map(local));
            }
            self.fronts[s].parent = parent;
        }
        self.in_parent = in_parent;
    }

    /// An entry belongs to the front of whichever of its row and column is eliminated first.
    fn place_entries(&mut self, front_of: &[u32], rank: &[u32]) {
        let mut next = 0;
        for s in 0..self.fronts.len() {
            self.fronts[s].entries = next;
            let front = self.fronts[s];
            for own in front.first..front.first + front.extent.own {
                let dof = self.order[own] as usize;
                for entry in self.pattern.row(dof) {
                    let other = self.pattern.columns[entry] as usize;
                    if front_of[rank[other] as usize] < s as u32 {
                        continue;
                    }
                    let (i, j) = (own - front.first, self.local(&front, rank[other]));
                    let mut put = |entry: usize, i: usize, j: usize| {
                        self.entries[next] = entry as u32;
                        self.places[next] = (front.panel + front.extent.place(i, j)) as u32;
                        next += 1;
                    };
                    put(entry, i, j);
                    if j >= front.extent.own {
                        // The pattern is symmetric, so the transposed entry is there.
                        let row = self.pattern.row(other);
                        let at = self.pattern.columns[row.clone()].iter().position(|&column| column as usize == dof);
                        put(row.start + at.unwrap_or(0), j, i);
                    }
                }
            }
        }
    }

    /// Factorises `matrix` with the rows and columns of fixed dofs replaced by those of the identity. A factor that is
    /// no longer needed is `renewed`: what has not changed since is not computed again.
    ///
    /// # Errors
    /// [`Error::NotFinite`] if an entry is not finite, [`Error::TooLarge`] if the factor does not fit.
    pub fn factorise(
        self: &Arc<Self>,
        matrix: &Matrix,
        fixed: &[bool],
        renewed: Option<UnsymmetricFactorization>,
    ) -> Result<UnsymmetricFactorization, Error> {
        let masked = masked_values(matrix, fixed)?;
        let (mut factor, fresh) = match renewed {
            Some(factor) => (factor, false),
            None => (UnsymmetricFactorization::zero(self.clone())?, true),
        };
        let mut stale = vec![fresh; self.fronts.len()];
        for s in 0..self.fronts.len() {
            let front = &self.fronts[s];
            let end = self.fronts.get(s + 1).map_or(self.entries.len(), |next| next.entries);
            for (value, &entry) in factor.input[front.entries..end].iter_mut().zip(&self.entries[front.entries..end]) {
                stale[s] |= *value != masked[entry as usize];
                *value = masked[entry as usize];
            }
            if let Some(parent) = front.parent {
                stale[parent] |= stale[s];
            }
        }
        // Children of each front.
        let mut first_child = vec![None; self.fronts.len()];
        let mut next_child = vec![None; self.fronts.len()];
        for (s, stale) in stale.into_iter().enumerate() {
            if let Some(parent) = self.fronts[s].parent {
                next_child[s] = first_child[parent].replace(s);
            }
            if stale {
                let children = std::iter::successors(first_child[s], |&child| next_child[child]);
                factor.renew(s, children);
            }
        }
        Ok(factor)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assembly::tests::wavy_ring;
    use crate::{Constraints, ControlVolumes, Linearisation, Space};

    /// Upwind transport with diffusion on a line of `n` points.
    fn line(n: u32) -> Matrix {
        let rows = |i: u32| i.saturating_sub(1)..(i + 2).min(n);
        let mut row_start = vec![0];
        let (mut columns, mut values) = (Vec::new(), Vec::new());
        for i in 0..n {
            for j in rows(i) {
                columns.push(j);
                values.push(match (i, j) {
                    (i, j) if i == j => 5.0 + f64::from(i % 3),
                    (i, j) if j < i => -4.0,
                    _ => -0.5,
                });
            }
            row_start.push(columns.len() as u32);
        }
        Matrix { pattern: Arc::new(Pattern { row_start, columns }), values }
    }

    #[test]
    fn both_systems_are_solved_and_given_dofs_stay() {
        let matrix = line(30);
        let analysis = Arc::new(
            UnsymmetricAnalysis::new(matrix.pattern.clone(), (0..matrix.pattern.dimension() as u32).collect()).unwrap(),
        );
        let mut constraints = Constraints::none(30);
        constraints.fix(7, 0.0);
        let factor = analysis.factorise(&matrix, &constraints.fixed, None).unwrap();
        let linearisation = Linearisation::unsymmetric(matrix, factor, constraints);
        let b: Vec<f64> = (0..30).map(|i| f64::from(i).sin()).collect();
        let (x, y) = (linearisation.solve(&b).unwrap(), linearisation.solve_transposed(&b).unwrap());
        assert_eq!((x[7], y[7]), (0.0, 0.0));
        let left = linearisation.matrix().multiply(&x);
        assert!((0..30).filter(|&i| i != 7).all(|i| (left[i] - b[i]).abs() < 1e-13));
        // b . A^-1 b is the same from both sides.
        let dot = |v: &[f64]| v.iter().zip(&b).map(|(v, b)| v * b).sum::<f64>() - v[7] * b[7];
        assert!((dot(&x) - dot(&y)).abs() < 1e-13);
    }

    #[test]
    fn a_singular_matrix_is_refused() {
        let mut matrix = line(12);
        let rows: Vec<usize> = matrix.pattern.row(5).collect();
        for k in rows {
            matrix.values[k] = 0.0;
        }
        let analysis = Arc::new(
            UnsymmetricAnalysis::new(matrix.pattern.clone(), (0..matrix.pattern.dimension() as u32).collect()).unwrap(),
        );
        let constraints = Constraints::none(12);
        let solved = analysis
            .factorise(&matrix, &constraints.fixed, None)
            .and_then(|factor| Linearisation::unsymmetric(matrix, factor, constraints).solve(&[1.0; 12]));
        assert!(solved.is_err());
    }

    /// On a mesh, whose fronts have several levels; a factor that is renewed is the one made anew, to the last bit.
    #[test]
    fn a_renewed_factor_is_a_new_one() {
        let space = Space::new(wavy_ring(40, 12), 2);
        let volumes = ControlVolumes::new(&space).unwrap();
        let n = space.dofs();
        let mut matrix = Matrix::zero(volumes.pattern.clone());
        for i in 0..n {
            for k in volumes.pattern.row(i) {
                matrix.values[k] = match volumes.pattern.columns[k] as usize {
                    j if j == i => 9.0,
                    j => -0.5 - (0.37 * (i + 3 * j) as f64).sin(),
                };
            }
        }
        let b: Vec<f64> = (0..n).map(|i| (i as f64).cos()).collect();
        let off = |ax: Vec<f64>| ax.iter().zip(&b).map(|(ax, b)| (ax - b).abs()).fold(0.0, f64::max);
        let fixed = vec![false; n];
        let first = volumes.analysis.factorise(&matrix, &fixed, None).unwrap();
        let (mut x, mut y) = (b.clone(), b.clone());
        first.solve(&mut x).unwrap();
        first.solve_transposed(&mut y).unwrap();
        assert!(off(matrix.multiply(&x)) < 1e-12 && off(matrix.multiply_transposed(&y)) < 1e-12);
        for i in [3, n / 2, n / 2 + 1] {
            matrix.add_to_diagonal(i, 0.25);
        }
        let renewed = volumes.analysis.factorise(&matrix, &fixed, Some(first)).unwrap();
        let anew = volumes.analysis.factorise(&matrix, &fixed, None).unwrap();
        assert!(renewed.panels == anew.panels);
        x.clone_from(&b);
        renewed.solve(&mut x).unwrap();
        assert!(off(matrix.multiply(&x)) < 1e-12);
    }
}
