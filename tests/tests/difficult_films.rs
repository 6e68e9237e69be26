//! Films that exist and are hard to reach: near a fold, at the edge of an arc, with hardly any pressure.

use std::path::Path;

use oilwedge_study::quantities::{ECCENTRICITY, LOAD, LOAD_COEFFICIENT};
use oilwedge_study::result::{RunResult, Status};
use oilwedge_study::{RunOptions, parse, run};
use oilwedge_tests::program::repository;

fn result(text: &str, folder: &Path, options: &RunOptions) -> RunResult {
    let scene = parse(text, &folder.join("scene.toml")).unwrap_or_else(|error| panic!("{error}"));
    run(&scene, options).expect("a film").result
}

/// Pressures of the as-printed equation may exceed 1/alpha: its fold lies at 36.72 rad/s, and the pressure reaches
/// 1/alpha at 35.5.
#[test]
fn an_as_printed_film_has_bars_up_to_its_fold() {
    let folder = repository().join("scenes");
    let text = std::fs::read_to_string(folder.join("06_flexpde_as_printed.toml")).expect("scene 06");
    let speed = text.lines().find(|line| line.starts_with("speed")).expect("a speed").to_owned();
    let at = |speed_of: &str| text.replace(&speed, &format!("speed = \"{speed_of}\""));
    for (speed, known) in [("36 rad/s", Some(144.42)), ("36.6 rad/s", None)] {
        let film = result(&at(speed), &folder, &RunOptions::default());
        assert_eq!(film.head.status, Status::Converged, "{speed}: {:?}", film.head.reason);
        let quantity = film.quantity(&LOAD_COEFFICIENT).expect("C_w");
        let bar = quantity.error().expect("a bar");
        assert!(bar < 1e-3 * quantity.value, "{speed}: {} +- {bar}", quantity.value);
        // The quadratic film of the same mesh, by itself.
        assert!(known.is_none_or(|known| (quantity.value - known).abs() < 0.01), "{}", quantity.value);
    }
    let beyond = result(&at("37 rad/s"), &folder, &RunOptions::default());
    assert!(beyond.head.status != Status::Converged);
}

fn pad(arc: &str, journal: &str, rest: &str) -> String {
    format!(
        r#"
bearing = {{ diameter = "80 mm", length = "50 mm", clearance = "40 um", arc = {arc} }}
journal = {{ {journal} }}
oil = {{ viscosity = "20 mPa.s" }}
cavitation = {{ model = "reynolds" }}
{rest}
"#
    )
}

/// Near the edge of an arc the force turns sharply with the position; a scan of positions shows one near eps = 0.88.
#[test]
fn a_load_towards_the_edge_of_an_arc_is_carried() {
    let arc = "{ from = \"200 deg\", to = \"340 deg\" }";
    let load = "load = { force = \"1990 N\", angle = \"205.9 deg\" }";
    let found = result(&pad(arc, "speed = \"3000 rpm\"", load), Path::new("."), &RunOptions::default());
    assert_eq!(found.head.status, Status::Converged, "{:?}", found.head.reason);
    let eps = found.quantity(&ECCENTRICITY).expect("eps").value;
    assert!((eps - 0.884).abs() < 0.01, "{eps}");
    let fine = format!("{load}\nmesh = {{ size = \"2 mm\" }}");
    let fine = result(&pad(arc, "speed = \"3000 rpm\"", &fine), Path::new("."), &RunOptions::default());
    let finer = fine.quantity(&ECCENTRICITY).expect("eps");
    let bar = found.quantity(&ECCENTRICITY).and_then(|it| it.error()).expect("a bar");
    assert!((finer.value - eps).abs() < bar + finer.error().expect("a bar"), "{eps} +- {bar}, {}", finer.value);
}

/// A pad opposite to the thinnest film has pressure in a sliver at its edge only.
#[test]
fn a_pad_without_load_ends_on_few_triangles() {
    let arc = "{ from = \"10 deg\", to = \"170 deg\" }";
    let journal = "speed = \"3000 rpm\", eccentricity = 0.6, min_film_angle = \"340 deg\"";
    let film = result(&pad(arc, journal, ""), Path::new("."), &RunOptions::default());
    assert_eq!(film.head.status, Status::Converged, "{:?}", film.head.reason);
    assert!(film.mesh.cells < 5_000, "{} triangles", film.mesh.cells);
    assert!(film.quantity(&LOAD).is_some_and(|load| load.value < 10.0));
}
