//! Scenes with an orbit.

use oilwedge_scene::Scene;
use oilwedge_study::orbit::by_maps;
use oilwedge_study::quantities::*;
use oilwedge_study::result::{RunResult, Status, Verdict};
use oilwedge_study::run_options::EarlierOrbit;
use oilwedge_study::{RunOptions, compile, read, run, warning};
use oilwedge_tests::scenes::parsed;
use oilwedge_tests::scenes::path;

/// One land of a big end, Swift-Stieber: least film 5.7389 um, greatest pressure 43.739 MPa, losses of both lands
/// 1140.17 + 102.81 W by structured finite volumes on two grids, extrapolated; each is within its bar and that of the
/// reference.
#[test]
fn the_big_end_of_the_shipped_scene_is_that_of_finite_volumes() {
    let scene = read(&path("27_big_end_orbit")).expect("a scene");
    let found = run(&scene, &RunOptions::of(&scene)).expect("an orbit");
    let result = &found.result;
    assert_eq!(result.head.status, Status::Converged, "{:?}", result.head.reason);
    let number = |row: &Row| {
        let quantity = result.quantity(row).expect(row.name);
        (quantity.value, quantity.error().expect(row.name))
    };
    let rows: [(&Row, f64, f64, f64); 5] = [
        (&CYCLE_FILM_THICKNESS_MIN, 5.7389e-6, 2e-9, 3e-3),
        (&CYCLE_PRESSURE_MAX, 43.739e6, 0.03e6, 5e-3),
        (&CYCLE_POWER_LOSS, 0.5 * (1140.17 + 102.81), 0.1, 3e-3),
        (&CYCLE_FRICTION_SHEAR_POWER, 0.5 * 1140.17, 0.08, 3e-3),
        (&CYCLE_LOAD_MAX, 0.5 * 207_294.6, 0.5, 1e-5),
    ];
    for (row, reference, uncertain, part) in rows {
        let (value, bar) = number(row);
        assert!((value / reference - 1.0).abs() < part, "{}: {value}", row.name);
        assert!((value - reference).abs() <= bar + uncertain, "{}: {value} {bar}", row.name);
    }
    // 256.86 and 17.27 deg.
    for (row, reference) in [(&CYCLE_FILM_THICKNESS_MIN_CRANK_ANGLE, 256.86), (&CYCLE_PRESSURE_MAX_CRANK_ANGLE, 17.27)]
    {
        let (value, bar) = number(row);
        assert!((value - reference).abs() <= bar, "{}: {value} {bar}", row.name);
    }
    let facts = result.orbit.as_ref().expect("an orbit");
    let last = facts.cycles.last().expect("a cycle");
    assert!(facts.closed && last.steps <= 150 && last.films <= 1600, "{facts:?}");
    assert!(result.balances.force < 1e-5, "{:?}", result.balances);
    // Least film at crank angles of the reference [um].
    let path = found.orbit.expect("a path");
    for (angle, film) in [(10.0, 10.971), (40.0, 7.6423), (90.0, 21.004), (150.0, 10.546)] {
        let [x, y, ..] = path.place(angle).expect("a place");
        let found = 1e6 * (path.clearance - x.hypot(y));
        assert!((found / film - 1.0).abs() < 5e-3, "{angle}: {found}");
    }
}

pub(crate) const SCENE: &str = r#"
bearing = { diameter = "50 mm", length = "25 mm", clearance = "30 um", theory = "short" }
mesh.size = "6 mm"
journal.speed = "3000 rpm"
oil.viscosity = "10 mPa.s"
cavitation.model = "guembel"
load = { harmonics = [{ order = 0, cos = { x = "2 kN" } }, { order = 1, sin = { y = "3 kN" } }], frame = "shell", period = "360 deg" }
orbit = { cycles = 5 }
"#;

/// The usual options but for bars.
fn without_bars(scene: &Scene) -> RunOptions {
    RunOptions { bars: false, ..RunOptions::of(scene) }
}

