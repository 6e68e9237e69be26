//! What the header of a page says first, fit, NOT fit or undecided, and the table of criteria behind it.

use oilwedge_study::result::{Criterion, Reserve, Status, Verdict};
use serde::Serialize;

use super::quantities::{shown_unit, with_minus};
use super::table::{Cell, DIGITS, Table, number_as, sized, text};
use crate::digits::{bar, quantity_value, unresolved};
use crate::sweep::CaseRecord;
use crate::tables::{first_faults, word};

/// The verdict as the header shows it.
#[derive(Debug, Clone, Serialize)]
pub(super) struct Outcome {
    word: String,
    /// How it is coloured: `good`, `bad` or `open`.
    kind: &'static str,
    /// What decides it; empty where all limits are kept without reserve.
    why: String,
}

impl Outcome {
    /// The outcome of a run with these criteria that ended with a status; `None` where the scene sets no limits.
    pub(super) fn of(criteria: &[Criterion], status: Status) -> Option<Self> {
        let verdict = Verdict::of(criteria)?;
        let missed = criteria.iter().filter(|criterion| criterion.is_missed());
        let mut why = first_faults(missed.map(|criterion| with_true_letters(&criterion.fault())));
        if criteria.iter().any(|criterion| criterion.decides && criterion.reserve == Some(Reserve::NoBars)) {
            why.push("by values without error bars: none were asked for".to_owned());
        }
        let is_converged = status == Status::Converged;
        if verdict == Verdict::Pass && !is_converged {
            why.push("the run has not converged".to_owned());
        }
        Some(match verdict {
            Verdict::Fail => Self::new("NOT fit", "bad", &why),
            Verdict::Pass if is_converged => Self::new("fit", "good", &why),
            Verdict::Pass | Verdict::Undecided => Self::new("undecided", "open", &why),
        })
    }

    /// The outcome of a sweep by the verdicts of its cases; `None` where there are none.
    pub(super) fn of_cases(rows: &[CaseRecord]) -> Option<Self> {
        let count = |verdict| rows.iter().filter(|row| row.verdict == Some(verdict)).count();
        let [fit, not, open] = [Verdict::Pass, Verdict::Fail, Verdict::Undecided].map(count);
        let judged = fit + not + open;
        let parts = [(fit, "fit"), (not, "NOT fit"), (open, "undecided")].into_iter();
        let parts: Vec<String> =
            parts.filter(|(count, _)| *count > 0).map(|(count, word)| format!("{count} {word}")).collect();
        let kind = match (fit == judged, fit == 0 && not > 0) {
            (true, _) => "good",
            (_, true) => "bad",
            _ => "open",
        };
        (judged > 0).then(|| Self { word: parts.join(", "), kind, why: String::new() })
    }

    fn new(word: &str, kind: &'static str, why: &[String]) -> Self {
        Self { word: word.to_owned(), kind, why: why.join("; ") }
    }
}

/// What a bearing is judged by, and what is usual.
pub(super) fn table(criteria: &[Criterion]) -> Option<Table> {
    let title = match Verdict::of(criteria) {
        Some(_) => "Design criteria",
        None => "Usual values, which nobody set as limits",
    };
    Table::new(title, ["criterion", "verdict", "here", "error bar", "limit"], criteria.iter().map(row).collect())
        .if_any()
}

/// The worst verdict of a bearing as a cell of a table.
pub(super) fn cell(criteria: &[Criterion]) -> Cell {
    let verdict = Verdict::of(criteria);
    Cell { kind: kind(verdict), ..text(verdict.map_or("\u{2013}", Verdict::name)) }
}

/// How a verdict is coloured.
pub(super) fn kind(verdict: Option<Verdict>) -> &'static str {
    match verdict {
        Some(Verdict::Pass) => "good",
        Some(Verdict::Fail) => "bad",
        Some(Verdict::Undecided) | None => "open",
    }
}

fn row(criterion: &Criterion) -> Vec<Cell> {
    let unit = shown_unit(&criterion.unit);
    let in_unit = |number: String| format!("{} {unit}", with_minus(number)).trim_end().to_owned();
    let value = match criterion.reserve {
        Some(Reserve::NotResolved) => unresolved(criterion.value),
        _ => quantity_value(criterion.value, criterion.bar, DIGITS),
    };
    let bar = match (criterion.bar, criterion.reserve) {
        (Some(0.0), _) => "exact".to_owned(),
        (Some(error), _) => in_unit(bar(error)),
        (None, Some(Reserve::NotResolved)) => "not resolved".to_owned(),
        (None, _) => "not asked for".to_owned(),
    };
    let bound = |limit: Option<f64>| limit.map(|limit| sized(limit, 1.0, &unit).text);
    let limit = match (bound(criterion.least), bound(criterion.most)) {
        (Some(least), Some(most)) => format!("{least} to {most}"),
        (Some(least), None) => format!("above {least}"),
        (None, most) => format!("below {}", most.unwrap_or_default()),
    };
    let usual = if criterion.decides { "" } else { "usual value " };
    vec![
        text(criterion.what.as_str()),
        Cell { kind: kind(criterion.decides.then_some(criterion.verdict)), ..text(word(criterion)) },
        number_as(criterion.value, in_unit(value)),
        Cell { is_number: true, ..text(bar) },
        text(format!("{usual}{limit}")),
    ]
}

/// Units of a sentence with their true letters.
fn with_true_letters(sentence: &str) -> String {
    match sentence.rsplit_once(' ') {
        Some((rest, unit)) => format!("{rest} {}", shown_unit(unit)).trim_end().to_owned(),
        None => sentence.to_owned(),
    }
}
