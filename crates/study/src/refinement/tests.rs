//! Loads that a full film of a given tilt does not carry: the reason bounds them.

use std::path::Path;

use crate::result::{RunResult, Status};
use crate::{RunOptions, parse, run};

/// A full ring with its journal tilted by these slopes [rad], under a load [N, rad].
fn solved(length: f64, tilt: [f64; 2], (force, angle): (f64, f64)) -> RunResult {
    let [x, y] = tilt;
    let text = format!(
        "bearing = {{ diameter = \"100 mm\", length = \"{length} m\", clearance = \"50 um\" }}\noil = {{ viscosity = \"20 mPa.s\" }}\n\
         cavitation = {{ model = \"none\" }}\njournal = {{ speed = \"100 rad/s\", tilt = {{ x = \"{x} rad\", y = \"{y} rad\" }} }}\n\
         load = {{ force = \"{force} N\", angle = \"{angle} rad\" }}\n"
    );
    let scene = parse(&text, Path::new("tilted.toml")).unwrap_or_else(|error| panic!("{error}"));
    let options = RunOptions { max_seconds: f64::INFINITY, ..RunOptions::of(&scene) };
    run(&scene, &options).unwrap_or_else(|error| panic!("{error}")).result
}

/// The number of a reason after these words.
fn number(reason: &str, after: &str) -> f64 {
    let number = reason.split(after).nth(1).and_then(|rest| rest.split(' ').next());
    number.and_then(|number| number.parse().ok()).unwrap_or_else(|| panic!("{reason}"))
}

/// The film of a journal in contact at one end carries a finite force, far below that of one in contact all along: more
/// is refused, less is balanced.
#[test]
fn the_best_contact_bounds_the_load() {
    let at = |force: f64| solved(0.045, [8.8e-4, 1.2e-4], (force, 1.9));
    let refused = at(12e3);
    let reason = refused.head.reason.unwrap_or_default();
    assert_eq!(refused.head.status, Status::NoSolution, "{reason}");
    let carried = number(&reason, "it carries ");
    let below = at(0.8 * carried);
    assert_eq!(below.head.status, Status::Converged, "{carried}: {:?}", below.head.reason);
    assert!(below.balances.force < 1e-10, "{:?}", below.balances);
    let above = at(1.2 * carried);
    assert_eq!(above.head.status, Status::NoSolution, "{carried}: {:?}", above.head.reason);
}

/// A load of many times what the film in contact carries is refused with what that is, under tension too.
#[test]
fn a_load_far_beyond_all_contacts_is_refused() {
    let refused = solved(0.034, [1.77e-3, -8.36e-4], (12.4e3, 0.644));
    let reason = refused.head.reason.unwrap_or_default();
    assert!(refused.head.status == Status::NoSolution && reason.contains("and the load is 7.5"), "{reason}");
}
