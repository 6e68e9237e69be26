//! Tables beside the quantities: balances, assumptions, criteria, meshes, comparisons, and the time.

use oilwedge_study::quantities::{FILM_THICKNESS_MIN, row};
use oilwedge_study::regime::{APART, THIN};
use serde::Serialize;
use serde_json::Value;

use super::quantities::{shown_unit, with_minus};
use crate::digits::{bar, quantity_value, significant};
use crate::readable::readable_unit;

/// Digits of numbers in tables.
const DIGITS: usize = 4;

/// A cell: its text, and the number in SI that it shows.
#[derive(Debug, Clone, Default, Serialize)]
pub(super) struct Cell {
    text: String,
    si: String,
    is_number: bool,
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
    fn new<const N: usize>(title: &str, header: [&str; N], rows: Vec<Vec<Cell>>) -> Self {
        Self {
            title: title.to_owned(),
            header: header.map(str::to_owned).to_vec(),
            rows,
            notes: Vec::new(),
        }
    }

    fn if_any(self) -> Option<Self> {
        (!self.rows.is_empty() || !self.notes.is_empty()).then_some(self)
    }
}

/// A text.
fn text(text: impl Into<String>) -> Cell {
    Cell {
        text: text.into(),
        ..Cell::default()
    }
}

/// A number in its own unit.
fn number(value: f64) -> Cell {
    sized(value, 1.0, "")
}

/// A number in a unit of that size.
fn sized(value: f64, size: f64, unit: &str) -> Cell {
    let shown = with_minus(significant(value / size, DIGITS));
    Cell {
        text: format!("{shown} {unit}").trim_end().to_owned(),
        si: format!("{value}"),
        is_number: true,
    }
}

fn optional(value: &Value) -> Cell {
    value.as_f64().map_or_else(|| text("\u{2013}"), number)
}

/// What must vanish, and what was left of it.
pub(super) fn balances(result: &Value) -> Table {
    let about = [
        ("mass", "oil that enters less oil that leaves, over the oil that passes"),
        ("power", "power put in less dissipation, over all powers"),
        ("moment", "moments of friction less that of the load, over the friction"),
        ("force", "load less force of the film, over the load"),
        ("heat", "heat of friction less heat carried off, over the friction"),
    ];
    let rows = about
        .into_iter()
        .filter_map(|(key, what)| Some(vec![text(what), number(result["balances"][key].as_f64()?)]));
    Table::new("", ["balance", "left over"], rows.collect())
}

/// Which assumptions the film meets.
pub(super) fn assumptions(result: &Value) -> Table {
    let regime = &result["regime"];
    let value = |key: &str| regime[key].as_f64();
    let least_film = result["quantities"][FILM_THICKNESS_MIN.name]["value"].as_f64();
    let micrometres = |value: f64| sized(value, 1e-6, "\u{b5}m");
    let below = |limit: f64| format!("below {}", significant(limit, DIGITS));
    let mut rows = Vec::new();
    let mut add = |what: &str, value: Option<Cell>, limit: String| {
        rows.extend(value.map(|value| vec![text(what), value, text(limit)]));
    };
    add(
        "laminar flow: Reynolds number",
        value("reynolds_number").map(number),
        value("taylor_limit").map(below).unwrap_or_default(),
    );
    add("no inertia: Re c/R", value("inertia").map(number), below(1.0));
    add("thin film: c/R", value("clearance_ratio").map(number), below(THIN));
    add(
        "smooth surfaces: least film over roughness",
        value("roughness_ratio").map(number),
        format!("above {APART}"),
    );
    add(
        "rigid surfaces: elastic deflection",
        value("deflection").map(micrometres),
        least_film.map_or(String::new(), |film| {
            format!(
                "small against the least film, {} \u{b5}m",
                significant(film / 1e-6, DIGITS)
            )
        }),
    );
    add(
        "viscosity law: pressure exponent alpha p",
        value("pressure_exponent").map(number),
        String::new(),
    );
    add(
        "one temperature: rise of the oil that leaves",
        value("temperature_rise").map(|rise| sized(rise, 1.0, "K")),
        String::new(),
    );
    add(
        "density taken for these",
        value("density").map(|density| sized(density, 1.0, "kg/m\u{b3}")),
        String::new(),
    );
    Table::new("", ["assumption", "here", "valid"], rows)
}

/// What the bearing must meet, where the temperature was sought.
pub(super) fn criteria(result: &Value) -> Option<Table> {
    let criteria = result["heat"]["criteria"].as_array()?;
    let rows = criteria.iter().map(|it| {
        let unit = shown_unit(it["unit"].as_str().unwrap_or_default());
        let bound = |key: &str, word: &str| {
            it[key]
                .as_f64()
                .map(|value| format!("{word} {}", significant(value, DIGITS)))
        };
        let bounds: Vec<String> = [bound("least", "at least"), bound("most", "at most")]
            .into_iter()
            .flatten()
            .collect();
        let verdict = match (it["is_met"].as_bool(), it["decides"].as_bool()) {
            (Some(true), _) => "met",
            (_, Some(true)) => "not met",
            _ => "unusual",
        };
        vec![
            text(it["what"].as_str().unwrap_or_default()),
            it["value"]
                .as_f64()
                .map_or_else(Cell::default, |value| sized(value, 1.0, &unit)),
            text(bounds.join(", ")),
            text(verdict),
        ]
    });
    Table::new(
        "Design criteria",
        ["criterion", "here", "bounds", "verdict"],
        rows.collect(),
    )
    .if_any()
}

