//! What the header of a page says first, fit, NOT fit or undecided, and the table of criteria behind it.

use oilwedge_study::result::{Criterion, Reserve, Status, Verdict};
use serde::Serialize;

use crate::readable::printed_unit;
use crate::sweep::CaseRecord;
use crate::tables::first_faults;

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

/// Units of a sentence with their true letters.
fn with_true_letters(sentence: &str) -> String {
    match sentence.rsplit_once(' ') {
        Some((rest, unit)) => format!("{rest} {}", printed_unit(unit)).trim_end().to_owned(),
        None => sentence.to_owned(),
    }
}
