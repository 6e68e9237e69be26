//! Linear functions as quadratic ones on the same mesh: at the middle of an edge, the mean of its ends.
//!
//! The step down from quadratic elements to their vertices, for `multigrid.rs`. A vertex counts as masked where its
//! function would touch a masked dof: where it is masked itself, or any of its edges is.

use std::sync::Arc;

use rayon::prelude::*;

use crate::sparsity::Sparsity;
use crate::{Matrix, Pattern, Space};

/// Rows that one task computes.
const ROWS_A_TASK: usize = 8192;

/// Prolongation from the linear to the quadratic space of one mesh.
#[derive(Debug)]
pub struct LinearProlongation {
    /// The pattern of the quadratic space.
    quadratic: Arc<Pattern>,
    /// The pattern of the linear space.
    linear: Arc<Pattern>,
    /// Dof of each vertex.
    vertex_dofs: Vec<u32>,
    /// Vertices whose mean a dof is; its own twice for that of a vertex.
    ends: Vec<[u32; 2]>,
}

impl LinearProlongation {
    /// The prolongation to the quadratic `space`, whose matrices have the pattern `quadratic`.
    pub fn new(space: &Space, quadratic: Arc<Pattern>) -> Self {
        let mesh = space.mesh();
        let vertex_dofs: Vec<u32> = (0..mesh.points().len() as u32).map(|v| space.vertex_dof(v) as u32).collect();
        let mut ends = vec![[0; 2]; space.dofs()];
        for (v, &dof) in (0u32..).zip(&vertex_dofs) {
            ends[dof as usize] = [v, v];
        }
        for (e, &vertices) in (0u32..).zip(&mesh.topology().edges) {
            ends[space.edge_dof(e)] = vertices;
        }
        Self { quadratic, linear: Sparsity::new(&Space::new(mesh.clone(), 1)).pattern, vertex_dofs, ends }
    }

    /// Dofs of the edges at vertex `v`: they follow its neighbours in its row (see [`crate::sparsity`]).
    fn edges_at(&self, v: usize) -> &[u32] {
        let degree = self.linear.row(v).len() - 1;
        let first = self.quadratic.row_start[self.vertex_dofs[v] as usize] as usize + 1 + degree;
        &self.quadratic.columns[first..first + degree]
    }

    /// Whether each vertex is masked.
    pub(crate) fn masked(&self, fixed: &[bool]) -> Vec<bool> {
        let mut masked = vec![false; self.vertex_dofs.len()];
        for (&fixed, ends) in fixed.iter().zip(&self.ends) {
            if fixed {
                ends.iter().for_each(|&v| masked[v as usize] = true);
            }
        }
        masked
    }

    /// A residual tested with linear functions.
    pub(crate) fn restrict(&self, r: &[f32]) -> Vec<f32> {
        let mut linear = vec![0.0; self.vertex_dofs.len()];
        linear.par_chunks_mut(ROWS_A_TASK).enumerate().for_each(|(task, out)| {
            for (k, out) in out.iter_mut().enumerate() {
                let v = task * ROWS_A_TASK + k;
                let middles: f32 = self.edges_at(v).iter().map(|&e| r[e as usize]).sum();
                *out = r[self.vertex_dofs[v] as usize] + 0.5 * middles;
            }
        });
        linear
    }

    /// Adds the linear function with the values `correction` to `z`.
    pub(crate) fn add_prolonged(&self, correction: &[f32], z: &mut [f32]) {
        let portions = z.par_chunks_mut(ROWS_A_TASK).zip(self.ends.par_chunks(ROWS_A_TASK));
        portions.for_each(|(z, ends)| {
            for (z, &[a, b]) in z.iter_mut().zip(ends) {
                *z += 0.5 * (correction[a as usize] + correction[b as usize]);
            }
        });
    }

    /// `P^T A P` with the masked rows and columns of `A` left out.
    pub(crate) fn galerkin(&self, matrix: &Matrix, fixed: &[bool]) -> Matrix {
        let vertices = self.vertex_dofs.len();
        let mut values = vec![0.0; self.linear.columns.len()];
        let mut tasks = Vec::new();
        let mut rest = &mut values[..];
        for first in (0..vertices).step_by(ROWS_A_TASK) {
            let last = (first + ROWS_A_TASK).min(vertices);
            let entries = self.linear.row_start[last] - self.linear.row_start[first];
            let (own, after) = rest.split_at_mut(entries as usize);
            rest = after;
            tasks.push((first..last, own));
        }
        tasks.into_par_iter().for_each(|(range, values)| {
            let begin = self.linear.row_start[range.start] as usize;
            // Where the current row has the entry of a vertex.
            let mut place = vec![0u32; vertices];
            for v in range {
                for k in self.linear.row(v) {
                    place[self.linear.columns[k] as usize] = (k - begin) as u32;
                }
                let mut add = |dof: usize, weight: f64| {
                    if fixed[dof] {
                        return;
                    }
                    for k in self.quadratic.row(dof) {
                        let column = self.quadratic.columns[k] as usize;
                        if fixed[column] {
                            continue;
                        }
                        let half = 0.5 * weight * matrix.values[k];
                        for end in self.ends[column] {
                            values[place[end as usize] as usize] += half;
                        }
                    }
                };
                add(self.vertex_dofs[v] as usize, 1.0);
                self.edges_at(v).iter().for_each(|&e| add(e as usize, 0.5));
            }
        });
        Matrix { pattern: self.linear.clone(), values }
    }
}
