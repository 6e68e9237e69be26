//! `oilwedge solve` and `oilwedge check` of the scene of a crankshaft.

use crate::complain::{self, Failure};
use crate::interrupt;
use crate::plot;
use crate::progress::ProgressLine;
use crate::report::PageArguments;
use crate::run_options::RunArguments;
use crate::terminal::{exit_code, output};
use oilwedge_report::json;
use oilwedge_report::orbit_course::OrbitCourse;
use oilwedge_report::page::{PAGE_FILE, SceneFile, shaft_page};
use oilwedge_report::plot::{load_figures, orbit_figures, shaft_figures};
use oilwedge_report::shaft::{ShaftBeside, write_shaft};
use oilwedge_report::shaft_view::ShaftViews;
use oilwedge_report::tables::{Written, shaft_report};
use oilwedge_scene::{SceneError, ShaftScene};
use oilwedge_study::RunOptions;
use oilwedge_study::shaft::{
    NoWeights, ShaftError, ShaftRun, Variant, check_shaft, run_cut, run_shaft, run_with_best_counterweights,
};
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

/// Solves the scene of a crankshaft and the shafts beside it, writes the results, and prints them.
///
/// # Errors
/// [`Failure`]: a scene cannot be used, or the results cannot be written.
pub(crate) fn solve(asked: &RunArguments, variants: &[Variant], page: PageArguments) -> Result<ExitCode, Failure> {
    let scene = ShaftScene::read(&asked.scene)?;
    variants.iter().try_for_each(|variant| variant.check(&scene))?;
    let folder = asked.folder();
    let working = ProgressLine::of("the films of all bearings; Ctrl-C ends with the cycles that are complete");
    let interrupt = interrupt::listen()?;
    let options = RunOptions { interrupt, observer: Some(working.observer()), ..asked.options_of_shaft() };
    let mut run = run_shaft(&scene, &options)?;
    let mut beside: Vec<ShaftBeside> = Vec::new();
    for variant in variants {
        working.goes_on_to(variant.words());
        let other = match variant {
            Variant::Cut => run_cut(&scene, &options)?,
            Variant::Counterweights => {
                let (other, report) = run_with_best_counterweights(&scene, &run, &options)?;
                run.result.counterweights = Some(report);
                other
            }
        };
        beside.push((*variant, other));
    }
    drop(working);
    let text = json(&run.result)?;
    let views = ShaftViews::of_runs(&run, &beside);
    let html = page.made(|| shaft_page(&views, &SceneFile::all(&scene.text, &asked.scene)))?;
    let files = write_shaft(&folder, &run, &beside)?;
    let pictures = drawn(&folder, &run, &views)? + &page.written(&folder, PAGE_FILE, html)?;
    let bearings = scene.crankshaft.bearings.len();
    complain::warn_of_sweep(scene.sweep.as_ref().map(|plan| plan.cases() * bearings));
    complain::warn(&run.result.tail.warnings);
    output(
        asked.json,
        || Ok(text),
        || shaft_report(&run.result, &beside, Written { folder: &folder, files: &files, pictures: &pictures }),
        Some(&folder),
    )?;
    Ok(exit_code(run.result.head.status))
}

/// The shaft with all its bearings, and the load, the path and the film of each one over the cycle as pictures, and a
/// line about them.
fn drawn(folder: &Path, run: &ShaftRun, views: &ShaftViews) -> Result<String, Failure> {
    let width = plot::usual().width;
    let of_bearing = |(number, bearing): (usize, &oilwedge_study::shaft::BearingPath)| {
        let title = format!("{}, bearing {}", run.result.head.title, bearing.name);
        let course = OrbitCourse::of_path(&bearing.path);
        let figures =
            load_figures(&title, &bearing.load, width).into_iter().chain(orbit_figures(&title, &course, width));
        let named = move |(name, figure)| (format!("bearing_{}_{name}", number + 1), figure);
        figures.map(named).collect::<Vec<_>>()
    };
    let of_bearings = run.paths.iter().enumerate().flat_map(of_bearing);
    let figures: Vec<_> = shaft_figures(views, width).into_iter().chain(of_bearings).collect();
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
