//! The table of a sweep: one row a case, and which columns there are.

use crate::Error;
use crate::number_columns;
use oilwedge_campaign::sweep::{CaseOutcome, CaseStatus};
use oilwedge_scene::Scene;
use oilwedge_scene::sweep::{AxisValue, Plan, WantedColumn};
use oilwedge_study::column::Column;
use oilwedge_study::quantities::of_scenes;
use oilwedge_study::result::{Criterion, Verdict};

/// The columns of a sweep, known before its first case is computed.
#[derive(Debug, Clone, PartialEq)]
pub struct Columns {
    /// Headings of the inputs.
    pub inputs: Vec<String>,
    /// The quantities that the scene asks for, else all in the order of the report.
    pub quantities: Vec<Column>,
    /// Whether each quantity has a column for its error.
    pub bars: bool,
}

/// A row: one text a column, empty where there is no value.
pub type TextRow = Vec<String>;

impl Columns {
    /// The columns of all cases of a sweep; without a wish of the scene an input that is a quantity of the report too
    /// has one column only.
    pub(crate) fn new(plan: &Plan, scenes: &[Scene], bars: bool) -> Self {
        let is_input = |name: &str| plan.axes.iter().any(|axis| axis.name == name);
        let all = || of_scenes(scenes).into_iter().filter(|(name, _)| !is_input(name));
        // What is wrong with a column was refused when the scene was read.
        let wanted = |wanted: &WantedColumn| Column::wanted_in(scenes, wanted)?.ok();
        let quantities = (plan.columns.as_ref()).map(|columns| columns.iter().filter_map(wanted).collect());
        Self {
            inputs: plan.input_headings(),
            quantities: quantities.unwrap_or_else(|| all().map(|(name, row)| Column::of(name, row)).collect()),
            bars,
        }
    }

    /// The headings.
    pub fn headings(&self) -> TextRow {
        let mut row = vec!["case".to_owned()];
        row.extend(self.inputs.iter().cloned());
        row.push("status".to_owned());
        row.extend(number_columns::headings(&self.quantities, self.bars));
        row.extend(TAIL.map(str::to_owned));
        row
    }

    /// The row of case `number` (from 0).
    ///
    /// # Errors
    /// A number is not finite.
    pub(crate) fn row(&self, plan: &Plan, number: usize, found: &CaseOutcome) -> Result<TextRow, Error> {
        let mut row = inputs(plan, number);
        row.push(status_name(found.status).to_owned());
        let case = format!("case {}", number + 1);
        row.extend(number_columns::cells(&self.quantities, self.bars, &found.quantities, &case)?);
        row.push(found.unknowns.map_or(String::new(), |unknowns| unknowns.to_string()));
        row.push(listed(found.warnings.iter().map(|warning| warning.kind.code.to_owned())));
        row.push(Verdict::of(&found.criteria).map_or_else(String::new, |verdict| verdict.name().to_owned()));
        let missed = found.criteria.iter().filter(|criterion| criterion.is_missed());
        row.push(listed(missed.map(Criterion::fault)));
        row.push(in_a_line(found.reason.as_deref().unwrap_or_default()));
        row.push(format!("{:.6}", found.seconds));
        Ok(row)
    }

    /// The row of case `number` (from 0), which cannot be computed.
    pub(crate) fn failed(&self, plan: &Plan, number: usize, reason: &str) -> TextRow {
        let mut row = inputs(plan, number);
        row.push(FAILED.to_owned());
        row.resize(self.place(self.quantities.len()), String::new());
        row.extend(TAIL.map(|column| if column == REASON { in_a_line(reason) } else { String::new() }));
        row
    }

    /// Column of the status.
    pub(crate) fn status(&self) -> usize {
        1 + self.inputs.len()
    }

    /// Place in a row of the value of the quantity of this number.
    pub(crate) fn place(&self, number: usize) -> usize {
        self.status() + 1 + number * if self.bars { 2 } else { 1 }
    }

    /// What a row has in one of the last columns: [`UNKNOWNS`] to [`SECONDS`].
    pub fn tail<'a>(&self, row: &'a TextRow, name: &str) -> &'a str {
        let place = TAIL.iter().position(|other| *other == name);
        place.and_then(|place| row.get(self.place(self.quantities.len()) + place)).map_or("", |text| text)
    }
}

/// Number and inputs of a case.
fn inputs(plan: &Plan, number: usize) -> TextRow {
    let mut row = vec![(number + 1).to_string()];
    row.extend(plan.inputs(number).into_iter().map(|(_, value)| match value {
        AxisValue::Number(number) => format!("{number:?}"),
        AxisValue::Word(word) => word,
    }));
    row
}

/// A text of several lines as one: a row is a line.
fn in_a_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Status of a case that no worker could compute.
pub(crate) const FAILED: &str = "failed";
/// Column of the unknown pressures.
pub const UNKNOWNS: &str = "unknowns";
/// Column of the codes of warnings.
pub const WARNINGS: &str = "warnings";
/// Column of the verdict by the design criteria: `pass`, `fail` or `undecided`; empty where the scene sets no limits.
pub const VERDICT: &str = "verdict";
/// Column of the design criteria that are not met.
pub const LIMITS: &str = "limits";
/// Column of the reason why there is no answer.
pub const REASON: &str = "reason";
/// Column of the wall time.
pub const SECONDS: &str = "seconds";
/// The columns behind the quantities.
const TAIL: [&str; 6] = [UNKNOWNS, WARNINGS, VERDICT, LIMITS, REASON, SECONDS];
/// Separator of entries of one cell.
pub(crate) const SEPARATOR: char = ';';

/// Texts in one cell, each once.
fn listed(texts: impl Iterator<Item = String>) -> String {
    let mut list: Vec<String> = Vec::new();
    for text in texts {
        if !list.contains(&text) {
            list.push(text);
        }
    }
    list.join(&SEPARATOR.to_string())
}

/// How a case ended, as it is written.
pub(crate) fn status_name(status: CaseStatus) -> &'static str {
    match status {
        CaseStatus::Run(status) => status.name(),
        CaseStatus::BadScene => "bad_scene",
    }
}

/// Rows as lines of CSV.
pub(crate) fn to_csv<'a>(rows: impl IntoIterator<Item = &'a TextRow>) -> Vec<u8> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for row in rows {
        // Writing into memory cannot fail.
        let _ = writer.write_record(row);
    }
    writer.into_inner().unwrap_or_default()
}

/// The rows of a table whose writer may have been killed: whole ones, up to the first that is not. `None` where the
/// table has other headings.
pub(crate) fn whole_rows(bytes: &[u8], headings: &TextRow) -> Option<Vec<TextRow>> {
    let end = bytes.iter().rposition(|byte| *byte == b'\n').map_or(0, |place| place + 1);
    let mut reader = csv::ReaderBuilder::new().has_headers(false).flexible(true).from_reader(&bytes[..end]);
    let mut records = reader.records();
    let row = |record: csv::StringRecord| -> TextRow { record.iter().map(str::to_owned).collect() };
    match records.next() {
        // Killed while the headings were written.
        None => return to_csv([headings]).starts_with(bytes).then(Vec::new),
        Some(first) if first.as_ref().ok().cloned().map(row).as_ref() != Some(headings) => return None,
        Some(_) => {}
    }
    let whole = records.map_while(Result::ok).map(row);
    Some(whole.take_while(|row| row.len() == headings.len()).collect())
}
