//! Which cases a sweep makes of its axes, and what it says of each.

use oilwedge_tests::sweeps::*;
use serde_json::Value;

#[test]
fn cases_come_in_the_order_of_the_grid_with_units_in_the_headings() {
    let bench = Bench::new();
    sweep(
        &bench,
        "speed = [\"90 rpm\", \"60 rpm\"]\noil.viscosity = [\"0.2 Pa.s\", \"0.4 Pa.s\"]\neccentricity = { from = 0.3, to = 0.5, steps = 3 }",
        &[],
    );
    let report = done(&bench.run(&["sweep", "scene.toml", "--json", "--bars", "none"]));
    let text = table(&bench, "out/scene");
    let lines: Vec<Vec<&str>> = text.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!(lines[0][..5], ["case", "speed [rpm]", "oil.viscosity [Pa.s]", "eccentricity", "status"]);
    assert!(lines[0].contains(&"load [N]") && !text.contains("error") && !text.contains("eccentricity [1]"));
    let speeds = ["90.0", "60.0"];
    let wanted = speeds.iter().flat_map(|speed| {
        let viscosities = ["0.2", "0.4"].into_iter();
        viscosities.flat_map(move |viscosity| ["0.3", "0.4", "0.5"].map(|eps| [*speed, viscosity, eps]))
    });
    let inputs = lines[1..].iter().map(|line| [line[1], line[2], line[3]]);
    assert!(inputs.eq(wanted), "{text}");
    assert!(lines.iter().all(|line| line.len() == lines[0].len()));
    let place = lines[0].iter().position(|heading| *heading == "load [N]").expect("a load");
    for (line, row) in lines[1..].iter().zip(report["rows"].as_array().expect("rows")) {
        // The reader of JSON here is good to the last digit but one.
        let (told, load) = (line[place].parse::<f64>().expect("a number"), value(row, "load"));
        assert!((told / load - 1.0).abs() < 1e-15, "{told} {load}");
        assert_eq!(row["quantities"]["load"]["error"], Value::Null);
    }
    let told = bench.run(&["sweep", "scene.toml", "--bars", "none"]);
    for part in ["12 cases, 12 converged", "speed [rpm]", "kept      12 cases", "nothing was left to compute"] {
        assert!(told.stdout.contains(part), "no {part:?} in\n{}", told.stdout);
    }
    let told = bench.run(&["check", "scene.toml"]);
    assert!(
        told.stdout.contains("sweep     12 cases: 2 of speed [rpm] by 2 of oil.viscosity [Pa.s] by 3 of eccentricity")
    );
    let told = bench.run(&["solve", "scene.toml"]);
    assert!(told.status == 0 && told.stderr.contains("[sweep]") && told.stderr.contains("12 cases"), "{}", told.stderr);
}

/// Every key that changes the physics but not the mesh, one after the other: a case that follows others is the same as
/// a scene by itself.
#[test]
fn a_case_is_the_scene_by_itself() {
    let axes = [
        ("clearance", "[\"37.5 um\", \"40 um\"]", "clearance = \"37.5 um\"", "clearance = \"40 um\""),
        ("speed", "[\"10 rad/s\", \"11 rad/s\"]", "\"10 rad/s\"", "\"11 rad/s\""),
        ("viscosity", "[\"0.4 Pa.s\", \"0.3 Pa.s\"]", "\"0.4 Pa.s\"", "\"0.3 Pa.s\""),
        ("oil.barus.alpha", "[\"2.5e-8 1/Pa\", \"1e-8 1/Pa\"]", "2.5e-8", "1e-8"),
        ("ends.pressure", "[\"0.98 bar\", \"0.5 bar\"]", "\"0.98 bar\"", "\"0.5 bar\""),
        ("feed.feed_hole.pressure", "[\"1.96 bar\", \"3 bar\"]", "\"1.96 bar\"", "\"3 bar\""),
        ("cavitation.model", "[\"reynolds\", \"guembel\"]", "\"reynolds\"", "\"guembel\""),
        ("cavitation.pressure", "[\"0 bar\", \"-0.3 bar\"]", "\"0 bar\"", "\"-0.3 bar\""),
    ];
    let cavity = "[cavitation]\nmodel = \"reynolds\"\npressure = \"0 bar\"\n";
    for under_load in [false, true] {
        let edits: &[(&str, &str)] = if under_load { &LOADED } else { &[] };
        let base = edited("08_flexpde_study_size", edits) + cavity;
        for (axis, values, from, to) in axes {
            let bench = Bench::new();
            assert!(base.contains(from), "{from}");
            bench.write("scene.toml", format!("{base}\n[sweep]\n\"{axis}\" = {values}\n"));
            bench.write("alone.toml", base.replacen(from, to, 1));
            let report = done(&bench.run(&["sweep", "scene.toml", "--json"]));
            let alone = object(&bench.run(&["solve", "alone.toml", "--json"]).stdout);
            let row = &report["rows"][1];
            for (name, quantity) in alone["quantities"].as_object().expect("quantities") {
                let own = quantity["value"].as_f64().expect("a value");
                if name == axis {
                    continue;
                }
                // Sums of parts that cancel are known to rounding of the parts: forces to that of the load, flows of
                // that through the film.
                let size = match quantity["unit"].as_str() {
                    Some("N") => value(row, "load"),
                    Some("m3/s") => 1e-6,
                    Some("Pa") => value(row, "pressure_max"),
                    _ => own.abs(),
                };
                let off = (value(row, name) - own).abs();
                assert!(off <= 2e-9 * size, "{axis}, load {under_load}: {name} {own} {off}");
            }
        }
    }
}

