//! What a bearing is judged by, as a sheet: a row for each criterion, with value, bar, limit and verdict.

use oilwedge_study::result::{Criterion, Reserve, Verdict};

use crate::digits::{quantity_value, significant, unresolved};
use crate::sheet::{Cell, DIGITS, Sheet, WHOLE_LINE, bar_in_words, none, number_as, numeral, sized, text};

/// Digits of the ends of a spread.
const SPREAD_DIGITS: usize = 3;

/// What a bearing is judged by, and what is usual; nothing where the scene sets no limits and nothing is usual.
pub(crate) fn criteria_sheet(criteria: &[Criterion]) -> Option<Sheet> {
    let title = match Verdict::of(criteria) {
        Some(_) => "design criteria",
        None => "usual values, which nobody set as limits",
    };
    let has_spread = criteria.iter().any(|criterion| criterion.spread.is_some());
    let mut header = vec!["criterion", "verdict", "here", "error bar"];
    header.extend(has_spread.then_some("within tolerances"));
    header.push("limit");
    let rows = criteria.iter().map(|criterion| row(criterion, has_spread)).collect();
    let header = header.into_iter().map(str::to_owned).collect();
    Sheet { title: title.to_owned(), header, rows, ..Sheet::default() }.if_any()
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

fn row(criterion: &Criterion, has_spread: bool) -> Vec<Cell> {
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
    let within = |[low, high]: [f64; 2]| {
        let [low, high] = [low, high].map(|value| significant(value, SPREAD_DIGITS));
        numeral(format!("{low} to {high} {unit}").trim_end())
    };
    let spread = || criterion.spread.as_ref().map_or_else(none, |spread| within(spread.range));
    let mut cells = vec![
        text(criterion.what.as_str()),
        Cell { kind: kind(criterion.decides.then_some(criterion.verdict)), ..text(word) },
        number_as(criterion.value, format!("{value} {unit}").trim_end()),
        numeral(bar.trim_end()),
    ];
    cells.extend(has_spread.then(spread));
    cells.push(Cell { kind: WHOLE_LINE, ..text(format!("{usual}{limit}")) });
    cells
}
