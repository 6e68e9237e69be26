//! What a bearing is judged by, for people: one line a criterion, with value, bar, limit and verdict.

use crate::digits::{bar, quantity_value, significant, unresolved};
use oilwedge_study::result::{Criterion, Reserve, RunResult, Verdict};
use oilwedge_study::shaft::ShaftResult;

/// Digits of a value without a bar.
const DIGITS: usize = 4;

/// The criteria of all bearings of a shaft, each with the name of its bearing.
pub(crate) fn of_shaft(result: &ShaftResult) -> Vec<Criterion> {
    let of_bearings = result.bearings.iter().flat_map(|bearing| {
        bearing.criteria.iter().map(|criterion| Criterion {
            what: format!("{}: {}", super::printable(&bearing.name), criterion.what),
            ..criterion.clone()
        })
    });
    of_bearings.collect()
}

/// The criteria of a bearing and the verdict; nothing where the scene sets none and nothing is usual.
pub(crate) fn criteria(result: &RunResult) -> Option<String> {
    let broken = result.temperature.as_ref().map_or(0, |report| report.broken_assumptions);
    judged(&result.criteria, broken)
}

/// The criteria and the verdict in words, never without reserve beside `broken` assumptions.
pub(crate) fn judged(criteria: &[Criterion], broken: usize) -> Option<String> {
    let lines = criteria.iter().map(|criterion| {
        let told = [value(criterion), criterion.unit.clone()].join(" ");
        let word = match (criterion.decides, criterion.verdict) {
            (true, Verdict::Fail) => "FAIL",
            _ => word(criterion),
        };
        format!("{word:9} {}: {}", criterion.what, told.trim_end())
    });
    let heading = match Verdict::of(criteria) {
        Some(_) => "design criteria",
        None => "usual values, which nobody set as limits",
    };
    let lines: Vec<String> = lines.chain(verdict(criteria, broken)).collect();
    (!criteria.is_empty()).then(|| format!("{heading}\n{}", lines.join("\n")))
}

/// The verdict in a word: a usual value neither passes nor fails.
pub(crate) fn word(criterion: &Criterion) -> &'static str {
    match (criterion.decides, criterion.verdict) {
        (false, Verdict::Fail) => "unusual",
        (false, Verdict::Pass) => "usual",
        (_, verdict) => verdict.name(),
    }
}

/// The verdict in a sentence; none where nothing decides.
fn verdict(criteria: &[Criterion], broken: usize) -> Option<String> {
    let decide = || criteria.iter().filter(|criterion| criterion.decides);
    let has = |reserve| decide().any(|criterion| criterion.reserve == Some(reserve));
    let without_bars = match has(Reserve::NoBars) {
        true => ", by values without error bars: none were asked for",
        false => "",
    };
    let reserve = match broken {
        0 => String::new(),
        1 => ", but 1 assumption of the film is broken: see the warnings".to_owned(),
        several => format!(", but {several} assumptions of the film are broken: see the warnings"),
    };
    Some(match Verdict::of(criteria)? {
        Verdict::Pass => format!("fit       the bearing meets its design criteria{without_bars}{reserve}"),
        Verdict::Fail => format!("NOT fit   the bearing does not meet its design criteria{without_bars}"),
        Verdict::Undecided if has(Reserve::InsideBar) => {
            "undecided a limit lies inside an error bar: a finer mesh decides".to_owned()
        }
        Verdict::Undecided => "undecided the error of a number that is judged is not resolved".to_owned(),
    })
}

fn value(criterion: &Criterion) -> String {
    let value = match (criterion.bar, criterion.reserve) {
        (Some(error), _) if error > 0.0 => {
            let value = quantity_value(criterion.value, Some(error), DIGITS);
            format!("{value} +- {}", bar(error))
        }
        (_, Some(Reserve::NotResolved)) => format!("{} (not resolved)", unresolved(criterion.value)),
        (_, Some(Reserve::NoBars)) => format!("{} (no bar)", significant(criterion.value, DIGITS)),
        _ => significant(criterion.value, DIGITS),
    };
    let bound = |bound: f64| match significant(bound, 6) {
        text if text.contains('.') && !text.contains('e') => {
            text.trim_end_matches('0').trim_end_matches('.').to_owned()
        }
        text => text,
    };
    let limit = if criterion.decides { "wanted" } else { "usual value" };
    match (criterion.least, criterion.most) {
        (Some(least), Some(most)) => format!("{value}, {limit} {} to {}", bound(least), bound(most)),
        (Some(least), None) => format!("{value}, {limit} above {}", bound(least)),
        (None, Some(most)) => format!("{value}, {limit} below {}", bound(most)),
        (None, None) => value,
    }
}
