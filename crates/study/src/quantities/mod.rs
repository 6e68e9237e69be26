//! The catalogue of quantities: what is reported of a film, one row each, in the order of the report.
//!
//! A row (`row.rs`) has name, symbol, unit and definition, how the quantity is measured on a film (`view.rs`), and how
//! its error is estimated (`rule.rs`). Results, tables, columns of sweeps, tolerances and
//! `docs/reference/quantities.md` are made of the rows. A new quantity is a new row in the file of its group, and its
//! place in [`CATALOGUE`].

use std::borrow::Cow;

use crate::outline::LinerOutline;
use crate::scope::Scope;
use oilwedge_scene::Scene;

#[macro_use]
mod row;
mod cap;
mod cavity;
mod coefficients;
mod contact;
mod cycle;
pub mod cycle_view;
mod damping;
mod deviation;
mod flow;
mod friction;
mod heat;
mod heat_field;
mod liner;
mod load;
mod motion;
mod places;
mod position;
mod pressure;
mod quantity;
mod rotor;
mod rule;
mod similarity;
mod spread;
mod stiffness;
mod tilt;
mod turbulence;
mod unit;
pub(crate) mod view;
mod warming;

pub use cap::*;
pub use cavity::*;
pub use contact::*;
pub use cycle::*;
pub use cycle_view::CycleView;
pub use damping::*;
pub use deviation::*;
pub use flow::*;
pub use friction::*;
pub use heat::*;
pub use heat_field::*;
pub use liner::*;
pub use load::*;
pub use motion::*;
pub use oilwedge_reynolds::error_bar::Bar;
pub use places::*;
pub use position::*;
pub use pressure::*;
pub use quantity::Quantity;
pub use rotor::*;
pub use row::{Headline, Measure, Row, Table};
pub use rule::{ErrorRule, Subject};
pub use similarity::*;
pub use spread::{QuantitySpread, Sensitivity, ToleranceCurve};
pub use stiffness::*;
pub use tilt::*;
pub use turbulence::*;
pub use unit::Unit;
pub use view::View;
pub use warming::Warming;

