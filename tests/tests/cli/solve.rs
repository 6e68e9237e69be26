//! `solve`: the result for people and for scripts, also where there is no film.

use oilwedge_tests::bench::{Bench, object, timeless};
use serde_json::Value;
use std::process::Stdio;

/// Faster than any film of Barus' oil: the limit is at 81.5 rad/s, the fold of the as-printed form at 36.7.
const TOO_FAST: (&str, &str) = ("\"10 rad/s\"", "\"100 rad/s\"");

fn keys(value: &Value) -> Vec<&str> {
    let object = value.as_object().unwrap_or_else(|| panic!("no object: {value}"));
    object.keys().map(String::as_str).collect()
}

/// The keys of the contract, all and no others, sorted.
fn check_keys(result: &Value) {
    let top = [
        "balances",
        "bars",
        "counts",
        "effects",
        "format",
        "geometry",
        "history",
        "levels",
        "linear_solver",
        "mesh",
        "mesh_sha256",
        "quantities",
        "reason",
        "regime",
        "scene",
        "scene_sha256",
        "status",
        "timing_s",
        "title",
        "version",
        "warnings",
    ];
    let counts = [
        "bars",
        "factorisations",
        "films",
        "levels",
        "linear_solves",
        "nonlinear_iterations",
        "position_steps",
        "temperature_steps",
    ];
    let sorted = |value: &Value| {
        let mut keys: Vec<String> = keys(value).into_iter().map(str::to_owned).collect();
        keys.sort_unstable();
        keys
    };
    assert_eq!(sorted(result), top);
    assert_eq!(sorted(&result["counts"]), counts);
    assert_eq!(sorted(&result["effects"]), ["not_simulated", "simulated"]);
    assert_eq!(sorted(&result["geometry"]), ["arc", "clearance", "film_start", "length", "radius", "speed"]);
    assert_eq!(sorted(&result["mesh"]), ["cells", "min_angle_deg", "nodes", "order"]);
    assert_eq!(sorted(&result["balances"]), ["force", "heat", "mass", "moment", "power", "tilt"]);
    assert_eq!(result["format"], "oilwedge-result/1");
    for key in ["scene_sha256", "mesh_sha256"] {
        assert_eq!(result[key].as_str().map(str::len), Some(64));
    }
    for (name, quantity) in result["quantities"].as_object().expect("quantities") {
        let keys = ["error", "error_parts", "symbol", "unit", "value"];
        assert_eq!(sorted(quantity), keys, "{name}");
        assert!(quantity["value"].is_f64(), "{name}");
    }
    for step in result["history"].as_array().expect("history") {
        assert_eq!(sorted(step), ["active", "residual", "step"]);
    }
}

#[test]
fn a_solved_scene_is_one_json_object_and_the_same_in_the_file() {
    let bench = Bench::new();
    bench.scene("02_flexpde_shell", &[]);
    let told = bench.run(&["solve", "scene.toml", "--json"]);
    assert_eq!(told.status, 0, "{}", told.stderr);
    let result = object(&told.stdout);
    check_keys(&result);
    assert_eq!((&result["status"], &result["reason"]), (&"converged".into(), &Value::Null));
    assert_eq!(result["title"], "Hole-fed shell, Barus oil (FlexPDE study)");
    assert_eq!(result["counts"]["linear_solves"], 1);
    for part in ["read", "assemble", "factorise", "solve", "total"] {
        assert!(result["timing_s"][part].as_f64().is_some_and(|seconds| seconds >= 0.0));
    }
    // The default folder is out/NAME.
    let written = std::fs::read_to_string(bench.path().join("out/scene/result.json")).expect("result.json");
    assert_eq!(timeless(object(&written)), timeless(result));
    let names: Vec<_> = bench.files().into_keys().collect();
    let expected = ["out/", "out/scene/", "out/scene/film.vtu", "out/scene/result.json", "scene.toml"];
    assert_eq!(names, expected.map(|name| bench.path().join(name)));
}

