//! Ctrl-C and the end that the system asks for: what is finished is kept, and the best answer so far is told.

use std::path::Path;
use std::process::{Child, Output};
use std::time::Duration;

use oilwedge_tests::bench::{Bench, edited, object};
use oilwedge_tests::two_scenes::{names, rows, send, start, sweep, until};
use serde_json::Value;

fn ended(run: Child) -> (Output, String) {
    let output = run.wait_with_output().expect("it ends");
    let stderr = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(!stderr.contains("panicked"), "{stderr}");
    (output, stderr)
}

/// Waits until the run looks after Ctrl-C: the system tells which signals a process catches. Where it does not, the
/// first moments are waited for.
fn until_it_listens(run: &Child) {
    const INTERRUPT: u64 = 1 << 1;
    let status = format!("/proc/{}/status", run.id());
    if !Path::new(&status).exists() {
        std::thread::sleep(Duration::from_millis(500));
        return;
    }
    until(|| {
        let text = std::fs::read_to_string(&status).expect("a process");
        let caught = text.lines().find_map(|line| line.strip_prefix("SigCgt:"));
        let caught = caught.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
        caught.expect("a mask of signals") & INTERRUPT != 0
    });
}

#[test]
fn a_sweep_ends_with_its_rows_and_goes_on_from_them() {
    let bench = Bench::new();
    sweep(&bench, 30);
    let command = ["sweep", "scene.toml", "--out"];
    let folder = bench.path().join("out");
    let mut before = 0;
    for signal in ["-INT", "-TERM"] {
        let run = start(&bench, &[&command[..], &["out"]].concat());
        until(|| rows(&folder).len() > before + 5);
        send(signal, &run);
        let (output, stderr) = ended(run);
        assert_eq!(output.status.code(), Some(130), "{stderr}");
        before = rows(&folder).len();
        let told = format!("interrupted: {before} of 60 cases are in out/sweep.csv; the same command goes on");
        assert!(stderr.contains(&told), "{stderr}");
        assert_eq!(names(&folder), ["sweep.csv", "sweep.json"]);
    }
    assert!(before < 60, "the sweep ended before it was interrupted");
    assert_eq!(bench.run(&[&command[..], &["out"]].concat()).status, 0);
    assert_eq!(bench.run(&[&command[..], &["whole"]].concat()).status, 0);
    assert_eq!(rows(&folder), rows(&bench.path().join("whole")));
}

/// What a run of `scene.toml` into `out` writes that is interrupted so many seconds after it began.
fn interrupted(bench: &Bench, seconds: f64) -> Value {
    let run = start(bench, &["solve", "scene.toml", "--out", "out"]);
    until_it_listens(&run);
    std::thread::sleep(Duration::from_secs_f64(seconds));
    send("-INT", &run);
    let (output, stderr) = ended(run);
    assert_eq!(output.status.code(), Some(1), "{stderr}");
    let result = std::fs::read_to_string(bench.path().join("out/result.json")).expect("a result");
    object(&result)
}

#[test]
fn a_refinement_ends_with_the_best_answer_so_far() {
    let bench = Bench::new();
    bench.write(
        "scene.toml",
        edited("09_drawn_ring", &[]) + "\n[mesh]\ntolerance = \"0.0000001 %\"\n[cavitation]\nmodel = \"reynolds\"\n",
    );
    let result = interrupted(&bench, 0.3);
    assert_eq!(result["status"], "not_converged");
    let reason = result["reason"].as_str().expect("a reason");
    assert!(reason.starts_with("interrupted: the bars are "), "{reason}");
    let load = &result["quantities"]["load"];
    assert!(load["value"].as_f64().is_some() && load["error"].as_f64().is_some(), "{load}");
    // Where the next mesh takes long, the numbers come without the picture.
    assert!(names(&bench.path().join("out")).contains(&"result.json".to_owned()));
}

