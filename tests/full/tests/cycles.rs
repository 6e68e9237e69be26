//! Cycles of a main bearing under a load table: each closes and carries its load, or says why it does not.

use std::fmt::Write;
use std::path::Path;
use std::sync::atomic::{AtomicU32, Ordering};

use oilwedge_bearing::Clock;
use oilwedge_campaign::design::{DesignEnd, design};
use oilwedge_study::quantities::CYCLE_FILM_THICKNESS_MIN;
use oilwedge_study::result::{RunResult, Status};
use oilwedge_study::{RunOptions, run};
use tempfile::TempDir;

const HALF_GROOVE: &str = "groove = { from = \"0 deg\", to = \"180 deg\", width = \"3 mm\" }";
const GROOVE: &str = "groove = { width = \"3 mm\" }";
const HOLE: &str = "hole = { angle = \"180 deg\", diameter = \"5 mm\" }";
const SWIFT_STIEBER: &str = "reynolds";
const CONSERVING: &str = "jfo";
const WARM: &str = "temperature = \"110 C\"";
const BALANCED: &str = "[heat]\ninlet = \"90 C\"";

/// Inertia that turns with the crank, and the pressure of one firing: force [N] over two turns.
fn load_table(times: f64) -> String {
    let mut table = "angle [deg], Fx [N], Fy [N]\n".to_owned();
    for angle in (0..=144).map(|k| 5.0 * f64::from(k)) {
        let firing = 5000.0 * (-((angle - 380.0) / 35.0_f64).powi(2)).exp();
        let [x, y] = [2500.0 * angle.to_radians().cos() + firing, 2500.0 * angle.to_radians().sin() + 0.2 * firing];
        writeln!(table, "{angle}, {:.1}, {:.1}", times * x, times * y).expect("a row");
    }
    table
}

/// Runs a bearing with a feed under this many times the load, its cavity by this model and its oil at a temperature
/// that is given or found.
fn cycle(feed: &str, model: &str, heat: &str, times: f64, options: &RunOptions) -> RunResult {
    let folder = TempDir::new().expect("a folder");
    std::fs::write(folder.path().join("load.csv"), load_table(times)).expect("a table");
    let text = format!(
        "bearing = {{ diameter = \"54 mm\", length = \"19 mm\", clearance = \"27 um\" }}\n\
         mesh.size = \"14 mm\"\njournal.speed = \"6000 rpm\"\norbit.tolerance = 3e-2\ncavitation.model = \"{model}\"\n\
         load = {{ file = \"load.csv\", frame = \"shell\", period = \"720 deg\" }}\n\
         [[feed]]\ngroup = \"feed\"\n{feed}\npressure = \"4 bar\"\n\
         [oil]\ngrade = \"SAE 5W-30\"\nhigh_shear = \"2.9 mPa.s\"\nroelands = {{ alpha = \"15 1/GPa\" }}\n{heat}\n"
    );
    let scene =
        oilwedge_study::parse(&text, &folder.path().join("cycle.toml")).unwrap_or_else(|error| panic!("{error}"));
    run(&scene, options).expect("an answer").result
}

/// Options without bars and without a limit.
fn numbers() -> RunOptions {
    RunOptions { bars: false, max_seconds: f64::INFINITY, ..RunOptions::default() }
}

