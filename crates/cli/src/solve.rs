//! `oilwedge solve`: one scene to numbers and fields.

use crate::complain::{self, Failure};
use crate::terminal;
use oilwedge_scene::report::Status;
use oilwedge_scene::results::write_results;
use oilwedge_scene::{Error, RunOptions, Scene};
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
}

const EXAMPLES: &str = "\
Examples:
  oilwedge solve bearing.toml
  oilwedge solve bearing.toml --out results/today --unrolled
  oilwedge solve bearing.toml --json | jq .quantities.load.value

Exit status: 0 done; 1 no solution or not converged (the reason is in the result); 2 bad scene, mesh or arguments.";

impl Solve {
    /// Solves the scene, writes the results, and prints them.
    ///
    /// # Errors
    /// [`Failure`]: the scene or its mesh cannot be used, or the results cannot be written.
    pub(crate) fn run(&self) -> Result<ExitCode, Failure> {
        let scene = Scene::read(&self.scene)?;
        let run = oilwedge_scene::run(
            &scene,
            &RunOptions {
                unrolled: self.unrolled,
            },
        )?;
        let json = run.result.to_json().map_err(Error::from)?;
        let picture = run
            .picture
            .map(|picture| picture.to_vtu())
            .transpose()
            .map_err(Error::from)?;
        let folder = self.out.clone().unwrap_or_else(|| default_folder(&self.scene));
        write_results(&folder, &run.result, picture.as_deref()).map_err(Error::from)?;
        complain::warn(&run.result.warnings);
        match self.json {
            true => terminal::print(&json)?,
            false => terminal::print(&terminal::run_report(&run.result, &folder, picture.is_some()))?,
        }
        Ok(match run.result.status {
            Status::Converged => ExitCode::SUCCESS,
            Status::NoSolution | Status::NotConverged => ExitCode::from(1),
        })
    }
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
