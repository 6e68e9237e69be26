//! The last line of a run: how it ended, what the film is fit for, and how many warnings there are.

use super::pieces::{counted, status};
use oilwedge_study::result::{Criterion, RunResult, Status};

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
    let report = result.temperature.as_ref()?;
    let missed = report.criteria.iter().filter(|criterion| criterion.is_missed());
    let missed: Vec<String> = missed.map(Criterion::fault).collect();
    Some(match (report.is_fit, result.warnings.is_empty()) {
        (false, _) => format!("NOT fit: {}", missed.join(", ")),
        (true, true) => "fit".to_owned(),
        (true, false) => "fit as far as the warnings allow".to_owned(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tables::run::tests::result;
    use oilwedge_study::result::{LevelFacts, TemperatureReport};
    use oilwedge_study::warning::TURBULENT;

    #[test]
    fn the_verdict_counts_warnings_and_names_what_is_not_met() {
        let mut result = result();
        assert_eq!(verdict(&result), "verdict   converged; no warnings");
        result.levels = vec![LevelFacts::default()];
        result.warnings = vec![TURBULENT.says("so")];
        assert_eq!(verdict(&result), "verdict   converged, within the tolerance; 1 warning");
        result.status = Status::NotConverged;
        let film = Criterion::new("thinnest film", "um", 2.0, [Some(3.0), None], true);
        result.temperature = Some(TemperatureReport {
            criteria: vec![film],
            ..TemperatureReport::default()
        });
        assert_eq!(
            verdict(&result),
            "verdict   not converged: the tolerance is not met; NOT fit: thinnest film below 3 um; 1 warning"
        );
    }
}
