//! Scenes with `[heat]` through the program.

use oilwedge_study::{RunOptions, run};
use oilwedge_tests::scenes::{table, variant};
use serde_json::Value;

use oilwedge_tests::bench::{Bench, object};

const RING: &str = r#"
[bearing]
diameter = "50 mm"
length = "20 mm"
clearance = "25 um"
[mesh]
size = "4 mm"
[[feed]]
group = "groove"
groove = { from = "60 deg", to = "120 deg", width = "8 mm" }
pressure = "3 bar"
[journal]
speed = "4000 rpm"
eccentricity = 0.7
min_film_angle = "300 deg"
[oil]
grade = "SAE 10W-40"
[cavitation]
model = "reynolds"
[heat]
inlet = "80 C"
"#;

/// What the program makes of the ring in which `from` is replaced by `to`.
fn told(bench: &Bench, from: &str, to: &str) -> (i32, Value, String) {
    assert!(RING.contains(from), "{from}");
    std::fs::write(bench.path().join("ring.toml"), RING.replacen(from, to, 1)).expect("written");
    let told = bench.run(&["solve", "ring.toml", "--json", "--curve"]);
    let result = if told.stdout.is_empty() { Value::Null } else { object(&told.stdout) };
    (told.status, result, told.stderr)
}

fn value(result: &Value, name: &str) -> f64 {
    let quantity = &result["quantities"][name];
    quantity["value"].as_f64().unwrap_or_else(|| panic!("no {name}: {quantity}"))
}

/// Friction is carried off, the mean temperature lies midway, and the oil has its viscosity there.
#[test]
fn heat_is_balanced_and_told() {
    let bench = Bench::new();
    let (status, result, stderr) = told(&bench, "80 C", "80 C");
    assert_eq!(status, 0, "{stderr}");
    let get = |name: &str| value(&result, name);
    assert!((get("heat_carried") / get("friction_power") - 1.0).abs() < 1e-6);
    assert!(result["balances"]["heat"].as_f64().expect("a number") < 1e-6);
    assert!((get("temperature_effective") - 0.5 * (80.0 + get("temperature_outlet"))).abs() < 1e-9);
    let carried = 1.8e6 * get("cooling_flow") * (get("temperature_outlet") - 80.0);
    assert!((carried / get("heat_carried") - 1.0).abs() < 1e-9, "{carried}");
    // Nothing enters at the ends of a film whose cavity has their pressure, and no feed drains.
    assert!((get("side_flow") / get("cooling_flow") - 1.0).abs() < 1e-12);
    for name in ["temperature_effective", "temperature_outlet", "heat_carried", "eccentricity", "load"] {
        let error = result["quantities"][name]["error"].as_f64();
        assert!(error.is_some_and(|error| error < 0.05 * get(name)), "{name}: {error:?}");
    }
    let heat = &result["heat"];
    assert_eq!((&heat["preset"], &heat["is_fit"]), (&Value::Null, &Value::Bool(true)));
    let curve = heat["curve"].as_array().expect("a curve");
    assert!(curve.len() >= 5);
    let at = |point: &Value, name: &str| point[name].as_f64().expect("a number");
    for pair in curve.windows(2) {
        assert!(at(&pair[1], "friction_power") < at(&pair[0], "friction_power"));
        assert!(at(&pair[1], "heat_carried") > at(&pair[0], "heat_carried"));
    }
    for file in ["heat.svg", "heat.png"] {
        assert!(bench.path().join("out/ring").join(file).is_file(), "{file}");
    }
    // At the temperature found the film is the same without a balance.
    let fixed = format!("grade = \"SAE 10W-40\"\ntemperature = \"{} C\"", get("temperature_effective"));
    let text = RING.replace("grade = \"SAE 10W-40\"", &fixed).replace("[heat]\ninlet = \"80 C\"", "");
    std::fs::write(bench.path().join("ring.toml"), text).expect("written");
    let again = bench.run(&["solve", "ring.toml", "--json"]);
    let isothermal = object(&again.stdout);
    for name in ["load", "side_flow", "friction_power", "viscosity_effective"] {
        let ratio = value(&isothermal, name) / get(name);
        assert!((ratio - 1.0).abs() < 1e-6, "{name}: {ratio}");
    }
    // Pictures of another run are taken away.
    assert!(isothermal.get("heat").is_none() && !bench.path().join("out/ring/heat.svg").exists());
    assert!(isothermal["quantities"].get("heat_carried").is_none());
}

