//! A run of a crankshaft for people: a row for each bearing.

use super::criteria::judged;
use super::pieces::{heading, status, time};
use super::verdict;
use crate::balances;
use crate::comparison::sheet;
use crate::criteria::of_shaft;
use crate::digits::significant;
use crate::shaft::ShaftBeside;
use crate::shaft_sheet::{bearings, counterweights};
use oilwedge_campaign::shafts;
use oilwedge_study::shaft::ShaftResult;
use std::path::Path;

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
        parts.push(bearings(result).terminal());
        parts.extend(judged(&of_shaft(result), 0));
        parts.extend(beside.iter().map(|(variant, other)| sheet(&shafts(result, *variant, &other.result)).terminal()));
        parts.extend(result.counterweights.iter().map(|it| counterweights(it).terminal()));
        lines.extend(balances::lines(&balances::of_shaft(result)));
    }
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
