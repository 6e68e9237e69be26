//! A run of a crankshaft for people: a row for each bearing.

use super::criteria::{judged, of_shaft};
use super::pieces::{heading, printable, status, table, time};
use super::verdict;
use crate::digits::{bar, significant};
use crate::readable::readable_unit;
use crate::shaft::ShaftBeside;
use oilwedge_study::quantities::{
    CYCLE_FILM_THICKNESS_MIN, CYCLE_FILM_THICKNESS_MIN_CRANK_ANGLE, CYCLE_LOAD_MAX, CYCLE_POWER_LOSS,
    CYCLE_PRESSURE_MAX, CYCLE_SIDE_FLOW, CYCLE_TEMPERATURE, FILM_THICKNESS_MIN, FRICTION_POWER, LOAD, LOAD_ANGLE,
    PRESSURE_MAX, Row, SIDE_FLOW, TEMPERATURE_EFFECTIVE, Unit,
};
use oilwedge_study::shaft::{BearingReport, CounterweightReport, ShaftResult, Variant};
use std::path::Path;

/// Digits of a value.
const DIGITS: usize = 4;

/// Headings of the columns, and the rows of the catalogue that they hold.
type Columns = [(&'static str, &'static Row); 7];

const AT_REST: Columns = [
    ("force", &LOAD),
    ("least film", &FILM_THICKNESS_MIN),
    ("towards", &LOAD_ANGLE),
    ("p_max", &PRESSURE_MAX),
    ("power", &FRICTION_POWER),
    ("side flow", &SIDE_FLOW),
    ("temperature", &TEMPERATURE_EFFECTIVE),
];
const OVER_CYCLE: Columns = [
    ("greatest load", &CYCLE_LOAD_MAX),
    ("least film", &CYCLE_FILM_THICKNESS_MIN),
    ("at crank angle", &CYCLE_FILM_THICKNESS_MIN_CRANK_ANGLE),
    ("p_max", &CYCLE_PRESSURE_MAX),
    ("mean power", &CYCLE_POWER_LOSS),
    ("side flow", &CYCLE_SIDE_FLOW),
    ("temperature", &CYCLE_TEMPERATURE),
];

/// Everything about a run of a crankshaft and of those beside it; `files` are those that were written to the folder.
pub fn shaft_report(
    result: &ShaftResult,
    beside: &[ShaftBeside],
    folder: &Path,
    (files, pictures): (&[String], &str),
) -> String {
    let mut parts = vec![heading(&result.head.title, status(result.head.status))];
    if let Some(reason) = &result.head.reason {
        parts.push(format!("reason: {reason}"));
    }
    let mut lines = Vec::new();
    if !result.bearings.is_empty() {
        parts.push(bearings(result));
        parts.extend(judged(&of_shaft(result), 0));
        parts.extend(beside.iter().map(|(variant, other)| compared(result, *variant, &other.result)));
        lines.push(balance(result));
    }
    lines.extend(result.counterweights.iter().flat_map(counterweights));
    lines.extend(result.cycles.last().map(|last| {
        format!(
            "cycle     {} cycles, the last one in {} steps with {} films of all bearings; it ends {} of the clearance from where it began",
            result.cycles.len(),
            last.steps,
            last.films,
            significant(last.closure, 2)
        )
    }));
    let parts_of_time = result.timing_s.iter().map(|(part, seconds)| format!("{part} {}", time(*seconds)));
    lines.push(format!("time      {}", parts_of_time.collect::<Vec<_>>().join(", ")));
    lines.push(format!("written   {}: {}", folder.display(), files.join(", ")));
    lines.extend(pictures.lines().map(str::to_owned));
    lines.push(verdict::of_shaft(result));
    parts.push(lines.join("\n"));
    parts.join("\n\n") + "\n"
}

