//! Places in films: where the pressure is greatest, and where the loaded film begins and ruptures.

use std::f64::consts::PI;

use oilwedge_scene::Scene;
use oilwedge_study::result::RunResult;
use oilwedge_study::{RunOptions, run};
use oilwedge_tests::scenes::written;

/// A ring whose widest film is at 30 degrees, where its film starts.
fn ring(theory: &str, model: &str, eccentricity: f64, size: &str, speed: &str) -> Scene {
    // The journal turns away from the widest film in either sense.
    written(&format!(
        "[bearing]\ndiameter = '75 mm'\nlength = '30 mm'\nclearance = '37.5 um'\n{theory}\n[mesh]\nsize = '{size}'\n\
         [journal]\nspeed = '{speed}'\neccentricity = {eccentricity}\nmin_film_angle = '210 deg'\n\
         [oil]\nviscosity = '0.4 Pa.s'\n[cavitation]\nmodel = '{model}'\n"
    ))
}

fn solved(scene: &Scene) -> RunResult {
    run(scene, &RunOptions::default()).expect("a run").result
}

/// Value and bar of a quantity.
fn number(result: &RunResult, name: &str) -> [f64; 2] {
    let found = result.quantities.iter().find(|quantity| quantity.name == name);
    let quantity = found.unwrap_or_else(|| panic!("no {name}"));
    [quantity.value, quantity.error().unwrap_or_else(|| panic!("{name} has no bar"))]
}

/// Asserts that a quantity is what it should be, within its bar and within `most`, which is what the bar may be too.
fn is(result: &RunResult, name: &str, expected: f64, most: f64) {
    let [value, bar] = number(result, name);
    let off = (value - expected).abs();
    assert!(off <= bar + 1e-9 && bar <= most, "{name}: {value} +- {bar}, not {expected}");
}

const LONG: &str = "theory = 'long'\nfilm_start = '30 deg'";

/// Sommerfeld's long film (Z. Math. Phys. 50 (1904) 97): the pressure is greatest where
/// `cos theta = -3 eps/(2 + eps^2)`, theta from the widest film. With Guembel's condition the film ends where it is
/// thinnest.
#[test]
fn long_films_of_sommerfeld_and_guembel() {
    for eccentricity in [0.3f64, 0.6, 0.8] {
        let theta = (-3.0 * eccentricity / (2.0 + eccentricity * eccentricity)).acos().to_degrees();
        let film = solved(&ring(LONG, "none", eccentricity, "3 mm", "10 rad/s"));
        is(&film, "pressure_max_angle", 30.0 + theta, 0.2);
        assert!(film.quantities.iter().all(|quantity| !quantity.name.starts_with("film_end")));
        let film = solved(&ring(LONG, "guembel", eccentricity, "3 mm", "10 rad/s"));
        is(&film, "pressure_max_angle", 30.0 + theta, 0.2);
        is(&film, "film_start_angle", 30.0, 1e-9);
        is(&film, "film_end_angle", 210.0, 0.2);
        // Turning backwards mirrors the film.
        let film = solved(&ring(LONG, "guembel", eccentricity, "3 mm", "-10 rad/s"));
        is(&film, "pressure_max_angle", 390.0 - theta, 0.2);
        is(&film, "film_end_angle", 210.0, 0.2);
    }
}

/// Swift (1932) and Stieber (1933) in the long film: with Sommerfeld's angle psi,
/// `1 + eps cos theta = (1 - eps^2)/(1 - eps cos psi)`, the film ruptures at psi_s where
/// `sin psi_s - psi_s cos psi_s = (eps/2) (psi_s - sin psi_s cos psi_s)`, and the pressure is greatest at
/// `2 pi - psi_s`.
#[test]
fn long_films_of_swift_and_stieber() {
    for eccentricity in [0.4f64, 0.7] {
        let condition = |psi: f64| {
            let (sin, cos) = psi.sin_cos();
            sin - psi * cos - 0.5 * eccentricity * (psi - sin * cos)
        };
        let (mut low, mut high) = (PI, 1.5 * PI);
        assert!(condition(low) > 0.0 && condition(high) < 0.0);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            *if condition(middle) > 0.0 { &mut low } else { &mut high } = middle;
        }
        let angle = |psi: f64| {
            let cos = (psi.cos() - eccentricity) / (1.0 - eccentricity * psi.cos());
            let theta = cos.acos().to_degrees();
            if psi > PI { 360.0 - theta } else { theta }
        };
        for model in ["reynolds", "jfo"] {
            let film = solved(&ring(LONG, model, eccentricity, "2 mm", "10 rad/s"));
            is(&film, "pressure_max_angle", 30.0 + angle(2.0 * PI - low), 2.5);
            is(&film, "film_end_angle", 30.0 + angle(low), 4.0);
            is(&film, "film_start_angle", 30.0, 1e-9);
        }
    }
}

