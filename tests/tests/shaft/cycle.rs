//! Shafts over a cycle of their throws.

use oilwedge_study::quantities::*;
use oilwedge_study::result::Status;
use oilwedge_study::{RunOptions, parse};

use super::{changed, engines, numbers, run, text};

/// A main bearing of the three throws by itself, beside throws with these angles and shares.
fn alone(throws: &str) -> f64 {
    let bearing = text("bearings/main_85.toml");
    let bearing = changed(&bearing, "eccentricity   = 0.8\nmin_film_angle = \"180 deg\"\n", "");
    let crank = r#"
[load]
bearing = "main"
period = "720 deg"
[crank]
radius             = "62.5 mm"
rod_length         = "230 mm"
reciprocating_mass = "3.43 kg"
rotating_mass      = "2.025 kg"
bore               = "125 mm"
gas                = { peak = "8 MPa", angle = "12 deg", sharpness = 14 }
"#;
    let scene = format!("{bearing}{crank}throws = {throws}\n[orbit]\ntolerance = 1e-3\n");
    let scene = parse(&scene, &engines("bearings/alone.toml")).unwrap_or_else(|error| panic!("{error}"));
    let options = RunOptions {
        bars: false,
        ..RunOptions::of(&scene)
    };
    let found = oilwedge_study::run(&scene, &options).unwrap_or_else(|error| panic!("{error}"));
    found.result.quantity(&CYCLE_FILM_THICKNESS_MIN).expect("a film").value
}

#[test]
fn a_shaft_cut_at_its_mains_has_the_orbits_of_single_bearings() {
    let scene = changed(
        &text("three_throws.toml"),
        "period         = \"720 deg\"",
        "statics = \"cut\"",
    );
    let run = run(&scene);
    assert_eq!(run.result.status, Status::Converged, "{:?}", run.result.reason);
    let films = numbers(&run, &CYCLE_FILM_THICKNESS_MIN);
    let first = alone("[{ share = 0.5, web_mass = \"2.4 kg\" }]");
    let second =
        "[{ share = 0.5, web_mass = \"2.4 kg\" }, { angle = \"240 deg\", share = 0.5, web_mass = \"2.4 kg\" }]";
    for (number, film) in [(0, first), (1, alone(second))] {
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
    let path = folder.path().join("main.toml");
    let coarse = changed(
        &text("bearings/main_85.toml"),
        "[journal]",
        "[mesh]\nsize = \"9 mm\"\n\n[journal]",
    );
    std::fs::write(&path, coarse).expect("a file");
    let scene = text("three_throws.toml").replace("bearings/main_85.toml", path.to_str().expect("a path"));
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
