//! The film whose heat is balanced, and how its numbers change with the temperature.

use std::borrow::Cow;
use std::collections::HashMap;
use std::time::Instant;

use oilwedge_bearing::thermal_balance::find;
use oilwedge_bearing::{Balanced, FoundWarmth, InitialGuess, NoThermalBalance, Work};
use oilwedge_reynolds::SolvedFilm;
use oilwedge_reynolds::lubricant::density::ZERO_CELSIUS;
use oilwedge_reynolds::solve::Neighbour;

use super::flows::{thermal_flows, thermal_flows_of};
use super::heating::Heating;
use super::none;
use crate::film::Film;
use crate::isothermal::{heated, isothermal};
use crate::measure::measure;
use crate::no_answer::NoAnswer;
use crate::oil::first_temperature;
use crate::quantities::{self, Quantity, View};
use crate::solved::{Errors, SolveOptions, Solved, TemperatureFound};
use crate::thermal_model::ThermalModel;

/// Heat that films which only lead to the balance may leave over, as a part of the friction.
pub(super) const ROUGHLY: f64 = 1e-4;
/// Force and load of films that only lead to the balance differ by this part of the load at most.
const LEADING_ACCURACY: f64 = 1e-6;
/// Distance [K] from the temperature found of the film that shows how numbers change with it.
const BESIDE: f64 = 0.1;

/// How a film changes with its temperature.
#[derive(Default)]
struct Slopes {
    /// Each number, by name [1/K].
    numbers: HashMap<Cow<'static, str>, f64>,
    /// The heat that is left over [W/K].
    surplus: f64,
    /// What that has cost.
    work: Work,
}

/// Why a search for the temperature was left.
pub(crate) enum SearchStop {
    /// No film was found.
    NoAnswer(NoAnswer),
    /// The deadline came; the film reached is the answer.
    Ended,
}

/// Solves a film at the temperature at which its heat is balanced. Where the deadline comes before, the film reached is
/// the answer.
///
/// # Errors
/// [`NoAnswer`]: there is no film, no position, or no such temperature.
pub fn solve(film: &Film, model: &ThermalModel, options: &SolveOptions) -> Result<Solved, NoAnswer> {
    let with_warming = |film: &Film, options: &SolveOptions| {
        let warming = Heating::of(film);
        warming.map_or_else(|| isothermal(film, options), |warming| heated(film, &warming, options))
    };
    // A film that jumps as its temperature changes leaves heat over at the end of the bracket.
    let in_bracket = |film: Film| with_warming(&film, options).or_else(|_| isothermal(&film, options));
    let mut solved = with_warming(film, options).or_else(|_| bracketed(film, model, options).and_then(in_bracket))?;
    let (clock, balance, warming) = (Instant::now(), solved.balance, solved.warming.take());
    let is_ended = balance.is_some_and(|balance| balance.is_ended);
    let asked = warming.as_ref().filter(|_| options.errors == Errors::Estimated && !is_ended);
    let slopes = asked.and_then(|warming| slopes(&solved, model, warming)).unwrap_or_default();
    let temperature = solved.film.oil.temperature.unwrap_or(model.balance.inlet);
    let flows = warming.map_or_else(|| thermal_flows_of(model, solved.reported()), |warming| warming.flows);
    let surplus = model.balance.surplus(temperature, &flows);
    let (steps, mut work) = (balance.map_or(0, |balance| balance.steps), work_of(&solved));
    work += slopes.work;
    solved.temperature = Some(TemperatureFound {
        balanced: Balanced { temperature, film: flows, surplus, slope: slopes.surplus, films: steps },
        is_ended,
        positions: steps,
        work,
        slopes: slopes.numbers,
        seconds: clock.elapsed().as_secs_f64(),
    });
    solved.balance = film.load().and(balance);
    Ok(solved)
}

