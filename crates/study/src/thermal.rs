//! The temperature of a film, at which friction heats the oil as much as it carries off: an unknown beside its position
//! ([`oilwedge_bearing::Heated`]).
//!
//! Its bar comes from those of friction and flow through the slope of their balance; all other numbers change with the
//! temperature as two films beside the one found show.

use oilwedge_bearing::{NoThermalBalance, ThermalBalance, ThermalFlows};

use crate::no_answer::{NoAnswer, NoTemperature, PowersAt};

mod bars;
mod between_runs;
mod curve;
pub(crate) mod field;
pub(crate) mod field_bars;
pub mod flows;
pub(crate) mod heating;
mod search;

pub(crate) use between_runs::FilmTemperature;
pub use curve::{cycle_temperature_report, temperature_report};
pub(crate) use search::SearchStop;
pub use search::solve;
pub(crate) use search::work_of;

/// What heats and what cools a film at a temperature [K].
pub(crate) fn powers(balance: &ThermalBalance, temperature: f64, film: &ThermalFlows) -> PowersAt {
    let carried_off = balance.carried(temperature, film) + balance.given_off(temperature);
    PowersAt { temperature, friction: film.power, carried_off }
}

/// Why there is no temperature.
pub(crate) fn none(balance: &ThermalBalance, reason: NoThermalBalance<SearchStop>) -> NoAnswer {
    let powers = |temperature: f64, film: &ThermalFlows| powers(balance, temperature, film);
    NoAnswer::Temperature(match reason {
        NoThermalBalance::NoFilm(SearchStop::NoAnswer(reason)) => return reason,
        NoThermalBalance::NoFilm(SearchStop::Ended) => NoTemperature::Ended { nearest: None },
        NoThermalBalance::Ends { temperature, film, reason: SearchStop::Ended } => {
            NoTemperature::Ended { nearest: Some(powers(temperature, &film)) }
        }
        NoThermalBalance::Ends { temperature, film, reason: SearchStop::NoAnswer(reason) } => {
            NoTemperature::NoFilmBeyond { last: powers(temperature, &film), reason: Box::new(reason) }
        }
        NoThermalBalance::TooHot { temperature, film } => NoTemperature::TooHot { hottest: powers(temperature, &film) },
    })
}