#[test]
fn names_of_quantities_are_those_of_the_contract() {
    let bench = Bench::new();
    bench.scene("02_flexpde_shell", &[]);
    let result = object(&bench.run(&["solve", "scene.toml", "--json"]).stdout);
    let expected = [
        "load",
        "load_x",
        "load_y",
        "load_angle",
        "load_coefficient",
        "sommerfeld_number",
        "attitude_angle",
        "eccentricity",
        "min_film_angle",
        "pressure_max",
        "pressure_max_angle",
        "pressure_max_z",
        "pressure_min",
        "film_thickness_min",
        "film_thickness_min_angle",
        "viscosity_max",
        "side_flow",
        "side_flow_low",
        "side_flow_high",
        "inlet_flow",
        "side_flow_number",
        "inlet_flow_number",
        "feed_flow.feed_hole",
        "friction_torque",
        "friction_torque_bearing",
        "friction_coefficient",
        "friction_power",
        "friction_shear_power",
        "friction_pressure_power",
        "pressure_integral",
        "specific_load",
        "load_x.feed_hole",
        "load_y.feed_hole",
    ];
    let mut found = keys(&result["quantities"]);
    found.sort_unstable();
    let mut sorted = expected;
    sorted.sort_unstable();
    assert_eq!(found, sorted);
    // At rest a Sommerfeld number has no meaning, without eccentricity an attitude angle has none.
    let rest = [("\"10 rad/s\"", "\"0 rpm\""), ("eccentricity   = 0.6", "eccentricity = 0")];
    bench.scene("02_flexpde_shell", &rest);
    let result = object(&bench.run(&["solve", "scene.toml", "--json"]).stdout);
    let friction = ["friction_torque", "friction_coefficient", "inlet_flow", "side_flow_number"];
    for name in ["sommerfeld_number", "attitude_angle", "min_film_angle"].into_iter().chain(friction) {
        assert!(result["quantities"].get(name).is_none(), "{name}");
    }
}

#[test]
fn people_get_tables_and_scripts_get_warnings_on_stderr() {
    let bench = Bench::new();
    bench.scene("02_flexpde_shell", &[]);
    let told = bench.run(&["solve", "scene.toml", "--out", "results/a", "--all"]);
    assert_eq!(told.status, 0);
    for part in [
        "converged",
        "poiseuille",
        "not simulated",
        "load_coefficient",
        "20.87",
        "kN",
        "balance",
        "1 linear solve",
        "results/a: result.json, film.vtu",
    ] {
        assert!(told.stdout.contains(part), "no {part:?} in\n{}", told.stdout);
    }
    assert!(!told.stdout.contains("warning:") && told.stderr.starts_with("warning: full Sommerfeld film"));
    assert!(bench.path().join("results/a/film.vtu").is_file());
}

/// Exit status 1, a reason with `words`, and no number, whether printed or as JSON.
fn no_solution(name: &str, words: &[&str]) {
    let bench = Bench::new();
    bench.scene(name, &[TOO_FAST]);
    let told = bench.run(&["solve", "scene.toml", "--json"]);
    assert_eq!(told.status, 1, "{}", told.stderr);
    let result = object(&told.stdout);
    check_keys(&result);
    assert_eq!(result["status"], "no_solution");
    assert!(keys(&result["quantities"]).is_empty());
    let reason = result["reason"].as_str().expect("a reason");
    let written = std::fs::read_to_string(bench.path().join("out/scene/result.json")).expect("result.json");
    assert_eq!(timeless(object(&written)), timeless(result.clone()));
    assert!(!bench.path().join("out/scene/film.vtu").exists());
    let people = bench.run(&["solve", "scene.toml"]);
    assert_eq!(people.status, 1);
    assert!(people.stdout.contains("there is no solution") && people.stdout.contains(reason));
    for word in words {
        assert!(reason.contains(word), "no {word:?} in {reason}");
    }
}

#[test]
fn barus_past_its_limit_has_no_solution() {
    no_solution(
        "02_flexpde_shell",
        &["at which the viscosity law makes the pressure infinite", "at 81.4", "lower speed"],
    );
}

#[test]
fn the_printed_equation_past_its_fold_has_no_solution() {
    no_solution("06_flexpde_as_printed", &["no solution above 36.7", "form = \"conservative\""]);
}

