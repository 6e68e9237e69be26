//! The greatest speeds with a film of the FlexPDE study, by both forms of its equation, against the independent
//! recomputation.

use oilwedge_tests::flexpde_study::limits;

#[test]
fn limits_of_existence() {
    let limits = limits();
    assert_eq!(limits.len(), 10);
    for limit in limits {
        let (liner, eccentricity) = (&limit.liner, limit.eccentricity);
        // Three digits of a coarse mesh, and two.
        for ([reference, found], part) in [(limit.conservative, 5e-3), (limit.as_printed, 2e-2)] {
            assert!((found / reference - 1.0).abs() < part, "{liner} {eccentricity}: {found} {reference}");
        }
    }
}
