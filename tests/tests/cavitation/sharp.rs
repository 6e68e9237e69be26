//! The sharp hill over the cavity of a mass-conserving film: Swift-Stieber films, and limits of finer meshes.

use oilwedge_reynolds::quantities::power::{PressurePower, power};
use oilwedge_reynolds::quantities::{load::load, pressure::extremes};
use oilwedge_reynolds::sharp::{HillNumbers, HillStart, SharpFilm};
use oilwedge_reynolds::{Cavitation, JournalChange, ReferenceFilm, SolvedFilm};
use oilwedge_study::analysis::solve;
use oilwedge_study::compile::compile;
use oilwedge_study::film::Film;
use oilwedge_study::solved::{Errors, SolveOptions};
use oilwedge_study::{RunOptions, run};
use oilwedge_tests::scenes::written;

/// B/D 0.8; `film_start` and supplies, edges of at most `size` [mm].
fn bearing(film_start: &str, size: f64, eccentricity: f64, supply: &str) -> String {
    format!(
        r#"
title = "One supply"
bearing = {{ diameter = "100 mm", length = "80 mm", clearance = "150 um"{film_start} }}
mesh = {{ size = "{size} mm" }}
journal = {{ speed = "3000 rpm", eccentricity = {eccentricity}, min_film_angle = "0 deg" }}
oil.viscosity = "0.01 Pa.s"
cavitation = {{ model = "jfo", pressure = "0 bar" }}
{supply}
"#
    )
}

fn fed(size: f64, region: &str) -> String {
    let supply = format!("[[feed]]\ngroup = \"supply\"\npressure = \"0.7 bar\"\n{region}\n");
    bearing("", size, 0.5, &supply)
}

fn film(text: &str) -> Film {
    compile(&written(text)).and_then(|model| model.film()).unwrap_or_else(|error| panic!("{error}"))
}

fn hill(study: &Film) -> SharpFilm {
    let film = study.problem.solve(&study.system).unwrap_or_else(|reason| panic!("{reason}"));
    let sharp = film.sharp_film(HillStart::Film);
    sharp.unwrap_or_else(|failure| panic!("{failure}")).expect("a hill")
}

fn magnitude(numbers: &HillNumbers) -> f64 {
    numbers.load.force[0].hypot(numbers.load.force[1])
}

#[track_caller]
fn close(what: &str, value: f64, expected: f64, relative: f64) {
    let error = (value / expected - 1.0).abs();
    assert!(error < relative, "{what}: {value} is {error:.1e} off {expected}");
}

/// Power [W] against the pressure.
fn pressure_power(study: &Film, numbers: &HillNumbers) -> f64 {
    let [per_x, per_y] = PressurePower::of(&study.problem).expect("a ring").force;
    let [x, y] = numbers.load.force;
    per_x * x + per_y * y
}

/// Where the line at the widest film is flooded the film breaks once: the cubic film of Swift and Stieber on these
/// triangles has the same pressures, whether or not the viscosity grows with them.
#[test]
fn a_flooded_ring_is_a_swift_stieber_film() {
    for (eccentricity, oil) in [(0.9, ""), (0.97, ""), (0.9, "oil.barus = { alpha = \"1e-8 1/Pa\" }")] {
        let study = film(&bearing(", film_start = \"180 deg\"", 11.0, eccentricity, oil));
        assert!(study.unknowns() < 2500, "{}", study.unknowns());
        let sharp = hill(&study);
        assert!(sharp.history.len() <= 20, "{} steps", sharp.history.len());
        let (mut problem, system) = (study.problem.clone(), &study.system);
        problem.cavitation = Cavitation::Reynolds { pressure: 0.0 };
        let quadratic = problem.solve(system).unwrap_or_else(|reason| panic!("{reason}"));
        let cubic = quadratic.cubic_film(None).unwrap_or_else(|reason| panic!("{reason}"));
        close("load", magnitude(&sharp.cubic), load(&cubic).magnitude(), 2e-4);
        close("p_max", sharp.cubic.greatest, extremes(&cubic).greatest, 1e-6);
        close("power", pressure_power(&study, &sharp.cubic), power(&cubic).pressure, 3e-4);
    }
}

