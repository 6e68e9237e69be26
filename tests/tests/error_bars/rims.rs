//! What round rims are off, and what a mesh that does not resolve a film is told.

use std::sync::Arc;

use oilwedge_report::write_mesh;
use oilwedge_reynolds::FilmSystem;
use oilwedge_reynolds::error_bar::Value;
use oilwedge_reynolds::supply::{BoundaryKind, Disc};
use oilwedge_study::RunOptions;
use oilwedge_study::compile::compile;
use oilwedge_tests::scenes::{table, variant};
use oilwedge_tests::{SPEED, plain_film, ring, ring_system};

use super::films::{Judged, answer, constant, drawn, set};

/// The hole of scene 04 [m].
const HOLE: Disc = Disc { centre: [0.0375 * 130.0 * std::f64::consts::PI / 180.0, 0.0], radius: 0.0085 };

/// The film of scene 04 with constant oil on its mesh of straight triangles: a rim of chords about a hole known to be
/// round.
fn chords() -> Judged {
    let scene = variant("04_flexpde_ring", |scene| {
        set(scene, "mesh", "file", "../meshes/flexpde_ring_straight.msh");
        let feeds = scene["feed"].as_array_mut().expect("feeds");
        feeds[0].as_table_mut().expect("a feed").remove("hole");
        constant(scene);
    });
    let study = compile(&scene).and_then(|model| model.film()).unwrap_or_else(|error| panic!("{error}"));
    let mesh = study.system.space().mesh();
    let feed = mesh.region("feed_hole").expect("the hole");
    assert!(feed.edges.iter().all(|&edge| mesh.bulge(edge) == [0.0; 2]));
    let regions = study.system.supply.regions().iter().cloned();
    let regions = regions.map(|mut region| {
        region.disc = (region.kind == BoundaryKind::Feed).then_some(HOLE);
        region
    });
    let system = Arc::new(FilmSystem::new(mesh.clone(), 2, regions.collect()).expect("the same system"));
    Judged::of(study.problem, &system)
}

#[test]
fn a_straight_rim_raises_the_geometry_part() {
    let straight = chords();
    let exact = Judged::of_scene(&drawn("04_flexpde_ring", 2.5, constant)).cubic_load().total;
    let found = straight.cubic_load().total;
    let wanted = [exact.force[0] - found.force[0], exact.force[1] - found.force[1], exact.pressure - found.pressure];
    let size = wanted[0].hypot(wanted[1]);
    for (goal, wanted) in straight.error.goals[..2].iter().zip(wanted) {
        assert!((goal.geometry - wanted).abs() < 0.1 * size, "{:e} {wanted:e}", goal.geometry);
    }
    // With the key `hole` the same triangles have a round rim.
    let round = Judged::of_scene(&variant("04_flexpde_ring", |scene| {
        set(scene, "mesh", "file", "../meshes/flexpde_ring_straight.msh");
        constant(scene);
    }));
    let [chords, round] = [&straight, &round].map(|judged| judged.error.load(Value::Cubic).geometry);
    assert!(round < 1e-3 * chords, "{round:e} {chords:e}");
    let bar = straight.error.load(Value::Cubic).total();
    assert!(bar >= chords && chords > 1e-5 * straight.cubic_load().magnitude());
}

/// Few triangles where the film is thin: no number of it is worth a bar.
#[test]
fn a_mesh_that_does_not_resolve_the_film_is_refused_a_bar() {
    let judged = Judged::of(plain_film(0.05, 0.99, 0.3, SPEED), &ring_system(18, 4, 0.05, None));
    assert!((200..260).contains(&judged.unknowns()), "{}", judged.unknowns());
    assert!(!judged.error.is_resolved());
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("coarse.msh");
    write_mesh(&ring(18, 4, 0.05, 0.0), &file).expect("a mesh file");
    let result = answer(
        &variant("01_plain_ring", |scene| {
            let bearing = table(scene, "bearing");
            for (key, value) in [("diameter", "100 mm"), ("length", "50 mm"), ("clearance", "50 um")] {
                bearing.insert(key.into(), value.into());
            }
            set(scene, "mesh", "file", file.display().to_string());
            set(scene, "journal", "eccentricity", 0.99);
        }),
        &RunOptions::default(),
    );
    assert!(result.bars);
    for quantity in &result.quantities {
        let given = ["eccentricity", "min_film_angle", "film_thickness_min", "film_thickness_min_angle"];
        let given = given.contains(&&*quantity.name);
        assert_eq!(quantity.error(), given.then_some(0.0), "{}", quantity.name);
    }
}
