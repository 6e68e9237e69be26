//! The Swift-Stieber film as the guide of a film that conserves oil: it is nowhere under less pressure, its balance
//! leads to that of the other, and where it has none the reason says whose film it was.

use std::sync::Arc;

use oilwedge_reynolds::{Cavitation, FilmSystem};
use oilwedge_study::RunOptions;
use oilwedge_study::result::Status;
use oilwedge_study::run::run;
use oilwedge_tests::scenes::written;
use oilwedge_tests::*;

const LENGTH: f64 = 0.08;
/// Pressure at the ends [Pa], above that of the cavity.
const ENDS: f64 = 1e5;

/// Greatest pressure of the film that conserves oil above that of Swift and Stieber, over the greatest pressure, on a
/// ring of so many cells around.
fn excess(eccentricity: f64, around: u32) -> f64 {
    let mesh = ring(around, around / 4, LENGTH, 0.0);
    let mut regions = ends(&mesh, LENGTH, None);
    regions.iter_mut().for_each(|region| region.pressure = ENDS);
    let system = Arc::new(FilmSystem::new(Arc::new(mesh), 2, regions).expect("the ends close the ring"));
    let mut film = plain_film(LENGTH, eccentricity, 0.3, SPEED);
    film.cavitation = Cavitation::Jfo { pressure: 0.0 };
    let conserving = film.solve(&system).expect("a film that conserves oil");
    film.cavitation = film.cavitation.guide().expect("its guide");
    let guide = film.solve(&system).expect("a Swift-Stieber film");
    let pairs = conserving.solution.unknown.iter().zip(&guide.solution.unknown);
    let greatest = guide.solution.unknown.iter().fold(0.0f64, |most, p| most.max(*p));
    pairs.fold(0.0f64, |most, (p, q)| most.max(p - q)) / greatest
}

/// Both are discrete films, by different schemes: what is left above falls towards zero with the mesh.
#[test]
fn the_guide_is_nowhere_under_less_pressure() {
    let left = [48, 96, 192].map(|around| excess(0.9, around));
    assert!(left.windows(2).all(|pair| pair[1] < 0.62 * pair[0]), "{left:?}");
}

const TILTED: &str = r#"
title = "Tilted ring"
bearing = { diameter = "100 mm", length = "50 mm", clearance = "50 um" }
mesh = { size = "4 mm" }
oil = { viscosity = "20 mPa.s" }
cavitation = { model = "jfo" }
ends = { pressure = "10 kPa" }
"#;

/// A load far beyond what a film that conserves oil carries in contact, held at a tilt.
#[test]
fn a_load_beyond_contact_is_refused() {
    let scene = |force: &str, tilt: &str| {
        written(&format!(
            "{TILTED}journal = {{ speed = \"100 rad/s\"{tilt} }}\nload = {{ force = \"{force}\", angle = \"270 deg\" }}\n"
        ))
    };
    let tilt = r#", tilt = { x = "-0.6 mrad", y = "-1.5 mrad" }"#;
    let answer = |scene| run(&scene, &RunOptions::default()).expect("a film").result;
    let refused = answer(scene("60 kN", tilt));
    assert_eq!(refused.head.status, Status::NoSolution, "{:?}", refused.head.reason);
    let reason = refused.head.reason.unwrap_or_default();
    assert!(reason.contains("times as much; lower the load"), "{reason}");
    // A load that it carries is balanced by the film that conserves oil itself.
    let balanced = answer(scene("1 kN", r#", tilt = { x = "-0.2 mrad", y = "-0.5 mrad" }"#));
    assert_eq!(balanced.head.status, Status::Converged, "{:?}", balanced.head.reason);
    assert!(balanced.balances.force < 1e-10, "{:?}", balanced.balances);
}
