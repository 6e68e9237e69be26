//! Arguments that `solve` and `sweep` share: error bars and limits of a run.

use crate::complain::Failure;
use oilwedge_scene::Scene;
use oilwedge_study::{Interrupt, RunOptions};
use std::path::{Path, PathBuf};

/// How a scene is run.
#[derive(Debug, clap::Args)]
pub(crate) struct RunArguments {
    /// The scene: a TOML file that describes a bearing or, for solve and sweep, a crankshaft.
    #[arg(value_name = "SCENE")]
    pub(crate) scene: PathBuf,

    /// Folder of the results [default: out/NAME for NAME.toml]. Earlier results of solve there are replaced, a sweep is
    /// continued.
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,

    /// Print one JSON object instead of tables.
    #[arg(long)]
    pub(crate) json: bool,

    /// Estimate error bars, or none (not with a tolerance in the scene).
    #[arg(long, value_enum, default_value_t = Bars::Auto)]
    bars: Bars,

    /// Time limit of a run in seconds, of each case of a sweep: for the refinement towards a tolerance and the search
    /// for a position under a load [default: 60 where the mesh is refined: with a tolerance, or with neither mesh file
    /// nor size; none on a given mesh and for a crankshaft]. The default does not count the time that a busy machine
    /// spends on others. A film that was begun is finished.
    #[arg(long, value_name = "S", value_parser = seconds)]
    max_seconds: Option<f64>,

    /// Most unknowns of meshes that are refined towards a tolerance; the first mesh may have 10 000 in any case, and
    /// one that the scene gives more.
    #[arg(long, value_name = "N", default_value_t = 1_000_000, value_parser = unknowns)]
    max_unknowns: usize,
}

/// Whether error bars are estimated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Bars {
    /// Bars for every quantity whose error can be resolved.
    Auto,
    /// No bars.
    None,
}

fn seconds(text: &str) -> Result<f64, String> {
    let seconds = text.parse().ok();
    let seconds = seconds.filter(|seconds: &f64| seconds.is_finite() && *seconds > 0.0);
    seconds.ok_or_else(|| "a number of seconds above zero is wanted".to_owned())
}

fn unknowns(text: &str) -> Result<usize, String> {
    let count = text.parse().ok().filter(|count| *count > 0);
    count.ok_or_else(|| "a whole number above zero is wanted".to_owned())
}

impl RunArguments {
    /// The options of a run that `interrupt` ends.
    ///
    /// # Errors
    /// No error bars are wanted, but the scene has a tolerance.
    pub(crate) fn options(&self, scene: &Scene, interrupt: Interrupt) -> Result<RunOptions, Failure> {
        if self.bars == Bars::None && scene.gives_tolerance() {
            return Err(Failure::Message(format!(
                "--bars none conflicts with the mesh.tolerance of the scene {}: a tolerance is met by error bars; leave out --bars none, or remove tolerance from [mesh]",
                self.scene.display()
            )));
        }
        let usual = RunOptions::of(scene);
        Ok(RunOptions {
            bars: self.bars == Bars::Auto,
            max_unknowns: self.max_unknowns,
            interrupt,
            ..usual.limited(self.max_seconds)
        })
    }

    /// The options of a run of a crankshaft, which takes the time that it takes.
    pub(crate) fn options_of_shaft(&self) -> RunOptions {
        RunOptions { bars: self.bars == Bars::Auto, max_seconds: f64::INFINITY, ..RunOptions::default() }
            .limited(self.max_seconds)
    }

    /// The folder of the results.
    pub(crate) fn folder(&self) -> PathBuf {
        folder(&self.out, &self.scene)
    }
}

/// The folder given, else `out/NAME` for `NAME.toml`.
pub(crate) fn folder(given: &Option<PathBuf>, scene: &Path) -> PathBuf {
    let own = || Path::new("out").join(scene.file_stem().unwrap_or("scene".as_ref()));
    given.clone().unwrap_or_else(own)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_go_to_a_folder_named_after_the_scene() {
        let scene = Path::new("scenes/01_plain.toml");
        assert_eq!(folder(&None, scene), Path::new("out/01_plain"));
        assert_eq!(folder(&Some("a".into()), scene), Path::new("a"));
    }
}
