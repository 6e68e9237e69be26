//! What an uncertain position makes uncertain: the film moved along its tangent as far as its bar, and measured again.

use std::borrow::Cow;
use std::collections::HashMap;

use oilwedge_bearing::deflection::displaced_with_wall;
use oilwedge_bearing::{NEAR, Vector};
use oilwedge_reynolds::SolvedFilm;
use oilwedge_reynolds::solve::Neighbour;
use rayon::prelude::*;

use crate::measure::{Measured, measure};
use crate::quantities::{Quantity, View, measured};
use crate::solved::{BalanceFacts, Solved};

/// A wall that leaves more than this part of its deflection is open.
const OPEN: f64 = 1e-6;

/// Change of each quantity of `list`, by name, where the journal moves as far as the bars [N] of what it carries in
/// some directions of force and moment, and what is left unbalanced, let it. Not finite where the film has no tangent,
/// or so far away no film, and where the load is so far from balanced that the tangent does not show how far the
/// position is, or the wall is open.
pub(super) fn position_bars(
    solved: &Solved,
    balance: &BalanceFacts,
    bars: &[(Vector, f64)],
    list: &[Quantity],
    reported: &Measured,
) -> HashMap<Cow<'static, str>, f64> {
    let base = &solved.film;
    let names = list.iter().map(|quantity| quantity.name.clone());
    let is_open = (base.problem.deflection()).is_some_and(|deflection| deflection.closing.residual > OPEN);
    if balance.residual >= NEAR || is_open {
        return names.map(|name| (name, f64::NAN)).collect();
    }
    let moved_towards = |(direction, bar): &(Vector, f64)| {
        let by = balance.stiffness.solve(direction.map(|d| d * (bar + balance.unbalanced)));
        let change = (balance.coordinates).change(&base.problem.journal, &base.model.sockets.centre_velocity, by);
        let wall = solved.wall.times(by);
        let moved = displaced_with_wall(&solved.primary, &change, &wall);
        let moved = moved.map(|moved| {
            let there = with_dynamics(solved, measure(&moved), &moved, reported);
            measured(&View::new(base, &moved.problem, &there))
        });
        let moved = moved.unwrap_or_default();
        let change = |here: &Quantity| {
            let there = moved.iter().find(|there| there.name == here.name);
            there.map_or(f64::NAN, |there| here.row.difference(here.value, there.value).abs())
        };
        list.iter().map(change).collect::<Vec<f64>>()
    };
    let by_direction: Vec<Vec<f64>> = bars.par_iter().map(moved_towards).collect();
    let changes = (0..list.len()).map(|k| by_direction.iter().map(|changes| changes[k]).sum());
    names.zip(changes).collect()
}

/// The numbers with the stiffness and damping of the film there, whose tangent is its own: a film moved along the
/// tangent has that of the place that it comes from.
pub(super) fn with_dynamics(solved: &Solved, there: Measured, moved: &SolvedFilm, reported: &Measured) -> Measured {
    if solved.film.model.sockets.dynamics.is_none() {
        return there;
    }
    let film = match moved.solution.film_fraction {
        Some(_) => Ok(moved.clone()),
        None => moved.problem.solve_from(&moved.system, Neighbour::Start(&solved.primary)),
    };
    match film {
        Ok(film) => there.with_dynamics(&solved.film, &film, Some(reported)),
        Err(_) => there,
    }
}
