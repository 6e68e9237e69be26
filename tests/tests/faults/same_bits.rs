//! The results of a scene are bit-identical on every run and on any number of threads. Shipped scenes: `cli/shipped.rs`; sweeps: `cli/sweep/`.

use oilwedge_tests::bench::{Bench, edited, object};
use oilwedge_tests::program::repository;

/// The lines of a `result.json` but for its times: `timing_s`, and `seconds` of levels.
pub(crate) fn timeless(text: &str) -> Vec<&str> {
    let mut in_times = false;
    let lines = text.lines().filter(|line| {
        let line = line.trim_start();
        let is_time = in_times || line.starts_with("\"timing_s\"") || line.starts_with("\"seconds\"");
        in_times = (in_times || line.starts_with("\"timing_s\"")) && !line.starts_with('}');
        !is_time
    });
    lines.collect()
}

/// What a run of `scene` gives: the numbers, and the picture.
fn bits(bench: &Bench, scene: &str, threads: &str, more: &[&str]) -> (String, Vec<u8>) {
    let told = bench.run(&[&["solve", scene, "--out", "out", "--threads", threads], more].concat());
    assert_eq!(told.status, 0, "{scene}: {}", told.stderr);
    let text = std::fs::read_to_string(bench.path().join("out/result.json")).expect("a result");
    let picture = std::fs::read(bench.path().join("out/film.vtu")).expect("a picture");
    (text, picture)
}

fn all_the_same(bench: &Bench, scene: &str, runs: &[&str], more: &[&str]) {
    let [first, others @ ..] = runs else { return };
    let reference = bits(bench, scene, first, more);
    for threads in others {
        let (result, picture) = bits(bench, scene, threads, more);
        assert_eq!(
            timeless(&result),
            timeless(&reference.0),
            "{scene} on {threads} threads"
        );
        assert!(picture == reference.1, "{scene} on {threads} threads: another picture");
    }
}

/// Bars of an orbit with a history take as long again as the orbit, by the same code, and so does its fine mesh.
#[test]
fn an_orbit_with_a_history_on_one_thread_and_on_two() {
    let bench = Bench::new();
    let text = std::fs::read_to_string(repository().join("scenes/28_big_end_orbit_conserving.toml")).expect("a scene");
    let loads = repository().join("scenes/loads").display().to_string();
    bench.write(
        "scene.toml",
        text.replace("12 mm", "40 mm")
            .replace("\"loads/", &format!("\"{loads}/")),
    );
    all_the_same(&bench, "scene.toml", &["1", "2"], &["--bars", "none"]);
}

/// More than 150 000 unknowns: multigrid, and every parallel path.
#[test]
fn a_large_film_on_one_two_and_three_threads() {
    let bench = Bench::new();
    let sized = |scene: &str, size: &str| edited(scene, &[]) + &format!("\n[mesh]\nsize = \"{size}\"\n");
    bench.write("scene.toml", sized("09_drawn_ring", "0.55 mm"));
    all_the_same(&bench, "scene.toml", &["2", "1", "3"], &[]);
    let (result, _) = bits(&bench, "scene.toml", "2", &["--bars", "none"]);
    let result = object(&result);
    assert!(
        result["mesh"]["nodes"].as_u64().is_some_and(|nodes| nodes > 155_000),
        "{}",
        result["mesh"]
    );
    assert_eq!(result["linear_solver"]["route"], "multigrid");
}
