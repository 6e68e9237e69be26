//! Limits of time and unknowns: a run ends with its best answer so far, the bars of that, and its status.

use std::time::{Duration, Instant};

use crate::bench::{Bench, edited, object};
use serde_json::Value;

const TIME: [&str; 2] = ["--max-seconds", "0.001"];
const SIZE: [&str; 2] = ["--max-unknowns", "1"];

/// The drawn ring with this below `[mesh]`.
fn drawn(bench: &Bench, mesh: &str) {
    bench.write(
        "scene.toml",
        edited("09_drawn_ring", &[]) + &format!("\n[mesh]\n{mesh}\n"),
    );
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
        assert!(
            result["quantities"]["load"]["error"]
                .as_f64()
                .is_some_and(|bar| bar > 0.0)
        );
        assert_eq!(result["levels"].as_array().map(Vec::len), Some(1));
    }
}

/// Scene 17 takes many films of a mass-conserving model: the search is ended among them, on a mesh of a given size and towards a
/// tolerance.
#[test]
fn the_search_for_a_position_looks_at_the_clock() {
    let bench = Bench::new();
    for (mesh, seconds) in [
        ("size = \"1.5 mm\"", "0.001"),
        ("size = \"1.5 mm\"", "0.3"),
        ("tolerance = \"0.1 %\"", "0.001"),
        ("tolerance = \"0.1 %\"", "0.5"),
    ] {
        bench.scene("17_engine_main_bearing", &[("size = \"1.5 mm\"", mesh)]);
        let result = limited(&bench, &["solve", "scene.toml", "--max-seconds", seconds]);
        is_answered(&result, "--max-seconds");
    }
}

#[test]
fn a_sweep_has_the_limits_of_its_cases() {
    let bench = Bench::new();
    let axes = "\n[sweep]\nforce = [\"4 kN\", \"5 kN\"]\n";
    for (mesh, limit) in [
        ("size = \"1.5 mm\"", TIME),
        ("tolerance = \"0.1 %\"", TIME),
        ("tolerance = \"0.1 %\"", SIZE),
    ] {
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
        assert!(
            levels
                .clone()
                .any(|course| course["levels"].as_array().is_some_and(|levels| !levels.is_empty()))
        );
    }
}

/// Meshes that no machine holds are refused before anything is made.
#[test]
fn a_mesh_of_a_billion_cells_is_refused_at_once() {
    let bench = Bench::new();
    drawn(&bench, "size = \"2 um\"");
    let clock = Instant::now();
    for verb in [
        &["solve", "scene.toml"][..],
        &["check", "scene.toml"],
        &["mesh", "scene.toml", "-o", "liner.msh"],
    ] {
        bench.refuses(verb, &["triangles", "[mesh] size", "larger size"]);
    }
    bench.refuses(
        &["converge", "scene.toml", "--max-seconds", "0.1"],
        &["[mesh] size", "larger size"],
    );
    assert!(clock.elapsed() < Duration::from_secs(10), "{:?}", clock.elapsed());
}
