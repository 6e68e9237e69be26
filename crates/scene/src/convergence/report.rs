//! What a convergence study found, as scripts read it: `converge.json`.
//!
//! Values are in the unit of the goal; errors, bars and accuracies are relative to the finest answer.

use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

use super::price::{Measure, Price};
use super::strategy::Strategy;
use crate::report::{Effects, ReportError, Status};

/// Name and version of the form of `converge.json`.
pub const CONVERGE_FORMAT: &str = "oilwedge-converge/1";

/// Everything that a study found.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ConvergenceReport {
    /// [`CONVERGE_FORMAT`].
    pub format: String,
    /// Title of the scene.
    pub title: String,
    /// Version of the program.
    pub version: String,
    /// SHA-256 of the scene's text, hexadecimal.
    pub scene_sha256: String,
    /// Whether there are any levels.
    pub status: Status,
    /// Why there are none.
    pub reason: Option<String>,
    /// What was simulated, and what was not.
    pub effects: Effects,
    /// The number whose error is studied.
    pub goal: GoalFacts,
    /// The finest answer.
    pub reference: Option<Reference>,
    /// The ways to more accuracy.
    pub strategies: Vec<Course>,
    /// What each digit costs: by error bars, where there are any, and then by true errors.
    pub prices: Vec<Price>,
    /// What to know of the study, in sentences.
    pub notes: Vec<String>,
    /// The time that was given [s].
    pub max_seconds: f64,
    /// The time that was taken [s], without drawing and writing.
    pub seconds: f64,
}

/// The number whose error is studied.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct GoalFacts {
    /// Name of the quantity: `load`, or `eccentricity` where a load is given.
    pub name: String,
    /// Its symbol.
    pub symbol: String,
    /// Its unit.
    pub unit: String,
}

/// The finest answer, which errors are measured against.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Reference {
    /// Whose it is.
    pub strategy: Strategy,
    /// On which level.
    pub level: usize,
    /// Unknowns there.
    pub unknowns: usize,
    /// The value.
    pub value: f64,
    /// How well it is itself known, relative: its bar or, if that is less, what its distances from the levels before predict;
    /// `None` with one level and no bar. Errors below this mean nothing.
    pub uncertainty: Option<f64>,
}

/// The levels of one strategy.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Course {
    /// The strategy.
    pub strategy: Strategy,
    /// The order s with which its price is extrapolated.
    pub order: f64,
    /// The exponent t with which its seconds are extrapolated; `None` without levels.
    pub time_exponent: Option<f64>,
    /// From coarse to fine.
    pub levels: Vec<LevelReport>,
    /// Why there are no more.
    pub ended: String,
}

/// One level.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LevelReport {
    /// Its number, from 1.
    pub level: usize,
    /// Triangles.
    pub cells: usize,
    /// Nodes whose pressure is not given.
    pub unknowns: usize,
    /// Value of the goal.
    pub value: f64,
    /// Half width of the error bar over the finest answer; `None` where it was not estimated.
    pub relative_bar: Option<f64>,
    /// Distance from the finest answer over that answer; `None` for the finest answer itself, or if it is not known well.
    pub relative_error: Option<f64>,
    /// The time from the scene to this answer.
    pub seconds: Timing,
}

impl LevelReport {
    /// The relative error by a measure: the bar, or the distance from the finest answer, but not less than
    /// that one is known to.
    pub fn error(&self, measure: Measure, reference: &Reference) -> Option<f64> {
        match measure {
            Measure::Bar => self.relative_bar,
            Measure::Error => Some(self.relative_error.unwrap_or(0.0).max(reference.uncertainty?)),
        }
    }
}

/// How long a level took [s].
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Timing {
    /// Median of the runs: from the scene to the answer.
    pub total: f64,
    /// The quickest run.
    pub least: f64,
    /// The slowest run.
    pub greatest: f64,
    /// How often the level was run.
    pub runs: usize,
    /// The parts of the total, medians: `mesh` is the making of all meshes up to this one, `earlier` the levels before that
    /// an adaptive mesh needs. An object keyed by part in JSON.
    #[serde(serialize_with = "in_parts")]
    pub parts: Vec<(String, f64)>,
}

impl Timing {
    /// Seconds of a part; zero where it was not needed.
    pub fn part(&self, name: &str) -> f64 {
        self.parts
            .iter()
            .find(|(part, _)| part == name)
            .map_or(0.0, |(_, seconds)| *seconds)
    }
}

