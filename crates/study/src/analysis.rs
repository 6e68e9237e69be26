//! What is asked of a film: its solution at a given position, or the position in which it carries a load; and what
//! judges it.

use std::time::Instant;

use oilwedge_bearing::{
    Carrier, Deadline, Equilibrium, GREATEST_ECCENTRICITY, InitialGuess, NoEquilibrium, SearchOptions, find,
};
use oilwedge_reynolds::angles::wrapped;
use oilwedge_reynolds::solve::Neighbour;
use oilwedge_reynolds::{Bearing, FilmSolution, JournalState, NoFilm, ReferenceFilm};

use crate::compile::{CompileError, Study, compile, compile_near};
use crate::result::Status;
use crate::start::middle;
use crate::thermal::{self, HeatFound, NoTemperature};
use crate::words::way_out;
use oilwedge_scene::Scene;

/// A mesh is graded anew where the least film thickness found is another one than it was graded for by this factor,
const REGRADED: f64 = 1.3;
/// or where the thinnest film lies elsewhere by this angle [rad].
const ELSEWHERE: f64 = 0.2;
/// Gradings of one search.
const GRADINGS: usize = 4;

/// A solved film of a study.
#[derive(Debug)]
pub struct Solved {
    /// The film.
    pub film: FilmSolution,
    /// The film by which its errors are estimated; none where they were not asked for, or where there is no such film.
    pub reference: Option<ReferenceFilm>,
    /// How the load is balanced, where the position was sought.
    pub balance: Option<Balance>,
    /// Seconds that the reference film took at the position of the film.
    pub judging: f64,
    /// How the heat is balanced, where the temperature was sought.
    pub heat: Option<HeatFound>,
}

impl Solved {
    /// True where the film is that of a position or temperature reached, not found: the search was ended.
    pub fn is_ended(&self) -> bool {
        let of_heat = self.heat.as_ref().is_some_and(|found| found.is_ended);
        of_heat || self.balance.is_some_and(|balance| balance.is_ended)
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
    /// There is no temperature for the heat.
    Heat(NoTemperature),
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
            Self::Heat(reason) => reason.fmt(out),
        }?;
        way_out(self).map_or(Ok(()), |way_out| write!(out, "; {way_out}"))
    }
}

impl std::error::Error for NoAnswer {}

impl NoAnswer {
    /// True if an answer may exist but was not reached.
    pub fn is_unreached(&self) -> bool {
        let film = match self {
            Self::Film(film) | Self::Equilibrium(NoEquilibrium::Film(film)) => film,
            Self::Heat(reason) => return reason.is_unreached,
            Self::Equilibrium(reason) => {
                return matches!(
                    reason,
                    NoEquilibrium::NotConverged { .. }
                        | NoEquilibrium::BelowRounding { .. }
                        | NoEquilibrium::Ended { .. }
                );
            }
        };
        matches!(
            film,
            NoFilm::NotConverged(_) | NoFilm::NearLimit { .. } | NoFilm::AtFold { .. }
        )
    }

    /// True if the mesh cannot tell on which side of the limit of the viscosity law the film is.
    pub fn is_near_limit(&self) -> bool {
        let (Self::Film(film) | Self::Equilibrium(NoEquilibrium::Film(film))) = self else {
            return false;
        };
        matches!(film, NoFilm::NearLimit { .. } | NoFilm::AtFold { .. })
    }

    /// What is said of a run that ends so.
    pub fn status(&self) -> Status {
        match self.is_unreached() {
            true => Status::NotConverged,
            false => Status::NoSolution,
        }
    }
}

/// Solves a study, with a reference film if errors are asked for (`bars`). Under a load the journal of its problem is where it was
/// found then, or where the search was when `deadline` was at its end.
///
/// # Errors
/// [`NoAnswer`]: the reason why there is no film or no position.
pub fn solve(study: &mut Study, bars: bool, deadline: Deadline) -> Result<Solved, NoAnswer> {
    solve_from(study, bars, deadline, InitialGuess::Cold)
}

/// The same from a given start.
///
/// # Errors
/// As [`solve`]; from near another operating point also where a solve that begins as the scene says finds an answer.
pub fn solve_from(study: &mut Study, bars: bool, deadline: Deadline, start: InitialGuess) -> Result<Solved, NoAnswer> {
    match study.heat {
        Some(heat) => thermal::solve(study, &heat, bars, deadline, start),
        None => isothermal(study, bars, deadline, start),
    }
}

