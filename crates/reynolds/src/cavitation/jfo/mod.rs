//! # Mass-conserving cavitation (Jakobsson, Floberg, Olsson)
//!
//! **Equation.** `div( U h theta/2 - h^3/(12 mu) grad p ) + theta dh/dt = 0`, `p >= p_cav`, `theta <= 1`, one of the
//! two an equality: where the film is full oil is driven by pressure, in the cavity it is only carried. A film with a
//! history ([`crate::Storage`]) has `d(theta h)/dt` in place of `theta dh/dt`.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | q (reduced pressure, `q >= q(p_cav)`) | Pa | `p`, `floor` |
//! | theta (film fraction) | - | `theta` |
//!
//! Finite volumes on the linear sub-mesh ([`oilwedge_fem::ControlVolumes`]): one q and one theta a node, each node
//! either full (theta = 1, q unknown) or in the cavity (q = q(p_cav), theta unknown); `blocks` has the balance of one
//! sub-triangle, `rows` the conditions, `active_set` the search for the cavity, `relaxation` what makes it short,
//! `loops` oil that no source sends, `spread` what triangles across the flow do to it. The load is integrated with the
//! quadratic functions of the nodal q, which is several times better than with linear ones.
//!
//! The film is a semismooth equation of its nodes: linear while the cavity stays, and one scheme carries the oil in all
//! of it. The active set is that of Newton's method; a set that comes back is answered by pseudo-time.
//!
//! **Source.** Jakobsson and Floberg, Chalmers Report 190 (1957); Olsson, Chalmers Report 272 (1965); Elrod, J. Lubr.
//! Technol. 103 (1981) 350. **Range.** Steady with rotation, or with a history; incompressible oil; triangles without
//! obtuse angles, with an edge along the flow wherever oil enters in layers. **Verified by** `literature/fowell_2007`,
//! `literature/pfeil_groove`, a structured code in Python, oil balances, and random bearings.

mod active_set;
mod balance;
mod blocks;
mod changes;
mod coarse_comparison;
mod loops;
mod relaxation;
mod rows;
mod sides;
mod spread;
#[cfg(test)]
mod tests;
mod work;

use oilwedge_fem::ControlVolumes;
use oilwedge_fem::complementarity::WarmStart;

use self::active_set::ActiveSetSearch;
use self::balance::CellBalance;
use self::blocks::{Block, blocks};
pub(crate) use self::changes::{PointChanges, residual_changes};
use self::relaxation::{Downstream, NodeStates};
use self::rows::{Condition, NodeConditions};
pub(crate) use self::sides::{FilmSides, film_sides};
pub(crate) use self::spread::spread;
pub(crate) use self::work::{Carriage, oil_carried, work};
use crate::existence::NoFilm;
use crate::film_law::FilmLaw;
use crate::film_start::StepBudget;
use crate::{FilmProblem, FilmSolution, FilmSystem, SolvedFilm, Storage};

/// Film fractions below zero by more than this are no rounding.
const ROUNDING: f64 = 1e-9;
/// What rounding leaves of the difference of what cells hold and have held, in machine epsilons.
const EPSILONS: f64 = 16.0;

/// How full the film is.
#[derive(Debug, Clone, PartialEq)]
pub struct FilmFraction {
    /// Film fraction theta at each dof: one where the film is full.
    pub values: Vec<f64>,
}

/// The discrete film.
struct DiscreteFilm<'a> {
    volumes: &'a ControlVolumes,
    blocks: Vec<Block>,
    rows: NodeConditions,
    downstream: Downstream,
    /// Reduced pressure of the cavity [Pa].
    floor: f64,
    /// Natural size of q [Pa].
    scale: f64,
    /// What q falls below the floor by where cells hold what they held before: rounding of both [Pa].
    rounding: f64,
    /// The time [s] in which the journal moves by a radius, or of the step of a film with a history.
    time: f64,
    /// What a film with a history held before.
    history: Option<History<'a>>,
}

/// What the cells held before, and hold when they are full.
struct History<'a> {
    before: &'a Storage,
    /// Volume of each cell [m3].
    volume: Vec<f64>,
}

/// Solves the film from the cavity of `start`: until it is settled, or with one `step` alone.
pub(crate) fn solve(
    (problem, system, motion): (&FilmProblem, &FilmSystem, f64),
    start: WarmStart,
    steps: StepBudget,
) -> Result<FilmSolution, NoFilm> {
    let clock = std::time::Instant::now();
    let film = DiscreteFilm::new(problem, system, motion)?;
    let mut search = ActiveSetSearch::new(&film, start);
    search.seconds.assemble += clock.elapsed().as_secs_f64();
    let found = match steps {
        StepBudget::UntilSettled => search.run()?,
        StepBudget::One => search.step()?,
    };
    let NodeStates { p, theta, cavity } = found.state;
    let least = (0..theta.len()).min_by(|&a, &b| theta[a].total_cmp(&theta[b]));
    if let Some(least) = least.filter(|&dof| found.wrong.is_empty() && theta[dof] < -ROUNDING) {
        let [x, z] = system.space().positions()[least];
        return Err(NoFilm::FilmFraction {
            fraction: theta[least],
            angle: (x / problem.bearing.radius).rem_euclid(std::f64::consts::TAU),
            z,
            couplings: film.wrong_couplings(),
        });
    }
    Ok(FilmSolution {
        inflow: film.rows.boundary_inflow(&found.residual, &theta),
        unknown: p,
        cavity,
        film_fraction: Some(FilmFraction { values: theta }),
        linearisation: std::sync::Arc::new(found.linearisation),
        gap_tangent: std::sync::OnceLock::new(),
        wrong: found.wrong,
        history: found.history,
        seconds: found.seconds,
        levels: 0,
        fallbacks: found.fallbacks,
    })
}

