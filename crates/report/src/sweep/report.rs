//! What a sweep found, as scripts read it: `sweep.json`.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::distribution::{Distribution, ToleranceRecord};
use super::table::{Columns, SECONDS, SEPARATOR, TextRow, UNKNOWNS};
use oilwedge_campaign::sweep::Part;
use oilwedge_scene::sweep::{AxisValue, DrawOptions, Plan, SweepAxis};
use oilwedge_study::effects::Effects;
use oilwedge_study::result::Verdict;

/// Name and version of the form of `sweep.json`.
pub const SWEEP_FORMAT: &str = "oilwedge-sweep/1";

/// What a sweep is computed from: rows of another one are not its own.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
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
    /// The draws of tolerances; `None` where nothing is drawn.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub draws: Option<DrawOptions>,
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
    pub rows: Vec<TextRow>,
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
    pub(super) fn join(&mut self, rows: Vec<TextRow>) {
        let seconds = |row: &TextRow| self.columns.tail(row, SECONDS).parse::<f64>().ok();
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
    pub fn value(&self, row: &TextRow, column: usize) -> Option<f64> {
        row.get(self.columns.place(column))?.parse().ok()
    }

    /// Whether a case has an answer: a film, if only that of a search that was ended.
    pub fn has_answer(&self, row: &TextRow) -> bool {
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

/// The whole of `sweep.json`. A key that a file does not have is empty.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct SweepResult {
    /// What the sweep was computed from.
    #[serde(flatten)]
    pub identity: Identity,
    /// Whether it has ended.
    pub complete: bool,
    /// The text of the scene.
    pub scene: String,
    /// What was simulated in the first case, and what was not.
    pub effects: Effects,
    /// The axes.
    pub axes: Vec<SweepAxis>,
    /// The columns that the scene asks for; absent in JSON where it asks for none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub columns: Vec<ColumnRecord>,
    /// The tolerances that were drawn; absent in JSON without draws.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub tolerances: Vec<ToleranceRecord>,
    /// How the main quantities are distributed over the draws at each point of the other axes; absent in JSON without
    /// draws.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub distributions: Vec<Distribution>,
    /// The cases, in their order.
    pub rows: Vec<CaseRecord>,
}

/// A column that the scene asks for.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ColumnRecord {
    /// How the scene writes it.
    pub name: String,
    /// The quantity that it is.
    pub quantity: String,
    /// Unit of the column.
    pub unit: String,
}

/// One case.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct CaseRecord {
    /// Number of the case, from 1.
    pub case: usize,
    /// The values on the axes, by the names of these.
    pub inputs: BTreeMap<String, AxisValue>,
    /// How it ended: `converged`, `no_solution`, `not_converged`, `bad_scene` or `failed`.
    pub status: String,
    /// Why it has no answer.
    pub reason: Option<String>,
    /// Numbers of the case, by the names of the columns.
    pub quantities: BTreeMap<String, CaseQuantity>,
    /// Codes of its warnings.
    pub warnings: Vec<String>,
    /// The verdict by the criteria of the scene; `None` where it has none.
    pub verdict: Option<Verdict>,
    /// The criteria that are not met.
    pub limits: Vec<String>,
    /// Unknown pressures.
    pub unknowns: Option<usize>,
    /// Wall time [s].
    pub seconds: Option<f64>,
}

/// A number of a case.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CaseQuantity {
    /// Half the width of its bar, if there is one.
    pub error: Option<f64>,
    /// Unit of both.
    pub unit: String,
    /// The value.
    pub value: f64,
}

/// The entries of a cell that lists several.
pub(super) fn entries(cell: &str) -> impl Iterator<Item = &str> {
    cell.split(SEPARATOR).filter(|entry| !entry.is_empty())
}
