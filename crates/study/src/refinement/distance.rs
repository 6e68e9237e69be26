//! How far bars are from their tolerances.

use crate::estimate::Estimated;
use crate::film::Film;
use crate::measure::{drag, possible_load};
use crate::quantities::{ECCENTRICITY, MOMENT_X, MOMENT_Y, Quantity, SIDE_FLOW, Unit};
use oilwedge_scene::Target;

/// Tolerances of what is less than this part of what it could be count against that part: loads against those that the
/// pressures could carry, pressures against that of drag, the eccentricity against the clearance, and where bars are
/// judged side flows against what the journal drags.
const LEAST: f64 = 1e-3;
/// Least side flow against which meshes are refined, over the flow that the journal drags through the clearance.
const LEAST_FLOW: f64 = 0.05;

/// Sizes that numbers of a film could have: tolerances of much smaller ones count against a part of them.
struct Possible {
    /// The load [N] that its pressures could carry.
    load: f64,
    /// The least load [N] that counts by its own size.
    least_load: f64,
    /// The moment [N m] of that load at an end.
    moment: f64,
    /// The pressure [Pa] that drag through the clearance makes.
    pressure: f64,
    /// The least side flow [m3/s] that counts by its own size.
    least_flow: f64,
}

impl Possible {
    /// Side flows count by their own size from `least_flow` times what the journal drags through the clearance.
    fn of(film: &Film, estimated: &Estimated, least_flow: f64) -> Self {
        let bearing = &film.problem.bearing;
        let dragged = 0.5 * film.problem.journal.speed.abs() * bearing.radius;
        Self {
            pressure: drag(&film.problem),
            load: possible_load(&film.problem, &estimated.measured),
            least_load: least_load(film, estimated),
            least_flow: least_flow * dragged * bearing.clearance * bearing.length,
            moment: 0.5 * bearing.length * possible_load(&film.problem, &estimated.measured),
        }
    }

    /// What a relative bar of a quantity is relative to, in its unit.
    fn size(&self, quantity: &Quantity) -> f64 {
        match quantity.row.unit {
            Unit::Degree => 1f64.to_degrees(),
            Unit::Pascal => quantity.value.abs().max(LEAST * self.pressure),
            Unit::Newton => quantity.value.abs().max(LEAST * self.load).max(self.least_load),
            _ if [&MOMENT_X, &MOMENT_Y].contains(&quantity.row) => quantity.value.abs().max(LEAST * self.moment),
            _ if quantity.row == &SIDE_FLOW => quantity.value.abs().max(self.least_flow),
            _ if quantity.row == &ECCENTRICITY => quantity.value.abs().max(LEAST),
            _ => quantity.value.abs(),
        }
    }

    /// The bar of a target over what it may be; infinite where it is missing. A quantity that this film does not have
    /// is met.
    fn ratio(&self, quantities: &[Quantity], target: &Target) -> f64 {
        let Some(quantity) = quantities.iter().find(|quantity| quantity.name == target.quantity) else {
            return 0.0;
        };
        match quantity.error() {
            None => f64::INFINITY,
            Some(0.0) => 0.0,
            Some(error) => error / (target.relative * self.size(quantity)),
        }
    }
}

/// Where the program chooses the tolerance the load of a tilted journal that bears a moment and next to no force counts
/// by the forces [N] at the two ends that stand for both.
fn least_load(film: &Film, estimated: &Estimated) -> f64 {
    let has_usual_tolerance = film.model.targets.as_ref().is_some_and(|targets| targets.are_usual);
    match has_usual_tolerance && film.problem.can_tilt() {
        true => (estimated.measured.load.total.resultant()).at_ends(0.5 * film.problem.bearing.length),
        false => 0.0,
    }
}

/// The greatest bar over what it may be, and of which quantity.
pub(super) fn worst<'a>(film: &Film, estimated: &Estimated, targets: &'a [Target]) -> (f64, &'a str) {
    let possible = Possible::of(film, estimated, LEAST_FLOW);
    (targets.iter())
        .map(|target| (possible.ratio(&estimated.quantities, target), target.quantity.as_str()))
        .fold((0.0, ""), |worst, next| if next.0 > worst.0 { next } else { worst })
}

/// Names of the targets whose bars are wider than they may be, with these bars over the values [1].
pub(crate) fn wide_bars<'a>(film: &Film, estimated: &Estimated, targets: &'a [Target]) -> Vec<(&'a str, f64)> {
    let possible = Possible::of(film, estimated, LEAST);
    let wide = |target: &'a Target| {
        let ratio = possible.ratio(&estimated.quantities, target);
        (ratio > 1.0 && ratio.is_finite()).then_some((target.quantity.as_str(), ratio * target.relative))
    };
    targets.iter().filter_map(wide).collect()
}
