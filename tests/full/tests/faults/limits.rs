//! Limits of time and unknowns: a run ends with its best answer so far, the bars of that, and its status.

use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};

use oilwedge_bearing::Clock;
use oilwedge_study::result::Status;
use oilwedge_study::{RunOptions, run};
use oilwedge_tests::bench::{Bench, edited, object};
use serde_json::Value;

const TIME: [&str; 2] = ["--max-seconds", "0.001"];
const SIZE: [&str; 2] = ["--max-unknowns", "1"];
/// Part of the load that is unbalanced below which the position has bars.
const NEAR: f64 = oilwedge_bearing::NEAR;

/// The drawn ring with this below `[mesh]`.
fn drawn(bench: &Bench, mesh: &str) {
    bench.write("scene.toml", edited("09_drawn_ring", &[]) + &format!("\n[mesh]\n{mesh}\n"));
}

/// The object that a run prints that was ended by a limit.
fn limited(bench: &Bench, arguments: &[&str]) -> Value {
    let told = bench.run(&[arguments, &["--json"]].concat());
    assert_eq!(told.status, 1, "{arguments:?}: {}", told.stderr);
    object(&told.stdout)
}

fn is_answered(result: &Value, flag: &str) {
    assert_eq!(result["status"], "not_converged");
    let reason = result["reason"].as_str().expect("a reason");
    assert!(reason.starts_with("limit: ") && reason.contains(flag), "{reason}");
    assert!(result["quantities"]["load"]["value"].as_f64().is_some(), "{result}");
}

#[test]
fn a_refinement_ends_with_its_first_mesh() {
    let bench = Bench::new();
    drawn(&bench, "tolerance = \"0.0001 %\"");
    for limit in [TIME, SIZE] {
        let result = limited(&bench, &[&["solve", "scene.toml"], &limit[..]].concat());
        is_answered(&result, limit[0]);
        assert!(result["quantities"]["load"]["error"].as_f64().is_some_and(|bar| bar > 0.0));
        assert_eq!(result["levels"].as_array().map(Vec::len), Some(1));
    }
}

/// Scene 17 takes many films of a mass-conserving model: the search is ended among them, on a mesh of a given size and
/// towards a tolerance.
#[test]
fn the_search_for_a_position_looks_at_the_clock() {
    let bench = Bench::new();
    for (mesh, seconds) in [
        ("size = \"1.5 mm\"", "0.001"),
        ("size = \"1.5 mm\"", "0.05"),
        ("tolerance = \"0.1 %\"", "0.001"),
        ("tolerance = \"0.1 %\"", "0.05"),
    ] {
        bench.scene("17_engine_main_bearing", &[("size = \"1.5 mm\"", mesh)]);
        let result = limited(&bench, &["solve", "scene.toml", "--max-seconds", seconds]);
        is_answered(&result, "--max-seconds");
    }
}

/// Far from the balance, and near it, a search is ended at once: its bars hold what a whole search finds.
#[test]
fn the_bars_of_a_search_that_was_ended_hold_or_are_absent() {
    let bench = Bench::new();
    let mut kinds = [0, 0];
    for force in ["500 N", "2 kN", "5 kN", "20 kN"] {
        bench.scene("17_engine_main_bearing", &[("5 kN", force), ("1.5 mm", "2.5 mm")]);
        let ended = limited(&bench, &[&["solve", "scene.toml"], &TIME[..]].concat());
        let told = bench.run(&["solve", "scene.toml", "--json"]);
        assert_eq!(told.status, 0, "{force}: {}", told.stderr);
        let whole = object(&told.stdout);
        let is_near = ended["balances"]["force"].as_f64().is_some_and(|force| force < NEAR);
        kinds[usize::from(is_near)] += 1;
        for (name, quantity) in ended["quantities"].as_object().expect("quantities") {
            let Some(bar) = quantity["error"].as_f64() else {
                continue;
            };
            let of_whole = &whole["quantities"][name];
            let (here, there) = (quantity["value"].as_f64(), of_whole["value"].as_f64());
            let (here, there) = (here.expect("a value"), there.expect("a value"));
            let room = bar + of_whole["error"].as_f64().unwrap_or(0.0) + 1e-9 * there.abs();
            assert!((here - there).abs() <= room, "{force}: {name} {here} {there} {bar}");
            let is_of_load = name.starts_with("load") || ["sommerfeld_number", "specific_load"].contains(&&**name);
            assert!(is_near || is_of_load, "{force}: {name} has a bar");
        }
    }
    assert!(kinds.iter().all(|&kind| kind > 0), "{kinds:?}");
}

