//! Tables of the page: cells with their text and the full number behind it.

use serde::Serialize;
use serde_json::Value;

use super::quantities::with_minus;
use crate::digits::significant;

/// Digits of numbers in tables.
pub(super) const DIGITS: usize = 4;
/// Whole numbers below this are counts, and are written out.
const WHOLE: f64 = 1e9;

/// A cell: its text, and the number in SI that it shows.
#[derive(Debug, Clone, Default, Serialize)]
pub(super) struct Cell {
    pub(super) text: String,
    pub(super) si: String,
    pub(super) is_number: bool,
    /// Class of its style: `good`, `bad`, `open`, or `whole` where its words stay in one line; empty as the text around
    /// it.
    pub(super) kind: &'static str,
}

/// A table with a title and notes below it.
#[derive(Debug, Clone, Default, Serialize)]
pub(super) struct Table {
    pub(super) title: String,
    pub(super) header: Vec<String>,
    pub(super) rows: Vec<Vec<Cell>>,
    pub(super) notes: Vec<String>,
}

impl Table {
    pub(super) fn new<const N: usize>(title: &str, header: [&str; N], rows: Vec<Vec<Cell>>) -> Self {
        Self { title: title.to_owned(), header: header.map(str::to_owned).to_vec(), rows, notes: Vec::new() }
    }

    pub(super) fn if_any(self) -> Option<Self> {
        (!self.rows.is_empty() || !self.notes.is_empty()).then_some(self)
    }
}

/// A text.
pub(super) fn text(text: impl Into<String>) -> Cell {
    Cell { text: text.into(), ..Cell::default() }
}

/// A number in its own unit.
pub(super) fn number(value: f64) -> Cell {
    sized(value, 1.0, "")
}

/// A number in a unit of that size.
pub(super) fn sized(value: f64, size: f64, unit: &str) -> Cell {
    let shown = match size == 1.0 && value.fract() == 0.0 && value.abs() < WHOLE {
        true => with_minus(format!("{}", value + 0.0)),
        false => with_minus(without_zeros(significant(value / size, DIGITS))),
    };
    Cell { text: format!("{shown} {unit}").trim_end().to_owned(), si: format!("{value}"), is_number: true, kind: "" }
}

/// A decimal number without zeros at its end.
pub(super) fn without_zeros(number: String) -> String {
    let (mantissa, exponent) = number.split_at(number.find('e').unwrap_or(number.len()));
    match mantissa.contains('.') {
        true => mantissa.trim_end_matches('0').trim_end_matches('.').to_owned() + exponent,
        false => number,
    }
}

/// A number, or a dash where there is none.
pub(super) fn optional(value: &Value) -> Cell {
    value.as_f64().map_or_else(|| text("\u{2013}"), number)
}

/// Any value of JSON in a cell.
pub(super) fn any(value: &Value) -> Cell {
    match value {
        Value::Null => Cell::default(),
        Value::Number(_) => value.as_f64().map_or_else(Cell::default, number),
        Value::String(words) => text(words.as_str()),
        Value::Array(list) => {
            let words: Vec<String> = list.iter().map(|it| any(it).text).collect();
            text(words.join(", "))
        }
        other => text(other.to_string()),
    }
}
