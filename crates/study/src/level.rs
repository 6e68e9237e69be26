//! One level: a model solved on one mesh with elements of one degree, and what that gives.

use std::sync::Arc;
use std::time::Instant;

use oilwedge_bearing::Deadline;
use oilwedge_mesh::Mesh;

use crate::analysis::solve;
use crate::compile_error::CompileError;
use crate::estimate::estimate_errors;
use crate::film::DEGREE;
use crate::film::Film;
use crate::model::Model;
use crate::no_answer::NoAnswer;
use crate::position::Position;
use crate::quantities::Quantity;
use crate::solved::{Errors, SolveOptions, Solved};

/// What one mesh gives.
pub struct Level {
    /// The film; under a load the journal of its problem is where it was found.
    pub film: Film,
    /// Nodes whose pressure is not given.
    pub unknowns: usize,
    /// The quantities of the report, with their error where it was estimated.
    pub quantities: Vec<Quantity>,
    /// Share of each triangle in the error of the goal, in the goal's unit; `None` where it was not estimated.
    pub indicator: Option<Vec<f64>>,
    /// True where the search for a position was ended before its load was balanced.
    pub is_ended: bool,
    /// Where the time went [s], in the order of the run, without the making of the mesh.
    pub seconds: Vec<(&'static str, f64)>,
}

/// Why a mesh gives nothing.
#[derive(Debug, thiserror::Error)]
pub enum LevelError {
    /// The scene does not become a film on this mesh.
    #[error(transparent)]
    Compile(#[from] CompileError),
    /// The scene asks for something that has no answer.
    #[error(transparent)]
    NoAnswer(#[from] NoAnswer),
}

/// Solves `model` on `mesh` with elements of the given degree, the journal at `position` or, under a load, sought from
/// there. Errors are estimated where they can be, on quadratic elements.
///
/// # Errors
/// [`LevelError`]: the scene does not become a film on this mesh, or there is no film or position.
pub fn solve_level(
    model: &Arc<Model>,
    mesh: Mesh,
    position: Position,
    degree: usize,
    deadline: Deadline,
) -> Result<Level, LevelError> {
    let clock = Instant::now();
    let film = model.film_on(mesh, &model.state_at(position), degree)?;
    let order = clock.elapsed().as_secs_f64();
    let options = SolveOptions {
        errors: if degree == DEGREE { Errors::Estimated } else { Errors::Omitted },
        deadline,
        ..SolveOptions::default()
    };
    let solved = solve(&film, &options)?;
    let clock = Instant::now();
    let estimated = estimate_errors(&solved);
    let (measuring, parts) = (clock.elapsed().as_secs_f64(), solved.primary.solution.seconds);
    let [bars, measure] = match options.errors {
        Errors::Estimated => [measuring, 0.0],
        Errors::Omitted => [0.0, measuring],
    };
    let per_newton = per_newton(&solved);
    let in_goal = |shares: Vec<f64>| shares.iter().map(|share| per_newton * share).collect();
    Ok(Level {
        unknowns: film.unknowns(),
        is_ended: solved.is_ended(),
        quantities: estimated.quantities,
        indicator: estimated.indicator.map(in_goal),
        seconds: vec![
            ("order", order),
            ("search", solved.balance.map_or(0.0, |balance| balance.seconds)),
            ("assemble", parts.assemble),
            ("factorise", parts.factorise),
            ("solve", parts.solve),
            ("bars", solved.reference_seconds + bars),
            ("measure", measure),
        ],
        film: solved.film,
    })
}

/// What the goal is off by for each newton that the force of the film is off by: one newton of the load, or under a
/// load the eccentricity `|K^-T n|/c` [1/N], K the stiffness of the film and n the direction of the line of centres.
/// The newton counts in its worst direction.
fn per_newton(solved: &Solved) -> f64 {
    let Some(balance) = &solved.balance else { return 1.0 };
    let problem = &solved.film.problem;
    let [x, y] = problem.journal.offset;
    let eccentricity = problem.journal.eccentricity();
    let along = |force: [f64; 2]| {
        let [by_x, by_y, ..] = balance.stiffness.solve([-force[0], -force[1], 0.0, 0.0]);
        (by_x * x + by_y * y) / (eccentricity * problem.bearing.clearance)
    };
    along([1.0, 0.0]).hypot(along([0.0, 1.0]))
}
