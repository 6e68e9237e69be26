//! The film on the vertices alone, by which the error of a mass-conserving film is estimated.
//!
//! A mass-conserving film lives on the linear sub-mesh of its nodes: vertices and the middles of edges. Without the
//! middles the scheme works on the triangles themselves: cells twice as wide, a quarter of the unknowns, the
//! same holes, grooves and lines. Its search starts from the film that is there, so it takes few steps.

use std::sync::Arc;

use oilwedge_fem::Space;
use oilwedge_fem::complementarity::WarmStart;

use super::solve;
use crate::film_start::StepBudget;
use crate::{FilmSystem, NoFilm, SolvedFilm};

impl FilmSystem {
    /// The system of linear elements on this mesh with the same given pressures; made once.
    pub fn vertices_only(&self) -> &Arc<Self> {
        self.vertices.get_or_init(|| Arc::new(self.on_vertices()))
    }

    /// A system of linear elements on this mesh with the same given pressures.
    pub fn on_vertices(&self) -> Self {
        let space = Space::new(self.space().mesh().clone(), 1);
        let supply = self.supply.on_space(&space);
        Self::with_supply(space, supply)
    }
}

impl SolvedFilm {
    /// The film on [`FilmSystem::vertices_only`], started from this mass-conserving one.
    ///
    /// # Errors
    /// [`NoFilm`]: the reason why there is none; this one may still be sound, but for [`NoFilm::NearLimit`].
    pub fn coarse_comparison(&self) -> Result<Self, NoFilm> {
        let coarse = self.coarse_comparison_unchecked()?;
        self.check_resolved(&coarse)?;
        coarse.check_existence()?;
        Ok(coarse)
    }

    /// The film on the vertices alone whether or not the viscosity law has a pressure for it.
    pub(crate) fn coarse_comparison_unchecked(&self) -> Result<Self, NoFilm> {
        let Self { problem, system, solution } = self;
        let vertices = system.vertices_only();
        let dofs = vertex_dofs(system.space());
        let start = WarmStart {
            u: dofs.iter().map(|&dof| solution.unknown[dof]).collect(),
            held: dofs.iter().map(|&dof| solution.cavity[dof]).collect(),
        };
        let problem = problem.on_vertices();
        let solution = solve((&problem, vertices, 1.0), start, StepBudget::UntilSettled)?;
        Ok(Self::new(problem, vertices, solution))
    }
}

/// The dof of each vertex.
fn vertex_dofs(space: &Space) -> Vec<usize> {
    let vertices = 0..space.mesh().points().len() as u32;
    vertices.map(|vertex| space.vertex_dof(vertex)).collect()
}
