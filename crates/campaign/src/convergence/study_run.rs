//! The run of one strategy from level to level.

use std::sync::Arc;
use std::time::Instant;

use oilwedge_bearing::Deadline;
use oilwedge_fem::marking::doerfler;
use oilwedge_mesh::{Mesh, refine};

use super::budget::Budget;
use super::cost_model::exponent;
use super::first_mesh::First;
use super::observer::Observer;
use super::report::{LevelReport, Timing};
use super::strategy::Strategy;
use oilwedge_study::compile_error::CompileError;
use oilwedge_study::effects::Effects;
use oilwedge_study::level::{Level, LevelError, solve_level};
use oilwedge_study::model::Model;
use oilwedge_study::no_answer::NoAnswer;
use oilwedge_study::position::Position;
use oilwedge_study::quantities::Quantity;

/// Share of the indicator that the triangles divided carry.
const SHARE: f64 = 0.7;
/// A marked triangle becomes four, and takes about this many others with it that become two.
const TAKEN_ALONG: f64 = 1.5;
/// Meshes without an answer that are refined further.
const MOST_FAILURES: usize = 3;
/// Most triangles of a level: its factorised matrix has some gigabytes.
const MOST_CELLS: f64 = 1e6;
/// Most triangles of a mesh that is kept to be drawn.
const DRAWN: usize = 5000;

/// Seconds of the parts of a run.
type PartSeconds = Vec<(&'static str, f64)>;

/// A mesh and the share of each triangle in the error.
#[derive(Debug, Clone)]
pub struct MarkedMesh {
    /// Level that the mesh belongs to.
    pub level: usize,
    /// The mesh.
    pub mesh: Arc<Mesh>,
    /// Radius of the liner [m].
    pub radius: f64,
    /// Share of each triangle in the error of the goal, signed; `None` where it was not estimated.
    pub indicator: Option<Vec<f64>>,
}

/// The levels of one strategy so far, and what its next level needs.
pub(super) struct StudyRun<'a> {
    pub(super) model: &'a Arc<Model>,
    position: Position,
    goal: &'static str,
    pub(super) strategy: Strategy,
    /// The mesh of the last level; before the first, its own.
    mesh: Arc<Mesh>,
    /// Triangles to divide for the next level; `None`: none, the mesh is that of the first level.
    marked: Option<Vec<bool>>,
    /// Seconds [s] that all meshes so far took.
    making: f64,
    /// Seconds [s] of the levels so far, where the next one needs them.
    earlier: f64,
    /// Triangles of the levels tried and their seconds [s].
    tried: Vec<(f64, f64)>,
    /// Seconds [s] that the first level takes at most, where another strategy has timed one.
    first: Option<f64>,
    failures: usize,
    pub(super) levels: Vec<LevelReport>,
    /// Why there are no more levels.
    pub(super) ended: Option<String>,
    /// Why the last mesh has no answer.
    pub(super) failure: Option<NoAnswer>,
    pub(super) effects: Option<Effects>,
    /// The quantity of the goal on the last level.
    pub(super) quantity: Option<Quantity>,
    /// The finest mesh that can be drawn.
    pub(super) drawn: Option<MarkedMesh>,
}

impl<'a> StudyRun<'a> {
    pub(super) fn new(model: &'a Arc<Model>, first: &First, strategy: Strategy, goal: &'static str) -> Self {
        Self {
            model,
            position: first.position,
            goal,
            strategy,
            mesh: first.mesh.clone(),
            marked: None,
            making: first.seconds,
            earlier: 0.0,
            tried: Vec::new(),
            first: None,
            failures: 0,
            levels: Vec::new(),
            ended: None,
            failure: None,
            effects: None,
            quantity: None,
            drawn: None,
        }
    }

    /// A run of another strategy that continues from the levels of this one.
    pub(super) fn turned(&self, strategy: Strategy) -> Self {
        let indicator = self.drawn.as_ref().and_then(|drawn| drawn.indicator.as_deref());
        let last = self.levels.last();
        Self {
            strategy,
            mesh: self.mesh.clone(),
            marked: Some(chosen(strategy, indicator, self.mesh.triangles().len())),
            earlier: last.map_or(0.0, |level| level.seconds.total - self.making),
            tried: self.tried.clone(),
            levels: self.levels.clone(),
            ended: self.ended.clone(),
            failure: None,
            effects: self.effects.clone(),
            quantity: self.quantity.clone(),
            drawn: self.drawn.clone(),
            ..*self
        }
    }

    /// The first level takes no longer than that of `other`.
    pub(super) fn no_longer_than(mut self, other: &Self) -> Self {
        self.first = other.tried.first().map(|(_, seconds)| *seconds);
        self
    }

