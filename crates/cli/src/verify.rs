//! `oilwedge verify`: this program against known answers and hard cases.

use crate::complain::Failure;
use crate::progress::ProgressLine;
use crate::readable::significant;
use crate::terminal::print;
use oilwedge_campaign::{Alternative, Comparison, QuantityPair};
use oilwedge_report::sheet::{Sheet, none, number_as, text};
use oilwedge_report::sweep::Progress as Cases;
use oilwedge_report::tables::{heading, time};
use oilwedge_report::{comparison, folder};
use oilwedge_study::quantities::{LOAD, Quantity};
use oilwedge_verification::cases::KNOWN_VALUES;
use oilwedge_verification::run_suite;
use oilwedge_verification::suite::{self, CaseVerdict};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::{Duration, Instant};

/// Arguments of `oilwedge verify`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Verify {
    /// Solve all hard cases, and write the page about them; some minutes.
    #[arg(long)]
    hard: bool,

    /// Only this family of hard cases, without the page; may be given more than once.
    #[arg(long, value_name = "NAME", conflicts_with = "hard")]
    family: Vec<String>,

    /// Folder of stability.md.
    #[arg(long, value_name = "DIR", default_value = "out/verify", requires = "hard")]
    out: PathBuf,
}

const EXAMPLES: &str = "\
Examples:
  oilwedge verify                      cases with known answers (a second)
  oilwedge verify --hard               all hard cases, to out/verify/stability.md
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
        let cases = suite::count(&names, true)?;
        let mut progress = ProgressLine::of_cases();
        let mut so_far: Vec<CaseVerdict> = Vec::new();
        if self.hard {
            // A folder that cannot be written is reported before minutes have passed.
            write(&self.out, &so_far, cases)?;
        }
        let (mut written, mut failure) = (Instant::now(), None);
        let verdicts = run_suite(&names, true, &mut |series| {
            so_far.extend_from_slice(series);
            let done = so_far.len();
            progress.cases(Cases { kept: 0, done, cases });
            if self.hard && failure.is_none() && written.elapsed() > INTERVAL {
                progress.line(&line(series, [done, cases], clock));
                failure = write(&self.out, &so_far, cases).err();
                written = Instant::now();
            }
        })?;
        if let Some(failure) = failure {
            return Err(failure);
        }
        drop(progress);
        let outcome = format!("{} cases, {}", verdicts.len(), outcome(&verdicts));
        let mut told = heading("Verification", &outcome) + "\n\n" + &ends(&verdicts).terminal() + "\n";
        told += &known_values(&verdicts).map_or(String::new(), |known| format!("\n{}\n", known.terminal()));
        told += &format!("\ntime      {}\n", time(clock.elapsed().as_secs_f64()));
        if self.hard {
            write(&self.out, &verdicts, cases)?;
            told += &format!("written   {}: {PAGE}\n", self.out.display());
        }
        print(&told, self.hard.then_some(self.out.as_path()))?;
        Ok(ExitCode::from(u8::from(verdicts.iter().any(|verdict| !verdict.faults.is_empty()))))
    }
}

/// How far the suite has got, and which series ended.
fn line(series: &[CaseVerdict], [done, cases]: [usize; 2], clock: Instant) -> String {
    let name = |verdict: &CaseVerdict| format!("{}, {}", verdict.case.family, verdict.case.series);
    let name = series.first().map_or(String::new(), name);
    format!("{done} of {cases} cases, {}: {name}", time(clock.elapsed().as_secs_f64()))
}

/// Time between two pages of a suite that is running.
const INTERVAL: Duration = Duration::from_secs(1);
/// File of the page.
const PAGE: &str = "stability.md";

/// Writes the page of the cases that have ended, whole or not at all.
fn write(folder: &Path, verdicts: &[CaseVerdict], cases: usize) -> Result<(), Failure> {
    let note = match verdicts.len() == cases {
        true => format!("{cases} cases, {}.", outcome(verdicts)),
        false => {
            format!("**Incomplete: {} of {cases} cases.** The run has not ended, or was ended early.", verdicts.len())
        }
    };
    let page = format!("# Hard cases\n\n{note}\n\n{}", ends(verdicts).markdown());
    Ok(folder::replace(folder, &[(PAGE.as_ref(), Some(page.as_bytes()))])?)
}

fn outcome(verdicts: &[CaseVerdict]) -> String {
    match verdicts.iter().filter(|verdict| !verdict.faults.is_empty()).count() {
        0 => "all as expected".to_owned(),
        count => format!("{count} unexplained"),
    }
}

/// Computed numbers beside known ones; nothing where there are none.
fn known_values(verdicts: &[CaseVerdict]) -> Option<Sheet> {
    let named = |verdict: &CaseVerdict, it: &QuantityPair| QuantityPair {
        name: format!("{}: {}", verdict.case.name(), it.name),
        ..it.clone()
    };
    let pairs = verdicts.iter().flat_map(|verdict| verdict.known.iter().map(|it| named(verdict, it))).collect();
    let computed = Alternative { name: "computed".to_owned(), pairs, seconds: None };
    let known = Comparison { film: "known".to_owned(), alternatives: vec![computed], ..Comparison::default() };
    Some(comparison::sheet(&known)).filter(|sheet| !sheet.rows.is_empty())
}

/// How the cases ended, their faults below.
fn ends(verdicts: &[CaseVerdict]) -> Sheet {
    let row = |verdict: &CaseVerdict| {
        let mark = if verdict.faults.is_empty() { "" } else { "! " };
        let load = verdict.result.as_ref().and_then(|result| result.quantity(&LOAD));
        let number =
            |value: Option<f64>, digits| value.map_or_else(none, |value| number_as(value, significant(value, digits)));
        vec![
            text(format!("{mark}{}", verdict.case.name())),
            text(verdict.end.name()),
            number_as(verdict.seconds, format!("{:.2}", verdict.seconds)),
            number(load.map(|load| load.value), 5),
            number(load.and_then(Quantity::error), 2),
            text(verdict.against.as_str()),
        ]
    };
    let header = ["case", "ends", "seconds", "load [N]", "bar", "compared with"];
    let mut sheet = Sheet::new("", header, verdicts.iter().map(row).collect());
    for verdict in verdicts.iter().filter(|verdict| !verdict.faults.is_empty()) {
        let name = format!("! {} ({}):", verdict.case.name(), verdict.case.family);
        sheet.notes.push(format!("{name} {}", verdict.faults.join("; ")));
    }
    sheet
}
