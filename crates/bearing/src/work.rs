//! What a search has cost.

use std::ops::AddAssign;

/// Films, factorisations and solves of linear systems.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Work {
    /// Films solved, on coarser meshes too.
    pub films: usize,
    /// Factorisations on the mesh of the answer; with multigrid of its coarsest level.
    pub factorisations: usize,
    /// Linear systems solved on the mesh of the answer, those of tangents included.
    pub linear_solves: usize,
}

impl AddAssign for Work {
    fn add_assign(&mut self, other: Self) {
        self.films += other.films;
        self.factorisations += other.factorisations;
        self.linear_solves += other.linear_solves;
    }
}
