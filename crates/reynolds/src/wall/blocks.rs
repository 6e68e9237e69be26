//! A sparse matrix of the dofs of a mesh and the splines of a grid, triangle by triangle.

use std::ops::AddAssign;

use oilwedge_fem::Space;
use oilwedge_fem::integrate::Nodal;

use super::grid::{Grid, Part};

/// For each triangle its splines, and for each of these the entries with all of its dofs.
#[derive(Debug, Clone, Default)]
pub(super) struct Blocks {
    /// Where the splines of each triangle end.
    ends: Vec<usize>,
    splines: Vec<u32>,
    /// All dofs of one spline after those of the one before.
    entries: Vec<f64>,
}

impl Blocks {
    /// Adds, at each of some `positions` [m] of a triangle, a part of each spline times the shares of that position in the first `shapes` dofs of the triangle.
    pub(super) fn add(
        &mut self,
        (grid, part): (&Grid, Part),
        positions: &[[f64; 2]],
        shares: impl Fn(usize) -> Nodal,
        shapes: usize,
    ) {
        for (q, &position) in positions.iter().enumerate() {
            let shares = shares(q);
            grid.each_part_at(part, position, |spline, value| {
                // A triangle knows few splines.
                let place = self.splines.iter().position(|&other| other == spline as u32);
                let place = place.unwrap_or_else(|| {
                    self.splines.push(spline as u32);
                    self.entries.extend(std::iter::repeat_n(0.0, shapes));
                    self.splines.len() - 1
                });
                let entries = &mut self.entries[place * shapes..(place + 1) * shapes];
                (entries.iter_mut().zip(&shares)).for_each(|(sum, share)| *sum += value * share);
            });
        }
    }

    /// The block of a triangle to which all has been added.
    pub(super) fn ended(mut self) -> Self {
        self.ends.push(self.splines.len());
        self
    }

    /// The product with a number for each spline: one for each dof of the space.
    pub(super) fn times(&self, space: &Space, of_splines: &[f64]) -> Vec<f64> {
        let mut of_dofs = vec![0.0; space.dofs()];
        self.each(space, |spline, dofs, entries| {
            for (&dof, entry) in dofs.iter().zip(entries) {
                of_dofs[dof] += entry * of_splines[spline];
            }
        });
        of_dofs
    }

    /// The transposed product, with a number for each dof: one for each of so many splines.
    pub(super) fn transposed(&self, space: &Space, of_dofs: &[f64], splines: usize) -> Vec<f64> {
        let mut of_splines = vec![0.0; splines];
        self.each(space, |spline, dofs, entries| {
            let sum: f64 = entries.iter().zip(dofs).map(|(part, &dof)| part * of_dofs[dof]).sum();
            of_splines[spline] += sum;
        });
        of_splines
    }

    /// Calls `visit` with each spline of each triangle, the dofs of the triangle and the entries of both.
    fn each(&self, space: &Space, mut visit: impl FnMut(usize, &[usize], &[f64])) {
        let (shapes, mut begin) = (space.shapes(), 0);
        for (t, &end) in self.ends.iter().enumerate() {
            let dofs = &space.element_dofs(t)[..shapes];
            for k in begin..end {
                let entries = &self.entries[k * shapes..(k + 1) * shapes];
                visit(self.splines[k] as usize, dofs, entries);
            }
            begin = end;
        }
    }
}

impl AddAssign for Blocks {
    fn add_assign(&mut self, mut other: Self) {
        let before = self.splines.len();
        self.ends.extend(other.ends.iter().map(|end| before + end));
        self.splines.append(&mut other.splines);
        self.entries.append(&mut other.entries);
    }
}
