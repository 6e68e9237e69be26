//! Shafts over a cycle of their throws.

use oilwedge_study::quantities::*;
use oilwedge_study::result::Status;
use oilwedge_tests::crankshafts::*;

#[test]
fn a_shaft_cut_at_its_mains_has_the_orbits_of_single_bearings() {
    // The same steps, coarse ones, lead to the same orbits of films on the same meshes.
    let folder = tempfile::tempdir().expect("a folder");
    let coarse = ("[journal]", "[mesh]\nsize = \"9 mm\"\n\n[journal]");
    let engine = with_bearing(folder.path(), "main_85", coarse, &text("three_throws.toml"));
    let engine = changed(&engine, "tolerance = 1e-3", "tolerance = 1e-2");
    let run = run(&three_throws_cut(&engine));
    assert_eq!(run.result.status, Status::Converged, "{:?}", run.result.reason);
    let films = numbers(&run, &CYCLE_FILM_THICKNESS_MIN);
    let bearing = changed(&text("bearings/main_85.toml"), coarse.0, coarse.1);
    for (number, throws) in BESIDE.iter().enumerate() {
        let film = single_main(&engine, throws, &bearing);
        assert!(
            (films[number] / film - 1.0).abs() < 1e-6,
            "{number}: {} {film}",
            films[number]
        );
    }
}

#[test]
fn all_films_of_an_engine_balance_its_loads_at_every_step() {
    let folder = tempfile::tempdir().expect("a folder");
    let coarse = ("[journal]", "[mesh]\nsize = \"9 mm\"\n\n[journal]");
    let scene = with_bearing(folder.path(), "main_85", coarse, &text("three_throws.toml"));
    let run = run(&changed(&scene, "tolerance = 1e-3", "tolerance = 1e-2"));
    assert_eq!(run.result.status, Status::Converged, "{:?}", run.result.reason);
    let balances = run.result.balances;
    assert!(
        [balances.force, balances.moment, balances.journals, balances.power]
            .iter()
            .all(|off| *off < 1e-8),
        "{balances:?}"
    );
    assert!(balances.power > 0.0, "its terms come by two ways");
    for bearing in &run.result.bearings {
        // Of the order of what steps may be off by.
        assert!(
            bearing.energy.is_some_and(|energy| energy < 1e-2),
            "{}: {:?}",
            bearing.name,
            bearing.energy
        );
    }
    // Films and cavities mirror each other in no throw: the outer bearings bear one throw each, the inner ones two.
    let loads = numbers(&run, &CYCLE_LOAD_MAX);
    assert!(
        loads[1] > 0.8 * loads[0] && loads.iter().all(|load| *load > 1e4),
        "{loads:?}"
    );
}
