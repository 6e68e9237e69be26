//! What a scene without `[mesh]` gets: the numbers that an engineer reads to 2 %, or a warning; and how many films that
//! takes.

use std::path::Path;

use oilwedge_study::quantities::{
    ECCENTRICITY, FILM_THICKNESS_MIN, FRICTION_TORQUE, FRICTION_TORQUE_BEARING, MIN_FILM_ANGLE, PRESSURE_MAX, Row,
    SIDE_FLOW,
};
use oilwedge_study::result::{RunResult, Status};
use oilwedge_study::{RunOptions, parse, run, warning};

/// A 60 mm main bearing: half groove, 4 bar, mass-conserving.
fn main_bearing(speed: &str, rest: &str) -> String {
    format!(
        r#"
bearing = {{ diameter = "60 mm", length = "25 mm", clearance = "30 um" }}
journal = {{ speed = "{speed}" }}
load = {{ force = "12 kN", angle = "270 deg" }}
cavitation = {{ model = "jfo", pressure = "0 bar" }}
{rest}
[[feed]]
group = "groove"
groove = {{ from = "0 deg", to = "180 deg", width = "4 mm" }}
pressure = "4 bar"
"#
    )
}

fn result(text: &str) -> RunResult {
    let scene = parse(text, Path::new("scene.toml")).unwrap_or_else(|error| panic!("{error}"));
    run(&scene, &RunOptions::default()).expect("a film").result
}

fn value(result: &RunResult, row: &Row) -> f64 {
    result.quantity(row).unwrap_or_else(|| panic!("no {}", row.name)).value
}

#[test]
fn what_an_engineer_reads_is_known_to_two_percent() {
    let oil = "oil = { grade = \"SAE 5W-30\", temperature = \"100 C\" }";
    let film = result(&main_bearing("3000 rpm", oil));
    assert_eq!(film.head.status, Status::Converged);
    for row in [&PRESSURE_MAX, &FILM_THICKNESS_MIN, &SIDE_FLOW, &FRICTION_TORQUE] {
        let quantity = film.quantity(row).expect("a number");
        let bar = quantity.error().expect("a bar");
        assert!(bar <= 0.02 * quantity.value.abs(), "{}: {} +- {bar}", row.name, quantity.value);
    }
    assert!(film.tail.warnings.iter().all(|warning| *warning.kind != warning::WIDE_BAR));
    // T - T_b = W e sin beta: the load is downwards.
    let offset = value(&film, &ECCENTRICITY) * 30e-6;
    let moment = 12e3 * offset * (value(&film, &MIN_FILM_ANGLE) - 270.0).to_radians().sin();
    let torques = value(&film, &FRICTION_TORQUE) - value(&film, &FRICTION_TORQUE_BEARING);
    assert!((torques / moment - 1.0).abs() < 1e-6, "{torques} {moment}");
}

/// A bar that stays wide because a finer mesh would be expensive is reported by a warning.
#[test]
fn a_bar_that_stays_wide_has_a_warning() {
    let oil = "oil = { grade = \"SAE 5W-30\", temperature = \"100 C\" }";
    let scene = parse(&main_bearing("3000 rpm", oil), Path::new("scene.toml")).expect("a scene");
    let options = RunOptions { max_unknowns: 7000, ..RunOptions::default() };
    let film = run(&scene, &options).expect("a film").result;
    let quantity = film.quantity(&PRESSURE_MAX).expect("a number");
    assert!(quantity.error().expect("a bar") > 0.02 * quantity.value);
    let told = film.tail.warnings.iter().find(|warning| *warning.kind == warning::WIDE_BAR);
    assert!(told.is_some_and(|told| told.text.contains("pressure_max")), "{:?}", film.tail.warnings);
    assert_eq!(film.head.status, Status::Converged, "what is required is met");
}

/// A shell that is thinnest at its edge loses hardly any oil at its ends: that number is the least certain, and no mesh
/// is made for it.
#[test]
fn a_small_side_flow_with_a_wide_bar_has_a_warning() {
    let film = result(
        r#"
bearing = { diameter = "80 mm", length = "50 mm", clearance = "50 um", arc = { from = "200 deg", to = "340 deg" } }
journal = { speed = "3000 rpm" }
load = { force = "1990 N", angle = "205.9 deg" }
oil = { viscosity = "20 mPa.s" }
cavitation = { model = "reynolds" }
"#,
    );
    let quantity = film.quantity(&SIDE_FLOW).expect("a side flow");
    let is_wide = quantity.error().expect("a bar") > 0.02 * quantity.value.abs();
    let told =
        (film.tail.warnings.iter()).any(|told| *told.kind == warning::WIDE_BAR && told.text.contains("side_flow"));
    assert_eq!((film.head.status, is_wide, told), (Status::Converged, true, true), "{:?}", film.tail.warnings);
}

#[test]
fn drawn_meshes_have_three_hundred_triangles() {
    let text = r#"
bearing = { diameter = "60 mm", length = "30 mm", clearance = "30 um", arc = { from = "240 deg", to = "300 deg" } }
journal = { speed = "3000 rpm", eccentricity = 0.3, min_film_angle = "290 deg" }
oil = { viscosity = "20 mPa.s" }
cavitation = { model = "reynolds" }
"#;
    let film = result(text);
    assert!(film.mesh.cells >= 270, "{} triangles", film.mesh.cells);
}

/// Temperature and position are found together: few more positions than at a given temperature.
#[test]
fn a_heat_balance_takes_few_positions() {
    let heat = "oil = { grade = \"SAE 5W-30\" }\nheat = { inlet = \"72.5 C\" }\nmesh = { size = \"3 mm\" }";
    let warm = result(&main_bearing("5000 rpm", heat));
    assert_eq!(warm.head.status, Status::Converged, "{:?}", warm.head.reason);
    let counts = warm.counts;
    assert!(counts.position_steps <= 40 && counts.temperature_steps <= 14, "{counts:?}");
    assert!(warm.balances.thermal < 1e-7 && warm.balances.force < 1e-8, "{:?}", warm.balances);
}