/// The counterweights before and after, and what they do.
fn counterweights(found: &CounterweightReport) -> Vec<String> {
    let film = |[before, after]: [f64; 2]| {
        let [before, after] = [before, after].map(|film| in_unit(film, None, Unit::Metre));
        format!("{before} -> {after}")
    };
    let taken = match found.part {
        0.0 => "the counterweights stay: the shaft of the scene fares no better on any part of the way".to_owned(),
        1.0 => "they are moved all the way".to_owned(),
        part => format!("they are moved {part} of the way: further on the shaft of the scene fares no better"),
    };
    let mut lines = vec![format!(
        "weights   least film of all bearings {}; by maps, the shaft cut at its bearings and the counterweights moved all the way, {}; {} shafts were tried; {taken}",
        found.film.map_or("not found".to_owned(), film),
        film(found.film_by_maps),
        found.asked
    )];
    for web in &found.webs {
        let [before, after] = web.moment.map(|moment| significant(1e3 * moment, DIGITS));
        let [from, to] = web.angle_deg.map(|angle| significant(angle, DIGITS));
        lines.push(format!(
            "          throw {} web {}: {before} kg mm at {from} deg -> {after} kg mm at {to} deg from the throw",
            web.throw, web.web
        ));
    }
    lines
}

/// The columns of a shaft at rest or over a cycle that its bearings have: the load first, the least film second.
fn columns(result: &ShaftResult) -> Vec<(&'static str, &'static Row)> {
    let has = |row: &Row| result.bearings.iter().any(|bearing| bearing.quantity(row).is_some());
    let columns = if has(&CYCLE_LOAD_MAX) { OVER_CYCLE } else { AT_REST };
    columns.into_iter().filter(|(_, row)| has(row)).collect()
}

fn bearings(result: &ShaftResult) -> String {
    let columns = columns(result);
    let headings = columns.iter().map(|(heading, _)| *heading);
    let mut rows = table(["bearing", "z"].into_iter().chain(headings).chain(["tilt"]), 1..columns.len() + 3);
    for bearing in &result.bearings {
        let numbers = columns.iter().map(|(_, row)| number(bearing, row));
        let name = printable(&bearing.name);
        let mut cells = vec![name, in_unit(bearing.at, None, Unit::Metre)];
        cells.extend(numbers);
        cells.push(in_unit(bearing.tilt_max, bearing.tilt_max_error, Unit::Radian));
        rows.add_row(cells);
    }
    rows.to_string()
}

/// Loads and least films of two shafts, and how far the other is off.
fn compared(own: &ShaftResult, variant: Variant, other: &ShaftResult) -> String {
    if let (true, Some(reason)) = (other.bearings.is_empty(), &other.head.reason) {
        return format!("beside {}: {reason}", variant.words());
    }
    let columns = columns(own);
    let headings = [columns[0], columns[1]].map(|(heading, _)| [heading, variant.name(), "change"]);
    let mut rows = table(["bearing"].into_iter().chain(headings.into_iter().flatten()), 1..7);
    for (bearing, beside) in own.bearings.iter().zip(&other.bearings) {
        let mut cells = vec![printable(&bearing.name)];
        for (_, row) in [columns[0], columns[1]] {
            let change = bearing.quantity(row).zip(beside.quantity(row));
            cells.extend([number(bearing, row), number(beside, row)]);
            cells.push(change.map_or(String::new(), |(a, b)| format!("{:+.1} %", 1e2 * (b.value / a.value - 1.0))));
        }
        rows.add_row(cells);
    }
    format!("beside {}:\n{rows}", variant.words())
}

fn number(bearing: &BearingReport, row: &'static Row) -> String {
    match bearing.quantity(row) {
        Some(quantity) => in_unit(quantity.value, quantity.error(), row.unit),
        None => String::new(),
    }
}

fn in_unit(value: f64, error: Option<f64>, unit: Unit) -> String {
    let (name, size) = readable_unit(value, unit);
    let value = significant(value / size, DIGITS);
    match error {
        Some(error) if error > 0.0 => format!("{value} ± {} {name}", bar(error / size)),
        _ => format!("{value} {name}"),
    }
}

fn balance(result: &ShaftResult) -> String {
    let part = |value: f64| significant(value, 2);
    let balances = result.balances;
    let mut line = format!(
        "balance   loads and film forces differ by {} of the loads, their moments by {}",
        part(balances.force),
        part(balances.moment)
    );
    if let Some(power) = balances.power {
        line += &format!(", powers by {} of the dissipation", part(power));
    }
    let energies = result.bearings.iter().filter_map(|bearing| bearing.energy);
    if let Some(worst) = energies.reduce(f64::max) {
        line += &format!(", energy over the cycle of a bearing by {} of the dissipation", part(worst));
    }
    line
}
