//! The page of the suite in Markdown.

use std::collections::BTreeMap;
use std::fmt::Write;

use super::map_picture::{CellMap, Outcome};

use super::map::unexplained;
use oilwedge_study::quantities::{LOAD, Quantity};
use oilwedge_verification::CaseVerdict;
use oilwedge_verification::family::Expect;

/// The page: what was asked, how each case ended, and the maps. `picture` is the file that shows them.
pub fn page(verdicts: &[CaseVerdict], maps: &[CellMap], picture: &str) -> String {
    let mut text = String::from(
        "# Hard cases: where the solver is stable\n\nWritten by `cargo run --release -p oilwedge-full -- stability`; the cases are in `tests/hard_cases`, one file a family, each with its reason. \
         A case is explained if it ends as it must, its balances close, its signs hold, it fits the other cases of its series, and a second method \
         (a finer mesh, another scene that must agree, known values) agrees within the error bars of both.\n\n",
    );
    // Writing to a String cannot fail.
    let _ = summary(&mut text, verdicts);
    let _ = drawn(&mut text, maps, picture);
    let mut family = "";
    for verdict in verdicts {
        if family != verdict.case.family {
            family = verdict.case.family;
            let _ = write!(
                text,
                "\n## {}\n{}\n\n| case | ends | iterations | triangles | load [N] | bar | seconds | against it stands |\n|---|---|---|---|---|---|---|---|\n",
                verdict.title, verdict.reason_of_family
            );
        }
        let _ = row(&mut text, verdict);
    }
    text
}

fn summary(text: &mut String, verdicts: &[CaseVerdict]) -> std::fmt::Result {
    let mut ends: BTreeMap<&str, usize> = BTreeMap::new();
    for verdict in verdicts {
        *ends.entry(verdict.end.name()).or_default() += 1;
    }
    let faulty: Vec<&CaseVerdict> = verdicts.iter().filter(|verdict| !verdict.faults.is_empty()).collect();
    let slowest = verdicts.iter().max_by(|a, b| a.seconds.total_cmp(&b.seconds));
    writeln!(text, "{} cases:", verdicts.len())?;
    for (end, count) in ends {
        writeln!(text, "* {count} end `{end}`")?;
    }
    writeln!(text, "* {} unexplained", faulty.len())?;
    if let Some(slowest) = slowest {
        writeln!(text, "* slowest: {:.1} s, {} ({})", slowest.seconds, slowest.case.name(), slowest.case.family)?;
    }
    for verdict in faulty {
        writeln!(
            text,
            "\nUnexplained: {} ({}): {}",
            verdict.case.name(),
            verdict.case.family,
            verdict.faults.join("; ")
        )?;
    }
    Ok(())
}

fn drawn(text: &mut String, maps: &[CellMap], picture: &str) -> std::fmt::Result {
    if maps.is_empty() {
        return Ok(());
    }
    let cells = || maps.iter().flat_map(|map| map.cells.iter().flatten());
    let answers = cells().filter(|cell| matches!(cell, Outcome::Answer(_))).count();
    let absent = cells().filter(|cell| matches!(cell, Outcome::Absent(_))).count();
    writeln!(
        text,
        "\n## The map\n![eccentricity against the coefficient of the viscosity law over its limit, and against slenderness]({picture})\n\n\
         {} cells: {answers} with an answer, {absent} without a film beyond the limit of the viscosity law.",
        cells().count()
    )?;
    for cell in maps.iter().flat_map(unexplained) {
        writeln!(text, "* unexplained: {cell}")?;
    }
    Ok(())
}

fn row(text: &mut String, verdict: &CaseVerdict) -> std::fmt::Result {
    let result = verdict.result.as_ref();
    let load = result.and_then(|result| result.quantity(&LOAD));
    let bar = load.and_then(Quantity::error).map_or("-".to_owned(), |bar| format!("{bar:.1e}"));
    let load = load.map_or("-".to_owned(), |load| format!("{:.5e}", load.value));
    let against = match verdict.end {
        Expect::Converged => verdict.against.clone(),
        _ => verdict.reason.as_deref().map_or(String::new(), first_words),
    };
    writeln!(
        text,
        "| {} | {} | {} | {} | {load} | {bar} | {:.2} | {} |",
        verdict.case.name(),
        verdict.end.name(),
        result.map_or(0, |result| result.counts.nonlinear_iterations),
        result.map_or(0, |result| result.mesh.cells),
        verdict.seconds,
        against.replace('|', "/")
    )
}

/// The beginning of a reason, in one line.
fn first_words(reason: &str) -> String {
    const LONGEST: usize = 160;
    let line = reason.lines().next().unwrap_or_default();
    match line.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}...", &line[..end]),
        None => line.to_owned(),
    }
}
