//! The temperature of a film: films at one temperature after the other, until friction heats the oil as much as it carries off.
//!
//! The root is sought by quadratic films first, then by those whose numbers are reported. Its bar comes from those of friction and flow
//! through the slope of their balance; all other numbers change with the temperature as the films on the way have shown.

use std::collections::HashMap;
use std::time::Instant;

use oilwedge_bearing::heat_balance::find;
use oilwedge_bearing::{Balanced, FilmHeat, HeatBalance, NoBalance, Patience};
use oilwedge_reynolds::existence::readable;
use oilwedge_reynolds::lubricant::density::ZERO_CELSIUS;
use oilwedge_reynolds::supply::Place;
use oilwedge_reynolds::{Cavitation, FilmProblem, FilmSystem};

use crate::analysis::{NoAnswer, Solved, Start, Witness, graded, isothermal};
use crate::compile::{CompileError, Study};
use crate::liner_mesh::resized;
use crate::measure::{self, Measured, measure};
use crate::report::Quantity;
use crate::scene::{Heat, Mixing, Scene};
use crate::wording::celsius;

mod bars;
mod curve;
mod doubts;

pub(crate) use curve::heat_report;
pub(crate) use doubts::doubts;

/// The heat is balanced when what is left over is this part of the friction;
const BALANCED: f64 = 1e-8;
/// by films that only lead there, this part.
const ROUGHLY: f64 = 1e-4;
/// Films nearer to one another than this [K] do not tell how numbers change with temperature;
const APART: f64 = 0.02;
/// then one further away is solved [K].
const FURTHER: f64 = 0.5;
/// Edges of the mesh on which the temperature is sought first, over those of the first mesh of the scene.
const COARSE: f64 = 3.0;
/// Names of the quantities of a balance of heat.
const NAMES: [&str; 4] = [
    "temperature_inlet",
    "temperature_outlet",
    "heat_carried",
    "heat_housing",
];

/// True of quantities that there are only where the temperature is sought.
pub fn is_of_heat(name: &str) -> bool {
    NAMES.contains(&name)
}

/// A temperature found.
#[derive(Debug, Clone, PartialEq)]
pub struct HeatFound {
    /// The film there.
    pub balanced: Balanced,
    /// How each number changes with the temperature [1/K], by name.
    slopes: HashMap<String, f64>,
    /// Seconds that the films at other temperatures took.
    pub seconds: f64,
}

/// Why there is no temperature.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{told}")]
pub struct NoTemperature {
    told: String,
    /// True if there may be one.
    pub(crate) is_unreached: bool,
}

/// Oil [m3/s] that leaves the film: at the ends, at the edge of an arc, and where a feed drains it.
pub(crate) fn leaving(system: &FilmSystem, measured: &Measured) -> f64 {
    let regions = system.supply.regions().iter().zip(&measured.flows.regions);
    let leaves = regions.map(|(region, flow)| match region.place {
        Place::End => flow.outward,
        Place::Line | Place::Feed => (-flow.net).max(0.0),
        Place::Sealed => 0.0,
    });
    leaves.sum()
}

/// What heats and what cools the film.
fn film_heat(heat: &Heat, system: &FilmSystem, measured: &Measured) -> FilmHeat {
    let flow = leaving(system, measured);
    let round = measured.inlet_flow.map_or(0.0, |inlet| (inlet - flow).max(0.0));
    FilmHeat {
        power: measured.power.friction(),
        flow,
        carried_over: match heat.mixing {
            None => 0.0,
            Some(Mixing::Ratio(ratio)) => ratio,
            Some(Mixing::Share(_)) if flow == 0.0 => 0.0,
            Some(Mixing::Share(share)) => share * round / flow,
        },
    }
}

/// What is told of a balance of heat; nothing without one.
pub(crate) fn quantities(study: &Study, measured: &Measured) -> Vec<Quantity> {
    let (Some(heat), Some(temperature)) = (&study.heat, study.oil.temperature) else {
        return Vec::new();
    };
    let balance = heat.balance();
    let film = film_heat(heat, &study.system, measured);
    let [inlet, outlet] = balance.ends(temperature, film.carried_over);
    let mut list = Vec::new();
    let mut add = |name: &str, symbol: &str, value: f64, unit: &str| {
        list.push(Quantity::new(name, symbol, value, unit));
    };
    if heat.mixing.is_some() {
        add("temperature_inlet", "t_in", inlet - ZERO_CELSIUS, "degC");
    }
    add("temperature_outlet", "t_out", outlet - ZERO_CELSIUS, "degC");
    add("heat_carried", "P_oil", balance.carried(temperature, &film), "W");
    if heat.housing.is_some() {
        add("heat_housing", "P_h", balance.given_off(temperature), "W");
    }
    list
}

