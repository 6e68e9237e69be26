//! `oilwedge converge`: what accuracy costs for one scene.

use crate::complain::Failure;
use crate::interrupt;
use crate::levels_table::convergence_report;
use crate::plot;
use crate::progress::ProgressLine;
use crate::report::PageArguments;
use crate::run_options::folder;
use crate::terminal::{exit_code, output};
use oilwedge_campaign::convergence::{Budget, converge};
use oilwedge_report::convergence as files;
use oilwedge_report::json;
use oilwedge_report::page::{STUDY_PAGE_FILE, convergence_page};
use oilwedge_report::plot::{CONVERGENCE, convergence_figure};
use std::path::PathBuf;
use std::process::ExitCode;

/// Arguments of `oilwedge converge`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Converge {
    /// The scene: a TOML file that describes one bearing.
    #[arg(value_name = "SCENE")]
    scene: PathBuf,

    /// Folder of converge.csv, .json, .svg and .png [default: out/NAME for NAME.toml]. Earlier ones there are replaced.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,

    /// Print the study as one JSON object instead of tables.
    #[arg(long)]
    json: bool,

    /// Draw the study into the folder plot of the results too.
    #[arg(long)]
    plot: bool,

    #[command(flatten)]
    page: PageArguments,

    /// Time limit of the study in seconds. It ends with the levels finished by then, as it does at Ctrl-C.
    #[arg(long, value_name = "S", default_value = "30", value_parser = seconds)]
    max_seconds: f64,
}

const EXAMPLES: &str = "\
Examples:
  oilwedge converge bearing.toml
  oilwedge converge bearing.toml --max-seconds 120 --out results/accuracy
  oilwedge converge bearing.toml --json | jq '.prices[] | [.accuracy, .seconds]'

Exit status: 0 done, with the levels that fitted; 1 no solution or not converged on any mesh (the reason is in
converge.json); 2 bad scene, mesh or arguments.";

/// Longest study [s]: a day.
const LONGEST: f64 = 86_400.0;

fn seconds(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(seconds) if seconds > 0.0 && seconds <= LONGEST => Ok(seconds),
        _ => Err(format!("give seconds above 0 and up to {LONGEST}, as 30 or 2.5")),
    }
}

impl Converge {
    /// Runs the study, writes its files, and prints it.
    ///
    /// # Errors
    /// [`Failure`]: the scene or its mesh cannot be used, or the files cannot be written.
    pub(crate) fn run(&self) -> Result<ExitCode, Failure> {
        let budget = Budget::seconds(self.max_seconds).until(interrupt::listen()?);
        let scene = oilwedge_study::read(&self.scene)?;
        let folder = folder(&self.out, &self.scene);
        files::check(&folder)?;
        let mut progress = ProgressLine::of_seconds(self.max_seconds);
        let study = converge(&scene, &budget, &mut progress).map_err(Failure::of(&self.scene))?;
        drop(progress);
        let report = &study.report;
        files::write(&folder, &study)?;
        let is_drawn = self.plot && report.levels().next().is_some();
        let figures: Vec<_> =
            is_drawn.then(|| (CONVERGENCE.to_owned(), convergence_figure(&study))).into_iter().collect();
        let page = self.page.made(|| {
            let svg = report.levels().next().is_some().then(|| convergence_figure(&study).to_svg());
            convergence_page(report, svg.as_deref())
        })?;
        let drawn = plot::written(&folder, &figures)? + &self.page.written(&folder, STUDY_PAGE_FILE, page)?;
        output(self.json, || json(report), || convergence_report(report, &folder) + &drawn, Some(&folder))?;
        Ok(exit_code(report.head.status))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_time_is_positive_and_ends() {
        assert_eq!(seconds("2.5"), Ok(2.5));
        for text in ["0", "-1", "nan", "inf", "1e9", "ten", ""] {
            assert!(seconds(text).is_err_and(|message| message.contains("as 30 or 2.5")), "{text}");
        }
    }
}
