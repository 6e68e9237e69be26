//! A sweep for people: how its cases ended, what was simulated, the main numbers of the cases.

use std::path::Path;

use oilwedge_reynolds::quantities::deviation::{Sections, common_crown};
use oilwedge_study::column::Column;
use oilwedge_study::quantities::{self, CYCLE_DEVIATION, CYCLE_MIDDLE_FILM_MIN, DEVIATION, MIDDLE_FILM_MIN};
use oilwedge_study::result::headlines;

use super::pieces::{counted, effects, heading, printable, time};
use crate::digits::significant;
use crate::readable::readable_unit;
use crate::sheet::{Sheet, none, numeral, text};
use crate::sweep::{LIMITS, REASON, SweepReport, SweepResult, TextRow, VERDICT, WARNINGS};

/// How many cases have each code.
fn tally(report: &SweepReport, column: &str) -> String {
    let entries = report.tally(column);
    let entries = entries.iter().map(|(entry, count)| format!("{}: {}", printable(entry), counted(*count, "case")));
    match entries.collect::<Vec<_>>() {
        none if none.is_empty() => "none".to_owned(),
        some => some.join("; "),
    }
}

/// Rows that are shown; of more the first and the last.
const SHOWN: usize = 24;
/// Digits of a number without a bar.
const DIGITS: usize = 5;

/// The main numbers of a sweep, for people; where it was written, if it was.
pub fn sweep_report(report: &SweepReport, folder: Option<&Path>) -> String {
    let cases = report.rows.len();
    let counts = [
        ("converged", "converged"),
        ("no_solution", "without a solution"),
        ("not_converged", "not converged"),
        ("bad_scene", "that do not fit their mesh"),
        ("failed", "that no worker could compute"),
    ];
    let counts = counts.map(|(status, words)| (report.count(status), words));
    let counts = (counts.iter()).filter(|(count, _)| *count > 0);
    let counts = counts.map(|(count, words)| format!("{count} {words}"));
    let part = report.identity.part.map(|part| format!("part {part}"));
    let status: Vec<String> = (part.into_iter()).chain([counted(cases, "case")]).chain(counts).collect();
    let mut parts =
        vec![heading(&report.identity.title, &status.join(", ")), effects(&report.effects), body(report, folder)];
    let own = cases - report.kept;
    let mut lines = Vec::new();
    if report.kept > 0 {
        lines.push(format!("kept      {} of an earlier run", counted(report.kept, "case")));
    }
    let each = report.seconds / own.max(1) as f64;
    let of_parts = if report.is_joined { ", added up over all parts" } else { "" };
    lines.push(match own {
        0 => format!("time      {}: nothing was left to compute", time(report.seconds)),
        _ => format!("time      {}: {} a case{of_parts}", time(report.seconds), time(each)),
    });
    lines.extend(folder.map(|folder| written(report, folder)));
    lines.push(format!("warnings  {}", tally(report, WARNINGS)));
    lines.push(format!("limits    {}", tally(report, LIMITS)));
    lines.extend(crown(report));
    parts.push(lines.join("\n"));
    parts.join("\n\n") + "\n"
}

/// The crown that evens the film of all cases, as bearings of one shaft, where films at mid-length and deviations are
/// columns in SI units.
fn crown(report: &SweepReport) -> Option<String> {
    let columns = &report.columns.quantities;
    let place = |rows: [&quantities::Row; 2]| columns.iter().position(|column| rows.contains(&column.row));
    let middle = place([&MIDDLE_FILM_MIN, &CYCLE_MIDDLE_FILM_MIN])?;
    let deviation = place([&DEVIATION, &CYCLE_DEVIATION])?;
    let is_si = report.plan.columns.is_none();
    let sections = report.rows.iter().filter_map(|row| {
        let (middle, deviation) = (report.value(row, middle)?, report.value(row, deviation)?);
        Some(Sections { middle, ends: [middle - deviation; 2] })
    });
    let depth = common_crown(&sections.collect::<Vec<_>>()).filter(|depth| is_si && *depth > 0.0)?;
    Some(format!(
        "crown     {} um at the ends would even the film of all cases, as bearings of one shaft",
        significant(1e6 * depth, 3)
    ))
}

