//! Warnings and limits in the table of a sweep, and how many there are.

use oilwedge_study::warning::KINDS;
use oilwedge_tests::program::repository;
use oilwedge_tests::sweeps::*;

/// Table, `sweep.json` and the count at the end have the same codes; a case has those of the run that solves it by
/// itself.
#[test]
fn every_warning_is_in_the_table() {
    let bench = Bench::new();
    sweep(&bench, "speed = [\"10 rad/s\", \"4000 rad/s\"]\neccentricity = [0.3, 0.6]", &[]);
    let told = bench.run(&["sweep", "scene.toml"]);
    assert_eq!(told.status, 0, "{}", told.stderr);
    let text = std::fs::read_to_string(bench.path().join("out/scene/sweep.json")).expect("a report");
    let report = object(&text);
    let rows = report["rows"].as_array().expect("rows");
    let codes = |row: &Value| -> Vec<String> {
        let list = row["warnings"].as_array().expect("a list");
        list.iter().map(|code| code.as_str().expect("a code").to_owned()).collect()
    };
    let mut count = 0;
    for (line, row) in table(&bench, "out/scene").lines().skip(1).zip(rows) {
        let codes = codes(row);
        assert!(line.contains(&format!(",{},", codes.join(";"))), "{line}");
        assert!(codes.iter().all(|code| KINDS.iter().any(|kind| kind.code == code)), "{codes:?}");
        count += usize::from(codes.contains(&"tension".to_owned()));
    }
    assert!(count > 0 && told.stdout.contains(&format!("tension: {count} case")), "{}", told.stdout);
    // One case by itself.
    let text = edited("08_flexpde_study_size", &[("eccentricity   = 0.6", "eccentricity = 0.3")]);
    bench.write("one.toml", text);
    let alone = object(&bench.run(&["solve", "one.toml", "--json"]).stdout);
    let alone = alone["warnings"].as_array().expect("a list").len();
    assert_eq!(codes(&rows[0]).len(), alone);
}

/// Design limits that are not met are counted: the film of a heavy load is too thin.
#[test]
fn limits_are_counted() {
    let bench = Bench::new();
    let scene = r#"
[bearing]
diameter = "50 mm"
length = "20 mm"
clearance = "25 um"
[mesh]
size = "6 mm"
[[feed]]
group = "hole"
hole = { diameter = "6 mm", angle = "90 deg", z = "0 mm" }
pressure = "3 bar"
[journal]
speed = "3000 rpm"
[load]
force = "1 kN"
angle = "270 deg"
[oil]
grade = "SAE 10W-40"
[cavitation]
model = "reynolds"
[heat]
inlet = "80 C"
film_min = "6 um"
[sweep]
force = ["0.3 kN", "5 kN", "6 kN"]
"#;
    bench.write("scene.toml", scene);
    let told = bench.run(&["sweep", "scene.toml", "--bars", "none"]);
    assert_eq!(told.status, 0, "{}", told.stderr);
    assert!(told.stdout.contains("limits    least film below 6 um: 2 cases\n"), "{}", told.stdout);
    let table = table(&bench, "out/scene");
    assert_eq!(table.matches("least film below 6 um").count(), 2, "{table}");
}

/// The page of sweeps explains every code.
#[test]
fn codes_are_documented() {
    let page = std::fs::read_to_string(repository().join("docs/reference/sweep.md")).expect("a page");
    for kind in KINDS {
        let row = format!("| `{}` | {} |", kind.code, kind.sentence);
        assert!(page.contains(&row), "no {row}");
    }
}
