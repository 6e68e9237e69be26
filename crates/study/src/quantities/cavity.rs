//! Extent of the cavity, and the oil that it makes.

use oilwedge_reynolds::error_bar::Bar;
use oilwedge_scene::CavitationModel;
use oilwedge_scene::Scene;

use super::row::{Measure::One, Row};
use super::rule::ErrorRule;
use super::unit::Unit::{CubicMetrePerSecond, One as Ratio};

/// Share of the film that is cavity.
pub static CAVITY_SHARE: Row = Row::new(
    "cavity_share",
    "A_c/A",
    Ratio,
    One(|film| Some(film.measured.cavity?.share)),
    ErrorRule::Of(
        "difference of the two films, and the part of the mesh that the edge of the cavity takes up",
        |estimate, at| Some(Bar::of(estimate.cavity_share(at.change))),
    ),
)
.means(
    "share of the film that is cavity",
    "`A_c/A`: area of the film that is cavity over the area that is free to be; of models with a free boundary",
)
.only(|scene| has(scene, CavitationModel::has_free_boundary));

/// Least film fraction.
pub static FILM_FRACTION_MIN: Row = Row::new(
    "film_fraction_min",
    "theta_min",
    Ratio,
    One(|film| film.measured.cavity?.least_fraction),
    ErrorRule::Of("difference of the two films where there is least oil", |estimate, _| {
        estimate.least_fraction().map(Bar::of)
    }),
)
.means(
    "least film fraction (1: full)",
    "`theta_min`: least film fraction, 1 where the film is full; of models that conserve oil",
)
.only(|scene| has(scene, CavitationModel::conserves_oil));

/// Oil that the cavity makes.
pub static CAVITY_FLOW: Row = Row::new(
    "cavity_flow",
    "Q_c",
    CubicMetrePerSecond,
    One(|film| drops(film).then_some(film.measured.flows.cavity)),
    ErrorRule::Of("sum of those of all flows that it balances", |estimate, at| {
        estimate.cavity_flow(at.change)
    }),
)
.means(
    "oil that the cavity makes, which conserves none",
    "`Q_c`: oil that comes out of the cavity less what goes into it; of models that do not conserve oil there",
)
.only(drops_in);

/// True of a film whose cavity keeps no oil.
pub(super) fn drops(film: &super::view::View) -> bool {
    film.problem.cavitation.drops_pressures()
}

/// True of a scene with such films.
pub(super) fn drops_in(scene: &Scene) -> bool {
    has(scene, CavitationModel::drops_pressures)
}

fn has(scene: &Scene, property: fn(CavitationModel) -> bool) -> bool {
    scene.cavitation.is_some_and(|cavitation| property(cavitation.model))
}
