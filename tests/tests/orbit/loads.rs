//! Loads in several frames, turned and mirrored: the orbit must follow.

use std::f64::consts::{FRAC_PI_2, TAU};
use std::path::Path;
use std::sync::Arc;

use oilwedge_bearing::Deadline;
use oilwedge_bearing::duty_cycle::{DutyCycle, ForceAxes, Harmonic, Linkage, Turning};
use oilwedge_bearing::orbit::{Motion, Orbit, OrbitOptions};
use oilwedge_reynolds::terms::squeeze::Squeeze;
use oilwedge_reynolds::{Cavitation, Gap};
use oilwedge_study::{RunOptions, parse, run};
use oilwedge_tests::*;

const RADIUS_OF_CRANK: f64 = 0.06;
const ROD_LENGTH: f64 = 0.2;

/// A short bearing whose load is a table; `FILE` and `FRAME` are to be filled in.
const SCENE: &str = r#"
bearing = { diameter = "50 mm", length = "25 mm", clearance = "30 um", theory = "short" }
mesh.size = "6 mm"
journal.speed = "3000 rpm"
oil.viscosity = "10 mPa.s"
cavitation.model = "guembel"
crank = { radius = "60 mm", rod_length = "200 mm" }
load = { file = "FILE", frame = "FRAME", period = "360 deg" }
orbit = { tolerance = 1e-2, cycles = 2 }
"#;

/// One load, written in the axes of the shell, of the cylinder and of the pin: offsets of the journal over a cycle
/// agree to 1e-9 of the clearance.
#[test]
fn a_load_given_in_three_frames_has_one_orbit() {
    let folder = tempfile::tempdir().expect("a folder");
    for sense in [1.0, -1.0] {
        let turning = Turning {
            speed: sense * 3000.0 * TAU / 60.0,
            rod: Some(Linkage { radius: RADIUS_OF_CRANK, rod_length: ROD_LENGTH }),
        };
        let path_of = |frame: ForceAxes, name: &str| {
            let mut table = "angle [deg], Fx [N], Fy [N]\n".to_owned();
            for degrees in (0..360).step_by(15) {
                let angle = f64::from(degrees).to_radians();
                let in_shell = [3000.0 + 2000.0 * angle.cos(), 1500.0 * angle.sin()];
                let [x, y] = turning.from_shell(in_shell, frame, angle);
                table += &format!("{degrees}, {x:?}, {y:?}\n");
            }
            let file = folder.path().join(format!("{name}{sense}.csv"));
            std::fs::write(&file, table).expect("a table");
            let file = file.to_str().expect("a name").replace('\\', "/");
            let text = SCENE.replace("FILE", &file).replace("FRAME", name);
            let text = text.replace("3000 rpm", &format!("{} rpm", 3000.0 * sense));
            let scene = parse(&text, Path::new("a.toml")).unwrap_or_else(|error| panic!("{error}"));
            let options = RunOptions { bars: false, ..RunOptions::default() };
            run(&scene, &options).expect("an orbit").orbit.expect("a path")
        };
        let [shell, cylinder, pin] =
            [(ForceAxes::Shell, "shell"), (ForceAxes::Cylinder, "cylinder"), (ForceAxes::Pin, "pin")]
                .map(|(frame, name)| path_of(frame, name));
        for other in [cylinder, pin] {
            let off = (0..360).map(|angle| {
                let [a, b] = [&shell, &other].map(|path| path.place(f64::from(angle)).expect("a place"));
                (a[0] - b[0]).hypot(a[1] - b[1]) / shell.clearance
            });
            let off = off.fold(0.0, f64::max);
            assert!(off < 1e-9, "{sense}: {off}");
        }
    }
}

