//! The hard cases of `tests/hard_cases` that are quick end as they must.

use oilwedge_full::stability::trends::judge_trends;
use oilwedge_verification::family::Expect;
use oilwedge_verification::run_suite;
use oilwedge_verification::suite::{self, CaseVerdict};

/// Families that are solved in a minute together; the others take several, and are left to the command `stability`.
const QUICK: [&str; 13] = [
    "known_values",
    "feed_pressure",
    "grooves",
    "arcs",
    "squeeze",
    "tilt",
    "dynamics",
    "contact",
    "liner",
    "speed",
    "placement",
    "scales",
    "meshes",
];

#[test]
fn every_quick_case_is_explained() {
    let mut told = 0;
    let quick = QUICK.map(str::to_owned);
    let verdicts = run_suite(&quick, false, &mut |series| told += series.len());
    let mut verdicts = verdicts.expect("the families can be read");
    judge_trends(&mut verdicts);
    assert_eq!(told, verdicts.len());
    let all = suite::count(&[], true).expect("the families can be read");
    assert!(all >= 150 && verdicts.len() >= 80, "{} of {all} cases", verdicts.len());
    let faults: Vec<String> = (verdicts.iter().filter(|verdict| !verdict.faults.is_empty()))
        .map(|verdict| format!("{} ({}): {}", verdict.case.name(), verdict.case.family, verdict.faults.join("; ")))
        .collect();
    assert!(faults.is_empty(), "{} unexplained:\n{}", faults.len(), faults.join("\n"));
    let bare = |verdict: &&CaseVerdict| verdict.end == Expect::Converged && verdict.against.is_empty();
    assert_eq!(verdicts.iter().find(bare).map(|verdict| verdict.case.name()), None);
}

#[test]
fn a_family_that_is_not_there_is_told_with_those_that_are() {
    let error = suite::count(&["moon".to_owned()], true).expect_err("no such family");
    assert!(error.to_string().contains("moon") && error.to_string().contains("loads"), "{error}");
}
