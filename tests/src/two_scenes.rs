//! Small scenes, and what whole results of them look like.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use crate::bench::{Bench, edited, object};
use crate::program::oilwedge_command;

/// Two scenes whose results differ.
pub const TWO: [&str; 2] = ["slow.toml", "fast.toml"];

/// Writes [`TWO`]: one bearing at two speeds.
pub fn two_scenes(bench: &Bench) {
    for (name, speed) in TWO.into_iter().zip(["10 rad/s", "20 rad/s"]) {
        bench.write(name, edited("01_plain_ring", &[("10 rad/s", speed)]));
    }
}

/// Writes `scene.toml`: a sweep with a tail of `count` eccentricities at two speeds.
pub fn sweep(bench: &Bench, count: usize) {
    let axes =
        format!("speed = [\"8 rad/s\", \"10 rad/s\"]\neccentricity = {{ from = 0.1, to = 0.8, steps = {count} }}");
    bench.write("scene.toml", edited("08_flexpde_study_size", &[]) + "\n[sweep]\n" + &axes + "\n");
}

/// Starts the program; it tells nothing.
pub fn start(bench: &Bench, arguments: &[&str]) -> Child {
    oilwedge_command()
        .args(arguments)
        .current_dir(bench.path())
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts")
}

/// Picture and scene of a whole result; none where there is no `result.json`.
pub fn pair(folder: &Path) -> Option<(String, Vec<u8>)> {
    let text = std::fs::read_to_string(folder.join("result.json")).ok()?;
    let result = object(&text);
    assert_eq!(result["status"], "converged");
    let scene = result["scene_sha256"].as_str().expect("a sum").to_owned();
    let picture = std::fs::read(folder.join("film.vtu")).expect("a picture beside its result");
    Some((scene, picture))
}

/// The pictures of both scenes by the sums of their scenes.
pub fn whole_pairs(bench: &Bench) -> BTreeMap<String, Vec<u8>> {
    let solved = TWO.map(|scene| {
        let told = bench.run(&["solve", scene, "--out", "whole"]);
        assert_eq!(told.status, 0, "{}", told.stderr);
        pair(&bench.path().join("whole")).expect("a result")
    });
    let pairs = BTreeMap::from(solved);
    assert_eq!(pairs.len(), 2);
    pairs
}

/// Names of what stands in a folder, sorted; nothing where it is none.
pub fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).into_iter().flatten();
    let mut names: Vec<String> =
        entries.map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

/// What killed runs leave in a folder.
pub fn left_over(folder: &Path) -> Vec<String> {
    let mut left = names(folder);
    left.retain(|name| name.starts_with(".oilwedge-"));
    left
}

/// Sends a signal to a run.
pub fn send(signal: &str, run: &Child) {
    let sent = Command::new("kill").args([signal, &run.id().to_string()]).status();
    assert!(sent.is_ok_and(|status| status.success()));
}

/// Waits until it is so; a run that never comes to it is given up.
pub fn until(is_so: impl Fn() -> bool) {
    let clock = Instant::now();
    while !is_so() {
        assert!(clock.elapsed() < Duration::from_secs(300), "it does not come to that");
        std::thread::sleep(Duration::from_millis(1));
    }
}

/// The whole rows of a table by their case, without their seconds.
pub fn rows(folder: &Path) -> BTreeMap<usize, String> {
    let text = std::fs::read_to_string(folder.join("sweep.csv")).unwrap_or_default();
    let whole = text.rfind('\n').map_or("", |end| &text[..end]);
    let row = |line: &str| {
        let (row, _) = line.rsplit_once(',').expect("columns");
        let (case, _) = row.split_once(',').expect("columns");
        (case.parse().expect("a case"), row.to_owned())
    };
    whole.lines().skip(1).map(row).collect()
}
