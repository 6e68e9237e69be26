//! A sweep as the script of the page has it: its axes, and values and errors of all quantities at all cases.

use oilwedge_drawing::ColourMap;
use oilwedge_scene::sweep::{AxisValue, SweepAxis};
use oilwedge_study::result::Verdict;
use serde::Serialize;

use super::packing::{Packed, packed};
use crate::plot::quantity_names;
use crate::readable::printed_unit;
use crate::sweep::{CaseQuantity, CaseRecord, SweepResult};

/// A sweep.
#[derive(Debug, Serialize)]
pub(super) struct SweepData {
    axes: Vec<AxisData>,
    quantities: Vec<QuantityData>,
    /// Values and errors in SI: all cases of the first quantity, then of the next; bits of single precision, not a
    /// number where there is none.
    values: Packed,
    errors: Packed,
    /// What became of each case.
    remarks: Vec<String>,
    /// Colours at equal steps, hexadecimal.
    sequential: String,
    diverging: String,
}

/// An axis.
#[derive(Debug, Serialize)]
struct AxisData {
    label: String,
    unit: String,
    is_numeric: bool,
    values: Vec<AxisValue>,
}

/// A quantity.
#[derive(Debug, Serialize)]
struct QuantityData {
    label: String,
    unit: String,
    /// Size of the unit in SI.
    size: f64,
}

impl SweepData {
    /// Data of a sweep; `None` where there is nothing to choose from.
    pub(super) fn of(sweep: &SweepResult) -> Option<Self> {
        if sweep.identity.draws.is_some() {
            return None;
        }
        let mut names = sweep.names(&[]);
        let others: Vec<String> = quantity_names(sweep);
        names.extend(others.into_iter().filter(|name| !names.contains(name)).collect::<Vec<_>>());
        let rows: Vec<Option<&CaseRecord>> = sweep.all().collect();
        let numbers = |number: &dyn Fn(&CaseQuantity) -> Option<f64>| -> Vec<u32> {
            let bits = |name: &String, row: &Option<&CaseRecord>| {
                let number = row.and_then(|row| row.quantities.get(name)).and_then(number);
                (number.unwrap_or(f64::NAN) as f32).to_bits()
            };
            names.iter().flat_map(|name| rows.iter().map(move |row| bits(name, row))).collect()
        };
        let has_choice = sweep.axes.iter().any(|axis| axis.values.len() > 1);
        (has_choice && !names.is_empty()).then(|| Self {
            axes: sweep.axes.iter().map(AxisData::of).collect(),
            quantities: names.iter().map(|name| QuantityData::of(sweep, name)).collect(),
            values: packed(&numbers(&|it| Some(it.value))),
            errors: packed(&numbers(&|it| it.error)),
            remarks: rows.iter().map(|row| row.map_or_else(String::new, remark)).collect(),
            sequential: ColourMap::Batlow.to_hex(),
            diverging: ColourMap::Vik.to_hex(),
        })
    }
}

/// What became of a case.
fn remark(row: &CaseRecord) -> String {
    let verdict = row.verdict.map_or("", Verdict::name);
    let reason = row.reason.as_deref().unwrap_or_default();
    let (limits, warnings) = (row.limits.join(", "), row.warnings.join(", "));
    let words = [row.status.as_str(), verdict, &limits, reason, &warnings];
    let words: Vec<&str> = words.into_iter().filter(|words| !words.is_empty()).collect();
    words.join("; ").replace('_', " ")
}

impl AxisData {
    fn of(axis: &SweepAxis) -> Self {
        Self {
            label: axis.name.replace('_', " "),
            unit: printed_unit(&axis.unit),
            is_numeric: axis.is_numeric(),
            values: axis.values.clone(),
        }
    }
}

impl QuantityData {
    fn of(sweep: &SweepResult, name: &str) -> Self {
        let (unit, size) = sweep.unit_of(name).unwrap_or(("", 1.0));
        Self { label: sweep.heading(name), unit: printed_unit(unit), size }
    }
}
