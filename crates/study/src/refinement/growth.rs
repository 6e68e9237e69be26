//! How much finer the next mesh must be, and may be.

use oilwedge_reynolds::FilmProblem;

use super::level::SolvedLevel;
use crate::result::{LevelFacts, Refinement};

/// Part of the bars asked for that a mesh is drawn for.
const SAFETY: f64 = 0.7;
/// Least growth of the number of unknowns from one mesh to the next.
const LEAST_GROWTH: f64 = 1.4;
/// A mesh that was drawn finer and has not this many times the unknowns is bound by its features.
const BOUND: f64 = 1.25;
/// A mesh that leaves this part of a bar did not serve it.
const STUCK: f64 = 0.8;
/// Growth where no bar can be trusted yet, and at least where the last mesh did not serve.
const UNRESOLVED_GROWTH: f64 = 3.0;
/// Seconds of a level grow like this power of the unknowns at most.
const TIME_EXPONENT: f64 = 1.2;

/// What the next mesh is for, and how large it may be.
#[derive(Debug, Clone, Copy)]
pub(super) struct Goal {
    /// The greatest bar over what it may be.
    pub(super) worst: f64,
    /// Most unknowns.
    pub(super) most_unknowns: usize,
    /// Most unknowns over those of the last mesh.
    pub(super) most_growth: f64,
}

/// The growth of the next mesh, and how it may be made.
#[derive(Debug, Clone, Copy)]
pub(super) struct Growth {
    /// Unknowns over those of the last mesh.
    pub(super) factor: f64,
    /// True if drawing the mesh finer made it hardly larger: its sizes are those of holes and grooves.
    pub(super) is_bound: bool,
    /// True if local division does not help.
    pub(super) is_stuck: bool,
}

impl Growth {
    /// The growth towards a goal, or less where that would be too long for the time left [s] or too large: a smaller
    /// step is better than none. The last mesh would take so many `seconds` [s] again.
    pub(super) fn of(level: &SolvedLevel, goal: &Goal, levels: &[LevelFacts], [left, seconds]: [f64; 2]) -> Self {
        let FilmProblem { cavitation, lubricant, .. } = &level.solved.film.problem;
        let order = cavitation.bar_order(&lubricant.pressure_law);
        let (least, most) = (LEAST_GROWTH, goal.most_growth);
        let has_served = left_of_bar(levels, &level.worst_name).is_none_or(|part| part < STUCK);
        let serving = if has_served { least } else { UNRESOLVED_GROWTH };
        let wanted = match goal.worst.is_finite() {
            true => (goal.worst / SAFETY).powf(1.0 / order).clamp(serving.min(most), most),
            false => UNRESOLVED_GROWTH.min(most),
        };
        let fits = levels.last().map_or(f64::INFINITY, |last| {
            let in_time = (left / seconds).max(0.0).powf(1.0 / TIME_EXPONENT);
            let in_size = goal.most_unknowns as f64 / last.unknowns as f64;
            (SAFETY * in_time).min(in_size)
        });
        Self {
            factor: if fits >= least { wanted.min(fits) } else { wanted },
            is_bound: matches!(levels, [.., before, last] if (last.unknowns as f64) < BOUND * before.unknowns as f64),
            is_stuck: !has_served && levels.last().is_some_and(|last| last.refinement == Refinement::Local),
        }
    }
}

/// Seconds [s] that a mesh takes with so many times the unknowns of one that takes so many `seconds` [s].
pub(super) fn next_seconds(seconds: f64, growth: f64) -> f64 {
    seconds * growth.powf(TIME_EXPONENT)
}

/// Part of the bar of this name that the last mesh left; none where it is the first.
fn left_of_bar(levels: &[LevelFacts], name: &str) -> Option<f64> {
    let error = |level: &LevelFacts| Some(level.errors.iter().find(|(other, _)| other == name)?.1);
    let [.., before, last] = levels else { return None };
    Some(error(last)? / error(before)?)
}