/// A ring four thousand times as wide as long has a first mesh of 150 000 unknowns, which takes seconds to make, and
/// has no answer before.
#[test]
fn a_first_mesh_ends_in_time() {
    let bench = Bench::new();
    let text = edited(
        "09_drawn_ring",
        &[("diameter = \"75 mm\"", "diameter = \"334 mm\""), ("length = \"75 mm\"", "length = \"0.084 mm\"")],
    );
    bench.write("scene.toml", text);
    let run = start(&bench, &["solve", "scene.toml", "--out", "out"]);
    until_it_listens(&run);
    std::thread::sleep(Duration::from_millis(300));
    send("-INT", &run);
    let (output, stderr) = ended(run);
    assert_eq!(output.status.code(), Some(130), "{stderr}");
    assert!(stderr.contains("interrupted: ended before there was an answer; nothing was written"), "{stderr}");
    assert!(!bench.path().join("out").exists());
}

#[test]
fn a_search_for_a_position_ends_where_it_is() {
    let bench = Bench::new();
    bench.scene("17_engine_main_bearing", &[("1.5 mm", "2.5 mm")]);
    let result = interrupted(&bench, 0.0);
    assert_eq!(result["status"], "not_converged");
    let reason = result["reason"].as_str().expect("a reason");
    assert!(reason.starts_with("interrupted: "), "{reason}");
    assert!(result["quantities"]["load"]["value"].as_f64().is_some(), "{result}");
    assert!(result["balances"]["force"].as_f64().is_some_and(|force| force > 1e-10), "{result}");
}

/// A heavy rotor whirls on its film: its orbit does not close.
const WHIRLING: &str = r#"
[bearing]
diameter = "100 mm"
length = "50 mm"
clearance = "50 um"
[oil]
viscosity = "20 mPa.s"
[cavitation]
model = "guembel"
[journal]
speed = "100 rad/s"
[load]
frame = "shell"
period = "360 deg"
harmonics = [{ order = 0, cos = { x = "500 N" } }, { order = 1, cos = { x = "50 N" } }]
[orbit]
tolerance = 3e-2
closure = 1e-12
cycles = 1000
mass = "20000 kg"
[mesh]
size = "30 mm"
"#;

#[test]
fn an_orbit_ends_with_the_cycles_that_are_done() {
    let bench = Bench::new();
    bench.write("scene.toml", WHIRLING);
    let result = interrupted(&bench, 5.0);
    assert_eq!(result["status"], "not_converged");
    let reason = result["reason"].as_str().expect("a reason");
    assert!(reason.starts_with("interrupted: the orbit was ended after "), "{reason}");
    let thinnest = &result["quantities"]["cycle_film_thickness_min"]["value"];
    assert!(thinnest.as_f64().is_some_and(|least| least > 0.0), "{result}");
    assert_eq!(names(&bench.path().join("out")), ["film.vtu", "orbit.csv", "result.json"]);
}

#[test]
fn a_study_ends_with_its_levels() {
    let bench = Bench::new();
    bench.scene("01_plain_ring", &[]);
    let run = start(&bench, &["converge", "scene.toml", "--out", "out", "--max-seconds", "600"]);
    until_it_listens(&run);
    std::thread::sleep(Duration::from_millis(500));
    send("-INT", &run);
    let (output, stderr) = ended(run);
    assert_eq!(output.status.code(), Some(0), "{stderr}");
    let report = std::fs::read_to_string(bench.path().join("out/converge.json")).expect("a report");
    let report = object(&report);
    let courses = report["strategies"].as_array().expect("strategies");
    let levels = |course: &Value| course["levels"].as_array().map_or(0, Vec::len);
    assert!(courses.iter().map(levels).sum::<usize>() > 0, "{report}");
    for course in courses {
        let why = course["ended"].as_str().expect("a reason");
        assert!(why.contains("interrupted"), "{why}");
    }
}

#[test]
fn the_second_time_ends_at_once() {
    let bench = Bench::new();
    sweep(&bench, 30);
    let run = start(&bench, &["sweep", "scene.toml", "--out", "out"]);
    until(|| rows(&bench.path().join("out")).len() > 3);
    send("-STOP", &run);
    send("-INT", &run);
    send("-CONT", &run);
    send("-TERM", &run);
    let (output, stderr) = ended(run);
    assert_eq!(output.status.code(), Some(130), "{stderr}");
}