/// The film of a neighbouring problem after one step with the tangent and the cavity of `film`.
pub(crate) fn chord(
    film: &SolvedFilm,
    fraction: &FilmFraction,
    (problem, system): (&FilmProblem, &FilmSystem),
) -> Result<FilmSolution, NoFilm> {
    let discrete = DiscreteFilm::new(problem, system, 1.0)?;
    let search = ActiveSetSearch::new(&discrete, film.solution.as_start());
    let (NodeStates { p, theta, .. }, left) = search.chord(&fraction.values, &film.solution.linearisation)?;
    let inflow = discrete.rows.boundary_inflow(&left, &theta);
    Ok(film.solution.beside(p, inflow, Some(FilmFraction { values: theta })))
}

/// Checks that oil is supplied to every part of the film.
///
/// # Errors
/// [`NoFilm::NoSupply`]: a place that none reaches; or the sub-mesh does not fit in memory.
pub(crate) fn check_supply(problem: &FilmProblem, system: &FilmSystem) -> Result<(), NoFilm> {
    let volumes = system.volumes().map_err(oilwedge_fem::newton::NewtonFailure::from)?;
    let law = FilmLaw::new(problem, 1.0);
    NodeConditions::new(problem, system, volumes, &law, cavity_floor(problem)).check_supply(problem, system, volumes)
}

/// Reduced pressure [Pa] of the cavity.
fn cavity_floor(problem: &FilmProblem) -> f64 {
    problem.cavitation.pressure().map_or(0.0, |p| problem.unknown_at(p))
}

/// Volume [m3] of the cell of each node of the cavity when it is full; zero of all others.
pub(crate) fn held_volume(film: &SolvedFilm) -> Result<Vec<f64>, oilwedge_fem::Error> {
    let volumes = film.system.volumes()?;
    let blocks = blocks(&FilmLaw::new(&film.problem, 1.0), film.system.space(), volumes);
    let mut held = volumes_of(volumes, &blocks, film.solution.cavity.len());
    let full = held.iter_mut().zip(&film.solution.cavity).filter(|(_, cavity)| !**cavity);
    full.for_each(|(held, _)| *held = 0.0);
    Ok(held)
}

/// Volume [m3] of the cell of each node while it is full.
///
/// # Errors
/// The sub-mesh does not fit in memory.
pub(crate) fn cell_volumes(problem: &FilmProblem, system: &FilmSystem) -> Result<Vec<f64>, oilwedge_fem::Error> {
    let volumes = system.volumes()?;
    let blocks = blocks(&FilmLaw::new(problem, 1.0), system.space(), volumes);
    Ok(volumes_of(volumes, &blocks, system.space().dofs()))
}

fn volumes_of(volumes: &ControlVolumes, blocks: &[Block], nodes: usize) -> Vec<f64> {
    let mut volume = vec![0.0; nodes];
    for (corners, block) in volumes.triangles.iter().zip(blocks) {
        for (&corner, piece) in corners.iter().zip(block.volume) {
            volume[corner as usize] += piece;
        }
    }
    volume
}

impl<'a> DiscreteFilm<'a> {
    fn new(problem: &'a FilmProblem, system: &'a FilmSystem, motion: f64) -> Result<Self, NoFilm> {
        let volumes = system.volumes().map_err(oilwedge_fem::newton::NewtonFailure::from)?;
        let law = FilmLaw::new(problem, motion);
        let floor = cavity_floor(problem);
        let rows = NodeConditions::new(problem, system, volumes, &law, floor);
        let mut blocks = blocks(&law, system.space(), volumes);
        let history = problem.storage.as_deref().map(|before| {
            let volume = volumes_of(volumes, &blocks, system.space().dofs());
            // What squeeze takes up is part of what the history does.
            blocks.iter_mut().for_each(|block| block.storage = [0.0; 3]);
            History { before, volume }
        });
        // What the film held says how much there is now.
        if history.is_none() {
            rows.check_supply(problem, system, volumes)?;
        }
        let (radius, velocity) = (problem.bearing.radius, law.velocity());
        let by_motion = problem.pressure_scale(&system.supply.constraints(|p| problem.unknown_at(p)));
        let by_history = (problem.storage.as_ref()).map_or(0.0, |before| problem.pressure_of(before.per_time));
        Ok(DiscreteFilm {
            volumes,
            blocks,
            rows,
            downstream: Downstream::new(system.space(), velocity, radius * problem.journal.min_film_angle()),
            floor,
            // A journal at rest may have a history alone.
            scale: if by_motion > 0.0 { by_motion } else { by_history },
            rounding: EPSILONS * f64::EPSILON * by_history,
            time: match &history {
                Some(history) => 1.0 / history.before.per_time,
                None => radius / velocity[0].hypot(velocity[1]),
            },
            history,
        })
    }

    /// Couplings of neighbours that are positive: the scheme is monotone without them.
    fn wrong_couplings(&self) -> usize {
        let oilwedge_fem::Matrix { pattern, values: couplings } = CellBalance::of_pressure(self).pressure;
        let wrong = |i: usize| {
            let row = pattern.row(i);
            let largest = couplings[row.clone()].iter().fold(0.0f64, |m, k| m.max(k.abs()));
            row.filter(|&k| pattern.columns[k] as usize > i && couplings[k] > 1e-9 * largest).count()
        };
        (0..pattern.dimension()).map(wrong).sum()
    }

    /// Nodes that may be in the cavity.
    fn may_cavitate(&self, dof: usize) -> bool {
        self.rows.condition[dof] != Condition::Given
    }
}