/// What takes heat off cools the film; hot oil that goes round heats it.
#[test]
fn housing_and_mixing_shift_the_balance() {
    let bench = Bench::new();
    let inlet = "inlet = \"80 C\"";
    let with = |more: &str| {
        let (status, result, stderr) = told(&bench, inlet, &format!("{inlet}\n{more}"));
        assert_eq!(status, 0, "{stderr}");
        result
    };
    let plain = value(&with(""), "temperature_effective");
    let housed = with("housing = { conductance = \"5 W/K\", ambient = \"30 C\" }");
    let sum = value(&housed, "heat_carried") + value(&housed, "heat_housing");
    assert!((sum / value(&housed, "friction_power") - 1.0).abs() < 1e-6);
    let warm = value(&housed, "temperature_effective");
    assert!((value(&housed, "heat_housing") / (5.0 * (warm - 30.0)) - 1.0).abs() < 1e-9);
    assert!(warm < plain);
    let mixed = with("mixing = { ratio = 0.25 }");
    let [t_in, t_out] = ["temperature_inlet", "temperature_outlet"].map(|name| value(&mixed, name));
    assert!((t_in - (80.0 + 0.25 * (t_out - t_in))).abs() < 1e-6);
    assert!(value(&mixed, "temperature_effective") > plain);
    let shared = with("mixing = { share = 0.5 }");
    assert!(value(&shared, "temperature_inlet") > 80.0);
    let none = with("mixing = { ratio = 0 }");
    assert!((value(&none, "temperature_effective") - plain).abs() < 1e-6);
}

#[test]
fn presets_are_judged_and_limits_decide() {
    let bench = Bench::new();
    let (status, result, stderr) =
        told(&bench, "inlet = \"80 C\"", "preset = \"diesel\"\nfilm_min = \"9 um\"\ntemperature_max = \"60 C\"");
    assert_eq!(status, 0, "{stderr}");
    let heat = &result["heat"];
    assert_eq!((&heat["preset"], &heat["is_fit"]), (&Value::from("diesel"), &Value::Bool(false)));
    let criteria = heat["criteria"].as_array().expect("criteria");
    let met: Vec<bool> = criteria.iter().map(|it| it["is_met"].as_bool().expect("a word")).collect();
    // Film and temperature are not met, the oil leaves cool enough; 25 um of 25 mm and 77.5 C are usual for a diesel, 3
    // bar are not.
    assert_eq!(met, [false, false, true, true, false, true]);
    let text = bench.run(&["solve", "ring.toml"]);
    let is_unusual = |line: &str| line.contains("pressure of the oil fed") && line.contains("unusual");
    assert!(text.stdout.contains("NOT fit") && text.stdout.lines().any(is_unusual), "{}", text.stdout);
}

/// A centred journal in a ring without feeds: no oil leaves, and nothing carries the heat off.
#[test]
fn what_cannot_be_cooled_is_told() {
    let bench = Bench::new();
    let feed = &RING[RING.find("[[feed]]").expect("a feed")..RING.find("[journal]").expect("a journal")];
    std::fs::write(
        bench.path().join("ring.toml"),
        RING.replace(feed, "").replace("eccentricity = 0.7", "eccentricity = 0"),
    )
    .expect("written");
    let told = bench.run(&["solve", "ring.toml", "--json"]);
    let result = object(&told.stdout);
    assert_eq!((told.status, &result["status"]), (1, &Value::from("no_solution")));
    let reason = result["reason"].as_str().expect("a reason");
    assert!(reason.starts_with("no temperature balances the heat: at 330 C still friction makes"), "{reason}");
}

/// A film that is told to be isothermal, though its oil would be heated by tens of kelvins.
#[test]
fn isothermal_films_that_heat_up_are_doubted() {
    let bench = Bench::new();
    let text =
        RING.replace("grade = \"SAE 10W-40\"", "viscosity = \"40 mPa.s\"").replace("[heat]\ninlet = \"80 C\"", "");
    std::fs::write(bench.path().join("ring.toml"), text).expect("written");
    let told = bench.run(&["solve", "ring.toml", "--json"]);
    let rise = object(&told.stdout)["regime"]["temperature_rise"].as_f64().expect("a rise");
    assert!(rise > 25.0, "{rise}");
    assert!(told.stderr.contains("a film as warm as its oil is fed"), "{}", told.stderr);
}

/// A mass-conserving film changes by jumps with temperature: its heat is balanced all the same.
#[test]
fn films_that_jump_are_balanced() {
    for (speed, force) in [(1900.0, 1557.1), (1100.0, 901.5)] {
        let scene = variant("20_heat_balance", |scene| {
            table(scene, "journal").insert("speed".into(), format!("{speed} rpm").into());
            table(scene, "load").insert("force".into(), format!("{force} N").into());
        });
        let found = run(&scene, &RunOptions::default()).expect("a film").result;
        assert!(found.balances.thermal < 1e-6, "{speed}: {}", found.balances.thermal);
        let bar = found.by_name("temperature_effective").and_then(|it| it.error());
        assert!(bar.is_some_and(|bar| (1e-3..0.2).contains(&bar)), "{speed}: {bar:?}");
    }
}

