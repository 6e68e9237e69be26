//! The report of a sweep as `sweep.json` has it.

use oilwedge_study::result::Verdict;
use serde::{Serialize, Serializer};

use super::distribution::ToleranceRecord;
use super::report::{CaseQuantity, CaseRecord, ColumnRecord, SweepReport, SweepResult, entries};
use super::spread::distributions;
use super::table::{LIMITS, REASON, SECONDS, TextRow, UNKNOWNS, VERDICT, WARNINGS};

impl From<&SweepReport> for SweepResult {
    fn from(report: &SweepReport) -> Self {
        let columns = report.columns.quantities.iter().map(|column| ColumnRecord {
            name: column.name.to_string(),
            quantity: column.quantity.to_string(),
            unit: column.unit.to_string(),
        });
        let drawn = report.plan.draws.iter().flat_map(|draws| &draws.inputs);
        let result = Self {
            identity: report.identity.clone(),
            complete: true,
            scene: report.plan.text.clone(),
            effects: report.effects.clone(),
            axes: report.plan.axes.clone(),
            columns: columns.filter(|_| report.plan.columns.is_some()).collect(),
            tolerances: drawn.map(ToleranceRecord::from).collect(),
            distributions: Vec::new(),
            rows: report.rows.iter().map(|row| report.record(row)).collect(),
        };
        Self { distributions: distributions(&result), ..result }
    }
}

impl Serialize for SweepReport {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        SweepResult::from(self).serialize(serializer)
    }
}

impl SweepReport {
    /// A row as the file has it.
    fn record(&self, row: &TextRow) -> CaseRecord {
        let number = |text: &String| text.parse::<f64>().ok();
        let columns = &self.columns;
        let case: usize = row[0].parse().unwrap_or(0);
        let inputs = self.plan.inputs(case.saturating_sub(1)).into_iter();
        let quantities = columns.quantities.iter().enumerate().filter_map(|(place, column)| {
            let error = row.get(columns.place(place) + 1).filter(|_| columns.bars).and_then(number);
            let value = self.value(row, place)?;
            Some((column.name.to_string(), CaseQuantity { error, unit: column.unit.to_string(), value }))
        });
        let tail = |name: &str| columns.tail(row, name).to_owned();
        let list = |name: &str| entries(columns.tail(row, name)).map(str::to_owned).collect();
        CaseRecord {
            case,
            inputs: inputs.map(|(name, value)| (name.to_owned(), value)).collect(),
            status: row[columns.status()].clone(),
            reason: Some(tail(REASON)).filter(|reason| !reason.is_empty()),
            quantities: quantities.collect(),
            warnings: list(WARNINGS),
            verdict: [Verdict::Pass, Verdict::Fail, Verdict::Undecided]
                .into_iter()
                .find(|it| it.name() == columns.tail(row, VERDICT)),
            limits: list(LIMITS),
            unknowns: tail(UNKNOWNS).parse().ok(),
            seconds: number(&tail(SECONDS)),
        }
    }
}
