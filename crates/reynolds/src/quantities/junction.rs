//! # Flow booked where two places of given pressure meet
//!
//! **Equation.** `Q_c = Int over both rims of (h^3/(12 mu0) dq/dn) phi_c ds` at a node c that belongs to two regions
//! ```text
//! Q_c = Q + Int (J_0 . grad phi_c + div J_0 phi_c) dA - what a cavity makes beside c
//! ```
//! with the residual Q there and the flow J_0 that no pressure drives: what pressure drives through the node. It is booked
//! to one of the two, though each takes about half of it: either flow may be off by as much. Where the two pressures differ, the
//! flow from one to the other grows like a logarithm as the mesh is refined, and so does this share of it.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | Q_c | m3/s | `unsure` |
//!
//! **Source.** Definition. **Range.** Films that conserve no oil in a cavity. **Verified by** the coverage of side flows in
//! `tests/tests/coverage.rs`.

use oilwedge_fem::Quadrature;
use oilwedge_fem::lagrange::{self, MOST_SHAPES};
use oilwedge_fem::mapping::Mapping;

use super::edge::Beside;
use crate::film_law::FilmLaw;
use crate::{FilmProblem, FilmSolution, FilmSystem};

/// For each node that two regions share, these and `|Q_c|` [m3/s].
pub(super) fn unsure(
    problem: &FilmProblem,
    system: &FilmSystem,
    film: &FilmSolution,
    beside: &[Beside],
) -> Vec<([usize; 2], f64)> {
    let space = system.space();
    let meeting = system.supply.meeting(space);
    if meeting.is_empty() || film.film_fraction.is_some() {
        return Vec::new();
    }
    let mut driven: Vec<Option<f64>> = vec![None; space.dofs()];
    for &(dof, _) in &meeting {
        driven[dof] = Some(film.inflow[dof] - beside[dof].made);
    }
    let law = FilmLaw::new(problem, 1.0);
    let rule = Quadrature::for_degree(space.degree());
    let (mut values, mut gradients) = ([0.0; MOST_SHAPES], [[0.0; 2]; MOST_SHAPES]);
    for t in 0..space.mesh().triangles().len() {
        let dofs = space.element_dofs(t);
        let dofs = &dofs[..space.shapes()];
        if dofs.iter().all(|&dof| driven[dof].is_none()) {
            continue;
        }
        let mapping = Mapping::of(space.mesh(), t);
        for (&point, weight) in rule.points.iter().zip(&rule.weights) {
            let place = mapping.at(point);
            let flow = law.film_and_flows(t, &[place.position]).1[0];
            lagrange::values(space.degree(), point, &mut values[..dofs.len()]);
            lagrange::gradients(space.degree(), point, &mut gradients[..dofs.len()]);
            for (i, &dof) in dofs.iter().enumerate() {
                if let Some(driven) = &mut driven[dof] {
                    let [x, z] = place.gradient(gradients[i]);
                    let dragged = flow.flux[0] * x + flow.flux[1] * z + flow.divergence * values[i];
                    *driven += weight * place.determinant * dragged;
                }
            }
        }
    }
    let share = |(dof, regions): (usize, [usize; 2])| (regions, driven[dof].unwrap_or(0.0).abs());
    meeting.into_iter().map(share).collect()
}