/// Heat of friction that is not carried off, relative to it; zero where no temperature was sought.
pub(crate) fn left_over(quantities: &[Quantity]) -> f64 {
    let value = |name: &str| {
        quantities
            .iter()
            .find(|quantity| quantity.name == name)
            .map(|quantity| quantity.value)
    };
    let (Some(power), Some(carried)) = (value("friction_power"), value("heat_carried")) else {
        return 0.0;
    };
    match power {
        0.0 => 0.0,
        power => ((power - carried - value("heat_housing").unwrap_or(0.0)) / power).abs(),
    }
}

/// What was measured on the film whose numbers are reported.
fn measured(study: &Study, solved: &Solved) -> Measured {
    match &solved.witness {
        Witness::Cubic(cubic) => measure(&study.problem, &study.system.enriched().system, cubic),
        Witness::None | Witness::Vertices(_) => measure(&study.problem, &study.system, &solved.film),
    }
}

/// Why a search for the temperature was left.
enum Left {
    /// There is no film.
    NoAnswer(NoAnswer),
    /// The search for a position was ended; that is the answer.
    Ended,
}

/// Films at one temperature after the other.
struct Films<'a> {
    study: &'a mut Study,
    heat: Heat,
    patience: Patience,
    /// The one with the least heat left over.
    best: Option<Best>,
    /// Numbers by temperature [K], of quadratic films.
    numbers: Vec<(f64, Vec<Quantity>)>,
}

/// A film, and the study as it was there.
struct Best {
    surplus: f64,
    /// Whether it is one whose errors are judged; what is left over of others does not count beside that.
    bars: bool,
    temperature: f64,
    problem: FilmProblem,
    solved: Solved,
    /// Seconds that it took.
    seconds: f64,
}

impl Films<'_> {
    fn at(&mut self, balance: &HeatBalance, temperature: f64, bars: bool, start: Start) -> Result<FilmHeat, Left> {
        let clock = Instant::now();
        self.study.heat_to(temperature);
        let neighbour = match (&self.best, start) {
            (Some(best), _) => {
                self.study.problem.journal = best.problem.journal;
                Start::Near(Some(&best.solved.film))
            }
            (None, start) => start,
        };
        let near = isothermal(self.study, bars, self.patience, neighbour);
        let solved = match near {
            Err(_) if !matches!(neighbour, Start::Scene) => isothermal(self.study, bars, self.patience, Start::Scene),
            other => other,
        };
        let solved = solved.map_err(Left::NoAnswer)?;
        let measured = measured(self.study, &solved);
        let film = film_heat(&self.heat, &self.study.system, &measured);
        if !bars {
            let numbers = measure::quantities(self.study, &measured);
            self.numbers.push((temperature, numbers));
        }
        let is_ended = solved.is_ended();
        let surplus = balance.surplus(temperature, &film).abs();
        let is_better = |best: &Best| (bars && !best.bars) || (bars == best.bars && surplus <= best.surplus);
        if is_ended || self.best.as_ref().is_none_or(is_better) {
            self.best = Some(Best {
                surplus,
                bars,
                temperature,
                problem: self.study.problem.clone(),
                solved,
                seconds: clock.elapsed().as_secs_f64(),
            });
        }
        match is_ended {
            true => Err(Left::Ended),
            false => Ok(film),
        }
    }

    /// How numbers change with temperature, by the two films nearest to the root.
    fn slopes(&self, root: f64) -> HashMap<String, f64> {
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
            if quantity.unit == "deg" {
                change = (change + 180.0).rem_euclid(360.0) - 180.0;
            }
            Some((quantity.name.clone(), change / (second - first)))
        };
        here.iter().filter_map(slope).collect()
    }
}

