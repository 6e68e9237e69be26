//! Orbits by maps of the film against those of the film.

use std::f64::consts::TAU;
use std::path::Path;
use std::sync::Arc;

use oilwedge_bearing::Deadline;
use oilwedge_bearing::duty_cycle::{DutyCycle, ForceAxes, Harmonic, Turning};
use oilwedge_bearing::mobility::{ShortMap, Travel};
use oilwedge_bearing::orbit::{Motion, OrbitOptions};
use oilwedge_reynolds::terms::squeeze::Squeeze;
use oilwedge_reynolds::{Cavitation, Gap, Theory};
use oilwedge_study::orbit::{by_maps, no_map};
use oilwedge_study::quantities::CYCLE_FILM_THICKNESS_MIN;
use oilwedge_study::{RunOptions, compile, parse, run};
use oilwedge_tests::*;

/// A short half film on a fine ring, over a turn from one place.
#[test]
fn the_short_map_leads_as_the_short_film() {
    let length = 0.5 * RADIUS;
    let mut problem = plain_film(length, 0.0, 0.0, SPEED);
    problem.terms.push(Arc::new(Squeeze));
    problem.theory = Theory::Short;
    problem.cavitation = Cavitation::Guembel { pressure: 0.0 };
    let system = ring_system(96, 2, length, None);
    let unit = pressure_scale() * RADIUS * RADIUS;
    let of = |order: f64, cos: [f64; 2], sin: [f64; 2]| Harmonic {
        order,
        cos: [unit * cos[0], unit * cos[1], 0.0, 0.0],
        sin: [unit * sin[0], unit * sin[1], 0.0, 0.0],
    };
    let orders = vec![of(0.0, [0.1, 0.0], [0.0; 2]), of(1.0, [0.15, 0.0], [0.0, 0.15])];
    let turning = Turning { speed: SPEED, rod: None };
    let cycle = DutyCycle::of_harmonics(orders, TAU, ForceAxes::Shell, turning);
    let motion = Motion {
        problem: &problem,
        system: &system,
        gap: Gap::of(&problem, &system),
        cycle: &cycle,
        support: None,
        mass: 0.0,
    };
    let options =
        OrbitOptions { tolerance: 1e-5, closure: 0.0, cycles: 1, deadline: Deadline::default(), observer: None };
    let start = [0.3 * CLEARANCE, 0.2 * CLEARANCE];
    let film = motion.orbit([start[0], start[1], 0.0, 0.0], &options).expect("an orbit");
    let travel = Travel { map: &ShortMap, bearing: problem.bearing, viscosity: VISCOSITY, cycle: &cycle };
    let map = travel.orbit(start, 1e-7, 0.0, 1).expect("an orbit by the map");
    let [a, b] = [&film.steps, &map.steps].map(|steps| steps.last().expect("an end").at);
    let off = (a[0] - b[0]).hypot(a[1] - b[1]) / CLEARANCE;
    assert!(off < 1e-4, "{off}");
    let eccentricity = b[0].hypot(b[1]) / CLEARANCE;
    assert!(eccentricity > 0.5, "a test of little use: {eccentricity}");
}

const SCENE: &str = r#"
bearing = { diameter = "50 mm", length = "25 mm", clearance = "30 um" }
mesh.size = "6 mm"
journal.speed = "3000 rpm"
oil.viscosity = "10 mPa.s"
cavitation.model = "reynolds"
load = { harmonics = [{ order = 0, cos = { x = "2 kN" } }, { order = 1, sin = { y = "3 kN" } }], frame = "shell", period = "360 deg" }
orbit = { cycles = 5 }
"#;

/// The least film by the map of the finite film is that of the film within 0.1 %; that of the short film is a quarter
/// off.
#[test]
fn the_map_of_the_finite_film_leads_as_the_film() {
    let scene = parse(SCENE, Path::new("a.toml")).unwrap_or_else(|error| panic!("{error}"));
    let options = RunOptions { bars: false, ..RunOptions::default() };
    let found = run(&scene, &options).expect("a film");
    let path = found.orbit.expect("a path");
    let [short, finite] =
        <[_; 2]>::try_from(by_maps(&compile(&scene).expect("a model"), &path).expect("a film")).expect("two maps");
    let film = found.result.quantity(&CYCLE_FILM_THICKNESS_MIN).expect("a film").value;
    let off = |by: &Result<oilwedge_study::orbit::ByMap, String>| {
        let by = by.as_ref().unwrap_or_else(|reason| panic!("{reason}"));
        let least = by.quantities.iter().find(|it| it.row == &CYCLE_FILM_THICKNESS_MIN).expect("a film").value;
        (least / film - 1.0).abs()
    };
    let finite_difference = finite.as_ref().expect("a map").film_difference;
    assert!(off(&finite) < 1e-3 && finite_difference < 2e-3, "{finite:?}");
    assert!(off(&short) > 0.1, "{short:?}");
}

#[test]
fn what_has_no_map_is_named() {
    let without = |from: &str, to: &str| {
        assert!(SCENE.contains(from), "{from}");
        let scene = parse(&SCENE.replacen(from, to, 1), Path::new("a.toml")).unwrap_or_else(|error| panic!("{error}"));
        no_map(&compile(&scene).expect("a model"))
    };
    assert_eq!(without("cycles = 5", "cycles = 4"), None);
    for (from, to, told) in [
        ("cycles = 5", "mass = \"1 kg\"", "mass"),
        ("\"reynolds\"", "\"none\"", "cavitation model"),
        ("\"10 mPa.s\"", "\"10 mPa.s\"\noil.barus.alpha = \"2e-8 1/Pa\"", "viscosity"),
        ("load = {", "ends.pressure = \"1 bar\"\nload = {", "pressure than the ends"),
        ("load = {", "load = { at = \"1 mm\",", "tilts"),
        ("orbit = { cycles = 5 }", "", "no [orbit]"),
    ] {
        let found = without(from, to).unwrap_or_else(|| panic!("{to} has a map"));
        assert!(found.contains(told), "{to}: {found}");
    }
}