#[test]
fn too_few_cycles_are_an_answer_with_numbers() {
    let scene = parsed(&SCENE.replace("cycles = 5", "cycles = 1, closure = 1e-12")).expect("a scene");
    let result = run(&scene, &RunOptions::of(&scene)).expect("an orbit").result;
    assert_eq!(result.head.status, Status::NotConverged);
    assert!(
        result.head.reason.as_deref().is_some_and(|reason| reason.starts_with("not closed after 1 cycle")),
        "{:?}",
        result.head.reason
    );
    assert!(result.quantity(&CYCLE_FILM_THICKNESS_MIN).is_some());
}

/// An orbit has the same numbers with and without bars. Frames stand at even crank angles, with the axis of the journal
/// where the path has it.
#[test]
fn an_orbit_is_the_same_without_bars_and_is_drawn_film_by_film() {
    let scene = parsed(SCENE).expect("a scene");
    let with = run(&scene, &RunOptions::of(&scene)).expect("an orbit");
    let options = RunOptions { bars: false, frames: 4, ..RunOptions::of(&scene) };
    let without = run(&scene, &options).expect("an orbit");
    let film = |result: &RunResult| result.quantity(&CYCLE_FILM_THICKNESS_MIN).map(|it| it.value);
    assert_eq!((film(&with.result), with.result.head.status), (film(&without.result), Status::Converged));
    let bar = |result: &RunResult| result.quantity(&CYCLE_FILM_THICKNESS_MIN).and_then(|it| it.error());
    assert!(bar(&with.result).is_some_and(|bar| bar > 0.0));
    assert!(with.frames.is_empty());
    let path = without.orbit.expect("a path");
    assert_eq!(without.frames.len(), 4);
    for (frame, angle) in without.frames.iter().zip([0.0, 90.0, 180.0, 270.0]) {
        assert!((frame.crank_angle - angle).abs() < 1e-9);
        let (_, axis) = frame.picture.lines.iter().find(|(name, _)| name == "journal_axis").expect("an axis");
        let [x, y, ..] = path.place(angle).expect("a place");
        let [from, to] = axis[0];
        assert!((from[0] - x).hypot(from[1] - y) < 1e-9 && (to[2] - from[2] - 0.025).abs() < 1e-12, "{axis:?}");
    }
}

#[test]
fn what_has_no_orbit_is_refused() {
    for (from, to, told) in [
        ("\"guembel\"", "\"jfo\"", "bearing.theory: is \"short\", but cavitation.model is \"jfo\""),
        ("load = ", "ends = ", "orbit: stands without [load]"),
        ("mesh.size = \"6 mm\"", "mesh.tolerance = \"1 %\"", "mesh.tolerance: stands beside [orbit]"),
        ("cycles = 5", "cycles = 1.5", "orbit.cycles: is no whole number"),
        ("cycles = 5", "tolerance = 1", "orbit.tolerance: is not between"),
        ("cycles = 5", "mass = \"-1 kg\"", "orbit.mass: is negative"),
        ("orbit = { cycles = 5 }", "", ""),
    ] {
        let found = parsed(&SCENE.replace(from, to));
        match told {
            "" => {
                let scene = found.expect("a scene");
                let refused = run(&scene, &RunOptions::of(&scene)).expect_err("no steady film").to_string();
                assert!(refused.contains("add [orbit]"), "{refused}");
            }
            told => {
                let refused = found.expect_err(to);
                assert!(refused.contains(told), "{to}: {refused}");
            }
        }
    }
}

