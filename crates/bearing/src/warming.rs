//! # Heat: the temperature of a film as an unknown beside place, tilt and wall
//!
//! **Equation.** `E(x, T) = P - rho c Q (t_out - t_0) - G (T - t_a) = 0` ([`crate::thermal_balance`]), P and Q of the
//! film at the coordinates x and the temperature T, which gives its oil the viscosity mu(T).
//!
//! **Method.** A step of [`crate::newton`] is bordered once more. With the moves y_0 that balance force and wall at
//! this temperature, and those y_1 by which they follow a kelvin under the same load, the step is `y_0 + y_1 dT`, `dT =
//! -(E + c y_0)/(b + c y_1)`. y_1 takes one back-substitution by the viscosity and one solve of the tangent. The row
//! (c, b) of E is never computed: it begins with what friction usually does, and each step corrects it by what it
//! missed (Broyden). So nothing but one film a step is measured.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | E | W | `surplus` |
//! | c, b | W/m, W/K | `WarmthRow` |
//! | y_1 | m/K | `Tangents::thicker` |
//!
//! **Source.** Broyden, Math. Comp. 19 (1965) 577. **Range.** Steady films, each of one temperature. **Verified by**
//! `tests/tests/cli/heat.rs`, `tests/tests/literature/thermal_balance.rs`: the heat of the film found is balanced.

use std::fmt::Debug;

use oilwedge_fem::newton::NewtonFailure;
use oilwedge_reynolds::lubricant::{Lubricant, PressureLaw};
use oilwedge_reynolds::quantities::load::oil_change;
use oilwedge_reynolds::{CentreVelocity, FilmChange, FilmProblem, NoFilm, SolvedFilm};

use crate::coordinates::{Coordinates, Vector, dot, moved};
use crate::coupled::Tangents;
use crate::deflection::Moves;
use crate::search::{Search, Trial, WarmthRow};
use crate::thermal_balance::{LONGEST_THINNING, ThermalBalance, ThermalFlows, is_usual};

/// The heat is balanced when what is left over is this part of the friction.
pub(crate) const BALANCED: f64 = 1e-8;
/// From this part of load and heat that is left on the surplus is believed to change as in a film whose cavity is held.
const MOVING: f64 = 1e-2;
/// Accuracy of the linear systems of film and wall by which a balanced film follows its temperature.
const FOLLOWED: f64 = 1e-3;
/// Temperatures [K] whose difference shows how the viscosity changes.
const APART: f64 = 0.01;

/// A film whose temperature is unknown.
pub trait Heated: Debug + Sync {
    /// What heats it, and what takes the heat off.
    fn balance(&self) -> ThermalBalance;

    /// Oil of the film at a temperature [K].
    fn lubricant(&self, temperature: f64) -> Lubricant;

    /// What heats and what cools it where it is solved so.
    fn flows(&self, film: &SolvedFilm) -> ThermalFlows;
}

/// The heat of a trial.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Warmth {
    /// Temperature of the film [K].
    temperature: f64,
    /// What heats and cools it.
    flows: ThermalFlows,
    /// Heat that neither takes [W].
    surplus: f64,
}

/// The heat of a film whose temperature was found, and how its journal and wall follow that under the same load.
#[derive(Debug, Clone)]
pub struct FoundWarmth {
    /// Temperature of the film [K].
    pub temperature: f64,
    /// What heats and cools it.
    pub flows: ThermalFlows,
    coordinates: Coordinates,
    /// Velocity of the journal's centre.
    velocity: CentreVelocity,
    /// Change of the coordinates [m/K].
    place: Vector,
    /// Change of the coefficients of the deflection [m/K]; empty where the wall is rigid.
    wall: Vec<f64>,
}