/// The files and where they are.
fn written(report: &SweepReport, folder: &Path) -> String {
    let rotor: String = report.rotor_tables.iter().map(|name| format!(", {name}")).collect();
    format!("written   {}: sweep.csv, sweep.json{rotor}", folder.display())
}

/// A column of numbers that is shown: the quantity by its place among those of the report, its heading, the size of its
/// unit.
struct ShownColumn {
    place: usize,
    heading: String,
    size: f64,
}

/// The columns that the scene asks for, in their units; else the headlines, in units that suit them.
fn shown(report: &SweepReport) -> Vec<ShownColumn> {
    let all: Vec<(usize, &Column)> = report.columns.quantities.iter().enumerate().collect();
    if report.plan.columns.is_some() {
        let column = |&(place, column): &(usize, &Column)| ShownColumn {
            place,
            heading: headed(&column.name, &column.unit),
            size: 1.0,
        };
        return all.iter().map(column).collect();
    }
    let column = |&(place, column): &(usize, &Column)| {
        let values = report.rows.iter().filter_map(|row| report.value(row, place));
        let (unit, size) = readable_unit(values.map(f64::abs).fold(0.0, f64::max), column.row.unit);
        ShownColumn { place, heading: headed(column.row.symbol, unit), size }
    };
    let headlines = headlines(&all, |(_, column)| column.row, &report.effects);
    headlines.into_iter().map(column).collect()
}

fn headed(name: &str, unit: &str) -> String {
    match unit {
        "" | "1" => name.to_owned(),
        unit => format!("{name} [{unit}]"),
    }
}

/// The rows or, of draws, how the quantities are distributed.
fn body(report: &SweepReport, folder: Option<&Path>) -> String {
    match SweepResult::from(report).distribution_sheet() {
        Some(sheet) => sheet.terminal(),
        None => rows(report, folder),
    }
}

fn rows(report: &SweepReport, folder: Option<&Path>) -> String {
    let columns = shown(report);
    let inputs = report.columns.inputs.len();
    let is_judged = report.rows.iter().any(|row| !report.columns.tail(row, VERDICT).is_empty());
    let last = &[VERDICT, WARNINGS][usize::from(!is_judged)..];
    let headings = columns.iter().map(|column| column.heading.clone());
    let header = ["case".to_owned()].into_iter().chain(report.columns.inputs.iter().cloned()).chain(headings);
    let cells = |row: &TextRow| {
        let numbers = columns.iter().map(|column| {
            let value = report.value(row, column.place);
            value.map_or_else(none, |value| numeral(significant(value / column.size, DIGITS)))
        });
        let last = last.iter().map(|name| text(report.columns.tail(row, name)));
        row[..=inputs].iter().map(numeral).chain(numbers).chain(last).collect()
    };
    let count = report.rows.len();
    let cut = count > SHOWN;
    let is_shown = |place: usize| !cut || place < SHOWN / 2 || place >= count - SHOWN / 2;
    let rows = report.rows.iter().enumerate().filter(|(place, _)| is_shown(*place));
    let mut sheet = Sheet {
        header: header.chain(last.iter().map(|&name| name.to_owned())).collect(),
        rows: rows.map(|(_, row)| cells(row)).collect(),
        ..Sheet::default()
    };
    if cut {
        let all = if folder.is_some() { "; all are in sweep.csv" } else { "" };
        sheet.notes.push(format!("the first and the last {} of {count} cases{all}", SHOWN / 2));
    }
    let reason = |row| report.columns.tail(row, REASON);
    let reasons = report.rows.iter().filter(|row| !reason(row).is_empty());
    sheet.notes.extend(reasons.take(REASONS).map(|row| format!("case {}: {}", row[0], reason(row))));
    sheet.terminal()
}

/// Reasons that are shown.
const REASONS: usize = 3;