/// All quantities, in the order of the report.
pub static CATALOGUE: &[&Row] = &[
    &CYCLE_FILM_THICKNESS_MIN,
    &CYCLE_FILM_THICKNESS_MIN_CRANK_ANGLE,
    &CYCLE_FILM_THICKNESS_MIN_ANGLE,
    &CYCLE_MIDDLE_FILM_MIN,
    &CYCLE_DEVIATION,
    &CYCLE_EQUIVALENT_FILM,
    &CYCLE_PRESSURE_MAX,
    &CYCLE_PRESSURE_MAX_CRANK_ANGLE,
    &CYCLE_LOAD_MAX,
    &CYCLE_POWER_LOSS,
    &CYCLE_FRICTION_POWER,
    &CYCLE_FRICTION_POWER_MAX,
    &CYCLE_FRICTION_SHEAR_POWER,
    &CYCLE_SIDE_FLOW,
    &CYCLE_CONTACT_SHARE_MAX,
    &CYCLE_CONTACT_DURATION,
    &CYCLE_TEMPERATURE,
    &CYCLE_TEMPERATURE_OUTLET,
    &CYCLE_COOLING_FLOW,
    &LOAD,
    &LOAD_X,
    &LOAD_Y,
    &LOAD_ANGLE,
    &SPECIFIC_LOAD,
    &LOAD_COEFFICIENT,
    &SOMMERFELD_NUMBER,
    &ATTITUDE_ANGLE,
    &ECCENTRICITY,
    &MIN_FILM_ANGLE,
    &TILT_X,
    &TILT_Y,
    &MOMENT_X,
    &MOMENT_Y,
    &LOAD_Z,
    &CONTACT_SHARE,
    &CONTACT_LOAD_X,
    &CONTACT_LOAD_Y,
    &CONTACT_MOMENT_X,
    &CONTACT_MOMENT_Y,
    &CONTACT_THRUST,
    &CONTACT_PRESSURE_MAX,
    &PRESSURE_MAX,
    &PRESSURE_MAX_ANGLE,
    &PRESSURE_MAX_Z,
    &PRESSURE_MIN,
    &FILM_THICKNESS_MIN,
    &FILM_THICKNESS_MIN_ANGLE,
    &FILM_THICKNESS_MIN_Z,
    &MIDDLE_FILM_MIN,
    &DEVIATION,
    &EQUIVALENT_FILM,
    &DEFLECTION_MAX,
    &CYCLE_DEFLECTION_MAX,
    &FILM_START_ANGLE,
    &FILM_END_ANGLE,
    &TEMPERATURE_EFFECTIVE,
    &VISCOSITY_EFFECTIVE,
    &VISCOSITY_MAX,
    &REYNOLDS_NUMBER_MAX,
    &TURBULENT_SHEAR,
    &CAVITY_SHARE,
    &FILM_FRACTION_MIN,
    &SIDE_FLOW,
    &SIDE_FLOW_LOW,
    &SIDE_FLOW_HIGH,
    &INLET_FLOW,
    &SIDE_FLOW_NUMBER,
    &INLET_FLOW_NUMBER,
    &FEED_FLOW,
    &CAVITY_FLOW,
    &FRICTION_TORQUE,
    &FRICTION_TORQUE_BEARING,
    &FRICTION_COEFFICIENT,
    &FRICTION_POWER,
    &FRICTION_SHEAR_POWER,
    &FRICTION_PRESSURE_POWER,
    &FRICTION_CAVITY_POWER,
    &FRICTION_CONTACT_POWER,
    &CONTACT_FRICTION_SHARE,
    &MOTION_POWER,
    &COOLING_FLOW,
    &TEMPERATURE_INLET,
    &TEMPERATURE_OUTLET,
    &HEAT_CARRIED,
    &HEAT_HOUSING,
    &TEMPERATURE_MAX,
    &TEMPERATURE_MAX_ANGLE,
    &TEMPERATURE_MAX_Z,
    &TEMPERATURE_JOURNAL,
    &TEMPERATURE_BUSH_MAX,
    &TEMPERATURE_BUSH_MAX_ANGLE,
    &TEMPERATURE_BUSH_MEAN,
    &FEED_TEMPERATURE,
    &HEAT_POWER,
    &HEAT_BUSH,
    &HEAT_JOURNAL,
    &PRESSURE_INTEGRAL,
    &REGION_LOAD_X,
    &REGION_LOAD_Y,
    &CAP_FORCE,
    &CAP_OPENING_FORCE,
    &CAP_FILM_SHARE,
    &SHELL_FORCE,
    &BOLT_FORCE,
    &BOLT_PRELOAD,
    &BOLT_TORQUE,
    &BOLT_FORCE_MAX,
    &BOLT_STRESS_MAX,
    &BOLT_STRESS_MIN,
    &BOLT_STRESS_MEAN,
    &BOLT_STRESS_AMPLITUDE,
    &STIFFNESS_XX,
    &STIFFNESS_XY,
    &STIFFNESS_X_GX,
    &STIFFNESS_X_GY,
    &STIFFNESS_YX,
    &STIFFNESS_YY,
    &STIFFNESS_Y_GX,
    &STIFFNESS_Y_GY,
    &STIFFNESS_MX_X,
    &STIFFNESS_MX_Y,
    &STIFFNESS_MX_GX,
    &STIFFNESS_MX_GY,
    &STIFFNESS_MY_X,
    &STIFFNESS_MY_Y,
    &STIFFNESS_MY_GX,
    &STIFFNESS_MY_GY,
    &DAMPING_XX,
    &DAMPING_XY,
    &DAMPING_X_GX,
    &DAMPING_X_GY,
    &DAMPING_YX,
    &DAMPING_YY,
    &DAMPING_Y_GX,
    &DAMPING_Y_GY,
    &DAMPING_MX_X,
    &DAMPING_MX_Y,
    &DAMPING_MX_GX,
    &DAMPING_MX_GY,
    &DAMPING_MY_X,
    &DAMPING_MY_Y,
    &DAMPING_MY_GX,
    &DAMPING_MY_GY,
    &CRITICAL_MASS,
    &WHIRL_RATIO,
    &LOGARITHMIC_DECREMENT,
];

/// The row that a quantity of this name belongs to.
pub fn row(name: &str) -> Option<&'static Row> {
    CATALOGUE.iter().copied().find(|row| row.has(name))
}

