//! The first minutes: a scene to begin with, its schema, what names mean, and what a change has changed.

use oilwedge_tests::bench::{Bench, object};
use oilwedge_tests::program::repository;
use serde_json::Value;

#[test]
fn a_new_scene_is_solved_as_it_is_and_never_replaced() {
    let bench = Bench::new();
    for kind in ["plain", "hole", "groove", "engine-main", "heat", "pad"] {
        let file = format!("{kind}.toml");
        assert_eq!(bench.run(&["new", &file, "--kind", kind]).status, 0, "{kind}");
        let text = std::fs::read_to_string(bench.path().join(&file)).expect("a scene");
        assert!(text.starts_with("#:schema ./oilwedge.schema.json\n"), "{kind}");
        let told = bench.run(&["solve", &file, "--out", kind]);
        assert_eq!(told.status, 0, "{kind}: {}", told.stderr);
    }
    let schema = std::fs::read_to_string(bench.path().join("oilwedge.schema.json")).expect("a schema");
    assert_eq!(schema, bench.run(&["schema"]).stdout);
    bench.refuses(&["new", "plain.toml"], &["plain.toml exists and is not replaced"]);
    bench.refuses(&["new", "plain"], &["ends in .toml"]);
    bench.write("oilwedge.schema.json", "mine");
    bench.refuses(&["new", "other.toml"], &["oilwedge.schema.json is no schema of oilwedge"]);
}

#[test]
fn wrong_keys_units_and_words_are_refused() {
    let file = repository().join("tests/data/wrong_scenes.json");
    let wrong: Value = serde_json::from_str(&std::fs::read_to_string(file).expect("a file")).expect("JSON");
    let text = wrong["scene"].as_str().expect("a scene");
    let bench = Bench::new();
    let check = |text: &str| {
        bench.write("scene.toml", text);
        bench.run(&["check", "scene.toml"])
    };
    assert_eq!(check(text).status, 0, "{}", check(text).stderr);
    let edits = wrong["edits"].as_array().expect("edits");
    assert!(edits.len() >= 50);
    for edit in edits {
        let [from, to] = [0, 1].map(|k| edit[k].as_str().expect("a text"));
        assert_eq!(check(&text.replacen(from, to, 1)).status, 2, "{to}");
    }
}

#[test]
fn names_are_explained_or_the_nearest_is_offered() {
    let bench = Bench::new();
    let told = bench.run(&["explain", "bearing.clearance"]);
    assert!(told.status == 0 && told.stdout.contains("radial clearance"), "{}", told.stdout);
    assert!(bench.run(&["explain", "jfo"]).stdout.contains("cavitation: jfo (effect)"));
    bench.refuses(&["explain", "clearence"], &["did you mean \"clearance\"?"]);
    bench.refuses(&["explain"], &["NAME"]);
    let all: Value = serde_json::from_str(&bench.run(&["explain", "--all", "--json"]).stdout).expect("JSON");
    for kind in ["key", "quantity", "effect", "field", "warning"] {
        assert!(all.as_array().is_some_and(|all| all.iter().any(|entry| entry["kind"] == kind)), "{kind}");
    }
}

#[test]
fn shells_and_man_are_served() {
    let bench = Bench::new();
    assert!(bench.run(&["completions", "bash"]).stdout.contains("oilwedge"));
    bench.refuses(&["completions", "tcsh"], &["tcsh", "bash"]);
    assert_eq!(bench.run(&["man", "--out", "pages"]).status, 0);
    assert!(bench.path().join("pages/oilwedge-solve.1").is_file());
    bench.write("taken", "");
    assert_eq!(bench.run(&["man", "--out", "taken"]).status, 2);
}

#[test]
fn a_change_of_the_mesh_lies_within_the_bars_and_one_of_the_bearing_does_not() {
    let bench = Bench::new();
    let scene = "17_engine_main_bearing";
    let text = |edit: &[(&str, &str)]| {
        bench.scene(scene, edit);
        std::fs::read_to_string(bench.path().join("scene.toml")).expect("a scene")
    };
    let size = ("\"1.5 mm\"", "\"2.5 mm\"");
    bench.write("b.toml", text(&[("\"1.5 mm\"", "\"2 mm\"")]));
    bench.write("c.toml", text(&[size, ("\"4000 rpm\"", "\"5000 rpm\"")]));
    bench.write("a.toml", text(&[size]));
    let equal = bench.run(&["diff", "a.toml", "a.toml"]);
    assert_eq!((equal.status, equal.stdout.as_str()), (0, "equal\n"));
    let changed = |a: &str, b: &str| {
        let told = bench.run(&["diff", a, b, "--json"]);
        assert_eq!(told.status, 1, "{}", told.stderr);
        object(&told.stdout)
    };
    let exceeds = |difference: &Value| {
        let quantities = difference["quantities"].as_array().expect("quantities").clone();
        assert!(!quantities.is_empty());
        quantities.iter().filter(|it| it["exceeds_bars"] == true).count()
    };
    assert_eq!(bench.run(&["solve", "a.toml", "--out", "results"]).status, 0);
    assert_eq!(bench.run(&["solve", "b.toml", "--out", "finer"]).status, 0);
    let mesh = changed("results", "finer");
    assert_eq!(mesh["keys"][0]["key"], "mesh.size");
    assert_eq!(exceeds(&mesh), 0, "{mesh:#}");
    let speed = changed("a.toml", "c.toml");
    assert_eq!((&speed["keys"][0]["key"], &speed["keys"][0]["b"]), (&"journal.speed".into(), &"5000 rpm".into()));
    assert!(exceeds(&speed) > 5, "{speed:#}");
    assert_eq!(bench.run(&["diff", "a.toml", "results"]).status, 0);
    let told = bench.run(&["diff", "results", "finer"]);
    assert_eq!(told.status, 1, "{}", told.stderr);
    assert!(told.stdout.contains("mesh.size: \"2.5 mm\" -> \"2 mm\""), "{}", told.stdout);
    bench.refuses(&["diff", "a.toml", "absent"], &["absent"]);
}
