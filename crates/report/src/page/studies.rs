//! Tables of sweeps and convergence studies.

use oilwedge_study::result::Verdict;
use serde::Deserialize;
use serde_json::Value;

use super::quantities::{shown_unit, with_minus};
use super::table::{Cell, DIGITS, Table, any, optional, text, without_zeros};
use super::verdict;
use crate::digits::{quantity_value, significant};
use crate::plot::Cases;

/// Digits of the value whose convergence is studied.
const VALUE_DIGITS: usize = 9;

/// How many cases there are, and what became of them.
pub(super) fn cases_in_words(sweep: &Value) -> String {
    let mut counts: Vec<(String, usize)> = Vec::new();
    let rows = sweep["rows"].as_array().into_iter().flatten();
    for status in rows.map(|row| any(&row["status"]).text.replace('_', " ")) {
        match counts.iter_mut().find(|(known, _)| *known == status) {
            Some((_, count)) => *count += 1,
            None => counts.push((status, 1)),
        }
    }
    let each: Vec<String> = counts.iter().map(|(status, count)| format!("{count} {status}")).collect();
    each.join(", ")
}

/// The rows of a sweep: its axes in their order, the columns that the scene asks for or the main quantities, the
/// verdict where the scene sets limits, and how each case ended.
pub(super) fn sweep_rows(sweep: &Value) -> Option<Table> {
    let cases = Cases::of(sweep)?;
    let quantities: Vec<(String, &str, f64)> = cases
        .names(&[])
        .into_iter()
        .filter_map(|name| {
            let (unit, size) = cases.unit_of(&name)?;
            Some((name, unit, size))
        })
        .collect();
    let is_judged = cases.rows().iter().any(|it| it["verdict"].is_string());
    let mut header = vec!["case".to_owned()];
    header.extend(cases.inputs().map(|(name, unit, _)| name.replace(['_', '.'], " ") + &unit_of(unit)));
    header.extend(quantities.iter().map(|(name, unit, _)| cases.heading(name) + &unit_of(unit)));
    header.extend(is_judged.then(|| "verdict".to_owned()));
    header.extend(["status", "warnings"].map(str::to_owned));
    let words = |it: &Value| text(any(it).text.replace('_', " "));
    let shown = cases.rows().iter().map(|it| {
        let mut cells = vec![any(&it["case"])];
        cells.extend(cases.inputs().map(|(name, ..)| Cell { kind: "whole", ..any(&it["inputs"][name]) }));
        cells.extend(quantities.iter().map(|(name, _, size)| quantity(&it["quantities"][name.as_str()], *size)));
        cells.extend(is_judged.then(|| verdict_of(it)));
        cells.extend([&it["status"], &it["warnings"]].map(words));
        cells
    });
    let reasons = cases.rows().iter().filter_map(|it| {
        let reason = it["reason"].as_str().filter(|reason| !reason.is_empty())?;
        Some(format!("Case {}: {reason}", it["case"]))
    });
    let which = if cases.are_asked() { "The columns that the scene asks for" } else { "The main quantities" };
    let all = format!("{which}; sweep.csv has their error bars.");
    Some(Table {
        title: "All cases".to_owned(),
        header,
        rows: shown.collect(),
        notes: [all].into_iter().chain(reasons).collect(),
    })
}

/// The verdict of a case, with the limits that it does not keep.
fn verdict_of(row: &Value) -> Cell {
    let verdict = Verdict::deserialize(&row["verdict"]).ok();
    let word = verdict.map_or("", Verdict::name);
    let missed = any(&row["limits"]).text;
    let comma = if missed.is_empty() { "" } else { ": " };
    Cell { kind: verdict::kind(verdict), ..text(format!("{word}{comma}{missed}")) }
}

/// The value of a quantity in a unit of that size, with the digits of its bar.
fn quantity(it: &Value, size: f64) -> Cell {
    let Some(value) = it["value"].as_f64() else {
        return text("\u{2013}");
    };
    let error = it["error"].as_f64().map(|error| error / size);
    let shown = quantity_value(value / size, error, DIGITS);
    Cell {
        text: with_minus(if error == Some(0.0) { without_zeros(shown) } else { shown }),
        si: format!("{value}"),
        is_number: true,
        ..Cell::default()
    }
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
            let mut cells = vec![text(any(&course["strategy"]).text.replace('_', " ").replace('p', "P"))];
            cells.extend(["level", "cells", "unknowns"].map(|key| optional(&level[key])));
            cells.extend(level["value"].as_f64().map(|value| Cell {
                text: with_minus(significant(value, VALUE_DIGITS)),
                si: format!("{value}"),
                is_number: true,
                ..Cell::default()
            }));
            cells.extend(["relative_bar", "relative_error"].map(|key| optional(&level[key])));
            rows.push(cells);
        }
    }
    let header = ["strategy", "level", "triangles", "unknowns", "value", "relative bar", "relative error"];
    let mut table = Table::new("Levels", header, rows);
    let notes = study["notes"].as_array().into_iter().flatten();
    table.notes = notes.filter_map(Value::as_str).map(str::to_owned).collect();
    table.if_any()
}
