//! `characteristics`: sixteen numbers on the terminal and for scripts, scenes that have none, and the reference page.

use oilwedge_tests::bench::{Bench, object};
use oilwedge_tests::program::repository;
use serde_json::Value;
use std::collections::BTreeSet;

const PLAIN: &str = r#"
bearing = { diameter = "100 mm", length = "50 mm", clearance = "50 um" }
mesh.tolerance = "1 %"
journal = { speed = "30 rad/s", eccentricity = 0.6, min_film_angle = "30 deg", squeeze = { radial = "-0.03 mm/s" } }
oil.viscosity = "20 mPa.s"
cavitation.model = "reynolds"
"#;

/// All keys of an object and of those within it, lists by their first entry.
fn keys(value: &Value, path: &str, found: &mut BTreeSet<String>) {
    match value {
        Value::Object(object) => {
            for (key, value) in object {
                keys(value, &format!("{path}.{key}"), found);
                found.insert(format!("{path}.{key}"));
            }
        }
        Value::Array(entries) => entries.iter().take(1).for_each(|entry| keys(entry, path, found)),
        _ => {}
    }
}

#[test]
fn a_parallel_journal_has_seven_numbers_and_a_sum_that_is_too_strong() {
    let bench = Bench::new();
    bench.write("scene.toml", PLAIN);
    let told = bench.run(&["characteristics", "scene.toml"]);
    assert_eq!((told.status, told.stderr.as_str()), (0, ""), "{}", told.stdout);
    for words in [
        "parallel to the bearing",
        "S^z, z cos",
        "0 is zero by symmetry",
        "sum of the parts",
        "% of the load of the film",
        "out/scene: characteristics.json",
    ] {
        assert!(told.stdout.contains(words), "no {words:?} in\n{}", told.stdout);
    }
    let row = |name: &str| {
        let line = told.stdout.lines().find(|line| line.starts_with(&format!("│ {name} "))).expect("a row");
        line.split('┆').map(|cell| cell.trim_matches(['│', ' ']).to_owned()).collect::<Vec<_>>()
    };
    // The force of a journal that rises along the line of centres is against it, and there is nothing else.
    let squeeze = row("squeeze");
    assert!(squeeze[2].starts_with('-') && squeeze[3..] == ["0", "0", "0"], "{squeeze:?}");
    let written = std::fs::read_to_string(bench.path().join("out/scene/characteristics.json")).expect("the file");
    let json = bench.run(&["characteristics", "scene.toml", "--json"]);
    assert_eq!(json.stdout, written);
    let found = object(&written);
    let parts = found["parts"].as_array().expect("parts");
    let numbers = parts.iter().flat_map(|part| part["characteristics"].as_object().expect("numbers").values());
    let zeros = numbers.filter(|number| number["zero_by_symmetry"] == true && number["value"] == 0.0).count();
    assert_eq!(zeros, 9);
    assert!(parts[1]["rate"].as_f64().is_some_and(|rate| (rate + 0.6).abs() < 1e-12));
}

#[test]
fn a_load_over_a_cycle_is_refused() {
    let bench = Bench::new();
    let scene = repository().join("scenes/loads/synthetic_big_end.toml").display().to_string();
    let told = bench.run(&["characteristics", &scene]);
    let wanted = "journal.eccentricity: is missing: the load changes over a cycle";
    assert!(told.status == 2 && told.stderr.contains(wanted), "{}", told.stderr);
    assert!(bench.files().is_empty());
}

#[test]
fn scenes_without_characteristics_are_refused_and_nothing_is_written() {
    let feed = "[[feed]]\ngroup = \"a\"\nhole = { diameter = \"5 mm\", angle = \"210 deg\" }\npressure = \"1 bar\"\n";
    let cases = [
        (PLAIN.to_owned() + feed, "feed \"a\".pressure: makes a pressure of its own"),
        (PLAIN.replace("\"reynolds\"", "\"jfo\""), "cavitation.model: is \"jfo\""),
        (
            PLAIN.replace("oil.viscosity", "oil.barus = { alpha = \"2e-8 1/Pa\" }\noil.viscosity"),
            "oil.barus: makes the viscosity grow with pressure",
        ),
        (PLAIN.to_owned() + "ends.pressure = \"1 bar\"\n", "cavitation.pressure: is not the pressure of the ends"),
        (
            PLAIN.replace("0.6, min", "0.0, min").replace("radial", "tangential"),
            "journal: moves across its line of centres (squeeze.tangential), but it is centred",
        ),
    ];
    for (scene, wanted) in cases {
        let bench = Bench::new();
        bench.write("scene.toml", &scene);
        let told = bench.run(&["characteristics", "scene.toml"]);
        assert_eq!((told.status, told.stdout.as_str()), (2, ""), "{wanted}: {}", told.stderr);
        assert!(told.stderr.contains(wanted) && told.stderr.contains("help: "), "{}", told.stderr);
        assert_eq!(bench.files().len(), 1, "{wanted}");
    }
}

