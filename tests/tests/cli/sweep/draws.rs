//! `--draws`: tolerances of a scene drawn at random.

use std::collections::BTreeMap;

use oilwedge_tests::bench::{Bench, edited, object};
use oilwedge_tests::sweeps::{done, table, timeless};
use serde_json::Value;

const SIZE: &str = "\n[mesh]\nsize = \"12 mm\"\n";
const NUMBERS: [(&str, &str); 2] = [("0.4 Pa.s", "0.4 Pa.s +- 10 %"), ("37.5 um", "36 um .. 39 um")];

fn scene(edits: &[(&str, &str)], more: &str) -> String {
    edited("09_drawn_ring", edits) + SIZE + more
}

fn number(value: &Value, path: &[&str]) -> f64 {
    let found = path.iter().fold(value, |value, key| &value[*key]);
    found.as_f64().unwrap_or_else(|| panic!("no {path:?} in {value}"))
}

#[test]
fn draws_are_the_same_on_any_number_of_threads_and_in_parts() {
    let bench = Bench::new();
    bench.write("scene.toml", scene(&NUMBERS, ""));
    let draws = ["sweep", "scene.toml", "--draws", "40", "--bars", "none", "--json"];
    let run = |more: &[&str]| bench.run(&[&draws[..], more].concat());
    let one = done(&run(&["--threads", "1", "--out", "one"]));
    done(&run(&["--threads", "2", "--out", "two"]));
    for part in ["1/2", "2/2"] {
        done(&run(&["--part", part, "--out", "parts"]));
    }
    done(&run(&["--join", "parts"]));
    let [first, second, joined] = ["one", "two", "parts"].map(|folder| timeless(&table(&bench, folder)));
    assert!(first == second && first == joined);
    assert!(first[0].starts_with("case,draw,bearing.clearance [um],oil.viscosity [Pa.s],status"), "{}", first[0]);
    let inputs = &one["rows"][16]["inputs"];
    assert!((36.0..=39.0).contains(&number(inputs, &["bearing.clearance"])), "{inputs}");
    // Another seed in the same folder is another sweep.
    bench.refuses(&[&draws[..], &["--seed", "2", "--out", "one"]].concat(), &["of other draws"]);
}

/// The load of a film at a given position is in proportion to the viscosity, so its distribution is known.
#[test]
fn a_load_is_spread_as_the_viscosity_that_is_drawn() {
    let bench = Bench::new();
    bench.write("scene.toml", scene(&NUMBERS[..1], "\n[criteria]\npressure_max = \"1000 bar\"\n"));
    bench.write("nominal.toml", scene(&[], "\n[criteria]\npressure_max = \"1000 bar\"\n"));
    let solve = |name: &str| {
        let result = object(&bench.run(&["solve", name, "--bars", "none", "--json"]).stdout);
        let quantities = result["quantities"].as_object().expect("quantities").iter();
        quantities.map(|(name, it)| (name.clone(), number(it, &["value"]))).collect::<BTreeMap<_, _>>()
    };
    assert_eq!(solve("scene.toml"), solve("nominal.toml"));
    let load = solve("nominal.toml")["load"];
    for (more, deviation) in [(&[][..], 0.1 / 3f64.sqrt()), (&["--normal"][..], 0.1 / 3.0 * 0.986_6)] {
        let arguments = ["sweep", "scene.toml", "--draws", "400", "--bars", "none", "--json", "--fresh"];
        let report = done(&bench.run(&[&arguments[..], more].concat()));
        let [found] = &report["distributions"].as_array().expect("distributions")[..] else { panic!("one point") };
        let of_load = &found["quantities"]["load"];
        for (path, wanted) in [
            (&["mean"][..], 1.0),
            (&["deviation"], deviation),
            (&["percentiles", "p50"], 1.0),
            (&["percentiles", "p95"], if more.is_empty() { 1.09 } else { 1.054_5 }),
            (&["percentiles", "p5"], if more.is_empty() { 0.91 } else { 0.945_5 }),
        ] {
            let [value, error] = ["value", "error"].map(|part| number(of_load, &[path, &[part]].concat()) / load);
            // 1.96 standard errors are the bar, and twice as much is left to chance.
            assert!((value - wanted).abs() < 2.0 * error && error < 0.02, "{path:?}: {value} is not {wanted}");
        }
        assert_eq!((number(found, &["draws"]), number(found, &["answered"])), (400.0, 400.0));
        assert_eq!(number(found, &["meet_criteria", "value"]), 1.0);
        assert!(found["quantities"].get("eccentricity").is_none());
    }
    let told = bench.run(&["sweep", "scene.toml", "--draws", "400", "--bars", "none", "--normal"]);
    for words in ["oil.viscosity 0.4 +- 0.04 Pa.s", "400 draws of seed 1", "of the draws meet all criteria"] {
        assert!(told.stdout.contains(words), "{}", told.stdout);
    }
}

#[test]
fn each_point_of_a_sweep_has_its_draws() {
    let bench = Bench::new();
    let axes = "\n[sweep]\nclearance = [\"36 um\", \"39 um\"]\ncolumns = [\"W kN\"]\n";
    bench.write("scene.toml", scene(&NUMBERS, axes));
    let report = done(&bench.run(&["sweep", "scene.toml", "--draws", "20", "--bars", "none", "--json", "--report"]));
    let points = report["distributions"].as_array().expect("distributions");
    let means: Vec<f64> = points.iter().map(|it| number(it, &["quantities", "W", "mean", "value"])).collect();
    assert_eq!((points.len(), report["tolerances"].as_array().map(Vec::len)), (2, Some(1)));
    // The same draws of the viscosity: W goes with 1 / c^2.
    assert!((means[0] / means[1] - (39.0f64 / 36.0).powi(2)).abs() < 1e-2, "{means:?}");
    let page = std::fs::read_to_string(bench.path().join("out/scene/sweep.html")).expect("a page");
    assert!(page.contains("Spread by draws"));
}

#[test]
fn what_cannot_be_drawn_is_refused() {
    let bench = Bench::new();
    bench.write("scene.toml", scene(&[], ""));
    bench.refuses(&["sweep", "scene.toml", "--draws", "20"], &["has no tolerances to draw"]);
    bench.write("scene.toml", scene(&NUMBERS, ""));
    bench.refuses(&["sweep", "scene.toml"], &["has no [sweep]"]);
    bench.refuses(&["sweep", "scene.toml", "--seed", "2"], &["--draws"]);
    bench.refuses(&["sweep", "scene.toml", "--draws", "1"], &["--draws"]);
    bench.write("scene.toml", scene(&NUMBERS, "\n[sweep]\nviscosity = [\"0.4 Pa.s +- 0.1 Pa.s\"]\n"));
    bench.refuses(&["check", "scene.toml"], &["sweep.viscosity", "has a value with a tolerance"]);
    bench.write("scene.toml", scene(&NUMBERS, ""));
    let told = bench.run(&["check", "scene.toml"]);
    assert!(
        told.stdout.contains("widths    bearing.clearance 37.5 +- 1.5 um, oil.viscosity 0.4 +- 0.04 Pa.s"),
        "{}",
        told.stdout
    );
}
