//! `oilwedge load`: the load of a journal over a cycle, alone.

use crate::complain::Failure;
use crate::plot;
use crate::readable::significant;
use crate::run_options::folder;
use crate::terminal::output;
use oilwedge_drawing::PAGE_WIDTH;
use oilwedge_report::folder::replace;
use oilwedge_report::json;
use oilwedge_report::load_sheet::{LoadAt, LoadSheet};
use oilwedge_report::plot::load_figures;
use oilwedge_report::sheet::{Sheet, numeral, text};
use oilwedge_report::tables::printable;
use oilwedge_scene::wording::{degrees, percent};
use oilwedge_study::duty::duty_cycle;
use std::f64::consts::PI;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Parts of the load at half the speed of the journal that are no more than this are not shown [1].
const LEAST_SHARE: f64 = 1e-3;

/// Arguments of `oilwedge load`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct LoadCommand {
    /// The scene, whose load changes over a cycle: [load] with file, harmonics or bearing.
    #[arg(value_name = "SCENE")]
    scene: PathBuf,

    /// Folder of the results [default: out/NAME for NAME.toml].
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,

    /// Print one JSON object instead of a table.
    #[arg(long)]
    json: bool,
}

const EXAMPLES: &str = "\
Examples:
  oilwedge load big_end.toml
  oilwedge load big_end.toml --out results/load
  oilwedge load big_end.toml --json | jq .peak

Writes load.json, and the load over the crank angle and its polar diagrams as SVG and PNG. No film is solved.
Exit status: 0 done; 2 bad scene, table or arguments (nothing was written).";

/// The file of the numbers.
const LOAD_FILE: &str = "load.json";

impl LoadCommand {
    /// Prints and draws the load.
    ///
    /// # Errors
    /// [`Failure`]: the scene or a table cannot be used, the load does not change, or the results cannot be written.
    pub(crate) fn run(&self) -> Result<ExitCode, Failure> {
        let scene = oilwedge_study::read(&self.scene)?;
        let message = |message: String| Failure::Message(format!("{}: {message}", self.scene.display()));
        let cycle = duty_cycle(&scene).map_err(|error| message(error.to_string()))?.ok_or_else(|| {
            message(
                "there is no load over a cycle; give [load] with file and frame, harmonics and frame, or bearing = \"big-end\", and period = \"720 deg\""
                    .to_owned(),
            )
        })?;
        let sheet = LoadSheet::of(&scene, &cycle);
        let text = json(&sheet)?;
        let figures = load_figures(&scene.title, &cycle, PAGE_WIDTH);
        let folder = folder(&self.out, &self.scene);
        replace(&folder, &[(LOAD_FILE.as_ref(), Some(text.as_bytes()))])?;
        let drawn = plot::written(&folder, &figures)?;
        output(self.json, || Ok(text), || in_words(&sheet, &folder, &drawn), Some(&folder))?;
        Ok(ExitCode::SUCCESS)
    }
}

fn in_words(sheet: &LoadSheet, folder: &Path, drawn: &str) -> String {
    let angle = if sheet.frequency_hz.is_some() { "angle of the load" } else { "crank angle" };
    let mut rows = Vec::new();
    let mut add = |name: &str, value: String, at: Option<(f64, f64)>| {
        // Without the sign of a zero.
        let angle = |angle: f64| format!("{:.2} deg", (100.0 * angle).round() / 100.0 + 0.0);
        let [at, direction] = at.map_or([String::new(), String::new()], |(at, direction)| {
            [if at.is_nan() { String::new() } else { angle(at) }, angle(direction)]
        });
        rows.push(vec![text(name), numeral(value), numeral(at), numeral(direction)]);
    };
    let newtons = |force: f64| match force < 1e3 {
        true => format!("{} N", significant(force, 6)),
        false => format!("{} kN", significant(1e-3 * force, 6)),
    };
    let of = |at: &LoadAt| Some((at.angle_deg, at.direction_deg));
    add("greatest force", newtons(sheet.peak.magnitude_n), of(&sheet.peak));
    add("least force", newtons(sheet.least.magnitude_n), of(&sheet.least));
    let mean = |[x, y]: [f64; 2]| (newtons(x.hypot(y)), Some((f64::NAN, y.atan2(x).to_degrees())));
    let (value, direction) = mean(sheet.mean_force_n);
    add("mean force", value, direction);
    add("mean magnitude", newtons(sheet.mean_magnitude_n), None);
    // The curve between the rows of a table beside the rows alone.
    if let Some(table) = &sheet.table {
        add(&format!("greatest force of the {} rows", table.rows), newtons(table.peak.magnitude_n), of(&table.peak));
        let (value, direction) = mean(table.mean_force_n);
        add("mean force of the rows", value, direction);
        add("mean magnitude of the rows", newtons(table.mean_magnitude_n), None);
    }
    add("greatest force/(length diameter)", format!("{} MPa", significant(1e-6 * sheet.specific_load_pa, 4)), None);
    if sheet.greatest_moment_n_m > 0.0 {
        add("greatest moment", format!("{} N.m", significant(sheet.greatest_moment_n_m, 4)), None);
    }
    if sheet.half_speed_share > LEAST_SHARE {
        add(
            "at half the speed of the journal",
            format!("{} of the mean magnitude", percent(sheet.half_speed_share)),
            None,
        );
    }
    let [least, greatest] = sheet.journal_speed_rad_s;
    let speed = match greatest - least > 1e-9 * greatest.abs() {
        true => format!("{} to {} rad/s", significant(least, 5), significant(greatest, 5)),
        false => format!("{} rad/s", significant(greatest, 5)),
    };
    add("speed of the journal against the shell", speed, None);
    if let Some(work) = sheet.gas_work_j {
        add("work of the gas in a period", format!("{} J", significant(work, 7)), None);
    }
    let period = match sheet.frequency_hz {
        Some(frequency) => format!("load that repeats at {} Hz", significant(frequency, 6)),
        None => format!(
            "load over {} of the crank angle at {} rpm",
            degrees(sheet.period_deg.to_radians()),
            (sheet.crank_speed_rad_s * 30e3 / PI).round() / 1e3
        ),
    };
    let table = Sheet::new("", ["", "value", angle, "direction"], rows).terminal();
    format!(
        "{}: {period}, in the frame of the shell\n\n{table}\n\nresults   {}\n{drawn}",
        printable(&sheet.title),
        folder.join(LOAD_FILE).display()
    )
}
