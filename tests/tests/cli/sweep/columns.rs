//! `[sweep] columns`: which quantities, in which units.

use oilwedge_tests::sweeps::*;

fn headings(bench: &Bench) -> Vec<String> {
    let text = table(bench, "out/scene");
    let line = text.lines().next().expect("headings");
    line.split(',').map(str::to_owned).collect()
}

/// Names and symbols, each in its unit; the values are those of the usual columns.
#[test]
fn columns_of_choice_are_in_their_units() {
    let bench = Bench::new();
    let axes = "eccentricity = [0.4, 0.6]";
    sweep(&bench, axes, &[]);
    let usual = done(&bench.run(&["sweep", "scene.toml", "--json"]));
    assert!(headings(&bench).contains(&"load_x [N]".to_owned()));
    sweep(&bench, &format!("columns = [\"h_min um\", \"load kN\", \"min_film_angle rad\", \"C_w\"]\n{axes}"), &[]);
    let told = bench.run(&["sweep", "scene.toml", "--fresh"]);
    assert_eq!(told.status, 0, "{}", told.stderr);
    let wanted = [
        "case",
        "eccentricity",
        "status",
        "h_min [um]",
        "h_min error [um]",
        "load [kN]",
        "load error [kN]",
        "min_film_angle [rad]",
        "min_film_angle error [rad]",
        "C_w [1]",
        "C_w error [1]",
        "unknowns",
        "warnings",
        "verdict",
        "limits",
        "reason",
        "seconds",
    ];
    assert_eq!(headings(&bench), wanted);
    for heading in ["h_min [um]", "load [kN]", "min_film_angle [rad]", "C_w ", "warnings"] {
        assert!(told.stdout.contains(heading), "no {heading} in\n{}", told.stdout);
    }
    let text = std::fs::read_to_string(bench.path().join("out/scene/sweep.json")).expect("a report");
    let chosen = object(&text);
    // The page has these columns in their order.
    let page = oilwedge_report::page::sweep_page(&serde_json::from_str(&text).expect("a sweep"), &[]).expect("a page");
    let places = ["h_min, \u{b5}m</th>", "load, kN</th>", "min_film_angle, rad</th>"]
        .map(|heading| page.find(heading).expect(heading));
    assert!(places.is_sorted() && page.find("film thickness min").is_none_or(|place| place > places[2]));
    for row in 0..2 {
        let [usual, chosen] = [&usual["rows"][row], &chosen["rows"][row]];
        assert_eq!(chosen["quantities"]["h_min"]["unit"], "um");
        for (own, name, size) in [
            ("film_thickness_min", "h_min", 1e-6),
            ("load", "load", 1e3),
            ("min_film_angle", "min_film_angle", 180.0 / std::f64::consts::PI),
            ("load_coefficient", "C_w", 1.0),
        ] {
            let ratio = size * value(chosen, name) / value(usual, own);
            assert!((ratio - 1.0).abs() < 1e-12, "{name}: {ratio}");
        }
    }
}

/// A bad name or unit is refused where it stands, with the nearest name; nothing is written.
#[test]
fn bad_columns_are_refused() {
    let bench = Bench::new();
    for (columns, words) in [
        ("[\"hmin um\"]", "did you mean \"h_min\"?"),
        ("[\"load_xx\"]", "did you mean \"load_x\"?"),
        ("[\"h_min\", \"p_max mm\"]", "a pressure is wanted"),
        ("[\"p_max barr\"]", "did you mean \"bar\"?"),
        ("[\"feed_flow.hol l/min\"]", "groups of feeds: feed_hole"),
        ("[]", "a list of texts in quotes is wanted"),
        ("[1]", "a list of texts in quotes is wanted"),
        ("\"h_min um\"", "a list of texts in quotes is wanted"),
    ] {
        sweep(&bench, &format!("columns = {columns}\neccentricity = [0.4, 0.6]"), &[]);
        let told = bench.run(&["sweep", "scene.toml"]);
        assert!(told.status == 2 && told.stderr.contains(words), "{columns}: {}", told.stderr);
        assert!(told.stderr.contains("sweep.columns") && !bench.path().join("out").exists());
    }
    sweep(&bench, "columns = [\"load\"]", &[]);
    let told = bench.run(&["sweep", "scene.toml"]);
    assert!(told.status == 2 && told.stderr.contains("names no axis"), "{}", told.stderr);
}
