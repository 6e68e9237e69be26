//! The synthetic big end of the shipped scene: by the short-bearing theory against a closed film, and its energy.

use oilwedge_study::orbit::OrbitPath;
use oilwedge_study::result::{RunResult, Status};
use oilwedge_study::{RunOptions, run};
use oilwedge_tests::orbits_page::{self, MAKE_SHORT, SHORT};

/// The shipped scene with its text changed, without bars.
fn changed(changes: &[(&str, &str)]) -> (RunResult, OrbitPath) {
    let scene = orbits_page::changed(changes);
    let options = RunOptions {
        bars: false,
        ..RunOptions::of(&scene)
    };
    let run = run(&scene, &options).expect("a film");
    assert_eq!(run.result.status, Status::Converged, "{:?}", run.result.reason);
    (run.result, run.orbit.expect("a path"))
}

/// The short half film by quadrature, integrated to 1e-10.
#[test]
fn the_short_film_of_the_big_end_runs_as_the_closed_one() {
    let (result, path) = changed(&MAKE_SHORT);
    // Film, its angle, pressure, its angle (which is found between the films), powers.
    let allowed = [1e-3, 0.1 / 257.31, 2e-3, 3e-2, 1e-3, 1e-3];
    for ((row, factor, name, _, reference), part) in SHORT.iter().zip(allowed) {
        let found = factor * result.quantity(row).expect(row.name).value;
        assert!((found / reference - 1.0).abs() < part, "{name}: {found} {reference}");
    }
    let table = [
        (0.0, 0.774516, 0.214494),
        (40.0, 0.877068, 0.141754),
        (80.0, 0.540122, -0.445705),
        (120.0, 0.630993, -0.501186),
        (180.0, 0.877265, -0.0867924),
        (240.0, 0.804204, 0.42582),
        (300.0, -0.0593062, 0.794719),
        (360.0, -0.846303, 0.153564),
        (420.0, -0.807483, -0.400927),
        (460.0, -0.145695, -0.784717),
        (540.0, 0.846904, -0.185085),
        (600.0, 0.815646, 0.383567),
        (660.0, 0.0793601, 0.826633),
        (700.0, 0.408828, 0.490097),
    ];
    for (angle, x, y) in table {
        let at = path.place(angle).expect("a place").map(|part| part / path.clearance);
        assert!((at[0] - x).hypot(at[1] - y) < 1e-3, "{angle}: {at:?} {x} {y}");
    }
}

/// What turns the journal and the work of the load become heat: to 1e-3 at the default tolerance, and the better the smaller it is.
#[test]
fn the_energy_of_a_cycle_is_balanced() {
    let left = |tolerance: &str| {
        let tolerance = format!("tolerance = {tolerance}");
        let mesh = "[mesh]\nsize = \"16 mm\"\n\n[orbit]";
        let (result, _) = changed(&[("tolerance = 1e-3", &tolerance), ("[orbit]", mesh)]);
        let balances = result.balances;
        assert!(balances.mass < 1e-8, "{balances:?}");
        balances.energy.expect("a balance")
    };
    let [rough, usual, fine] = ["1e-2", "1e-3", "1e-4"].map(left);
    assert!(
        usual < 1e-3 && fine < 0.3 * usual && usual < rough,
        "{rough} {usual} {fine}"
    );
}
