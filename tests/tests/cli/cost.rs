//! `solve --cost`: what each effect changes, by the same numbers as a scene without it.

use oilwedge_tests::bench::{Bench, object, timeless};
use serde_json::Value;

/// The result of a shipped scene with edits, and what was told beside it.
fn costs(name: &str, edits: &[(&str, &str)]) -> (Value, String) {
    let bench = Bench::new();
    bench.scene(name, edits);
    let told = bench.run(&["solve", "scene.toml", "--json", "--cost"]);
    assert_eq!(told.status, 0, "{}", told.stderr);
    let written = std::fs::read_to_string(bench.path().join("out/scene/result.json")).expect("result.json");
    assert_eq!(written, told.stdout);
    (object(&told.stdout), told.stderr)
}

fn by_effect(result: &Value) -> Vec<(&str, &Value)> {
    let list = result["cost"].as_array().expect("a list");
    list.iter().map(|it| (it["effect"].as_str().expect("a name"), it)).collect()
}

/// The value of a quantity of a shipped scene.
fn value(name: &str, edits: &[(&str, &str)], quantity: &str) -> f64 {
    let bench = Bench::new();
    bench.scene(name, edits);
    let told = bench.run(&["solve", "scene.toml", "--json"]);
    let result = object(&told.stdout);
    assert!(result.get("cost").is_none());
    result["quantities"][quantity]["value"].as_f64().expect("a number")
}

#[test]
fn each_effect_of_the_shell_is_left_out_once() {
    let (result, stderr) = costs("12_flexpde_shell_cavitated", &[]);
    assert_eq!(stderr, "", "warnings of the runs without an effect are not those of the result");
    let costs = by_effect(&result);
    let names: Vec<_> = costs.iter().map(|(name, _)| *name).collect();
    assert_eq!(names, ["couette", "barus", "cavitation: reynolds"]);
    for (name, cost) in &costs {
        assert_eq!((&cost["status"], &cost["reason"]), (&"converged".into(), &Value::Null), "{name}");
        assert!(["with", "without"].iter().all(|key| cost[format!("seconds_{key}")].as_f64() > Some(0.0)));
        for quantity in ["load", "attitude_angle", "pressure_max", "film_thickness_min", "side_flow"] {
            let change = &cost["changes"][quantity];
            assert_eq!(change["with"], result["quantities"][quantity]["value"], "{name}, {quantity}");
            assert_eq!(change["unit"], result["quantities"][quantity]["unit"]);
        }
    }
    // Scene 02 is scene 12 without a cavity.
    let full = value("02_flexpde_shell", &[], "load");
    let load = &costs[2].1["changes"]["load"];
    assert_eq!(load["without"].as_f64(), Some(full));
    let [with, change] = ["with", "change"].map(|key| load[key].as_f64().expect("a number"));
    assert!((change - (with - full)).abs() < 1e-12 * with && change > 0.1 * full);
    let constant = [("barus     = { alpha = \"2.5e-8 1/Pa\" }", "")];
    let thin = value("12_flexpde_shell_cavitated", &constant, "load");
    assert_eq!(costs[1].1["changes"]["load"]["without"].as_f64(), Some(thin));
    check_page(&costs);
}

/// The page on effects shows these changes of the load.
fn check_page(costs: &[(&str, &Value)]) {
    let page = oilwedge_tests::program::repository().join("docs/howto/effects.md");
    let page = std::fs::read_to_string(page).expect("the page");
    let row = page.lines().find(|line| line.starts_with("│ load ")).expect("a row of the load");
    let cells: Vec<&str> = row.split('┆').map(str::trim).collect();
    for ((name, cost), cell) in costs.iter().zip(&cells[3..]) {
        let shown: f64 = cell.split(' ').next().and_then(|text| text.parse().ok()).expect("a load");
        let load = cost["changes"]["load"]["without"].as_f64().expect("a number");
        assert!((1e3 * shown / load - 1.0).abs() < 0.01, "{name}: {shown}");
    }
}

#[test]
fn a_journal_that_only_sinks_makes_all_of_its_load_by_squeeze() {
    let (result, _) = costs("15_squeezed_ring", &[]);
    let costs = by_effect(&result);
    let names: Vec<_> = costs.iter().map(|(name, _)| *name).collect();
    assert_eq!(names, ["squeeze", "cavitation: reynolds"]);
    let (_, squeeze) = costs[0];
    assert_eq!((&squeeze["status"], &squeeze["could_be_left_out"]), (&"converged".into(), &false.into()));
    let load = &squeeze["changes"]["load"];
    assert!(load["without"] == 0.0 && load["change"] == load["with"], "{load}");
    assert_eq!(squeeze["changes"]["attitude_angle"]["without"], Value::Null);
}

#[test]
fn a_removal_that_leaves_no_film_tells_why() {
    let jfo = [("\"reynolds\"", "\"jfo\""), ("\"2.5e-8 1/Pa\"", "\"0 1/Pa\"")];
    let (result, _) = costs("12_flexpde_shell_cavitated", &jfo);
    let costs = by_effect(&result);
    let (name, couette) = costs[0];
    assert_eq!((name, &couette["status"]), ("couette", &"no_solution".into()));
    let reason = couette["reason"].as_str().expect("a reason");
    assert!(reason.contains("nothing carries the oil"), "{reason}");
    assert!(couette["changes"].as_object().is_some_and(serde_json::Map::is_empty));
    let barus = costs[1].1;
    assert_eq!(barus["changes"]["load"]["change"], 0.0, "alpha is zero");
}

#[test]
fn a_scene_without_a_film_may_have_one_without_an_effect() {
    let bench = Bench::new();
    bench.scene("02_flexpde_shell", &[("\"10 rad/s\"", "\"100 rad/s\"")]);
    let told = bench.run(&["solve", "scene.toml", "--cost", "--json"]);
    assert_eq!(told.status, 1, "{}", told.stderr);
    let result = object(&told.stdout);
    assert_eq!(result["status"], "no_solution");
    let costs = by_effect(&result);
    let (name, barus) = costs[1];
    let load = &barus["changes"]["load"];
    assert_eq!((name, &barus["status"], &load["with"]), ("barus", &"converged".into(), &Value::Null));
    assert!(load["without"].as_f64() > Some(1e4), "{load}");
    assert_eq!(barus["could_be_left_out"], false);
}

#[test]
fn people_get_a_table_and_the_result_is_the_same() {
    let bench = Bench::new();
    bench.scene("12_flexpde_shell_cavitated", &[]);
    let told = bench.run(&["solve", "scene.toml", "--cost"]);
    assert_eq!((told.status, told.stderr.as_str()), (0, ""));
    for part in ["run time", "without couette", "without barus", "without cavitation: reynolds", " deg"] {
        assert!(told.stdout.contains(part), "no {part:?} in\n{}", told.stdout);
    }
    let written = std::fs::read_to_string(bench.path().join("out/scene/result.json")).expect("result.json");
    let mut with = timeless(object(&written));
    let plain = timeless(object(&bench.run(&["solve", "scene.toml", "--json"]).stdout));
    with.as_object_mut().map(|result| result.remove("cost"));
    assert_eq!(with, plain);
}