/// With a balance of heat the mean flow carries off the mean power, and all bars know that of the temperature.
#[test]
fn one_temperature_balances_the_heat_of_a_cycle() {
    let text = SCENE.replace("oil.viscosity = \"10 mPa.s\"", "oil.grade = \"SAE 30\"\nheat.inlet = \"70 C\"");
    let scene = parsed(&text).expect("a scene");
    let found = run(&scene, &RunOptions::of(&scene)).expect("an orbit");
    let result = &found.result;
    assert_eq!(result.head.status, Status::Converged, "{:?}", result.head.reason);
    let number = |row: &Row| {
        let quantity = result.quantity(row).expect(row.name);
        (quantity.value, quantity.error().expect(row.name))
    };
    let (temperature, bar) = number(&CYCLE_TEMPERATURE);
    let (outlet, _) = number(&CYCLE_TEMPERATURE_OUTLET);
    let (power, flow) = (number(&CYCLE_POWER_LOSS).0, number(&CYCLE_COOLING_FLOW).0);
    assert!(temperature > 71.0 && bar > 0.0 && bar < 1.0, "{temperature} {bar}");
    // The usual heat capacity of oil, 1.8 MJ/(m3 K); fresh oil, so that the mean is midway.
    let carried = 1.8e6 * flow * (outlet - 70.0);
    assert!((carried / power - 1.0).abs() < 1e-3, "{carried} {power}");
    assert!((outlet - 70.0 - 2.0 * (temperature - 70.0)).abs() < 1e-9, "{outlet} {temperature}");
    assert!(result.balances.thermal < 1e-3, "{:?}", result.balances);
    // Maps have the viscosity at the temperature that was found.
    let path = found.orbit.as_ref().expect("a path");
    for map in by_maps(&compile(&scene).expect("a model"), path).expect("maps") {
        let map = map.expect("an orbit");
        assert!(map.film_difference < 1e-2, "{map:?}");
    }
    let parts = result.quantity(&CYCLE_FILM_THICKNESS_MIN).and_then(|it| it.bar).expect("a bar");
    assert!(parts.temperature > 0.0);
    let report = result.temperature.as_ref().expect("a verdict");
    let asked: Vec<_> = report.criteria.iter().map(|it| (&*it.what, it.value)).collect();
    let thinnest = 1e6 * number(&CYCLE_FILM_THICKNESS_MIN).0;
    let wanted = [
        ("least film", thinnest),
        ("temperature of the film", temperature),
        ("temperature of the oil that leaves", outlet),
    ];
    assert_eq!(asked, wanted);
    assert!(report.curve.is_empty() && report.is_fit, "{report:?}");
    // As warm a film without the balance is the same.
    let given = text.replace("heat.inlet = \"70 C\"", &format!("oil.temperature = \"{temperature} C\""));
    let given = parsed(&given).expect("a scene");
    let given = run(&given, &without_bars(&given)).expect("an orbit").result;
    let (alone, balanced) = (given.quantity(&CYCLE_POWER_LOSS).expect("a power").value, power);
    assert!((alone / balanced - 1.0).abs() < 1e-3, "{alone} {balanced}");
}

/// Limits are compared over the cycle, not on the film that is drawn: its pressure is not the greatest.
#[test]
fn limits_are_those_of_the_cycle() {
    let limit = |keys: &str| {
        let scene = parsed(&format!("{SCENE}\n[limits]\n{keys}\n")).expect("a scene");
        run(&scene, &RunOptions::default()).expect("an orbit").result
    };
    let told = |result: &RunResult| {
        let missed = result.criteria.iter().filter(|it| it.is_missed());
        missed.map(|it| it.what.clone()).collect::<Vec<_>>()
    };
    let wide = limit("film_min = \"0.1 um\"\npressure_max = \"100000 bar\"");
    assert_eq!(told(&wide), Vec::<String>::new());
    let greatest = 1e-5 * wide.quantity(&CYCLE_PRESSURE_MAX).expect("a pressure").value;
    // Farther below than the bar is wide: a limit inside it would be undecided.
    let below = 0.9 * greatest;
    let exceeded = limit(&format!("pressure_max = \"{below} bar\""));
    assert_eq!((told(&exceeded), exceeded.criteria[0].verdict), (vec!["greatest pressure".to_owned()], Verdict::Fail));
}

/// An orbit that was not closed goes on where it ended.
#[test]
fn an_orbit_is_continued() {
    let one = parsed(&SCENE.replace("cycles = 5", "cycles = 1, closure = 1e-6")).expect("a scene");
    let first = run(&one, &without_bars(&one)).expect("an orbit").result;
    let facts = first.orbit.expect("an orbit");
    let options =
        RunOptions { earlier: Some(EarlierOrbit { cycles: facts.cycles.len(), end: facts.end }), ..without_bars(&one) };
    let second = run(&one, &options).expect("an orbit").result.orbit.expect("an orbit");
    let two = parsed(&SCENE.replace("cycles = 5", "cycles = 2, closure = 1e-6")).expect("a scene");
    let both = run(&two, &without_bars(&two)).expect("an orbit").result.orbit.expect("an orbit");
    assert_eq!(second.earlier_cycles, 1);
    let apart = (0..2).map(|k| (second.end[k] - both.end[k]).abs()).fold(0.0, f64::max);
    assert!(apart < 1e-4, "{apart}");
    assert!(second.cycles[0].closure < 0.1 * facts.cycles[0].closure, "{second:?} {facts:?}");
}

