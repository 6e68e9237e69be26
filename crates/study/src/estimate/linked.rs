//! Bars of numbers that follow from one another: where a relation is exact, so is that between the bars.
//!
//! * Under a load that is balanced W is given, so that `f = T/(R W)` is off by as much as the torque, in proportion.
//! * What one feed brings leaves at the ends: `Q_f = Q_s` in a film that conserves oil and has no other source. The
//!   narrower bar holds for both.
//! * Where oil leaves at the ends alone, and none enters there, that is all that cools the film: `Q_out = Q_s`.

use oilwedge_reynolds::supply::BoundaryKind;
use oilwedge_reynolds::{Form, Theory};

use crate::quantities::{COOLING_FLOW, FEED_FLOW, FRICTION_COEFFICIENT, FRICTION_TORQUE, Quantity, SIDE_FLOW, View};
use crate::solved::BalanceFacts;

/// Flows that differ by less than this part are one.
const ROUNDING: f64 = 1e-12;

/// Gives linked numbers of a list bars that agree; `balance` is that of the load, where one is given.
pub(super) fn link(list: &mut [Quantity], view: &View, balance: Option<&BalanceFacts>) {
    let place = |row| list.iter().position(|quantity: &Quantity| quantity.row == row);
    let friction = place(&FRICTION_TORQUE).zip(place(&FRICTION_COEFFICIENT));
    let flow = place(&SIDE_FLOW).zip(place(&FEED_FLOW));
    let cooling = place(&SIDE_FLOW).zip(place(&COOLING_FLOW));
    if let Some((torque, coefficient)) = friction.filter(|_| balance.is_some_and(|balance| !balance.is_ended)) {
        let (per_torque, bar) = (list[coefficient].value / list[torque].value, list[torque].bar);
        list[coefficient].set_bar(bar.map(|bar| bar.scaled(per_torque)));
    }
    if let Some((side, feed)) = flow.filter(|_| has_one_source(view)) {
        let narrower = [side, feed].into_iter().filter_map(|place| list[place].bar);
        let narrower = narrower.min_by(|a, b| a.total().total_cmp(&b.total()));
        for place in [side, feed] {
            list[place].set_bar(narrower);
        }
    }
    if let Some((side, cooling)) = cooling {
        let (side, cooling) = (list[side].clone(), &mut list[cooling]);
        if (side.value - cooling.value).abs() <= ROUNDING * cooling.value.abs() {
            cooling.set_bar(side.bar);
        }
    }
}

/// Whether all oil that leaves at the ends comes through one feed.
fn has_one_source(view: &View) -> bool {
    let problem = view.problem;
    let conserves = problem.form == Form::Conservative && !problem.cavitation.drops_pressures();
    let rests = problem.journal.is_still();
    let has_lines = view.regions(BoundaryKind::Line).next().is_some();
    conserves && rests && problem.theory == Theory::Full && !has_lines && view.regions(BoundaryKind::Feed).count() == 1
}
