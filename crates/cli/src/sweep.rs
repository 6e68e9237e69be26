//! `oilwedge sweep`: one scene for many values of its keys, to a table.

use crate::complain::{Failure, warn};
use crate::crankshaft::is_crankshaft;
use crate::interrupt;
use crate::plot;
use crate::progress::ProgressLine;
use crate::report::PageArguments;
use crate::run_options::RunArguments;
use crate::terminal::output;
use oilwedge_campaign::sweep::{Forecast, Part, Sweep as Cases};
use oilwedge_report::json;
use oilwedge_report::page::{SWEEP_PAGE_FILE, SceneFile, sweep_page};
use oilwedge_report::sweep::{Notice, SweepError, SweepOptions, SweepReport, SweepResult, part_folder};
use oilwedge_report::tables::{counted, duration, sweep_report};
use oilwedge_scene::sweep::{DrawLaw, DrawOptions, MOST_CASES, Plan};
use oilwedge_scene::{Scene, ShaftScene};
use oilwedge_study::RunOptions;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Arguments of `oilwedge sweep`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct SweepCommand {
    #[command(flatten)]
    run: RunArguments,

    /// Draw the tolerances of the scene N times, at each point of its [sweep] or, without one, of the scene itself, and
    /// report how the quantities are distributed.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(2..=100_000))]
    draws: Option<u32>,

    /// Number by which other draws are made.
    #[arg(long, value_name = "N", default_value_t = 1, requires = "draws")]
    seed: u64,

    /// Draw from normal distributions, half of a tolerance being three deviations, and not uniformly.
    #[arg(long, requires = "draws")]
    normal: bool,

    /// Replace a sweep that stands in the folder, also if it is that of another scene.
    #[arg(long)]
    fresh: bool,

    /// Compute one of N parts of the sweep, for machines that share it, into the folder parts/K-of-N below that of the
    /// results. Each part is a number of whole chains of neighbouring cases.
    #[arg(long, value_name = "K/N", value_parser = part, conflicts_with_all = ["plot", "report", "open"])]
    part: Option<Part>,

    /// Join the parts in the folder parts below DIR to the table of the whole sweep, in DIR or in the folder of --out.
    /// Nothing is computed.
    #[arg(long, value_name = "DIR", conflicts_with_all = ["part", "max_seconds", "max_unknowns"])]
    join: Option<PathBuf>,

    /// Draw the quantities over the axes into the folder plot of the results.
    #[arg(long)]
    plot: bool,

    #[command(flatten)]
    page: PageArguments,
}

const EXAMPLES: &str = "\
Examples:
  oilwedge sweep bearing.toml
  oilwedge sweep bearing.toml --bars none --out results/map
  oilwedge sweep bearing.toml --part 3/40 --out map      one of 40 jobs of a cluster
  oilwedge sweep bearing.toml --join map                 the table of all their cases
  oilwedge sweep bearing.toml --draws 500 --bars none    numbers as \"27 um +- 3 um\" are drawn
  oilwedge sweep bearing.toml --json | jq '.rows[] | [.inputs.speed, .quantities.load.value]'

