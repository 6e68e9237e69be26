//! `oilwedge verify`: this program against known answers and hard cases.

use crate::complain::Failure;
use crate::progress::Progress;
use crate::readable::significant;
use crate::terminal::print;
use oilwedge_report::folder;
use oilwedge_report::plot::to_png;
use oilwedge_report::sweep::Progress as Cases;
use oilwedge_report::tables::{heading, table, time};
use oilwedge_verification::cases::KNOWN_VALUES;
use oilwedge_verification::map::{CELLS, unexplained};
use oilwedge_verification::map_picture::{CellMap, cells_figure};
use oilwedge_verification::page::{page, page_so_far};
use oilwedge_verification::suite::{self, Verdict};
use oilwedge_verification::{run_map, run_suite};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::{Duration, Instant};

/// Arguments of `oilwedge verify`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Verify {
    /// Solve all hard cases and the map of stability, and write the page about them; some minutes.
    #[arg(long)]
    hard: bool,

    /// Only this family of hard cases, without map and page; may be given more than once.
    #[arg(long, value_name = "NAME", conflicts_with = "hard")]
    family: Vec<String>,

    /// Folder of stability.md, stability.svg and stability.png.
    #[arg(long, value_name = "DIR", default_value = "docs/validation", requires = "hard")]
    out: PathBuf,
}

const EXAMPLES: &str = "\
Examples:
  oilwedge verify                      cases with known answers (a second)
  oilwedge verify --hard               all hard cases and the map, to docs/validation/stability.md
  oilwedge verify --family loads       one family of them

Exit status: 0 every case ends as expected; 1 some do not, and are listed with their faults; 2 bad arguments, or the
page cannot be written.";

impl Verify {
    /// Runs the cases, and prints what was found.
    ///
    /// # Errors
    /// [`Failure`]: there is no such family, or the page cannot be written.
    pub(crate) fn run(&self) -> Result<ExitCode, Failure> {
        let clock = Instant::now();
        let names = match (self.hard, self.family.is_empty()) {
            (true, _) => Vec::new(),
            (false, true) => vec![KNOWN_VALUES.to_owned()],
            (false, false) => self.family.clone(),
        };
        let cases = suite::count(&names, true)? + if self.hard { CELLS } else { 0 };
        let mut progress = Progress::of_cases();
        let (kept, mut done) = (0, 0);
        let mut so_far = Draft::default();
        if self.hard {
            // A folder that cannot be written is reported before minutes have passed.
            so_far.write(&self.out, [0, cases])?;
        }
        let mut failure = None;
        let verdicts = run_suite(&names, true, &mut |series| {
            done += series.len();
            progress.cases(Cases { kept, done, cases });
            if self.hard && failure.is_none() {
                so_far.verdicts.extend_from_slice(series);
                progress.line(&line(series, [done, cases], clock));
                failure = so_far.keep(&self.out, [done, cases]).err();
            }
        })?;
        if let Some(failure) = failure {
            return Err(failure);
        }
        let maps = match self.hard {
            true => {
                so_far.write(&self.out, [done, cases])?;
                Vec::from(run_map(&mut |count| {
                    done += count;
                    progress.cases(Cases { kept, done, cases });
                    progress.line(&format!("{done} of {cases} cases, {}: map", time(clock.elapsed().as_secs_f64())));
                })?)
            }
            false => Vec::new(),
        };
        drop(progress);
        let faults = verdicts.iter().filter(|verdict| !verdict.faults.is_empty()).count()
            + maps.iter().flat_map(unexplained).count();
        let mut text = report(&verdicts, &maps, clock.elapsed().as_secs_f64());
        if self.hard {
            self.write(&verdicts, &maps)?;
            text += &format!("written   {}: stability.md, stability.svg, stability.png\n", self.out.display());
        }
        print(&text, self.hard.then_some(self.out.as_path()))?;
        Ok(if faults == 0 { ExitCode::SUCCESS } else { ExitCode::from(1) })
    }

    fn write(&self, verdicts: &[Verdict], maps: &[CellMap]) -> Result<(), Failure> {
        let figure = cells_figure(maps);
        let (svg, png) = (figure.to_svg(), to_png(&figure)?);
        let text = page(verdicts, maps, PICTURES[1]);
        let files = [
            (PICTURES[0].as_ref(), Some(svg.as_bytes())),
            (PICTURES[1].as_ref(), Some(&png[..])),
            (PAGE.as_ref(), Some(text.as_bytes())),
        ];
        Ok(folder::replace(&self.out, &files)?)
    }
}

