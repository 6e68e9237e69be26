//! The last line of a run: how it ended, what the film is fit for, and how many warnings there are.

use super::pieces::{counted, status};
use oilwedge_study::result::{Criterion, RunResult, Status, Verdict};

/// Most faults that a line names.
const MOST_FAULTS: usize = 3;

/// Status, with a tolerance whether it is met, verdict of the design criteria where there are any, number of warnings.
pub(crate) fn verdict(RunResult { head, tail, levels, criteria, .. }: &RunResult) -> String {
    let ending = match (head.status, levels.is_empty()) {
        (Status::Converged, false) => "converged, within the tolerance",
        (Status::NotConverged, false) => "not converged: the tolerance is not met",
        (ended, _) => status(ended),
    };
    let mut parts = vec![ending.to_owned()];
    parts.extend(fitness(criteria, !tail.warnings.is_empty()));
    parts.extend(unusual(criteria));
    parts.push(match tail.warnings.len() {
        0 => "no warnings".to_owned(),
        count => counted(count, "warning"),
    });
    format!("verdict   {}", parts.join("; "))
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
        result.tail.warnings = vec![TURBULENT.says("so")];
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