impl ConvergenceReport {
    /// The text of `converge.json`, with a line break at its end.
    ///
    /// # Errors
    /// [`ReportError`] where a number is not finite.
    pub fn to_json(&self) -> Result<String, ReportError> {
        let finite = |name: String, value: f64| match value.is_finite() {
            true => Ok(()),
            false => Err(ReportError::NotFinite { name, value }),
        };
        for (course, level) in self.levels() {
            let place = format!("{}, level {}", course.strategy.key(), level.level);
            finite(place.clone(), level.value)?;
            finite(place.clone(), level.relative_bar.unwrap_or(0.0))?;
            finite(place.clone(), level.relative_error.unwrap_or(0.0))?;
            finite(place, level.seconds.total)?;
        }
        for price in &self.prices {
            finite("prices".to_owned(), price.unknowns * price.seconds)?;
        }
        let text = serde_json::to_string_pretty(self).map_err(|error| ReportError::Json(error.to_string()))?;
        Ok(text + "\n")
    }

    /// All levels, each with its course.
    pub fn levels(&self) -> impl Iterator<Item = (&Course, &LevelReport)> {
        (self.strategies.iter()).flat_map(|course| course.levels.iter().map(move |level| (course, level)))
    }
}

fn in_parts<S: Serializer>(parts: &[(String, f64)], serializer: S) -> Result<S::Ok, S::Error> {
    let mut map = serializer.serialize_map(Some(parts.len()))?;
    for (part, seconds) in parts {
        map.serialize_entry(part, seconds)?;
    }
    map.end()
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    pub(crate) fn example() -> ConvergenceReport {
        let level = |level: usize, value: f64, relative_error: Option<f64>| LevelReport {
            level,
            cells: 100 * level,
            unknowns: 190 * level,
            value,
            relative_bar: relative_error.map(|error| 1.5 * error),
            relative_error,
            seconds: Timing {
                total: 0.25 * level as f64,
                least: 0.2,
                greatest: 0.5,
                runs: 3,
                parts: vec![("mesh".into(), 0.125), ("factorise".into(), 0.0625)],
            },
        };
        ConvergenceReport {
            format: CONVERGE_FORMAT.into(),
            title: "example".into(),
            version: "0.1.0".into(),
            scene_sha256: "ab".into(),
            status: Status::Converged,
            reason: None,
            effects: Effects::default(),
            goal: GoalFacts {
                name: "load".into(),
                symbol: "W".into(),
                unit: "N".into(),
            },
            reference: Some(Reference {
                strategy: Strategy::P2Uniform,
                level: 2,
                unknowns: 380,
                value: 1000.0,
                uncertainty: Some(1e-4),
            }),
            strategies: vec![Course {
                strategy: Strategy::P2Uniform,
                order: 2.0,
                time_exponent: Some(1.0),
                levels: vec![level(1, 1010.0, Some(0.01)), level(2, 1000.0, None)],
                ended: "the time is up".into(),
            }],
            prices: vec![Price {
                measure: Measure::Bar,
                accuracy: 0.01,
                strategy: Strategy::P2Uniform,
                unknowns: 190.0,
                seconds: 0.25,
                extrapolated: false,
            }],
            notes: vec![],
            max_seconds: 30.0,
            seconds: 1.5,
        }
    }

    #[test]
    fn the_json_is_that_of_the_reference_page() {
        let text = example().to_json().expect("all numbers are finite");
        let value: serde_json::Value = serde_json::from_str(&text).expect("it is JSON");
        assert_eq!(value["format"], "oilwedge-converge/1");
        assert_eq!(value["reference"]["strategy"], "p2_uniform");
        let level = &value["strategies"][0]["levels"][0];
        assert_eq!(
            (&level["unknowns"], &level["relative_error"]),
            (&190.into(), &0.01.into())
        );
        assert_eq!(level["seconds"]["parts"]["factorise"], 0.0625);
        assert!(value["strategies"][0]["levels"][1]["relative_error"].is_null());
        assert_eq!(value["prices"][0]["extrapolated"], false);
    }

    #[test]
    fn what_is_not_finite_is_not_written() {
        let spoil: [fn(&mut ConvergenceReport); 3] = [
            |report| report.strategies[0].levels[1].value = f64::NAN,
            |report| report.strategies[0].levels[0].relative_bar = Some(f64::INFINITY),
            |report| report.prices[0].seconds = f64::NAN,
        ];
        for spoil in spoil {
            let mut report = example();
            spoil(&mut report);
            assert!(matches!(report.to_json(), Err(ReportError::NotFinite { .. })));
        }
    }

    #[test]
    fn a_true_error_is_known_as_well_as_the_reference() {
        let report = example();
        let (reference, levels) = (report.reference.expect("one"), &report.strategies[0].levels);
        let errors = |measure: Measure| [0, 1].map(|level| levels[level].error(measure, &reference));
        assert_eq!(errors(Measure::Bar), [Some(0.015), None]);
        assert_eq!(errors(Measure::Error), [Some(0.01), Some(1e-4)]);
    }
}
