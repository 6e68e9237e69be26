//! Extremes of pressure and viscosity.

use oilwedge_reynolds::error_bar::Bar;

use super::row::{Headline, Measure::One};
use super::rule::{ErrorRule, Subject};
use crate::estimate::Estimate;

rows! {
    /// `p_max`: greatest pressure, gauge, between nodes too (at nodes only beside a cavity of `jfo`)
    PRESSURE_MAX = "pressure_max", "p_max", Pascal, "greatest pressure, gauge":
        One(|film| Some(film.measured.extremes.greatest)),
        ErrorRule::Of("difference of the two films where either is greatest",
            |estimate, _| Some(Bar::of(estimate.greatest_pressure()))),
        tolerance headline(Headline::Always(6));

    /// `p_min`: least pressure, gauge, likewise; where there is a cavity, its pressure
    PRESSURE_MIN = "pressure_min", "p_min", Pascal, "least pressure, gauge":
        One(|film| Some(film.measured.extremes.least)),
        ErrorRule::Of("exact where it is that of a cavity; else difference of the two films where it is least",
            |estimate, _| Some(estimate.least_pressure()));

    /// `mu_max = mu(p_max)`
    VISCOSITY_MAX = "viscosity_max", "mu_max", PascalSecond, "viscosity at the greatest pressure":
        One(|film| Some(film.measured.extremes.viscosity(film.problem, film.measured.extremes.greatest))),
        ErrorRule::Of("viscosities at the ends of the bar of p_max", viscosity);
}

fn viscosity(estimate: &dyn Estimate, at: &Subject) -> Option<Bar> {
    let (bar, greatest) = (estimate.greatest_pressure(), at.view.measured.extremes.greatest);
    let off = |p: f64| (at.view.measured.extremes.viscosity(at.view.problem, p) - at.value).abs();
    bar.is_finite().then(|| Bar::of(off(greatest + bar).max(off(greatest - bar))))
}
