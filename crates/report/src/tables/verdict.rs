//! The last line of a run: how it ended, what the film is fit for, and how many warnings there are.

use super::pieces::{counted, status};
use oilwedge_study::result::{Criterion, RunResult, Status, Verdict};

/// Status, verdict of the design criteria where there are any, number of warnings.
pub(crate) fn verdict(result: &RunResult) -> String {
    let mut parts = vec![ending(result)];
    parts.extend(fitness(result));
    parts.push(match result.warnings.len() {
        0 => "no warnings".to_owned(),
        count => counted(count, "warning"),
    });
    format!("verdict   {}", parts.join("; "))
}

/// How the run ended; with a tolerance whether it is met.
fn ending(result: &RunResult) -> String {
    match (result.status, result.levels.is_empty()) {
        (Status::Converged, false) => "converged, within the tolerance".to_owned(),
        (Status::NotConverged, false) => "not converged: the tolerance is not met".to_owned(),
        (ended, _) => status(ended).to_owned(),
    }
}

/// Whether the bearing meets its design criteria, and which it does not.
fn fitness(result: &RunResult) -> Option<String> {
    if result.criteria.is_empty() {
        return None;
    }
    let missed: Vec<&Criterion> = result
        .criteria
        .iter()
        .filter(|criterion| criterion.is_missed())
        .collect();
    let is_open = missed.iter().all(|criterion| criterion.verdict == Verdict::Undecided);
    let faults = || {
        missed
            .iter()
            .map(|criterion| criterion.fault())
            .collect::<Vec<_>>()
            .join(", ")
    };
    Some(match (missed.is_empty(), is_open, result.warnings.is_empty()) {
        (true, _, true) => "fit".to_owned(),
        (true, _, false) => "fit as far as the warnings allow".to_owned(),
        (false, true, _) => format!("open: {}", faults()),
        (false, false, _) => format!("NOT fit: {}", faults()),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tables::run::tests::result;
    use oilwedge_study::result::LevelFacts;
    use oilwedge_study::warning::TURBULENT;

    #[test]
    fn the_verdict_counts_warnings_and_names_what_is_not_met() {
        let mut result = result();
        assert_eq!(verdict(&result), "verdict   converged; no warnings");
        result.levels = vec![LevelFacts::default()];
        result.warnings = vec![TURBULENT.says("so")];
        assert_eq!(verdict(&result), "verdict   converged, within the tolerance; 1 warning");
        result.status = Status::NotConverged;
        let film = Criterion::new("thinnest film", "um", (2.0, None), [Some(3.0), None], true);
        result.criteria = vec![film];
        assert_eq!(
            verdict(&result),
            "verdict   not converged: the tolerance is not met; NOT fit: thinnest film below 3 um; 1 warning"
        );
    }
}
