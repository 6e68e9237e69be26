//! # Flow per width and shear stress on the walls
//!
//! **Equation.** Across the film the velocity is `u(y) = U y/h + y (y - h)/(2 mu) grad p`, y from the bearing to the
//! journal. So
//! ```text
//! flow per width         J     = theta U h/2 - h^3/(12 mu) grad p
//! stress on the bearing  tau_b = theta mu U/h - h/2 grad p
//! stress on the journal  tau_j = -(theta mu U/h + h/2 grad p)
//! ```
//! `tau` is the force per area that the oil exerts on the wall, along it.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | J | m2/s | `flow` |
//! | tau_j, tau_b | Pa | `on_journal`, `on_bearing` |
//! | theta | 1 | the film fraction of `jfo`, 1 for other models |
//!
//! **Source.** Hamrock, Schmid, Jacobson, Fundamentals of Fluid Film Lubrication (2004), ch. 7. **Range.** No pressure
//! drives oil in a cavity; models without a film fraction shear the whole gap there. No film where a feed gives the
//! pressure. **Verified by** `tests/tests/fields.rs`: torques and flows are integrals of these fields.

use oilwedge_fem::lagrange::nodes;
use oilwedge_fem::{Field, in_order};
use oilwedge_mesh::triangle_area;
use rayon::prelude::*;

use super::power::{excess, shear_viscosity};
use crate::SolvedFilm;
use crate::film_law::FilmLaw;

/// What flows past a point and what it shears there.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Stream {
    /// Volume flow per width, along x and z [m2/s].
    pub flow: [f64; 2],
    /// Stress that the oil exerts on the journal, along x and z [Pa].
    pub on_journal: [f64; 2],
    /// Stress that the oil exerts on the bearing, along x and z [Pa].
    pub on_bearing: [f64; 2],
}

/// Nodes of a triangle of which a picture is made: vertices, then the middles of edges.
pub const PICTURED: usize = 6;

/// Triangles that are worked on together: their streams fit into the cache.
const BLOCK: usize = 1024;

/// What flows at the nodes of each triangle of a quadratic film, with the area [m2] of the triangle; `None` in
/// triangles that a feed covers. Gradients jump between triangles, so that a node has a value in each of its triangles.
pub fn streams<'a>(film: &'a SolvedFilm) -> impl Iterator<Item = Option<(f64, [Stream; PICTURED])>> + 'a {
    let mesh = film.system.space().mesh();
    let is_film = film.system.supply.film(mesh);
    let nodal = NodalFilm {
        film,
        excess: film.solution.unknown.iter().map(|&u| excess(&film.problem, u)).collect(),
        places: nodes(film.system.space().degree()),
    };
    let triangles = is_film.len();
    (0..triangles).step_by(BLOCK).flat_map(move |first| {
        let at = |t: usize| is_film[t].then(|| (triangle_area(mesh.corners(t)), nodal.streams(t)));
        let block = first..triangles.min(first + BLOCK);
        in_order(block.into_par_iter().map(at))
    })
}

/// A film with its values at nodes.
struct NodalFilm<'a> {
    film: &'a SolvedFilm,
    /// Pressure above that of the ends [Pa].
    excess: Vec<f64>,
    /// Reference coordinates of the nodes.
    places: Vec<[f64; 2]>,
}

impl NodalFilm<'_> {
    fn streams(&self, t: usize) -> [Stream; PICTURED] {
        let SolvedFilm { problem, system, solution } = self.film;
        let space = system.space();
        let law = FilmLaw::new(problem, 1.0);
        let (points, flows) = law.film_and_flows(t, &space.mesh().nodes(t));
        let (velocity, along) = (law.velocity(), problem.theory.directions());
        let fields = [&solution.unknown, &self.excess].map(|values| Field { space, values });
        let slopes = fields.map(|field| field.gradients(t, &self.places));
        let dofs = space.element_dofs(t);
        let is_broken = dofs[3..PICTURED].iter().all(|&dof| self.is_low(dof));
        std::array::from_fn(|i| {
            let (dof, thickness) = (dofs[i], points[i].thickness);
            let slopes = match is_broken || self.is_low(dof) {
                true => [[0.0; 2]; 2],
                false => [slopes[0][i], slopes[1][i]],
            };
            let fraction = solution.film_fraction.as_ref().map_or(1.0, |fraction| fraction.values[dof]);
            let shear = fraction * shear_viscosity(problem, &points[i], self.excess[dof]) / thickness;
            let driven = |part: f64, d: usize| part * thickness * slopes[1][d];
            let drag = points[i].drag;
            Stream {
                flow: [0, 1].map(|d| fraction * flows[i].flux[d] - flows[i].conductance[d] * along[d] * slopes[0][d]),
                on_journal: [0, 1].map(|d| -shear * velocity[d] - driven(drag, d)),
                on_bearing: [0, 1].map(|d| shear * velocity[d] - driven(1.0 - drag, d)),
            }
        })
    }

    /// True in a cavity, and where Guembel drops the pressure.
    fn is_low(&self, dof: usize) -> bool {
        let SolvedFilm { problem, solution, .. } = self.film;
        let dropped = problem.cavitation.kink();
        solution.cavity[dof] || dropped.is_some_and(|p| solution.unknown[dof] < problem.unknown_at(p))
    }
}
