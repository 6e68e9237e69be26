//! What a bearing is judged by, for people: one line a criterion, with value, bar, limit and verdict.

use crate::digits::significant;
use oilwedge_study::result::{Criterion, RunResult, Verdict};

/// The criteria and the verdict; nothing where the scene sets none.
pub(crate) fn criteria(result: &RunResult) -> Option<String> {
    if result.criteria.is_empty() {
        return None;
    }
    let lines = result.criteria.iter().map(|criterion| {
        let parts = [value(criterion), criterion.unit.clone()];
        let told = parts.join(" ");
        format!("{:9} {}: {}", word(criterion), criterion.what, told.trim_end())
    });
    let lines: Vec<String> = lines.chain([verdict(result)]).collect();
    Some(format!("design criteria\n{}", lines.join("\n")))
}

fn word(criterion: &Criterion) -> &'static str {
    match (criterion.decides, criterion.verdict) {
        (true, Verdict::Fail) => "FAIL",
        (false, Verdict::Fail) => "unusual",
        (_, verdict) => verdict.name(),
    }
}

/// Never without reserve where an assumption is broken.
fn verdict(result: &RunResult) -> String {
    let broken = result
        .temperature
        .as_ref()
        .map_or(0, |report| report.broken_assumptions);
    let reserve = match broken {
        0 => String::new(),
        1 => ", but 1 assumption of the film is broken: see the warnings".to_owned(),
        several => format!(", but {several} assumptions of the film are broken: see the warnings"),
    };
    let missed = || result.criteria.iter().filter(|criterion| criterion.is_missed());
    match missed().next() {
        None => format!("fit       the bearing meets its design criteria{reserve}"),
        Some(_) if missed().all(|criterion| criterion.verdict == Verdict::Undecided) => {
            "open      a limit lies inside an error bar, or the mesh does not resolve the number: a finer mesh decides"
                .to_owned()
        }
        Some(_) => "NOT fit   the bearing does not meet its design criteria".to_owned(),
    }
}

fn value(criterion: &Criterion) -> String {
    let value = significant(criterion.value, 4);
    let value = match criterion.bar {
        Some(bar) if bar > 0.0 => format!("{value} +- {}", significant(bar, 2)),
        None if criterion.verdict == Verdict::Undecided => format!("{value} (not resolved)"),
        _ => value,
    };
    let bound = |bound: f64| match significant(bound, 6) {
        text if text.contains('.') && !text.contains('e') => {
            text.trim_end_matches('0').trim_end_matches('.').to_owned()
        }
        text => text,
    };
    match (criterion.least, criterion.most) {
        (Some(least), Some(most)) => format!("{value}, usual {} to {}", bound(least), bound(most)),
        (Some(least), None) => format!("{value}, wanted above {}", bound(least)),
        (None, Some(most)) => format!("{value}, wanted below {}", bound(most)),
        (None, None) => value,
    }
}
