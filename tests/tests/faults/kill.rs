//! `kill -9` at random moments, two hundred times in all: over the whole run, and in the moments of writing.

use std::path::Path;
use std::process::Child;
use std::time::{Duration, Instant};

use crate::bench::{Bench, object};
use crate::scenes::{TWO, left_over, names, pair, rows, start, sweep, two_scenes, whole_pairs};
use oilwedge_tests::random_bearings::Dice;

/// Kills of each kind of run; they are 200 together.
const SOLVES: usize = 90;
const SWEEPS: usize = 50;
const MESHES: usize = 40;
const STUDIES: usize = 20;
const SEED: u64 = 20_260_722;

/// Kills a run: every other time at a moment of the whole run, which takes `length` seconds, else soon after it began to write.
/// Tells whether it was still running.
fn kill(mut run: Child, folder: &Path, length: f64, dice: &mut Dice) -> bool {
    let clock = Instant::now();
    if dice.chance(0.5) {
        std::thread::sleep(Duration::from_secs_f64(dice.between(0.0, 1.1 * length)));
    } else {
        let before = left_over(folder);
        let mut files = names(folder);
        while clock.elapsed().as_secs_f64() < 3.0 * length {
            let now = names(folder);
            // A new folder beside, or what an earlier run left is taken away.
            if left_over(folder) != before || now != files {
                break;
            }
            files = now;
        }
        std::thread::sleep(Duration::from_secs_f64(dice.between(0.0, 2e-3)));
    }
    run.kill().expect("it can be killed, or has ended");
    let status = run.wait().expect("it ends");
    status.code().is_none()
}

/// Seconds of a run that is left alone.
fn length(bench: &Bench, arguments: &[&str]) -> f64 {
    let clock = Instant::now();
    let told = bench.run(arguments);
    assert_eq!(told.status, 0, "{}", told.stderr);
    clock.elapsed().as_secs_f64()
}

fn told(kind: &str, kills: usize, alive: usize, writing: usize) {
    println!("{kind}: {kills} kills (seed {SEED}), {alive} before the end, {writing} while it wrote");
    assert!(alive > kills / 4, "only {alive} runs of {kind} were killed");
    assert!(writing > 0, "no run of {kind} was killed while it wrote");
}

#[test]
fn a_killed_solve_leaves_a_whole_result_or_none() {
    let bench = Bench::new();
    two_scenes(&bench);
    let whole = whole_pairs(&bench);
    let folder = bench.path().join("out");
    let length = length(&bench, &["solve", TWO[0], "--out", "out"]);
    let mut dice = Dice::new(SEED);
    let (mut alive, mut writing) = (0, 0);
    for kill_number in 0..SOLVES {
        let run = start(&bench, &["solve", TWO[kill_number % 2], "--out", "out"]);
        alive += usize::from(kill(run, &folder, length, &mut dice));
        writing += usize::from(left_over(&folder) > 0);
        if let Some((scene, picture)) = pair(&folder) {
            assert!(
                whole.get(&scene) == Some(&picture),
                "kill {kill_number}: the picture of another run"
            );
        }
        assert!(left_over(&folder) <= 1, "kill {kill_number}: {:?}", names(&folder));
    }
    told("solve", SOLVES, alive, writing);
    assert_eq!(bench.run(&["solve", TWO[0], "--out", "out"]).status, 0);
    assert_eq!(names(&folder), ["film.vtu", "result.json"]);
}

#[test]
fn a_killed_sweep_loses_no_row() {
    let bench = Bench::new();
    sweep(&bench, 16);
    let folder = bench.path().join("out");
    let command = ["sweep", "scene.toml", "--bars", "none", "--out"];
    let arguments = |folder| [&command[..], &[folder]].concat();
    let length = length(&bench, &arguments("whole"));
    let whole = rows(&bench.path().join("whole"));
    assert_eq!(whole.len(), 32);
    let mut dice = Dice::new(SEED + 1);
    let (mut alive, mut writing, mut ended) = (0, 0, 0);
    let mut before = rows(&folder);
    for kill_number in 0..SWEEPS {
        let run = start(&bench, &arguments("out"));
        // A third of the run, so that several kills fall on one sweep.
        alive += usize::from(kill(run, &folder, length / 3.0, &mut dice));
        writing += usize::from(left_over(&folder) > 0);
        let now = rows(&folder);
        for (case, row) in &now {
            assert_eq!(whole.get(case), Some(row), "kill {kill_number}: another row");
        }
        let lost: Vec<_> = before.keys().filter(|case| !now.contains_key(case)).collect();
        assert!(lost.is_empty(), "kill {kill_number}: rows {lost:?} were lost");
        assert!(left_over(&folder) <= 1, "kill {kill_number}: {:?}", names(&folder));
        before = now;
        if before.len() == whole.len() {
            let told = bench.run(&arguments("out"));
            assert_eq!(told.status, 0, "{}", told.stderr);
            assert_eq!(rows(&folder), whole);
            assert_eq!(names(&folder), ["sweep.csv", "sweep.json"]);
            std::fs::remove_dir_all(&folder).expect("a folder");
            before.clear();
            ended += 1;
        }
    }
    told("sweep", SWEEPS, alive, writing);
    assert!(ended > 0, "no sweep came to its end");
    let told = bench.run(&arguments("out"));
    assert_eq!((told.status, rows(&folder)), (0, whole), "{}", told.stderr);
}

