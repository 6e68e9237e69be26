//! `solve` of a scene with tolerances: the spread of its quantities.

use oilwedge_tests::bench::{Bench, edited, object};
use oilwedge_tests::program::repository;
use serde_json::Value;

const SIZE: &str = "\n[mesh]\nsize = \"12 mm\"\n";

fn number(value: &Value, path: &[&str]) -> f64 {
    let found = path.iter().fold(value, |value, key| &value[*key]);
    found.as_f64().unwrap_or_else(|| panic!("no {path:?} in {value}"))
}

/// The load of a short film at a given position is in proportion to mu omega / c^2 (DuBois and Ocvirk 1953).
#[test]
fn a_short_film_has_the_exponents_of_its_closed_form() {
    let bench = Bench::new();
    let edits = [
        ("0.4 Pa.s", "0.4 Pa.s +- 1 %"),
        ("10 rad/s", "10 +- 0.1 rad/s"),
        ("\"37.5 um\"", "\"37.5 um +- 0.375 um\"\ntheory = \"short\""),
    ];
    bench.write("scene.toml", edited("09_drawn_ring", &edits) + SIZE);
    let result = object(&bench.run(&["solve", "scene.toml", "--json"]).stdout);
    let load = &result["quantities"]["load"];
    for (key, exponent) in [("oil.viscosity", 1.0), ("journal.speed", 1.0), ("bearing.clearance", -2.0)] {
        let found = number(load, &["sensitivity", key, "log"]);
        assert!((found - exponent).abs() < 1e-8, "{key}: {found}");
    }
    let per_unit = number(load, &["sensitivity", "oil.viscosity", "value"]);
    assert!((per_unit * 0.4 / number(load, &["value"]) - 1.0).abs() < 1e-3);
    assert_eq!(load["sensitivity"]["bearing.clearance"]["unit"], "N/um");
    let [rss, worst] = ["rss", "worst_case"].map(|name| number(load, &["spread", name]) / number(load, &["value"]));
    assert!((rss - 6f64.sqrt() * 1e-2).abs() < 1e-4 && (worst - 4e-2).abs() < 1e-4, "{rss} {worst}");
    let shares = load["spread"]["shares"].as_object().expect("shares");
    let sum: f64 = shares.values().filter_map(Value::as_f64).sum();
    assert!(shares.len() == 3 && (sum - 1.0).abs() < 1e-12, "{shares:?}");
    assert!(number(load, &["spread", "nonlinearity"]) < 5e-3, "{load}");
}

#[test]
fn the_rss_is_the_deviation_of_draws() {
    let bench = Bench::new();
    let edits = [
        ("0.4 Pa.s", "0.4 Pa.s +- 5 %"),
        ("\"37.5 um\"", "\"36 um .. 39 um\""),
        ("eccentricity = 0.6", ""),
        ("min_film_angle = \"180 deg\"", "[load]\nforce = \"20 kN +- 3 %\"\nangle = \"270 deg\""),
    ];
    bench.write("scene.toml", edited("09_drawn_ring", &edits) + SIZE + "\n[cavitation]\nmodel = \"reynolds\"\n");
    let told = bench.run(&["solve", "scene.toml", "--bars", "none"]);
    assert!(told.stdout.contains("What matters among the tolerances"), "{}\n{}", told.stdout, told.stderr);
    let result = object(&bench.run(&["solve", "scene.toml", "--bars", "none", "--json"]).stdout);
    let draws = ["sweep", "scene.toml", "--draws", "200", "--bars", "none", "--json"];
    let drawn = object(&bench.run(&draws).stdout);
    for name in ["film_thickness_min", "eccentricity", "pressure_max", "friction_power"] {
        let found = number(&drawn["distributions"][0], &["quantities", name, "deviation", "value"]);
        // Half widths of uniform numbers are deviations times the root of three.
        let rss = number(&result["quantities"], &[name, "spread", "rss"]) / 3f64.sqrt();
        assert!((rss / found - 1.0).abs() < 0.1, "{name}: {rss} is not {found}");
    }
}

#[test]
fn a_scene_without_tolerances_has_no_spread() {
    let bench = Bench::new();
    bench.write("scene.toml", edited("09_drawn_ring", &[]) + SIZE);
    let told = bench.run(&["solve", "scene.toml", "--json", "--bars", "none"]);
    assert!(!told.stdout.contains("spread") && !told.stdout.contains("sensitivity"), "{}", told.stdout);
}

#[test]
fn orbits_have_no_sensitivities() {
    let bench = Bench::new();
    let scene = repository().join("scenes/27_big_end_orbit.toml");
    let path = scene.to_str().expect("a path");
    bench.refuses(&["solve", path, "--sensitivity"], &["--sensitivity", "27_big_end_orbit.toml", "[orbit]"]);
}