/// What a film has cost: the search for its position or, at a given one, its own solve.
pub(crate) fn work_of(solved: &Solved) -> Work {
    let (film, steps) = (&solved.primary.solution, solved.primary.solution.history.len());
    let own = Work { films: 1 + film.levels, factorisations: steps, linear_solves: steps };
    solved.balance.map_or(own, |balance| balance.work)
}

/// How numbers change with temperature: by a film beside the one found, where journal and wall have followed under the
/// same load. None where there is no such film.
fn slopes(solved: &Solved, model: &ThermalModel, warming: &FoundWarmth) -> Option<Slopes> {
    let numbers = |film: &Film, solution: &SolvedFilm| {
        let measured = measure(solution).with_dynamics(film, solution, None);
        let surplus = model.balance.surplus(film.oil.temperature?, &thermal_flows(model, film, &measured));
        Some((quantities::measured(&View::new(film, &film.problem, &measured)), surplus))
    };
    let film = solved.film.at_temperature(warming.temperature + BESIDE);
    let film = film.as_found(&warming.followed(&film.problem, BESIDE));
    let beside = film.problem.solve_from(&film.system, Neighbour::Start(&solved.primary)).ok()?;
    let ((here, less), (there, more)) = (numbers(&solved.film, &solved.primary)?, numbers(&film, &beside)?);
    let slope = |quantity: &Quantity| {
        let other = there.iter().find(|other| other.name == quantity.name)?;
        Some((quantity.name.clone(), quantity.row.difference(other.value, quantity.value) / BESIDE))
    };
    let steps = beside.solution.history.len();
    Some(Slopes {
        numbers: here.iter().filter_map(slope).collect(),
        surplus: (more - less) / BESIDE,
        work: Work { films: 1, factorisations: steps, linear_solves: steps },
    })
}

/// The film at the temperature at which its heat is balanced, where no search for all unknowns together has led to it:
/// by quadratic films at one temperature after the other.
fn bracketed(film: &Film, model: &ThermalModel, options: &SolveOptions) -> Result<Film, NoAnswer> {
    let mut last: Option<Solved> = None;
    let mut films = 0;
    let at = |temperature: f64| {
        if options.deadline.is_over() {
            return Err(SearchStop::Ended);
        }
        films += 1;
        if let Some(observer) = options.observer {
            observer.temperature(films, temperature - ZERO_CELSIUS);
        }
        let options = SolveOptions { accuracy: Some(LEADING_ACCURACY), errors: Errors::Omitted, ..*options };
        let solved = near_or_cold(temperature, (film, last.as_ref()), &options).map_err(SearchStop::NoAnswer)?;
        let (flows, is_ended) = (thermal_flows_of(model, &solved.primary), solved.is_ended());
        last = Some(solved);
        if is_ended { Err(SearchStop::Ended) } else { Ok(flows) }
    };
    let first = film.oil.temperature.unwrap_or(first_temperature(model.balance.inlet));
    let found = find(&model.balance, first, ROUGHLY, at);
    match (found, last) {
        (Ok(_), Some(last)) => Ok(last.film),
        (
            Err(NoThermalBalance::NoFilm(SearchStop::Ended) | NoThermalBalance::Ends { reason: SearchStop::Ended, .. }),
            Some(last),
        ) => Ok(last.film),
        (Err(reason), _) => Err(none(&model.balance, reason)),
        (Ok(_), None) => Err(none(&model.balance, NoThermalBalance::NoFilm(SearchStop::Ended))),
    }
}

/// A film at a temperature [K]: from another one, if there is one, or cold where that leads nowhere.
pub(super) fn near_or_cold(
    temperature: f64,
    (film, near): (&Film, Option<&Solved>),
    options: &SolveOptions,
) -> Result<Solved, NoAnswer> {
    let at = |film: &Film, guess| isothermal(&film.at_temperature(temperature), &SolveOptions { guess, ..*options });
    let near = near.map(|near| at(&near.film, InitialGuess::Near(Neighbour::Start(&near.primary))));
    near.and_then(Result::ok).map_or_else(|| at(film, InitialGuess::Cold), Ok)
}
