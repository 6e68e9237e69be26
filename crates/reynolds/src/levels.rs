//! Nested iteration: a film is solved on coarser meshes of its liner first, to find where it breaks.
//!
//! A cold active set walks the edge of a cavity one row of nodes an iteration; started from a coarser
//! mesh it is a row off. The coarser mesh has no holes or grooves of its own: pressure is given at those of its
//! nodes that lie in them. So every mesh has coarser ones, drawn or imported.

use std::sync::Arc;

use oilwedge_fem::complementarity::WarmStart;
use oilwedge_fem::control_volumes::{sub_triangle_at, sub_triangles};
use oilwedge_fem::{Field, Space, lagrange};
use oilwedge_mesh::coarsen;
use oilwedge_mesh::developed::LinerDomain;
use oilwedge_mesh::generate::Sense;
use oilwedge_mesh::locate::Locator;
use oilwedge_mesh::quality::lies_in_rows;
use rayon::prelude::*;

use crate::film_start::FilmStart;
use crate::film_thickness::FilmContribution;
use crate::supply::{BoundaryKind, SupplyRegion};
use crate::{Bearing, Cavitation, FilmProblem, FilmSolution, FilmSystem, SolvedFilm};

/// Edges of a coarser mesh over those of the finer.
const RATIO: f64 = 2.0;

/// How the triangles of coarser meshes lie.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LevelLayout {
    /// Rows along the flow for a film that conserves oil, where its own mesh lies in rows: oil that triangles spread
    /// across the flow would feed a film that should starve.
    Rows,
    /// Free triangles.
    Free,
}

/// A coarser mesh and the film on it.
#[derive(Debug)]
pub struct CoarseLevel {
    /// Unknowns and given pressures there.
    pub system: Arc<FilmSystem>,
    pub(crate) film_thickness: Vec<Arc<dyn FilmContribution>>,
    /// Triangle of the finer mesh in which each triangle lies.
    pub(crate) parents: Vec<u32>,
    /// Where each dof of the finer mesh lies: triangle of the coarser mesh and reference point.
    places: Vec<(u32, [f64; 2])>,
}

impl FilmSystem {
    /// The system with coarser ones behind it for a problem, as long as there are any.
    pub fn with_coarser(self, problem: &FilmProblem, layout: LevelLayout) -> Self {
        self.with_levels(problem, layout, &problem.film_thickness)
    }

    fn with_levels(
        mut self,
        problem: &FilmProblem,
        layout: LevelLayout,
        film_thickness: &[Arc<dyn FilmContribution>],
    ) -> Self {
        self.coarser = CoarseLevel::of(&self, (problem, layout), film_thickness).map(Box::new);
        self
    }
}

impl CoarseLevel {
    fn of(
        fine: &FilmSystem,
        (problem, layout): (&FilmProblem, LevelLayout),
        film_thickness: &[Arc<dyn FilmContribution>],
    ) -> Option<Self> {
        let (mesh, bearing) = (fine.space().mesh(), &problem.bearing);
        let (liner, line) = (liner(fine, bearing), line(fine, bearing));
        let coarse = match layout {
            LevelLayout::Rows if problem.cavitation.conserves_oil() && lies_in_rows(mesh) => {
                coarsen::coarser_in_rows(mesh, &liner, line, RATIO, Sense::of(problem.journal.speed))
            }
            LevelLayout::Rows | LevelLayout::Free => coarsen::coarser(mesh, &liner, line, RATIO),
        }?;
        // A mesh that is bound by its length, not by the sizes asked for, would not become coarser for ever.
        if 2 * coarse.mesh.triangles().len() > mesh.triangles().len() {
            return None;
        }
        let space = Space::new(Arc::new(coarse.mesh), fine.space().degree());
        let supply = fine.supply.on_coarser(fine.space(), &space, bearing)?;
        let film_thickness: Vec<_> =
            (film_thickness.iter()).map(|contribution| contribution.carried(&coarse.parents)).collect();
        let locator = Locator::new(space.mesh());
        let places = (fine.space().positions().into_par_iter())
            .map(|position| locator.nearest(position))
            .map(|place| place.map(|(triangle, point)| (triangle as u32, point)))
            .collect::<Option<_>>()?;
        let system = FilmSystem::with_supply(space, supply);
        Some(Self {
            system: Arc::new(system.with_levels(problem, layout, &film_thickness)),
            film_thickness,
            parents: coarse.parents,
            places,
        })
    }

