//! Shipped scenes as they are: the same bits on one thread and on three, and the orbit with a wall against finite
//! volumes.

use oilwedge_tests::bench::{Bench, lines_without_times, object};
use oilwedge_tests::program::repository;

use crate::liner::orbit::the_big_end_with_a_wall_is_that_of_finite_volumes;

/// Films, searches, tangents, contact and orbits, each where it is met first.
const SCENES: [&str; 8] = [
    "06_flexpde_as_printed",
    "10_drawn_liner",
    "17_engine_main_bearing",
    "24_load_off_the_middle",
    "27_big_end_orbit",
    "29_mixed_lubrication",
    "31_worn_bore",
    "35_squeeze_film_damper",
];

#[test]
fn bits_do_not_depend_on_threads() {
    let bench = Bench::new();
    for name in SCENES {
        let scene = repository().join(format!("scenes/{name}.toml")).display().to_string();
        let solved = |threads: &str| {
            let told = bench.run(&["solve", &scene, "--json", "--threads", threads]);
            assert_eq!(told.status, 0, "{name}: {}", told.stderr);
            let picture = std::fs::read(bench.path().join(format!("out/{name}/film.vtu"))).expect("a picture");
            (told.stdout, picture)
        };
        let [(alone, drawn), (together, again)] = ["1", "3"].map(solved);
        assert_eq!(lines_without_times(&alone), lines_without_times(&together), "{name}");
        assert!(drawn == again, "{name}: another picture");
    }
}

#[test]
fn the_orbit_with_a_wall_is_that_of_finite_volumes() {
    let scene = repository().join("scenes/34_elastic_big_end_orbit.toml").display().to_string();
    let told = Bench::new().run(&["solve", &scene, "--json"]);
    assert_eq!(told.status, 0, "{}", told.stderr);
    the_big_end_with_a_wall_is_that_of_finite_volumes(&object(&told.stdout));
}
