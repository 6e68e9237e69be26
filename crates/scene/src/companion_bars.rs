//! The error bars of a mass-conserving film: its distance from the same film on cells twice as wide.
//!
//! The scheme is of second order in the full film and carries the film fraction at first order or better, so that what halving the
//! cells changes covers what is left. `docs/theory/error_estimation.md` has the figures.

use oilwedge_reynolds::FilmSolution;
use oilwedge_reynolds::error_bar::Bar;

use crate::analysis::Solved;
use crate::bars::{Judged, balanced, is_cut_out, set};
use crate::compile::Study;
use crate::measure::{Measured, measure, quantities};
use crate::moved::position_bars;
use crate::report::Quantity;

/// Loads of which the companion is off by more than this part are not resolved.
const UNRESOLVED: f64 = 0.2;

/// Judges a mass-conserving film by its `companion` on the vertices alone.
pub(crate) fn judge(study: &Study, solved: &Solved, companion: &FilmSolution) -> Judged {
    let measured = measure(&study.problem, &study.system, &solved.film);
    let coarse = measure(&study.problem, study.system.vertices_only(), companion);
    let mut list = quantities(study, &measured);
    let other = quantities(study, &coarse);
    let [along, across] = apart(&measured, &coarse);
    let force = measured.load.magnitude();
    let resolved = along.max(across) <= UNRESOLVED * force;
    let moved =
        (solved.balance.as_ref()).map(|balance| position_bars(study, &solved.film, balance, [along, across], &list));
    for (k, quantity) in list.iter_mut().enumerate() {
        let own = match (&solved.balance, resolved) {
            (Some(balance), true) => balanced(quantity, balance),
            _ => None,
        };
        let other = other.iter().find(|other| other.name == quantity.name);
        let bar = own.or_else(|| {
            let discretisation = own_bar(quantity, other?, resolved, [along, across], &measured)?;
            let position = moved.as_ref().map_or(0.0, |moved| moved[k]);
            Some(Bar {
                discretisation,
                position,
                ..Bar::default()
            })
        });
        set(quantity, bar);
    }
    Judged {
        quantities: list,
        measured,
        indicator: None,
        at_front: false,
        seconds: 0.0,
    }
}

/// Distance [N] of the two loads along and across.
fn apart(fine: &Measured, coarse: &Measured) -> [f64; 2] {
    let ([x, y], [other_x, other_y]) = (fine.load.total.force, coarse.load.total.force);
    let size = x.hypot(y).max(f64::MIN_POSITIVE);
    let change = [other_x - x, other_y - y];
    [
        ((change[0] * x + change[1] * y) / size).abs(),
        ((change[1] * x - change[0] * y) / size).abs(),
    ]
}

/// The bar of a number at the position of the film; none if it cannot be trusted.
fn own_bar(
    quantity: &Quantity,
    other: &Quantity,
    resolved: bool,
    [along, across]: [f64; 2],
    measured: &Measured,
) -> Option<f64> {
    let name = quantity.name.as_str();
    if matches!(name, "eccentricity" | "min_film_angle" | "film_thickness_min") || is_cut_out(name) {
        return Some(0.0);
    }
    if !resolved {
        return None;
    }
    let change = (quantity.value - other.value).abs();
    let [x, y] = measured.load.total.force;
    let force = x.hypot(y);
    Some(match name {
        "load" => along,
        "load_x" => (along * x.abs() + across * y.abs()) / force,
        "load_y" => (along * y.abs() + across * x.abs()) / force,
        "load_angle" | "attitude_angle" => (across / force).to_degrees(),
        "load_coefficient" | "sommerfeld_number" => along / force * quantity.value.abs(),
        _ => change,
    })
}
