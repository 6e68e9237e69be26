//! What was compared with the film on request: films without an effect, of bearing theories, and the numbers of the
//! standard.

use std::collections::BTreeMap;

use oilwedge_campaign::records::{Compared, CostRecord, FilmRecord, Records, StandardRecord, TheoriesRecord};
use oilwedge_study::quantities::row;

use super::quantities::{in_words, shown_unit};
use super::table::{Cell, Table, number_as, text, with_bar};
use crate::readable::readable_unit;

/// A quantity in a comparison: its name, and a value with the digits of its bar.
struct ComparedQuantity {
    name: Cell,
    unit: String,
    size: f64,
}

impl ComparedQuantity {
    fn new(name: &str, value: f64) -> Self {
        let row = row(name);
        let (unit, size) = row.map_or(("", 1.0), |row| readable_unit(value, row.unit));
        Self { name: text(in_words(name)), unit: shown_unit(unit), size }
    }

    fn value(&self, value: Option<f64>, error: Option<f64>) -> Cell {
        let shown =
            |value: f64| number_as(value, format!("{} {}", with_bar(value, error, self.size), self.unit).trim_end());
        value.map_or_else(|| text("\u{2013}"), shown)
    }
}

/// Numbers by the names of their quantities.
fn by_name<T>(entries: &[(String, Compared<T>)]) -> BTreeMap<&str, &T> {
    entries.iter().map(|(name, it)| (name.as_str(), &it.numbers)).collect()
}

/// What each effect changes.
fn cost(costs: &[CostRecord]) -> Option<Table> {
    let mut table =
        Table::new("What the effects change", ["effect", "quantity", "with it", "without it", "change"], Vec::new());
    for CostRecord { effect, instead, reason, changes, could_be_left_out, .. } in costs {
        if let Some(reason) = reason {
            table.notes.push(format!("Without {effect}: {reason}"));
        }
        for (quantity, it) in by_name(changes) {
            let compared = ComparedQuantity::new(quantity, it.with.unwrap_or(0.0));
            table.rows.push(vec![
                text(format!("{effect} (then {instead})")),
                compared.name.clone(),
                compared.value(it.with, None),
                compared.value(it.without, None),
                compared.value(it.change, it.error),
            ]);
        }
        if *could_be_left_out == Some(true) {
            table.notes.push(format!("{effect} changes nothing beyond the error bars: it could be left out"));
        }
    }
    table.if_any()
}

/// The film of short and of long bearings.
fn theories(theories: &TheoriesRecord) -> Option<Table> {
    let mut table =
        Table::new("Theories of short and long bearings", ["theory", "quantity", "value", "difference"], Vec::new());
    for FilmRecord { theory, reason, quantities, .. } in &theories.films {
        if let Some(reason) = reason {
            table.notes.push(format!("{theory}: {reason}"));
        }
        for (quantity, it) in by_name(quantities) {
            let compared = ComparedQuantity::new(quantity, it.value);
            table.rows.push(vec![
                text(theory.as_str()),
                compared.name.clone(),
                compared.value(Some(it.value), it.error),
                compared.value(it.difference, None),
            ]);
        }
    }
    if !theories.without.is_empty() {
        table.notes.push(format!("All films here are without: {}", theories.without.join(", ")));
    }
    table.if_any()
}

/// What ISO 7902 gives for the bearing.
fn standard(standard: &StandardRecord) -> Option<Table> {
    let rows = standard.numbers.iter().map(|it| {
        let compared = ComparedQuantity::new(&it.quantity, it.film);
        vec![
            compared.name.clone(),
            compared.value(Some(it.film), it.error),
            compared.value(Some(it.standard), None),
            compared.value(Some(it.difference), None),
        ]
    });
    let mut table = Table::new("ISO 7902 (DIN 31652)", ["quantity", "film", "standard", "difference"], rows.collect());
    table.notes.clone_from(&standard.notes);
    table.if_any()
}

/// Comparisons that were asked for.
pub(super) fn comparisons(records: &Records) -> Vec<Table> {
    let Records { cost: costs, standard: twin, theories: films, .. } = records;
    let tables = [costs.as_deref().and_then(cost), films.as_ref().and_then(theories), twin.as_ref().and_then(standard)];
    tables.into_iter().flatten().collect()
}
