//! `oilwedge report`: the HTML pages of results in a folder; and `--report`, `--open` of other verbs.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitCode, Stdio};
use std::time::{Duration, Instant};

use oilwedge_report::convergence::REPORT_FILE as STUDY_FILE;
use oilwedge_report::folder::replace;
use oilwedge_report::json::ResultFile;
use oilwedge_report::orbit_course::OrbitCourse;
use oilwedge_report::page::{
    Extras, PAGE_FILE, STUDY_PAGE_FILE, SWEEP_PAGE_FILE, convergence_page, film_page, shaft_page, sweep_page,
};
use oilwedge_report::results::{ORBIT_FILE, PICTURE_FILE, RESULT_FILE};
use oilwedge_report::shaft_view::ShaftViews;
use oilwedge_report::sweep::REPORT_FILE as SWEEP_FILE;
use oilwedge_report::vtu_read::from_vtu;
use oilwedge_study::result::ResultHead;
use oilwedge_study::shaft::SHAFT_FORMAT;

use crate::complain::{self, Failure};
use crate::plot::{read, results, text};
use crate::terminal::print;

/// Arguments of verbs that write results.
#[derive(Debug, Clone, Copy, clap::Args)]
pub(crate) struct PageArguments {
    /// Write a page into the folder of the results, which has everything and needs no network: report.html, of a sweep
    /// sweep.html, of a convergence study converge.html.
    #[arg(long)]
    report: bool,

    /// Write the page, and open it in the browser.
    #[arg(long)]
    open: bool,
}

impl PageArguments {
    /// Whether a page is wanted.
    pub(crate) fn is_wanted(self) -> bool {
        self.report || self.open
    }

    /// The page, which is made if it is wanted.
    ///
    /// # Errors
    /// [`Failure`]: it cannot be made.
    pub(crate) fn made(
        self,
        make: impl FnOnce() -> Result<String, oilwedge_report::Error>,
    ) -> Result<Option<String>, Failure> {
        Ok(self.is_wanted().then(make).transpose()?)
    }

    /// Writes a page into the folder under its name, and opens it where that is wanted; returns the line that says so.
    ///
    /// # Errors
    /// [`Failure`]: it cannot be written.
    pub(crate) fn written(self, folder: &Path, name: &str, page: Option<String>) -> Result<String, Failure> {
        let Some(page) = page else { return Ok(String::new()) };
        replace(folder, &[(OsStr::new(name), Some(page.as_bytes()))])?;
        let path = folder.join(name);
        if self.open {
            open(&path);
        }
        Ok(format!("report    {}\n", path.display()))
    }
}

/// How long a program that finds no browser takes to say so, at most.
const PATIENCE: Duration = Duration::from_secs(1);
/// Time between two looks at that program.
const LOOK: Duration = Duration::from_millis(20);

/// Opens a file in the browser; where there is none, a warning says so.
fn open(path: &Path) {
    let program = match std::env::consts::OS {
        "macos" => "open",
        "windows" => "explorer",
        _ => "xdg-open",
    };
    let command =
        Command::new(program).arg(path).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null()).spawn();
    let reason = match command {
        Err(error) => Some(error.to_string()),
        // The explorer of Windows ends with 1 in any case.
        Ok(_) if program == "explorer" => None,
        Ok(mut started) => failure(&mut started),
    };
    if let Some(reason) = reason {
        complain::warn(&[format!(
            "{} is written, but no browser could be opened: {program}: {reason}",
            path.display()
        )]);
    }
}

/// Why a program that has just been started failed; none if it still runs after [`PATIENCE`].
fn failure(started: &mut Child) -> Option<String> {
    let clock = Instant::now();
    while clock.elapsed() < PATIENCE {
        match started.try_wait() {
            Err(error) => return Some(error.to_string()),
            Ok(Some(status)) => return (!status.success()).then(|| status.to_string()),
            Ok(None) => std::thread::sleep(LOOK),
        }
    }
    None
}

/// Arguments of `oilwedge report`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Report {
    /// A folder with the results of solve, sweep or converge.
    #[arg(value_name = "DIR")]
    of: PathBuf,

    /// Open the page in the browser.
    #[arg(long)]
    open: bool,
}

const EXAMPLES: &str = "\
Examples:
  oilwedge report out/bearing
  oilwedge report out/bearing --open

Writes report.html, sweep.html or converge.html into the folder, a page for the results of each. oilwedge solve, sweep and
converge write theirs too, with --report or --open.

Exit status: 0 done; 2 there are no results, or they cannot be read.";

impl Report {
    /// Writes the pages of all results in the folder.
    ///
    /// # Errors
    /// [`Failure`]: there are no results, or a page cannot be written.
    pub(crate) fn run(&self) -> Result<ExitCode, Failure> {
        let [result, sweep, study] = [RESULT_FILE, SWEEP_FILE, STUDY_FILE].map(|name| self.of.join(name));
        let mut pages = Vec::new();
        if result.is_file() {
            pages.push((PAGE_FILE, self.of_result(&result)?));
        }
        if sweep.is_file() {
            let page = sweep_page(&results(&sweep)?, &[]).map_err(Failure::of_file(&sweep))?;
            pages.push((SWEEP_PAGE_FILE, page));
        }
        if study.is_file() {
            let svg = study.with_extension("svg");
            let svg = svg.is_file().then(|| text(&svg)).transpose()?;
            let page = convergence_page(&results(&study)?, svg.as_deref()).map_err(Failure::of_file(&study))?;
            pages.push((STUDY_PAGE_FILE, page));
        }
        if pages.is_empty() {
            return Err(Failure::Message(format!(
                "{} has no {RESULT_FILE}, {SWEEP_FILE} or {STUDY_FILE}; give a folder of oilwedge solve, sweep or converge",
                self.of.display()
            )));
        }
        let arguments = PageArguments { report: true, open: self.open };
        for (name, page) in pages {
            print(&arguments.written(&self.of, name, Some(page))?, Some(&self.of))?;
        }
        Ok(ExitCode::SUCCESS)
    }

    /// The page of a film or a crankshaft.
    fn of_result(&self, file: &Path) -> Result<String, Failure> {
        let head: ResultHead = results(file)?;
        if head.format == SHAFT_FORMAT {
            let views = ShaftViews::read(&self.of).map_err(Failure::of_file(file))?;
            return shaft_page(&views, &[]).map_err(Failure::of_file(file));
        }
        let ResultFile { result, records } = results(file)?;
        let picture = self.of.join(PICTURE_FILE);
        let picture = match picture.is_file() {
            true => Some(from_vtu(&read(&picture)?).map_err(Failure::of_file(&picture))?),
            false => None,
        };
        let orbit = self.of.join(ORBIT_FILE);
        let course = match orbit.is_file() {
            true => Some(OrbitCourse::from_csv(&read(&orbit)?).map_err(Failure::of_file(&orbit))?),
            false => None,
        };
        let extras = Extras { records: Some(&records), course: course.as_ref(), files: &[] };
        film_page(&result, picture.as_ref(), extras).map_err(Failure::of_file(file))
    }
}
