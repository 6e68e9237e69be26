//! `oilwedge diff`: what differs between two scenes or results.

use crate::complain::{Failure, printable};
use crate::readable::significant;
use crate::terminal::{output, table};
use oilwedge_report::difference::{Changed, ChangedQuantity, Difference, of_results, of_scenes};
use oilwedge_report::results::RESULT_FILE;
use oilwedge_report::{json, result_json};
use oilwedge_study::RunOptions;
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

    /// Another one.
    #[arg(value_name = "B")]
    b: PathBuf,

    /// Print one JSON object instead of tables.
    #[arg(long)]
    json: bool,
}

const EXAMPLES: &str = "\
Examples:
  oilwedge diff before.toml after.toml      changed keys and quantities
  oilwedge diff out/before out/after        of results that are there already; these do not hold the keys of their scenes
  oilwedge diff a.toml b.toml --json | jq '.quantities[] | select(.exceeds_bars)'

A change exceeds the error bars if it is more than the sum of both: then they do not overlap.
Exit status: 0 equal; 1 different; 2 bad scene, folder or arguments.";

/// One side: its result, and the text of its scene where that is at hand.
struct Side {
    result: Value,
    scene: Option<String>,
}

impl Diff {
    /// Prints what differs.
    ///
    /// # Errors
    /// [`Failure`]: a scene or folder cannot be used.
    pub(crate) fn run(&self) -> Result<ExitCode, Failure> {
        let (a, b) = (side(&self.a)?, side(&self.b)?);
        let mut difference = of_results(&a.result, &b.result);
        if let (Some(a), Some(b)) = (&a.scene, &b.scene) {
            difference.keys = of_scenes(a, b)?;
            // A comment makes another text of the same scene.
            difference.facts.retain(|fact| fact.key != "scene_sha256");
        }
        output(self.json, || json(&difference), || in_words(&difference), None)?;
        Ok(match difference.is_none() {
            true => ExitCode::SUCCESS,
            false => ExitCode::from(1),
        })
    }
}

fn side(path: &Path) -> Result<Side, Failure> {
    let cannot = |path: &Path, why: &dyn std::fmt::Display| {
        Failure::Message(format!(
            "cannot read {}: {why}; give a scene, or a folder of oilwedge solve",
            path.display()
        ))
    };
    let value = |path: &Path, text: &str| serde_json::from_str(text).map_err(|error| cannot(path, &error));
    if path.is_dir() {
        let file = path.join(RESULT_FILE);
        let text = std::fs::read_to_string(&file).map_err(|error| cannot(&file, &error))?;
        let result: Value = value(&file, &text)?;
        if !result["quantities"].is_object() {
            return Err(cannot(&file, &"it is no result of oilwedge solve"));
        }
        return Ok(Side { result, scene: None });
    }
    let scene = oilwedge_study::read(path)?;
    let text = std::fs::read_to_string(path).map_err(|error| cannot(path, &error))?;
    let mut options = RunOptions::default();
    if scene.tolerance.is_none() {
        options.max_seconds = f64::INFINITY;
    }
    let run = oilwedge_study::run(&scene, &options).map_err(Failure::of(path))?;
    Ok(Side {
        result: value(path, &result_json(&run.result, &[])?)?,
        scene: Some(text),
    })
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
        let mut rows = table(
            ["quantity", "A", "B", "change", "both bars", "unit", "exceeds the bars"],
            1..5,
        );
        rows.add_rows(difference.quantities.iter().map(cells));
        text += &format!("{rows}\n");
    }
    text
}

fn line(changed: &Changed) -> String {
    let shown = |value: &Value| match value {
        Value::Null => "absent".to_owned(),
        value => printable(&value.to_string()),
    };
    format!(
        "{}: {} -> {}",
        printable(&changed.key),
        shown(&changed.a),
        shown(&changed.b)
    )
}

fn cells(quantity: &ChangedQuantity) -> [String; 7] {
    let number = |number: Option<f64>, digits| number.map_or("none".to_owned(), |number| significant(number, digits));
    let verdict = match quantity.exceeds_bars {
        Some(true) => "yes",
        Some(false) => "no",
        None => "not known",
    };
    [
        printable(&quantity.name),
        number(quantity.a, 6),
        number(quantity.b, 6),
        number(quantity.change, 3),
        number(quantity.bars, 3),
        quantity.unit.clone(),
        verdict.to_owned(),
    ]
}
