//! What contact of rough surfaces carries, and how it rubs.

use oilwedge_reynolds::error_bar::Bar;

use super::cycle_view::At;
use super::row::{Headline, Measure::One, Measure::OverCycle};
use super::rule::{ErrorRule, Subject};
use super::view::View;
use crate::estimate::Estimate;
use crate::measure::ContactShare;

rows! {
    /// `W_a . W/W^2`, `W_a = Int p_a (cos phi, sin phi) dA`: the part of the load, along it, that contact carries; the
    /// rest is that of the oil; of scenes with `[contact]`, none without a load
    CONTACT_SHARE = "contact_share", "W_a/W", One, "part of the load that contact carries":
        One(share), ErrorRule::Of("that of the load, in proportion, and the error of integration; under a load that of the position", of_share),
        tolerance only(|scope| scope.touches) headline(Headline::Always(6));

    /// `W_ax = Int p_a cos phi dA`: the part of W_x that contact carries
    CONTACT_LOAD_X = "contact_load_x", "W_ax", Newton, "part of W_x that contact carries":
        One(|film| Some(film.measured.contact?.share.force[0])), INTEGRATED, only(|scope| scope.touches);

    /// `W_ay = Int p_a sin phi dA`, likewise
    CONTACT_LOAD_Y = "contact_load_y", "W_ay", Newton, "part of W_y that contact carries":
        One(|film| Some(film.measured.contact?.share.force[1])), INTEGRATED, only(|scope| scope.touches);

    /// `m_ax = Int p_a z cos phi dA`: the part of m_x that contact carries; of journals that may tilt
    CONTACT_MOMENT_X = "contact_moment_x", "m_ax", NewtonMetre, "part of m_x that contact carries":
        One(|film| moment(film, 0)), MOMENT, only(|scope| scope.touches && scope.can_tilt);

    /// `m_ay = Int p_a z sin phi dA`, likewise
    CONTACT_MOMENT_Y = "contact_moment_y", "m_ay", NewtonMetre, "part of m_y that contact carries":
        One(|film| moment(film, 1)), MOMENT, only(|scope| scope.touches && scope.can_tilt);

    /// `Int p_a dA` over the liner: what presses the surfaces on each other
    CONTACT_THRUST = "contact_thrust", "Int p_a dA", Newton, "pressure of contact times area, summed":
        One(|film| Some(film.measured.contact?.share.pressure)), INTEGRATED, only(|scope| scope.touches);

    /// greatest `p_a`, that at the thinnest film
    CONTACT_PRESSURE_MAX = "contact_pressure_max", "p_a", Pascal, "greatest pressure of contact":
        One(greatest), ErrorRule::Position, only(|scope| scope.touches);

    /// `P_a = mu_b |U| Int p_a dA`: the part of P that contact rubs; none at rest
    FRICTION_CONTACT_POWER = "friction_contact_power", "P_a", Watt, "part of P that contact rubs":
        One(|film| rubbing(film).map(|[contact, _]| contact)),
        ErrorRule::Of("the error of integration; under a load that of the position", |_, at| {
            let [contact, _] = rubbing(at.view)?;
            let thrust = at.view.measured.contact?.share.pressure;
            Some(integrated(at)?.scaled(if thrust > 0.0 { contact / thrust } else { 0.0 }))
        }),
        only(|scope| scope.touches);

    /// `P_a/P`: the part of the friction, torque or power, that contact makes; none at rest
    CONTACT_FRICTION_SHARE = "contact_friction_share", "P_a/P", One, "part of the friction that contact makes":
        One(|film| rubbing(film).map(|[contact, all]| contact / all)),
        ErrorRule::Of("that of the friction of the oil, in proportion; under a load that of the position", |estimate, at| {
            let [_, all] = rubbing(at.view)?;
            Some(estimate.power([1.0, 1.0]).scaled(at.value / all))
        }),
        only(|scope| scope.touches);

    /// Greatest `W_a . W/W^2` over the cycle; of orbits with `[contact]`
    CYCLE_CONTACT_SHARE_MAX = "cycle_contact_share_max", "W_a/W", One, "greatest part of the load that contact carries over the cycle":
        OverCycle(|cycle| {
            let At { time, value } = cycle.greatest(&CONTACT_SHARE)?;
            Some((value, cycle.bar_at(&CONTACT_SHARE, time)))
        }),
        ErrorRule::OverCycle("that of the film there, and of the errors of the orbit"), only(|scope| scope.touches && scope.orbit.is_some());

    /// Part of the cycle in which contact carries more than a hundredth of the load; likewise
    CYCLE_CONTACT_DURATION = "cycle_contact_duration", "T_a/T", One, "part of the cycle in which contact carries more than a hundredth of the load":
        OverCycle(|cycle| cycle.part_above(&CONTACT_SHARE, TOUCHING)),
        ErrorRule::OverCycle("part of the cycle in which the share of contact is within its bar of a hundredth"), only(|scope| scope.touches && scope.orbit.is_some());
}

/// Part of the load from which on a film counts as one in contact.
const TOUCHING: f64 = 0.01;

const INTEGRATED: ErrorRule =
    ErrorRule::Of("the error of integration; under a load that of the position", |_, at| integrated(at));
const MOMENT: ErrorRule =
    ErrorRule::Of("the error of integration, at half of the length; under a load that of the position", |_, at| {
        Some(integrated(at)?.scaled(0.5 * at.view.problem.bearing.length))
    });

/// Bar [N] of the quadrature of contact.
pub(super) fn integrated(at: &Subject) -> Option<Bar> {
    at.view.measured.contact.map(|ContactShare { unsure, .. }| Bar::of(unsure))
}

fn share(film: &View) -> Option<f64> {
    let contact = film.measured.contact?.share.force;
    let [x, y] = film.measured.load.total.force;
    film.is_directed.then(|| (contact[0] * x + contact[1] * y) / film.force.powi(2))
}

fn of_share(estimate: &dyn Estimate, at: &Subject) -> Option<Bar> {
    let force = at.view.force;
    Some(estimate.load().scaled(at.value / force) + integrated(at)?.scaled(1.0 / force))
}

fn moment(film: &View, axis: usize) -> Option<f64> {
    let contact = film.measured.contact.filter(|_| film.problem.can_tilt())?;
    Some(contact.share.moment[axis])
}

fn greatest(film: &View) -> Option<f64> {
    let contact = film.problem.contact.as_ref()?;
    Some(contact.law.at(film.measured.thinnest.thickness).pressure)
}

/// Friction of contact and all friction [W]; none at rest, and where nothing is simulated.
fn rubbing(film: &View) -> Option<[f64; 2]> {
    let power = &film.measured.power;
    let is_turning = film.problem.contact.is_some() && film.journal().speed.abs() > 0.0;
    is_turning.then(|| [power.contact, power.friction()])
}
