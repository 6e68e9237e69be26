//! The map of what each triangle adds to the error: in the unit of the goal.

use oilwedge_bearing::Deadline;
use oilwedge_mesh::Mesh;
use oilwedge_scene::Scene;
use oilwedge_study::compile::compile;
use oilwedge_study::film::DEGREE;
use oilwedge_study::level::{Level, solve_level};
use oilwedge_tests::scenes::written;

fn level(scene: &Scene) -> Level {
    let film = compile(scene).and_then(|model| model.film()).expect("a film");
    let mesh = Mesh::build(film.system.space().mesh().to_raw()).expect("the same mesh");
    solve_level(&film.model, mesh, film.position(), DEGREE, Deadline::default()).expect("a level")
}

/// Sum of the map over the bar of a quantity.
fn ratio(level: &Level, goal: &str) -> f64 {
    let quantity = level.quantities.iter().find(|quantity| quantity.name == goal).expect("the goal");
    let shares = level.indicator.as_ref().expect("a map");
    assert!(shares.iter().all(|share| share.is_finite()));
    shares.iter().map(|share| share.abs()).sum::<f64>() / quantity.error().expect("a bar")
}

/// Shares without their signs do not fall short of the error of the load, and under a load those of the eccentricity
/// exceed its bar as many times: the map is in the unit of the goal. A direction across the line of centres may count
/// less.
#[test]
fn the_map_adds_up_to_the_error() {
    for force in ["2 kN", "8 kN"] {
        let ring = |journal: &str| {
            written(&format!(
                "[bearing]\ndiameter = '75 mm'\nlength = '60 mm'\nclearance = '37.5 um'\n[mesh]\nsize = '4 mm'\n[journal]\nspeed = '10 rad/s'\n{journal}\n\
                 [oil]\nviscosity = '0.4 Pa.s'\n[cavitation]\nmodel = 'reynolds'\n"
            ))
        };
        let loaded = level(&ring(&format!("[load]\nforce = '{force}'\nangle = '270 deg'")));
        let position = loaded.film.position();
        let given = level(&ring(&format!(
            "eccentricity = {}\nmin_film_angle = '{} deg'",
            position.eccentricity,
            position.min_film_angle.to_degrees().rem_euclid(360.0)
        )));
        let (of_load, of_eccentricity) = (ratio(&given, "load"), ratio(&loaded, "eccentricity"));
        assert!(of_load > 0.8, "{force}: {of_load}");
        let relative = of_eccentricity / of_load;
        assert!((0.4..2.5).contains(&relative), "{force}: {of_eccentricity} {of_load}");
    }
}
