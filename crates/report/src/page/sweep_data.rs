//! A sweep as the script of the page has it: its axes, and values and errors of all quantities at all cases.

use oilwedge_drawing::ColourMap;
use serde::Serialize;
use serde_json::Value;

use super::packing::{Packed, packed};
use super::quantities::shown_unit;
use super::table::any;
use crate::plot::{Cases, quantity_names};

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
    values: Vec<Value>,
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
    /// Data from the object of `sweep.json`; `None` where there is nothing to choose from.
    pub(super) fn of(sweep: &Value) -> Option<Self> {
        let cases = Cases::of(sweep)?;
        let mut names = cases.names(&[]);
        let others: Vec<String> = quantity_names(sweep);
        names.extend(others.into_iter().filter(|name| !names.contains(name)).collect::<Vec<_>>());
        let rows: Vec<Option<&Value>> = cases.all().collect();
        let numbers = |key: &str| -> Vec<u32> {
            let bits = |name: &String, row: &Option<&Value>| {
                let number = row.and_then(|row| row["quantities"][name.as_str()][key].as_f64());
                (number.unwrap_or(f64::NAN) as f32).to_bits()
            };
            names.iter().flat_map(|name| rows.iter().map(move |row| bits(name, row))).collect()
        };
        let has_choice = cases.inputs().any(|(_, _, values)| values.len() > 1);
        let remark = |row: &Option<&Value>| {
            row.map_or_else(String::new, |row| {
                let keys = ["status", "verdict", "limits", "reason", "warnings"];
                let words = keys.map(|key| any(&row[key]).text);
                let words: Vec<String> = words.into_iter().filter(|words| !words.is_empty()).collect();
                words.join("; ").replace('_', " ")
            })
        };
        (has_choice && !names.is_empty()).then(|| Self {
            axes: cases.inputs().map(|(name, unit, values)| AxisData::of(name, unit, values)).collect(),
            quantities: names.iter().map(|name| QuantityData::of(&cases, name)).collect(),
            values: packed(&numbers("value")),
            errors: packed(&numbers("error")),
            remarks: rows.iter().map(remark).collect(),
            sequential: ColourMap::Batlow.to_hex(),
            diverging: ColourMap::Vik.to_hex(),
        })
    }
}

impl AxisData {
    fn of(name: &str, unit: &str, values: &[Value]) -> Self {
        Self {
            label: name.replace('_', " "),
            unit: shown_unit(unit),
            is_numeric: values.iter().all(Value::is_number),
            values: values
                .iter()
                .map(|value| if value.is_number() { value.clone() } else { any(value).text.into() })
                .collect(),
        }
    }
}

impl QuantityData {
    fn of(cases: &Cases, name: &str) -> Self {
        let (unit, size) = cases.unit_of(name).unwrap_or(("", 1.0));
        Self { label: cases.heading(name), unit: shown_unit(unit), size }
    }
}