impl FoundWarmth {
    /// A problem whose journal and wall have followed so many kelvin.
    pub fn followed(&self, problem: &FilmProblem, kelvin: f64) -> FilmProblem {
        let place = self.place.map(|x| kelvin * x);
        let journal = problem.journal.changed(&self.coordinates.change(&problem.journal, &self.velocity, place));
        let more: Vec<f64> = self.wall.iter().map(|d| kelvin * d).collect();
        let bent = problem.deflection().map(|deflection| deflection.with_more(&more));
        FilmProblem { journal, ..problem.clone() }.deflected(bent.as_ref())
    }
}

impl Search<'_> {
    /// The heat of a trial; none where its temperature is given.
    fn warmth(&self, trial: &Trial) -> Option<Warmth> {
        let warming = self.options.warming?;
        let temperature = trial.film.problem.lubricant.temperature?;
        let flows = || warming.flows(trial.cubic.as_ref().unwrap_or(&trial.film));
        let flows = *trial.warming.get_or_init(flows);
        Some(Warmth { temperature, flows, surplus: warming.balance().surplus(temperature, &flows) })
    }

    /// Heat that a trial leaves over, as a part of its friction [1]; zero where its temperature is given.
    pub(crate) fn part_left_over(&self, trial: &Trial) -> f64 {
        let of = |warmth: Warmth| (warmth.surplus / warmth.flows.power).abs();
        self.warmth(trial).map_or(0.0, |warmth| if warmth.surplus == 0.0 { 0.0 } else { of(warmth) })
    }

    /// The step that balances the heat of a trial too, where `moves` balance force and wall at its temperature.
    ///
    /// # Errors
    /// The linear systems could not be solved.
    pub(crate) fn with_warming(&self, here: &Trial, tangents: &Tangents, moves: Moves) -> Result<Moves, NoFilm> {
        let (Some(warmth), Some(warming)) = (self.warmth(here), self.options.warming) else {
            return Ok(moves);
        };
        let Warmth { temperature, surplus, .. } = warmth;
        let thinning = thinning(warming, temperature);
        let per_kelvin = Moves { kelvin: 1.0, ..tangents.thicker(self, here)?.over(1.0 / thinning) };
        let row = self.row_at(&warming.balance(), &warmth, thinning, per_kelvin.place);
        let slope = row.by_temperature + dot(row.by_place, per_kelvin.place);
        let most = LONGEST_THINNING / thinning.abs();
        let [coldest, hottest] = warming.balance().range();
        let kelvin = (-(surplus + dot(row.by_place, moves.place)) / slope).max(-most).min(most);
        let kelvin = kelvin.max(coldest - temperature).min(hottest - temperature);
        Ok(moves.plus(kelvin, &per_kelvin))
    }

    /// The row of the surplus, as the steps before have shown it or, where that is not to be believed, as it usually
    /// is.
    fn row_at(&self, balance: &ThermalBalance, warmth: &Warmth, thinning: f64, per_kelvin: Vector) -> WarmthRow {
        let Warmth { temperature, flows, .. } = warmth;
        let by_temperature = balance.slope_at_place(*temperature, flows, thinning);
        let square = dot(per_kelvin, per_kelvin);
        let more = balance.slope_under_load(*temperature, flows, thinning) - by_temperature;
        let by_load = if square > 0.0 { more / square } else { 0.0 };
        let usual = WarmthRow { by_place: per_kelvin.map(|x| by_load * x), by_temperature };
        let slope = |row: &WarmthRow| row.by_temperature + dot(row.by_place, per_kelvin);
        let is_believed = |row: &WarmthRow| is_usual(slope(row), slope(&usual));
        let mut record = self.record();
        let row = record.row.filter(is_believed).unwrap_or(usual);
        record.row = Some(row);
        row
    }

    /// Corrects the row of the surplus by what it missed in the step from one trial, which leaves so much of its
    /// balances [1], to another; not by that of a short step in which the cavity moves.
    pub(crate) fn correct_row(&self, (before, left): (&Trial, f64), after: &Trial) {
        if !before.film.solution.wrong.is_empty() && left < MOVING {
            return;
        }
        let (Some(row), Some(from), Some(to)) = (self.record().row, self.warmth(before), self.warmth(after)) else {
            return;
        };
        let (place, kelvin) = (moved(self.place(after), -1.0, self.place(before)), to.temperature - from.temperature);
        let missed = to.surplus - from.surplus - dot(row.by_place, place) - row.by_temperature * kelvin;
        // A film that is half as thick, or oil that is e times as thick, count alike.
        let per_metre = self.least_film(before).powi(-2);
        let per_kelvin = self.options.warming.map_or(0.0, |warming| thinning(warming, from.temperature).powi(2));
        let square = per_metre * dot(place, place) + per_kelvin * kelvin * kelvin;
        if square > 0.0 {
            self.record().row = Some(WarmthRow {
                by_place: moved(row.by_place, missed * per_metre / square, place),
                by_temperature: row.by_temperature + missed * per_kelvin * kelvin / square,
            });
        }
    }

    /// A problem whose film is warmer by some kelvin; one whose temperature is given stays as it is.
    pub(crate) fn warmed(&self, problem: FilmProblem, kelvin: f64) -> FilmProblem {
        match (self.options.warming, problem.lubricant.temperature) {
            (Some(warming), Some(temperature)) if kelvin != 0.0 => {
                FilmProblem { lubricant: warming.lubricant(temperature + kelvin), ..problem }
            }
            _ => problem,
        }
    }

    /// The viscosity law of the oil of a problem which may be only tried.
    pub(crate) fn law_at(&self, problem: &FilmProblem) -> PressureLaw {
        let of_film = self.options.warming.zip(problem.lubricant.temperature);
        of_film.map_or_else(|| self.law.clone(), |(warming, temperature)| warming.lubricant(temperature).pressure_law)
    }

    /// The heat of a balanced film; none where its temperature is given.
    ///
    /// # Errors
    /// The linear systems could not be solved.
    pub(crate) fn found_warmth(&self, trial: &Trial) -> Result<Option<FoundWarmth>, NoFilm> {
        let (Some(warming), Some(Warmth { temperature, flows, .. })) = (self.options.warming, self.warmth(trial))
        else {
            return Ok(None);
        };
        let left = self.left_of_wall(trial);
        let tangents = self.tangents(trial, &trial.film, &left, (FOLLOWED, 0.0))?;
        let Moves { place, wall, .. } = tangents.thicker(self, trial)?.over(1.0 / thinning(warming, temperature));
        let (coordinates, velocity) = (self.coordinates, self.options.centre_velocity);
        Ok(Some(FoundWarmth { temperature, flows, coordinates, velocity, place, wall }))
    }
}

impl Tangents<'_> {
    /// How journal and wall move where the oil of a trial is thicker, for a whole of its viscosity, under the same
    /// load: of a film in cubic elements as the quadratic one does, which is much like it.
    fn thicker(&self, search: &Search, here: &Trial) -> Result<Moves, NoFilm> {
        let joint = match self {
            Self::Rigid(rigid) => {
                let film = &rigid.columns[search.coordinates.order];
                let carried = oil_change(&here.film, &here.film.unknown_in(film));
                let moves = self.solve(search.coordinates.forces(&carried).map(|force| -force), None)?;
                return Ok(moves.with_film(film));
            }
            Self::Yielding(joint) => joint,
            Self::OfCubic(bordered) => bordered.near(),
        };
        Ok(joint.following(FilmChange::Viscosity(1.0)).map_err(NewtonFailure::from)?)
    }
}

/// How the logarithm of the viscosity changes with temperature [1/K].
fn thinning(warming: &dyn Heated, temperature: f64) -> f64 {
    let [low, high] = [-0.5, 0.5].map(|part| warming.lubricant(temperature + part * APART).viscosity.ln());
    (high - low) / APART
}
