//! The temperature of the film, and where its heat goes.

use oilwedge_bearing::{ThermalBalance, ThermalFlows};
use oilwedge_reynolds::error_bar::{Bar, FlowGoal};
use oilwedge_reynolds::lubricant::density::ZERO_CELSIUS;
use oilwedge_reynolds::supply::BoundaryKind;

use super::friction::FRICTION_POWER;
use super::heat_field::{HEAT_BUSH, HEAT_JOURNAL, HEAT_POWER, heat};
use super::motion::MOTION_POWER;
use super::quantity::Quantity;
use super::row::{Headline, Measure::One, Row, Table};
use super::rule::{ErrorRule, Subject};
use super::view::View;
use super::warming::Warming;
use crate::estimate::{Estimate, Scaled};
use crate::thermal::flows::thermal_flows;

rows! {
    /// `t_m`: temperature of the film, one for all of it; with `[heat]` the one at which `P + P_e = P_oil + P_h`, and
    /// with `heat.field` the mean over its oil; none where the oil has one viscosity
    TEMPERATURE_EFFECTIVE = "temperature_effective", "t_m", Celsius, "mean temperature of the film":
        One(|film| match heat(film) {
            Some(heat) => Some(heat.mean() - ZERO_CELSIUS),
            None => Some(film.base.oil.temperature? - ZERO_CELSIUS),
        }),
        ErrorRule::Temperature(|_| Some(1.0)), only(|scope| scope.is_by_temperature) headline(Headline::Always(8));

    /// `mu0 = mu(t_m, p = 0)`; none where the oil has one viscosity
    VISCOSITY_EFFECTIVE = "viscosity_effective", "mu0", PascalSecond, "viscosity at that temperature, without pressure":
        One(|film| film.base.oil.temperature.map(|_| film.problem.lubricant.viscosity)),
        ErrorRule::Temperature(|warming| warming.slope(VISCOSITY_EFFECTIVE.name)),
        only(|scope| scope.is_by_temperature);

    /// `Q_out`: oil that leaves the film: `Q_s` where oil only leaves at the ends, and what feeds drain; none without
    /// `[heat]`
    COOLING_FLOW = "cooling_flow", "Q_out", CubicMetrePerSecond, "oil that leaves the film and carries heat off":
        One(|film| Some(found(film)?.2.flow)),
        ErrorRule::Of("those of the flows at the ends, and where else oil leaves", of_leaving),
        in_table(Table::Temperature) only(|scope| scope.thermal.is_some());

    /// `t_in = 2 t_m - t_out`: temperature of the oil that enters the film, hot oil mixed in; none without
    /// `heat.mixing`
    TEMPERATURE_INLET = "temperature_inlet", "t_in", Celsius, "of the oil that enters the film, hot oil mixed in":
        One(|film| film.base.model.sockets.thermal?.mixing.and_then(|_| end(film, 0))),
        ErrorRule::Balance(|warming| warming.of_mixing(), |warming| Some(warming.ends()[0])),
        in_table(Table::Temperature) only(|scope| scope.thermal.is_some_and(|model| model.mixing.is_some()));

    /// `t_out = t_0 + 2 (1 + m)/(1 + 2 m) (t_m - t_0)`: temperature of the oil that leaves; t_0 that of the oil fed, m
    /// the hot oil carried over for each part of fresh oil; with `heat.field` the mean by flow of what leaves the ends;
    /// none without `[heat]`
    TEMPERATURE_OUTLET = "temperature_outlet", "t_out", Celsius, "of the oil that leaves it":
        One(|film| match heat(film) {
            Some(heat) => heat.sheet.outlet.map(|t| t - ZERO_CELSIUS),
            None => end(film, 1),
        }),
        ErrorRule::Balance(|warming| warming.of_mixing(), |warming| Some(warming.ends()[1])),
        in_table(Table::Temperature) only(|scope| scope.thermal.is_some() || scope.has_heat_field)
        headline(Headline::Always(9));

    /// `P_oil = rho c Q_out (t_out - t_0)`; none without `[heat]`
    HEAT_CARRIED = "heat_carried", "P_oil", Watt, "heat that the oil carries off":
        One(|film| match heat(film) {
            Some(heat) => Some(heat.sheet.carried),
            None => found(film).map(|(balance, temperature, film)| balance.carried(temperature, &film)),
        }),
        ErrorRule::Balance(|warming| warming.power, carried_per_kelvin),
        in_table(Table::Temperature) only(|scope| scope.thermal.is_some() || scope.has_heat_field);

    /// `P_h = G (t_m - t_a)`: G the conductance of the housing, t_a the temperature around it; none without
    /// `heat.housing`
    HEAT_HOUSING = "heat_housing", "P_h", Watt, "heat that the housing gives off":
        One(|film| found(film).and_then(|(balance, temperature, _)| balance.housing.map(|_| balance.given_off(temperature)))),
        ErrorRule::Temperature(|warming| warming.conductance()),
        in_table(Table::Temperature) only(|scope| scope.thermal.is_some_and(|model| model.balance.housing.is_some()));
}

