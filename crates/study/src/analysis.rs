//! The analysis of a film: its solution at a given position, or at the position in which it carries a load; with the reference film by which
//! errors are estimated.

use std::time::Instant;

use oilwedge_bearing::{
    Carrier, Deadline, Equilibrium, GREATEST_ECCENTRICITY, InitialGuess, NoEquilibrium, SearchOptions, find,
};
use oilwedge_reynolds::angles::wrapped;
use oilwedge_reynolds::solve::Neighbour;
use oilwedge_reynolds::{Bearing, FilmSolution, JournalState, NoFilm, ReferenceFilm};
use oilwedge_scene::Scene;

use crate::compile::{CompileError, compile, compile_near};
use crate::film::Film;
use crate::position::Position;
use crate::reasons::way_out;
use crate::result::Status;
use crate::thermal::{self, NoTemperature, TemperatureFound};

/// A mesh is graded anew where the least film thickness found differs by this factor from that which it was graded for,
const REGRADED: f64 = 1.3;
/// or where the thinnest film lies elsewhere by this angle [rad].
const ELSEWHERE: f64 = 0.2;
/// Gradings of one search.
const GRADINGS: usize = 4;

/// How a film is solved; by default without an error estimate, from a cold start, without a deadline.
#[derive(Debug, Clone, Copy, Default)]
pub struct SolveOptions<'a> {
    /// Whether errors are to be estimated.
    pub errors: Errors,
    /// When searches must end.
    pub deadline: Deadline,
    /// Where a search begins.
    pub guess: InitialGuess<'a>,
}

/// Whether errors are to be estimated.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Errors {
    /// No reference film is solved.
    #[default]
    Omitted,
    /// A reference film is solved.
    Estimated,
}

/// A solved film.
#[derive(Debug)]
pub struct Solved {
    /// The film, at the position and temperature found.
    pub film: Film,
    /// Its solution.
    pub solution: FilmSolution,
    /// The film by which errors are estimated; none where they are omitted, or where there is no such film.
    pub reference: Option<ReferenceFilm>,
    /// How the load is balanced, where the position was sought.
    pub balance: Option<Balance>,
    /// How the temperature was found, where it was sought.
    pub temperature: Option<TemperatureFound>,
    /// Seconds that the reference film took at the position of the film.
    pub reference_seconds: f64,
}

impl Solved {
    /// True where the film is that of a position or temperature reached, not found: the search was ended.
    pub fn is_ended(&self) -> bool {
        let of_temperature = self.temperature.as_ref().is_some_and(|found| found.is_ended);
        of_temperature || self.balance.is_some_and(|balance| balance.is_ended)
    }
}

/// How well a load is balanced, and what it took.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Balance {
    /// Load less force of the film [N].
    pub unbalanced: f64,
    /// Load less force of the film, relative to the load.
    pub residual: f64,
    /// `dW/de` [N/m] of the film, row: component of W.
    pub stiffness: [[f64; 2]; 2],
    /// Positions tried on the mesh of the result.
    pub steps: usize,
    /// True where the search was ended before the load was balanced.
    pub is_ended: bool,
    /// Seconds that the search took, but for the film of the result.
    pub seconds: f64,
}

/// Why there is nothing to report.
#[derive(Debug)]
pub enum NoAnswer {
    /// There is no film at the given position.
    Film(NoFilm),
    /// There is no position for the load.
    Equilibrium(NoEquilibrium),
    /// There is no temperature at which the balance closes.
    Temperature(NoTemperature),
}

impl From<NoFilm> for NoAnswer {
    fn from(reason: NoFilm) -> Self {
        Self::Film(reason)
    }
}

impl From<NoEquilibrium> for NoAnswer {
    fn from(reason: NoEquilibrium) -> Self {
        Self::Equilibrium(reason)
    }
}

impl std::fmt::Display for NoAnswer {
    /// The reason, and what can be done about it.
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Film(reason) => reason.fmt(out),
            Self::Equilibrium(reason) => reason.fmt(out),
            Self::Temperature(reason) => reason.fmt(out),
        }?;
        way_out(self).map_or(Ok(()), |way_out| write!(out, "; {way_out}"))
    }
}

impl std::error::Error for NoAnswer {}

impl NoAnswer {
    /// True if an answer may exist but was not reached.
    pub fn is_unreached(&self) -> bool {
        match self {
            Self::Film(film) | Self::Equilibrium(NoEquilibrium::Film(film)) => matches!(
                film,
                NoFilm::NotConverged(_) | NoFilm::NearLimit { .. } | NoFilm::AtFold { .. }
            ),
            Self::Equilibrium(reason) => matches!(
                reason,
                NoEquilibrium::NotConverged { .. } | NoEquilibrium::BelowRounding { .. } | NoEquilibrium::Ended { .. }
            ),
            Self::Temperature(reason) => reason.is_unreached,
        }
    }

    /// True if the mesh cannot tell on which side of the limit of the viscosity law the film is.
    pub fn is_near_limit(&self) -> bool {
        let (Self::Film(film) | Self::Equilibrium(NoEquilibrium::Film(film))) = self else {
            return false;
        };
        matches!(film, NoFilm::NearLimit { .. } | NoFilm::AtFold { .. })
    }

    /// The status of a run that ends so.
    pub fn status(&self) -> Status {
        match self.is_unreached() {
            true => Status::NotConverged,
            false => Status::NoSolution,
        }
    }
}

/// Solves a film; under a load at the position found, or reached when the deadline came; with a heat balance at the temperature found.
///
/// # Errors
/// [`NoAnswer`]: the reason why there is no film or no position; from near another operating point also where a cold start finds an answer.
pub fn solve(film: &Film, options: &SolveOptions) -> Result<Solved, NoAnswer> {
    match film.scene.heat {
        Some(heat) => thermal::solve(film, &heat, options),
        None => isothermal(film, options),
    }
}

