//! Temperatures across the film, of its walls and feeds, and where the heat goes then.

use std::sync::Arc;

use oilwedge_bearing::film_heat::{FilmHeat, HotSpot};
use oilwedge_reynolds::lubricant::density::ZERO_CELSIUS;
use oilwedge_reynolds::supply::BoundaryKind;

use super::row::{Headline, Measure::Each, Measure::One, Table};
use super::rule::ErrorRule;
use super::view::{View, degrees};
use super::{Quantity, TEMPERATURE_EFFECTIVE, measured};

rows! {
    /// `T_max`: greatest temperature of the film at any point across it, walls included; none without `heat.field`
    TEMPERATURE_MAX = "temperature_max", "T_max", Celsius, "hottest point of the film, walls included":
        One(|film| hottest(film).map(|spot| spot.temperature - ZERO_CELSIUS)), OF_FIELD,
        in_table(Table::Temperature) only(|scope| scope.has_heat_field) headline(Headline::Always(8));

    /// Angle of the hottest point on the bearing; none without `heat.field`
    TEMPERATURE_MAX_ANGLE = "temperature_max_angle", "phi_T", Degree, "angle of the hottest point":
        One(|film| hottest(film).map(|spot| degrees(spot.angle))), OF_FIELD,
        in_table(Table::Temperature) only(|scope| scope.has_heat_field);

    /// Axial place of the hottest point; none without `heat.field`
    TEMPERATURE_MAX_Z = "temperature_max_z", "z_T", Metre, "axial place of the hottest point":
        One(|film| hottest(film).map(|spot| spot.along * film.problem.bearing.length)), OF_FIELD,
        in_table(Table::Temperature) only(|scope| scope.has_heat_field);

    /// `T_j`: temperature of the journal, one for all of it: it takes as much heat from the film as it gives back, but
    /// for what leaves along the shaft; none without `heat.field`
    TEMPERATURE_JOURNAL = "temperature_journal", "T_j", Celsius, "temperature of the journal":
        One(|film| heat(film)?.temperatures.journal.map(|t| t - ZERO_CELSIUS)), OF_FIELD,
        in_table(Table::Temperature) only(|scope| scope.has_heat_field) headline(Headline::Always(8));

    /// Greatest temperature of the bore; none without `heat.bush`
    TEMPERATURE_BUSH_MAX = "temperature_bush_max", "T_bmax", Celsius, "greatest temperature of the bore":
        One(|film| heat(film)?.hottest_of_bush().map(|spot| spot.temperature - ZERO_CELSIUS)), OF_FIELD,
        in_table(Table::Temperature) only(|scope| scope.has_heat_bush);

    /// Angle at which the bore is hottest; none without `heat.bush`
    TEMPERATURE_BUSH_MAX_ANGLE = "temperature_bush_max_angle", "phi_b", Degree, "angle at which the bore is hottest":
        One(|film| heat(film)?.hottest_of_bush().map(|spot| degrees(spot.angle))), OF_FIELD,
        in_table(Table::Temperature) only(|scope| scope.has_heat_bush);

    /// Mean temperature of the bore, feeds included; none without `heat.bush`
    TEMPERATURE_BUSH_MEAN = "temperature_bush_mean", "T_bm", Celsius, "mean temperature of the bore":
        One(|film| heat(film)?.mean_of_bush().map(|t| t - ZERO_CELSIUS)), OF_FIELD,
        in_table(Table::Temperature) only(|scope| scope.has_heat_bush);

    /// `T_f`: temperature of the oil in the feed of that name, in which all that flows in is mixed; none without
    /// `heat.field`
    FEED_TEMPERATURE = "feed_temperature.", "T_f", Celsius, "temperature of the oil mixed in that feed":
        Each(of_feeds), OF_FIELD,
        in_table(Table::Temperature) only(|scope| scope.has_heat_field && scope.is_fed);

    /// `P_h`: heat of the film, of shear and of the flow that pressure drives: `P` and what the pressure of the supply
    /// puts in, over a cycle the mean; none without `heat.field`
    HEAT_POWER = "heat_power", "P_heat", Watt, "heat of the film: friction, and the pressure of the supply":
        One(|film| heat(film).map(|_| film.measured.power.shear + film.measured.power.driven)), OF_FIELD,
        in_table(Table::Temperature) only(|scope| scope.has_heat_field);

    /// Heat into the bush; none without `heat.bush`
    HEAT_BUSH = "heat_bush", "P_b", Watt, "heat that the bush conducts away":
        One(|film| Some(heat(film)?.sheet.bush)), OF_FIELD,
        in_table(Table::Temperature) only(|scope| scope.has_heat_bush);

    /// Heat that leaves along the shaft; zero where no `heat.journal` is given, and none without `heat.field`
    HEAT_JOURNAL = "heat_journal", "P_j", Watt, "heat that leaves along the shaft":
        One(|film| Some(heat(film)?.sheet.journal)), OF_FIELD,
        in_table(Table::Temperature) only(|scope| scope.has_heat_field);
}

/// The bar of a number that follows from the temperatures: [`crate::thermal::field`] adds what layers and mesh change.
const OF_FIELD: ErrorRule = ErrorRule::Of(
    "what two layers more change, and what temperatures on the vertices of the mesh alone change",
    |_, _| Some(oilwedge_reynolds::error_bar::Bar::default()),
);

/// The numbers of the temperatures across a film.
pub(crate) fn of_temperatures(film: &View) -> Vec<Quantity> {
    measured(film).into_iter().filter(is_of_heat).collect()
}

/// Whether a number is one of the temperatures across a film.
pub(crate) fn is_of_heat(quantity: &Quantity) -> bool {
    quantity.row.table == Table::Temperature || quantity.row == &TEMPERATURE_EFFECTIVE
}

/// The temperatures of a film; none of one that has one temperature.
pub(super) fn heat<'a>(film: &View<'a>) -> Option<&'a Arc<FilmHeat>> {
    film.base.heat.as_ref()
}

fn hottest(film: &View) -> Option<HotSpot> {
    Some(heat(film)?.hottest())
}

fn of_feeds(film: &View) -> Vec<(String, f64)> {
    let Some(heat) = heat(film) else { return Vec::new() };
    let regions = film.base.system.supply.regions().iter().enumerate();
    let feeds = regions.filter(|(_, region)| region.kind == BoundaryKind::Feed);
    feeds.filter_map(|(k, region)| Some((region.name.clone(), heat.of_feed(k)? - ZERO_CELSIUS))).collect()
}