/// A groove of three quarters of the width; limits: a structured code, and meshes of 35 000 nodes.
#[test]
fn a_groove_is_sharp_at_six_thousand_nodes() {
    let region = r#"groove = { from = "82.5 deg", to = "97.5 deg", width = "60 mm" }"#;
    let study = film(&fed(6.5, region));
    let sharp = hill(&study);
    close("load", magnitude(&sharp.cubic), 1745.8, 3e-4);
    close("p_max", sharp.cubic.greatest, 5.2530e5, 1e-4);
    close("power", pressure_power(&study, &sharp.cubic), 16.357, 5e-4);
}

const MAIN: &str = r#"
title = "Main bearing of a crankshaft"
bearing = { diameter = "60 mm", length = "25 mm", clearance = "30 um" }
mesh = { size = "4 mm" }
journal = { speed = "5000 rpm", eccentricity = 0.8937, min_film_angle = "309 deg" }
oil = { grade = "SAE 5W-30", temperature = "94 C" }
cavitation = { model = "jfo", pressure = "0 bar" }
[[feed]]
group = "groove"
groove = { from = "0 deg", to = "180 deg", width = "4 mm" }
pressure = "4 bar"
"#;

/// A main bearing of 60 mm on a coarse mesh; limits: meshes of 42 000 nodes with edges of 1 mm.
#[test]
fn a_main_bearing_is_sharp() {
    let study = film(MAIN);
    let sharp = hill(&study);
    close("load", magnitude(&sharp.cubic), 31053.0, 1e-4);
    close("p_max", sharp.cubic.greatest, 1.01629e8, 1e-4);
    close("power", pressure_power(&study, &sharp.cubic), 86.967, 5e-4);
    let [x, y] = sharp.cubic.load.force;
    let angle = y.atan2(x).to_degrees().rem_euclid(360.0);
    assert!((angle - 285.4841).abs() < 3e-3, "{angle}");
    let result = run(&written(MAIN), &RunOptions::default()).expect("a film").result;
    for (name, limit, most) in [("load", 31053.0, 2e-3), ("pressure_max", 1.01629e8, 2e-3)] {
        let quantity = result.by_name(name).expect(name);
        let bar = quantity.bar.expect("a bar").total();
        assert!((quantity.value - limit).abs() < bar && bar < most * limit, "{name}: {} +- {bar}", quantity.value);
    }
}

