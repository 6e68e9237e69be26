//! `solve` of a scene with tolerances: the spread of its quantities.

use oilwedge_tests::bench::{Bench, edited, object};
use oilwedge_tests::program::repository;
use serde_json::Value;

const SIZE: &str = "\n[mesh]\nsize = \"12 mm\"\n";

/// A cycle that closes soon.
const CYCLE: &str = "
bearing = { diameter = \"50 mm\", length = \"25 mm\", clearance = \"30 um\" }
mesh.size = \"8 mm\"
journal.speed = \"3000 rpm\"
oil.viscosity = \"VISCOSITY\"
cavitation.model = \"reynolds\"
orbit = { tolerance = 1e-2 }
[load]
harmonics = [{ order = 0, cos = { x = \"2 kN\" } }, { order = 1, sin = { y = \"3 kN\" } }]
frame = \"shell\"
period = \"360 deg\"
";

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
    let departure = (1.01f64.powi(2) / 0.99f64.powi(2) - 1.0) / 4e-2 - 1.0;
    assert!((number(load, &["spread", "nonlinearity"]) / departure - 1.0).abs() < 1e-6, "{load}");
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

/// Half a fifth of the clearance more or less is no small change: the load goes with its inverse square.
#[test]
fn corners_and_curves_are_those_of_the_closed_form() {
    let bench = Bench::new();
    let edits = [("0.4 Pa.s", "0.4 Pa.s +- 10 %"), ("\"37.5 um\"", "\"37.5 um +- 20 %\"\ntheory = \"short\"")];
    bench.write("scene.toml", edited("09_drawn_ring", &edits) + SIZE);
    let result = object(&bench.run(&["solve", "scene.toml", "--bars", "none", "--json", "--plot"]).stdout);
    let load = &result["quantities"]["load"];
    let nominal = number(load, &["value"]);
    let corner = |end: &str| load["spread"]["corners"][end.parse::<usize>().expect("an end")].as_f64().expect("a load");
    for (found, wanted) in [(corner("0"), 0.9 / 1.44), (corner("1"), 1.1 / 0.64)] {
        assert!((found / nominal / wanted - 1.0).abs() < 1e-9, "{found} is not {wanted}");
    }
    let departure = (1.1 / 0.64 - 1.0) / 0.5 - 1.0;
    assert!((number(load, &["spread", "nonlinearity"]) - departure).abs() < 1e-6, "{load}");
    let curve = &result["tolerance_curve"];
    assert_eq!(curve["key"], "bearing.clearance");
    let loads = curve["quantities"]["load"].as_array().expect("loads").iter().filter_map(Value::as_f64);
    for (found, part) in loads.zip([0.8, 0.9, 1.0, 1.1, 1.2f64]) {
        assert!((found / nominal * part * part - 1.0).abs() < 1e-9, "{found} at {part}");
    }
    assert!(bench.path().join("out/scene/plot/tolerances.svg").is_file());
}

#[test]
fn criteria_are_judged_within_the_tolerances() {
    let bench = Bench::new();
    let edits = [("0.4 Pa.s", "0.4 Pa.s +- 10 %"), ("\"37.5 um\"", "\"37.5 um +- 1 %\"")];
    let scene = edited("09_drawn_ring", &edits) + SIZE;
    let bench_of = |limit: &str| {
        bench.write("scene.toml", format!("{scene}[criteria]\npressure_max = \"{limit} bar\"\n"));
        let told = bench.run(&["solve", "scene.toml", "--bars", "none"]);
        let result = object(&std::fs::read_to_string(bench.path().join("out/scene/result.json")).expect("a result"));
        (result["criteria"][0].clone(), told.stdout)
    };
    let (criterion, _) = bench_of("1");
    let value = number(&criterion, &["value"]);
    let range = criterion["spread"]["range"].as_array().expect("a range").iter().filter_map(Value::as_f64);
    // The pressure goes with mu/c^2.
    assert!(range.zip([-0.12, 0.12]).all(|(found, part)| (found / value - 1.0 - part).abs() < 1e-3), "{criterion}");
    for (part, verdict) in [(0.8, "fail"), (0.95, "undecided"), (1.05, "undecided"), (1.2, "pass")] {
        let (criterion, told) = bench_of(&format!("{}", part * value));
        assert_eq!(criterion["verdict"], verdict, "{part}: {criterion}");
        assert_eq!(told.contains("oil.viscosity decides the greatest pressure"), verdict == "undecided", "{told}");
        let reserve = if verdict == "undecided" { "inside_spread" } else { "no_bars" };
        assert_eq!(criterion["reserve"], reserve, "{part}: {criterion}");
    }
}

#[test]
fn a_film_that_the_tolerances_miss_is_named_and_the_spread_stays() {
    let bench = Bench::new();
    // Half of the length times the tilt is 1.3 um. The film in the middle is 1.1 um where both are at their ends.
    let edits = [
        ("eccentricity = 0.6", "eccentricity = \"0.9 +- 0.05\"\ntilt = { x = \"0.035 mrad\", y = \"0 rad\" }"),
        ("min_film_angle = \"180 deg\"", "min_film_angle = \"0 deg\""),
        ("\"37.5 um\"", "\"37.5 um +- 15 um\""),
    ];
    bench.write("scene.toml", edited("09_drawn_ring", &edits) + SIZE);
    let told = bench.run(&["solve", "scene.toml", "--bars", "none"]);
    assert!(told.status == 0 && told.stdout.contains("What matters among the tolerances"), "{}", told.stderr);
    for words in ["there is no film at", "bearing.clearance = 22.5 um", "journal.eccentricity = 0.95"] {
        assert!(told.stderr.contains(words), "{words}: {}", told.stderr);
    }
}

#[test]
fn a_scene_without_tolerances_has_no_spread() {
    let bench = Bench::new();
    bench.write("scene.toml", edited("09_drawn_ring", &[]) + SIZE);
    let told = bench.run(&["solve", "scene.toml", "--json", "--bars", "none"]);
    assert!(!told.stdout.contains("spread") && !told.stdout.contains("sensitivity"), "{}", told.stdout);
}

/// A cycle is solved at both ends of each tolerance, if that is asked.
#[test]
fn cycles_are_differentiated_by_their_tolerances_on_demand() {
    let bench = Bench::new();
    let scene = repository().join("scenes/27_big_end_orbit.toml");
    let path = scene.to_str().expect("a path");
    bench.refuses(
        &["solve", path, "--sensitivity"],
        &["--sensitivity", "27_big_end_orbit.toml", "with tolerances only"],
    );
    let cycle = |viscosity: &str| {
        bench.write("scene.toml", CYCLE.replace("VISCOSITY", viscosity));
        object(&bench.run(&["solve", "scene.toml", "--bars", "none", "--json", "--sensitivity"]).stdout)
    };
    let power = |result: &Value| number(&result["quantities"], &["cycle_power_loss", "value"]);
    let found = cycle("10 mPa.s +- 1 mPa.s");
    let plain = ["9 mPa.s", "11 mPa.s"].map(|viscosity| {
        bench.write("scene.toml", CYCLE.replace("VISCOSITY", viscosity));
        power(&object(&bench.run(&["solve", "scene.toml", "--bars", "none", "--json"]).stdout))
    });
    let sensitivity = &found["quantities"]["cycle_power_loss"]["sensitivity"]["oil.viscosity"];
    assert!((number(sensitivity, &["value"]) / (0.5 * (plain[1] - plain[0])) - 1.0).abs() < 1e-6, "{sensitivity}");
    assert_eq!(sensitivity["is_by_films"], true);
    bench.write("scene.toml", CYCLE.replace("VISCOSITY", "10 mPa.s +- 1 mPa.s"));
    let told = bench.run(&["solve", "scene.toml", "--bars", "none", "--json"]).stdout;
    assert!(!told.contains("sensitivity"), "{told}");
}
