//! Loads that lead to no orbit, each with its cause in the reason.

use oilwedge_study::result::Status;
use oilwedge_study::{RunOptions, run};

use oilwedge_tests::scenes::parsed;

use crate::orbits_of_scenes::SCENE;

/// Options without bars, and with time enough on a busy machine.
fn options() -> RunOptions {
    RunOptions { bars: false, max_seconds: 600.0, ..RunOptions::default() }
}

/// The scene on a coarse mesh, with long steps.
fn rough() -> String {
    SCENE.replace("6 mm", "10 mm").replace("cycles = 5", "tolerance = 1e-2, cycles = 5")
}

/// A load that no film carries: far too heavy, or led out of the shell of an arc.
#[test]
fn a_load_beyond_the_film_is_told_as_that() {
    let half = "bearing = { arc = { from = \"90 deg\", to = \"270 deg\" }, diameter";
    let whole = "bearing = { diameter";
    let changes: [(&[(&str, &str)], &str); 2] = [
        (&[("2 kN", "2e7 kN"), ("3 kN", "3e7 kN")], "the load squeezes the film out"),
        (
            &[(whole, half), (", theory = \"short\"", "")],
            "no film carries the load at 0.00 deg of cycle 1: it points to 0.0 deg, beyond the shell",
        ),
    ];
    for (changes, told) in changes {
        let text = changes.iter().fold(rough(), |text, (from, to)| text.replace(from, to));
        let scene = parsed(&text).expect("a scene");
        let result = run(&scene, &options()).expect("an answer").result;
        assert_eq!(result.head.status, Status::NoSolution);
        let reason = result.head.reason.as_deref().unwrap_or_default();
        assert!(reason.starts_with(told) && reason.contains("; "), "{reason}");
    }
}

#[test]
fn a_load_at_half_the_speed_of_the_journal_is_told_as_collapse() {
    let turning = "[{ order = 0.5, cos = { x = \"2 kN\" }, sin = { y = \"2 kN\" } }]";
    let (before, rest) = SCENE.split_once("load = { harmonics = ").expect("a load");
    let (_, after) = rest.split_once(", frame").expect("a frame");
    let scene = format!("{before}load = {{ harmonics = {turning}, frame{after}");
    let scene = scene.replace("360 deg", "720 deg").replace("cycles = 5", "cycles = 2, closure = 1e-6");
    let result = run(&parsed(&scene).expect("a scene"), &options()).expect("an orbit").result;
    assert_eq!(result.head.status, Status::NotConverged);
    let reason = result.head.reason.as_deref().unwrap_or_default();
    assert!(reason.starts_with("collapse: 100 % of the load turns at half the speed"), "{reason}");
    assert!(result.tail.warnings.iter().any(|warning| warning.kind.code == "half_speed"));
}
