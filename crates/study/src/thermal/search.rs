//! The search for the temperature at which the heat is balanced, film by film.
//!
//! The forms by which a mass-conserving film carries its oil change by jumps as its temperature does. So near the balance they are kept, and
//! chosen anew at the balance until they come to rest: as the position under a load is found.

use std::borrow::Cow;
use std::collections::HashMap;
use std::time::Instant;

use oilwedge_bearing::heat_balance::find;
use oilwedge_bearing::{Balanced, Deadline, FilmHeat, InitialGuess, NoBalance};
use oilwedge_reynolds::FilmProblem;
use oilwedge_reynolds::solve::Neighbour;

use super::{HeatFound, balance, film_heat, first_temperature, measured, none};
use crate::analysis::{NoAnswer, Solved, isothermal};
use crate::compile::Study;
use crate::quantities::{self, Quantity, Unit, View};
use oilwedge_scene::Heat;

/// The heat is balanced when what is left over is this part of the friction;
const BALANCED: f64 = 1e-8;
/// by films that only lead there, this part.
pub(super) const ROUGHLY: f64 = 1e-4;
/// Films nearer to one another than this [K] do not tell how numbers change with temperature;
const APART: f64 = 0.02;
/// then one further away is solved [K].
const FURTHER: f64 = 0.5;
/// Choices of the forms by which a mass-conserving film carries its oil.
const MOST_CHOICES: usize = 4;

/// Why a search for the temperature was left.
pub(super) enum Left {
    /// There is no film.
    NoAnswer(NoAnswer),
    /// Deadline was at its end; the film reached is the answer.
    Ended,
}

/// How a film is solved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Film {
    /// Without bars; a mass-conserving one chooses how it carries its oil.
    Chosen,
    /// A mass-conserving one that carries its oil as the best film does.
    Kept,
    /// With a witness that judges it, the forms kept.
    Judged,
}

/// Films at one temperature after the other.
pub(super) struct Films<'a> {
    study: &'a mut Study,
    heat: Heat,
    deadline: Deadline,
    /// Where the first film begins.
    start: InitialGuess<'a>,
    /// The one with the least heat left over.
    best: Option<Tried>,
    /// Numbers by temperature [K], of quadratic films.
    numbers: Vec<(f64, Vec<Quantity>)>,
    /// Films solved.
    solved: usize,
    /// True where the forms of a mass-conserving film were still changing at the balance.
    is_restless: bool,
}

/// A film, and the study as it was there.
struct Tried {
    temperature: f64,
    film: FilmHeat,
    surplus: f64,
    /// Whether it has a witness.
    is_judged: bool,
    problem: FilmProblem,
    solved: Solved,
    /// Seconds that it took.
    seconds: f64,
}

impl<'a> Films<'a> {
    pub(super) fn new(study: &'a mut Study, heat: Heat, deadline: Deadline, start: InitialGuess<'a>) -> Self {
        Self {
            study,
            heat,
            deadline,
            start,
            best: None,
            numbers: Vec::new(),
            solved: 0,
            is_restless: false,
        }
    }

    /// The temperature at which the heat is balanced to the part `accuracy` of the friction, sought from `first` [K].
    pub(super) fn find(&mut self, first: f64, accuracy: f64, kind: Film) -> Result<Balanced, NoBalance<Left>> {
        find(&balance(&self.heat), first, accuracy, |t| self.at(t, kind))
    }

    fn at(&mut self, temperature: f64, kind: Film) -> Result<FilmHeat, Left> {
        if self.deadline.is_over() && self.best.is_some() {
            return Err(Left::Ended);
        }
        let best = self.best.take();
        let tried = self.tried(temperature, kind, best.as_ref());
        self.best = best;
        let tried = tried.map_err(Left::NoAnswer)?;
        let (film, is_ended) = (tried.film, tried.solved.is_ended());
        if is_ended || self.best.as_ref().is_none_or(|best| tried.is_better(best)) {
            self.best = Some(tried);
        }
        match is_ended {
            true => Err(Left::Ended),
            false => Ok(film),
        }
    }

    /// The film at a temperature, from another one or as the scene says.
    fn tried(&mut self, temperature: f64, kind: Film, from: Option<&Tried>) -> Result<Tried, NoAnswer> {
        let clock = Instant::now();
        self.solved += 1;
        self.study.heat_to(temperature);
        let is_judged = kind == Film::Judged;
        let start = match from {
            Some(Tried { solved, problem, .. }) => {
                self.study.problem.journal = problem.journal;
                let keeps = kind != Film::Chosen && solved.film.film_fraction.is_some();
                let from = if keeps { Neighbour::Kept } else { Neighbour::Start };
                InitialGuess::Near(from(&solved.film))
            }
            None => self.start,
        };
        let solved = match isothermal(self.study, is_judged, self.deadline, start) {
            Err(_) if !matches!(start, InitialGuess::Cold) => {
                isothermal(self.study, is_judged, self.deadline, InitialGuess::Cold)
            }
            other => other,
        }?;
        let measured = measured(self.study, &solved);
        let film = film_heat(&self.heat, self.study, &measured);
        if !is_judged {
            let numbers = quantities::measured(&View::new(self.study, &self.study.problem, &measured));
            self.numbers.push((temperature, numbers));
        }
        Ok(Tried {
            temperature,
            film,
            surplus: balance(&self.heat).surplus(temperature, &film),
            is_judged,
            problem: self.study.problem.clone(),
            solved,
            seconds: clock.elapsed().as_secs_f64(),
        })
    }

