//! `oilwedge sweep`: one scene for many values of its keys, to a table.

use crate::complain::{Failure, printable};
use crate::progress::SweepProgress;
use crate::readable::{readable_unit, significant};
use crate::terminal::{align_right, heading, table, time};
use crate::{interrupt, solve, terminal};
use oilwedge_campaign::sweep::Sweep as Cases;
use oilwedge_report::Error;
use oilwedge_report::sweep::{Row, SweepOptions, SweepReport};
use oilwedge_scene::Scene;
use oilwedge_study::RunOptions;
use oilwedge_study::quantities::{self, ATTITUDE_ANGLE, ECCENTRICITY, FILM_THICKNESS_MIN, LOAD, PRESSURE_MAX};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Arguments of `oilwedge sweep`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Sweep {
    /// The scene: a TOML file that describes one bearing, with a table [sweep].
    #[arg(value_name = "SCENE")]
    scene: PathBuf,

    /// Folder of sweep.csv and sweep.json [default: out/NAME for NAME.toml]. A sweep that was ended there is taken up again.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,

    /// Replace a sweep that stands in the folder, also if it is that of another scene.
    #[arg(long)]
    fresh: bool,

    /// Print the sweep as one JSON object instead of tables.
    #[arg(long)]
    json: bool,

    /// Estimate error bars, or none (not with a tolerance in the scene).
    #[arg(long, value_enum, default_value_t = solve::Bars::Auto)]
    bars: solve::Bars,

    /// End the refinement of a case towards a tolerance, and the search for its position under a load, after this many seconds
    /// [default: 60 with a tolerance, else none].
    #[arg(long, value_name = "S", value_parser = solve::seconds)]
    max_seconds: Option<f64>,

    /// Refine a case towards a tolerance to this many unknowns at most; its first mesh, and one that the scene gives, may have more.
    #[arg(long, value_name = "N", default_value_t = 1_000_000, value_parser = solve::unknowns)]
    max_unknowns: usize,
}

const EXAMPLES: &str = "\
Examples:
  oilwedge sweep bearing.toml
  oilwedge sweep bearing.toml --bars none --out results/map
  oilwedge sweep bearing.toml --json | jq '.rows[] | [.inputs.speed, .quantities.load.value]'