/// What a moving centre puts in heats the film beside friction.
#[test]
fn squeeze_heats_too() {
    let bench = Bench::new();
    let from = "min_film_angle = \"300 deg\"";
    let moving = format!("{from}\nsqueeze = {{ radial = \"20 mm/s\" }}");
    let (status, moved, stderr) = told(&bench, from, &moving);
    assert_eq!(status, 0, "{stderr}");
    let put_in = value(&moved, "friction_power") + value(&moved, "squeeze_power");
    assert!(value(&moved, "squeeze_power") > 0.05 * put_in, "{put_in}");
    assert!((value(&moved, "heat_carried") / put_in - 1.0).abs() < 1e-6);
    assert!(moved["balances"]["heat"].as_f64().expect("a number") < 1e-6);
}

/// Between sealed ends oil goes round: only the housing cools it.
#[test]
fn a_long_bearing_is_cooled_by_its_housing() {
    let bench = Bench::new();
    let text = RING
        .replace("clearance = \"25 um\"", "clearance = \"25 um\"\ntheory = \"long\"\nfilm_start = \"120 deg\"")
        .replace("inlet = \"80 C\"", "inlet = \"80 C\"\nhousing = { conductance = \"20 W/K\", ambient = \"30 C\" }");
    let feed = &text[text.find("[[feed]]").expect("a feed")..text.find("[journal]").expect("a journal")];
    std::fs::write(bench.path().join("ring.toml"), text.replace(feed, "")).expect("written");
    let told = bench.run(&["solve", "ring.toml", "--json"]);
    assert_eq!(told.status, 0, "{}", told.stderr);
    let result = object(&told.stdout);
    let get = |name: &str| value(&result, name);
    assert_eq!((get("heat_carried"), get("cooling_flow")), (0.0, 0.0));
    assert!((get("heat_housing") / get("friction_power") - 1.0).abs() < 1e-6);
    assert!((get("heat_housing") / (20.0 * (get("temperature_effective") - 30.0)) - 1.0).abs() < 1e-9);
}

/// A search that is ended tells how far the heat is from its balance, and does not judge the bearing.
#[test]
fn a_search_that_is_ended_has_no_verdict() {
    let bench = Bench::new();
    let scene = oilwedge_tests::program::repository().join("scenes/20_heat_balance.toml");
    let told = bench.run(&["solve", &scene.display().to_string(), "--json", "--max-seconds", "0.05"]);
    let result = object(&told.stdout);
    assert_eq!((told.status, &result["status"]), (1, &Value::from("not_converged")));
    let reason = result["reason"].as_str().expect("a reason");
    assert!(reason.starts_with("limit: the search for the temperature was ended"), "{reason}");
    assert!(result.get("heat").is_none(), "{}", result["heat"]);
}

/// A sweep has a column for every number that a run of its scene tells.
#[test]
fn a_sweep_tells_temperatures() {
    let bench = Bench::new();
    let text = RING.replace("model = \"reynolds\"", "model = \"guembel\"")
        + "housing = { conductance = \"5 W/K\", ambient = \"30 C\" }\nmixing = { ratio = 0.1 }\n[sweep]\nspeed = [\"2000 rpm\", \"4000 rpm\"]\n";
    std::fs::write(bench.path().join("ring.toml"), text).expect("written");
    let swept = bench.run(&["sweep", "ring.toml", "--out", "swept"]);
    assert_eq!(swept.status, 0, "{}", swept.stderr);
    let table = std::fs::read_to_string(bench.path().join("swept/sweep.csv")).expect("a table");
    let row = |line: usize| table.lines().nth(line).expect("a line").split(',').collect::<Vec<_>>();
    let (headings, last) = (row(0), row(2));
    let told = bench.run(&["solve", "ring.toml", "--json"]);
    let result = object(&told.stdout);
    for (name, quantity) in result["quantities"].as_object().expect("quantities") {
        let heading = format!("{name} [{}]", quantity["unit"].as_str().expect("a unit"));
        let column = headings.iter().position(|it| *it == heading);
        let column = column.unwrap_or_else(|| panic!("no column {heading} in {headings:?}"));
        let swept: f64 = last[column].parse().expect("a number");
        let solved = quantity["value"].as_f64().expect("a number");
        assert!((swept - solved).abs() <= 1e-6 * solved.abs().max(1e-9), "{heading}: {swept} {solved}");
    }
}