/// A centred journal turns without pressure; squeezed, it carries.
#[test]
fn a_centred_journal_has_characteristics() {
    let bench = Bench::new();
    bench.write("scene.toml", PLAIN.replace("eccentricity = 0.6", "eccentricity = 0"));
    let told = bench.run(&["characteristics", "scene.toml", "--json"]);
    assert_eq!(told.status, 0, "{}", told.stderr);
    let found = object(&told.stdout);
    let of =
        |part: usize, name: &str| found["parts"][part]["characteristics"][name]["value"].as_f64().expect("a number");
    assert_eq!((of(0, "force_along"), of(0, "moment_across")), (0.0, 0.0));
    assert!(of(1, "force_along") < -0.1 && of(2, "moment_along") > 0.01);
}

/// A load that nothing carries ends the command with its reason.
#[test]
fn a_load_without_a_position_is_a_result() {
    let bench = Bench::new();
    let loaded =
        PLAIN.replace("eccentricity = 0.6, min_film_angle = \"30 deg\", squeeze = { radial = \"-0.03 mm/s\" }", "");
    let loaded = loaded.replace("\"30 rad/s\",  }", "\"30 rad/s\" }");
    bench.write("scene.toml", loaded.clone() + "load = { force = \"1 kN\", angle = \"270 deg\" }\n");
    let told = bench.run(&["characteristics", "scene.toml", "--json"]);
    assert_eq!(told.status, 0, "{}", told.stderr);
    let found = object(&told.stdout);
    let film = &found["film"];
    let load = film["force_along"]["value"]
        .as_f64()
        .expect("along")
        .hypot(film["force_across"]["value"].as_f64().expect("across"));
    assert!((load / 1e3 - 1.0).abs() < 0.01, "{load}");
    bench.write(
        "scene.toml",
        loaded.replace("30 rad/s", "0 rad/s") + "load = { force = \"1 kN\", angle = \"270 deg\" }\n",
    );
    let told = bench.run(&["characteristics", "scene.toml", "--json"]);
    let found = object(&told.stdout);
    assert_eq!((told.status, &found["status"]), (1, &Value::from("no_solution")), "{}", told.stderr);
    assert!(found["journal"].is_null() && found["parts"].as_array().is_some_and(Vec::is_empty));
    assert!(found["reason"].as_str().is_some_and(|reason| reason.starts_with("position: ")), "{found}");
}

#[test]
fn json_is_that_of_the_reference_page() {
    let page = std::fs::read_to_string(repository().join("docs/reference/characteristics.md")).expect("the page");
    let example = page.split("```json\n").nth(1).and_then(|rest| rest.split("```").next()).expect("an example");
    let (mut wanted, mut found) = (BTreeSet::new(), BTreeSet::new());
    keys(&object(example), "", &mut wanted);
    let bench = Bench::new();
    bench.scene("26_tilting_crankshaft_journal", &[]);
    let told = bench.run(&["characteristics", "scene.toml", "--json"]);
    let it = object(&told.stdout);
    keys(&it, "", &mut found);
    wanted.retain(|key| !key.starts_with(".fit."));
    assert_eq!(wanted, found);
    // The numbers of the page, to a few digits.
    let numbers = object(example);
    for name in ["force_along", "force_across", "moment_along", "moment_across"] {
        for key in ["sum", "film"] {
            let number = |value: &Value| value[key][name]["value"].as_f64().expect("a number");
            let size = if name.starts_with("force") { 6e3 } else { 15.0 };
            assert!((number(&numbers) - number(&it)).abs() < 5e-3 * size, "{key}.{name}: {}", number(&it));
        }
    }
}
