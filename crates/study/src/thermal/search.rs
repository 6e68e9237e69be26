//! The search for the temperature at which the heat is balanced, film by film.
//!
//! The advection schemes of a mass-conserving film change by jumps as its temperature does. So near the balance they are kept, and chosen anew at
//! the balance until they come to rest: as the position under a load is found.

use std::borrow::Cow;
use std::collections::HashMap;
use std::time::Instant;

use oilwedge_bearing::thermal_balance::find;
use oilwedge_bearing::{Balanced, InitialGuess, NoBalance, ThermalFlows};
use oilwedge_reynolds::lubricant::density::ZERO_CELSIUS;
use oilwedge_reynolds::solve::Neighbour;

use super::flows::thermal_flows;
use super::{measured, none};
use crate::compile::at_temperature;
use crate::film::Film;
use crate::isothermal::isothermal;
use crate::no_answer::NoAnswer;
use crate::oil::first_temperature;
use crate::quantities::{self, Quantity, View};
use crate::solved::{Errors, SolveOptions, Solved, TemperatureFound};
use crate::thermal_model::ThermalModel;

/// The heat is balanced when what is left over is this part of the friction;
const BALANCED: f64 = 1e-8;
/// by films that only lead there, this part.
pub(super) const ROUGHLY: f64 = 1e-4;
/// Films nearer to one another than this [K] do not show how numbers change with temperature;
const APART: f64 = 0.02;
/// then one further away is solved [K].
const FURTHER: f64 = 0.5;
/// Choices of the advection schemes of a mass-conserving film.
const MOST_CHOICES: usize = 4;

/// Why a search for the temperature was left.
pub(super) enum Left {
    /// There is no film.
    NoAnswer(NoAnswer),
    /// The deadline came; the film reached is the answer.
    Ended,
}

/// How a film of the search is solved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Kind {
    /// Without error estimate; a mass-conserving film chooses its advection schemes.
    Chosen,
    /// A mass-conserving film keeps the advection schemes of the best film.
    Kept,
    /// With error estimate, the schemes kept.
    Estimated,
}

/// Films at one temperature after the other.
pub(super) struct Search<'a> {
    film: &'a Film,
    model: ThermalModel,
    options: SolveOptions<'a>,
    /// The film with the least heat left over.
    best: Option<Tried>,
    /// Numbers by temperature [K], of quadratic films.
    numbers: Vec<(f64, Vec<Quantity>)>,
    /// Films solved.
    solved: usize,
    /// Positions of the journal tried.
    positions: usize,
    /// True where the schemes of a mass-conserving film were still changing at the balance.
    is_restless: bool,
}

/// A solved film at a temperature.
struct Tried {
    temperature: f64,
    flows: ThermalFlows,
    surplus: f64,
    kind: Kind,
    solved: Solved,
    /// Seconds that it took.
    seconds: f64,
}

impl<'a> Search<'a> {
    pub(super) fn new(film: &'a Film, model: ThermalModel, options: &SolveOptions<'a>) -> Self {
        Self {
            film,
            model,
            options: *options,
            best: None,
            numbers: Vec::new(),
            solved: 0,
            positions: 0,
            is_restless: false,
        }
    }

    /// The temperature at which the heat is balanced to the part `accuracy` of the friction, sought from `first` [K].
    pub(super) fn find(&mut self, first: f64, accuracy: f64, kind: Kind) -> Result<Balanced, NoBalance<Left>> {
        let balance = self.model.balance;
        find(&balance, first, accuracy, |t| self.at(t, kind))
    }

    fn at(&mut self, temperature: f64, kind: Kind) -> Result<ThermalFlows, Left> {
        if self.options.deadline.is_over() && self.best.is_some() {
            return Err(Left::Ended);
        }
        let best = self.best.take();
        let tried = self.tried(temperature, kind, best.as_ref());
        self.best = best;
        let tried = tried.map_err(Left::NoAnswer)?;
        let (flows, is_ended) = (tried.flows, tried.solved.is_ended());
        if is_ended || self.best.as_ref().is_none_or(|best| tried.is_better(best)) {
            self.best = Some(tried);
        }
        match is_ended {
            true => Err(Left::Ended),
            false => Ok(flows),
        }
    }