/// Solves a film at the temperature that it has.
///
/// # Errors
/// As [`solve`].
pub fn isothermal(film: &Film, options: &SolveOptions) -> Result<Solved, NoAnswer> {
    match film.load {
        None => at_given_position(film, options),
        Some(load) => under_load(film, load, options),
    }
}

fn at_given_position(film: &Film, options: &SolveOptions) -> Result<Solved, NoAnswer> {
    let solution = match options.guess {
        InitialGuess::Near(near @ (Neighbour::Start(_) | Neighbour::Kept(_))) => {
            film.problem.solve_from(&film.system, near)?
        }
        InitialGuess::Cold | InitialGuess::Near(Neighbour::None) => film.problem.solve(&film.system)?,
    };
    with_reference(film.clone(), solution, options.errors)
}

fn under_load(film: &Film, load: [f64; 2], options: &SolveOptions) -> Result<Solved, NoAnswer> {
    let clock = Instant::now();
    let by_cubic = options.errors == Errors::Estimated && film.problem.cavitation.is_symmetric();
    let search = SearchOptions {
        carrier: if by_cubic { Carrier::Cubic } else { Carrier::Quadratic },
        guess: options.guess,
        ..search_options(film, options.deadline)
    };
    let found = find(&film.problem, &film.system, load, &search)?;
    let (parts, seconds) = (found.film.seconds, clock.elapsed().as_secs_f64());
    let balance = Balance {
        unbalanced: found.unbalanced,
        residual: found.residual,
        stiffness: found.stiffness,
        steps: found.steps,
        is_ended: found.is_ended,
        seconds: seconds - parts.assemble - parts.factorise - parts.solve,
    };
    let film = film.with_journal(found.problem.journal);
    let solved = match found.cubic {
        None => with_reference(film, found.film, options.errors)?,
        cubic => Solved {
            reference: cubic.map(ReferenceFilm::Cubic),
            ..with_reference(film, found.film, Errors::Omitted)?
        },
    };
    Ok(Solved {
        balance: Some(balance),
        ..solved
    })
}

/// A solved film at a given position and temperature, with its reference film if errors are estimated.
fn with_reference(film: Film, solution: FilmSolution, errors: Errors) -> Result<Solved, NoAnswer> {
    let clock = Instant::now();
    let reference = match errors {
        Errors::Estimated => film.problem.reference_film(&film.system, &solution)?,
        Errors::Omitted => None,
    };
    Ok(Solved {
        film,
        solution,
        reference,
        balance: None,
        temperature: None,
        reference_seconds: clock.elapsed().as_secs_f64(),
    })
}

fn search_options<'a>(film: &Film, deadline: Deadline) -> SearchOptions<'a> {
    SearchOptions {
        centre_velocity: film.centre_velocity,
        deadline,
        ..SearchOptions::default()
    }
}

/// Compiles a scene; under a load a mesh that is made here is graded for the position that the load leads to, as far as the deadline
/// allows.
///
/// # Errors
/// The scene does not become a film.
pub fn graded(scene: &Scene, deadline: Deadline) -> Result<Film, CompileError> {
    let mut film = compile(scene)?;
    let Some(load) = film.load.filter(|_| scene.mesh.is_graded()) else {
        return Ok(film);
    };
    let mut middle = Some(Position::middle(scene));
    for _ in 1..GRADINGS {
        if deadline.is_over() {
            break;
        }
        let Some(position) = position_to_grade_for(&film, load, deadline, &mut middle) else {
            break;
        };
        film = compile_near(scene, position)?;
    }
    Ok(film)
}

/// The position that the mesh should be graded for; `None` where it suits, or where none is known. `middle` is tried once.
fn position_to_grade_for(
    film: &Film,
    load: [f64; 2],
    deadline: Deadline,
    middle: &mut Option<Position>,
) -> Option<Position> {
    let journal = match rough_balance(film, load, deadline) {
        Ok(Equilibrium { problem, .. }) => problem.journal,
        Err(NoEquilibrium::BeyondCapacity { .. } | NoEquilibrium::BelowRounding { .. }) => return None,
        // Feeds may carry what the estimate would have a thin film carry.
        Err(reason) => match middle.take() {
            None => reason.last_position()?,
            position => return position,
        },
    };
    let bearing = &film.problem.bearing;
    let is_possible = journal.eccentricity() <= GREATEST_ECCENTRICITY * bearing.clearance;
    (is_possible && !is_near(bearing, &film.problem.journal, &journal))
        .then(|| Position::of(&journal, bearing.clearance))
}

/// The balance on a coarser mesh, which is good enough to grade a mesh for, if it leads to a position. A load may be out of reach only because the
/// mesh is too coarse there.
fn rough_balance(film: &Film, load: [f64; 2], deadline: Deadline) -> Result<Equilibrium, NoEquilibrium> {
    let options = search_options(film, deadline);
    let on_coarser = (film.system.coarser.as_ref())
        .and_then(|coarser| find(&coarser.problem(&film.problem), &coarser.system, load, &options).ok());
    on_coarser.map_or_else(|| find(&film.problem, &film.system, load, &options), Ok)
}

/// Whether a mesh graded for one position suits another.
pub fn is_near(bearing: &Bearing, graded_for: &JournalState, found: &JournalState) -> bool {
    let ratio = bearing.least_gap(graded_for) / bearing.least_gap(found);
    let turn = wrapped(graded_for.min_film_angle() - found.min_film_angle()).abs();
    ratio < REGRADED && ratio > 1.0 / REGRADED && turn < ELSEWHERE
}
