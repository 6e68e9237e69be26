//! A run of a crankshaft for people: a row for each bearing.

use super::criteria::judged;
use super::pieces::whole_run;
use super::run::{Written, timing};
use super::verdict::verdict;
use crate::balances;
use crate::comparison::sheet;
use crate::digits::significant;
use crate::shaft::ShaftBeside;
use crate::shaft_sheet::{bearings, counterweights};
use oilwedge_campaign::shafts;
use oilwedge_study::shaft::ShaftResult;

/// Everything about a run of a crankshaft and of those beside it, and what was written.
pub fn shaft_report(result: &ShaftResult, beside: &[ShaftBeside], written: Written) -> String {
    let (mut tables, mut lines) = (Vec::new(), Vec::new());
    let whole = result.as_one();
    if !result.bearings.is_empty() {
        tables.push(bearings(result).terminal());
        tables.extend(judged(&whole));
        tables.extend(beside.iter().map(|(variant, other)| sheet(&shafts(result, *variant, &other.result)).terminal()));
        tables.extend(result.counterweights.iter().map(|it| counterweights(it).terminal()));
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
    lines.push(format!("time      {}", timing(&result.tail)));
    lines.extend(written.lines());
    lines.push(verdict(&whole));
    whole_run(&result.head, tables, &lines)
}
