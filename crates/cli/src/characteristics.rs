//! `oilwedge characteristics`: what a film carries for each motion of its journal by itself.

use crate::characteristics_report::characteristics_report;
use crate::complain::{self, Failure};
use crate::progress::ProgressLine;
use crate::run_options::RunArguments;
use crate::terminal::{exit_code, output};
use oilwedge_campaign::characteristics::{characteristics, check, fit};
use oilwedge_report::characteristics as files;
use oilwedge_report::json;
use oilwedge_report::sweep::Progress as Cases;
use oilwedge_scene::Scene;
use oilwedge_study::result::Status;
use oilwedge_study::{CHECKS, Interrupt};
use std::process::ExitCode;
use std::sync::Mutex;

/// Arguments of `oilwedge characteristics`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct CharacteristicsOf {
    #[command(flatten)]
    run: RunArguments,

    /// Solve 70 straight bearings as well, and fit the seven characteristics of a parallel journal over eccentricity
    /// and B/D.
    #[arg(long)]
    fit: bool,
}

const EXAMPLES: &str = "\
Examples:
  oilwedge characteristics tilted.toml
  oilwedge characteristics tilted.toml --json | jq '.parts[] | {part, characteristics}'
  oilwedge characteristics tilted.toml --fit --out results/fit

Exit status: 0 done; 1 a film has no solution or has not converged (the reason is in characteristics.json); 2 bad scene, mesh or arguments.";

impl CharacteristicsOf {
    /// Solves the films, writes the file, and prints the tables.
    ///
    /// # Errors
    /// [`Failure`]: the scene or its mesh cannot be used, or the file cannot be written.
    pub(crate) fn run(&self) -> Result<ExitCode, Failure> {
        let path = &self.run.scene;
        let checks: Vec<_> = CHECKS.into_iter().chain([check as oilwedge_scene::Check]).collect();
        let scene = Scene::read(path, &checks)?;
        let folder = self.run.folder();
        files::check(&folder)?;
        let options = self.run.options(&scene, Interrupt::NEVER)?;
        let working = ProgressLine::of("the film of each motion");
        let mut found = characteristics(&scene, &options).map_err(Failure::of(path))?;
        drop(working);
        if self.fit {
            let progress = Mutex::new(ProgressLine::of_cases());
            let done = |done: usize, cases: usize| {
                if let Ok(mut progress) = progress.lock() {
                    progress.cases(Cases { kept: 0, done, cases });
                }
            };
            let fit = fit(&scene, &options, &done).map_err(Failure::of(path))?;
            if let (Some(reason), Status::Converged) = (&fit.reason, found.head.status) {
                found.head.end(Status::NotConverged, format!("fit: {reason}"));
            }
            found.fit = Some(fit);
        }
        files::write(&folder, &found)?;
        complain::warn(&found.warnings);
        output(self.run.json, || json(&found), || characteristics_report(&found, &folder), Some(&folder))?;
        Ok(exit_code(found.head.status))
    }
}