    /// Triangles of the next level, roughly.
    fn cells(&self) -> f64 {
        let cells = self.mesh.triangles().len() as f64;
        let divided = self.marked.as_ref().map_or(0, |marked| marked.iter().filter(|marked| **marked).count());
        f64::min(cells + (3.0 + TAKEN_ALONG) * divided as f64, 4.0 * cells).max(cells)
    }

    /// Seconds [s] of the next level; `None` where no level has been timed.
    fn expected(&self) -> Option<f64> {
        let Some(&(cells, seconds)) = self.tried.last() else {
            return self.first;
        };
        let last = &self.tried[self.tried.len().saturating_sub(2)..];
        let points: Vec<_> = last.iter().map(|(cells, seconds)| (cells.ln(), seconds.ln())).collect();
        Some(seconds * (self.cells() / cells).powf(exponent(&points)))
    }

    /// Seconds [s] that the next level is expected to take; zero where that is not known.
    pub(super) fn urgency(&self) -> f64 {
        self.expected().unwrap_or(0.0)
    }

    /// Tries one more level if there is time for it, else ends.
    ///
    /// # Errors
    /// The first mesh does not suit the scene.
    pub(super) fn step(&mut self, budget: &Budget, observer: &mut dyn Observer) -> Result<(), CompileError> {
        let number = self.tried.len() + 1;
        let (cells, expected) = (self.cells(), self.expected());
        // The first level of quadratic elements is run in any case: a study without levels has no result.
        let must = number == 1 && self.strategy == Strategy::P2Uniform;
        self.ended = match must {
            true => None,
            false => self.limit(number, budget),
        };
        if self.ended.is_some() {
            return Ok(());
        }
        observer.begins(self.strategy, number, cells as usize, expected);
        let clock = Instant::now();
        if let Err(reason) = self.refine(number) {
            self.ended = Some(reason);
            return Ok(());
        }
        let refining = clock.elapsed().as_secs_f64();
        self.making += refining;
        let triangles = self.mesh.triangles().len();
        match self.solve(budget, budget.deadline(must)) {
            Ok((level, _)) if level.is_ended => {
                self.ended = Some(match budget.is_interrupted() {
                    true => format!("interrupted: level {number} was not finished"),
                    false => format!("limit: level {number} was not finished in {} s", budget.max_seconds()),
                });
            }
            Ok((level, timing)) => {
                let slowest = timing.greatest - self.making - self.earlier;
                self.tried.push((triangles as f64, refining + slowest));
                let report = self.take(number, level, timing);
                observer.ended(self.strategy, &report);
                self.levels.push(report);
            }
            Err(LevelError::Compile(error)) if number > 1 => self.ended = Some(error.to_string()),
            Err(LevelError::Compile(error)) => return Err(error),
            Err(LevelError::NoAnswer(reason)) => {
                self.tried.push((triangles as f64, clock.elapsed().as_secs_f64()));
                self.failures += 1;
                self.marked = Some(vec![true; triangles]);
                if self.failures >= MOST_FAILURES {
                    self.ended = Some(format!("level {number} has no answer: {reason}"));
                }
                self.failure = Some(reason);
            }
        }
        Ok(())
    }

    /// Why level `number` is not begun, where a limit forbids it.
    fn limit(&self, number: usize, budget: &Budget) -> Option<String> {
        if !budget.fits(self.urgency()) {
            let left = match budget.is_interrupted() {
                true => "the study was interrupted".to_owned(),
                false => format!("{:.1} s of {} s were left", budget.left(), budget.max_seconds()),
            };
            return Some(match self.expected() {
                Some(expected) => format!("level {number} would take some {expected:.1} s, {left}"),
                None => format!("level {number} was not begun, {left}"),
            });
        }
        let is_large = number > 1 && self.cells() > MOST_CELLS;
        is_large.then(|| format!("level {number} would have more than {MOST_CELLS:.0} triangles"))
    }

    /// Divides the marked triangles; the reason where the mesh would fold.
    fn refine(&mut self, number: usize) -> Result<(), String> {
        let Some(marked) = self.marked.take() else {
            return Ok(());
        };
        let refined = refine::local(&self.mesh, &marked).map_err(|defects| {
            let first = defects.first().map_or(String::new(), ToString::to_string);
            format!("the mesh of level {number} folds: {first}")
        })?;
        self.mesh = Arc::new(refined.mesh);
        Ok(())
    }

