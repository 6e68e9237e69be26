//! The page `docs/reference/quantities.md`: tables made of the catalogue of quantities.

use oilwedge_study::quantities::{CATALOGUE, Row, Table};

use crate::tables::{replace, row};

/// The page with tables made anew.
pub fn page(text: &str) -> String {
    let tables =
        [("film", Table::Film), ("heat", Table::Temperature), ("dynamics", Table::Dynamics), ("cap", Table::Cap)];
    tables.iter().fold(text.to_owned(), |text, (name, table)| {
        let head = ["name", "symbol", "unit", "definition", "error bar", "tolerance"];
        let rows = CATALOGUE.iter().filter(|row| row.table == *table).map(|row| line(row));
        let rows: Vec<_> = std::iter::once(row(head)).chain(rows).collect();
        replace(&text, name, &rows)
    })
}

fn line(quantity: &Row) -> Vec<String> {
    let region = if quantity.is_family() { "GROUP" } else { "" };
    vec![
        format!("`{}{region}`", quantity.name),
        quantity.symbol.to_owned(),
        quantity.unit.name().to_owned(),
        quantity.definition.to_owned(),
        quantity.error.sentence().to_owned(),
        if quantity.may_be_tolerance { "yes" } else { "" }.to_owned(),
    ]
}
