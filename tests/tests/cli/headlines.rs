//! What a run shows first and last, and how it gets on.

use oilwedge_tests::bench::Bench;

/// A main bearing of an engine under a load, its heat balanced; its oil turbulent and far too hot at the given speed
/// and limits.
const BEARING: &str = r#"
title = "Main bearing"
[bearing]
diameter = "60 mm"
length = "25 mm"
clearance = "30 um"
[mesh]
size = "8 mm"
[ends]
pressure = "0 bar"
[[feed]]
group = "hole"
hole = { diameter = "5 mm", angle = "90 deg", z = "0 mm" }
pressure = "4 bar"
[journal]
speed = "3000 rpm"
[load]
force = "3 kN"
angle = "270 deg"
[oil]
grade = "SAE 10W-40"
[heat]
inlet = "80 C"
film_min = "30 um"
[cavitation]
model = "reynolds"
pressure = "0 bar"
"#;

/// Names in the first column of the first table of a report.
fn first_table(text: &str) -> Vec<&str> {
    let lines = text.lines().skip_while(|line| !line.starts_with('╞')).skip(1);
    let rows = lines.take_while(|line| line.starts_with('│'));
    rows.filter_map(|row| row.split(['│', '┆']).nth(1).map(str::trim)).collect()
}

/// Engineers read position, film, pressure, temperature, friction and flow first; the load that they gave is not
/// repeated in five ways.
#[test]
fn headlines_stand_first_and_the_verdict_last() {
    let bench = Bench::new();
    std::fs::write(bench.path().join("bearing.toml"), BEARING).expect("written");
    let told = bench.run(&["solve", "bearing.toml"]);
    assert_eq!(told.status, 0, "{}", told.stderr);
    let names = first_table(&told.stdout);
    let wanted = [
        "eccentricity",
        "attitude_angle",
        "min_film_angle",
        "film_thickness_min",
        "pressure_max",
        "specific_load",
        "temperature_effective",
        "temperature_outlet",
        "friction_torque",
        "friction_power",
        "side_flow",
        "feed_flow.hole",
    ];
    assert_eq!(names, wanted, "{}", told.stdout);
    assert!(names.len() <= 14 && told.stdout.find('╞') < told.stdout.find("simulated"));
    let last = told.stdout.trim_end().lines().last().expect("a line");
    let count = told.stderr.lines().filter(|line| line.starts_with("warning: ")).count();
    let warnings = match count {
        0 => "no warnings".to_owned(),
        1 => "1 warning".to_owned(),
        count => format!("{count} warnings"),
    };
    assert_eq!(last, format!("verdict   converged; NOT fit: least film below 30 um; {warnings}"));
    // All pressures of the output are in one unit.
    for other in [" MPa", " kPa", " GPa", "┆ Pa "] {
        assert!(!told.stdout.contains(other) && !told.stderr.contains(other), "{other}");
    }
    let all = bench.run(&["solve", "bearing.toml", "--all", "--curve"]);
    for name in ["load_x", "sommerfeld_number", "friction_coefficient", "heat_carried", "carried off [W]"] {
        assert!(all.stdout.contains(name) && !told.stdout.contains(name), "{name}");
    }
    assert_eq!(first_table(&all.stdout), wanted);
}

/// At a given position the load is the answer, and stands first.
#[test]
fn the_load_of_a_given_position_is_a_headline() {
    let bench = Bench::new();
    let text = BEARING
        .replace("speed = \"3000 rpm\"", "speed = \"3000 rpm\"\neccentricity = 0.6\nmin_film_angle = \"270 deg\"")
        .replace("[load]\nforce = \"3 kN\"\nangle = \"270 deg\"", "");
    std::fs::write(bench.path().join("bearing.toml"), text).expect("written");
    let told = bench.run(&["solve", "bearing.toml"]);
    assert_eq!(told.status, 0, "{}", told.stderr);
    assert_eq!(first_table(&told.stdout)[..2], ["load", "eccentricity"]);
}

/// Where nobody watches, each mesh on the way to a tolerance leaves a line with the error reached and the one asked
/// for.
#[test]
fn every_level_is_a_line_without_a_terminal() {
    let bench = Bench::new();
    let text = BEARING
        .replace("size = \"8 mm\"", "tolerance = { side_flow = \"0.5 %\" }")
        .replace("[heat]\ninlet = \"80 C\"\nfilm_min = \"30 um\"\n", "")
        .replace("grade = \"SAE 10W-40\"", "viscosity = \"10 mPa.s\"");
    std::fs::write(bench.path().join("bearing.toml"), text).expect("written");
    let told = bench.run(&["solve", "bearing.toml"]);
    let levels: Vec<&str> = told.stderr.lines().filter(|line| line.starts_with("level ")).collect();
    let shown = told.stdout.lines().filter(|line| line.contains("unknowns, ")).count();
    assert!(levels.len() > 1 && levels.len() == shown, "{}\n{}", told.stderr, told.stdout);
    for (number, line) in (1..).zip(levels) {
        assert!(line.starts_with(&format!("level {number}: ")), "{line}");
        assert!(line.contains("side_flow ± ") && line.contains("asked for ± "), "{line}");
    }
}
