//! What it takes to move the journal's centre.

use super::row::Measure::One;
use super::rule::{ErrorRule, Subject};
use crate::estimate::Estimate;
use oilwedge_reynolds::error_bar::Bar;

rows! {
    /// `P_e = W . de/dt + m . dg/dt`: the load times the velocity of the journal's centre, and the moment times the
    /// rate of the slope of its axis; with P the whole power of a film that is fed no pressure; none where both rest
    MOTION_POWER = "squeeze_power", "P_e", Watt, "power of the load as the journal's centre moves":
        One(|film| { let moves = !film.journal().is_still(); moves.then(|| film.measured.motion_power(film.journal())) }),
        ErrorRule::Of("dual-weighted, along and across the load", bar),
        only(|scope| scope.moves);
}

fn bar(estimate: &dyn Estimate, at: &Subject) -> Option<Bar> {
    let journal = at.view.journal();
    let by_centre = estimate.product(journal.velocity);
    let [w_x, w_y] = journal.tilt_rate;
    match [w_x, w_y] == [0.0; 2] {
        true => Some(by_centre),
        false => {
            let [x, y] = estimate.moment()?;
            Some(by_centre + x.scaled(w_x) + y.scaled(w_y))
        }
    }
}