/// The same with the oil of the study as it is.
///
/// # Errors
/// As [`solve_from`].
pub fn isothermal(study: &mut Study, bars: bool, deadline: Deadline, start: InitialGuess) -> Result<Solved, NoAnswer> {
    let clock = Instant::now();
    let Some(load) = study.load else {
        let film = match start {
            InitialGuess::Near(near @ (Neighbour::Start(_) | Neighbour::Kept(_))) => {
                study.problem.solve_from(&study.system, near)?
            }
            InitialGuess::Cold | InitialGuess::Near(Neighbour::None) => study.problem.solve(&study.system)?,
        };
        let clock = Instant::now();
        let reference = match bars {
            true => study.problem.reference_film(&study.system, &film)?,
            false => None,
        };
        return Ok(Solved {
            film,
            reference,
            balance: None,
            judging: clock.elapsed().as_secs_f64(),
            heat: None,
        });
    };
    let options = SearchOptions {
        centre_velocity: study.centre_velocity,
        deadline,
        guess: start,
        carrier: match bars && study.problem.cavitation.is_symmetric() {
            true => Carrier::Cubic,
            false => Carrier::Quadratic,
        },
        accuracy: None,
    };
    let found = find(&study.problem, &study.system, load, &options)?;
    let seconds = clock.elapsed().as_secs_f64();
    let Equilibrium {
        problem, film, cubic, ..
    } = found;
    study.problem = problem;
    let parts = film.seconds;
    let clock = Instant::now();
    let reference = match cubic {
        Some(cubic) => Some(ReferenceFilm::Cubic(cubic)),
        None if bars => study.problem.reference_film(&study.system, &film)?,
        None => None,
    };
    Ok(Solved {
        film,
        reference,
        balance: Some(Balance {
            unbalanced: found.unbalanced,
            residual: found.residual,
            stiffness: found.stiffness,
            steps: found.steps,
            is_ended: found.is_ended,
            seconds: seconds - parts.assemble - parts.factorise - parts.solve,
        }),
        judging: clock.elapsed().as_secs_f64(),
        heat: None,
    })
}

/// Compiles a scene; under a load a mesh that is made here is graded for the position that the load leads to, as far as `deadline`
/// reaches.
///
/// # Errors
/// The scene does not become a film.
pub fn graded(scene: &Scene, deadline: Deadline) -> Result<Study, CompileError> {
    let mut study = compile(scene)?;
    let Some(load) = study.load.filter(|_| scene.mesh.is_graded()) else {
        return Ok(study);
    };
    let options = SearchOptions {
        centre_velocity: study.centre_velocity,
        deadline,
        ..SearchOptions::default()
    };
    let mut middle = Some(middle(&scene.journal));
    for _ in 1..GRADINGS {
        if deadline.is_over() {
            break;
        }
        // A coarser mesh is good enough to grade a mesh for, if it leads to a position. A load may be out of reach only
        // because the mesh is too coarse there.
        let on_coarser = (study.system.coarser.as_ref())
            .and_then(|coarser| find(&coarser.problem(&study.problem), &coarser.system, load, &options).ok());
        let found = match on_coarser.map_or_else(|| find(&study.problem, &study.system, load, &options), Ok) {
            Ok(Equilibrium { problem, .. }) => Some(problem.journal),
            Err(NoEquilibrium::BeyondCapacity { .. } | NoEquilibrium::BelowRounding { .. }) => break,
            // Feeds may carry what the estimate would have a thin film carry.
            Err(_) if middle.is_some() => {
                study = compile_near(scene, middle.take().unwrap_or_default())?;
                continue;
            }
            Err(reason) => reason.last_position(),
        };
        let clearance = scene.bearing.clearance;
        let Some(found) = found.filter(|found| found.eccentricity() <= GREATEST_ECCENTRICITY * clearance) else {
            break;
        };
        if is_near(&study.problem.bearing, &study.problem.journal, &found) {
            break;
        }
        study = compile_near(scene, (found.eccentricity() / clearance, found.min_film_angle()))?;
    }
    Ok(study)
}

/// Whether a mesh graded for one position suits another.
pub fn is_near(bearing: &Bearing, graded_for: &JournalState, found: &JournalState) -> bool {
    let ratio = bearing.least_gap(graded_for) / bearing.least_gap(found);
    let turn = wrapped(graded_for.min_film_angle() - found.min_film_angle()).abs();
    ratio < REGRADED && ratio > 1.0 / REGRADED && turn < ELSEWHERE
}
