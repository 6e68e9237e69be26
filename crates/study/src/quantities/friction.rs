//! What it takes to turn the journal.

use oilwedge_reynolds::error_bar::Bar;

use super::cavity::{drops, drops_in};
use super::row::{Measure::One, Row};
use super::rule::{ErrorRule, Subject};
use super::unit::Unit::{NewtonMetre, One as Ratio, Watt};
use super::view::View;
use crate::estimate::Estimate;

/// Torque on the journal.
pub static FRICTION_TORQUE: Row = Row::new(
    "friction_torque",
    "T",
    NewtonMetre,
    One(|film| Some(film.friction()?.on_journal)),
    ErrorRule::Of(DUAL, |estimate, at| of_torque(estimate, at, [1.0, 1.0])),
)
.means(
    "torque on the journal, against the rotation",
    "`T = R Int (mu U/h + (h/2) dp/dx) dA` over the film, mu that at the pressure of the place; the journal is turned with it; positive against the rotation in either sense; none at rest. With `jfo` the shear is weighted with the film fraction",
)
.tolerance();

/// Torque on the bearing.
pub static FRICTION_TORQUE_BEARING: Row = Row::new(
    "friction_torque_bearing",
    "T_b",
    NewtonMetre,
    One(|film| Some(film.friction()?.on_bearing)),
    ErrorRule::Of(DUAL, |estimate, at| of_torque(estimate, at, [1.0, -1.0])),
)
.means(
    "torque on the bearing, with the rotation",
    "`T_b = R Int (mu U/h - (h/2) dp/dx) dA`, which the bearing must be held with; none at rest",
);

/// Coefficient of friction.
pub static FRICTION_COEFFICIENT: Row = Row::new(
    "friction_coefficient",
    "f",
    Ratio,
    One(|film| {
        Some(
            film.friction()
                .filter(|_| film.is_directed)?
                .coefficient(&film.problem.bearing, film.force),
        )
    }),
    ErrorRule::Of("those of torque and load, in proportion", |estimate, at| {
        estimate.friction_coefficient(at.value)
    }),
)
.means("T / (R W)", "`f = T/(R W)`; none at rest, or without a load")
.tolerance();

/// Power of friction.
pub static FRICTION_POWER: Row = Row::new(
    "friction_power",
    "P",
    Watt,
    One(|film| turning(film, film.measured.power.friction())),
    ErrorRule::Of(DUAL, |estimate, at| of_power(estimate, at, [1.0, 1.0])),
)
.means(
    "power that turns the journal, T omega",
    "`P = T omega = P_s + P_p`; none at rest",
)
.tolerance();

/// Its part against shear.
pub static FRICTION_SHEAR_POWER: Row = Row::new(
    "friction_shear_power",
    "P_s",
    Watt,
    One(|film| turning(film, film.measured.power.shear)),
    ErrorRule::Of(DUAL, |estimate, at| of_power(estimate, at, [1.0, 0.0])),
)
.means("its part against shear", "`P_s = Int mu U^2/h dA`; none at rest");

/// Its part against pressure.
pub static FRICTION_PRESSURE_POWER: Row = Row::new(
    "friction_pressure_power",
    "P_p",
    Watt,
    One(|film| turning(film, film.measured.power.pressure)),
    ErrorRule::Of(DUAL, |estimate, at| of_power(estimate, at, [0.0, 1.0])),
)
.means(
    "its part against pressure",
    "`P_p = Int (h/2) U dp/dx dA`; in a ring without pockets omega times half of the moment of W about the bearing's centre; none at rest",
);

/// Its part in the cavity.
pub static FRICTION_CAVITY_POWER: Row = Row::new(
    "friction_cavity_power",
    "P_sc",
    Watt,
    One(|film| turning(film, film.measured.power.cavity_shear).filter(|_| drops(film))),
    ErrorRule::Of(
        "difference of the two films, and the shear on the part of the mesh that the edge of the cavity takes up",
        |estimate, at| estimate.cavity_power(at.change),
    ),
)
.means(
    "part of P_s in the cavity, its whole gap sheared",
    "`P_sc`: the part of P_s in the cavity, where models that keep no film fraction shear the whole gap; P without it is what a dry cavity would leave; none at rest",
)
.only(drops_in);

const DUAL: &str = "dual-weighted, with the error of integration";

/// A power of the journal's rotation; none at rest.
fn turning(film: &View, power: f64) -> Option<f64> {
    (film.journal().speed.abs() > 0.0).then_some(power)
}

fn of_power(estimate: &dyn Estimate, at: &Subject, parts: [f64; 2]) -> Option<Bar> {
    Some(estimate.power(parts, at.per(1.0)))
}

fn of_torque(estimate: &dyn Estimate, at: &Subject, parts: [f64; 2]) -> Option<Bar> {
    Some(estimate.power(parts, at.per(at.view.journal().speed.abs())))
}
