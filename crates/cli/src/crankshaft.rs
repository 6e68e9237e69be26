//! `oilwedge solve` and `oilwedge check` of the scene of a crankshaft.

use crate::complain::{self, Failure};
use crate::interrupt;
use crate::plot;
use crate::progress::Progress;
use crate::terminal::{exit_code, output};
use oilwedge_report::json;
use oilwedge_report::orbit_course::OrbitCourse;
use oilwedge_report::plot::{load_figures, orbit_figures};
use oilwedge_report::shaft::write_shaft;
use oilwedge_report::tables::shaft_report;
use oilwedge_scene::{SceneError, ShaftScene};
use oilwedge_study::RunOptions;
use oilwedge_study::shaft::{NoWeights, ShaftError, ShaftRun, check_shaft, run_shaft, run_with_best_counterweights};
use std::path::Path;
use std::process::ExitCode;

impl From<ShaftError> for Failure {
    fn from(error: ShaftError) -> Self {
        match error {
            ShaftError::Scene(error) => Self::Scene(error),
            other => Self::Message(other.to_string()),
        }
    }
}

impl From<NoWeights> for Failure {
    fn from(error: NoWeights) -> Self {
        match error {
            NoWeights::Shaft(error) => error.into(),
            other => Self::Message(format!("--counterweights: {other}")),
        }
    }
}

/// Whether a scene could not be read because it is that of a crankshaft.
pub(crate) fn is_crankshaft(error: &SceneError) -> bool {
    matches!(error, SceneError::Crankshaft { .. })
}

/// What is asked of a run.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Asked<'a> {
    /// The scene.
    pub(crate) scene: &'a Path,
    /// Folder of the results.
    pub(crate) folder: &'a Path,
    /// How it is run.
    pub(crate) options: RunOptions,
    /// Whether counterweights are sought.
    pub(crate) weights: Weights,
    /// What is printed.
    pub(crate) shown: Form,
}

/// The counterweights of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Weights {
    /// Those of the scene.
    Given,
    /// Those, and the best ones.
    Best,
}

/// What is printed of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Form {
    /// One JSON object.
    Json,
    /// A table.
    Table,
}

/// Solves the scene of a crankshaft, writes the results, and prints them.
///
/// # Errors
/// [`Failure`]: a scene cannot be used, or the results cannot be written.
pub(crate) fn solve(asked: Asked) -> Result<ExitCode, Failure> {
    let scene = ShaftScene::read(asked.scene)?;
    let working = Progress::of("the films of all bearings; Ctrl-C ends with the cycles that are complete");
    let options = RunOptions {
        interrupt: interrupt::listen()?,
        observer: Some(working.observer()),
        ..asked.options
    };
    let mut run = run_shaft(&scene, &options)?;
    if asked.weights == Weights::Best {
        working.turns_to("the best counterweights");
        let (_, report) = run_with_best_counterweights(&scene, &run, &options)?;
        run.result.counterweights = Some(report);
    }
    drop(working);
    let text = json(&run.result)?;
    let files = write_shaft(asked.folder, &run)?;
    let pictures = drawn(asked.folder, &run)?;
    complain::warn(&run.result.warnings);
    output(
        asked.shown == Form::Json,
        || Ok(text),
        || shaft_report(&run.result, asked.folder, &files, &pictures),
        Some(asked.folder),
    )?;
    Ok(exit_code(run.result.status))
}

/// The load, the path and the film of each bearing over the cycle as pictures, and a line about them.
fn drawn(folder: &Path, run: &ShaftRun) -> Result<String, Failure> {
    let width = plot::usual().width;
    let of_bearing = |(number, bearing): (usize, &oilwedge_study::shaft::BearingPath)| {
        let title = format!("{}, bearing {}", run.result.title, bearing.name);
        let course = OrbitCourse::of_path(&bearing.path);
        let figures = load_figures(&title, &bearing.load, width)
            .into_iter()
            .chain(orbit_figures(&title, &course, width));
        let named = move |(name, figure)| (format!("bearing_{}_{name}", number + 1), figure);
        figures.map(named).collect::<Vec<_>>()
    };
    let figures: Vec<_> = run.paths.iter().enumerate().flat_map(of_bearing).collect();
    plot::written(folder, &figures)
}

/// Checks the scene of a crankshaft and those of its bearings, and prints what is in them.
///
/// # Errors
/// [`Failure`]: a scene cannot be used.
pub(crate) fn check(path: &Path) -> Result<String, Failure> {
    let scene = ShaftScene::read(path)?;
    let compiled = check_shaft(&scene)?;
    let mut lines = vec![format!(
        "{}: a crankshaft of {:.1} mm with {} throws on {} bearings",
        scene.title,
        1e3 * scene.crankshaft.length(),
        scene.crankshaft.fires_at().len(),
        compiled.bearings.len()
    )];
    for bearing in &compiled.bearings {
        lines.push(format!(
            "bearing {}: {} at {:.1} mm, {} unknowns",
            bearing.name,
            bearing.path.display(),
            1e3 * bearing.at,
            bearing.film.unknowns()
        ));
    }
    Ok(lines.join("\n") + "\n")
}
