//! Extent of the cavity, and the oil that it makes.

use oilwedge_reynolds::error_bar::Bar;

use super::row::Measure::One;
use super::rule::ErrorRule;

rows! {
    /// `A_c/A`: area of the film that is cavity over the area that is free to be; of models with a free boundary
    CAVITY_SHARE = "cavity_share", "A_c/A", One, "share of the film that is cavity":
        One(|film| Some(film.measured.cavity?.share)),
        ErrorRule::Of("difference of the two films, and the part of the mesh that the edge of the cavity takes up",
            |estimate, at| Some(Bar::of(estimate.cavity_share(at.change)))),
        only(|scope| scope.cavitation.has_free_boundary());

    /// `theta_min`: least film fraction, 1 where the film is full; of models that conserve oil
    FILM_FRACTION_MIN = "film_fraction_min", "theta_min", One, "least film fraction (1: full)":
        One(|film| film.measured.cavity?.least_fraction),
        ErrorRule::Of("difference of the two films where there is least oil",
            |estimate, _| estimate.least_fraction().map(Bar::of)),
        only(|scope| scope.cavitation.conserves_oil());

    /// `Q_c`: oil that comes out of the cavity less what goes into it; of models that do not conserve oil there
    CAVITY_FLOW = "cavity_flow", "Q_c", CubicMetrePerSecond, "oil created by a cavity model that does not conserve oil":
        One(|film| drops(film).then_some(film.measured.flows.cavity)),
        ErrorRule::Of("sum of those of all flows that it balances", |estimate, at| estimate.cavity_flow(at.change)),
        only(|scope| scope.cavitation.drops_pressures());
}

/// True of a film whose cavity keeps no oil.
pub(super) fn drops(film: &super::view::View) -> bool {
    film.problem.cavitation.drops_pressures()
}
