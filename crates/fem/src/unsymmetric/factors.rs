//! The LU factors, front by front: elimination and triangular solves.

use std::sync::Arc;

use super::UnsymmetricAnalysis;
use crate::Error;
use crate::front::FrontExtent;

/// The LU factors of a masked matrix.
#[derive(Debug)]
pub struct UnsymmetricFactorization {
    analysis: Arc<UnsymmetricAnalysis>,
    /// Entries of the matrix, front by front.
    pub(super) input: Vec<f64>,
    pub(super) panels: Vec<f64>,
    updates: Vec<f64>,
}

impl UnsymmetricFactorization {
    pub(super) fn zero(analysis: Arc<UnsymmetricAnalysis>) -> Result<Self, Error> {
        Ok(Self {
            input: vec![0.0; analysis.entries.len()],
            panels: vec![0.0; analysis.panels],
            updates: vec![0.0; analysis.updates],
            analysis,
        })
    }

    /// Assembles a front from entries of the matrix and updates of its children, and eliminates its own dofs.
    pub(super) fn renew(&mut self, s: usize, children: impl Iterator<Item = usize>) {
        let analysis = &*self.analysis;
        let front = &analysis.fronts[s];
        let end = analysis.fronts.get(s + 1).map_or(analysis.entries.len(), |next| next.entries);
        let panel = &mut self.panels[front.panel..front.panel + front.extent.panel()];
        let (before, update) = self.updates.split_at_mut(front.update);
        let update = &mut update[..front.extent.update()];
        panel.fill(0.0);
        update.fill(0.0);
        for (value, &place) in self.input[front.entries..end].iter().zip(&analysis.places[front.entries..end]) {
            panel[place as usize - front.panel] = *value;
        }
        for child in children {
            let child = &analysis.fronts[child];
            let from = &before[child.update..child.update + child.extent.update()];
            let places = &analysis.in_parent[child.below..child.below + child.extent.below];
            front.extent.add(from, places, panel, update);
        }
        front.extent.eliminate(panel, update);
    }

    /// Solves `A x = b` in place.
    ///
    /// # Errors
    /// [`Error::NotFinite`] if the solution is not finite.
    pub fn solve(&self, x: &mut [f64]) -> Result<(), Error> {
        self.both_ways(x, FrontExtent::solve_lower, FrontExtent::solve_upper)
    }

    /// Solves `A^T x = b` in place.
    ///
    /// # Errors
    /// [`Error::NotFinite`] if the solution is not finite.
    pub fn solve_transposed(&self, x: &mut [f64]) -> Result<(), Error> {
        self.both_ways(x, FrontExtent::solve_upper_transposed, FrontExtent::solve_lower_transposed)
    }

    /// Runs through the fronts in the order of elimination by `first`, and back by `second`.
    fn both_ways(&self, x: &mut [f64], first: FrontSolve, second: FrontSolve) -> Result<(), Error> {
        let analysis = &*self.analysis;
        let mut ordered: Vec<f64> = analysis.order.iter().map(|&dof| x[dof as usize]).collect();
        let mut local = Vec::new();
        for (step, front) in (analysis.fronts.iter().map(|front| (first, front)))
            .chain(analysis.fronts.iter().rev().map(|front| (second, front)))
        {
            let (own, below) = (front.first..front.first + front.extent.own, analysis.rows_below(front));
            local.clear();
            local.extend_from_slice(&ordered[own.clone()]);
            local.extend(below.iter().map(|&row| ordered[row as usize]));
            step(front.extent, &self.panels[front.panel..front.panel + front.extent.panel()], &mut local);
            ordered[own].copy_from_slice(&local[..front.extent.own]);
            for (&row, value) in below.iter().zip(&local[front.extent.own..]) {
                ordered[row as usize] = *value;
            }
        }
        for (&dof, value) in analysis.order.iter().zip(&ordered) {
            x[dof as usize] = *value;
        }
        match x.iter().all(|x| x.is_finite()) {
            true => Ok(()),
            false => Err(Error::NotFinite { what: "solution of the linear system" }),
        }
    }
}

/// What a front does in a solve: its extent, its panel, and the unknowns of its rows.
type FrontSolve = fn(FrontExtent, &[f64], &mut [f64]);
