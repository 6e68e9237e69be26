//! `sweep`: many operating points at one command, in a table that survives its writer.

use std::process::Stdio;
use std::time::{Duration, Instant};

use oilwedge_tests::bench::{Bench, Told, edited, object};
use oilwedge_tests::flexpde_study::rows;
use oilwedge_tests::printed;
use oilwedge_tests::program::oilwedge_command;
use serde_json::Value;

/// A sweep of scene 08, a small one, with these axes.
fn sweep(bench: &Bench, axes: &str, edits: &[(&str, &str)]) {
    let text = edited("08_flexpde_study_size", edits);
    bench.write("scene.toml", format!("{text}\n[sweep]\n{axes}\n"));
}

/// Scene 09 with this key below `[mesh]`.
fn drawn(mesh: &str) -> String {
    edited("09_drawn_ring", &[]) + &format!("\n[mesh]\n{mesh}\n")
}

/// Scene 08 under a load, with a film that breaks.
const LOADED: [(&str, &str); 2] = [
    (
        "min_film_angle = \"180 deg\"",
        "[load]\nforce = \"20 kN\"\nangle = \"130 deg\"",
    ),
    ("eccentricity   = 0.6", ""),
];
const BREAKS: &str = "[cavitation]\nmodel = \"reynolds\"\n";

/// A sweep of a load on that bearing: `count` forces at two speeds.
fn loaded(bench: &Bench, count: usize) {
    let axes =
        format!("speed = [\"8 rad/s\", \"10 rad/s\"]\nforce = {{ from = \"5 kN\", to = \"20 kN\", steps = {count} }}");
    let text = edited("08_flexpde_study_size", &LOADED);
    bench.write("scene.toml", format!("{text}\n{BREAKS}\n[sweep]\n{axes}\n"));
}

fn table(bench: &Bench, folder: &str) -> String {
    std::fs::read_to_string(bench.path().join(folder).join("sweep.csv")).expect("a table")
}

/// The rows of a table with their seconds left out. No text of these tables has a comma within.
fn timeless(table: &str) -> Vec<String> {
    let cut = |line: &str| line.rsplit_once(',').map(|(row, _)| row.to_owned());
    table.lines().map(|line| cut(line).expect("columns")).collect()
}

fn done(told: &Told) -> Value {
    assert_eq!((told.status, told.stderr.as_str()), (0, ""), "{}", told.stdout);
    object(&told.stdout)
}

fn value(row: &Value, name: &str) -> f64 {
    let value = row["quantities"][name]["value"].as_f64();
    value.unwrap_or_else(|| panic!("no {name} in {row}"))
}

#[test]
fn the_sweep_of_the_study_meets_its_rows() {
    let bench = Bench::new();
    bench.scene("18_sweep_eccentricity", &[]);
    let report = done(&bench.run(&["sweep", "scene.toml", "--json"]));
    assert_eq!(
        (report["cases"].as_u64(), report["complete"].as_bool()),
        (Some(16), Some(true))
    );
    let study = rows();
    for row in report["rows"].as_array().expect("rows") {
        let number = |name: &str| row["inputs"][name].as_f64().expect("an input");
        let viscosity = if number("oil.barus.alpha") == 0.0 {
            "constant"
        } else {
            "conservative"
        };
        let reference = study.iter().find(|reference| {
            (reference.liner.as_str(), reference.cavitation.as_str()) == ("shell", "none")
                && reference.viscosity == viscosity
                && (reference.eccentricity, reference.mu0, reference.omega) == (number("eccentricity"), 0.4, 10.0)
        });
        let reference = reference.unwrap_or_else(|| panic!("no reference for {row}"));
        // As in literature/flexpde_2016.rs; bars are there, so the numbers are those of the cubic film.
        let c_w = reference.reference("C_w").expect("C_w");
        assert!(
            (value(row, "load_coefficient") - c_w).abs() < 1e-4 * c_w + 6e-5,
            "{row}"
        );
        let attitude = reference.reference("attitude_deg").expect("an angle");
        assert!((value(row, "attitude_angle") - attitude).abs() < 0.01, "{row}");
        let bar = row["quantities"]["load"]["error"].as_f64().expect("a bar");
        assert!(bar > 0.0 && bar < 2e-3 * value(row, "load"), "{row}");
    }
}

