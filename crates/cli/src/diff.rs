//! `oilwedge diff`: what differs between two scenes or results.

use crate::complain::Failure;
use crate::terminal::output;
use oilwedge_report::difference::{Changed, Difference, of_results};
use oilwedge_report::json;
use oilwedge_report::results::RESULT_FILE;
use oilwedge_report::tables::printable;
use oilwedge_study::RunOptions;
use oilwedge_study::result::{RESULT_FORMAT, ResultHead, RunResult};
use oilwedge_study::shaft::{SHAFT_FORMAT, ShaftResult};
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Arguments of `oilwedge diff`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Diff {
    /// A scene, which is solved, or the folder of its results.
    #[arg(value_name = "A")]
    a: PathBuf,

    /// The scene, or the folder of its results, that is compared with A.
    #[arg(value_name = "B")]
    b: PathBuf,

    /// Print one JSON object instead of tables.
    #[arg(long)]
    json: bool,
}

const EXAMPLES: &str = "\
Examples:
  oilwedge diff before.toml after.toml      changed keys and quantities
  oilwedge diff out/before out/after        of results that are there already
  oilwedge diff a.toml b.toml --json | jq '.quantities[] | select(.exceeds_bars)'

A change exceeds the error bars if it is more than the sum of both: then they do not overlap. A change below round-off is none.
Exit status: 0 equal; 1 different; 2 bad scene, folder or arguments.";

impl Diff {
    /// Prints what differs.
    ///
    /// # Errors
    /// [`Failure`]: a scene or folder cannot be used.
    pub(crate) fn run(&self) -> Result<ExitCode, Failure> {
        let difference = of_results(&result(&self.a)?, &result(&self.b)?)?;
        output(self.json, || json(&difference), || in_words(&difference), None)?;
        Ok(match difference.is_none() {
            true => ExitCode::SUCCESS,
            false => ExitCode::from(1),
        })
    }
}

/// The result in a folder, that of a shaft as one with the numbers of all its bearings, or that of a scene.
fn result(path: &Path) -> Result<RunResult, Failure> {
    if !path.is_dir() {
        let scene = oilwedge_study::read(path)?;
        return Ok(oilwedge_study::run(&scene, &RunOptions::of(&scene)).map_err(Failure::of(path))?.result);
    }
    let file = path.join(RESULT_FILE);
    let cannot = |why: &dyn std::fmt::Display| {
        let file = file.display();
        Failure::Message(format!("cannot read {file}: {why}; give a scene, or a folder of oilwedge solve"))
    };
    let text = std::fs::read_to_string(&file).map_err(|error| cannot(&error))?;
    let of_format = |head: ResultHead| match head.format.as_str() {
        RESULT_FORMAT => serde_json::from_str(&text).map(Some),
        SHAFT_FORMAT => serde_json::from_str::<ShaftResult>(&text).map(|result| Some(result.as_one())),
        _ => Ok(None),
    };
    match serde_json::from_str(&text).and_then(of_format) {
        Ok(Some(result)) => Ok(result),
        Err(error) if !error.is_data() => Err(cannot(&error)),
        _ => Err(cannot(&"it is no result of oilwedge solve")),
    }
}

fn in_words(difference: &Difference) -> String {
    if difference.is_none() {
        return "equal\n".to_owned();
    }
    let mut text = String::new();
    for (name, changed) in [("keys", &difference.keys), ("results", &difference.facts)] {
        for (place, changed) in changed.iter().enumerate() {
            let head = if place == 0 { name } else { "" };
            text += &format!("{head:8}  {}\n", line(changed));
        }
    }
    if !difference.quantities.is_empty() {
        text += &(difference.table() + "\n");
    }
    text
}

/// Digits of a check sum that are shown.
const SUM: usize = 12;

fn line(changed: &Changed) -> String {
    let shown = |value: &Value| match value {
        Value::Null => "absent".to_owned(),
        Value::String(sum) if changed.key.ends_with("sha256") => sum.chars().take(SUM).collect(),
        Value::Array(items) if items.is_empty() => "none".to_owned(),
        value => printable(&value.to_string()),
    };
    format!("{}: {} -> {}", printable(&changed.key), shown(&changed.a), shown(&changed.b))
}