#[test]
fn cycles_of_grooved_and_hole_fed_bearings_close() {
    for (feed, model, heat, bars) in [
        (HALF_GROOVE, SWIFT_STIEBER, WARM, true),
        (HOLE, SWIFT_STIEBER, WARM, false),
        (GROOVE, SWIFT_STIEBER, BALANCED, false),
        (HALF_GROOVE, CONSERVING, WARM, false),
        (GROOVE, CONSERVING, WARM, false),
        (HOLE, CONSERVING, WARM, false),
    ] {
        let result = cycle(feed, model, heat, 1.0, &RunOptions { bars, ..numbers() });
        let named = format!("{feed} {model} {heat}");
        assert_eq!(result.head.status, Status::Converged, "{named}: {:?}", result.head.reason);
        let facts = result.orbit.as_ref().expect("an orbit");
        assert!(facts.closed && facts.cycles.len() <= 4, "{named}: {facts:?}");
        // A stage leaves a thousandth of the tolerance of the steps.
        assert!(result.balances.force <= 3e-5, "{named}: {:?}", result.balances);
        assert!(result.balances.mass < 1e-8, "{named}: {:?}", result.balances);
        assert_eq!(result.balances.thermal > 0.0, heat == BALANCED, "{named}: {:?}", result.balances);
        let thinnest = result.quantity(&CYCLE_FILM_THICKNESS_MIN).expect("a film");
        assert!(thinnest.value > 0.5e-6 && thinnest.value < 10e-6, "{named}: {}", thinnest.value);
        assert_eq!(thinnest.error().is_some_and(|bar| bar > 0.0 && bar < 0.2 * thinnest.value), bars, "{named}");
    }
}

/// A load that squeezes the film until the viscosity law has no pressure for it.
#[test]
fn a_load_beyond_the_viscosity_law_is_told_as_that() {
    let result = cycle(GROOVE, CONSERVING, WARM, 4.0, &numbers());
    assert_eq!(result.head.status, Status::NotConverged, "{:?}", result.head.reason);
    let reason = result.head.reason.unwrap_or_default();
    assert!(reason.contains("viscosity law") && reason.contains("lower the load"), "{reason}");
}

/// Whatever is ended before its heat is balanced says by which limit, and what to give.
#[test]
fn a_balance_of_heat_that_was_ended_names_the_limit() {
    static CALLS: AtomicU32 = AtomicU32::new(0);
    for calls in [0.5, 200.0] {
        let clock = Clock::Showing(|| f64::from(CALLS.fetch_add(1, Ordering::Relaxed)));
        let result =
            cycle(GROOVE, SWIFT_STIEBER, BALANCED, 1.0, &RunOptions { max_seconds: calls, clock, ..numbers() });
        assert_eq!(result.head.status, Status::NotConverged);
        let reason = result.head.reason.unwrap_or_default();
        let told = reason.starts_with("limit: the search for the temperature was ended")
            && reason.ends_with(&format!("by --max-seconds {calls}; give --max-seconds a higher limit"));
        assert!(told, "{reason}");
    }
}

/// The film of the cycle is as thin as the limit allows, where a thinner one takes less power.
#[test]
fn a_design_of_a_cycle_ends_at_its_limit() {
    let text = "
bearing = { diameter = \"50 mm\", length = \"25 mm\", clearance = \"30 um\" }
mesh.size = \"8 mm\"
journal.speed = \"3000 rpm\"
oil.viscosity = \"15 mPa.s\"
cavitation.model = \"reynolds\"
orbit = { tolerance = 1e-2 }
criteria = { film_min = \"7 um\" }
[load]
harmonics = [{ order = 0, cos = { x = \"2 kN\" } }, { order = 1, sin = { y = \"3 kN\" } }]
frame = \"shell\"
period = \"360 deg\"
[design]
free = { \"oil.viscosity\" = [\"8 mPa.s\", \"20 mPa.s\"] }
minimise = \"cycle_power_loss\"
";
    let scene = oilwedge_study::parse(text, Path::new("scene.toml")).unwrap_or_else(|error| panic!("{error}"));
    let options = RunOptions { bars: false, ..RunOptions::of(&scene) };
    let asked = scene.design.as_ref().expect("a design");
    let found = design(&scene, asked, &options).unwrap_or_else(|error| panic!("{error}")).record;
    let limit = &found.constraints[0];
    assert!(found.is_met && limit.is_active && (limit.value - 7.0).abs() < 1e-2, "{found:?}");
    assert!(found.end == DesignEnd::Optimum && found.gradient_films == 2 * found.films, "{found:?}");
}