/// The synthetic big end with oil at 2 bar in its groove, mass-conserving: least film 5.577 um and greatest pressure
/// 45.6 MPa by structured finite volumes, extrapolated from four grids (5.05, 5.41, 5.52 and 5.56 um on 48 x 4 to 384 x
/// 32 cells a land): each to 1 %.
#[test]
fn the_big_end_that_conserves_its_oil_is_that_of_finite_volumes() {
    let scene = read(&path("28_big_end_orbit_conserving")).expect("a scene");
    let result = run(&scene, &without_bars(&scene)).expect("an orbit").result;
    assert_eq!(result.head.status, Status::Converged, "{:?}", result.head.reason);
    for (row, reference, part) in [(&CYCLE_FILM_THICKNESS_MIN, 5.577e-6, 0.01), (&CYCLE_PRESSURE_MAX, 45.6e6, 0.01)] {
        let value = result.quantity(row).expect(row.name).value;
        assert!((value / reference - 1.0).abs() < part, "{}: {value}", row.name);
    }
    assert!(result.mesh.nodes < 3000, "{:?}", result.mesh);
    let [told] = &result.tail.warnings[..] else {
        panic!("{:?}", result.tail.warnings);
    };
    assert!(*told.kind == warning::WARMED, "{}", told.text);
    let cycles = &result.orbit.as_ref().expect("an orbit").cycles;
    let last = cycles.last().expect("a cycle");
    assert!(last.oil_imbalance.is_some_and(|oil| oil < 1e-8), "{last:?}");
    assert!(last.oil_closure.is_some_and(|oil| oil < 1e-3), "{last:?}");
    assert!(result.balances.mass < 1e-8 && result.balances.force < 1e-4, "{:?}", result.balances);
}

/// The scene with a groove at 2 bar all around, and a cavity that conserves its oil.
fn conserving() -> String {
    SCENE
        .replace(", theory = \"short\"", "")
        .replace("\"guembel\"", "\"jfo\"")
        .replace("cycles = 5", "tolerance = 0.03")
        + "\n[[feed]]\ngroup = \"groove\"\ngroove = { width = \"4 mm\" }\npressure = \"2 bar\"\n"
}

#[test]
fn a_finer_mesh_is_within_the_bars_of_an_orbit_that_conserves_its_oil() {
    let solved = |size: &str, bars: bool| {
        let scene = parsed(&conserving().replace("6 mm", size)).expect("a scene");
        let options = RunOptions { bars, ..RunOptions::of(&scene) };
        run(&scene, &options).expect("an orbit").result
    };
    let (coarse, fine) = (solved("6 mm", true), solved("4 mm", false));
    assert_eq!(coarse.head.status, Status::Converged, "{:?}", coarse.head.reason);
    for row in [&CYCLE_FILM_THICKNESS_MIN, &CYCLE_PRESSURE_MAX, &CYCLE_POWER_LOSS] {
        let quantity = coarse.quantity(row).expect(row.name);
        let bar = quantity.bar.expect(row.name);
        let better = fine.quantity(row).expect(row.name).value;
        assert!((quantity.value - better).abs() <= bar.total(), "{}: {} {bar:?} {better}", row.name, quantity.value);
        assert!(bar.discretisation > 0.0 && bar.time > 0.0, "{}: {bar:?}", row.name);
    }
}

/// Between ends at the pressure of the cavity, without a feed, the oil of the start is all there is.
#[test]
fn a_film_without_supply_is_told_to_follow_from_its_start() {
    let told = |text: &str| {
        let scene = parsed(text).expect("a scene");
        let result = run(&scene, &without_bars(&scene)).expect("an orbit").result;
        assert!(result.quantity(&CYCLE_FILM_THICKNESS_MIN).is_some(), "{:?}", result.head.reason);
        result.tail.warnings.iter().any(|warning| warning.kind.code == "from_start")
    };
    let once = conserving().replace("tolerance", "cycles = 1, tolerance");
    assert!(!told(&once));
    let feed = once.find("[[feed]]").expect("a feed");
    assert!(told(&once[..feed]));
}