/// Ocvirk's short film (NACA TN 2808, 1952), `p ~ sin theta/(1 + eps cos theta)^3`: greatest where
/// `cos theta = (1 - sqrt(1 + 24 eps^2))/(4 eps)`, at mid-length; loaded over the half of the ring that converges.
#[test]
fn short_films_of_ocvirk() {
    for eccentricity in [0.3f64, 0.8] {
        let cos = (1.0 - f64::sqrt(1.0 + 24.0 * eccentricity * eccentricity)) / (4.0 * eccentricity);
        let film = solved(&ring("theory = 'short'", "guembel", eccentricity, "2 mm", "10 rad/s"));
        is(&film, "pressure_max_angle", 30.0 + cos.acos().to_degrees(), 0.5);
        is(&film, "pressure_max_z", 0.0, 1e-3);
        is(&film, "film_start_angle", 30.0, 0.2);
        is(&film, "film_end_angle", 210.0, 0.2);
    }
}

/// A liner that does not reach the minimum film has its thinnest film at an edge; one that is full to its edges begins
/// and ends there.
#[test]
fn arcs_end_at_their_edges() {
    let scene = |angle: f64| {
        written(&format!(
            "[bearing]\ndiameter = '75 mm'\nlength = '75 mm'\nclearance = '37.5 um'\narc = {{ from = '40 deg', to = '160 deg' }}\n\
             [mesh]\nsize = '4 mm'\n[journal]\nspeed = '10 rad/s'\neccentricity = 0.5\nmin_film_angle = '{angle} deg'\n\
             [oil]\nviscosity = '0.4 Pa.s'\n[cavitation]\nmodel = 'reynolds'\n"
        ))
    };
    let film = solved(&scene(200.0));
    is(&film, "film_thickness_min_angle", 160.0, 1e-9);
    is(&film, "film_start_angle", 40.0, 1e-9);
    is(&film, "film_end_angle", 160.0, 1e-9);
    let film = solved(&scene(120.0));
    is(&film, "film_thickness_min_angle", 120.0, 1e-9);
    let [rupture, bar] = number(&film, "film_end_angle");
    assert!(rupture - bar > 120.0 && rupture + bar < 160.0, "{rupture} {bar}");
}

/// Where the greatest pressure is that of a feed it has no place of its own.
#[test]
fn a_given_pressure_has_no_place() {
    let scene = written(
        "[bearing]\ndiameter = '75 mm'\nlength = '75 mm'\nclearance = '37.5 um'\n[[feed]]\ngroup = 'hole'\npressure = '100 bar'\n\
         hole = { diameter = '17 mm', angle = '130 deg', z = '0 mm' }\n[mesh]\nsize = '6 mm'\n\
         [journal]\nspeed = '1 rad/s'\neccentricity = 0.2\nmin_film_angle = '180 deg'\n[oil]\nviscosity = '0.4 Pa.s'\n",
    );
    let film = solved(&scene);
    assert!(film.quantities.iter().all(|quantity| !quantity.name.starts_with("pressure_max_")));
}

/// Bars of places against a finer mesh, in films of finite length.
#[test]
fn bars_of_places_hold() {
    for model in ["guembel", "reynolds", "jfo"] {
        let start = if model == "guembel" { "" } else { "film_start = '30 deg'" };
        let fine = solved(&ring(start, model, 0.7, "1 mm", "10 rad/s"));
        let coarse = solved(&ring(start, model, 0.7, "5 mm", "10 rad/s"));
        for name in ["pressure_max_angle", "pressure_max_z", "film_start_angle", "film_end_angle"] {
            let ([value, bar], [better, rest]) = (number(&coarse, name), number(&fine, name));
            assert!((value - better).abs() <= bar + rest, "{model} {name}: {value} +- {bar}, {better} +- {rest}");
            assert!(rest <= 0.5 * bar || bar < 1e-9, "{model} {name}: {bar} {rest}");
        }
    }
}

/// Rows of triangles along the flow have vertices and edges on the mid-plane, and the greatest pressure at one of them.
#[test]
fn rows_of_triangles_have_both_ends() {
    for (eccentricity, size) in [(0.666_084, "4 mm"), (0.666_084, "2 mm"), (0.5, "3 mm"), (0.8, "5 mm")] {
        let scene = written(&format!(
            "[bearing]\ndiameter = '75 mm'\nlength = '75 mm'\nclearance = '37.5 um'\nfilm_start = '10.6 deg'\n[mesh]\nsize = '{size}'\n\
             [journal]\nspeed = '10 rad/s'\neccentricity = {eccentricity}\nmin_film_angle = '190.6 deg'\n\
             [oil]\nviscosity = '0.4 Pa.s'\n[cavitation]\nmodel = 'jfo'\n"
        ));
        let film = solved(&scene);
        is(&film, "film_start_angle", 10.6, 1e-9);
        let ([rupture, bar], [top, _]) = (number(&film, "film_end_angle"), number(&film, "pressure_max_angle"));
        assert!(top < 190.6 && rupture > 190.6 && rupture - bar < 230.0, "{top} {rupture} {bar}");
    }
}