/// Streaks with sharp edges, which a hill smears: the finite volumes stand.
#[test]
fn streaks_are_those_of_the_finite_volumes() {
    for (region, size, limit) in [
        (r#"groove = { from = "82.5 deg", to = "97.5 deg", width = "20 mm" }"#, 5.5, 1651.2),
        (r#"hole = { diameter = "15 mm", angle = "1.6207963 rad" }"#, 6.0, 1586.8),
    ] {
        let result = run(&written(&fed(size, region)), &RunOptions::default()).expect("a film").result;
        let load = result.by_name("load").expect("a load");
        close("load", load.value, limit, 5e-4);
        assert!((load.value - limit).abs() < load.bar.expect("a bar").total());
    }
}

/// Over cavities that are kept the force follows the position smoothly. What it changes by over those of a position
/// farther off is told, and is small.
#[test]
fn the_force_over_kept_cavities_is_smooth() {
    let study = film(&MAIN.replace("4 mm\" }\njournal", "6 mm\" }\njournal"));
    let mut place = Place::of(&study);
    let mut differences = Vec::new();
    for _ in 0..6 {
        place = place.moved(1e-4);
        differences.push(place.hill.cubic.load.force[0]);
    }
    for _ in 0..3 {
        differences = differences.windows(2).map(|pair| pair[1] - pair[0]).collect();
    }
    let load = magnitude(&place.hill.cubic);
    assert!(differences.iter().all(|jump| jump.abs() < 1e-8 * load), "{differences:?} of {load}");
    let Place { film, hill } = place.moved(5e-3);
    let checked = film.cavities_checked(hill).expect("a hill");
    let by_cavities = magnitude(&checked.by_cavities) / load;
    assert!((1e-10..1e-6).contains(&by_cavities), "{by_cavities:e}");
}

/// A film and its hill.
struct Place {
    film: SolvedFilm,
    hill: SharpFilm,
}

impl Place {
    fn of(study: &Film) -> Self {
        let film = study.problem.solve(&study.system).unwrap_or_else(|reason| panic!("{reason}"));
        let hill = film.sharp_film(HillStart::Film);
        Self { hill: hill.expect("a hill").expect("a hill"), film }
    }

    /// Moves along x by this part of the clearance over the cavities that are there.
    fn moved(self, part: f64) -> Self {
        let change =
            JournalChange { offset: [part * self.film.problem.bearing.clearance, 0.0], ..JournalChange::default() };
        let film = self.film.displaced(&change).unwrap_or_else(|reason| panic!("{reason}"));
        let hill = film.sharp_film(HillStart::SameCavities(self.hill));
        Self { hill: hill.expect("a hill").expect("a hill"), film }
    }
}

/// Bars of finite volumes below a thousandth leave a hill nothing to do.
#[test]
fn narrow_bars_need_no_hill() {
    let region = r#"groove = { from = "82.5 deg", to = "97.5 deg", width = "60 mm" }"#;
    for (size, is_sought) in [(9.0, true), (2.5, false)] {
        let solved =
            solve(&film(&fed(size, region)), &SolveOptions { errors: Errors::Estimated, ..SolveOptions::default() });
        let solved = solved.unwrap_or_else(|reason| panic!("{reason}"));
        let Some(ReferenceFilm::Coarse { hill, .. }) = &solved.reference else {
            panic!("no comparison");
        };
        assert_eq!(hill.is_some(), is_sought, "{size} mm");
    }
}

/// The load of the hill gives its position back, and what is left of it is less than the bars by far.
#[test]
fn the_force_of_the_hill_finds_the_position() {
    let text = |journal: &str| {
        format!(
            r#"
title = "Ring with a groove"
bearing = {{ diameter = "60 mm", length = "25 mm", clearance = "30 um" }}
mesh = {{ size = "5 mm" }}
journal = {{ speed = "5000 rpm"{journal} }}
oil = {{ viscosity = "8 mPa.s" }}
cavitation = {{ model = "jfo", pressure = "0 bar" }}
{}
[[feed]]
group = "groove"
groove = {{ from = "0 deg", to = "180 deg", width = "4 mm" }}
pressure = "4 bar"
"#,
            match journal {
                "" => "load = { force = \"20 kN\", angle = \"270 deg\" }",
                _ => "",
            }
        )
    };
    let found = run(&written(&text("")), &RunOptions::default()).expect("a film").result;
    let number = |name: &str| found.by_name(name).expect(name).value;
    assert!(found.balances.force < 1e-10, "{:e}", found.balances.force);
    assert!(found.of_hill.iter().any(|name| name == "load"), "{:?}", found.of_hill);
    let journal =
        format!(", eccentricity = {}, min_film_angle = \"{} deg\"", number("eccentricity"), number("min_film_angle"));
    // On another mesh, graded for that position.
    let there = run(&written(&text(&journal)), &RunOptions::default()).expect("a film").result;
    let load = there.by_name("load").expect("a load");
    assert!((load.value - 20e3).abs() < load.bar.expect("a bar").total(), "{}", load.value);
    let bar = found.by_name("eccentricity").expect("a position").bar.expect("a bar").total();
    assert!(bar < 1e-3 * number("eccentricity"), "{bar:e}");
}
