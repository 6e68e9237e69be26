//! Two runs in one folder: results belong together, and a sweep is written by one run only.

use oilwedge_tests::bench::Bench;
use oilwedge_tests::two_scenes::{TWO, names, pair, rows, send, start, sweep, two_scenes, until, whole_pairs};

const ROUNDS: usize = 20;
const SWEEP: [&str; 6] = ["sweep", "scene.toml", "--out", "out", "--threads", "1"];

#[test]
fn solves_in_one_folder_leave_one_whole_result() {
    let bench = Bench::new();
    two_scenes(&bench);
    let whole = whole_pairs(&bench);
    let folder = bench.path().join("out");
    for _ in 0..ROUNDS {
        let runs = TWO.map(|scene| start(&bench, &["solve", scene, "--out", "out"]));
        for run in runs {
            let output = run.wait_with_output().expect("it ends");
            assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        }
        let (scene, picture) = pair(&folder).expect("a result");
        assert!(whole.get(&scene) == Some(&picture), "the picture of the other run");
        assert_eq!(names(&folder), ["film.vtu", "result.json"]);
    }
}

/// Starts a sweep in `out`, waits for its first rows and halts it.
fn begun(bench: &Bench) -> std::process::Child {
    let run = start(bench, &SWEEP);
    until(|| rows(&bench.path().join("out")).len() > 1);
    send("-STOP", &run);
    run
}

#[test]
fn a_sweep_that_is_being_written_is_refused_to_others() {
    let bench = Bench::new();
    sweep(&bench, 30);
    let mut first = begun(&bench);
    let process = format!("process {}", first.id());
    for fresh in [&[][..], &["--fresh"]] {
        let told = bench.run(&[&SWEEP, fresh].concat());
        assert_eq!((told.status, told.stdout.as_str()), (2, ""), "{}", told.stderr);
        for word in [&process, "still writing", "--out"] {
            assert!(told.stderr.contains(word), "no {word:?} in\n{}", told.stderr);
        }
    }
    // Other results may go into the same folder.
    bench.write("alone.toml", oilwedge_tests::bench::edited("01_plain_ring", &[]));
    assert_eq!(bench.run(&["solve", "alone.toml", "--out", "out"]).status, 0);
    // The lock of a killed run is none.
    first.kill().expect("it can be killed");
    first.wait().expect("it ends");
    let before = rows(&bench.path().join("out")).len();
    assert!(before < 60, "the sweep ended before it was killed");
    let told = bench.run(&SWEEP);
    assert_eq!(told.status, 0, "{}", told.stderr);
    assert!(told.stdout.contains("cases of an earlier run"), "{}", told.stdout);
    assert_eq!(rows(&bench.path().join("out")).len(), 60);
    assert_eq!(names(&bench.path().join("out")), ["film.vtu", "result.json", "sweep.csv", "sweep.json"]);
}

#[test]
fn of_sweeps_started_at_once_one_runs() {
    let bench = Bench::new();
    sweep(&bench, 10);
    for round in 0..5 {
        let folder = format!("out{round}");
        let runs = [0, 1].map(|_| start(&bench, &["sweep", "scene.toml", "--bars", "none", "--out", &folder]));
        let status = runs.map(|run| run.wait_with_output().expect("it ends").status.code());
        // One after the other both may find it done.
        assert!(status.contains(&Some(0)), "{status:?}");
        assert!(status.iter().all(|status| matches!(status, Some(0 | 2))), "{status:?}");
        assert_eq!(rows(&bench.path().join(&folder)).len(), 20);
        assert_eq!(names(&bench.path().join(&folder)), ["sweep.csv", "sweep.json"]);
    }
}
