//! `oilwedge load`: the load over a cycle, its files, and what is refused.

use oilwedge_tests::program::repository;
use serde_json::Value;

use oilwedge_tests::bench::Bench;

#[test]
fn a_load_is_printed_written_and_drawn() {
    let bench = Bench::new();
    let scenes = repository().join("scenes/loads");
    for (name, peak, angle, words, frames_of_rod) in [
        ("synthetic_big_end", 207_294.6, 11.2, "207.295 kN", 0),
        ("crank_big_end", 81_509.59, 13.3, "work of the gas in a period", 3),
    ] {
        let scene = scenes.join(format!("{name}.toml")).display().to_string();
        let told = bench.run(&["load", &scene]);
        assert_eq!((told.status, told.stderr.as_str()), (0, ""), "{name}");
        assert!(told.stdout.contains(words), "{}", told.stdout);
        let folder = bench.path().join("out").join(name);
        let written = std::fs::read_to_string(folder.join("load.json")).expect("load.json");
        let json = bench.run(&["load", &scene, "--json", "--out", "other"]);
        assert_eq!((json.status, &json.stdout), (0, &written));
        let sheet: Value = serde_json::from_str(&written).expect("JSON");
        assert_eq!((&sheet["format"], &sheet["period_deg"]), (&"oilwedge-load/1".into(), &720.0.into()));
        let number = |value: &Value| value.as_f64().expect("a number");
        assert!((number(&sheet["peak"]["magnitude_n"]) - peak).abs() < 0.5, "{}", sheet["peak"]);
        assert!((number(&sheet["peak"]["angle_deg"]) - angle).abs() < 0.05, "{}", sheet["peak"]);
        assert_eq!(sheet["rows"].as_array().map(Vec::len), Some(720));
        for picture in ["load_by_angle", "load_polar"] {
            let svg = folder.join("plot").join(format!("{picture}.svg"));
            let svg = std::fs::read_to_string(svg).expect("a picture");
            assert!(svg.contains("width=\"170mm\""));
            if picture == "load_polar" {
                let titles = ["x along the rod, kN", "x to the cylinder, kN", "x along the throw, kN"];
                let drawn = titles.into_iter().filter(|title| svg.contains(title)).count();
                assert_eq!(drawn, frames_of_rod, "{name}");
            }
            assert!(folder.join("plot").join(format!("{picture}.png")).is_file());
        }
    }
}

#[test]
fn a_table_with_a_fault_is_refused_with_file_and_line() {
    let bench = Bench::new();
    let scenes = repository().join("scenes/loads");
    let text = |name: &str| std::fs::read_to_string(scenes.join(name)).expect("shipped");
    bench.write("synthetic_big_end.toml", text("synthetic_big_end.toml"));
    bench.refuses(&["load", "synthetic_big_end.toml"], &["load.file", "there is no file synthetic_big_end.csv"]);
    let table = text("synthetic_big_end.csv").replacen("\n6, ", "\n4, ", 1);
    bench.write("synthetic_big_end.csv", &table);
    let words = [
        "the table synthetic_big_end.csv, line 9: the angle 4 deg is not beyond that of the row before, 4 deg; sort the rows",
    ];
    let told = bench.refuses(&["load", "synthetic_big_end.toml"], &words);
    assert_eq!(told.stderr.trim().lines().count(), 1, "{}", told.stderr);
}

/// No steady film carries a load that changes.
#[test]
fn a_steady_film_of_a_load_over_a_cycle_is_refused() {
    let bench = Bench::new();
    let scene = repository().join("scenes/loads/crank_big_end.toml").display().to_string();
    for verb in ["solve", "check", "converge"] {
        let told = bench.refuses(&[verb, &scene], &["the load changes over a cycle", "oilwedge load SCENE"]);
        assert_eq!(told.stderr.matches("changes over a cycle").count(), 1, "{verb}: {}", told.stderr);
    }
    let plain = repository().join("scenes/01_plain_ring.toml").display().to_string();
    bench.refuses(&["load", &plain], &["there is no load over a cycle", "period = \"720 deg\""]);
}