    /// The balance of films whose numbers are reported: with `bars` those of cubic ones, but for mass-conserving films.
    fn balanced(&mut self, first: f64, bars: bool) -> Result<Balanced, NoBalance<Left>> {
        if self.study.problem.cavitation.conserves_oil() {
            return self.conserving(first);
        }
        if !bars {
            return self.find(first, BALANCED, Film::Chosen);
        }
        let rough = self.find(first, ROUGHLY, Film::Chosen)?;
        let found = self.find(rough.temperature, BALANCED, Film::Judged)?;
        Ok(or_slope(found, rough.slope))
    }

    /// The balance of mass-conserving films, where their forms have come to rest or, if they do not, by those chosen near it.
    fn conserving(&mut self, first: f64) -> Result<Balanced, NoBalance<Left>> {
        let mut found = self.find(first, ROUGHLY, Film::Chosen)?;
        for _ in 0..MOST_CHOICES {
            let near = self.find(found.temperature, BALANCED, Film::Kept)?;
            found = or_slope(near, found.slope);
            let kept = self.best.take();
            match self.tried(found.temperature, Film::Chosen, kept.as_ref()) {
                Ok(chosen) if chosen.surplus.abs() > BALANCED * chosen.film.power.abs() => self.best = Some(chosen),
                // Where the choice fails the film before stands.
                chosen => {
                    self.best = kept;
                    self.is_restless = chosen.is_err();
                    return Ok(found);
                }
            }
        }
        self.is_restless = true;
        let near = self.find(found.temperature, BALANCED, Film::Kept)?;
        Ok(or_slope(near, found.slope))
    }

    /// What bars need beside the balance. Without these films numbers have none; there is nothing else to fail.
    fn judge(&mut self, found: &Balanced) {
        if self.study.problem.cavitation.conserves_oil() {
            drop(self.at(found.temperature, Film::Judged));
        }
        if self.slopes(found.temperature).is_empty() {
            for temperature in [found.temperature, found.temperature + FURTHER] {
                drop(self.at(temperature, Film::Chosen));
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
            let mut change = other.value - quantity.value;
            if quantity.row.unit == Unit::Degree {
                change = (change + 180.0).rem_euclid(360.0) - 180.0;
            }
            Some((quantity.name.clone(), change / (second - first)))
        };
        here.iter().filter_map(slope).collect()
    }
}

impl Tried {
    /// Whether less heat is left over than of another one; that of films without a judge does not count beside one with it.
    fn is_better(&self, other: &Self) -> bool {
        match self.is_judged == other.is_judged {
            true => self.surplus.abs() <= other.surplus.abs(),
            false => self.is_judged,
        }
    }

    /// Where the search was ended: the balance that is not one.
    fn unbalanced(&self) -> Balanced {
        Balanced {
            temperature: self.temperature,
            film: self.film,
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

/// Solves a study at the temperature at which its heat is balanced; the study then has that temperature. Where deadline is at its end before,
/// the film reached is the answer.
///
/// # Errors
/// [`NoAnswer`]: there is no film, no position, or no such temperature.
pub fn solve(
    study: &mut Study,
    heat: &Heat,
    bars: bool,
    deadline: Deadline,
    start: InitialGuess,
) -> Result<Solved, NoAnswer> {
    let clock = Instant::now();
    let balance = balance(heat);
    let first = study.oil.temperature.unwrap_or(first_temperature(heat));
    let mut films = Films::new(study, *heat, deadline, start);
    let found = films.balanced(first, bars);
    if let (Ok(found), true) = (&found, bars) {
        films.judge(found);
    }
    let slopes = match &found {
        Ok(found) => films.slopes(found.temperature),
        Err(_) => HashMap::new(),
    };
    let Films {
        best,
        solved: asked,
        is_restless,
        ..
    } = films;
    let is_ended = matches!(
        found,
        Err(NoBalance::NoFilm(Left::Ended)
            | NoBalance::Ends {
                reason: Left::Ended,
                ..
            })
    );
    let (balanced, best) = match (found, best) {
        (Ok(found), Some(best)) => (found, best),
        (Err(_), Some(best)) if is_ended => (best.unbalanced(), best),
        (Err(reason), _) => return Err(none(&balance, reason)),
        (Ok(_), None) => return Err(none(&balance, NoBalance::NoFilm(Left::Ended))),
    };
    study.heat_to(best.temperature);
    study.problem = best.problem;
    let mut solved = best.solved;
    if is_restless {
        let told = "the forms by which oil is carried did not come to rest at the balanced temperature: those chosen near it are kept";
        solved.film.fallbacks.push(told.to_owned());
    }
    solved.heat = Some(HeatFound {
        balanced: Balanced {
            films: asked,
            ..balanced
        },
        is_ended,
        slopes,
        seconds: clock.elapsed().as_secs_f64() - best.seconds,
    });
    Ok(solved)
}