    /// Solves on the mesh, again for the timing where that is cheap.
    fn solve(&self, budget: &Budget, deadline: Deadline) -> Result<(Level, Timing), LevelError> {
        let (mut level, wall, run) = self.run(deadline)?;
        let (mut walls, mut parts) = (vec![wall], vec![run]);
        while budget.repeats(&walls) {
            // Memory for one level at a time.
            drop(level);
            let (again, wall, run) = self.run(deadline)?;
            level = again;
            walls.push(wall);
            parts.push(run);
        }
        let before = self.making + self.earlier;
        let mut timing = Timing {
            total: before + median(walls.clone()),
            least: before + walls.iter().copied().fold(f64::INFINITY, f64::min),
            greatest: before + walls.iter().copied().fold(0.0, f64::max),
            runs: walls.len(),
            parts: vec![("mesh".to_owned(), self.making), ("earlier".to_owned(), self.earlier)],
        };
        let names: Vec<&str> = parts[0].iter().map(|(name, _)| *name).collect();
        for (place, name) in names.into_iter().enumerate() {
            let runs = parts.iter().filter_map(|run| run.get(place)).map(|(_, seconds)| *seconds);
            timing.parts.push((name.to_owned(), median(runs.collect())));
        }
        Ok((level, timing))
    }

    /// Solves on the mesh once: the level, its seconds [s], and these in parts.
    fn run(&self, deadline: Deadline) -> Result<(Level, f64, PartSeconds), LevelError> {
        let mesh = Mesh::clone(&self.mesh);
        let degree = self.strategy.degree();
        let clock = Instant::now();
        let level = solve_level(self.model, mesh, self.position, degree, deadline)?;
        let wall = clock.elapsed().as_secs_f64();
        let mut parts = level.seconds.clone();
        let known: f64 = parts.iter().map(|(_, seconds)| seconds).sum();
        parts.push(("other", f64::max(wall - known, 0.0)));
        Ok((level, wall, parts))
    }

    /// Reports a level, and keeps what the next one needs.
    fn take(&mut self, number: usize, level: Level, timing: Timing) -> LevelReport {
        let mesh = level.film.system.space().mesh().clone();
        let cells = mesh.triangles().len();
        let goal = level.quantities.iter().find(|quantity| quantity.name == self.goal);
        let value = goal.map_or(f64::NAN, |goal| goal.value);
        let report = LevelReport {
            level: number,
            cells,
            unknowns: level.unknowns,
            value,
            relative_bar: goal.and_then(Quantity::error).map(|bar| bar / value.abs()),
            relative_error: None,
            seconds: timing,
        };
        let marked = chosen(self.strategy, level.indicator.as_deref(), cells);
        if self.strategy == Strategy::P2Adaptive {
            self.earlier = report.seconds.total - self.making;
        }
        if cells <= DRAWN || self.drawn.is_none() {
            self.drawn = Some(MarkedMesh {
                level: number,
                mesh: mesh.clone(),
                radius: self.model.mesh.bearing.radius,
                indicator: level.indicator,
            });
        }
        self.quantity = goal.cloned();
        self.effects = Some(Effects::of(&level.film.model.effects));
        self.marked = Some(marked);
        self.mesh = mesh;
        report
    }
}

/// Which triangles a strategy divides: all of them where there is no indicator.
fn chosen(strategy: Strategy, indicator: Option<&[f64]>, cells: usize) -> Vec<bool> {
    let marked = match (strategy, indicator) {
        (Strategy::P2Adaptive, Some(indicator)) => doerfler(indicator, SHARE),
        _ => Vec::new(),
    };
    if marked.contains(&true) { marked } else { vec![true; cells] }
}

/// The middle one, or the mean of the two in the middle; zero of none.
fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    let middle = values.len() / 2;
    match (values.get(middle), middle.checked_sub(1).and_then(|place| values.get(place))) {
        (Some(upper), Some(lower)) if values.len().is_multiple_of(2) => 0.5 * (lower + upper),
        (Some(middle), _) => *middle,
        (None, _) => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::{Strategy, chosen, median};

    #[test]
    fn an_indicator_chooses_for_the_adaptive_strategy_only() {
        let indicator = Some(&[0.1, -0.8, 0.1][..]);
        assert_eq!(chosen(Strategy::P2Adaptive, indicator, 3), [false, true, false]);
        assert_eq!(chosen(Strategy::P2Uniform, indicator, 3), [true; 3]);
        assert_eq!(chosen(Strategy::P2Adaptive, None, 3), [true; 3]);
        assert_eq!(chosen(Strategy::P2Adaptive, Some(&[0.0; 3]), 3), [true; 3]);
    }

    #[test]
    fn medians_of_few() {
        assert_eq!(median(vec![]), 0.0);
        assert_eq!(median(vec![3.0]), 3.0);
        assert_eq!(median(vec![3.0, 1.0]), 2.0);
        assert_eq!(median(vec![3.0, 1.0, 7.0]), 3.0);
    }
}
