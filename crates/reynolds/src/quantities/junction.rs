//! # Flow booked where two places of given pressure meet
//!
//! **Equation.** `Q_c = Int over both rims of (h^3/(12 mu0) dq/dn) phi_c ds` at a node c that belongs to two regions
//! ```text
//! Q_c = Q + Int (J_0 . grad phi_c + div J_0 phi_c) dA - what a cavity makes beside c
//! ```
//! with the residual Q there and the flow J_0 that no pressure drives: what pressure drives through the node. It is
//! booked to one of the two, though each takes about half of it: either flow may be off by as much. Where the two
//! pressures differ, the flow from one to the other grows like a logarithm as the mesh is refined, and so does this
//! share of it.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | Q_c | m3/s | `unsure` |
//!
//! **Source.** Definition. **Range.** Films that conserve no oil in a cavity. **Verified by** the coverage of side
//! flows in `tests/full/tests/coverage.rs`.

use oilwedge_fem::integrate::Rule;

use super::edge::EdgeSource;
use crate::SolvedFilm;
use crate::film_law::FilmLaw;

/// The two regions of each node that they share, and `|Q_c|` [m3/s] there.
pub(super) fn unsure(film: &SolvedFilm, beside: &[EdgeSource]) -> Vec<([usize; 2], f64)> {
    let space = film.system.space();
    let meeting = film.system.supply.meeting(space);
    if meeting.is_empty() || film.solution.film_fraction.is_some() {
        return Vec::new();
    }
    let mut driven: Vec<Option<f64>> = vec![None; space.dofs()];
    for &(dof, _) in &meeting {
        driven[dof] = Some(film.solution.inflow[dof] - beside[dof].made);
    }
    let law = FilmLaw::new(&film.problem, 1.0);
    let rule = Rule::for_degree(space.degree());
    for t in 0..space.mesh().triangles().len() {
        let dofs = space.element_dofs(t);
        let dofs = &dofs[..space.shapes()];
        if dofs.iter().all(|&dof| driven[dof].is_none()) {
            continue;
        }
        rule.visit(space.mesh(), t, |points| {
            for (q, &position) in points.positions.iter().enumerate() {
                let flow = law.film_and_flows(t, &[position]).1[0];
                for (i, &dof) in dofs.iter().enumerate() {
                    if let Some(driven) = &mut driven[dof] {
                        let [x, z] = points.shape_gradient(q, i);
                        let dragged = flow.flux[0] * x + flow.flux[1] * z + flow.divergence * points.shapes(q)[i];
                        *driven += points.area(q) * dragged;
                    }
                }
            }
        });
    }
    let share = |(dof, regions): (usize, [usize; 2])| (regions, driven[dof].unwrap_or(0.0).abs());
    meeting.into_iter().map(share).collect()
}
