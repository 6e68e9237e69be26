//! `solve --theories`: one scene as a short, a full and a long bearing, by the same numbers as scenes that say so.

use oilwedge_tests::bench::{Bench, object, timeless};
use serde_json::Value;

/// A short ring with half film; what a theory or a film start is written for stands behind its clearance.
fn ring(more: &str) -> String {
    format!(
        r#"
bearing = {{ diameter = "74.5 mm", length = "25.7 mm", clearance = "46 um"{more} }}
mesh = {{ size = "3 mm" }}
journal = {{ speed = "3200 rpm", eccentricity = 0.8, min_film_angle = "180 deg" }}
oil = {{ viscosity = "6.1 mPa.s" }}
cavitation = {{ model = "guembel" }}
"#
    )
}

fn solved(bench: &Bench, scene: &str, arguments: &[&str]) -> Value {
    bench.write("scene.toml", scene);
    let told = bench.run(&[&["solve", "scene.toml", "--json", "--bars", "none"], arguments].concat());
    assert_eq!(told.status, 0, "{}", told.stderr);
    let written = std::fs::read_to_string(bench.path().join("out/scene/result.json")).expect("result.json");
    assert_eq!(written, told.stdout);
    object(&told.stdout)
}

#[test]
fn each_film_is_that_of_a_scene_that_asks_for_it() {
    let bench = Bench::new();
    let mut all = solved(&bench, &ring(""), &["--theories"]);
    let theories = all["theories"].clone();
    assert!((theories["slenderness"].as_f64().expect("B/D") - 25.7 / 74.5).abs() < 1e-12);
    let films = theories["films"].as_array().expect("a list");
    let names: Vec<_> = films.iter().map(|film| film["theory"].as_str().expect("a name")).collect();
    assert_eq!(names, ["short", "full", "long"]);
    assert_eq!(films[2]["film_start_deg"], 0.0);
    for (film, more) in films.iter().zip([", theory = \"short\"", "", ", theory = \"long\", film_start = \"0 deg\""]) {
        let alone = solved(&bench, &ring(more), &[]);
        assert!(alone.get("theories").is_none());
        assert_eq!((&film["status"], &film["reason"]), (&"converged".into(), &Value::Null));
        let numbers = film["quantities"].as_object().expect("numbers");
        assert!(numbers.len() >= 5, "{film}");
        for (name, number) in numbers {
            assert_eq!(number["value"], alone["quantities"][name]["value"], "{more}: {name}");
            let [value, difference] = ["value", "difference"].map(|key| number[key].as_f64().expect("a number"));
            let full = films[1]["quantities"][name]["value"].as_f64().expect("a number");
            assert!((value - full - difference).abs() < 1e-9 * full.abs(), "{more}: {name}");
        }
    }
    // 1.457, 1.675 and -3.93 degrees by finite differences (`literature/short_bearing_finite_length.rs`).
    let short = &films[0]["quantities"];
    let off = |name: &str| {
        let [value, difference] = ["value", "difference"].map(|key| short[name][key].as_f64().expect("a number"));
        value / (value - difference)
    };
    assert!((off("load") / 1.457 - 1.0).abs() < 5e-3 && (off("pressure_max") / 1.675 - 1.0).abs() < 1e-2);
    assert!((short["attitude_angle"]["difference"].as_f64().expect("an angle") + 3.93).abs() < 0.1);
    // Nothing else of the result is another one.
    all.as_object_mut().map(|result| result.remove("theories"));
    assert_eq!(timeless(all), timeless(solved(&bench, &ring(""), &[])));
}

#[test]
fn every_shipped_scene_has_a_table_or_a_reason() {
    let bench = Bench::new();
    for (name, refused) in [
        ("09_drawn_ring", [None, None]),
        ("01_plain_ring", [None, None]),
        ("10_drawn_liner", [None, None]),
        ("14_starved_pad", [Some("bearing.arc is given"), None]),
        ("15_squeezed_ring", [None, None]),
        ("19_connecting_rod_cap", [None, Some("no line of the bearing has a pressure")]),
    ] {
        bench.scene(name, &[]);
        let told = bench.run(&["solve", "scene.toml", "--theories"]);
        assert_eq!(told.status, 0, "{name}: {}", told.stderr);
        for part in [" short ", " long ", "\nB/D       "] {
            assert!(told.stdout.contains(part), "{name}: no {part:?} in\n{}", told.stdout);
        }
        for (theory, reason) in ["short", "long"].into_iter().zip(refused) {
            let line = told.stdout.lines().find(|line| line.starts_with(&format!("no {theory} film: ")));
            match reason {
                Some(reason) => assert!(line.is_some_and(|line| line.contains(reason)), "{name}: {line:?}"),
                None => assert_eq!(line, None, "{name}"),
            }
        }
    }
}

/// The page on effects shows the numbers of scene 21.
#[test]
fn the_table_of_the_page_is_that_of_the_scene() {
    let bench = Bench::new();
    bench.scene("21_short_crankshaft_bearing", &[]);
    let result = object(&bench.run(&["solve", "scene.toml", "--theories", "--json"]).stdout);
    let page = oilwedge_tests::program::repository().join("docs/howto/effects.md");
    let page = std::fs::read_to_string(page).expect("the page");
    let section = page.split("## Is my bearing short?").nth(1).expect("the section");
    for (name, scale) in [("load", 1e3), ("attitude_angle", 1.0), ("pressure_max", 1e6)] {
        let row = section.lines().find(|line| line.starts_with(&format!("│ {name} ")));
        let cells: Vec<&str> = row.expect("a row").split('┆').map(str::trim).collect();
        let films = &result["theories"]["films"];
        for (film, cell) in [&films[1], &films[0], &films[2]].into_iter().zip(&cells[2..]) {
            let value = film["quantities"][name]["value"].as_f64().expect("a number") / scale;
            let shown: f64 = cell.split(' ').next().and_then(|text| text.parse().ok()).expect("a number");
            assert!((shown / value - 1.0).abs() < 3e-3, "{name}, {}: {shown}, {value}", film["theory"]);
        }
    }
}
