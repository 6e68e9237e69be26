//! Loads over a cycle against closed forms: the crank of `tests/data/big_end_of_a_crank.json`, and the synthetic big
//! end of the shipped scenes.

use std::f64::consts::{PI, TAU};

use oilwedge_bearing::duty_cycle::{Crank, ForceAxes};
use oilwedge_scene::Scene;
use oilwedge_study::duty::{Duty, DutyCycle, duty_cycle};
use oilwedge_tests::program::repository;
use oilwedge_tests::scenes::path;
use serde_json::Value;

/// Angles at which identities are checked in two turns.
const ANGLES: u32 = 2000;

fn shipped(name: &str) -> Scene {
    oilwedge_study::read(&path(&format!("loads/{name}"))).unwrap_or_else(|error| panic!("{error}"))
}

fn cycle(scene: &Scene) -> DutyCycle {
    let cycle = duty_cycle(scene).unwrap_or_else(|error| panic!("{error}"));
    cycle.expect("a load over a cycle")
}

fn angles() -> impl Iterator<Item = f64> {
    (0..ANGLES).map(|k| 2.0 * TAU * f64::from(k) / f64::from(ANGLES))
}

fn reference() -> Value {
    let path = repository().join("tests/data/big_end_of_a_crank.json");
    serde_json::from_str(&std::fs::read_to_string(path).expect("the data")).expect("JSON")
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

/// The table gives seven digits.
#[test]
fn the_load_of_a_crank_is_that_of_the_closed_form() {
    let cycle = cycle(&shipped("crank_big_end"));
    let turning = cycle.turning().expect("a crank");
    let crank = cycle.crank().expect("a crank");
    let data = reference();
    let speed = 2000.0 * PI / 30.0;
    let peak = number(&data["peak_N"]);
    let rows = data["rows"].as_array().expect("rows");
    assert_eq!(rows.len(), 24);
    for row in rows {
        let [theta, f_x, f_y, along, across, omega, acceleration] = [0, 1, 2, 3, 4, 5, 6].map(|k| number(&row[k]));
        let theta = theta.to_radians();
        let duty = cycle.at(theta);
        // The data give the force on the pin; the load is the opposite one.
        let [x, y] = turning.from_shell(duty.force, ForceAxes::Cylinder, theta);
        for (found, wanted) in [(-x, f_x), (-y, f_y), (-duty.force[0], along), (-duty.force[1], across)] {
            assert!((found - wanted).abs() < 1e-6 * peak, "{theta}: {found} {wanted}");
        }
        assert!((duty.speed / omega - 1.0).abs() < 1e-6, "{theta}: {} {omega}", duty.speed);
        let found = crank.linkage.piston_acceleration(theta, speed);
        assert!((found / acceleration - 1.0).abs() < 1e-6, "{theta}: {found} {acceleration}");
    }
    let (at, force) = cycle.summary().peak;
    assert!((force[0].hypot(force[1]) / peak - 1.0).abs() < 1e-6, "{force:?}");
    assert!((at.to_degrees() - number(&data["peak_deg"])).abs() < 0.05, "{at}");
}

/// `F . v_pin + (F_gas + m_p a_p) v_p = 0`.
fn power_balance(crank: &Crank, angle: f64, speed: f64) -> [f64; 2] {
    let [f_x, f_y] = crank.force_on_pin(angle, speed);
    let along_path = crank.linkage.radius * speed;
    let of_pin = along_path * (f_y * angle.cos() - f_x * angle.sin());
    let acceleration = crank.linkage.piston_acceleration(angle, speed);
    let thrust = crank.gas_force(angle) + crank.reciprocating_mass * acceleration;
    [of_pin, thrust * crank.linkage.piston_velocity(angle, speed)]
}

#[test]
fn power_of_the_crank_balances_at_every_angle() {
    let cycle = cycle(&shipped("crank_big_end"));
    let crank = cycle.crank().expect("a crank");
    let speed = cycle.angular_speed();
    let terms: Vec<_> = angles().map(|angle| power_balance(crank, angle, speed)).collect();
    let greatest = terms.iter().map(|[pin, _]| pin.abs()).fold(0.0, f64::max);
    let off = terms.iter().map(|[pin, piston]| (pin + piston).abs()).fold(0.0, f64::max);
    assert!(off < 1e-12 * greatest, "{off} of {greatest}");
}

/// Forces of inertia do no work over a cycle: the pin gives the crank what the gas gives the piston.
#[test]
fn the_work_of_a_cycle_is_that_of_the_gas() {
    let cycle = cycle(&shipped("crank_big_end"));
    let (turning, crank) = (cycle.turning().expect("a crank"), cycle.crank().expect("a crank"));
    let step = 2.0 * TAU / f64::from(ANGLES);
    // The load is the force of the crank on the pin; that of the pin on the crank is the opposite one.
    let torque = |angle: f64| {
        let force = turning.from_shell(cycle.at(angle).force, ForceAxes::Pin, angle);
        -crank.linkage.radius * force[1]
    };
    let work = step * angles().map(torque).sum::<f64>();
    let of_gas = crank.gas_work(ANGLES);
    assert!((work / of_gas - 1.0).abs() < 1e-9, "{work} {of_gas}");
    let wanted = number(&reference()["work_per_cycle_J"]);
    assert!((work / wanted - 1.0).abs() < 1e-6, "{work} {wanted}");
}

/// The load of the synthetic big end [N].
fn synthetic(angle: f64) -> [f64; 2] {
    let gas = 300e3 * (16.0 * ((0.5 * (angle - 10f64.to_radians())).cos() - 1.0)).exp();
    let inertia = 40e3 * (angle.cos() + 0.25 * (2.0 * angle).cos());
    [gas - inertia - 45e3 * angle.cos(), -45e3 * angle.sin()]
}

/// Greatest distance of a load from the synthetic one, over its peak.
fn distance(cycle: &DutyCycle) -> f64 {
    let off = angles().map(|angle| {
        let ([x, y], Duty { force, .. }) = (synthetic(angle), cycle.at(angle));
        (force[0] - x).hypot(force[1] - y)
    });
    off.fold(0.0, f64::max) / 207_294.633_674_890_68
}

#[test]
fn the_spline_of_the_table_is_the_formula() {
    let cycle = cycle(&shipped("synthetic_big_end"));
    let off = distance(&cycle);
    assert!(off < 3e-7, "{off}");
    let (at, force) = cycle.summary().peak;
    assert!((force[0].hypot(force[1]) / 207_294.633_674_890_68 - 1.0).abs() < 2e-6, "{force:?}");
    assert!((at.to_degrees() - 11.2).abs() < 0.05, "{at}");
    let rows = cycle.rows_summary().expect("a table");
    assert_eq!((rows.count, rows.peak.0.to_degrees().round()), (360, 12.0));
    assert!((cycle.summary().mean_magnitude / rows.mean_magnitude - 1.0).abs() < 1e-3);
    assert!(cycle.turning().is_some_and(|turning| turning.rod.is_none()));
    assert!((cycle.at(1.0).speed - 20.0 * PI).abs() < 1e-12);
}

/// A scene with the synthetic load in a frame, from a table in 2 degree steps with full digits and without an end row,
/// or with one.
fn written(frame: ForceAxes, end: u32, folder: &std::path::Path) -> Scene {
    let crank = cycle(&shipped("crank_big_end"));
    let turning = crank.turning().expect("a crank");
    let row = |k: u32| {
        let angle = f64::from(2 * k).to_radians();
        let [x, y] = turning.from_shell(synthetic(angle), frame, angle);
        format!("{}, {x:e}, {y:e}\n", 2 * k)
    };
    let rows: String = (0..end).map(row).collect();
    std::fs::write(folder.join("load.csv"), format!("angle [deg], Fx [N], Fy [N]\n{rows}")).expect("written");
    let frame = format!("{frame:?}").to_lowercase();
    let text = format!(
        "bearing = {{ diameter = \"85 mm\", length = \"40 mm\", clearance = \"45 um\" }}\njournal = {{ speed = \"2000 rpm\" }}\n\
         load = {{ file = \"load.csv\", frame = \"{frame}\", period = \"720 deg\" }}\n\
         crank = {{ radius = \"62.5 mm\", rod_length = \"230 mm\" }}\noil = {{ viscosity = \"10 mPa.s\" }}\n"
    );
    oilwedge_study::parse(&text, &folder.join("a.toml")).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn a_table_in_three_frames_is_one_load() {
    let folder = tempfile::tempdir().expect("a folder");
    let frames = [ForceAxes::Shell, ForceAxes::Cylinder, ForceAxes::Pin];
    let cycles = frames.map(|frame| cycle(&written(frame, 360, folder.path())));
    for angle in angles() {
        let [shell, others @ ..] = [0, 1, 2].map(|k: usize| cycles[k].at(angle));
        for other in others {
            let off = (shell.force[0] - other.force[0]).hypot(shell.force[1] - other.force[1]);
            assert!(off < 1e-12 * 207e3, "{angle}: {off}");
            assert_eq!(shell.speed, other.speed);
        }
    }
    assert!(distance(&cycles[0]) < 2e-6);
    // A row that repeats the first one changes nothing.
    let closed = cycle(&written(ForceAxes::Shell, 361, folder.path()));
    assert!(angles().all(|angle| closed.at(angle) == cycles[0].at(angle)));
}

/// Harmonics of a rotating force in the frame of the cylinder are a constant in that of the pin.
#[test]
fn harmonics_are_a_load_too() {
    let scene = |frame: &str, harmonics: &str| {
        let text = format!(
            "bearing = {{ diameter = \"85 mm\", length = \"40 mm\", clearance = \"45 um\" }}\njournal = {{ speed = \"2000 rpm\" }}\n\
             load = {{ frame = \"{frame}\", period = \"720 deg\", at = \"5 mm\", harmonics = [{harmonics}] }}\n\
             crank = {{ radius = \"62.5 mm\", rod_length = \"230 mm\" }}\noil = {{ viscosity = \"10 mPa.s\" }}\n"
        );
        cycle(&oilwedge_study::parse(&text, std::path::Path::new("a.toml")).unwrap_or_else(|error| panic!("{error}")))
    };
    let pin = scene("pin", "{ order = 0, cos = { x = \"5 kN\" } }");
    let cylinder = scene("cylinder", "{ order = 1, cos = { x = \"5 kN\" }, sin = { y = \"5 kN\" } }");
    for angle in angles() {
        let (a, b) = (pin.at(angle), cylinder.at(angle));
        assert!((a.force[0] - b.force[0]).hypot(a.force[1] - b.force[1]) < 1e-12 * 5e3, "{angle}");
        assert!((a.moment[0] - 5e-3 * a.force[0]).abs() < 1e-12 && (a.moment[1] - 5e-3 * a.force[1]).abs() < 1e-12);
    }
    let half = scene("shell", "{ order = 0.5, sin = { x = \"1 kN\" } }");
    assert!((half.at(PI).force[0] - 1e3).abs() < 1e-9 && (half.at(3.0 * PI).force[0] + 1e3).abs() < 1e-9);
}

/// A table of the pressure in 2 degree steps is the formula of the shipped crank.
#[test]
fn gas_pressure_by_table_is_that_by_numbers() {
    let folder = tempfile::tempdir().expect("a folder");
    let crank = shipped("crank_big_end");
    let row = |k: u32| {
        let angle = f64::from(2 * k).to_radians();
        let pressure = 8.0 * (14.0 * ((0.5 * (angle - 12f64.to_radians())).cos() - 1.0)).exp();
        format!("{}, {pressure:e}\n", 2 * k)
    };
    let rows: String = (0..360).map(row).collect();
    std::fs::write(folder.path().join("gas.csv"), format!("angle [deg], p [MPa]\n{rows}")).expect("written");
    let numbers = "peak = \"8 MPa\", angle = \"12 deg\", sharpness = 14";
    assert!(crank.text.contains(numbers));
    let text = crank.text.replace(numbers, "file = \"gas.csv\"");
    let by_file = oilwedge_study::parse(&text, &folder.path().join("a.toml")).unwrap_or_else(|error| panic!("{error}"));
    let (by_file, by_numbers) = (cycle(&by_file), cycle(&crank));
    for angle in angles() {
        let (a, b) = (by_file.at(angle).force, by_numbers.at(angle).force);
        assert!((a[0] - b[0]).hypot(a[1] - b[1]) < 2e-6 * 8e4, "{angle}: {a:?} {b:?}");
    }
}
