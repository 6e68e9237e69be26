//! Extremes of pressure and viscosity.

use oilwedge_reynolds::error_bar::Bar;

use super::row::{Measure::One, Row};
use super::rule::{ErrorRule, Subject};
use super::unit::Unit::{Pascal, PascalSecond};
use crate::estimate::Estimate;

/// Greatest pressure.
pub static PRESSURE_MAX: Row = Row::new(
    "pressure_max",
    "p_max",
    Pascal,
    One(|film| Some(film.measured.extremes.greatest)),
    ErrorRule::Of("difference of the two films where either is greatest", |estimate, _| {
        Some(Bar::of(estimate.greatest_pressure()))
    }),
)
.means(
    "greatest pressure, gauge",
    "`p_max`: greatest pressure, gauge, between nodes too (at nodes only beside a cavity of `jfo`)",
)
.tolerance()
.headline();

/// Least pressure.
pub static PRESSURE_MIN: Row = Row::new(
    "pressure_min",
    "p_min",
    Pascal,
    One(|film| Some(film.measured.extremes.least)),
    ErrorRule::Of(
        "exact where it is that of a cavity; else difference of the two films where it is least",
        |estimate, _| Some(estimate.least_pressure()),
    ),
)
.means(
    "least pressure, gauge",
    "`p_min`: least pressure, gauge, likewise; where there is a cavity, its pressure",
);

/// Greatest viscosity.
pub static VISCOSITY_MAX: Row = Row::new(
    "viscosity_max",
    "mu_max",
    PascalSecond,
    One(|film| Some(film.measured.extremes.viscosity)),
    ErrorRule::Of("viscosities at the ends of the bar of p_max", viscosity),
)
.means("viscosity at the greatest pressure", "`mu_max = mu(p_max)`");

fn viscosity(estimate: &dyn Estimate, at: &Subject) -> Option<Bar> {
    let (bar, greatest) = (estimate.greatest_pressure(), at.view.measured.extremes.greatest);
    let off = |p: f64| (at.view.problem.viscosity_at(p) - at.value).abs();
    bar.is_finite()
        .then(|| Bar::of(off(greatest + bar).max(off(greatest - bar))))
}
