//! Tables of sweeps and convergence studies.

use oilwedge_study::quantities::row;
use serde_json::Value;

use super::quantities::{shown_unit, with_minus};
use super::table::{Cell, DIGITS, Table, any, optional, text};
use crate::digits::{quantity_value, significant};

/// Digits of the value whose convergence is studied.
const VALUE_DIGITS: usize = 9;

/// The rows of a sweep.
pub(super) fn sweep_rows(sweep: &Value) -> Option<Table> {
    let rows = sweep["rows"].as_array()?;
    let keys = |of: &str| -> Vec<String> {
        let first = rows
            .iter()
            .find_map(|row| row[of].as_object().filter(|it| !it.is_empty()));
        first.into_iter().flat_map(|it| it.keys().cloned()).collect()
    };
    let (inputs, quantities) = (keys("inputs"), keys("quantities"));
    let symbol =
        |name: &String| row(name).map_or(name.clone(), |row| row.symbol.to_owned() + &unit_of(row.unit.name()));
    let mut header = inputs.clone();
    header.extend(quantities.iter().map(symbol));
    header.push("status".to_owned());
    header.push("reason and warnings".to_owned());
    let shown = rows.iter().map(|it| {
        let mut cells: Vec<Cell> = inputs.iter().map(|key| any(&it["inputs"][key])).collect();
        cells.extend(quantities.iter().map(|key| {
            let quantity = &it["quantities"][key];
            quantity["value"].as_f64().map_or_else(
                || text("\u{2013}"),
                |value| Cell {
                    text: with_minus(quantity_value(value, quantity["error"].as_f64(), DIGITS)),
                    si: format!("{value}"),
                    is_number: true,
                },
            )
        }));
        cells.push(any(&it["status"]));
        let words = [&it["reason"], &it["warnings"]].map(|words| any(words).text);
        let words: Vec<String> = words.into_iter().filter(|words| !words.is_empty()).collect();
        cells.push(text(words.join("; ")));
        cells
    });
    Some(Table {
        title: "All cases".to_owned(),
        header,
        rows: shown.collect(),
        notes: Vec::new(),
    })
}

fn unit_of(unit: &str) -> String {
    match unit {
        "1" | "" => String::new(),
        unit => format!(", {}", shown_unit(unit)),
    }
}

/// The levels of a convergence study.
pub(super) fn study_levels(study: &Value) -> Option<Table> {
    let mut rows = Vec::new();
    for course in study["strategies"].as_array()? {
        for level in course["levels"].as_array().into_iter().flatten() {
            let mut cells = vec![any(&course["strategy"])];
            cells.extend(["level", "cells", "unknowns"].map(|key| optional(&level[key])));
            cells.extend(level["value"].as_f64().map(|value| Cell {
                text: with_minus(significant(value, VALUE_DIGITS)),
                si: format!("{value}"),
                is_number: true,
            }));
            cells.extend(["relative_bar", "relative_error"].map(|key| optional(&level[key])));
            rows.push(cells);
        }
    }
    let header = [
        "strategy",
        "level",
        "triangles",
        "unknowns",
        "value",
        "relative bar",
        "relative error",
    ];
    let mut table = Table::new("Levels", header, rows);
    let notes = study["notes"].as_array().into_iter().flatten();
    table.notes = notes.filter_map(Value::as_str).map(str::to_owned).collect();
    table.if_any()
}