#[test]
fn a_limit_that_leaves_a_tolerance_unmet_ends_with_one() {
    let bench = Bench::new();
    let clearance = "clearance = \"37.5 um\"\n";
    let tolerance = format!("{clearance}[mesh]\ntolerance = \"0.000001 %\"\n");
    bench.scene("09_drawn_ring", &[(clearance, &tolerance)]);
    let told = bench.run(&["solve", "scene.toml", "--json", "--max-unknowns", "3000"]);
    assert_eq!(told.status, 1, "{}", told.stderr);
    let result = object(&told.stdout);
    check_keys(&result);
    assert_eq!(result["status"], "not_converged");
    let reason = result["reason"].as_str().expect("a reason");
    assert!(reason.starts_with("limit: ") && reason.contains("--max-unknowns"), "{reason}");
    assert!(result["quantities"]["load"]["error"].is_f64());
    assert!(result["levels"].as_array().is_some_and(|levels| levels.len() > 1));
    assert!(bench.path().join("out/scene/film.vtu").is_file());
    let people = bench.run(&["solve", "scene.toml", "--max-unknowns", "3000"]);
    assert_eq!(people.status, 1);
    for part in ["bar       of the load", "levels    ", reason] {
        assert!(people.stdout.contains(part), "no {part:?} in\n{}", people.stdout);
    }
}

#[test]
fn bars_are_left_out_where_they_are_not_wanted() {
    let bench = Bench::new();
    bench.scene("09_drawn_ring", &[]);
    let told = bench.run(&["solve", "scene.toml", "--json", "--bars", "none"]);
    assert_eq!(told.status, 0, "{}", told.stderr);
    let result = object(&told.stdout);
    check_keys(&result);
    assert_eq!((&result["bars"], &result["counts"]["bars"]), (&false.into(), &0.into()));
    let quantities = result["quantities"].as_object().expect("quantities");
    assert!(quantities.values().all(|it| it["error"].is_null() && it["error_parts"].is_null()));
    let people = bench.run(&["solve", "scene.toml", "--bars", "none"]);
    assert!(!people.stdout.contains("± error") && !people.stdout.contains("levels    "));
    let people = bench.run(&["solve", "scene.toml"]);
    assert!(people.stdout.contains("± error") && people.stdout.contains("levels    "));
}

#[test]
fn unrolled_changes_the_picture_only() {
    let bench = Bench::new();
    bench.scene("02_flexpde_shell", &[]);
    let result = |arguments: &[&str]| timeless(object(&bench.run(arguments).stdout));
    let cylinder = result(&["solve", "scene.toml", "--json", "--out", "cylinder"]);
    let plane = result(&["solve", "scene.toml", "--json", "--out", "plane", "--unrolled"]);
    assert_eq!(cylinder, plane);
    let picture = |folder: &str| std::fs::read(bench.path().join(folder).join("film.vtu")).expect("film.vtu");
    assert!(picture("cylinder") != picture("plane"));
}

#[test]
fn a_reader_that_goes_away_is_no_fault() {
    let bench = Bench::new();
    bench.scene("01_plain_ring", &[]);
    let mut child = oilwedge_tests::program::oilwedge_command()
        .args(["solve", "scene.toml"])
        .current_dir(bench.path())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .expect("oilwedge starts");
    drop(child.stdout.take());
    assert_eq!(child.wait().expect("it ends").code(), Some(0));
}

/// Multigrid solves the quadratic film, and cubic elements on top of it judge it: both end by the balance of oil.
#[test]
fn oil_balances_where_multigrid_solves() {
    let bench = Bench::new();
    let name = "10_drawn_liner";
    let cavity = [("[oil]", "[cavitation]\nmodel = \"reynolds\"\n[oil]")];
    for edits in [&[][..], &cavity] {
        bench.scene(name, edits);
        let result = object(&bench.run(&["solve", "scene.toml", "--json"]).stdout);
        assert_eq!(result["linear_solver"]["route"], "multigrid", "{name}");
        let open = result["balances"]["mass"].as_f64().expect("a number");
        assert!(open < 1e-10, "{name}: {open:e}");
    }
}