/// The quantity by which an answer is judged where nothing else is asked: the load, or the eccentricity that a given
/// load leads to.
pub fn main_quantity(scope: &Scope) -> &'static Row {
    match scope.is_loaded {
        _ if scope.orbit.is_some() => &CYCLE_FILM_THICKNESS_MIN,
        true => &ECCENTRICITY,
        false => &LOAD,
    }
}

/// The quantities of a measured film, without bars; one without a meaning there is absent.
pub fn measured(film: &View) -> Vec<Quantity> {
    in_order(|row| match row.measure {
        Measure::One(value) => value(film).map(|value| Quantity::new(row, value)).into_iter().collect(),
        Measure::OverCycle(_) => Vec::new(),
        Measure::Each(values) => {
            let member = |(region, value): (String, f64)| Quantity::of_region(row, &region, value);
            values(film).into_iter().map(member).collect()
        }
    })
}

/// The quantities of an orbit, with their bars where errors are estimated.
pub fn over_cycle(cycle: &CycleView) -> Vec<Quantity> {
    let quantity = |row: &'static Row| match row.measure {
        Measure::OverCycle(value) => value(cycle).map(|(value, bar)| {
            let mut quantity = Quantity::new(row, value);
            quantity.set_bar(bar);
            quantity
        }),
        Measure::One(_) | Measure::Each(_) => None,
    };
    CATALOGUE.iter().copied().filter_map(quantity).collect()
}

/// Names and rows of the quantities that films of these scenes may have.
pub fn of_scenes(scenes: &[Scene]) -> Vec<(Cow<'static, str>, &'static Row)> {
    let mut regions: Vec<String> = Vec::new();
    for outline in scenes.iter().map(LinerOutline::of) {
        for region in outline.regions() {
            if region.pressure().is_some() && !regions.contains(&region.name) {
                regions.push(region.name);
            }
        }
    }
    let scopes: Vec<Scope> = scenes.iter().map(Scope::of).collect();
    in_order(|row| match scopes.iter().any(|scope| row.may_occur(scope)) {
        false => Vec::new(),
        true if row.is_family() => regions.iter().map(|region| (row.region_name(region), row)).collect(),
        true => vec![(row.name.into(), row)],
    })
}

/// What rows give, in the order of the report: families side by side are listed region by region.
fn in_order<T>(of: impl Fn(&'static Row) -> Vec<T>) -> Vec<T> {
    let mut list = Vec::new();
    for rows in CATALOGUE.chunk_by(|row, next| row.is_family() && next.is_family()) {
        let mut each: Vec<_> = rows.iter().map(|row| of(row).into_iter()).collect();
        let mut len = usize::MAX;
        while len != list.len() {
            len = list.len();
            list.extend(each.iter_mut().filter_map(Iterator::next));
        }
    }
    list
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_row_is_documented_and_has_a_name_of_its_own() {
        for (place, row) in CATALOGUE.iter().enumerate() {
            assert!(!row.what.is_empty() && !row.definition.is_empty(), "{row:?} is not documented");
            assert!(!row.error.sentence().is_empty(), "{row:?} has no words for its error");
            assert!(!row.unit.dimension().is_empty() && !row.symbol.is_empty(), "{row:?}");
            let twin = CATALOGUE[..place].iter().find(|other| other.name == row.name);
            assert!(twin.is_none(), "{row:?} stands there twice");
        }
    }

    #[test]
    fn names_of_regions_belong_to_their_family() {
        assert_eq!(row("load_x"), Some(&LOAD_X));
        assert_eq!(row("load_x.hole.b"), Some(&REGION_LOAD_X));
        assert_eq!(row("feed_flow."), None);
        assert_eq!(row("colour"), None);
        let flow = Quantity::of_region(&FEED_FLOW, "hole.b", 1.0);
        assert_eq!((&*flow.name, flow.region()), ("feed_flow.hole.b", "hole.b"));
        assert_eq!(Quantity::new(&LOAD, 1.0).region(), "");
    }

    #[test]
    fn angles_differ_the_lesser_way_round() {
        assert_eq!(LOAD_ANGLE.difference(350.0, 20.0), -30.0);
        assert_eq!(LOAD_ANGLE.difference(20.0, 350.0), 30.0);
        assert_eq!(LOAD_ANGLE.difference(20.0, 50.0), -30.0);
        assert_eq!(LOAD.difference(350.0, 20.0), 330.0);
    }
}
