//! What was compared with the film on request: films without an effect, of bearing theories, and the numbers of the
//! standard.

use oilwedge_study::quantities::row;
use serde_json::Value;

use super::quantities::{in_words, shown_unit, with_minus};
use super::table::{Cell, DIGITS, Table, text};
use crate::digits::{bar, quantity_value};
use crate::readable::readable_unit;

/// A quantity in a comparison: its name, and a value with the digits of its bar.
struct Compared {
    name: Cell,
    unit: String,
    size: f64,
}

impl Compared {
    fn new(name: &str, value: f64) -> Self {
        let row = row(name);
        let (unit, size) = row.map_or(("", 1.0), |row| readable_unit(value, row.unit));
        Self { name: text(in_words(name)), unit: shown_unit(unit), size }
    }

    fn value(&self, value: &Value, error: &Value) -> Cell {
        let Some(value) = value.as_f64() else {
            return text("\u{2013}");
        };
        let error = error.as_f64().map(|error| error / self.size);
        let shown = with_minus(quantity_value(value / self.size, error, DIGITS));
        let bar = error.filter(|error| *error > 0.0).map(|error| format!(" \u{b1} {}", with_minus(bar(error))));
        Cell {
            text: format!("{shown}{} {}", bar.unwrap_or_default(), self.unit).trim_end().to_owned(),
            si: format!("{value}"),
            is_number: true,
            ..Cell::default()
        }
    }
}

/// What each effect changes.
fn cost(result: &Value) -> Option<Table> {
    let mut table =
        Table::new("What the effects change", ["effect", "quantity", "with it", "without it", "change"], Vec::new());
    for it in result["cost"].as_array()? {
        let effect = it["effect"].as_str().unwrap_or_default();
        let instead = it["instead"].as_str().unwrap_or_default();
        let name = format!("{effect} (then {instead})");
        if let Some(reason) = it["reason"].as_str() {
            table.notes.push(format!("Without {effect}: {reason}"));
        }
        for (quantity, change) in it["changes"].as_object().into_iter().flatten() {
            let compared = Compared::new(quantity, change["with"].as_f64().unwrap_or(0.0));
            let none = Value::Null;
            table.rows.push(vec![
                text(name.as_str()),
                compared.name.clone(),
                compared.value(&change["with"], &none),
                compared.value(&change["without"], &none),
                compared.value(&change["change"], &change["error"]),
            ]);
        }
        if it["could_be_left_out"].as_bool() == Some(true) {
            table.notes.push(format!("{effect} changes nothing beyond the error bars: it could be left out"));
        }
    }
    table.if_any()
}

/// The film of short and of long bearings.
fn theories(result: &Value) -> Option<Table> {
    let films = result["theories"]["films"].as_array()?;
    let mut table =
        Table::new("Theories of short and long bearings", ["theory", "quantity", "value", "difference"], Vec::new());
    for film in films {
        let theory = film["theory"].as_str().unwrap_or_default();
        if let Some(reason) = film["reason"].as_str() {
            table.notes.push(format!("{theory}: {reason}"));
        }
        for (quantity, it) in film["quantities"].as_object().into_iter().flatten() {
            let compared = Compared::new(quantity, it["value"].as_f64().unwrap_or(0.0));
            table.rows.push(vec![
                text(theory),
                compared.name.clone(),
                compared.value(&it["value"], &it["error"]),
                compared.value(&it["difference"], &Value::Null),
            ]);
        }
    }
    let left_out = result["theories"]["without"].as_array().into_iter().flatten();
    let left_out: Vec<&str> = left_out.filter_map(Value::as_str).collect();
    if !left_out.is_empty() {
        table.notes.push(format!("All films here are without: {}", left_out.join(", ")));
    }
    table.if_any()
}

/// What ISO 7902 gives for the bearing.
fn standard(result: &Value) -> Option<Table> {
    let standard = result["standard"].as_object()?;
    let numbers = standard.get("numbers").and_then(Value::as_array).into_iter().flatten();
    let rows = numbers.map(|it| {
        let film = it["film"].as_f64().unwrap_or(0.0);
        let compared = Compared::new(it["quantity"].as_str().unwrap_or_default(), film);
        vec![
            compared.name.clone(),
            compared.value(&it["film"], &it["error"]),
            compared.value(&it["standard"], &Value::Null),
            compared.value(&it["difference"], &Value::Null),
        ]
    });
    let mut table = Table::new("ISO 7902 (DIN 31652)", ["quantity", "film", "standard", "difference"], rows.collect());
    let notes = standard.get("notes").and_then(Value::as_array).into_iter().flatten();
    table.notes = notes.filter_map(Value::as_str).map(str::to_owned).collect();
    table.if_any()
}

/// Comparisons that were asked for.
pub(super) fn comparisons(result: &Value) -> Vec<Table> {
    [cost(result), theories(result), standard(result)].into_iter().flatten().collect()
}