/// What the balance of heat is made of belongs to its case: a film that takes over the mesh of the case before takes
/// none of its heat.
#[test]
fn each_case_has_the_heat_of_its_own() {
    let base = edited(
        "08_flexpde_study_size",
        &[(
            "viscosity = \"0.4 Pa.s\"",
            "walther = { nu40 = \"150 mm2/s\", nu100 = \"15 mm2/s\" }\ndensity = \"885 kg/m3\"",
        )],
    );
    let heat = "[cavitation]\nmodel = \"reynolds\"\n[heat]\ninlet = \"40 C\"\nheat_capacity = \"1.7 MJ/(m3.K)\"\nhousing = { conductance = \"5 W/K\", ambient = \"20 C\" }\n";
    for (axis, from, to) in [
        ("heat.inlet", "40 C", "60 C"),
        ("heat.heat_capacity", "1.7 MJ/(m3.K)", "1.2 MJ/(m3.K)"),
        ("heat.housing.conductance", "5 W/K", "15 W/K"),
        ("heat.housing.ambient", "20 C", "0 C"),
    ] {
        let bench = Bench::new();
        let text = format!("{base}\n{heat}");
        assert!(text.contains(from), "{text}");
        bench.write("scene.toml", format!("{text}[sweep]\n\"{axis}\" = [\"{from}\", \"{to}\"]\n"));
        bench.write("alone.toml", text.replace(from, to));
        let report = done(&bench.run(&["sweep", "scene.toml", "--json", "--bars", "none"]));
        let alone = object(&bench.run(&["solve", "alone.toml", "--json", "--bars", "none"]).stdout);
        let row = &report["rows"][1];
        for name in ["temperature_effective", "temperature_outlet", "friction_power"] {
            let own = alone["quantities"][name]["value"].as_f64().expect("a value");
            let off = (value(row, name) - own).abs();
            // The balance of heat is found to 1e-8 of the friction.
            assert!(off <= 1e-6 * own.abs(), "{axis}: {name} {own} {off}");
        }
    }
}

#[test]
fn drawn_meshes_follow_the_journal() {
    let bench = Bench::new();
    let sized = drawn("size = \"6 mm\"") + "[sweep]\neccentricity = [0.2, 0.25, 0.5, 0.9]\n";
    bench.write("scene.toml", &sized);
    let report = done(&bench.run(&["sweep", "scene.toml", "--json"]));
    let rows = report["rows"].as_array().expect("rows");
    let unknowns: Vec<u64> = rows.iter().filter_map(|row| row["unknowns"].as_u64()).collect();
    assert!(unknowns[0] == unknowns[1] && unknowns[1] < unknowns[3], "{unknowns:?}");
    bench.write(
        "alone.toml",
        sized.split("[sweep]").next().expect("a scene").replace("eccentricity = 0.6", "eccentricity = 0.9"),
    );
    let alone = object(&bench.run(&["solve", "alone.toml", "--json"]).stdout);
    let eccentricity = alone["quantities"]["eccentricity"]["value"].as_f64();
    assert!((eccentricity.expect("a value") - 0.9).abs() < 1e-12);
    let load = &alone["quantities"]["load"];
    assert!(
        (value(&rows[3], "load") - load["value"].as_f64().expect("a load")).abs()
            < load["error"].as_f64().expect("a bar")
    );
}

#[test]
fn a_case_without_a_film_is_a_row_with_its_reason() {
    let bench = Bench::new();
    sweep(&bench, "speed = [\"10 rad/s\", \"200 rad/s\", \"20 rad/s\"]", &[]);
    let report = done(&bench.run(&["sweep", "scene.toml", "--json"]));
    let status: Vec<_> = report["rows"].as_array().expect("rows").iter().map(|row| row["status"].clone()).collect();
    assert_eq!(status, ["converged", "no_solution", "converged"]);
    let failed = &report["rows"][1];
    assert!(failed["reason"].as_str().is_some_and(|reason| reason.contains("rad/s")), "{failed}");
    assert_eq!(failed["quantities"].as_object().map(|quantities| quantities.len()), Some(0));
    assert_eq!(table(&bench, "out/scene").lines().count(), 4);
    let none = Bench::new();
    sweep(&none, "speed = [\"200 rad/s\", \"300 rad/s\"]", &[]);
    let told = none.run(&["sweep", "scene.toml"]);
    assert_eq!(told.status, 1, "{}", told.stderr);
    assert!(told.stdout.contains("2 without a solution") && told.stdout.contains("case 1: "), "{}", told.stdout);
}

