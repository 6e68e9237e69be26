//! The error bars of a mass-conserving film, by its companion on the vertices alone: cells twice as wide.
//!
//! `docs/theory/error_estimation.md` has the rules and how often they hold.

use oilwedge_reynolds::FilmSolution;
use oilwedge_reynolds::error_bar::Bar;
use oilwedge_reynolds::error_bar::conserving::{ConservingError, conserving_error};
use oilwedge_reynolds::quantities::similarity;

use crate::analysis::Solved;
use crate::bars::{Judged, balanced, is_given, of_few, set};
use crate::compile::Study;
use crate::joint;
use crate::measure::{Measured, measure, quantities};
use crate::moved::position_bars;
use crate::result::Quantity;

/// Judges a mass-conserving film by its `companion`.
pub(crate) fn judge(study: &Study, solved: &Solved, companion: &FilmSolution) -> Judged {
    let measured = measure(&study.problem, &study.system, &solved.film);
    let mut list = quantities(study, &measured);
    let error = conserving_error(&study.problem, &study.system, &solved.film, companion);
    let Some(error) = error else {
        return Judged::without_bars(list, measured);
    };
    let moved = solved.balance.as_ref().map(|balance| {
        let bars = [error.load, error.across].map(|bar| of_few(study, bar).total());
        position_bars(study, &solved.film, balance, bars, &list)
    });
    for quantity in &mut list {
        let own = solved
            .balance
            .as_ref()
            .and_then(|balance| balanced(study, quantity, balance, &measured));
        let bar = own.or_else(|| {
            let bar = of_few(study, bar(study, quantity, &error, &measured)?);
            let position = moved.as_ref().map_or(0.0, |moved| moved[&quantity.name]);
            Some(Bar { position, ..bar })
        });
        set(quantity, bar);
    }
    Judged {
        indicator: Some(error.indicator),
        spread: error.spread,
        ..Judged::without_bars(list, measured)
    }
}

/// The bar of a number at the position of the film; none if it cannot be trusted.
fn bar(study: &Study, quantity: &Quantity, error: &ConservingError, measured: &Measured) -> Option<Bar> {
    let name = quantity.name.as_str();
    let plain = |discretisation: f64| Bar {
        discretisation,
        ..Bar::default()
    };
    let of_position = matches!(name, "eccentricity" | "min_film_angle" | "film_thickness_min");
    if is_given(name) || (of_position && study.load.is_none()) {
        return Some(Bar::default());
    }
    if !error.is_resolved {
        return None;
    }
    if of_position {
        return Some(Bar::default());
    }
    if !error.greatest_pressure.is_finite() && matches!(name, "pressure_max" | "viscosity_max") {
        return None;
    }
    let force = measured.load.magnitude().max(f64::MIN_POSITIVE);
    let speed = study.problem.journal.speed.abs();
    let flow_unit = similarity::flow_unit(&study.problem.bearing, &study.problem.journal);
    Some(match name {
        // A load that cannot be told from none may have any direction.
        "load_angle" | "attitude_angle" if error.across.total() >= force => plain(180.0),
        "load" => error.load,
        "load_x" => error.force[0],
        "load_y" => error.force[1],
        joint::FILM_SHARE => {
            let [x, y] = study.film_share()?;
            error.force[0].scaled(x) + error.force[1].scaled(y)
        }
        "load_angle" | "attitude_angle" => error.across.scaled(1f64.to_degrees() / force),
        "load_coefficient" | "sommerfeld_number" => error.load.scaled(quantity.value / force),
        "pressure_integral" => error.pressure_integral,
        "pressure_max" => plain(error.greatest_pressure),
        // That of the cavity.
        "pressure_min" if measured.cavity.is_some_and(|cavity| cavity.share > 0.0) => Bar::default(),
        "pressure_min" if error.greatest_pressure.is_finite() => plain(error.greatest_pressure),
        "pressure_min" => return None,
        "viscosity_max" => {
            let (problem, greatest) = (&study.problem, measured.extremes.greatest);
            let at = |p: f64| (problem.viscosity_at(p) - quantity.value).abs();
            plain(at(greatest + error.greatest_pressure).max(at(greatest - error.greatest_pressure)))
        }
        "cavity_share" => plain(error.cavity_share),
        "film_fraction_min" => plain(error.least_fraction),
        "side_flow" => plain(error.side_flow),
        "side_flow_number" => plain(error.side_flow / flow_unit?),
        "inlet_flow" => plain(error.inlet_flow),
        "inlet_flow_number" => plain(error.inlet_flow / flow_unit?),
        "friction_torque" => plain(error.power([1.0, 1.0]) / speed),
        "friction_torque_bearing" => plain(error.power([1.0, -1.0]) / speed),
        "friction_power" => plain(error.power([1.0, 1.0])),
        "friction_shear_power" => plain(error.power([1.0, 0.0])),
        "friction_pressure_power" => plain(error.power([0.0, 1.0])),
        "friction_coefficient" if error.load.total() >= force => return None,
        "friction_coefficient" => {
            let torque = plain(error.power([1.0, 1.0]) * quantity.value / measured.power.friction());
            torque.scaled(1.0) + error.load.scaled(quantity.value / force)
        }
        "squeeze_power" => {
            let [x, y] = study.problem.journal.velocity;
            error.force[0].scaled(x) + error.force[1].scaled(y)
        }
        region => {
            let end = region.strip_prefix("side_flow_").map(|end| format!("end_{end}"));
            let feed = end.or_else(|| Some(region.strip_prefix("feed_flow.")?.to_owned()))?;
            let place = study
                .system
                .supply
                .regions()
                .iter()
                .position(|region| region.name == feed)?;
            plain(*error.flows.get(place)?)
        }
    })
}
