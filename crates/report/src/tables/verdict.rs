//! The last line of a run: how it ended, what the film is fit for, and how many warnings there are.

use super::pieces::{counted, status};
use oilwedge_study::result::{Criterion, RunResult, Status, Verdict};
use oilwedge_study::shaft::ShaftResult;

/// Most faults that a line names.
const MOST_FAULTS: usize = 3;

/// Status, verdict of the design criteria where there are any, number of warnings.
pub(crate) fn verdict(result: &RunResult) -> String {
    line(ending(result), &result.criteria, result.warnings.len())
}

/// The line of the verdict of a crankshaft, by the criteria of all its bearings.
pub(crate) fn of_shaft(result: &ShaftResult) -> String {
    line(status(result.head.status).to_owned(), &crate::criteria::of_shaft(result), result.warnings.len())
}

fn line(ending: String, criteria: &[Criterion], warnings: usize) -> String {
    let mut parts = vec![ending];
    parts.extend(fitness(criteria, warnings > 0));
    parts.extend(unusual(criteria));
    parts.push(match warnings {
        0 => "no warnings".to_owned(),
        count => counted(count, "warning"),
    });
    format!("verdict   {}", parts.join("; "))
}

/// How the run ended; with a tolerance whether it is met.
fn ending(result: &RunResult) -> String {
    match (result.head.status, result.levels.is_empty()) {
        (Status::Converged, false) => "converged, within the tolerance".to_owned(),
        (Status::NotConverged, false) => "not converged: the tolerance is not met".to_owned(),
        (ended, _) => status(ended).to_owned(),
    }
}

/// Whether the bearing meets its design criteria, and which it does not.
fn fitness(criteria: &[Criterion], has_warnings: bool) -> Option<String> {
    let faults = || faults(criteria.iter().filter(|criterion| criterion.is_missed()));
    Some(match (Verdict::of(criteria)?, has_warnings) {
        (Verdict::Pass, false) => "fit".to_owned(),
        (Verdict::Pass, true) => "fit as far as the warnings allow".to_owned(),
        (Verdict::Undecided, _) => format!("undecided: {}", faults()),
        (Verdict::Fail, _) => format!("NOT fit: {}", faults()),
    })
}

/// The usual values, set by nobody as limits, that are left.
fn unusual(criteria: &[Criterion]) -> Option<String> {
    let left = |criterion: &&Criterion| !criterion.decides && criterion.verdict == Verdict::Fail;
    let told = faults(criteria.iter().filter(left));
    (!told.is_empty()).then(|| format!("beyond usual values: {told}"))
}

fn faults<'a>(criteria: impl Iterator<Item = &'a Criterion>) -> String {
    first_faults(criteria.map(Criterion::fault)).join(", ")
}

/// The first of several faults, and how many more there are.
pub(crate) fn first_faults(all: impl Iterator<Item = String>) -> Vec<String> {
    let mut faults: Vec<String> = all.collect();
    let more = faults.len().saturating_sub(MOST_FAULTS);
    if more > 0 {
        faults.truncate(MOST_FAULTS);
        faults.push(format!("and {more} more"));
    }
    faults
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tables::run::tests::result;
    use oilwedge_study::result::{Accuracy, LevelFacts, Origin};
    use oilwedge_study::warning::TURBULENT;

    #[test]
    fn the_verdict_counts_warnings_and_names_what_is_not_met() {
        let mut result = result();
        assert_eq!(verdict(&result), "verdict   converged; no warnings");
        result.levels = vec![LevelFacts::default()];
        result.warnings = vec![TURBULENT.says("so")];
        assert_eq!(verdict(&result), "verdict   converged, within the tolerance; 1 warning");
        result.head.status = Status::NotConverged;
        let of =
            |value, origin| Criterion::new("least film", "um", (value, Accuracy::NotAsked), [Some(3.0), None], origin);
        result.criteria = vec![of(2.0, Origin::Usual)];
        assert_eq!(
            verdict(&result),
            "verdict   not converged: the tolerance is not met; beyond usual values: least film below 3 um; 1 warning"
        );
        result.criteria = vec![of(2.0, Origin::Scene)];
        assert_eq!(
            verdict(&result),
            "verdict   not converged: the tolerance is not met; NOT fit: least film below 3 um; 1 warning"
        );
    }
}
