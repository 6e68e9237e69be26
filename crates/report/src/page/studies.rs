//! Tables of sweeps and convergence studies.

use oilwedge_campaign::convergence::{ConvergenceReport, LevelReport, StrategyLevels};
use oilwedge_scene::sweep::SweepAxis;
use oilwedge_study::result::Verdict;

use crate::criteria;
use crate::digits::{quantity_value, significant};
use crate::readable::plain_words;
use crate::sheet::{Cell, DIGITS, Sheet, count, none, number_as, of_axis, optional, text, without_zeros};
use crate::sweep::{CaseQuantity, CaseRecord, SweepResult};

/// Digits of the value whose convergence is studied.
const VALUE_DIGITS: usize = 9;

/// How many cases there are, and what became of them.
pub(super) fn cases_in_words(rows: &[CaseRecord]) -> String {
    let mut counts: Vec<(String, usize)> = Vec::new();
    for status in rows.iter().map(|row| row.status.replace('_', " ")) {
        match counts.iter_mut().find(|(known, _)| *known == status) {
            Some((_, count)) => *count += 1,
            None => counts.push((status, 1)),
        }
    }
    let each: Vec<String> = counts.iter().map(|(status, count)| format!("{count} {status}")).collect();
    each.join(", ")
}

/// The rows of a sweep: its axes in their order, the columns that the scene asks for or the main quantities, the
/// verdict where the scene sets limits, and how each case ended. A sweep that has not ended has none.
pub(super) fn sweep_rows(sweep: &SweepResult) -> Option<Sheet> {
    let quantities: Vec<(String, &str, f64)> = sweep
        .names(&[])
        .into_iter()
        .filter_map(|name| {
            let (unit, size) = sweep.unit_of(&name)?;
            Some((name, unit, size))
        })
        .collect();
    let is_judged = sweep.rows.iter().any(|it| it.verdict.is_some());
    let mut header = vec!["case".to_owned()];
    header.extend(sweep.axes.iter().map(|axis| plain_words(&axis.name) + &unit_of(&axis.unit)));
    header.extend(quantities.iter().map(|(name, unit, _)| sweep.heading(name) + &unit_of(unit)));
    header.extend(is_judged.then(|| "verdict".to_owned()));
    header.extend(["status", "warnings"].map(str::to_owned));
    let shown = sweep.rows.iter().map(|it| {
        let mut cells = vec![count(it.case)];
        let input = |axis: &SweepAxis| it.inputs.get(&axis.name).map_or_else(Cell::default, of_axis);
        cells.extend(sweep.axes.iter().map(|axis| Cell { kind: "whole", ..input(axis) }));
        cells.extend(quantities.iter().map(|(name, _, size)| quantity(it.quantities.get(name), *size)));
        cells.extend(is_judged.then(|| verdict_of(it)));
        cells.extend([it.status.clone(), it.warnings.join(", ")].map(|words| text(words.replace('_', " "))));
        cells
    });
    let reasons = sweep.rows.iter().filter_map(|it| {
        let reason = it.reason.as_ref().filter(|reason| !reason.is_empty())?;
        Some(format!("Case {}: {reason}", it.case))
    });
    let which = if sweep.columns.is_empty() { "The main quantities" } else { "The columns that the scene asks for" };
    let all = format!("{which}; sweep.csv has their error bars.");
    sweep.complete.then(|| Sheet {
        title: "All cases".to_owned(),
        header,
        rows: shown.collect(),
        notes: [all].into_iter().chain(reasons).collect(),
        ..Sheet::default()
    })
}

/// The verdict of a case, with the limits that it does not keep.
fn verdict_of(row: &CaseRecord) -> Cell {
    let word = row.verdict.map_or("", Verdict::name);
    let missed = row.limits.join(", ");
    let comma = if missed.is_empty() { "" } else { ": " };
    Cell { kind: criteria::kind(row.verdict), ..text(format!("{word}{comma}{missed}")) }
}

/// The value of a quantity in a unit of that size, with the digits of its bar.
fn quantity(it: Option<&CaseQuantity>, size: f64) -> Cell {
    let Some(CaseQuantity { value, error, .. }) = it else {
        return none();
    };
    let error = error.map(|error| error / size);
    let shown = quantity_value(value / size, error, DIGITS);
    number_as(*value, if error == Some(0.0) { without_zeros(shown) } else { shown })
}

fn unit_of(unit: &str) -> String {
    match unit {
        "1" | "" => String::new(),
        unit => format!(", {unit}"),
    }
}

/// The levels of a convergence study.
pub(super) fn study_levels(study: &ConvergenceReport) -> Option<Sheet> {
    let row = |(course, level): (&StrategyLevels, &LevelReport)| {
        let value = number_as(level.value, significant(level.value, VALUE_DIGITS));
        let sizes = [level.level, level.cells, level.unknowns].map(count);
        let errors = [level.relative_bar, level.relative_error].map(optional);
        [text(course.strategy.name())].into_iter().chain(sizes).chain([value]).chain(errors).collect()
    };
    let header = ["strategy", "level", "triangles", "unknowns", "value", "relative bar", "relative error"];
    let mut table = Sheet::new("Levels", header, study.levels().map(row).collect());
    table.notes.clone_from(&study.notes);
    table.if_any()
}