/// The meshes on the way to a tolerance.
pub(super) fn levels(result: &Value) -> Option<Table> {
    let levels = result["levels"].as_array()?;
    let rows = levels.iter().map(|level| {
        let refinement = level["refinement"].as_str().unwrap_or_default().replace('_', " ");
        vec![
            optional(&level["unknowns"]),
            optional(&level["cells"]),
            text(refinement),
        ]
    });
    Table::new(
        "Meshes towards the tolerance",
        ["unknowns", "triangles", "refinement"],
        rows.collect(),
    )
    .if_any()
}

/// How often expensive operations were done, and the iteration.
pub(super) fn work(result: &Value) -> Table {
    let words = |key: &str| key.replace('_', " ");
    let counts = result["counts"].as_object().into_iter().flatten();
    let rows = counts.map(|(key, count)| vec![text(words(key)), optional(count)]);
    Table::new("Work", ["operation", "count"], rows.collect())
}

/// Steps of the nonlinear iteration.
pub(super) fn history(result: &Value) -> Option<Table> {
    let steps = result["history"].as_array()?.iter();
    let rows = steps.map(|step| ["step", "residual", "active"].map(|key| optional(&step[key])).to_vec());
    Table::new(
        "Nonlinear iteration",
        ["step", "relative residual", "nodes in the cavity"],
        rows.collect(),
    )
    .if_any()
}

/// Wall times [ms], also those of meshes and effects; the only numbers that differ from run to run.
pub(super) fn timings(result: &Value) -> Table {
    let milliseconds = |seconds: &Value| seconds.as_f64().map_or_else(Cell::default, |it| sized(it, 1e-3, ""));
    let parts = result["timing_s"].as_object().into_iter().flatten();
    let mut rows: Vec<Vec<Cell>> = parts
        .map(|(part, it)| vec![text(part.as_str()), milliseconds(it)])
        .collect();
    let levels = (1..).zip(result["levels"].as_array().into_iter().flatten());
    rows.extend(levels.map(|(number, level)| vec![text(format!("mesh {number}")), milliseconds(&level["seconds"])]));
    for cost in result["cost"].as_array().into_iter().flatten() {
        let name = cost["effect"].as_str().unwrap_or_default();
        rows.push(vec![
            text(format!("without {name}")),
            milliseconds(&cost["seconds_without"]),
        ]);
    }
    Table::new("", ["part", "ms"], rows)
}

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
        Self {
            name: text(row.map_or(name, |row| row.what)),
            unit: shown_unit(unit),
            size,
        }
    }

    fn value(&self, value: &Value, error: &Value) -> Cell {
        let Some(value) = value.as_f64() else {
            return text("\u{2013}");
        };
        let error = error.as_f64().map(|error| error / self.size);
        let shown = with_minus(quantity_value(value / self.size, error, DIGITS));
        let bar = error
            .filter(|error| *error > 0.0)
            .map(|error| format!(" \u{b1} {}", bar(error)));
        Cell {
            text: format!("{shown}{} {}", bar.unwrap_or_default(), self.unit)
                .trim_end()
                .to_owned(),
            si: format!("{value}"),
            is_number: true,
        }
    }
}

/// What each effect changes.
fn cost(result: &Value) -> Option<Table> {
    let mut table = Table::new(
        "What the effects change",
        ["without", "quantity", "with", "without", "change"],
        Vec::new(),
    );
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
            table.notes.push(format!(
                "{effect} changes nothing beyond the error bars: it could be left out"
            ));
        }
    }
    table.if_any()
}

/// The film of short and of long bearings.
fn theories(result: &Value) -> Option<Table> {
    let films = result["theories"]["films"].as_array()?;
    let mut table = Table::new(
        "Theories of short and long bearings",
        ["theory", "quantity", "value", "difference"],
        Vec::new(),
    );
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
        table
            .notes
            .push(format!("All films here are without: {}", left_out.join(", ")));
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
    let mut table = Table::new(
        "ISO 7902 (DIN 31652)",
        ["quantity", "film", "standard", "difference"],
        rows.collect(),
    );
    let notes = standard.get("notes").and_then(Value::as_array).into_iter().flatten();
    table.notes = notes.filter_map(Value::as_str).map(str::to_owned).collect();
    table.if_any()
}

/// Comparisons that were asked for.
pub(super) fn comparisons(result: &Value) -> Vec<Table> {
    [cost(result), theories(result), standard(result)]
        .into_iter()
        .flatten()
        .collect()
}

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

/// Any value of JSON in a cell.
fn any(value: &Value) -> Cell {
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

/// The levels of a convergence study.
pub(super) fn study_levels(study: &Value) -> Option<Table> {
    let mut rows = Vec::new();
    for course in study["strategies"].as_array()? {
        for level in course["levels"].as_array().into_iter().flatten() {
            let mut cells = vec![any(&course["strategy"])];
            let keys = ["level", "cells", "unknowns", "value", "relative_bar", "relative_error"];
            cells.extend(keys.map(|key| optional(&level[key])));
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
