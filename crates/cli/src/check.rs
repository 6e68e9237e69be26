//! `oilwedge check`: what a scene or mesh holds, or what is wrong with it. Nothing is solved or written.

use crate::check_report::check_report;
use crate::complain::{self, Failure};
use crate::crankshaft;
use crate::terminal::{output, print};
use oilwedge_campaign::sweep::Sweep;
use oilwedge_report::json;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Arguments of `oilwedge check`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct CheckCommand {
    /// A scene (TOML), or a mesh by itself (a gmsh 4.1 file, its name ending in .msh, lengths in metres).
    #[arg(value_name = "SCENE|MESH")]
    file: PathBuf,

    /// Print what was found as one JSON object.
    #[arg(long)]
    json: bool,
}

const EXAMPLES: &str = "\
Examples:
  oilwedge check bearing.toml
  oilwedge check meshes/liner.msh --json

Exit status: 0 it can be used; 2 it cannot (all errors are on stderr).";

impl CheckCommand {
    /// Checks the file, and prints what is in it.
    ///
    /// # Errors
    /// [`Failure`]: the scene or mesh cannot be used.
    pub(crate) fn run(&self) -> Result<ExitCode, Failure> {
        let found = match is_mesh(&self.file) {
            true => oilwedge_report::check_mesh(&self.file)?,
            false => {
                let scene = match oilwedge_study::read(&self.file) {
                    Err(error) if crankshaft::is_crankshaft(&error) => {
                        print(&crankshaft::check(&self.file)?, None)?;
                        return Ok(ExitCode::SUCCESS);
                    }
                    other => other?,
                };
                // Every case must be a good scene.
                Sweep::of(&scene)?;
                oilwedge_report::check_scene(&scene).map_err(Failure::of(&self.file))?
            }
        };
        let json = json(&found)?;
        complain::warn(&found.warnings);
        output(self.json, || Ok(json), || check_report(&found), None)?;
        Ok(ExitCode::SUCCESS)
    }
}

fn is_mesh(file: &Path) -> bool {
    file.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("msh"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn meshes_are_recognised_by_their_ending() {
        assert!(is_mesh(Path::new("liner.msh")) && is_mesh(Path::new("LINER.MSH")));
        assert!(!is_mesh(Path::new("bearing.toml")) && !is_mesh(Path::new("msh")));
    }
}
