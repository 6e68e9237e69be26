//! What a sweep found, as scripts read it: `sweep.json`.

use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

use super::table::{Columns, Row};
use oilwedge_scene::sweep::{AxisValue, Plan};
use oilwedge_study::effects::Effects;

/// Name and version of the form of `sweep.json`.
pub const SWEEP_FORMAT: &str = "oilwedge-sweep/1";

/// What a sweep is computed from: rows of another one are not its own.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Identity {
    /// [`SWEEP_FORMAT`].
    pub format: String,
    /// Title of the scene.
    pub title: String,
    /// Version of the program.
    pub version: String,
    /// SHA-256 of the scene's text, hexadecimal.
    pub scene_sha256: String,
    /// SHA-256 of the mesh files, hexadecimal; `None` where meshes are drawn.
    pub mesh_sha256: Option<String>,
    /// Whether error bars are estimated.
    pub bars: bool,
    /// Number of cases.
    pub cases: usize,
}

/// Everything that a sweep found.
#[derive(Debug, Clone, PartialEq)]
pub struct SweepReport {
    /// What it was computed from.
    pub identity: Identity,
    /// What was simulated in the first case, and what was not.
    pub effects: Effects,
    /// The axes.
    pub plan: Plan,
    /// The columns of the table.
    pub columns: Columns,
    /// One row a case, in their order.
    pub rows: Vec<Row>,
    /// Rows that an earlier run had computed.
    pub kept: usize,
    /// Seconds that this run took.
    pub seconds: f64,
}

impl SweepReport {
    /// Number of cases that ended so: `converged`, `no_solution`, `not_converged` or `bad_scene`.
    pub fn count(&self, status: &str) -> usize {
        let column = self.columns.status();
        self.rows.iter().filter(|row| row[column] == status).count()
    }

    /// The number of a quantity in a row.
    pub fn value(&self, row: &Row, name: &str) -> Option<f64> {
        row[self.columns.quantity(name)?].parse().ok()
    }
}

impl Serialize for SweepReport {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(Serialize)]
        struct Whole<'a> {
            #[serde(flatten)]
            identity: &'a Identity,
            complete: bool,
            effects: &'a Effects,
            axes: Vec<AxisRecord<'a>>,
            rows: Vec<RowRecord<'a>>,
        }
        let axes = self.plan.axes.iter().map(|axis| AxisRecord {
            name: &axis.name,
            key: &axis.path,
            unit: &axis.unit,
            values: axis.values.iter().map(json_value).collect(),
        });
        let whole = Whole {
            identity: &self.identity,
            complete: true,
            effects: &self.effects,
            axes: axes.collect(),
            rows: self.rows.iter().map(|row| RowRecord { report: self, row }).collect(),
        };
        whole.serialize(serializer)
    }
}

#[derive(Serialize)]
struct AxisRecord<'a> {
    name: &'a str,
    key: &'a str,
    unit: &'a str,
    values: Vec<serde_json::Value>,
}

fn json_value(value: &AxisValue) -> serde_json::Value {
    match value {
        AxisValue::Number(number) => (*number).into(),
        AxisValue::Word(word) => word.as_str().into(),
    }
}

/// One row as an object.
struct RowRecord<'a> {
    report: &'a SweepReport,
    row: &'a Row,
}

impl Serialize for RowRecord<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Self { report, row } = self;
        let number = |text: &String| text.parse::<f64>().ok();
        let columns = &report.columns;
        let case: usize = row[0].parse().unwrap_or(0);
        let mut inputs = serde_json::Map::new();
        let indices = report.plan.indices(case.saturating_sub(1));
        for (axis, index) in report.plan.axes.iter().zip(indices) {
            inputs.insert(axis.name.clone(), json_value(&axis.values[index]));
        }
        let mut quantities = serde_json::Map::new();
        let width = if columns.bars { 2 } else { 1 };
        let cells = row[columns.status() + 1..].chunks(width);
        for ((name, about), cells) in columns.quantities.iter().zip(cells) {
            if let Some(value) = number(&cells[0]) {
                let error = cells.get(1).and_then(number);
                quantities.insert(
                    name.to_string(),
                    serde_json::json!({ "value": value, "unit": about.unit.name(), "error": error }),
                );
            }
        }
        let tail = &row[row.len() - 3..];
        let mut map = serializer.serialize_map(Some(7))?;
        map.serialize_entry("case", &case)?;
        map.serialize_entry("inputs", &inputs)?;
        map.serialize_entry("status", &row[columns.status()])?;
        map.serialize_entry("reason", &Some(&tail[1]).filter(|reason| !reason.is_empty()))?;
        map.serialize_entry("quantities", &quantities)?;
        map.serialize_entry("unknowns", &tail[0].parse::<usize>().ok())?;
        map.serialize_entry("seconds", &number(&tail[2]))?;
        map.end()
    }
}
