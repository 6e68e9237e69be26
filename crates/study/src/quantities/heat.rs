//! The temperature of the film, and where its heat goes.

use oilwedge_bearing::{FilmHeat, HeatBalance};
use oilwedge_reynolds::lubricant::density::ZERO_CELSIUS;
use oilwedge_scene::Viscosity;

use super::friction::FRICTION_POWER;
use super::motion::MOTION_POWER;
use super::row::{Measure::One, Row, Table};
use super::rule::ErrorRule;
use super::unit::Unit::{Celsius, CubicMetrePerSecond, PascalSecond, Watt};
use super::view::View;
use crate::thermal::film_heat::{balance, film_heat};

/// Temperature of the film.
pub static TEMPERATURE_EFFECTIVE: Row = Row::new(
    "temperature_effective",
    "t_m",
    Celsius,
    One(|film| Some(film.study.oil.temperature? - ZERO_CELSIUS)),
    ErrorRule::Temperature(|_| Some(1.0)),
)
.means(
    "temperature of the film",
    "`t_m`: temperature of the film, one for all of it; with `[heat]` the one at which `P + P_e = P_oil + P_h`; none where the oil has one viscosity",
)
.only(|scene| matches!(scene.oil.viscosity, Viscosity::ByTemperature(_)));

/// Viscosity there.
pub static VISCOSITY_EFFECTIVE: Row = Row::new(
    "viscosity_effective",
    "mu0",
    PascalSecond,
    One(|film| film.study.oil.temperature.map(|_| film.problem.lubricant.viscosity)),
    ErrorRule::Temperature(|warming| warming.slope(&VISCOSITY_EFFECTIVE)),
)
.means(
    "viscosity at that temperature, without pressure",
    "`mu0 = mu(t_m, p = 0)`; none where the oil has one viscosity",
)
.only(|scene| matches!(scene.oil.viscosity, Viscosity::ByTemperature(_)));

/// Oil that carries heat off.
pub static COOLING_FLOW: Row = Row::new(
    "cooling_flow",
    "Q_out",
    CubicMetrePerSecond,
    One(|film| Some(found(film)?.2.flow)),
    ErrorRule::Heat(|warming| warming.flow, |_| Some(0.0)),
)
.means(
    "oil that leaves the film and carries heat off",
    "`Q_out`: oil that leaves the film: `Q_s` where oil only leaves at the ends, and what feeds drain; none without `[heat]`",
)
.in_table(Table::Heat)
.only(|scene| scene.heat.is_some());

/// Temperature with which oil enters.
pub static TEMPERATURE_INLET: Row = Row::new(
    "temperature_inlet",
    "t_in",
    Celsius,
    One(|film| film.study.heat?.mixing.and_then(|_| end(film, 0))),
    ErrorRule::Temperature(|warming| Some(warming.ends()[0])),
)
.means(
    "of the oil that enters the film, hot oil mixed in",
    "`t_in = 2 t_m - t_out`: temperature of the oil that enters the film, hot oil mixed in; none without `heat.mixing`",
)
.in_table(Table::Heat)
.only(|scene| scene.heat.is_some_and(|heat| heat.mixing.is_some()));

/// Temperature with which it leaves.
pub static TEMPERATURE_OUTLET: Row = Row::new(
    "temperature_outlet",
    "t_out",
    Celsius,
    One(|film| end(film, 1)),
    ErrorRule::Temperature(|warming| Some(warming.ends()[1])),
)
.means(
    "of the oil that leaves it",
    "`t_out = t_0 + 2 (1 + m)/(1 + 2 m) (t_m - t_0)`: temperature of the oil that leaves; t_0 that of the oil fed, m the hot oil carried over for each part of fresh oil; none without `[heat]`",
)
.in_table(Table::Heat)
.only(|scene| scene.heat.is_some());

/// Heat that leaves with the oil.
pub static HEAT_CARRIED: Row = Row::new(
    "heat_carried",
    "P_oil",
    Watt,
    One(|film| found(film).map(|(balance, temperature, film)| balance.carried(temperature, &film))),
    // What friction makes and the housing does not take.
    ErrorRule::Heat(
        |warming| warming.power,
        |warming| {
            let made = warming.slope(&FRICTION_POWER)?;
            Some(warming.conductance().unwrap_or(0.0) + made + warming.slope(&MOTION_POWER).unwrap_or(0.0))
        },
    ),
)
.means(
    "heat that the oil carries off",
    "`P_oil = rho c Q_out (t_out - t_0)`; none without `[heat]`",
)
.in_table(Table::Heat)
.only(|scene| scene.heat.is_some());

/// Heat that leaves through the housing.
pub static HEAT_HOUSING: Row = Row::new(
    "heat_housing",
    "P_h",
    Watt,
    One(|film| found(film).and_then(|(balance, temperature, _)| balance.housing.map(|_| balance.given_off(temperature)))),
    ErrorRule::Temperature(|warming| warming.conductance()),
)
.means(
    "heat that the housing gives off",
    "`P_h = G (t_m - t_a)`: G the conductance of the housing, t_a the temperature around it; none without `heat.housing`",
)
.in_table(Table::Heat)
.only(|scene| scene.heat.is_some_and(|heat| heat.housing.is_some()));

/// The balance, the temperature [K] of the film, and what heats and cools it.
fn found(film: &View) -> Option<(HeatBalance, f64, FilmHeat)> {
    let (heat, temperature) = (film.study.heat.as_ref()?, film.study.oil.temperature?);
    Some((balance(heat), temperature, film_heat(heat, film.study, film.measured)))
}

/// Temperature [degrees C] of the oil that enters (0) and leaves (1).
fn end(film: &View, which: usize) -> Option<f64> {
    let (balance, temperature, film) = found(film)?;
    Some(balance.ends(temperature, film.carried_over)[which] - ZERO_CELSIUS)
}