    /// The film at a temperature, from another one or as the scene says.
    fn tried(&mut self, temperature: f64, kind: Kind, from: Option<&Tried>) -> Result<Tried, NoAnswer> {
        let clock = Instant::now();
        self.solved += 1;
        if let Some(observer) = self.options.observer {
            observer.temperature(self.solved, temperature - ZERO_CELSIUS);
        }
        let mut film = at_temperature(self.film, temperature);
        let mut options = self.options;
        options.errors = match kind {
            Kind::Estimated => Errors::Estimated,
            Kind::Chosen | Kind::Kept => Errors::Omitted,
        };
        if let Some(Tried { solved, .. }) = from {
            film.problem.journal = solved.film.problem.journal;
            let keeps = kind != Kind::Chosen && solved.solution.film_fraction.is_some();
            let near = if keeps { Neighbour::Kept } else { Neighbour::Start };
            options.guess = InitialGuess::Near(near(&solved.solution));
        }
        let solved = from_near_or_cold(&film, &options)?;
        self.positions += solved.balance.map_or(0, |balance| balance.steps);
        let measured = measured(&solved);
        let flows = thermal_flows(&self.model, &solved.film, &measured);
        if kind != Kind::Estimated {
            let view = View::new(&solved.film, &solved.film.problem, &measured);
            self.numbers.push((temperature, quantities::measured(&view)));
        }
        Ok(Tried {
            temperature,
            flows,
            surplus: self.model.balance.surplus(temperature, &flows),
            kind,
            solved,
            seconds: clock.elapsed().as_secs_f64(),
        })
    }

    /// The balance of films whose numbers are reported: with error estimate those of cubic ones, but for mass-conserving films.
    fn balanced(&mut self, first: f64) -> Result<Balanced, NoBalance<Left>> {
        if self.film.problem.cavitation.conserves_oil() {
            return self.conserving(first);
        }
        if self.options.errors == Errors::Omitted {
            return self.find(first, BALANCED, Kind::Chosen);
        }
        let rough = self.find(first, ROUGHLY, Kind::Chosen)?;
        let found = self.find(rough.temperature, BALANCED, Kind::Estimated)?;
        Ok(or_slope(found, rough.slope))
    }

    /// The balance of mass-conserving films, where their schemes have come to rest or, if they do not, by those chosen near it.
    fn conserving(&mut self, first: f64) -> Result<Balanced, NoBalance<Left>> {
        let mut found = self.find(first, ROUGHLY, Kind::Chosen)?;
        for _ in 0..MOST_CHOICES {
            let near = self.find(found.temperature, BALANCED, Kind::Kept)?;
            found = or_slope(near, found.slope);
            let kept = self.best.take();
            match self.tried(found.temperature, Kind::Chosen, kept.as_ref()) {
                Ok(chosen) if chosen.surplus.abs() > BALANCED * chosen.flows.power.abs() => self.best = Some(chosen),
                // Where the choice fails the film before stands.
                chosen => {
                    self.best = kept;
                    self.is_restless = chosen.is_err();
                    return Ok(found);
                }
            }
        }
        self.is_restless = true;
        let near = self.find(found.temperature, BALANCED, Kind::Kept)?;
        Ok(or_slope(near, found.slope))
    }

    /// Solves what an error estimate needs beside the balance. Without these films numbers have no bars; nothing else fails.
    fn prepare_estimate(&mut self, found: &Balanced) {
        if self.film.problem.cavitation.conserves_oil() {
            drop(self.at(found.temperature, Kind::Estimated));
        }
        if self.slopes(found.temperature).is_empty() {
            for temperature in [found.temperature, found.temperature + FURTHER] {
                drop(self.at(temperature, Kind::Chosen));
            }
        }
    }