In the scene, each axis a list or a range, the last one running fastest:
  [sweep]
  force = { from = \"1 kN\", to = \"9 kN\", steps = 9 }
  speed = [\"1000 rpm\", \"2000 rpm\", \"4000 rpm\"]

Rows are written as cases end. A sweep that was killed or ended by Ctrl-C goes on where it was when the same command is given again.

Exit status: 0 all cases are in the table, also those without a film (their row has the reason); 1 no case has an
answer; 2 bad scene, mesh or arguments, or another sweep in the folder; 130 ended by Ctrl-C with its rows kept.";

impl Sweep {
    /// Runs the sweep, and prints it.
    ///
    /// # Errors
    /// [`Failure`]: the scene or a case of it cannot be used, or the table cannot be written.
    pub(crate) fn run(&self) -> Result<ExitCode, Failure> {
        let scene = oilwedge_study::read(&self.scene)?;
        let options = self.options(&scene)?;
        let Some(cases) = Cases::of(&scene)? else {
            return Err(Failure::Argument {
                message: format!(
                    "the scene {} has no [sweep]; write for example\n\n[sweep]\neccentricity = {{ from = 0.1, to = 0.95, steps = 18 }}",
                    self.scene.display()
                ),
            });
        };
        let folder = self.out.clone().unwrap_or_else(|| solve::default_folder(&self.scene));
        let mut progress = SweepProgress::new();
        let outcome = oilwedge_report::sweep::run(&cases, &options, &folder, &mut |now| progress.move_on(now));
        progress.end();
        let report = outcome?;
        match self.json {
            true => terminal::print(&oilwedge_report::json(&report).map_err(Error::from)?, Some(&folder))?,
            false => terminal::print(&sweep_report(&report, &folder), Some(&folder))?,
        }
        Ok(
            match report.rows.iter().any(|row| report.value(row, LOAD.name).is_some()) {
                true => ExitCode::SUCCESS,
                false => ExitCode::from(1),
            },
        )
    }

    fn options(&self, scene: &Scene) -> Result<SweepOptions, Failure> {
        let bars = solve::wanted_bars(self.bars, scene, &self.scene)?;
        Ok(SweepOptions {
            case: RunOptions {
                bars,
                max_seconds: solve::time_limit(self.max_seconds, scene),
                max_unknowns: self.max_unknowns,
                interrupt: interrupt::listen()?,
                ..RunOptions::default()
            },
            fresh: self.fresh,
        })
    }
}

/// Rows that are shown; of more the first and the last.
const SHOWN: usize = 24;
/// Quantities that are shown.
const COLUMNS: [&quantities::Row; 5] = [
    &LOAD,
    &ECCENTRICITY,
    &ATTITUDE_ANGLE,
    &PRESSURE_MAX,
    &FILM_THICKNESS_MIN,
];
/// Digits of a number without a bar.
const DIGITS: usize = 5;

/// The main numbers of a sweep, for people.
fn sweep_report(report: &SweepReport, folder: &Path) -> String {
    let cases = report.rows.len();
    let ended = |status, words| match report.count(status) {
        0 => None,
        count => Some(format!("{count} {words}")),
    };
    let counts: Vec<String> = [
        ended("converged", "converged"),
        ended("no_solution", "without a solution"),
        ended("not_converged", "not converged"),
        ended("bad_scene", "that do not fit their mesh"),
    ]
    .into_iter()
    .flatten()
    .collect();
    let mut parts = vec![
        heading(&report.identity.title, &format!("{cases} cases, {}", counts.join(", "))),
        terminal::effects(&report.effects),
        rows(report),
    ];
    let own = cases - report.kept;
    let mut lines = Vec::new();
    if report.kept > 0 {
        lines.push(format!("kept      {} cases of an earlier run", report.kept));
    }
    let each = report.seconds / own.max(1) as f64;
    lines.push(match own {
        0 => format!("time      {}: nothing was left to compute", time(report.seconds)),
        _ => format!("time      {}: {} a case", time(report.seconds), time(each)),
    });
    lines.push(format!("written   {}: sweep.csv, sweep.json", folder.display()));
    parts.push(lines.join("\n"));
    parts.join("\n\n") + "\n"
}

fn rows(report: &SweepReport) -> String {
    let columns: Vec<_> = (COLUMNS.iter())
        .filter_map(|&shown| {
            let quantities::Row { name, symbol, unit, .. } = shown;
            report.columns.quantity(name)?;
            let values = report.rows.iter().filter_map(|row| report.value(row, name));
            let (unit, size) = readable_unit(values.map(f64::abs).fold(0.0, f64::max), unit.name());
            let heading = match unit {
                "" => (*symbol).to_owned(),
                unit => format!("{symbol} [{unit}]"),
            };
            Some((*name, heading, size))
        })
        .collect();
    let mut table = table(["case"]);
    let inputs = report.columns.inputs.iter().map(|input| printable(input));
    let headings = columns.iter().map(|(_, heading, _)| heading.clone());
    let header: Vec<String> = ["case".to_owned()].into_iter().chain(inputs).chain(headings).collect();
    let width = header.len();
    table.set_header(header);
    let inputs = report.columns.inputs.len();
    let mut add = |row: &Row| {
        let mut cells: Vec<String> = row[..=inputs].iter().map(|cell| printable(cell)).collect();
        let numbers = columns.iter().map(|(name, _, size)| {
            let value = report.value(row, name);
            value.map_or("-".to_owned(), |value| significant(value / size, DIGITS))
        });
        cells.extend(numbers);
        table.add_row(cells);
    };
    let cut = report.rows.len() > SHOWN;
    let (first, last) = match cut {
        true => (&report.rows[..SHOWN / 2], &report.rows[report.rows.len() - SHOWN / 2..]),
        false => (&report.rows[..], &report.rows[..0]),
    };
    first.iter().for_each(&mut add);
    last.iter().for_each(&mut add);
    (0..width).for_each(|column| align_right(&mut table, column));
    let mut text = table.to_string();
    if cut {
        text += &format!(
            "\nthe first and the last {} of {} cases; all are in sweep.csv",
            SHOWN / 2,
            report.rows.len()
        );
    }
    let reasons = report.rows.iter().filter(|row| !row[row.len() - 2].is_empty());
    for row in reasons.take(REASONS) {
        text += &format!("\ncase {}: {}", row[0], printable(&row[row.len() - 2]));
    }
    text
}

/// Reasons that are told.
const REASONS: usize = 3;
