//! The search for the temperature at which the heat is balanced, film by film.

use std::borrow::Cow;
use std::collections::HashMap;
use std::time::Instant;

use oilwedge_bearing::thermal_balance::{Start, find};
use oilwedge_bearing::{Balanced, InitialGuess, NoBalance, Point, ThermalFlows, Visited, Work};
use oilwedge_reynolds::lubricant::density::ZERO_CELSIUS;
use oilwedge_reynolds::solve::Neighbour;

use super::flows::thermal_flows;
use super::none;
use crate::compile::at_temperature;
use crate::film::Film;
use crate::isothermal::isothermal;
use crate::measure::measure;
use crate::no_answer::NoAnswer;
use crate::oil::first_temperature;
use crate::position::Position;
use crate::quantities::{self, Quantity, View};
use crate::solved::{Errors, SolveOptions, Solved, TemperatureFound};
use crate::thermal_model::ThermalModel;

/// The heat is balanced when what is left over is this part of the friction.
const BALANCED: f64 = 1e-8;
/// Heat that films which only lead to the balance may leave over, as a part of the friction.
pub(super) const ROUGHLY: f64 = 1e-4;
/// Force and load of films that only lead to the balance differ by this part of the load at most.
pub(super) const LEADING_ACCURACY: f64 = 1e-6;
/// Force and load of films that show how numbers change with temperature differ by this part of the load at most, for
/// the slope is that of a difference over half a kelvin.
const BESIDE_ACCURACY: f64 = 1e-9;
/// Friction under a load falls with temperature like this power of the viscosity: the slope of a first step, which
/// later ones correct.
const FRICTION_EXPONENT: f64 = 0.6;
/// Least distance [K] of films that show how numbers change with temperature.
const APART: f64 = 0.02;
/// Distance [K] at which a further film is solved where the others are too near.
const FURTHER: f64 = 0.5;

/// Why a search for the temperature was left.
pub(crate) enum Left {
    /// No film was found.
    NoAnswer(NoAnswer),
    /// The deadline came; the film reached is the answer.
    Ended,
}

/// How a film of the search is solved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Kind {
    /// The film leads to the balance; its position is found roughly.
    Leading,
    /// The film shows how numbers change near the balance.
    Beside,
    /// The film whose numbers are reported: with an error estimate, where one is asked for.
    Last,
}

/// Films at one temperature after the other.
pub(super) struct Search<'a> {
    film: &'a Film,
    model: ThermalModel,
    options: SolveOptions<'a>,
    /// The film with the least heat left over.
    best: Option<Tried>,
    /// Numbers of quadratic films that change smoothly with the temperature.
    numbers: Vec<Numbers>,
    /// Positions found, by the logarithms of one over the viscosity.
    visited: Vec<Visited>,
    /// Films solved.
    solved: usize,
    /// Positions of the journal tried.
    positions: usize,
    /// What that has cost.
    work: Work,
}