    /// How numbers change with temperature, by the two films nearest to the root.
    fn slopes(&self, root: f64) -> HashMap<Cow<'static, str>, f64> {
        let mut by_distance: Vec<_> = self.numbers.iter().collect();
        by_distance.sort_by(|a, b| (a.0 - root).abs().total_cmp(&(b.0 - root).abs()));
        let Some((first, here)) = by_distance.first() else {
            return HashMap::new();
        };
        let Some((second, there)) = by_distance.iter().find(|(other, _)| (other - first).abs() > APART) else {
            return HashMap::new();
        };
        let slope = |quantity: &Quantity| {
            let other = there.iter().find(|other| other.name == quantity.name)?;
            let change = quantity.row.difference(other.value, quantity.value);
            Some((quantity.name.clone(), change / (second - first)))
        };
        here.iter().filter_map(slope).collect()
    }
}

impl Tried {
    /// Whether less heat is left over than of another one; a film with error estimate is better than one without.
    fn is_better(&self, other: &Self) -> bool {
        let is_estimated = |tried: &Self| tried.kind == Kind::Estimated;
        match is_estimated(self) == is_estimated(other) {
            true => self.surplus.abs() <= other.surplus.abs(),
            false => is_estimated(self),
        }
    }

    /// Where the search was ended: the balance that is not one.
    fn unbalanced(&self) -> Balanced {
        Balanced {
            temperature: self.temperature,
            film: self.flows,
            surplus: self.surplus,
            slope: f64::NAN,
            films: 0,
        }
    }
}

/// With that slope where it has none.
fn or_slope(found: Balanced, slope: f64) -> Balanced {
    match found.slope.is_nan() {
        true => Balanced { slope, ..found },
        false => found,
    }
}

/// Solves a film from the initial guess or, where that leads nowhere, from a cold start.
pub(super) fn from_near_or_cold(film: &Film, options: &SolveOptions) -> Result<Solved, NoAnswer> {
    let guess = InitialGuess::Cold;
    match isothermal(film, options) {
        Err(_) if !matches!(options.guess, InitialGuess::Cold) => isothermal(film, &SolveOptions { guess, ..*options }),
        other => other,
    }
}

/// Solves a film at the temperature at which its heat is balanced. Where the deadline comes before, the film reached is the answer.
///
/// # Errors
/// [`NoAnswer`]: there is no film, no position, or no such temperature.
pub fn solve(film: &Film, model: &ThermalModel, options: &SolveOptions) -> Result<Solved, NoAnswer> {
    let clock = Instant::now();
    let first = film.oil.temperature.unwrap_or(first_temperature(model.balance.inlet));
    let mut search = Search::new(film, *model, options);
    let found = search.balanced(first);
    if let (Ok(found), Errors::Estimated) = (&found, options.errors) {
        search.prepare_estimate(found);
    }
    let slopes = found
        .as_ref()
        .map_or_else(|_| HashMap::new(), |found| search.slopes(found.temperature));
    let is_ended = matches!(
        found,
        Err(NoBalance::NoFilm(Left::Ended)
            | NoBalance::Ends {
                reason: Left::Ended,
                ..
            })
    );
    let (balanced, best) = match (found, search.best) {
        (Ok(found), Some(best)) => (found, best),
        (Err(_), Some(best)) if is_ended => (best.unbalanced(), best),
        (Err(reason), _) => return Err(none(&model.balance, reason)),
        (Ok(_), None) => return Err(none(&model.balance, NoBalance::NoFilm(Left::Ended))),
    };
    let mut solved = best.solved;
    if search.is_restless {
        let fallback =
            "the advection schemes did not come to rest at the balanced temperature: those chosen near it are kept";
        solved.solution.fallbacks.push(fallback.to_owned());
    }
    solved.temperature = Some(TemperatureFound {
        balanced: Balanced {
            films: search.solved,
            ..balanced
        },
        is_ended,
        positions: search.positions,
        slopes,
        seconds: clock.elapsed().as_secs_f64() - best.seconds,
    });
    Ok(solved)
}