/// The closed form and finite differences of the real length (`literature/short_crankshaft_bearing.rs`, `short_bearing_finite_length.rs`): a film
/// refined to 0.5 % of its load is asked for 1 % of it, 1.5 % of its greatest pressure, 2 % of its flow and 0.2 degrees.
#[test]
fn the_sweeps_of_the_crankshaft_bearing_meet_their_rows() {
    let wanted = printed::rows("source000/finite_length.csv");
    for (name, squeeze) in [
        ("21_short_crankshaft_bearing", 0.0),
        ("22_squeezed_crankshaft_bearing", 0.4),
    ] {
        let bench = Bench::new();
        bench.scene(name, &[]);
        let report = done(&bench.run(&["sweep", "scene.toml", "--json"]));
        let cases = report["rows"].as_array().expect("rows");
        assert_eq!(cases.len(), 10);
        for row in cases {
            // A short film under Reynolds' condition is the half film: each line along the axis has pressure or none.
            let model = match row["inputs"]["bearing.theory"].as_str() {
                Some("short") => "short_GUM",
                _ => "finite_REY",
            };
            let speed = row["inputs"]["speed"].as_f64().expect("a speed");
            let wanted = wanted.iter().find(|it| {
                (it.text("model"), it.number("E")) == (model, squeeze) && (it.number("n") - speed).abs() < 1e-6
            });
            let wanted = wanted.unwrap_or_else(|| panic!("no {model} at {speed}: {row}"));
            for (quantity, column, scale, tolerance) in [
                ("load", "R", 1.0, 1e-2),
                ("pressure_max", "p_max", 1e-6, 1.5e-2),
                ("side_flow", "Q_both_ends", 1.0, 2e-2),
            ] {
                let off = scale * value(row, quantity) / wanted.number(column) - 1.0;
                assert!(off.abs() < tolerance, "{quantity} is {off:.1e} off: {row}");
            }
            assert!(
                (value(row, "attitude_angle") - wanted.number("theta")).abs() < 0.2,
                "{row}"
            );
        }
    }
}

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
    assert_eq!(
        lines[0][..5],
        ["case", "speed [rpm]", "oil.viscosity [Pa.s]", "eccentricity", "status"]
    );
    assert!(lines[0].contains(&"load [N]") && !text.contains("error") && !text.contains("eccentricity [1]"));
    let speeds = ["90.0", "60.0"];
    let wanted = speeds.iter().flat_map(|speed| {
        let viscosities = ["0.2", "0.4"].into_iter();
        viscosities.flat_map(move |viscosity| ["0.3", "0.4", "0.5"].map(|eps| [*speed, viscosity, eps]))
    });
    let inputs = lines[1..].iter().map(|line| [line[1], line[2], line[3]]);
    assert!(inputs.eq(wanted), "{text}");
    assert!(lines.iter().all(|line| line.len() == lines[0].len()));
    let place = lines[0]
        .iter()
        .position(|heading| *heading == "load [N]")
        .expect("a load");
    for (line, row) in lines[1..].iter().zip(report["rows"].as_array().expect("rows")) {
        // The reader of JSON here is good to the last digit but one.
        let (told, load) = (line[place].parse::<f64>().expect("a number"), value(row, "load"));
        assert!((told / load - 1.0).abs() < 1e-15, "{told} {load}");
        assert_eq!(row["quantities"]["load"]["error"], Value::Null);
    }
    let told = bench.run(&["sweep", "scene.toml", "--bars", "none"]);
    for part in [
        "12 cases, 12 converged",
        "speed [rpm]",
        "kept      12 cases",
        "nothing was left to compute",
    ] {
        assert!(told.stdout.contains(part), "no {part:?} in\n{}", told.stdout);
    }
    let told = bench.run(&["check", "scene.toml"]);
    assert!(
        told.stdout
            .contains("sweep     12 cases: 2 of speed [rpm] by 2 of oil.viscosity [Pa.s] by 3 of eccentricity")
    );
    let told = bench.run(&["solve", "scene.toml"]);
    assert!(
        told.status == 0 && told.stderr.contains("[sweep]") && told.stderr.contains("12 cases"),
        "{}",
        told.stderr
    );
}

