//! `oilwedge design`: the numbers of a scene that make a quantity least or greatest, the criteria being met.

use std::ffi::OsStr;
use std::process::ExitCode;

use oilwedge_campaign::Records;
use oilwedge_campaign::design::{DesignEnd, Designed, NoDesign, design};
use oilwedge_report::design_sheet::{DESIGN_FILE, OPTIMUM_FILE, design_csv};
use oilwedge_report::folder::replace;
use oilwedge_report::page::{Extras, PAGE_FILE, SceneFile, film_page};
use oilwedge_report::result_json;
use oilwedge_report::results::{ResultCompanions, write_results};
use oilwedge_report::tables::{ShownQuantities, Written, run_report};
use oilwedge_report::vtu::{VtuForm, to_vtu};
use oilwedge_scene::no_design;
use oilwedge_study::RunOptions;
use oilwedge_study::result::Status;

use crate::complain::{self, Failure};
use crate::interrupt;
use crate::progress::ProgressLine;
use crate::report::PageArguments;
use crate::run_options::RunArguments;
use crate::terminal::output;

/// Arguments of `oilwedge design`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct DesignCommand {
    #[command(flatten)]
    run: RunArguments,

    #[command(flatten)]
    page: PageArguments,
}

const EXAMPLES: &str = "\
Examples:
  oilwedge design bearing.toml
  oilwedge design bearing.toml --out results/design --report

In the scene, the limits being those of [criteria]:
  [design]
  free = { \"bearing.clearance\" = [\"20 um\", \"40 um\"], \"feed.groove.groove.width\" = [\"3 mm\", \"9 mm\"] }
  minimise = \"friction_power\"

Writes the results of solve for the optimum, design.csv with all films of the search, and optimum.toml, the scene with the numbers of the optimum.

Exit status: 0 done; 1 the search found no optimum that meets the criteria (the best film is written); 2 bad scene, mesh or arguments, or no film
to begin with (nothing was written); 130 ended by Ctrl-C.";

impl From<NoDesign> for Failure {
    fn from(error: NoDesign) -> Self {
        match error {
            NoDesign::Scene(error) => error.into(),
            NoDesign::Compile(error) => error.into(),
            NoDesign::NoStart(_) => Self::Message(error.to_string()),
        }
    }
}

impl DesignCommand {
    /// Finds the optimum, writes the results, and prints them.
    ///
    /// # Errors
    /// [`Failure`]: the scene cannot be used or has no design, there is no film to begin with, or the results cannot be
    /// written.
    pub(crate) fn run(&self) -> Result<ExitCode, Failure> {
        let path = &self.run.scene;
        let scene = oilwedge_study::read(path)?;
        let asked = scene.design.as_ref().ok_or_else(|| Failure::Message(no_design(path)))?;
        let options: RunOptions = self.run.options(&scene, interrupt::listen_in_time(interrupt::NOTHING)?)?;
        let working = ProgressLine::of("the films of the search");
        let Designed { run, scene: optimum, record, notes } = design(&scene, asked, &options)?;
        drop(working);
        let is_found = record.end == DesignEnd::Optimum && record.is_met && run.result.head.status == Status::Converged;
        let csv = design_csv(&record);
        let records = Records { design: Some(record), ..Records::default() };
        let json = result_json(&run.result, &records)?;
        let page = self.page.made(|| {
            let files = SceneFile::all(&optimum.text, path);
            let extras = Extras { records: Some(&records), course: None, files: &files };
            film_page(&run.result, run.picture.as_ref(), extras)
        })?;
        let picture = run.picture.map(|picture| to_vtu(&picture, VtuForm::usual(&picture))).transpose()?;
        let folder = self.run.folder();
        let _writing = interrupt::writing();
        let beside = ResultCompanions { picture: picture.as_deref(), ..ResultCompanions::default() };
        let mut files = write_results(&folder, &run.result, &records, beside)?;
        let own = [(DESIGN_FILE, csv.as_bytes()), (OPTIMUM_FILE, optimum.text.as_bytes())];
        replace(&folder, &own.map(|(name, content)| (OsStr::new(name), Some(content))))?;
        files.extend(own.map(|(name, _)| name.to_owned()));
        let drawn = self.page.written(&folder, PAGE_FILE, page)?;
        complain::warn(&notes);
        complain::warn(&run.result.tail.warnings);
        let written = Written { folder: &folder, files: &files, pictures: &drawn };
        let report = || run_report(&run.result, ShownQuantities::Headlines, &records, Some(written));
        output(self.run.json, || Ok(json), report, Some(&folder))?;
        Ok(if is_found { ExitCode::SUCCESS } else { ExitCode::from(1) })
    }
}
