//! What it takes to turn the journal.

use oilwedge_reynolds::error_bar::Bar;
use oilwedge_reynolds::quantities::power::PressurePower;

use super::cavity::drops;
use super::row::{Headline, Measure::One};
use super::rule::{ErrorRule, Subject};
use super::view::View;
use crate::estimate::Estimate;

rows! {
    /// `T = R Int (mu U/h + (h/2) dp/dx) dA` over the film, mu that at the pressure of the place; the journal is turned
    /// with it; positive against the rotation in either sense; none at rest. With `jfo` the shear is weighted with the
    /// film fraction; `[contact]` adds `R mu_b Int p_a dA`; with `[turbulence]` C mu stands for mu
    FRICTION_TORQUE = "friction_torque", "T", NewtonMetre, "torque on the journal, against the rotation":
        One(|film| Some(film.friction()?.on_journal)),
        ErrorRule::Of(OF_PARTS, |estimate, at| of_torque(estimate, at, [1.0, 1.0])), tolerance headline(Headline::Always(10));

    /// `T_b = R Int (mu U/h - (h/2) dp/dx) dA`, which the bearing must be held with; none at rest
    FRICTION_TORQUE_BEARING = "friction_torque_bearing", "T_b", NewtonMetre, "torque on the bearing, with the rotation":
        One(|film| Some(film.friction()?.on_bearing)),
        ErrorRule::Of(OF_PARTS, |estimate, at| of_torque(estimate, at, [1.0, -1.0]));

    /// `f = T/(R W)`; none at rest, or without a load
    FRICTION_COEFFICIENT = "friction_coefficient", "f", One, "T / (R W)":
        One(|film| Some(film.friction().filter(|_| film.is_directed)? .coefficient(&film.problem.bearing, film.force))),
        ErrorRule::Of("those of torque and load, in proportion", of_coefficient),
        tolerance;

    /// `P = T omega = P_s + P_p`, with `[contact]` also `P_a`; none at rest
    FRICTION_POWER = "friction_power", "P", Watt, "power that turns the journal, T omega":
        One(|film| turning(film, film.measured.power.friction())),
        ErrorRule::Of(OF_PARTS, |estimate, at| of_power(estimate, at, [1.0, 1.0])), tolerance headline(Headline::Always(11));

    /// `P_s = Int mu U^2/h dA`, with `[turbulence]` C mu for mu; none at rest
    FRICTION_SHEAR_POWER = "friction_shear_power", "P_s", Watt, "part of P against shear":
        One(|film| turning(film, film.measured.power.shear)),
        ErrorRule::Of(DUAL, |estimate, at| of_power(estimate, at, [1.0, 0.0]));

    /// `P_p = Int (h/2) U dp/dx dA`; without pockets it is taken as omega times half of the moment of W about the
    /// bearing's centre; none at rest
    FRICTION_PRESSURE_POWER = "friction_pressure_power", "P_p", Watt, "part of P against pressure":
        One(|film| turning(film, film.measured.power.pressure)),
        ErrorRule::Of("that of the load across the eccentricity, in proportion; with pockets dual-weighted", |estimate, at| of_power(estimate, at, [0.0, 1.0]));

    /// `P_sc`: the part of P_s in the cavity, where models that keep no film fraction shear the whole gap; P without it
    /// is what a dry cavity would leave; none at rest
    FRICTION_CAVITY_POWER = "friction_cavity_power", "P_sc", Watt, "part of P_s in the cavity, its whole gap sheared":
        One(|film| turning(film, film.measured.power.cavity_shear).filter(|_| drops(film))),
        ErrorRule::Of("difference of the two films, and the shear on the part of the mesh that the edge of the cavity takes up",
            |estimate, at| estimate.cavity_power(at.change)),
        only(|scope| scope.cavitation.drops_pressures());
}

const DUAL: &str = "dual-weighted, with the error of integration";
const OF_PARTS: &str = "those of `friction_shear_power` and `friction_pressure_power` together";

/// A power of the journal's rotation; none at rest.
fn turning(film: &View, power: f64) -> Option<f64> {
    (film.journal().speed.abs() > 0.0).then_some(power)
}

/// Bar [W] of `shear` times the power of shear and `pressure` times that of pressure. The latter goes with the force
/// and the moment of the film where it follows from them.
fn of_power(estimate: &dyn Estimate, at: &Subject, [shear, pressure]: [f64; 2]) -> Option<Bar> {
    let Some(per) = PressurePower::of(at.view.problem) else {
        return Some(estimate.power([shear, pressure]));
    };
    let moments = estimate.moment().unwrap_or_default();
    let by_moment = |sum: Bar, (bar, per): (Bar, f64)| sum + bar.scaled(per);
    let of_pressure = (moments.into_iter().zip(per.moment)).fold(estimate.product(per.force), by_moment);
    Some(estimate.power([shear, 0.0]) + of_pressure.scaled(pressure))
}

fn of_torque(estimate: &dyn Estimate, at: &Subject, parts: [f64; 2]) -> Option<Bar> {
    let per_speed = at.view.journal().speed.abs().recip();
    Some(of_power(estimate, at, parts)?.scaled(per_speed))
}

/// Torque and load may both be off; none where the load may be none.
fn of_coefficient(estimate: &dyn Estimate, at: &Subject) -> Option<Bar> {
    estimate.across()?;
    let power = of_power(estimate, at, [1.0, 1.0])?;
    let per_power = at.value / at.view.measured.power.friction();
    Some(power.scaled(per_power) + estimate.load().scaled(at.value / estimate.force()))
}
