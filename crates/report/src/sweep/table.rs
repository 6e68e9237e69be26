//! The table of a sweep: one row a case, and which columns there are.

use std::borrow::Cow;

use crate::Error;
use oilwedge_campaign::sweep::{CaseStatus, Found};
use oilwedge_scene::Scene;
use oilwedge_scene::sweep::{AxisValue, Plan};
use oilwedge_study::quantities::{self, of_scenes};
use oilwedge_study::result::Status;

/// The columns of a sweep, known before its first case is computed.
#[derive(Debug, Clone, PartialEq)]
pub struct Columns {
    /// Headings of the inputs.
    pub inputs: Vec<String>,
    /// The quantities by name, in the order of the report.
    pub quantities: Vec<(Cow<'static, str>, &'static quantities::Row)>,
    /// Whether each quantity has a column for its error.
    pub bars: bool,
}

/// A row: one text a column, empty where there is no value.
pub type Row = Vec<String>;

impl Columns {
    /// The columns of all cases of a sweep; an input that is a quantity of the report too has one column only.
    pub(crate) fn new(plan: &Plan, scenes: &[Scene], bars: bool) -> Self {
        let is_input = |name: &str| plan.axes.iter().any(|axis| axis.name == name);
        let quantities = of_scenes(scenes).into_iter().filter(|(name, _)| !is_input(name));
        Self {
            inputs: plan.axes.iter().map(|axis| axis.heading()).collect(),
            quantities: quantities.collect(),
            bars,
        }
    }

    /// The headings.
    pub fn headings(&self) -> Row {
        let mut row = vec!["case".to_owned()];
        row.extend(self.inputs.iter().cloned());
        row.push("status".to_owned());
        for (name, about) in &self.quantities {
            let unit = about.unit.name();
            row.push(format!("{name} [{unit}]"));
            if self.bars {
                row.push(format!("{name} error [{unit}]"));
            }
        }
        row.extend(["unknowns", "reason", "seconds"].map(str::to_owned));
        row
    }

    /// The row of case `number` (from 0).
    ///
    /// # Errors
    /// A number is not finite.
    pub(crate) fn row(&self, plan: &Plan, number: usize, found: &Found) -> Result<Row, Error> {
        let mut row = vec![(number + 1).to_string()];
        for (axis, index) in plan.axes.iter().zip(plan.indices(number)) {
            row.push(match &axis.values[index] {
                AxisValue::Number(number) => format!("{number:?}"),
                AxisValue::Word(word) => word.clone(),
            });
        }
        row.push(status_name(found.status).to_owned());
        for (name, _) in &self.quantities {
            let quantity = found.quantities.iter().find(|quantity| quantity.name == *name);
            let text = |value: Option<f64>| match value {
                None => Ok(String::new()),
                Some(value) if value.is_finite() => Ok(format!("{value:?}")),
                Some(value) => Err(Error::NotFinite {
                    name: format!("case {}, {name}", number + 1),
                    value,
                }),
            };
            row.push(text(quantity.map(|quantity| quantity.value))?);
            if self.bars {
                row.push(text(quantity.and_then(|quantity| quantity.error()))?);
            }
        }
        row.push(found.unknowns.map_or(String::new(), |unknowns| unknowns.to_string()));
        let reason = found.reason.as_deref().unwrap_or_default();
        // One line a row.
        row.push(reason.split_whitespace().collect::<Vec<_>>().join(" "));
        row.push(format!("{:.6}", found.seconds));
        Ok(row)
    }

    /// Column of the status.
    pub(crate) fn status(&self) -> usize {
        1 + self.inputs.len()
    }

    /// Column of a quantity.
    pub fn quantity(&self, name: &str) -> Option<usize> {
        let place = self.quantities.iter().position(|(other, _)| other == name)?;
        Some(self.status() + 1 + place * if self.bars { 2 } else { 1 })
    }
}

/// How a case ended, as it is written.
pub(crate) fn status_name(status: CaseStatus) -> &'static str {
    match status {
        CaseStatus::Run(Status::Converged) => "converged",
        CaseStatus::Run(Status::NoSolution) => "no_solution",
        CaseStatus::Run(Status::NotConverged) => "not_converged",
        CaseStatus::BadScene => "bad_scene",
    }
}

/// Rows as lines of CSV.
pub(crate) fn to_csv<'a>(rows: impl IntoIterator<Item = &'a Row>) -> Vec<u8> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for row in rows {
        // Writing into memory cannot fail.
        let _ = writer.write_record(row);
    }
    writer.into_inner().unwrap_or_default()
}

/// The rows of a table whose writer may have been killed: whole ones, up to the first that is not. `None` where the table has other
/// headings.
pub(crate) fn whole_rows(bytes: &[u8], headings: &Row) -> Option<Vec<Row>> {
    let end = bytes
        .iter()
        .rposition(|byte| *byte == b'\n')
        .map_or(0, |place| place + 1);
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .from_reader(&bytes[..end]);
    let mut records = reader.records();
    let row = |record: csv::StringRecord| -> Row { record.iter().map(str::to_owned).collect() };
    match records.next() {
        // Killed while the headings were written.
        None => return to_csv([headings]).starts_with(bytes).then(Vec::new),
        Some(first) if first.as_ref().ok().cloned().map(row).as_ref() != Some(headings) => return None,
        Some(_) => {}
    }
    let whole = records.map_while(Result::ok).map(row);
    Some(whole.take_while(|row| row.len() == headings.len()).collect())
}
