//! `oilwedge solve`: one scene to numbers and fields.

use crate::complain::{self, Failure};
use crate::progress::Working;
use crate::{interrupt, terminal};
use oilwedge_campaign::{AddOns, effect_costs, standard, theories};
use oilwedge_report::Error;
use oilwedge_report::result_json;
use oilwedge_report::results::write_results;
use oilwedge_report::vtu::to_vtu;
use oilwedge_scene::{Scene, Tolerance};
use oilwedge_study::result::Status;
use oilwedge_study::{Interrupt, RunOptions};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Arguments of `oilwedge solve`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Solve {
    /// The scene: a TOML file that describes one bearing.
    #[arg(value_name = "SCENE")]
    scene: PathBuf,

    /// Folder of result.json and film.vtu [default: out/NAME for NAME.toml]. Earlier results there are replaced.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,

    /// Print the result as one JSON object instead of tables.
    #[arg(long)]
    json: bool,

    /// Draw film.vtu on the unrolled liner (x = R phi, y = z) instead of on the cylinder.
    #[arg(long)]
    unrolled: bool,

    /// Estimate error bars, or none (not with a tolerance in the scene).
    #[arg(long, value_enum, default_value_t = Bars::Auto)]
    bars: Bars,

    /// End the refinement towards a tolerance, and the search for a position under a load, after this many seconds
    /// [default: 60 with a tolerance, else none]. A film that was begun is finished.
    #[arg(long, value_name = "S", value_parser = seconds)]
    max_seconds: Option<f64>,

    /// Refine towards a tolerance to this many unknowns at most; the first mesh, and one that the scene gives, may have more.
    #[arg(long, value_name = "N", default_value_t = 1_000_000, value_parser = unknowns)]
    max_unknowns: usize,

    /// Solve again without each effect, and tell what it changes and costs.
    #[arg(long)]
    cost: bool,

    /// Tell what ISO 7902 (DIN 31652) gives for the same bearing, beside its film.
    #[arg(long)]
    standard: bool,

    /// Solve again as a short and as a long bearing, and tell how far these theories are from the film of this length.
    #[arg(long)]
    theories: bool,
}

/// Whether error bars are estimated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum Bars {
    /// For every quantity whose error can be resolved.
    Auto,
    /// For none.
    None,
}

pub(crate) fn seconds(text: &str) -> Result<f64, String> {
    let seconds = text
        .parse()
        .ok()
        .filter(|seconds: &f64| seconds.is_finite() && *seconds > 0.0);
    seconds.ok_or_else(|| "a number of seconds above zero is wanted".to_owned())
}

pub(crate) fn unknowns(text: &str) -> Result<usize, String> {
    let count = text.parse().ok().filter(|count| *count > 0);
    count.ok_or_else(|| "a whole number above zero is wanted".to_owned())
}

const EXAMPLES: &str = "\
Examples:
  oilwedge solve bearing.toml
  oilwedge solve bearing.toml --out results/today --unrolled
  oilwedge solve bearing.toml --json | jq .quantities.load.value
  oilwedge solve bearing.toml --cost
  oilwedge solve bearing.toml --standard
  oilwedge solve bearing.toml --theories
  oilwedge solve bearing.toml --bars none
  oilwedge solve bearing.toml --max-seconds 600 --max-unknowns 5000000

Exit status: 0 done; 1 no solution, not converged, or a tolerance that a limit or Ctrl-C left unmet (the reason is in the result);
2 bad scene, mesh or arguments; 130 ended by Ctrl-C at once, on its second or without a tolerance or load.";

