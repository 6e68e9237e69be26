//! Solve, estimate, mark, refine: from mesh to mesh until every bar is as small as the scene asks.
//!
//! A smooth film is refined everywhere: a mesh drawn here is drawn anew, as fine as the law of the bar,
//! `bar ~ unknowns^-s`, says that it must be; that of a file is divided. Where the error comes from the edge of a
//! cavity the triangles are divided that carry most of it.
//!
//! Source: Doerfler, SIAM J. Numer. Anal. 33 (1996) 1106; s measured, `docs/theory/error_estimation.md`.

mod distance;
mod growth;
mod level;
mod levels;
mod next;
#[cfg(test)]
mod tests;

use std::sync::Arc;

use crate::analysis::solve;
use crate::compile_error::CompileError;
use crate::estimate::{Estimated, estimate_errors};
use crate::film::Film;
use crate::grading::graded;
use crate::model::Model;
use crate::no_answer::NoAnswer;
use crate::observer::Watch;
use crate::reasons::Limit;
use crate::result::LevelFacts;
use crate::run_options::RunOptions;
use crate::solved::{Errors, SolveOptions, Solved};

pub(crate) use distance::wide_bars;
pub use next::first_film;

/// Heat left over beyond this part of the friction is no balance.
const UNBALANCED: f64 = 1e-6;

/// A model answered.
pub struct Answer {
    /// The film on the last mesh.
    pub film: Film,
    /// The film solved there with its errors, or why there is none.
    pub outcome: Result<(Solved, Estimated), NoAnswer>,
    /// The meshes on the way to a tolerance.
    pub levels: Vec<LevelFacts>,
    /// Why a tolerance is not met or a load not balanced.
    pub limit: Option<Limit>,
}

/// Is told of each mesh but the last: its film with the errors, all meshes so far, and the limit that stands if the run
/// ends there.
pub(crate) type Tell<'a> = &'a dyn Fn((&Solved, Estimated), &[LevelFacts], Option<&Limit>);

/// Answers a model, on meshes as fine as its tolerance asks for if errors are estimated.
///
/// # Errors
/// The model does not become a film.
pub fn answer(model: &Arc<Model>, options: &RunOptions) -> Result<Answer, CompileError> {
    answer_telling(model, options, None)
}

/// Answers a model as [`answer`] does, and tells of each mesh but the last.
pub(crate) fn answer_telling(
    model: &Arc<Model>,
    options: &RunOptions,
    tell: Option<Tell>,
) -> Result<Answer, CompileError> {
    if let Some(targets) = model.targets.as_ref().filter(|_| options.bars) {
        next::check_first(model, options.watch())?;
        return levels::towards(model, targets, options, tell);
    }
    let watch = options.watch();
    let film = graded(model, model.mesh.longest, watch)?;
    let outcome = solved(&film, options.errors(), watch);
    let limit = outcome.as_ref().ok().and_then(|(solved, _)| ended(solved, options));
    Ok(Answer {
        film: outcome.as_ref().map_or(film, |(solved, _)| solved.film.clone()),
        outcome,
        levels: Vec::new(),
        limit,
    })
}

/// Why a position under a load, or a temperature, is only that which the search had reached, if so.
pub fn ended(solved: &Solved, options: &RunOptions) -> Option<Limit> {
    let cause = options.cause();
    let of_temperature = solved.temperature.as_ref().and_then(|found| match found.left_over() {
        left_over if found.is_ended => Some(Limit::Temperature(left_over, cause)),
        left_over if left_over > UNBALANCED => Some(Limit::Jump(left_over)),
        _ => None,
    });
    let of_position = || {
        let balance = solved.balance.filter(|balance| balance.is_ended)?;
        Some(Limit::Position(balance.residual, cause))
    };
    of_temperature.or_else(of_position)
}

fn solved(film: &Film, errors: Errors, watch: Watch) -> Result<(Solved, Estimated), NoAnswer> {
    let options =
        SolveOptions { errors, deadline: watch.deadline, observer: watch.observer, ..SolveOptions::default() };
    let solved = solve(film, &options)?;
    let estimated = estimate_errors(&solved);
    Ok((solved, estimated))
}