#[test]
fn a_killed_mesher_leaves_a_whole_mesh_or_none() {
    let bench = Bench::new();
    let sized = |size: &str| crate::bench::edited("09_drawn_ring", &[]) + &format!("\n[mesh]\nsize = \"{size}\"\n");
    bench.write(TWO[0], sized("3 mm"));
    bench.write(TWO[1], sized("4 mm"));
    let folder = bench.path().join("out");
    std::fs::create_dir(&folder).expect("a folder");
    let arguments = |scene| ["mesh", scene, "-o", "out/liner.msh"];
    let read = || std::fs::read(folder.join("liner.msh")).ok();
    let whole = TWO.map(|scene| {
        length(&bench, &arguments(scene));
        read().expect("a mesh")
    });
    assert!(whole[0] != whole[1]);
    let length = length(&bench, &arguments(TWO[1]));
    let mut dice = Dice::new(SEED + 2);
    let (mut alive, mut writing) = (0, 0);
    for kill_number in 0..MESHES {
        let run = start(&bench, &arguments(TWO[kill_number % 2]));
        alive += usize::from(kill(run, &folder, length, &mut dice));
        writing += usize::from(left_over(&folder) > 0);
        assert!(read().is_some_and(|mesh| whole.contains(&mesh)), "kill {kill_number}");
        assert!(left_over(&folder) <= 1, "kill {kill_number}: {:?}", names(&folder));
    }
    told("mesh", MESHES, alive, writing);
    assert_eq!(bench.run(&arguments(TWO[0])).status, 0);
    assert_eq!(names(&folder), ["liner.msh"]);
}

#[test]
fn a_killed_study_leaves_files_of_one_study_or_no_report() {
    let bench = Bench::new();
    two_scenes(&bench);
    let folder = bench.path().join("out");
    let arguments = ["converge", TWO[0], "--max-seconds", "0.2", "--out", "out"];
    let length = length(&bench, &arguments);
    let mut dice = Dice::new(SEED + 3);
    let (mut alive, mut writing) = (0, 0);
    for kill_number in 0..STUDIES {
        alive += usize::from(kill(start(&bench, &arguments), &folder, length, &mut dice));
        writing += usize::from(left_over(&folder) > 0);
        assert!(left_over(&folder) <= 1, "kill {kill_number}: {:?}", names(&folder));
        if let Ok(report) = std::fs::read_to_string(folder.join("converge.json")) {
            is_of_one_study(&report, &folder);
        }
    }
    told("converge", STUDIES, alive, writing);
    bench.run(&arguments);
    assert_eq!(
        names(&folder),
        ["converge.csv", "converge.json", "converge.png", "converge.svg"]
    );
}

/// The times of a study are those of no other.
fn is_of_one_study(report: &str, folder: &Path) {
    let read = |name: &str| std::fs::read(folder.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"));
    let table = String::from_utf8(read("converge.csv")).expect("a table");
    let mut lines = table.lines();
    let headings = lines.next().expect("headings").split(',');
    let place = headings
        .into_iter()
        .position(|heading| heading == "total_s")
        .expect("total_s");
    let in_table: Vec<f64> = lines
        .map(|line| {
            line.split(',')
                .nth(place)
                .and_then(|cell| cell.parse().ok())
                .expect("seconds")
        })
        .collect();
    let report = object(report);
    let strategies = report["strategies"].as_array().expect("strategies").iter();
    let levels = strategies.flat_map(|course| course["levels"].as_array().expect("levels"));
    let in_report: Vec<f64> = levels
        .map(|level| level["seconds"]["total"].as_f64().expect("seconds"))
        .collect();
    assert_eq!(in_table.len(), in_report.len());
    for (a, b) in in_table.iter().zip(&in_report) {
        assert!((a / b - 1.0).abs() < 1e-6, "{a} {b}");
    }
    assert!(
        String::from_utf8(read("converge.svg"))
            .expect("a drawing")
            .trim_end()
            .ends_with("</svg>")
    );
    assert!(read("converge.png").ends_with(b"IEND\xae\x42\x60\x82"));
}
