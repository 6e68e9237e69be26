//! What an uncertain position makes uncertain: the film moved along its tangent as far as its bar, and measured again.

use std::collections::HashMap;

use oilwedge_bearing::{NEAR, newton_step};
use oilwedge_reynolds::FilmSolution;

use crate::analysis::Balance;
use crate::compile::Study;
use crate::measure::{measure, quantities_at};
use crate::result::Quantity;

/// For each quantity of `list` (measured on `film`) by name how much it changes where the journal moves as far as the bars of
/// the load, `[along, across]` [N], and what is left unbalanced let it. Not finite where the film has no tangent, or so far away no film,
/// and where the load is so far from balanced that the tangent does not tell how far the position is.
pub(crate) fn position_bars(
    study: &Study,
    film: &FilmSolution,
    balance: &Balance,
    bars: [f64; 2],
    list: &[Quantity],
) -> HashMap<String, f64> {
    if balance.residual >= NEAR {
        return list.iter().map(|quantity| (quantity.name.clone(), f64::NAN)).collect();
    }
    let [x, y] = study.load.unwrap_or_default();
    let size = x.hypot(y);
    let along = match size > 0.0 {
        true => [x / size, y / size],
        false => [1.0, 0.0],
    };
    let across = [-along[1], along[0]];
    let mut changes = vec![0.0; list.len()];
    for (direction, bar) in [along, across].into_iter().zip(bars) {
        let by = newton_step(balance.stiffness, direction.map(|d| -d * (bar + balance.unbalanced)));
        let change = study.centre_velocity.change(&study.problem.journal, by);
        let moved = study
            .problem
            .moved(&study.system, film, &change)
            .map(|(problem, film)| {
                let measured = measure(&problem, &study.system, &film);
                quantities_at(study, &problem, &measured)
            });
        for (change, here) in changes.iter_mut().zip(list) {
            let there = moved
                .as_ref()
                .ok()
                .and_then(|moved| moved.iter().find(|there| there.name == here.name));
            *change += there.map_or(f64::NAN, |there| distance(here, there));
        }
    }
    list.iter().map(|quantity| quantity.name.clone()).zip(changes).collect()
}

/// Angles differ by less than half a turn.
fn distance(a: &Quantity, b: &Quantity) -> f64 {
    let difference = (a.value - b.value).abs();
    match a.unit == "deg" {
        true => difference.min((difference - 360.0).abs()),
        false => difference,
    }
}
