//! # Extent of the cavity and of tension
//!
//! **Equation.** `A_c/A`: area of the film that is in the cavity over the area that is free to be; `theta_min`: least
//! film fraction. Likewise the share of the area where the pressure lies below a level.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | A_c/A | 1 | `share` |
//! | theta_min | 1 | `least_fraction` |
//!
//! **Source.** Definition: a node of a mass-conserving film stands for a third of each sub-triangle that it bounds, the
//! middle of an edge (a vertex of linear elements) of Swift-Stieber's for a third of each triangle; nodes of given
//! pressure stand for nothing.
//! **Range.** First order in the size of the cells. **Verified by** `tests/tests/oil_balance.rs`, a film that breaks on
//! half of a ring.

use oilwedge_fem::control_volumes::sub_triangles;
use oilwedge_mesh::triangle_area;

use crate::SolvedFilm;
use crate::film_law::FilmLaw;

/// What a cavity is like.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cavity {
    /// Share of the film's area that is cavity, A_c/A [1].
    pub share: f64,
    /// Least film fraction theta_min [1] of a mass-conserving film.
    pub least_fraction: Option<f64>,
}

/// The cavity of a film, also where it is empty.
pub fn cavity(film: &SolvedFilm) -> Cavity {
    let fraction = film.solution.film_fraction.as_ref();
    Cavity {
        share: share(film),
        least_fraction: fraction.map(|fraction| fraction.values.iter().copied().fold(1.0, f64::min)),
    }
}

/// Shares of a triangle that its nodes stand for: the means of their functions.
fn node_shares(degree: usize) -> Vec<f64> {
    match degree {
        1 => vec![1.0 / 3.0; 3],
        2 => [[0.0; 3], [1.0 / 3.0; 3]].concat(),
        _ => [&[1.0 / 30.0; 3][..], &[3.0 / 40.0; 6], &[9.0 / 20.0]].concat(),
    }
}

fn share(film: &SolvedFilm) -> f64 {
    let space = film.system.space();
    let mesh = space.mesh();
    let whole_cell: Vec<(usize, f64)> = node_shares(space.degree()).into_iter().enumerate().collect();
    let (mut held, mut whole) = (0.0, 0.0);
    for t in 0..mesh.triangles().len() {
        let dofs = space.element_dofs(t);
        let area = triangle_area(mesh.corners(t));
        let mut add = |area: f64, nodes: &[(usize, f64)]| {
            let (mut broken, mut free) = (0.0, 0.0);
            for &(node, share) in nodes {
                let dof = dofs[node];
                broken += if film.solution.cavity[dof] { share } else { 0.0 };
                let counts = film.solution.cavity[dof] || film.system.supply.owner(dof).is_none();
                free += if counts { share } else { 0.0 };
            }
            if free > 0.0 {
                held += area * broken / free;
                whole += area;
            }
        };
        match film.solution.film_fraction {
            Some(_) => {
                let pieces = sub_triangles(space, t);
                for piece in pieces {
                    add(area / pieces.len() as f64, &piece.map(|node| (node, 1.0 / 3.0)));
                }
            }
            None => add(area, &whole_cell),
        }
    }
    if whole > 0.0 { held / whole } else { 0.0 }
}

/// Share of a triangle of a pressure film [1] that the cavity of Swift and Stieber takes, or where Guembel drops the
/// pressure; zero for other models.
pub(super) fn broken_share(film: &SolvedFilm, t: usize) -> f64 {
    let SolvedFilm { problem, system, solution } = film;
    let space = system.space();
    let is_broken = |dof: usize| match problem.cavitation.kink() {
        // Raised after the solve: the unknown is that of the full film.
        Some(pressure) => solution.unknown[dof] < problem.unknown_at(pressure),
        None => problem.cavitation.drops_pressures() && solution.cavity[dof],
    };
    let (mut broken, mut free) = (0.0, 0.0);
    for (dof, share) in space.element_dofs(t).into_iter().zip(node_shares(space.degree())) {
        let held = is_broken(dof);
        broken += if held { share } else { 0.0 };
        free += if held || system.supply.owner(dof).is_none() { share } else { 0.0 };
    }
    if free > 0.0 { broken / free } else { 0.0 }
}

/// Share of the area [1] of triangles in which a cavity may hide from the mesh: where none is shown, the film diverges
/// (by thirds, as their corners), and the pressure is within `margin` [Pa] of that of the cavity. Zero without a model
/// of cavitation.
pub fn hidden_share(film: &SolvedFilm, margin: f64) -> f64 {
    let SolvedFilm { problem, system, solution } = film;
    let Some(cavity) = problem.cavitation.pressure() else {
        return 0.0;
    };
    let (space, law) = (system.space(), FilmLaw::new(problem, 1.0));
    let mesh = space.mesh();
    let (mut hidden, mut whole) = (0.0, 0.0);
    for t in 0..mesh.triangles().len() {
        let area = triangle_area(mesh.corners(t));
        let nodes = &space.element_dofs(t)[..space.shapes()];
        let is_low = |&dof: &usize| problem.pressure_at(solution.unknown[dof]) <= cavity + margin;
        let flows = law.film_and_flows(t, &mesh.corners(t)).1;
        let diverging = flows[..3].iter().filter(|flow| flow.divergence + flow.storage > 0.0);
        if nodes.iter().any(is_low) && !nodes.iter().any(|&dof| solution.cavity[dof]) {
            hidden += area * diverging.count() as f64 / 3.0;
        }
        whole += area;
    }
    if whole > 0.0 { hidden / whole } else { 0.0 }
}

/// Share of the meshed area [1] where the pressure lies below `level` [Pa], judged by the nodes at which none is given.
pub fn share_below(film: &SolvedFilm, level: f64) -> f64 {
    let space = film.system.space();
    let mesh = space.mesh();
    let shares = node_shares(space.degree());
    let (mut below, mut whole) = (0.0, 0.0);
    for t in 0..mesh.triangles().len() {
        let area = triangle_area(mesh.corners(t));
        let (mut under, mut free) = (0.0, 0.0);
        // Where pressure is given it may be just that level, and tells nothing.
        let nodes = space.element_dofs(t).into_iter().zip(&shares);
        for (dof, share) in nodes.filter(|&(dof, _)| film.system.supply.owner(dof).is_none()) {
            free += share;
            under += if film.problem.pressure_at(film.solution.unknown[dof]) < level { *share } else { 0.0 };
        }
        if free > 0.0 {
            below += area * under / free;
            whole += area;
        }
    }
    if whole > 0.0 { below / whole } else { 0.0 }
}
