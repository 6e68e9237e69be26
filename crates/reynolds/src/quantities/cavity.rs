//! # Extent of the cavity and of tension
//!
//! **Equation.** `A_c/A`: area of the film that is in the cavity over the area that is free to be; `theta_min`: least film
//! fraction. Likewise the share of the area where the pressure lies below a level.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | A_c/A | 1 | `share` |
//! | theta_min | 1 | `least_fraction` |
//!
//! **Source.** Definition: a node of a mass-conserving film stands for a third of each sub-triangle that it bounds, the middle
//! of an edge (a vertex of linear elements) of Swift-Stieber's for a third of each triangle; nodes of given pressure stand for nothing.
//! **Range.** First order in the size of the cells. **Verified by** `tests/oil_balance.rs`, a film that breaks on half of a ring.

use oilwedge_fem::control_volumes::sub_triangles;
use oilwedge_fem::mapping::Mapping;
use oilwedge_fem::{Field, Quadrature};

use crate::{FilmProblem, FilmSolution, FilmSystem};

/// What a cavity is like.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cavity {
    /// Share of the film's area that is cavity, A_c/A [1].
    pub share: f64,
    /// Least film fraction theta_min [1] of a mass-conserving film.
    pub least_fraction: Option<f64>,
}

/// The cavity of a film, also where it is empty.
pub fn cavity(system: &FilmSystem, film: &FilmSolution) -> Cavity {
    let fraction = film.film_fraction.as_ref();
    Cavity {
        share: share(system, film),
        least_fraction: fraction.map(|fraction| fraction.values.iter().copied().fold(1.0, f64::min)),
    }
}

fn share(system: &FilmSystem, film: &FilmSolution) -> f64 {
    let mesh = system.space().mesh();
    let conserving = film.film_fraction.is_some();
    let (mut held, mut whole) = (0.0, 0.0);
    for t in 0..mesh.triangles().len() {
        let dofs = system.space().element_dofs(t);
        let [a, b, c] = mesh.corners(t);
        let subs = sub_triangles(mesh, t);
        let groups: &[[usize; 3]] = match system.space().degree() {
            1 => &[[0, 1, 2]],
            _ if conserving => &subs,
            _ => &[[3, 4, 5]],
        };
        let area = 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / groups.len() as f64;
        for group in groups {
            let (mut broken, mut free) = (0, 0);
            for dof in group.map(|node| dofs[node]) {
                broken += u32::from(film.cavity[dof]);
                free += u32::from(film.cavity[dof] || system.supply.owner(dof).is_none());
            }
            if free > 0 {
                held += area * f64::from(broken) / f64::from(free);
                whole += area;
            }
        }
    }
    if whole > 0.0 { held / whole } else { 0.0 }
}

/// Share of the meshed area [1] where the pressure lies below `level` [Pa].
pub fn share_below(problem: &FilmProblem, system: &FilmSystem, film: &FilmSolution, level: f64) -> f64 {
    let space = system.space();
    let rule = Quadrature::for_degree(space.degree());
    let field = Field {
        space,
        values: &film.unknown,
    };
    let (mut below, mut whole) = (0.0, 0.0);
    for t in 0..space.mesh().triangles().len() {
        let mapping = Mapping::of(space.mesh(), t);
        for (&point, weight) in rule.points.iter().zip(&rule.weights) {
            let area = weight * mapping.at(point).determinant;
            whole += area;
            if problem.pressure_at(field.value(t, point)) < level {
                below += area;
            }
        }
    }
    below / whole
}
