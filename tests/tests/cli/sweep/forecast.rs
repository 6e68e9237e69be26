//! How long a sweep will take, and axes that have a value twice.

use oilwedge_tests::sweeps::*;
use std::time::Instant;

/// The seconds in `300 cases, about 4 s on 2 threads`.
fn forecast(told: &Told) -> (usize, f64) {
    let line = told.stderr.lines().find(|line| line.contains(" cases, about "));
    let words: Vec<&str> = line.unwrap_or_else(|| panic!("{}", told.stderr)).split(' ').collect();
    let unit = match words[4] {
        "s" => 1.0,
        "min" => 60.0,
        other => panic!("{other}"),
    };
    (words[0].parse().expect("a number"), unit * words[3].parse::<f64>().expect("a number"))
}

/// Within a factor of two, in a sweep whose cases differ. Other programs on the machine may slow a part of a run, so it
/// has three.
#[test]
fn the_time_is_forecast() {
    let bench = Bench::new();
    loaded(&bench, 120);
    let attempt = || {
        let clock = Instant::now();
        let told = bench.run(&["sweep", "scene.toml", "--bars", "none", "--fresh"]);
        let seconds = clock.elapsed().as_secs_f64();
        assert_eq!(told.status, 0, "{}", told.stderr);
        assert!(told.stderr.lines().count() == 1, "{}", told.stderr);
        let (cases, about) = forecast(&told);
        assert_eq!(cases, 240);
        // It is told in whole seconds.
        (about - 1.0 < 2.0 * seconds && about + 1.0 > 0.5 * seconds, [about, seconds])
    };
    let mut attempts = Vec::new();
    while attempts.len() < 3 && !attempts.last().is_some_and(|(is_near, _)| *is_near) {
        attempts.push(attempt());
    }
    assert!(attempts.last().is_some_and(|(is_near, _)| *is_near), "{attempts:?}");
}

/// Values that an axis has twice are reported, and computed as often as they stand there.
#[test]
fn repeated_values_are_reported() {
    let bench = Bench::new();
    sweep(&bench, "eccentricity = [0.4, 0.6, 0.4]", &[]);
    let told = bench.run(&["sweep", "scene.toml"]);
    let warning = "warning: [sweep] eccentricity = 0.4 stands there 2 times";
    assert!(told.status == 0 && told.stderr.contains(warning), "{}", told.stderr);
    assert!(!told.stderr.contains("0.6") && told.stdout.contains("3 cases"), "{}", told.stdout);
}