    /// The film on the coarser mesh. Its viscosity does not vary across the film: it is a start alone.
    pub fn problem(&self, fine: &FilmProblem) -> FilmProblem {
        let film_thickness = self.film_thickness.clone();
        let problem = FilmProblem { film_thickness, viscosity_across: None, ..fine.clone() };
        problem.deflected(fine.deflection())
    }

    /// Values at the dofs of the coarser mesh, so many each, at those of the finer one: linear on the sub-triangles.
    pub fn prolonged(&self, values: &[f64], each: usize) -> Vec<f64> {
        let space = self.system.space();
        let at = |&(triangle, point): &(u32, [f64; 2])| {
            let triangle = triangle as usize;
            let (sub, weights) = sub_triangle_at(space, triangle, point);
            let (corners, dofs) = (sub_triangles(space, triangle)[sub], space.element_dofs(triangle));
            let corners = corners.map(|corner| dofs[corner]);
            (0..each).map(move |k| (0..3).map(|c| weights[c] * values[corners[c] * each + k]).sum())
        };
        self.places.iter().flat_map(at).collect()
    }

    /// What one step of the film on the finer mesh starts from where this one is that of the coarser mesh.
    pub fn start_of(&self, film: &SolvedFilm) -> FilmStart {
        FilmStart(self.carried(&film.solution, film.problem.cavitation))
    }

    /// A film of the coarser mesh as a start on the finer one. A dof is in the cavity if the nearest node is that can
    /// be: any one of a mass-conserving film or of linear elements, those amid edges of Swift-Stieber's quadratic ones.
    pub(crate) fn carried(&self, film: &FilmSolution, cavitation: Cavitation) -> WarmStart {
        let space = self.system.space();
        let nodes = lagrange::nodes(space.degree());
        let voters = match cavitation.obstacle() {
            Some(_) if space.degree() > 1 => 3..nodes.len(),
            _ => 0..nodes.len(),
        };
        let field = Field { space, values: &film.unknown };
        let (mut u, mut held) = (Vec::with_capacity(self.places.len()), Vec::with_capacity(self.places.len()));
        for &(triangle, point) in &self.places {
            u.push(field.value(triangle as usize, point));
            let dofs = space.element_dofs(triangle as usize);
            let distance = |&k: &usize| (nodes[k][0] - point[0]).powi(2) + (nodes[k][1] - point[1]).powi(2);
            let nearest = voters.clone().min_by(|a, b| distance(a).total_cmp(&distance(b)));
            held.push(nearest.is_some_and(|k| film.cavity[dofs[k]]));
        }
        WarmStart { u, held }
    }
}

/// The liner that the mesh covers.
fn liner(system: &FilmSystem, bearing: &Bearing) -> LinerDomain {
    let mesh = system.space().mesh();
    let arc = match mesh.period() {
        Some(_) => None,
        None => {
            let xs = mesh.points().iter().map(|point| point[0] / bearing.radius);
            Some(xs.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(x), h.max(x))))
        }
    };
    LinerDomain { radius: bearing.radius, length: bearing.length, arc }
}

/// Angle [rad] of the film start of a ring.
fn line(system: &FilmSystem, bearing: &Bearing) -> Option<f64> {
    let mesh = system.space().mesh();
    mesh.period()?;
    let is_line = |region: &&SupplyRegion| region.kind == BoundaryKind::Line;
    let region = system.supply.regions().iter().find(is_line)?;
    Some(mesh.edge_nodes(*region.edges.first()?)[0][0] / bearing.radius)
}
