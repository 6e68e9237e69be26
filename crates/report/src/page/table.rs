//! Tables of the page: cells with their text and the full number behind it.

use oilwedge_scene::sweep::AxisValue;
use serde::Serialize;

use super::quantities::with_minus;
use crate::digits::{bar, quantity_value, significant};

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
    number_as(value, format!("{shown} {unit}").trim_end())
}

/// A number that is shown as this text.
pub(super) fn number_as(value: f64, text: impl Into<String>) -> Cell {
    Cell { text: text.into(), si: format!("{value}"), is_number: true, kind: "" }
}

/// A value with the digits of its bar, and the bar if there is one, in a unit of this size.
pub(super) fn with_bar(value: f64, error: Option<f64>, size: f64) -> String {
    let error = error.map(|error| error / size);
    let bar = error.filter(|error| *error > 0.0).map(|error| format!(" \u{b1} {}", with_minus(bar(error))));
    with_minus(quantity_value(value / size, error, DIGITS)) + &bar.unwrap_or_default()
}

/// A decimal number without zeros at its end.
pub(super) fn without_zeros(number: String) -> String {
    let (mantissa, exponent) = number.split_at(number.find('e').unwrap_or(number.len()));
    match mantissa.contains('.') {
        true => mantissa.trim_end_matches('0').trim_end_matches('.').to_owned() + exponent,
        false => number,
    }
}

/// A count.
pub(super) fn count(count: usize) -> Cell {
    number(count as f64)
}

/// A number, or a dash where there is none.
pub(super) fn optional(value: Option<f64>) -> Cell {
    value.map_or_else(|| text("\u{2013}"), number)
}

/// A value of an axis.
pub(super) fn of_axis(value: &AxisValue) -> Cell {
    match value {
        AxisValue::Number(value) => number(*value),
        AxisValue::Word(word) => text(word.as_str()),
    }
}
