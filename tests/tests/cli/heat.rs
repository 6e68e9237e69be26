//! Scenes with `[heat]` through the program.

use serde_json::Value;

use crate::bench::{Bench, object};

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
    let told = bench.run(&["solve", "ring.toml", "--json"]);
    let result = if told.stdout.is_empty() {
        Value::Null
    } else {
        object(&told.stdout)
    };
    (told.status, result, told.stderr)
}

fn value(result: &Value, name: &str) -> f64 {
    let quantity = &result["quantities"][name];
    quantity["value"]
        .as_f64()
        .unwrap_or_else(|| panic!("no {name}: {quantity}"))
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
    let carried = 1.8e6 * get("side_flow") * (get("temperature_outlet") - 80.0);
    assert!((carried / get("heat_carried") - 1.0).abs() < 1e-3, "{carried}");
    for name in [
        "temperature_effective",
        "temperature_outlet",
        "heat_carried",
        "eccentricity",
        "load",
    ] {
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
    let fixed = format!(
        "grade = \"SAE 10W-40\"\ntemperature = \"{} C\"",
        get("temperature_effective")
    );
    let text = RING
        .replace("grade = \"SAE 10W-40\"", &fixed)
        .replace("[heat]\ninlet = \"80 C\"", "");
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
    let (status, result, stderr) = told(
        &bench,
        "inlet = \"80 C\"",
        "preset = \"diesel\"\nfilm_min = \"9 um\"\ntemperature_max = \"60 C\"",
    );
    assert_eq!(status, 0, "{stderr}");
    let heat = &result["heat"];
    assert_eq!(
        (&heat["preset"], &heat["is_fit"]),
        (&Value::from("diesel"), &Value::Bool(false))
    );
    let criteria = heat["criteria"].as_array().expect("criteria");
    let met: Vec<bool> = criteria
        .iter()
        .map(|it| it["is_met"].as_bool().expect("a word"))
        .collect();
    // Film and temperature are not met; 25 um of 25 mm and 77.5 C are usual for a diesel, 3 bar are not.
    assert_eq!(met, [false, false, true, false, true]);
    let text = bench.run(&["solve", "ring.toml"]);
    assert!(text.stdout.contains("NOT fit") && text.stdout.contains("unusual   pressure of the oil fed"));
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
    assert!(
        reason.starts_with("no temperature balances the heat: at 330 C still friction makes"),
        "{reason}"
    );
}

/// A film that is told to be isothermal, though its oil would be heated by tens of kelvins.
#[test]
fn isothermal_films_that_heat_up_are_doubted() {
    let bench = Bench::new();
    let text = RING
        .replace("grade = \"SAE 10W-40\"", "viscosity = \"40 mPa.s\"")
        .replace("[heat]\ninlet = \"80 C\"", "");
    std::fs::write(bench.path().join("ring.toml"), text).expect("written");
    let told = bench.run(&["solve", "ring.toml", "--json"]);
    let rise = object(&told.stdout)["regime"]["temperature_rise"]
        .as_f64()
        .expect("a rise");
    assert!(rise > 25.0, "{rise}");
    assert!(
        told.stderr.contains("a film as warm as its oil is fed"),
        "{}",
        told.stderr
    );
}
