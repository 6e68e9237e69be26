//! What a bearing is judged by, as a sheet: a row for each criterion, with value, bar, limit and verdict.

use oilwedge_study::result::{Criterion, Reserve, Verdict};

use crate::digits::{quantity_value, unresolved};
use crate::sheet::{Cell, DIGITS, Sheet, WHOLE_LINE, bar_in_words, none, number_as, numeral, sized, text};

/// What a bearing is judged by, and what is usual; nothing where the scene sets no limits and nothing is usual.
pub(crate) fn criteria_sheet(criteria: &[Criterion]) -> Option<Sheet> {
    let title = match Verdict::of(criteria) {
        Some(_) => "design criteria",
        None => "usual values, which nobody set as limits",
    };
    Sheet::new(title, ["criterion", "verdict", "here", "error bar", "limit"], criteria.iter().map(row).collect())
        .if_any()
}

/// The worst verdict of a bearing as a cell of a table.
pub(crate) fn worst(criteria: &[Criterion]) -> Cell {
    let verdict = Verdict::of(criteria);
    Cell { kind: kind(verdict), ..verdict.map_or_else(none, |verdict| text(verdict.name())) }
}

/// How a verdict is coloured.
pub(crate) fn kind(verdict: Option<Verdict>) -> &'static str {
    match verdict {
        Some(Verdict::Pass) => "good",
        Some(Verdict::Fail) => "bad",
        Some(Verdict::Undecided) | None => "open",
    }
}

fn row(criterion: &Criterion) -> Vec<Cell> {
    let unit = if criterion.unit == "1" { "" } else { &criterion.unit };
    let is_unresolved = criterion.reserve == Some(Reserve::NotResolved);
    let value = match is_unresolved {
        true => unresolved(criterion.value),
        false => quantity_value(criterion.value, criterion.bar, DIGITS),
    };
    let bar = match bar_in_words(criterion.bar, is_unresolved, 1.0) {
        number if criterion.bar.is_some_and(|bar| bar > 0.0) => format!("{number} {unit}"),
        words => words,
    };
    let bound = |limit: Option<f64>| limit.map(|limit| sized(limit, 1.0, unit).text);
    let limit = match (bound(criterion.least), bound(criterion.most)) {
        (Some(least), Some(most)) => format!("{least} to {most}"),
        (Some(least), None) => format!("above {least}"),
        (None, most) => format!("below {}", most.unwrap_or_default()),
    };
    let usual = if criterion.decides { "" } else { "usual value " };
    // A usual value neither passes nor fails.
    let word = match (criterion.decides, criterion.verdict) {
        (false, Verdict::Fail) => "unusual",
        (false, Verdict::Pass) => "usual",
        (_, verdict) => verdict.name(),
    };
    vec![
        text(criterion.what.as_str()),
        Cell { kind: kind(criterion.decides.then_some(criterion.verdict)), ..text(word) },
        number_as(criterion.value, format!("{value} {unit}").trim_end()),
        numeral(bar.trim_end()),
        Cell { kind: WHOLE_LINE, ..text(format!("{usual}{limit}")) },
    ]
}