/// A clock that leaps beyond any limit once it was asked so often.
static ASKED: AtomicUsize = AtomicUsize::new(0);

fn leaping() -> f64 {
    let left = ASKED.fetch_update(Ordering::Relaxed, Ordering::Relaxed, |left| left.checked_sub(1));
    if left.is_ok() { 0.0 } else { 1e9 }
}

/// A search on an elastic liner that is ended solves one more film and does not close its wall: the result states what
/// is left of the deflection, and no number that depends on the position has a bar.
#[test]
fn numbers_under_a_wall_that_was_left_open_have_no_bars() {
    let loaded = "[load]\nforce = \"5 kN\"\nangle = \"0 deg\"\n";
    let given = "eccentricity   = 0.8                            # the film at the ends, where there is no pressure, is 0.2 of the clearance\nmin_film_angle = \"0 deg\"\n";
    let text = edited("33_polymer_liner", &[(given, loaded)]);
    let scene = oilwedge_study::parse(&text, Path::new("scene.toml")).unwrap_or_else(|error| panic!("{error}"));
    let mut near = 0;
    for asked in 8..20 {
        ASKED.store(asked, Ordering::Relaxed);
        let options = RunOptions { clock: Clock::Showing(leaping), ..RunOptions::of(&scene) };
        let result = run(&scene, &options).expect("a run").result;
        let left = result.balances.deflection.unwrap_or(0.0);
        if left > 1e-6 {
            near += usize::from(result.balances.force < NEAR);
            let bars = result
                .quantities
                .iter()
                .filter(|quantity| quantity.name == "eccentricity" || quantity.name == "film_thickness_min");
            assert_eq!(result.head.status, Status::NotConverged);
            assert!(bars.into_iter().all(|quantity| quantity.error().is_none()), "{asked}: {left:e}");
        }
    }
    assert!(near > 0, "no wall was left open near a balance");
}

/// One film on a given mesh takes what it takes, and a position on it too where only the unknowns are limited.
#[test]
fn limits_do_not_concern_what_is_not_sought() {
    let bench = Bench::new();
    for scene in ["01_plain_ring", "16_loaded_shell"] {
        bench.scene(scene, &[]);
        let limits = if scene == "01_plain_ring" { [TIME, SIZE].concat() } else { SIZE.to_vec() };
        let told = bench.run(&[&["solve", "scene.toml", "--json"], &limits[..]].concat());
        assert_eq!(told.status, 0, "{scene}: {}", told.stderr);
        assert_eq!(object(&told.stdout)["status"], "converged");
    }
}

#[test]
fn a_sweep_has_the_limits_of_its_cases() {
    let bench = Bench::new();
    let axes = "\n[sweep]\nforce = [\"4 kN\", \"5 kN\"]\n";
    for (mesh, limit) in [("size = \"1.5 mm\"", TIME), ("tolerance = \"0.1 %\"", TIME), ("tolerance = \"0.1 %\"", SIZE)]
    {
        let text = edited("17_engine_main_bearing", &[("size = \"1.5 mm\"", mesh)]);
        bench.write("scene.toml", text + axes);
        let told = bench.run(&[&["sweep", "scene.toml", "--fresh", "--json"], &limit[..]].concat());
        assert_eq!(told.status, 0, "{}", told.stderr);
        for row in object(&told.stdout)["rows"].as_array().expect("rows") {
            is_answered(row, limit[0]);
        }
    }
}

#[test]
fn a_study_has_a_level_in_any_case() {
    let bench = Bench::new();
    for scene in ["01_plain_ring", "16_loaded_shell"] {
        bench.scene(scene, &[]);
        let told = bench.run(&["converge", "scene.toml", "--json", "--max-seconds", "0.001"]);
        assert_eq!(told.status, 0, "{scene}: {}", told.stderr);
        let report = object(&told.stdout);
        assert_eq!(report["status"], "converged");
        let levels = report["strategies"].as_array().expect("strategies").iter();
        assert!(levels.clone().any(|course| course["levels"].as_array().is_some_and(|levels| !levels.is_empty())));
    }
}

/// Meshes that no machine holds are refused before anything is made.
#[test]
fn a_mesh_of_a_billion_cells_is_refused() {
    let bench = Bench::new();
    drawn(&bench, "size = \"2 um\"");
    for verb in [&["solve", "scene.toml"][..], &["check", "scene.toml"], &["mesh", "scene.toml", "-o", "liner.msh"]] {
        bench.refuses(verb, &["triangles", "[mesh] size", "larger size"]);
    }
    bench.refuses(&["converge", "scene.toml", "--max-seconds", "0.1"], &["[mesh] size", "larger size"]);
}