/// Every key that changes the physics but not the mesh, one after the other: a case that follows others is the same as
/// a scene by itself.
#[test]
fn a_case_is_the_scene_by_itself() {
    let axes = [
        (
            "clearance",
            "[\"37.5 um\", \"40 um\"]",
            "clearance = \"37.5 um\"",
            "clearance = \"40 um\"",
        ),
        ("speed", "[\"10 rad/s\", \"11 rad/s\"]", "\"10 rad/s\"", "\"11 rad/s\""),
        (
            "viscosity",
            "[\"0.4 Pa.s\", \"0.3 Pa.s\"]",
            "\"0.4 Pa.s\"",
            "\"0.3 Pa.s\"",
        ),
        ("oil.barus.alpha", "[\"2.5e-8 1/Pa\", \"1e-8 1/Pa\"]", "2.5e-8", "1e-8"),
        (
            "ends.pressure",
            "[\"0.98 bar\", \"0.5 bar\"]",
            "\"0.98 bar\"",
            "\"0.5 bar\"",
        ),
        (
            "feed.feed_hole.pressure",
            "[\"1.96 bar\", \"3 bar\"]",
            "\"1.96 bar\"",
            "\"3 bar\"",
        ),
        (
            "cavitation.model",
            "[\"reynolds\", \"guembel\"]",
            "\"reynolds\"",
            "\"guembel\"",
        ),
        (
            "cavitation.pressure",
            "[\"0 bar\", \"-0.3 bar\"]",
            "\"0 bar\"",
            "\"-0.3 bar\"",
        ),
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
                // Sums of parts that cancel are known to rounding of the parts: forces to that of the load, flows of that through the film.
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
        sized
            .split("[sweep]")
            .next()
            .expect("a scene")
            .replace("eccentricity = 0.6", "eccentricity = 0.9"),
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
fn any_number_of_threads_gives_the_same_rows() {
    let bench = Bench::new();
    loaded(&bench, 9);
    let run = |threads: &str, folder: &str, bars: &str| {
        let told = bench.run(&[
            "sweep",
            "scene.toml",
            "--json",
            "--threads",
            threads,
            "--out",
            folder,
            "--bars",
            bars,
        ]);
        done(&told);
        timeless(&table(&bench, folder))
    };
    for bars in ["none", "auto"] {
        let one = run("1", &format!("one_{bars}"), bars);
        assert_eq!(one.len(), 19);
        assert_eq!(one, run("2", &format!("two_{bars}"), bars));
        assert_eq!(one, run("5", &format!("five_{bars}"), bars));
    }
}

#[test]
fn a_table_that_was_cut_off_anywhere_is_completed() {
    let bench = Bench::new();
    loaded(&bench, 9);
    let again = || bench.run(&["sweep", "scene.toml", "--json", "--bars", "none"]);
    done(&again());
    let (whole, folder) = (table(&bench, "out/scene"), bench.path().join("out/scene"));
    let about = std::fs::read_to_string(folder.join("sweep.json")).expect("a report");
    let begun = about.replacen("\"complete\": true", "\"complete\": false", 1);
    let line = whole.lines().next().expect("headings").len() + 1;
    for cut in [
        0,
        5,
        line - 1,
        line,
        line + 1,
        whole.len() / 2,
        whole.len() * 2 / 3,
        whole.len() - 1,
        whole.len(),
    ] {
        std::fs::write(folder.join("sweep.csv"), &whole.as_bytes()[..cut]).expect("a table");
        std::fs::write(folder.join("sweep.json"), &begun).expect("a report");
        done(&again());
        assert_eq!(timeless(&table(&bench, "out/scene")), timeless(&whole), "cut at {cut}");
        assert!(
            std::fs::read_to_string(folder.join("sweep.json"))
                .expect("a report")
                .contains("\"complete\": true")
        );
    }
    // Rows that stand there are believed: one that is marked stays.
    let marked = whole.replacen(",converged,", ",marked,", 1);
    std::fs::write(folder.join("sweep.csv"), &marked).expect("a table");
    again();
    assert_eq!(table(&bench, "out/scene"), marked);
}

#[test]
fn a_sweep_that_is_killed_goes_on_where_it_was() {
    let bench = Bench::new();
    loaded(&bench, 60);
    let arguments = ["sweep", "scene.toml", "--json", "--bars", "none", "--threads", "2"];
    let rows = |folder: &str| {
        let text = std::fs::read_to_string(bench.path().join(folder).join("sweep.csv"));
        text.map_or(0, |text| text.lines().count().saturating_sub(1))
    };
    let mut killed = oilwedge_command()
        .args(arguments)
        .current_dir(bench.path())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("the program starts");
    let deadline = Instant::now() + Duration::from_secs(120);
    while rows("out/scene") < 30 && Instant::now() < deadline {
        std::thread::sleep(Duration::from_millis(2));
    }
    killed.kill().expect("it can be killed");
    killed.wait().expect("it ends");
    let left = rows("out/scene");
    assert!((30..120).contains(&left), "{left} rows when it was killed");
    done(&bench.run(&arguments));
    let resumed = timeless(&table(&bench, "out/scene"));
    done(&bench.run(&[&arguments[..], &["--out", "whole"]].concat()));
    assert_eq!(resumed, timeless(&table(&bench, "whole")));
}

#[test]
fn a_case_without_a_film_is_a_row_with_its_reason() {
    let bench = Bench::new();
    sweep(&bench, "speed = [\"10 rad/s\", \"200 rad/s\", \"20 rad/s\"]", &[]);
    let report = done(&bench.run(&["sweep", "scene.toml", "--json"]));
    let status: Vec<_> = report["rows"]
        .as_array()
        .expect("rows")
        .iter()
        .map(|row| row["status"].clone())
        .collect();
    assert_eq!(status, ["converged", "no_solution", "converged"]);
    let failed = &report["rows"][1];
    assert!(
        failed["reason"].as_str().is_some_and(|reason| reason.contains("rad/s")),
        "{failed}"
    );
    assert_eq!(
        failed["quantities"].as_object().map(|quantities| quantities.len()),
        Some(0)
    );
    assert_eq!(table(&bench, "out/scene").lines().count(), 4);
    let none = Bench::new();
    sweep(&none, "speed = [\"200 rad/s\", \"300 rad/s\"]", &[]);
    let told = none.run(&["sweep", "scene.toml"]);
    assert_eq!(told.status, 1, "{}", told.stderr);
    assert!(
        told.stdout.contains("2 without a solution") && told.stdout.contains("case 1: "),
        "{}",
        told.stdout
    );
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
    bench.refuses(
        &["sweep", "scene.toml", "--bars", "none"],
        &["--bars none conflicts with the mesh.tolerance"],
    );
    let told = bench.run(&[
        "sweep",
        "scene.toml",
        "--max-unknowns",
        "1",
        "--json",
        "--out",
        "limited",
    ]);
    let report = object(&told.stdout);
    let row = &report["rows"][1];
    assert!(
        row["status"] == "not_converged" && row["reason"].as_str().is_some_and(|reason| reason.starts_with("limit")),
        "{row}"
    );
}

#[test]
fn another_sweep_in_the_folder_is_left_alone() {
    let bench = Bench::new();
    sweep(&bench, "eccentricity = [0.3, 0.4]", &[]);
    done(&bench.run(&["sweep", "scene.toml", "--json"]));
    bench.refuses(
        &["sweep", "scene.toml", "--bars", "none"],
        &["holds a sweep with error bars", "--out", "--fresh"],
    );
    sweep(&bench, "eccentricity = [0.3, 0.5]", &[]);
    bench.refuses(
        &["sweep", "scene.toml"],
        &["of another scene, or of this one before it was changed"],
    );
    done(&bench.run(&["sweep", "scene.toml", "--json", "--fresh"]));
    std::fs::remove_file(bench.path().join("out/scene/sweep.json")).expect("a report");
    bench.refuses(
        &["sweep", "scene.toml"],
        &["without the record of what it was computed from"],
    );
}

#[test]
fn bad_axes_are_refused_at_once() {
    let bench = Bench::new();
    let told = [
        ("", &["sweep: names no axis"][..]),
        (
            "ecentricity = [0.1]",
            &[
                "sweep.ecentricity: this key is not known as an axis",
                "did you mean \"eccentricity\"",
            ],
        ),
        (
            "\"oli.viscosity\" = [\"1 Pa.s\"]",
            &["begins with \"oli\"", "did you mean \"oil\""],
        ),
        (
            "\"oil.viscossity\" = [\"1 Pa.s\"]",
            &[
                "sweep.oil.viscossity: with",
                "this key is not known",
                "did you mean \"viscosity\"",
            ],
        ),
        ("\"feed.hole.pressure\" = [\"1 bar\"]", &["names no [[feed]]"]),
        (
            "eccentricity = [0.5, 1.2]",
            &["sweep.eccentricity: with eccentricity = 1.2", "journal.eccentricity"],
        ),
        (
            "speed = [\"1 rpm\", \"1 rad/s\"]",
            &["has values in rpm and in rad/s", "in one unit"],
        ),
        (
            "speed = [10]",
            &["sweep.speed: with speed = 10", "a bare number has no unit"],
        ),
        ("speed = [\"10 mm\"]", &["\"mm\" is a unit of length"]),
        ("speed = []", &["has no values"]),
        (
            "speed = \"10 rpm\"",
            &["a list or a range of values is wanted, not a text"],
        ),
        (
            "speed = { from = \"1 rpm\", to = \"9 rpm\" }",
            &["sweep.speed.steps: is missing"],
        ),
        (
            "speed = { from = \"1 rpm\", to = \"9 rpm\", steps = 2.5 }",
            &["is not a whole number from 2"],
        ),
        (
            "speed = { from = \"1 rpm\", to = \"9 rpm\", steps = 1 }",
            &["is not a whole number from 2"],
        ),
        (
            "speed = { from = \"1 rpm\", to = \"9 Hz\", steps = 3 }",
            &["is in Hz, but from in rpm"],
        ),
        (
            "speed = { from = \"0 rpm\", to = \"9 rpm\", steps = 3, spacing = \"log\" }",
            &["goes through zero"],
        ),
        (
            "speed = { from = \"1 rpm\", to = \"9 rpm\", step = 3 }",
            &["did you mean \"steps\""],
        ),
        (
            "speed = [\"1 rpm\"]\njournal.speed = [\"2 rpm\"]",
            &["is the same key of the scene as"],
        ),
        (
            "speed = { from = \"1 rpm\", to = \"9 rpm\", steps = 1000 }\nviscosity = { from = \"1 Pa.s\", to = \"9 Pa.s\", steps = 1000 }",
            &["makes 1000000 cases, more than 100000"],
        ),
        (
            "\"feed.feed_hole.hole.diameter\" = [\"17 mm\", \"90 mm\"]",
            &["is wider than the liner"],
        ),
        ("\"mesh.file\" = [\"nowhere.msh\"]", &["there is no file"]),
        ("force = [\"1 kN\"]", &["sweep", "load"]),
    ];
    for (axes, words) in told {
        sweep(&bench, axes, &[]);
        bench.refuses(&["sweep", "scene.toml"], words);
        bench.refuses(&["check", "scene.toml"], words);
    }
    bench.scene("08_flexpde_study_size", &[]);
    bench.refuses(
        &["sweep", "scene.toml"],
        &["has no [sweep]", "eccentricity = { from = 0.1"],
    );
}