#[test]
fn a_tolerance_is_met_by_each_case() {
    let bench = Bench::new();
    let axes = "eccentricity = [0.3, 0.8]";
    bench.write("scene.toml", drawn("tolerance = \"0.1 %\"") + "[sweep]\n" + axes);
    let report = done(&bench.run(&["sweep", "scene.toml", "--json"]));
    for row in report["rows"].as_array().expect("rows") {
        let load = &row["quantities"]["load"];
        let (value, bar) = (load["value"].as_f64(), load["error"].as_f64());
        assert!(bar.expect("a bar") <= 1e-3 * value.expect("a value"), "{row}");
    }
    bench.refuses(&["sweep", "scene.toml", "--bars", "none"], &["--bars none conflicts with the mesh.tolerance"]);
    bench.write("narrow.toml", drawn("tolerance = \"0.001 %\"") + "[sweep]\n" + axes);
    let told = bench.run(&["sweep", "narrow.toml", "--max-unknowns", "1", "--json", "--out", "limited"]);
    let report = object(&told.stdout);
    let row = &report["rows"][1];
    assert!(
        row["status"] == "not_converged" && row["reason"].as_str().is_some_and(|reason| reason.starts_with("limit")),
        "{row}"
    );
}

#[test]
fn bad_axes_are_refused_at_once() {
    let bench = Bench::new();
    let told = [
        ("", &["sweep: names no axis"][..]),
        (
            "ecentricity = [0.1]",
            &["sweep.ecentricity: this key is not known as an axis", "did you mean \"eccentricity\""],
        ),
        ("\"oli.viscosity\" = [\"1 Pa.s\"]", &["begins with \"oli\"", "did you mean \"oil\""]),
        (
            "\"oil.viscossity\" = [\"1 Pa.s\"]",
            &["sweep.oil.viscossity: with", "this key is not known", "did you mean \"viscosity\""],
        ),
        ("\"feed.hole.pressure\" = [\"1 bar\"]", &["names no [[feed]]"]),
        ("eccentricity = [0.5, 1.2]", &["sweep.eccentricity: with eccentricity = 1.2", "journal.eccentricity"]),
        ("speed = [\"1 rpm\", \"1 rad/s\"]", &["has values in rpm and in rad/s", "in one unit"]),
        ("speed = [10]", &["sweep.speed: with speed = 10", "a bare number has no unit"]),
        ("speed = [\"10 mm\"]", &["\"mm\" is a unit of length"]),
        ("speed = []", &["has no values"]),
        ("speed = \"10 rpm\"", &["a list or a range of values is wanted, not a text"]),
        ("speed = { from = \"1 rpm\", to = \"9 rpm\" }", &["sweep.speed.steps: is missing"]),
        ("speed = { from = \"1 rpm\", to = \"9 rpm\", steps = 2.5 }", &["is not a whole number from 2"]),
        ("speed = { from = \"1 rpm\", to = \"9 rpm\", steps = 1 }", &["is not a whole number from 2"]),
        ("speed = { from = \"1 rpm\", to = \"9 Hz\", steps = 3 }", &["is in Hz, but from in rpm"]),
        ("speed = { from = \"0 rpm\", to = \"9 rpm\", steps = 3, spacing = \"log\" }", &["goes through zero"]),
        ("speed = { from = \"1 rpm\", to = \"9 rpm\", step = 3 }", &["did you mean \"steps\""]),
        ("speed = [\"1 rpm\"]\njournal.speed = [\"2 rpm\"]", &["is the same key of the scene as"]),
        (
            "speed = { from = \"1 rpm\", to = \"9 rpm\", steps = 1000 }\nviscosity = { from = \"1 Pa.s\", to = \"9 Pa.s\", steps = 1000 }",
            &["makes 1000000 cases, more than 100000"],
        ),
        ("\"feed.feed_hole.hole.diameter\" = [\"17 mm\", \"90 mm\"]", &["is wider than the liner"]),
        ("\"mesh.file\" = [\"nowhere.msh\"]", &["there is no file"]),
        ("force = [\"1 kN\"]", &["sweep", "load"]),
    ];
    for (axes, words) in told {
        sweep(&bench, axes, &[]);
        bench.refuses(&["sweep", "scene.toml"], words);
        bench.refuses(&["check", "scene.toml"], words);
    }
    bench.scene("08_flexpde_study_size", &[]);
    bench.refuses(&["sweep", "scene.toml"], &["has no [sweep]", "eccentricity = { from = 0.1"]);
}