impl Solve {
    /// Solves the scene, writes the results, and prints them.
    ///
    /// # Errors
    /// [`Failure`]: the scene or its mesh cannot be used, or the results cannot be written.
    pub(crate) fn run(&self) -> Result<ExitCode, Failure> {
        let scene = oilwedge_study::read(&self.scene)?;
        let options = self.options(&scene)?;
        let working = Working::on(Self::task(&scene));
        let run = oilwedge_study::run(&scene, &options)
            .map_err(Error::from)
            .map_err(Failure::of(&self.scene))?;
        let mut add_ons = AddOns::default();
        if self.cost {
            working.turns_to("the film without each effect");
            add_ons.cost = Some(effect_costs(&scene, &options, &run.result).map_err(Error::from)?);
        }
        if self.standard {
            add_ons.standard = Some(standard(&scene, &run.result));
        }
        if self.theories {
            working.turns_to("the film of a short and of a long bearing");
            add_ons.theories = Some(theories(&scene, &options, &run.result));
        }
        drop(working);
        let json = result_json(&run.result, &add_ons).map_err(Error::from)?;
        let picture = run.picture.map(to_vtu).transpose().map_err(Error::from)?;
        let folder = self.out.clone().unwrap_or_else(|| default_folder(&self.scene));
        write_results(&folder, &run.result, &add_ons, picture.as_deref()).map_err(Error::from)?;
        if let Some(plan) = &scene.sweep {
            let cases = plan.cases();
            complain::warn(&[format!(
                "the {cases} cases of [sweep] are not run here, but the scene as it is without them; run them with oilwedge sweep"
            )]);
        }
        complain::warn(&run.result.warnings);
        match self.json {
            true => terminal::print(&json, Some(&folder))?,
            false => terminal::print(
                &terminal::run_report(&run.result, &add_ons, &folder, picture.is_some()),
                Some(&folder),
            )?,
        }
        Ok(match run.result.status {
            Status::Converged => ExitCode::SUCCESS,
            Status::NoSolution | Status::NotConverged => ExitCode::from(1),
        })
    }

    /// What a run of the scene may spend long on.
    fn task(scene: &Scene) -> &'static str {
        match (scene.tolerance.is_some(), scene.journal.load().is_some()) {
            (true, _) => "from mesh to mesh, until the error bars are small enough; Ctrl-C ends with the best so far",
            (false, true) => "the position under the load; Ctrl-C ends with the best so far",
            (false, false) => "the film",
        }
    }

    fn options(&self, scene: &Scene) -> Result<RunOptions, Failure> {
        let bars = wanted_bars(self.bars, scene, &self.scene)?;
        Ok(RunOptions {
            unrolled: self.unrolled,
            bars,
            max_seconds: time_limit(self.max_seconds, scene),
            max_unknowns: self.max_unknowns,
            interrupt: match scene.tolerance.is_some() || scene.journal.load().is_some() {
                true => interrupt::listen()?,
                false => Interrupt::NEVER,
            },
        })
    }
}

/// The time [s] that a run of the scene may take: what is asked for, else enough for most tolerances; a given mesh takes what it takes.
pub(crate) fn time_limit(asked: Option<f64>, scene: &Scene) -> f64 {
    let usual = match scene.tolerance {
        Some(_) => RunOptions::default().max_seconds,
        None => f64::INFINITY,
    };
    asked.unwrap_or(usual)
}

/// Whether error bars are wanted.
///
/// # Errors
/// None are, but the scene at `path` asks for a tolerance.
pub(crate) fn wanted_bars(bars: Bars, scene: &Scene, path: &Path) -> Result<bool, Failure> {
    let bars = bars == Bars::Auto;
    if !bars
        && scene
            .tolerance
            .as_ref()
            .is_some_and(|tolerance| *tolerance != Tolerance::Usual)
    {
        return Err(Failure::Argument {
            message: format!(
                "--bars none does not go with the mesh.tolerance of the scene {}: without error bars nothing tells when it is met; leave out --bars none, or remove tolerance from [mesh]",
                path.display()
            ),
        });
    }
    Ok(bars)
}

/// `out/NAME` for `NAME.toml`.
pub(crate) fn default_folder(scene: &Path) -> PathBuf {
    Path::new("out").join(scene.file_stem().unwrap_or("scene".as_ref()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_go_to_a_folder_named_after_the_scene() {
        assert_eq!(
            default_folder(Path::new("scenes/01_plain.toml")),
            Path::new("out/01_plain")
        );
    }
}
