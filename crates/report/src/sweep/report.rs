//! What a sweep found, as scripts read it: `sweep.json`.

use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

use super::table::{Columns, LIMITS, REASON, Row, SECONDS, SEPARATOR, UNKNOWNS, VERDICT, WARNINGS};
use oilwedge_campaign::sweep::Part;
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
    /// SHA-256 of the tables of loads and gas pressures, and of the scenes of bearings on crankshafts, hexadecimal;
    /// `None` where there are none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tables_sha256: Option<String>,
    /// Whether error bars are estimated.
    pub bars: bool,
    /// Number of cases of the whole sweep.
    pub cases: usize,
    /// The part of it that is computed; `None` where it is all of it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub part: Option<Part>,
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
    /// One row a case of the sweep or its part, in their order.
    pub rows: Vec<Row>,
    /// Rows that an earlier run had computed.
    pub kept: usize,
    /// Seconds that this run took; of a table that is joined those of its cases together.
    pub seconds: f64,
    /// Whether the rows were computed as parts, by other runs.
    pub is_joined: bool,
    /// Names of the tables for programs of rotors that were written.
    pub rotor_tables: Vec<&'static str>,
}

impl SweepReport {
    /// Takes rows that other runs have computed, of all cases.
    pub(super) fn join(&mut self, rows: Vec<Row>) {
        let seconds = |row: &Row| self.columns.tail(row, SECONDS).parse::<f64>().ok();
        self.seconds = rows.iter().filter_map(seconds).sum();
        self.rows = rows;
        self.is_joined = true;
    }

    /// Number of cases that ended so: `converged`, `no_solution`, `not_converged`, `bad_scene` or `failed`.
    pub fn count(&self, status: &str) -> usize {
        let column = self.columns.status();
        self.rows.iter().filter(|row| row[column] == status).count()
    }

    /// The number in a row of the quantity in the column of this number, in its unit.
    pub fn value(&self, row: &Row, column: usize) -> Option<f64> {
        row.get(self.columns.place(column))?.parse().ok()
    }

    /// Whether a case has an answer: a film, if only that of a search that was ended.
    pub fn has_answer(&self, row: &Row) -> bool {
        !self.columns.tail(row, UNKNOWNS).is_empty()
            && (0..self.columns.quantities.len()).any(|it| self.value(row, it).is_some())
    }

    /// How many cases have each entry of one of the last columns, [`WARNINGS`] or [`LIMITS`]; the most frequent first.
    pub fn tally(&self, column: &str) -> Vec<(&str, usize)> {
        let mut tally: Vec<(&str, usize)> = Vec::new();
        for entry in self.rows.iter().flat_map(|row| entries(self.columns.tail(row, column))) {
            match tally.iter_mut().find(|(other, _)| *other == entry) {
                Some((_, count)) => *count += 1,
                None => tally.push((entry, 1)),
            }
        }
        tally.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
        tally
    }
}

impl Serialize for SweepReport {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(Serialize)]
        struct Whole<'a> {
            #[serde(flatten)]
            identity: &'a Identity,
            complete: bool,
            scene: &'a str,
            effects: &'a Effects,
            axes: Vec<AxisRecord<'a>>,
            #[serde(skip_serializing_if = "Option::is_none")]
            columns: Option<Vec<ColumnRecord<'a>>>,
            rows: Vec<RowRecord<'a>>,
        }
        let axes = self.plan.axes.iter().map(|axis| AxisRecord {
            name: &axis.name,
            key: &axis.path,
            unit: &axis.unit,
            values: axis.values.iter().map(json_value).collect(),
        });
        let columns = self.columns.quantities.iter().map(|column| ColumnRecord {
            name: &column.name,
            quantity: &column.quantity,
            unit: &column.unit,
        });
        let is_asked = self.plan.columns.is_some();
        let whole = Whole {
            identity: &self.identity,
            complete: true,
            scene: &self.plan.text,
            effects: &self.effects,
            axes: axes.collect(),
            columns: is_asked.then(|| columns.collect()),
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

/// A column that the scene asks for.
#[derive(Serialize)]
struct ColumnRecord<'a> {
    name: &'a str,
    quantity: &'a str,
    unit: &'a str,
}

fn json_value(value: &AxisValue) -> serde_json::Value {
    match value {
        AxisValue::Number(number) => (*number).into(),
        AxisValue::Word(word) => word.as_str().into(),
    }
}

/// The entries of a cell that lists several.
fn entries(cell: &str) -> impl Iterator<Item = &str> {
    cell.split(SEPARATOR).filter(|entry| !entry.is_empty())
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
        for (place, column) in columns.quantities.iter().enumerate() {
            if let Some(value) = report.value(row, place) {
                let error = row.get(columns.place(place) + 1).filter(|_| columns.bars).and_then(number);
                quantities.insert(
                    column.name.to_string(),
                    serde_json::json!({ "value": value, "unit": column.unit, "error": error }),
                );
            }
        }
        let tail = |name: &str| columns.tail(row, name).to_owned();
        let list = |name: &str| entries(columns.tail(row, name)).collect::<Vec<_>>();
        let mut map = serializer.serialize_map(Some(10))?;
        map.serialize_entry("case", &case)?;
        map.serialize_entry("inputs", &inputs)?;
        map.serialize_entry("status", &row[columns.status()])?;
        map.serialize_entry(REASON, &Some(tail(REASON)).filter(|reason| !reason.is_empty()))?;
        map.serialize_entry("quantities", &quantities)?;
        map.serialize_entry(WARNINGS, &list(WARNINGS))?;
        map.serialize_entry(VERDICT, &Some(tail(VERDICT)).filter(|verdict| !verdict.is_empty()))?;
        map.serialize_entry(LIMITS, &list(LIMITS))?;
        map.serialize_entry(UNKNOWNS, &tail(UNKNOWNS).parse::<usize>().ok())?;
        map.serialize_entry(SECONDS, &number(&tail(SECONDS)))?;
        map.end()
    }
}
