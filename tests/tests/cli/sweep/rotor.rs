//! The table of stiffness and damping for programs of rotors.

use oilwedge_tests::sweeps::*;

/// The shipped scene over these axes.
fn whirl(bench: &Bench, sweep: &str) {
    let text = edited("25_whirl", &[]);
    let own = text.find("[sweep]").expect("a sweep");
    bench.write("scene.toml", format!("{}[sweep]\n{sweep}\n", &text[..own]));
}

fn rotor(bench: &Bench) -> Option<String> {
    std::fs::read_to_string(bench.path().join("out/scene/rotor_bearing.csv")).ok()
}

fn rotor_3(bench: &Bench) -> Option<String> {
    std::fs::read_to_string(bench.path().join("out/scene/rotor_bearing_3.csv")).ok()
}

/// Over speed and whirl there is a table for version 3 alone, with the frequency of the whirl.
#[test]
fn a_sweep_of_speed_and_whirl_writes_a_table_of_both() {
    let bench = Bench::new();
    whirl(&bench, "\"dynamics.whirl\" = [1, 0.5]\nspeed = [\"400 rad/s\", \"200 rad/s\"]");
    done(&bench.run(&["sweep", "scene.toml", "--json"]));
    let table = rotor_3(&bench).expect("a table");
    let keys: Vec<Vec<&str>> = table.lines().map(|line| line.split(',').take(2).collect()).collect();
    let wanted =
        [["speed", "frequency"], ["200.0", "100.0"], ["200.0", "200.0"], ["400.0", "200.0"], ["400.0", "400.0"]];
    assert_eq!((keys, rotor(&bench)), (wanted.map(|keys| keys.to_vec()).to_vec(), None));
}

#[test]
fn a_sweep_of_the_speed_writes_a_table_for_rotors() {
    let bench = Bench::new();
    whirl(&bench, "speed = [\"5000 rpm\", \"3000 rpm\"]");
    let report = done(&bench.run(&["sweep", "scene.toml", "--json"]));
    let table = rotor(&bench).expect("a table");
    let mut lines = table.lines();
    assert_eq!(lines.next(), Some("frequency,kxx,kxy,kyx,kyy,cxx,cxy,cyx,cyy"));
    // By growing speed, whatever the order of the cases.
    for (line, row) in lines.zip([&report["rows"][1], &report["rows"][0]]) {
        let numbers: Vec<f64> = line.split(',').map(|text| text.parse().expect("a number")).collect();
        let speed = row["inputs"]["speed"].as_f64().expect("a speed") * std::f64::consts::PI / 30.0;
        assert!((numbers[0] / speed - 1.0).abs() < 1e-12);
        let names = ["stiffness", "damping"].map(|of| ["xx", "xy", "yx", "yy"].map(|entry| format!("{of}_{entry}")));
        for (number, name) in numbers[1..].iter().zip(names.as_flattened()) {
            assert!((number / value(row, name) - 1.0).abs() < 1e-14, "{name}");
        }
    }
    assert_eq!(table.lines().count(), 3);
    let of_version_3 = rotor_3(&bench).expect("a table");
    assert_eq!(of_version_3, table.replace("frequency", "speed"));
    let told = bench.run(&["sweep", "scene.toml"]);
    assert!(told.stdout.contains("sweep.csv, sweep.json, rotor_bearing.csv, rotor_bearing_3.csv"), "{}", told.stdout);
}

/// Columns in other units are written in SI; without all of them, or with another axis, there is no table, and an old
/// one goes.
#[test]
fn the_table_needs_all_coefficients_over_the_speed_alone() {
    let bench = Bench::new();
    let columns =
        "columns = [\"K_xx MN/m\", \"K_xy kN/m\", \"K_yx\", \"K_yy\", \"C_xx\", \"C_xy\", \"C_yx\", \"C_yy kN.s/m\"]";
    let speed = "speed = [\"300 rad/s\"]";
    whirl(&bench, &format!("{columns}\n{speed}"));
    let report = done(&bench.run(&["sweep", "scene.toml", "--json"]));
    let table = rotor(&bench).expect("a table");
    let first = table.lines().nth(1).and_then(|line| line.split(',').nth(1)).expect("kxx");
    let own = 1e6 * value(&report["rows"][0], "K_xx");
    assert!((first.parse::<f64>().expect("a number") / own - 1.0).abs() < 1e-12);
    for sweep in [
        format!("columns = [\"K_xx\"]\n{speed}"),
        format!("{speed}\n\"dynamics.mass\" = [\"100 kg\", \"200 kg\"]"),
        "force = [\"1 kN\"]".to_owned(),
    ] {
        whirl(&bench, &sweep);
        let told = bench.run(&["sweep", "scene.toml", "--fresh"]);
        assert_eq!((told.status, rotor(&bench)), (0, None), "{sweep}: {}", told.stderr);
    }
}

/// A mass that is swept is that of each case.
#[test]
fn the_decrement_falls_with_the_mass() {
    let bench = Bench::new();
    whirl(&bench, "\"dynamics.mass\" = [\"100 kg\", \"1000 kg\", \"2000 kg\"]");
    let report = done(&bench.run(&["sweep", "scene.toml", "--json"]));
    let [light, middle, heavy] = [0, 1, 2].map(|case| value(&report["rows"][case], "logarithmic_decrement"));
    assert!(light > middle && middle > 0.0 && heavy < 0.0, "{light} {middle} {heavy}");
}