/// The balance, the temperature [K] of the film, and what heats and cools it.
fn found(film: &View) -> Option<(ThermalBalance, f64, ThermalFlows)> {
    let (model, temperature) = (film.base.model.sockets.thermal?, film.base.oil.temperature?);
    Some((model.balance, temperature, thermal_flows(&model, film.base, film.measured)))
}

/// Bar of the oil that leaves the film: those of the flows through the ends, and through all other regions as far as
/// oil may leave there.
fn of_leaving(estimate: &dyn Estimate, at: &Subject) -> Option<Bar> {
    if at.value == 0.0 {
        return Some(Bar::default());
    }
    let elsewhere = [BoundaryKind::Line, BoundaryKind::Feed].map(|kind| at.view.regions(kind));
    let of_ends = estimate.flow(&FlowGoal::Ends, at.per(1.0))?;
    elsewhere.into_iter().flatten().try_fold(of_ends, |sum, (region, flow)| {
        let goal = FlowGoal::Region(region.name.clone());
        let bar = estimate.flow(&goal, Scaled { unit: 1.0, change: 0.0 })?;
        let leaves = (bar.total() - flow.net.max(0.0)).max(0.0);
        Some(sum + bar.scaled(leaves / bar.total().max(f64::MIN_POSITIVE)))
    })
}

/// What friction and squeeze make for each kelvin and the housing does not take [W/K].
fn carried_per_kelvin(warming: &Warming) -> Option<f64> {
    let slopes = [&FRICTION_POWER, &MOTION_POWER].map(|row| warming.slope(row.name));
    let made = slopes.into_iter().flatten().reduce(|a, b| a + b)?;
    Some(warming.conductance().unwrap_or(0.0) + made)
}

/// Temperature [degrees C] of the oil that enters (0) and leaves (1).
fn end(film: &View, which: usize) -> Option<f64> {
    let (balance, temperature, film) = found(film)?;
    Some(balance.ends(temperature, film.carried_over)[which] - ZERO_CELSIUS)
}

/// Heat of friction and squeeze that is not carried off, relative to it; zero where no temperature was sought.
pub fn left_over(quantities: &[Quantity]) -> f64 {
    let value = |row: &Row| {
        let quantity = quantities.iter().find(|quantity| quantity.row == row);
        quantity.map(|quantity| quantity.value)
    };
    let Some(carried) = value(&HEAT_CARRIED) else {
        return 0.0;
    };
    let part = |row: &Row| value(row).unwrap_or(0.0);
    if let Some(power) = value(&HEAT_POWER) {
        let given = carried + part(&HEAT_BUSH) + part(&HEAT_JOURNAL);
        return if power == 0.0 { 0.0 } else { ((power - given) / power).abs() };
    }
    match part(&FRICTION_POWER) + part(&MOTION_POWER) {
        0.0 => 0.0,
        power => ((power - carried - part(&HEAT_HOUSING)) / power).abs(),
    }
}