/// What was measured on a quadratic film.
struct Numbers {
    temperature: f64,
    surplus: f64,
    quantities: Vec<Quantity>,
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
            visited: Vec::new(),
            solved: 0,
            positions: 0,
            work: Work::default(),
        }
    }

    /// The temperature at which the heat is balanced to the part `accuracy` of the friction.
    pub(super) fn find(&mut self, start: Start, accuracy: f64, kind: Kind) -> Result<Balanced, NoBalance<Left>> {
        let balance = self.model.balance;
        let [coldest, hottest] = balance.range();
        let temperature = start.temperature.clamp(coldest, hottest);
        let slope = start.slope.or_else(|| self.estimated_slope(temperature, kind));
        find(&balance, Start { temperature, slope }, accuracy, |t| self.at(t, kind))
    }

    /// How the surplus changes with temperature [W/K], estimated from the film at one.
    fn estimated_slope(&mut self, temperature: f64, kind: Kind) -> Option<f64> {
        let flows = self.at(temperature, kind).ok()?;
        let thinner = |by: f64| -self.film.oil.at(temperature + by).viscosity.ln();
        let exponent = if self.film.load.is_some() { FRICTION_EXPONENT } else { 1.0 };
        let by_friction = exponent * flows.power * (thinner(0.5) - thinner(-0.5));
        let balance = self.model.balance;
        let taken = |mean: f64| balance.surplus(mean, &flows);
        Some(taken(temperature + 1.0) - taken(temperature) - by_friction)
    }

    fn at(&mut self, temperature: f64, kind: Kind) -> Result<ThermalFlows, Left> {
        if let Some(best) = (self.best.as_ref()).filter(|best| best.temperature == temperature && best.serves(kind)) {
            return Ok(best.flows);
        }
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
        (options.errors, options.accuracy) = match kind {
            Kind::Last => (options.errors, None),
            Kind::Beside => (Errors::Omitted, Some(BESIDE_ACCURACY)),
            Kind::Leading => (Errors::Omitted, Some(LEADING_ACCURACY)),
        };
        if let Some(Tried { solved, .. }) = from {
            film.problem.journal = solved.film.problem.journal;
            film = self.predicted(film);
            options.guess = InitialGuess::Near(Neighbour::Start(&solved.primary));
        }
        let solved = from_near_or_cold(&film, &options)?;
        self.positions += solved.balance.map_or(0, |balance| balance.steps);
        self.work += work_of(&solved);
        self.visited.push(visited(&solved.film));
        let measured = measure(solved.reported());
        let flows = thermal_flows(&self.model, &solved.film, &measured);
        let surplus = self.model.balance.surplus(temperature, &flows);
        // How numbers change with temperature is shown by balanced quadratic films alone.
        if kind != Kind::Last && !solved.is_ended() {
            let measured = measured.with_dynamics(&solved.film, solved.reported(), None);
            let view = View::new(&solved.film, &solved.film.problem, &measured);
            self.numbers.push(Numbers { temperature, surplus, quantities: quantities::measured(&view) });
        }
        Ok(Tried { temperature, flows, surplus, kind, solved, seconds: clock.elapsed().as_secs_f64() })
    }

    /// The balance of films whose numbers are reported: with error estimate those of cubic ones, but for
    /// mass-conserving films.
    fn balanced(&mut self, first: Start) -> Result<Balanced, NoBalance<Left>> {
        let rough = self.find(first, ROUGHLY, Kind::Leading)?;
        self.find(again(&rough), BALANCED, Kind::Last)
    }

    /// The film with the journal where the positions found before say that it will be.
    fn predicted(&self, film: Film) -> Film {
        let position = (film.load).and_then(|_| Position::predicted(&film.scene, &self.visited, point(&film)));
        match position {
            Some(position) => film.at_position(position),
            None => film,
        }
    }

    /// Solves what an error estimate needs beside the balance, which stays the answer. Without that film numbers have
    /// no bars; nothing else fails.
    fn prepare_estimate(&mut self, found: &Balanced) {
        if self.nearest(found.temperature).is_some() || self.options.deadline.is_over() {
            return;
        }
        let best = self.best.take();
        drop(self.tried(found.temperature + FURTHER, Kind::Beside, best.as_ref()));
        self.best = best;
    }

    /// The two films nearest to the root that are far enough from one another to show how numbers change.
    fn nearest(&self, root: f64) -> Option<[&Numbers; 2]> {
        let mut by_distance: Vec<&Numbers> = self.numbers.iter().collect();
        by_distance.sort_by(|a, b| (a.temperature - root).abs().total_cmp(&(b.temperature - root).abs()));
        let first = *by_distance.first()?;
        let mut others = by_distance.iter();
        let second = others.find(|other| (other.temperature - first.temperature).abs() > APART)?;
        Some([first, second])
    }

    /// How numbers change with temperature near the root.
    fn slopes(&self, root: f64) -> HashMap<Cow<'static, str>, f64> {
        let Some([here, there]) = self.nearest(root) else {
            return HashMap::new();
        };
        let slope = |quantity: &Quantity| {
            let other = there.quantities.iter().find(|other| other.name == quantity.name)?;
            let change = quantity.row.difference(other.value, quantity.value);
            Some((quantity.name.clone(), change / (there.temperature - here.temperature)))
        };
        here.quantities.iter().filter_map(slope).collect()
    }

    /// A balance with the slope of its surplus as films near it show it, where they do.
    fn with_slope(&self, found: Balanced) -> Balanced {
        let slope = |[here, there]: [&Numbers; 2]| {
            let change = there.surplus - here.surplus;
            change / (there.temperature - here.temperature)
        };
        Balanced { slope: self.nearest(found.temperature).map_or(found.slope, slope), ..found }
    }
}

