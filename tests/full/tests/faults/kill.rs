//! `kill -9` at random moments, a hundred times in all: over the whole run, and in the moments of writing.

use std::path::Path;
use std::process::Child;
use std::time::{Duration, Instant};

use oilwedge_tests::bench::{Bench, object};
use oilwedge_tests::random_bearings::Dice;
use oilwedge_tests::two_scenes::{TWO, left_over, names, pair, rows, start, sweep, two_scenes, whole_pairs};

/// Kills of each kind of run; they are 100 together.
const SOLVES: usize = 45;
const SWEEPS: usize = 25;
const MESHES: usize = 20;
const STUDIES: usize = 10;
const SEED: u64 = 20_260_722;

/// Kills of one kind of run, which write into one folder.
struct Kills<'a> {
    kind: &'static str,
    folder: &'a Path,
    /// Seconds over which the moments are spread.
    length: f64,
    dice: Dice,
    wanted: usize,
    /// Runs started.
    started: usize,
    /// Runs that were killed before they ended.
    killed: usize,
    /// Number of kills at which the program was writing.
    writing: usize,
    /// What killed runs have left.
    left: Vec<String>,
}

impl<'a> Kills<'a> {
    fn of(kind: &'static str, folder: &'a Path, wanted: usize, length: f64, seed: u64) -> Self {
        Self {
            kind,
            folder,
            length,
            dice: Dice::new(seed),
            wanted,
            started: 0,
            killed: 0,
            writing: 0,
            left: left_over(folder),
        }
    }

    /// Whether there are not yet as many as wanted. A run that ended before it was killed counts for none: how many of
    /// them there are depends on what else the machine does.
    fn goes_on(&self) -> bool {
        let goes_on = self.killed < self.wanted || self.writing == 0;
        assert!(
            !goes_on || self.started < 20 * self.wanted,
            "of {} runs of {} {} were killed",
            self.started,
            self.kind,
            self.killed
        );
        if !goes_on {
            println!(
                "{}: {} kills of {} runs, {} while they wrote",
                self.kind, self.killed, self.started, self.writing
            );
        }
        goes_on
    }

    /// Kills a run: every other one at a moment of its whole course, the others soon after they began to write.
    fn kill(&mut self, mut run: Child) {
        self.started += 1;
        if self.dice.chance(0.5) {
            std::thread::sleep(Duration::from_secs_f64(self.dice.between(0.0, self.length)));
        } else {
            let before = names(self.folder);
            while names(self.folder) == before && run.try_wait().expect("a status").is_none() {}
            std::thread::sleep(Duration::from_secs_f64(self.dice.between(0.0, 2e-3)));
        }
        run.kill().expect("it can be killed, or has ended");
        let status = run.wait().expect("it ends");
        let left = left_over(self.folder);
        if status.code().is_none() {
            self.killed += 1;
            self.writing += usize::from(!left.is_empty() && left != self.left);
        }
        assert!(left.len() <= 1, "run {}: {left:?}", self.started);
        self.left = left;
    }
}

/// Seconds of a run that is left alone.
fn length(bench: &Bench, arguments: &[&str]) -> f64 {
    // The program is built first.
    assert_eq!(bench.run(&["--version"]).status, 0);
    let clock = Instant::now();
    let told = bench.run(arguments);
    assert_eq!(told.status, 0, "{}", told.stderr);
    clock.elapsed().as_secs_f64()
}

#[test]
fn a_killed_solve_leaves_a_whole_result_or_none() {
    let bench = Bench::new();
    two_scenes(&bench);
    let whole = whole_pairs(&bench);
    let folder = bench.path().join("out");
    let length = length(&bench, &["solve", TWO[0], "--out", "out"]);
    let mut kills = Kills::of("solve", &folder, SOLVES, length, SEED);
    while kills.goes_on() {
        kills.kill(start(&bench, &["solve", TWO[kills.started % 2], "--out", "out"]));
        if let Some((scene, picture)) = pair(&folder) {
            assert!(whole.get(&scene) == Some(&picture), "run {}: the picture of another run", kills.started);
        }
    }
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
    // Several kills fall on one sweep.
    let mut kills = Kills::of("sweep", &folder, SWEEPS, length / 3.0, SEED + 1);
    let mut before = rows(&folder);
    while kills.goes_on() {
        kills.kill(start(&bench, &arguments("out")));
        let now = rows(&folder);
        for (case, row) in &now {
            assert_eq!(whole.get(case), Some(row), "run {}: another row", kills.started);
        }
        let lost: Vec<_> = before.keys().filter(|case| !now.contains_key(case)).collect();
        assert!(lost.is_empty(), "run {}: rows {lost:?} were lost", kills.started);
        before = now;
        if before.len() == whole.len() {
            let told = bench.run(&arguments("out"));
            assert_eq!(told.status, 0, "{}", told.stderr);
            assert_eq!(rows(&folder), whole);
            assert_eq!(names(&folder), ["sweep.csv", "sweep.json"]);
            std::fs::remove_dir_all(&folder).expect("a folder");
            before.clear();
            kills.left.clear();
        }
    }
    let told = bench.run(&arguments("out"));
    assert_eq!((told.status, rows(&folder)), (0, whole), "{}", told.stderr);
}

#[test]
fn a_killed_mesher_leaves_a_whole_mesh_or_none() {
    let bench = Bench::new();
    let sized =
        |size: &str| oilwedge_tests::bench::edited("09_drawn_ring", &[]) + &format!("\n[mesh]\nsize = \"{size}\"\n");
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
    let mut kills = Kills::of("mesh", &folder, MESHES, length, SEED + 2);
    while kills.goes_on() {
        kills.kill(start(&bench, &arguments(TWO[kills.started % 2])));
        assert!(read().is_some_and(|mesh| whole.contains(&mesh)), "run {}", kills.started);
    }
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
    let mut kills = Kills::of("converge", &folder, STUDIES, length, SEED + 3);
    while kills.goes_on() {
        kills.kill(start(&bench, &arguments));
        if let Ok(report) = std::fs::read_to_string(folder.join("converge.json")) {
            is_of_one_study(&report, &folder);
        }
    }
    bench.run(&arguments);
    assert_eq!(names(&folder), ["converge.csv", "converge.json", "converge.png", "converge.svg"]);
}

/// The times of a study are those of no other.
fn is_of_one_study(report: &str, folder: &Path) {
    let read = |name: &str| std::fs::read(folder.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"));
    let table = String::from_utf8(read("converge.csv")).expect("a table");
    let mut lines = table.lines();
    let headings = lines.next().expect("headings").split(',');
    let place = headings.into_iter().position(|heading| heading == "total_s").expect("total_s");
    let in_table: Vec<f64> =
        lines.map(|line| line.split(',').nth(place).and_then(|cell| cell.parse().ok()).expect("seconds")).collect();
    let report = object(report);
    let strategies = report["strategies"].as_array().expect("strategies").iter();
    let levels = strategies.flat_map(|course| course["levels"].as_array().expect("levels"));
    let in_report: Vec<f64> = levels.map(|level| level["seconds"]["total"].as_f64().expect("seconds")).collect();
    assert_eq!(in_table.len(), in_report.len());
    for (a, b) in in_table.iter().zip(&in_report) {
        assert!((a / b - 1.0).abs() < 1e-6, "{a} {b}");
    }
    assert!(String::from_utf8(read("converge.svg")).expect("a drawing").trim_end().ends_with("</svg>"));
    assert!(read("converge.png").ends_with(b"IEND\xae\x42\x60\x82"));
}
