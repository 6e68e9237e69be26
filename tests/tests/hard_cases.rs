//! Every hard case of `tests/hard_cases` ends as it must; those that take long, and the map of stability, are left to `oilwedge verify --hard`.

use oilwedge_verification::family::Expect;
use oilwedge_verification::run_suite;
use oilwedge_verification::suite::{self, Verdict};

#[test]
fn every_case_is_explained() {
    let mut told = 0;
    let verdicts = run_suite(&[], false, &mut |_| told += 1).expect("the families can be read");
    assert_eq!(told, verdicts.len());
    assert!(verdicts.len() >= 150, "only {} cases", verdicts.len());
    let faults: Vec<String> = (verdicts.iter().filter(|verdict| !verdict.faults.is_empty()))
        .map(|verdict| {
            format!(
                "{} ({}): {}",
                verdict.case.name(),
                verdict.case.family,
                verdict.faults.join("; ")
            )
        })
        .collect();
    assert!(
        faults.is_empty(),
        "{} unexplained:\n{}",
        faults.len(),
        faults.join("\n")
    );
    let bare = |verdict: &&Verdict| verdict.end == Expect::Converged && verdict.against.is_empty();
    assert_eq!(verdicts.iter().find(bare).map(|verdict| verdict.case.name()), None);
    // The suite asks for every way to end.
    for end in [
        Expect::Converged,
        Expect::NoSolution,
        Expect::NotConverged,
        Expect::Refused,
    ] {
        assert!(
            verdicts.iter().any(|verdict| verdict.end == end),
            "no case ends {}",
            end.name()
        );
    }
}

#[test]
fn a_family_that_is_not_there_is_told_with_those_that_are() {
    let error = suite::count(&["moon".to_owned()], true).expect_err("no such family");
    assert!(
        error.to_string().contains("moon") && error.to_string().contains("loads"),
        "{error}"
    );
}
