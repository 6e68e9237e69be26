//! The results of a scene are bit-identical on every run and on any number of threads. Shipped scenes:
//! `cli/shipped.rs`; sweeps: `cli/sweep/`.

use oilwedge_tests::bench::{Bench, edited, lines_without_times, object};

/// What a run of `scene.toml` on so many threads gives: the numbers, and the picture.
fn bits(bench: &Bench, threads: &str) -> (String, Vec<u8>) {
    let told = bench.run(&["solve", "scene.toml", "--out", "out", "--threads", threads]);
    assert_eq!(told.status, 0, "{threads} threads: {}", told.stderr);
    let text = std::fs::read_to_string(bench.path().join("out/result.json")).expect("a result");
    let picture = std::fs::read(bench.path().join("out/film.vtu")).expect("a picture");
    (text, picture)
}

/// A film of more than 150 000 unknowns takes multigrid and every parallel path.
#[test]
fn a_large_film_on_one_thread_and_on_three() {
    let bench = Bench::new();
    bench.write("scene.toml", edited("09_drawn_ring", &[]) + "\n[mesh]\nsize = \"0.55 mm\"\n");
    let [alone, together] = ["1", "3"].map(|threads| bits(&bench, threads));
    assert_eq!(lines_without_times(&alone.0), lines_without_times(&together.0));
    assert!(alone.1 == together.1, "another picture");
    let result = object(&alone.0);
    assert!(result["mesh"]["nodes"].as_u64().is_some_and(|nodes| nodes > 155_000), "{}", result["mesh"]);
    assert_eq!(result["linear_solver"]["route"], "multigrid");
}