impl Tried {
    /// Whether less heat is left over than of another one; a film whose numbers can be reported is better than one that
    /// leads to it.
    fn is_better(&self, other: &Self) -> bool {
        let is_last = |tried: &Self| tried.kind == Kind::Last;
        match is_last(self) == is_last(other) {
            true => self.surplus.abs() <= other.surplus.abs(),
            false => is_last(self),
        }
    }

    /// Whether another film of this kind would add nothing.
    fn serves(&self, kind: Kind) -> bool {
        self.kind == kind || self.kind == Kind::Last
    }

    /// The film at which the search was ended: the balance that is not one.
    fn unbalanced(&self) -> Balanced {
        Balanced { temperature: self.temperature, film: self.flows, surplus: self.surplus, slope: f64::NAN, films: 0 }
    }
}

/// What a film at one temperature has cost: the search for its position or, at a given one, its own solve.
pub(crate) fn work_of(solved: &Solved) -> Work {
    let (film, steps) = (&solved.primary.solution, solved.primary.solution.history.len());
    let own = Work { films: 1 + film.levels, factorisations: steps, linear_solves: steps };
    solved.balance.map_or(own, |balance| balance.work)
}

/// Place of a film's operating point among those of other temperatures.
pub(super) fn point(film: &Film) -> Point {
    let duty = -film.problem.lubricant.viscosity.ln();
    Point { coordinate: duty, duty }
}

/// The position of a film found.
pub(super) fn visited(film: &Film) -> Visited {
    film.position().visited(point(film))
}

/// A start from a balance towards another one nearby.
fn again(found: &Balanced) -> Start {
    Start { temperature: found.temperature, slope: Some(found.slope) }
}

/// Solves a film from the initial guess or, where that leads nowhere, from a cold start.
pub(super) fn from_near_or_cold(film: &Film, options: &SolveOptions) -> Result<Solved, NoAnswer> {
    let guess = InitialGuess::Cold;
    match isothermal(film, options) {
        Err(_) if !matches!(options.guess, InitialGuess::Cold) => isothermal(film, &SolveOptions { guess, ..*options }),
        other => other,
    }
}

/// Solves a film at the temperature at which its heat is balanced. Where the deadline comes before, the film reached is
/// the answer.
///
/// # Errors
/// [`NoAnswer`]: there is no film, no position, or no such temperature.
pub fn solve(film: &Film, model: &ThermalModel, options: &SolveOptions) -> Result<Solved, NoAnswer> {
    let clock = Instant::now();
    let first = film.oil.temperature.unwrap_or(first_temperature(model.balance.inlet));
    let mut search = Search::new(film, *model, options);
    let found = search.balanced(Start::at(first));
    if let (Ok(found), Errors::Estimated) = (&found, options.errors) {
        search.prepare_estimate(found);
    }
    let slopes = found.as_ref().map_or_else(|_| HashMap::new(), |found| search.slopes(found.temperature));
    let with_slope = found.as_ref().ok().map(|found| search.with_slope(*found));
    let is_ended = matches!(found, Err(NoBalance::NoFilm(Left::Ended) | NoBalance::Ends { reason: Left::Ended, .. }));
    let (balanced, best) = match (found, search.best) {
        (Ok(found), Some(best)) => (with_slope.unwrap_or(found), best),
        (Err(_), Some(best)) if is_ended => (best.unbalanced(), best),
        (Err(reason), _) => return Err(none(&model.balance, reason)),
        (Ok(_), None) => return Err(none(&model.balance, NoBalance::NoFilm(Left::Ended))),
    };
    let mut solved = best.solved;
    solved.temperature = Some(TemperatureFound {
        balanced: Balanced { films: search.solved, ..balanced },
        is_ended,
        positions: search.positions,
        work: search.work,
        slopes,
        seconds: clock.elapsed().as_secs_f64() - best.seconds,
    });
    Ok(solved)
}