/// A moment in the table acts where the tilt is free, and is refused where it is given.
#[test]
fn a_moment_in_the_table_tilts_the_journal_or_is_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("load.csv");
    let rows = (0..360).step_by(30).map(|angle| {
        let theta = f64::from(angle).to_radians();
        format!("{angle}, 3000, {}, {}, 0\n", 1000.0 * theta.sin(), 2.0 * theta.cos())
    });
    let table = "angle [deg], Fx [N], Fy [N], Mx [N.m], My [N.m]\n".to_owned() + &rows.collect::<String>();
    std::fs::write(&file, table).expect("a table");
    let file = file.to_str().expect("a name").replace('\\', "/");
    let text = SCENE.replace("FILE", &file).replace("FRAME", "shell").replace("load = {", "load = { KEY");
    let found = |key: &str| {
        let scene = parse(&text.replace("KEY", key), Path::new("a.toml")).unwrap_or_else(|error| panic!("{error}"));
        let options = RunOptions { bars: false, ..RunOptions::default() };
        run(&scene, &options)
    };
    let refused = found("").expect_err("the tilt is given").to_string();
    assert!(refused.contains("columns Mx and My") && refused.contains("load.at"), "{refused}");
    let tilted = found("at = \"0 mm\",").expect("an orbit").orbit.expect("a path");
    let [.., z_x, _] = tilted.place(0.0).expect("a place");
    assert!(z_x.abs() > 1e-3 * tilted.clearance, "{z_x}");
}

/// An orbit of a film by Swift and Stieber under a load of two orders whose parts are given by `turned`, at this speed.
fn orbit(turned: &dyn Fn([f64; 2]) -> [f64; 2], speed: f64) -> Orbit {
    let mut problem = plain_film(RADIUS, 0.0, 0.0, speed);
    problem.terms.push(Arc::new(Squeeze));
    problem.cavitation = Cavitation::Reynolds { pressure: 0.0 };
    let system = ring_system(24, 4, RADIUS, None);
    let unit = pressure_scale() * RADIUS * RADIUS;
    let force = |force: [f64; 2]| {
        let [x, y] = turned(force).map(|part| unit * part);
        [x, y, 0.0, 0.0]
    };
    let of = |order: f64, cos: [f64; 2], sin: [f64; 2]| Harmonic { order, cos: force(cos), sin: force(sin) };
    let orders = vec![of(0.0, [0.5, 0.1], [0.0; 2]), of(1.0, [0.3, 0.0], [0.0, 0.4])];
    let turning = Turning { speed, rod: None };
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
        OrbitOptions { tolerance: 1e-2, closure: 0.0, cycles: 1, deadline: Deadline::default(), observer: None };
    let [x, y] = turned([0.2 * CLEARANCE, 0.1 * CLEARANCE]);
    motion.orbit([x, y, 0.0, 0.0], &options).expect("an orbit")
}

type Image<'a> = &'a dyn Fn([f64; 2]) -> [f64; 2];

/// The mesh is its own image under quarter turns and in the axis x; a mirrored journal turns in the other sense.
#[test]
fn turned_and_mirrored_loads_turn_and_mirror_the_orbit() {
    let as_it_is = orbit(&|force| force, SPEED);
    let (sin, cos) = FRAC_PI_2.sin_cos();
    let turned = |[x, y]: [f64; 2]| [cos * x - sin * y, sin * x + cos * y];
    let mirrored = |[x, y]: [f64; 2]| [x, -y];
    let images: [(Image, f64); 2] = [(&turned, SPEED), (&mirrored, -SPEED)];
    for (image, speed) in images {
        let other = orbit(image, speed);
        assert_eq!(as_it_is.steps.len(), other.steps.len());
        for (a, b) in as_it_is.steps.iter().zip(&other.steps) {
            let [x, y] = image([a.at[0], a.at[1]]);
            let off = (x - b.at[0]).hypot(y - b.at[1]) / CLEARANCE;
            assert!(off < 1e-9 && (a.time - b.time).abs() < 1e-9 / SPEED, "{off}");
        }
    }
}