/// Solves a study at the temperature at which its heat is balanced; the study then has that temperature.
///
/// # Errors
/// [`NoAnswer`]: there is no film, no position, or no such temperature.
pub(crate) fn solve(
    study: &mut Study,
    heat: &Heat,
    bars: bool,
    patience: Patience,
    start: Start,
) -> Result<Solved, NoAnswer> {
    let clock = Instant::now();
    let balance = heat.balance();
    let first = study.oil.temperature.unwrap_or(heat.first_temperature());
    let mut films = Films {
        study,
        heat: *heat,
        patience,
        best: None,
        numbers: Vec::new(),
    };
    // The numbers of a mass-conserving film are those of the film itself; else those of a cubic one.
    let cubic = bars && !matches!(films.study.problem.cavitation, Cavitation::Jfo { .. });
    let accuracy = if cubic { ROUGHLY } else { BALANCED };
    let mut found = find(&balance, first, accuracy, |t| films.at(&balance, t, false, start));
    let mut asked = found.as_ref().map_or(0, |found| found.films);
    if let (Ok(rough), true) = (&found, cubic) {
        let rough = *rough;
        found = find(&balance, rough.temperature, BALANCED, |t| {
            films.at(&balance, t, true, start)
        });
        asked += found.as_ref().map_or(0, |found| found.films);
        if let Ok(found) = &mut found
            && found.slope.is_nan()
        {
            found.slope = rough.slope;
        }
    }
    if let (Ok(found), true) = (&found, bars) {
        // Without these films numbers have no bars; there is nothing else to fail.
        if !cubic {
            drop(films.at(&balance, found.temperature, true, start));
        }
        if films.slopes(found.temperature).is_empty() {
            for temperature in [found.temperature, found.temperature + FURTHER] {
                drop(films.at(&balance, temperature, false, start));
            }
        }
    }
    let slopes = found
        .as_ref()
        .map_or_else(|_| HashMap::new(), |found| films.slopes(found.temperature));
    let best = films.best.take();
    let mut balanced = match (found, &best) {
        (Ok(found), _) => found,
        // Ended before the balance: the film reached is the answer.
        (
            Err(
                NoBalance::NoFilm(Left::Ended)
                | NoBalance::Ends {
                    reason: Left::Ended, ..
                },
            ),
            Some(best),
        ) => Balanced {
            temperature: best.temperature,
            film: FilmHeat::default(),
            surplus: best.surplus,
            slope: f64::NAN,
            films: 0,
        },
        (Err(reason), _) => return Err(none(&balance, reason)),
    };
    balanced.films = asked;
    let Some(Best {
        temperature,
        problem,
        mut solved,
        seconds,
        ..
    }) = best
    else {
        return Err(none(&balance, NoBalance::NoFilm(Left::Ended)));
    };
    study.heat_to(temperature);
    study.problem = problem;
    solved.heat = Some(HeatFound {
        balanced,
        slopes,
        seconds: clock.elapsed().as_secs_f64() - seconds,
    });
    Ok(solved)
}

/// Why there is no temperature, in words.
fn none(balance: &HeatBalance, reason: NoBalance<Left>) -> NoAnswer {
    let watts = |film: &FilmHeat, t: f64| {
        let off = balance.carried(t, film) + balance.given_off(t);
        format!(
            "friction makes {} W, and {} W are carried off",
            readable(film.power),
            readable(off)
        )
    };
    let mut is_unreached = false;
    let told = match reason {
        NoBalance::NoFilm(Left::NoAnswer(reason)) => return reason,
        NoBalance::NoFilm(Left::Ended) => {
            is_unreached = true;
            "the search for the temperature was ended; give --max-seconds a higher limit".to_owned()
        }
        NoBalance::Ends {
            temperature,
            film,
            reason,
        } => {
            let why = match reason {
                Left::NoAnswer(reason) => {
                    is_unreached = reason.is_unreached();
                    reason.to_string()
                }
                Left::Ended => {
                    is_unreached = true;
                    "the search was ended".to_owned()
                }
            };
            format!(
                "no temperature balances the heat: at {} {}, and there is no film beyond: {why}",
                celsius(temperature),
                watts(&film, temperature)
            )
        }
        NoBalance::TooHot { temperature, film } => format!(
            "no temperature balances the heat: at {} still {}; feed more oil, or give [heat] housing",
            celsius(temperature),
            watts(&film, temperature)
        ),
    };
    NoAnswer::Heat(NoTemperature { told, is_unreached })
}

/// The scene with the temperature that a coarse film leads to, where one is sought: for meshes graded for it, and quick searches on them.
///
/// # Errors
/// The scene does not become a film.
pub(crate) fn warmed(scene: &Scene, patience: Patience) -> Result<Option<Scene>, CompileError> {
    if scene.heat.is_none() {
        return Ok(None);
    }
    let coarse = resized(scene, COARSE).unwrap_or_else(|| scene.clone());
    let mut study = graded(&coarse, patience)?;
    let found = solve_coarse(&mut study, patience);
    Ok(found.map(|temperature| scene.at_temperature(temperature)))
}

fn solve_coarse(study: &mut Study, patience: Patience) -> Option<f64> {
    let heat = study.heat?;
    let solved = solve(study, &heat, false, patience, Start::Scene).ok()?;
    Some(solved.heat?.balanced.temperature)
}
