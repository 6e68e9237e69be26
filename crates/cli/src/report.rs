//! `oilwedge report`: the HTML page of results in a folder; and `--report`, `--open` of other verbs.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitCode, Stdio};
use std::time::{Duration, Instant};

use oilwedge_report::convergence::REPORT_FILE as STUDY_FILE;
use oilwedge_report::folder::replace;
use oilwedge_report::page::{PAGE_FILE, convergence_page, film_page, shaft_page, sweep_page};
use oilwedge_report::results::{PICTURE_FILE, RESULT_FILE};
use oilwedge_report::shaft_view::{ShaftViews, is_of_shaft};
use oilwedge_report::sweep::REPORT_FILE as SWEEP_FILE;
use oilwedge_report::vtu_read::from_vtu;

use crate::complain::{self, Failure};
use crate::plot::{read, text, value};
use crate::terminal::print;

/// Arguments of verbs that write results.
#[derive(Debug, Clone, Copy, clap::Args)]
pub(crate) struct PageArguments {
    /// Write report.html into the folder of the results: one page with everything, which needs no network.
    #[arg(long)]
    report: bool,

    /// Write report.html, and open it in the browser.
    #[arg(long)]
    open: bool,
}

impl PageArguments {
    /// Whether a page is wanted.
    pub(crate) fn is_wanted(self) -> bool {
        self.report || self.open
    }

    /// Writes the page into the folder, and opens it where that is wanted; returns the line that says so.
    ///
    /// # Errors
    /// [`Failure`]: it cannot be written.
    pub(crate) fn written(self, folder: &Path, page: Option<String>) -> Result<String, Failure> {
        let Some(page) = page else { return Ok(String::new()) };
        replace(folder, &[(OsStr::new(PAGE_FILE), Some(page.as_bytes()))])?;
        let path = folder.join(PAGE_FILE);
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
    let command = Command::new(program)
        .arg(path)
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn();
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

Writes report.html into the folder. oilwedge solve, sweep and converge write it too, with --report or --open.

Exit status: 0 done; 2 there are no results, or they cannot be read.";

impl Report {
    /// Writes the page.
    ///
    /// # Errors
    /// [`Failure`]: there are no results, or the page cannot be written.
    pub(crate) fn run(&self) -> Result<ExitCode, Failure> {
        let [result, sweep, study] = [RESULT_FILE, SWEEP_FILE, STUDY_FILE].map(|name| self.of.join(name));
        let page = if result.is_file() {
            self.of_result(&result)?
        } else if sweep.is_file() {
            sweep_page(&value(&text(&sweep)?)?).map_err(Failure::of_file(&sweep))?
        } else if study.is_file() {
            let svg = study.with_extension("svg");
            let svg = svg.is_file().then(|| text(&svg)).transpose()?;
            convergence_page(&value(&text(&study)?)?, svg.as_deref()).map_err(Failure::of_file(&study))?
        } else {
            return Err(Failure::Message(format!(
                "{} has no {RESULT_FILE}, {SWEEP_FILE} or {STUDY_FILE}; give a folder of oilwedge solve, sweep or converge",
                self.of.display()
            )));
        };
        let arguments = PageArguments {
            report: true,
            open: self.open,
        };
        print(&arguments.written(&self.of, Some(page))?, Some(&self.of))?;
        Ok(ExitCode::SUCCESS)
    }

    /// The page of a film or a crankshaft.
    fn of_result(&self, file: &Path) -> Result<String, Failure> {
        let result = value(&text(file)?)?;
        if is_of_shaft(&result) {
            let views = ShaftViews::read(&self.of).map_err(Failure::of_file(file))?;
            return shaft_page(&views).map_err(Failure::of_file(file));
        }
        let picture = self.of.join(PICTURE_FILE);
        let picture = match picture.is_file() {
            true => Some(from_vtu(&read(&picture)?).map_err(Failure::of_file(&picture))?),
            false => None,
        };
        film_page(&result, picture.as_ref()).map_err(Failure::of_file(file))
    }
}
