//! The page `docs/theory/notation.md`: the symbols of all pages. Those of quantities and fields are rows of their
//! catalogues; here stand the others, and the keys of scenes that give them.

use std::collections::BTreeSet;

use oilwedge_scene::catalogue::keys;
use oilwedge_study::fields::file_fields;
use oilwedge_study::quantities::{CATALOGUE, Table};

use crate::tables::{replace, row};

/// Symbols of the theory that are in no catalogue, or have a key of a scene.
const SYMBOLS: &str = include_str!("notation_symbols.txt");

/// The lines of [`SYMBOLS`].
fn symbols() -> impl Iterator<Item = Line> {
    SYMBOLS.lines().skip(1).map(|line| {
        let mut parts = line.split('|').map(str::trim);
        let [symbol, unit, what, names] = std::array::from_fn(|_| parts.next().expect("four columns"));
        Line {
            symbol,
            unit,
            what,
            names: names.split(' ').filter(|name| !name.is_empty()).map(str::to_owned).collect(),
        }
    })
}

/// A row of the table.
struct Line {
    symbol: &'static str,
    unit: &'static str,
    what: &'static str,
    names: Vec<String>,
}

/// The page with its table made anew.
pub fn page(text: &str) -> String {
    let head = row(["symbol", "meaning", "unit", "name in scenes, results and files"]);
    let rows = lines().into_iter().map(|line| {
        let names: Vec<String> = line.names.iter().map(|name| format!("`{name}`")).collect();
        row([&format!("`{}`", line.symbol), line.what, line.unit, &names.join(", ")])
    });
    let rows: Vec<Vec<String>> = std::iter::once(head).chain(rows).collect();
    replace(text, "notation", &rows)
}

/// One line for each meaning: fields and quantities whose symbol and unit are those of a line before stand with it.
fn lines() -> Vec<Line> {
    let fields = file_fields().map(|field| Line {
        symbol: field.symbol,
        unit: field.unit,
        what: field.what,
        names: vec![field.name.to_owned()],
    });
    // Of several quantities with one symbol the one with the shortest name comes first: the others are its parts, or
    // its greatest over a cycle.
    let mut rows: Vec<_> = CATALOGUE.iter().filter(|row| !is_coefficient(row.name)).collect();
    rows.sort_by_key(|row| (row.table != Table::Film, row.name.len()));
    let quantities = rows.into_iter().map(|row| Line {
        symbol: row.symbol,
        unit: row.unit.name(),
        what: row.what,
        names: vec![format!("{}{}", row.name, if row.is_family() { "GROUP" } else { "" })],
    });
    let mut lines: Vec<Line> = symbols().collect();
    for line in fields.chain(quantities) {
        let known = lines.iter_mut().find(|known| (known.symbol, known.unit) == (line.symbol, line.unit));
        match known {
            Some(known) => known.names.extend(line.names),
            None => lines.push(line),
        }
    }
    lines
}

/// Whether a quantity is an entry of the matrices of stiffness and damping, which have one line each.
fn is_coefficient(name: &str) -> bool {
    name.starts_with("stiffness_") || name.starts_with("damping_")
}

/// Names of the table that neither a scene nor a result nor a file has.
pub fn unknown_names() -> Vec<String> {
    let mut known: BTreeSet<String> = keys().map(|key| key.path.to_owned()).collect();
    known.extend(CATALOGUE.iter().map(|row| row.name.to_owned()));
    known.insert("...".to_owned());
    symbols().flat_map(|line| line.names).filter(|name| !known.contains(name)).collect()
}
