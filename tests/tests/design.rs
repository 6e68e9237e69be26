//! Designs whose optimum is known in closed form.

use std::f64::consts::{PI, TAU};
use std::path::Path;

use oilwedge_campaign::design::{DesignEnd, DesignRecord, design};
use oilwedge_study::RunOptions;

/// Most films of a search.
const MOST: usize = 30;

fn found(text: &str) -> DesignRecord {
    let scene = oilwedge_study::parse(text, Path::new("scene.toml")).unwrap_or_else(|error| panic!("{error}"));
    let options = RunOptions { bars: false, ..RunOptions::of(&scene) };
    let asked = scene.design.as_ref().expect("a design");
    let found = design(&scene, asked, &options).unwrap_or_else(|error| panic!("{error}")).record;
    assert!(found.end == DesignEnd::Optimum && found.is_met && found.films <= MOST, "{found:?}");
    found
}

fn assert_close(found: f64, wanted: f64, relative: f64) {
    assert!((found / wanted - 1.0).abs() < relative, "{found} is not {wanted}");
}

/// Rayleigh, Phil. Mag. 35 (1918) 1: a step carries most where the ratio of its films is 1.866, at 0.718 of the length.
#[test]
fn a_step_carries_most_where_rayleigh_has_it() {
    let text = "
bearing = { diameter = \"100 mm\", length = \"20 mm\", clearance = \"50 um\", theory = \"long\", arc = { from = \"0 deg\", to = \"100 deg\" } }
mesh = { size = \"8 mm\" }
feed = [{ group = \"step\", groove = { from = \"0 deg\", to = \"60 deg\", width = \"20 mm\" }, depth = \"30 um\" }]
journal = { speed = \"100 rad/s\", eccentricity = 0, min_film_angle = \"50 deg\" }
oil = { viscosity = \"20 mPa.s\" }
[design]
free = { \"feed.step.depth\" = [\"10 um\", \"100 um\"], \"feed.step.groove.to\" = [\"40 deg\", \"90 deg\"] }
maximise = \"pressure_integral\"
";
    let found = found(text);
    let (ratio, place) = (1.0 + found.keys[0].optimum / 50.0, found.keys[1].optimum / 100.0);
    assert_close(ratio, 1.0 + 0.75f64.sqrt(), 1e-3);
    assert_close(place, 0.718_03, 1e-3);
    // Int p dA of the step: half of the length times the pressure at the step.
    let [films, length] = [[1.866_025 * 50e-6, 50e-6], [0.718_03 * 100.0, 0.281_97 * 100.0].map(|angle| angle)];
    let [first, second] = length.map(|angle| angle * PI / 180.0 * 0.05);
    let pressure = 6.0 * 20e-3 * 5.0 * (films[0] - films[1]) / (films[0].powi(3) / first + films[1].powi(3) / second);
    assert_close(found.value, 0.5 * (first + second) * 0.02 * pressure, 1e-5);
}

/// A short film (DuBois and Ocvirk 1953) under 5 kN at 300 rad/s, 50 mm in diameter and as long, whose least film is
/// `film` [m] at the eccentricity `e`: clearance [m], viscosity [Pa.s] and power [W].
fn short_film(film: f64, e: f64) -> [f64; 3] {
    let (load, omega, radius, length) = (5000.0, 300.0, 0.025, 0.05);
    let (clearance, rest) = (film / (1.0 - e), 1.0 - e * e);
    let carried = omega * radius * f64::powi(length, 3) / (4.0 * clearance * clearance) * e / (rest * rest)
        * (16.0 * e * e + PI * PI * rest).sqrt();
    let viscosity = load / carried;
    let shear = TAU * viscosity * f64::powi(omega, 2) * f64::powi(radius, 3) * length / clearance / rest.sqrt();
    let attitude = (PI * rest.sqrt() / (4.0 * e)).atan();
    [clearance, viscosity, shear + 0.5 * load * e * clearance * attitude.sin() * omega]
}

/// The eccentricity of the least power at a given least film.
fn best_eccentricity(film: f64) -> f64 {
    let power = |e: f64| short_film(film, e)[2];
    let (mut low, mut high) = (0.3, 0.95);
    while high - low > 1e-10 {
        let third = (high - low) / 3.0;
        if power(low + third) < power(high - third) {
            high -= third;
        } else {
            low += third;
        }
    }
    0.5 * (low + high)
}

fn short(film: f64, size: &str, more: &str) -> String {
    format!(
        "
bearing = {{ diameter = \"50 mm\", length = \"50 mm\", clearance = \"30 um\", theory = \"short\" }}
mesh = {{ size = \"{size}\" }}
journal = {{ speed = \"300 rad/s\" }}
load = {{ force = \"5 kN\", angle = \"270 deg\" }}
oil = {{ viscosity = \"1 mPa.s\" }}
cavitation = {{ model = \"guembel\" }}
criteria = {{ film_min = \"{film} um\" }}
[design]
free = {{ clearance = [\"15 um\", \"60 um\"], viscosity = [\"0.1 mPa.s\", \"2 mPa.s\"] }}
minimise = \"friction_power\"
{more}"
    )
}

#[test]
fn a_short_film_has_the_clearance_of_its_least_power() {
    let found = found(&short(4.0, "1.2 mm", ""));
    let [clearance, viscosity, power] = short_film(4e-6, best_eccentricity(4e-6));
    assert_close(found.keys[0].optimum * 1e-6, clearance, 1e-3);
    assert_close(found.keys[1].optimum * 1e-3, viscosity, 1e-3);
    assert_close(found.value, power, 1e-5);
    assert!(found.constraints[0].is_active && found.gradient_films == 0, "{found:?}");
}

/// With `spread` the limit is met in the worst case: the load and the viscosity at their ends.
#[test]
fn limits_are_met_within_the_tolerances() {
    let text = short(4.0, "5 mm", "spread = true").replace("\"5 kN\"", "\"5 kN +- 4 %\"");
    let with = found(&text);
    let without = found(&short(4.0, "5 mm", ""));
    let limit = &with.constraints[0];
    let spread = limit.spread.expect("a spread");
    assert!(limit.is_active && (limit.value - spread - 4.0).abs() < 1e-3, "{limit:?}");
    // The film goes with a power of the load of some -1/2 to -1.
    assert!((0.015..0.04).contains(&(spread / limit.value)), "{limit:?}");
    assert!(with.value > without.value, "{} {}", with.value, without.value);
}

/// What a limit costs is the change of the objective with it; of listed values the best one is taken.
#[test]
fn a_limit_costs_what_the_objective_loses() {
    let [low, high] = [3.99e-6, 4.01e-6].map(|film| short_film(film, best_eccentricity(film))[2]);
    let found = found(&short(4.0, "5 mm", "choose = { speed = [\"310 rad/s\", \"300 rad/s\"] }"));
    assert_close(found.constraints[0].cost, (high - low) / 0.02, 1e-2);
    let values: Vec<f64> = found.choices.iter().filter_map(|choice| choice.objective).collect();
    assert!(values.len() == 2 && values[1] == found.value && values[0] > values[1], "{found:?}");
}