/// How far the suite has got, and which series ended.
fn line(series: &[Verdict], [done, cases]: [usize; 2], clock: Instant) -> String {
    let name = |verdict: &Verdict| format!("{}, {}", verdict.case.family, verdict.case.series);
    let name = series.first().map_or(String::new(), name);
    format!("{done} of {cases} cases, {}: {name}", time(clock.elapsed().as_secs_f64()))
}

/// Time between two pages of a suite that is running.
const INTERVAL: Duration = Duration::from_secs(1);

/// The page of a suite that is running.
#[derive(Default)]
struct Draft {
    verdicts: Vec<Verdict>,
    written: Option<Instant>,
}

impl Draft {
    /// Writes the page if the last one is old.
    fn keep(&mut self, folder: &Path, progress: [usize; 2]) -> Result<(), Failure> {
        match self.written {
            Some(written) if written.elapsed() < INTERVAL => Ok(()),
            _ => self.write(folder, progress),
        }
    }

    /// Writes the page, whole or not at all. Pictures of an earlier run are taken away.
    fn write(&mut self, folder: &Path, progress: [usize; 2]) -> Result<(), Failure> {
        let text = page_so_far(&self.verdicts, progress);
        let files =
            [(PICTURES[0].as_ref(), None), (PICTURES[1].as_ref(), None), (PAGE.as_ref(), Some(text.as_bytes()))];
        folder::replace(folder, &files)?;
        self.written = Some(Instant::now());
        Ok(())
    }
}

/// File of the page.
const PAGE: &str = "stability.md";
/// File of the picture of the page.
const PICTURES: [&str; 2] = ["stability.svg", "stability.png"];

/// Computed numbers beside known ones, in a table; nothing where there are none.
fn known_values(verdicts: &[Verdict]) -> String {
    let mut cells = table(["case", "quantity", "known", "computed", "± error", "difference", "unit"], 2..6);
    let mut is_empty = true;
    for verdict in verdicts {
        for it in &verdict.known {
            let (computed, bar) = it.computed;
            cells.add_row([
                verdict.case.name(),
                it.quantity.clone(),
                significant(it.known, 6),
                significant(computed, 6),
                significant(bar, 2),
                significant(it.difference, 2),
                it.unit.to_owned(),
            ]);
            is_empty = false;
        }
    }
    match is_empty {
        true => String::new(),
        false => format!("\n{cells}\n"),
    }
}

/// The cases in a table, their faults below it.
fn report(verdicts: &[Verdict], maps: &[CellMap], seconds: f64) -> String {
    let mut cells = table(["case", "ends", "seconds", "load [N]", "bar", "compared with"], 2..5);
    let number = |value: Option<f64>, digits| value.map_or(String::new(), |value| significant(value, digits));
    for verdict in verdicts {
        let mark = if verdict.faults.is_empty() { "" } else { "! " };
        cells.add_row([
            format!("{mark}{}", verdict.case.name()),
            verdict.end.name().to_owned(),
            format!("{:.2}", verdict.seconds),
            number(verdict.load.map(|(load, _)| load), 5),
            number(verdict.load.and_then(|(_, bar)| bar), 2),
            verdict.against.clone(),
        ]);
    }
    let known = known_values(verdicts);
    let faulty: Vec<&Verdict> = verdicts.iter().filter(|verdict| !verdict.faults.is_empty()).collect();
    let outcome = match faulty.len() {
        0 => "all as expected".to_owned(),
        count => format!("{count} unexplained"),
    };
    let mut text = heading("Verification", &format!("{} cases, {outcome}", verdicts.len()))
        + "\n\n"
        + &cells.to_string()
        + "\n"
        + &known;
    for verdict in faulty {
        text += &format!("\n! {} ({})\n", verdict.case.name(), verdict.case.family);
        text += &verdict.faults.iter().map(|fault| format!("    {fault}\n")).collect::<String>();
    }
    for cell in maps.iter().flat_map(unexplained) {
        text += &format!("\n! map: {cell}\n");
    }
    text + &format!("\ntime      {}\n", time(seconds))
}