In the scene, each axis a list or a range, the last one running fastest:
  [sweep]
  force = { from = \"1 kN\", to = \"9 kN\", steps = 9 }
  speed = [\"1000 rpm\", \"2000 rpm\", \"4000 rpm\"]
  columns = [\"h_min um\", \"p_max bar\", \"friction_power W\"]     by default the main ones, all in sweep.csv

Rows are written as cases end. The same command continues a sweep that was killed or ended by Ctrl-C.

Exit status: 0 all cases are in the table, also those without a film (their row has the reason); 1 no case has an
answer (not with --part); 2 bad scene, mesh or arguments, or another sweep in the folder; 130 ended by Ctrl-C with its rows kept.";

impl SweepCommand {
    /// Runs the sweep, and prints it.
    ///
    /// # Errors
    /// [`Failure`]: the scene or a case of it cannot be used, or the table cannot be written.
    pub(crate) fn run(&self) -> Result<ExitCode, Failure> {
        let (cases, case) = self.read()?;
        let options = SweepOptions { case, fresh: self.fresh, part: self.part };
        let folder = self.folder();
        warn(&repeated(&cases));
        warn(&self.part.and_then(|part| empty(&cases, part)).into_iter().collect::<Vec<_>>());
        let report = match &self.join {
            Some(parts) => oilwedge_report::sweep::join(&cases, &options, parts, &folder)?,
            None => computed(&cases, &options, &folder)?,
        };
        let figures = match self.plot {
            true => plot::figures_of_sweep(&SweepResult::from(&report), &plot::usual())?,
            false => Vec::new(),
        };
        let files = || SceneFile::all(&report.plan.text, &self.run.scene);
        let page = self.page.made(|| sweep_page(&SweepResult::from(&report), &files()))?;
        let drawn = plot::written(&folder, &figures)? + &self.page.written(&folder, SWEEP_PAGE_FILE, page)?;
        let written = self.part.map_or(folder.clone(), |part| part_folder(&folder, part));
        output(self.run.json, || json(&report), || sweep_report(&report, Some(&written)) + &drawn, Some(&written))?;
        // A part is a job among others: whether the sweep has an answer is known when they are joined.
        Ok(match self.part.is_some() || report.rows.iter().any(|row| report.has_answer(row)) {
            true => ExitCode::SUCCESS,
            false => ExitCode::from(1),
        })
    }

    /// The cases of the scene, of one bearing or of a crankshaft, and how each is run.
    fn read(&self) -> Result<(Cases, RunOptions), Failure> {
        let path = &self.run.scene;
        let (cases, options, example) = match oilwedge_study::read(path) {
            Err(error) if is_crankshaft(&error) => {
                if self.draws.is_some() {
                    let path = path.display();
                    return Err(Failure::Message(format!(
                        "the scene {path} is one of a crankshaft, whose numbers have no tolerances; leave out --draws"
                    )));
                }
                let scene = ShaftScene::read(path)?;
                let options = RunOptions { interrupt: interrupt::listen_in_time(KEPT)?, ..self.run.options_of_shaft() };
                let example = "speed = { from = \"1000 rpm\", to = \"6000 rpm\", steps = 6 }";
                (Cases::of_shaft(&scene)?, options, example)
            }
            scene => {
                let scene = scene?;
                let options = self.run.options(&scene, interrupt::listen_in_time(KEPT)?)?;
                if let Some(count) = self.draws {
                    return Ok((self.drawn(&scene, count as usize)?, options));
                }
                (Cases::of(&scene)?, options, "eccentricity = { from = 0.1, to = 0.95, steps = 18 }")
            }
        };
        let cases = cases.ok_or_else(|| {
            let path = path.display();
            Failure::Message(format!("the scene {path} has no [sweep]; write for example\n\n[sweep]\n{example}"))
        })?;
        Ok((cases, options))
    }

    /// The cases in which the tolerances of a scene are drawn so many times.
    fn drawn(&self, scene: &Scene, count: usize) -> Result<Cases, Failure> {
        let law = if self.normal { DrawLaw::Normal } else { DrawLaw::Uniform };
        let points = scene.sweep.as_ref().map_or(1, Plan::cases);
        if points * count > MOST_CASES {
            let message =
                format!("{points} points with {count} draws are more than {MOST_CASES} cases; give fewer --draws");
            return Err(Failure::Message(message));
        }
        Cases::drawn(scene, DrawOptions { count, seed: self.seed, law })?.ok_or_else(|| {
            let path = self.run.scene.display();
            Failure::Message(format!(
                "the scene {path} has no tolerances to draw; write for example clearance = \"27 um +- 3 um\""
            ))
        })
    }

    /// The folder of the sweep.
    fn folder(&self) -> PathBuf {
        let joined = self.join.clone().filter(|_| self.run.out.is_none());
        joined.unwrap_or_else(|| self.run.folder())
    }
}

/// What is said where a case takes long to end.
const KEPT: &str = "the cases that ended before are kept; the same command goes on with the missing cases";

/// Computes a sweep or a part of it, and shows how far it has got.
fn computed(cases: &Cases, options: &SweepOptions, folder: &Path) -> Result<SweepReport, SweepError> {
    let mut progress = ProgressLine::of_cases();
    let notify = &mut |notice: Notice| match notice {
        Notice::Forecast(forecast) => progress.say(&words(&forecast)),
        Notice::Progress(now) => progress.cases(now),
    };
    oilwedge_report::sweep::run(cases, options, folder, notify)
}

/// A part as it is written: its number and how many there are.
fn part(text: &str) -> Result<Part, String> {
    let part = text.split_once('/').and_then(|(number, of)| Part::new(number.parse().ok()?, of.parse().ok()?));
    part.ok_or_else(|| format!("a part is written K/N, such as 3/40, with 1 <= K <= N and N at most {}", Part::MOST))
}

/// The complaint that a part has no case, if so.
fn empty(cases: &Cases, part: Part) -> Option<String> {
    cases.cases_of(part).is_empty().then(|| {
        format!(
            "part {part} has no case: parts hold whole chains, and the sweep has {}; give at most as many parts",
            counted(cases.chains().len(), "chain")
        )
    })
}

/// Values that an axis has more than once.
fn repeated(cases: &Cases) -> Vec<String> {
    let words = |(value, count): (String, usize)| {
        format!("[sweep] {value} stands there {count} times: its cases are computed as often; remove the others")
    };
    cases.plan.repeated().into_iter().map(words).collect()
}

/// How long a sweep will take.
fn words(forecast: &Forecast) -> String {
    format!(
        "{}, about {} on {}",
        counted(forecast.cases, "case"),
        duration(forecast.seconds),
        counted(forecast.threads, "thread")
    )
}
