//! Random shafts of one to four throws with random firing orders on the films of all their bearings; the same on every
//! run.

use std::path::{Path, PathBuf};

use oilwedge_bearing::Deadline;
use oilwedge_bearing::shaft::NoBalance;
use oilwedge_scene::ShaftScene;
use oilwedge_study::quantities::CYCLE_FILM_THICKNESS_MIN;
use oilwedge_study::result::Status;
use oilwedge_study::shaft::{ShaftResult, compile_shaft, engine, run_shaft};
use oilwedge_study::{Interrupt, RunOptions};

use oilwedge_tests::program::repository;
use oilwedge_tests::random_bearings::Dice;

/// Clearance of the bearings [m].
const CLEARANCE: f64 = 28e-6;
/// What the balances of force and moment, and the equations of all journals, may be off by at any step, over the loads
/// [1].
const BALANCED: f64 = 1e-8;

/// Eccentricity for which meshes of shafts at rest are graded.
const ECCENTRICITY: f64 = 0.93;
/// Most time of a search for a balance at rest [s].
pub const REST_SECONDS: f64 = 20.0;

/// The scene of the bearings of all random shafts, on a coarse mesh, in a `folder`: its path.
///
/// # Panics
/// The shipped scene cannot be read or has no journal, or the folder cannot be written.
pub fn bearing(folder: &Path) -> PathBuf {
    let shipped = repository().join("scenes/engines/bearings/main_56.toml");
    let text = std::fs::read_to_string(shipped).expect("a shipped scene");
    assert!(text.contains("[journal]"), "{text}");
    let path = folder.join("main.toml");
    std::fs::write(&path, text.replacen("[journal]", "[mesh]\nsize = \"9 mm\"\n\n[journal]", 1)).expect("a file");
    path
}

/// Shaft `number`, each throw between two mains that have the scene `bearing`: sizes, stiffness, firing angles and
/// loads are random.
pub fn scene(number: u64, bearing: &Path) -> String {
    let mut dice = Dice::new(12_000_000 + number);
    let throws = dice.between(1.0, 4.999) as usize;
    let diameter = dice.between(50.0, 56.0);
    let [journal, web, pin] = [[22.0, 40.0], [16.0, 30.0], [20.0, 40.0]].map(|[from, to]| dice.between(from, to));
    let (mut pieces, mut bearings, mut z) = (String::new(), String::new(), 0.0);
    for number in 0..=throws {
        pieces += &format!("{{ length = \"{journal} mm\", diameter = \"{diameter} mm\" }},");
        bearings += &format!(
            "{{ scene = \"{}\", at = \"{} mm\"{} }},",
            bearing.display(),
            z + 0.5 * journal,
            support(&mut dice)
        );
        z += journal + pin + 2.0 * web;
        if number < throws {
            pieces += &format!("{{ fires_at = \"{:.0} deg\" }},", dice.between(0.0, 719.0));
        }
    }
    let width = match dice.chance(0.2) {
        true => format!("web_width = \"{} mm\"", dice.between(70.0, 120.0)),
        false => String::new(),
    };
    format!(
        "[crankshaft]\nspeed = \"{} rpm\"\nyoungs_modulus = \"{} GPa\"\nshear_modulus = \"80 GPa\"\n\
         piece = [{pieces}]\nbearing = [{bearings}]\n\
         [crankshaft.throw]\npin_length = \"{pin} mm\"\npin_diameter = \"{} mm\"\nweb_thickness = \"{web} mm\"\n\
         web_mass = \"{} kg\"\n{width}\n\
         [crank]\nradius = \"43 mm\"\nrod_length = \"144 mm\"\nreciprocating_mass = \"{} kg\"\nrotating_mass = \"0.45 kg\"\n\
         bore = \"86 mm\"\ngas = {{ peak = \"{} MPa\", angle = \"12 deg\", sharpness = 14 }}\n\
         [orbit]\ntolerance = 1e-2\ncycles = 5\nclosure = 1e-2\n",
        dice.between(800.0, 7000.0),
        dice.between(150.0, 220.0),
        0.9 * diameter,
        dice.between(0.0, 2.0),
        dice.between(0.2, 1.0),
        dice.between(0.5, 6.0),
    )
}

/// A housing that gives way, at times.
fn support(dice: &mut Dice) -> String {
    match dice.chance(0.3) {
        true => format!(
            ", support = {{ stiffness = \"{} MN/m\", tilt_stiffness = \"20 kN.m/rad\" }}",
            dice.between(200.0, 2e3)
        ),
        false => String::new(),
    }
}

/// What is found of a `scene` within a time [s].
///
/// # Panics
/// The scene is refused.
pub fn solved(scene: &str, max_seconds: f64) -> ShaftResult {
    let read = ShaftScene::parse(scene, Path::new("random.toml")).unwrap_or_else(|error| panic!("{error}\n{scene}"));
    let options = RunOptions { bars: false, max_seconds, ..RunOptions::default() };
    run_shaft(&read, &options).unwrap_or_else(|error| panic!("{error}\n{scene}")).result
}

/// Crank angles [deg], of `count` even ones in a cycle, at which the films have no balance under the loads there if
/// these last; the second list has those at which a search takes longer than [`REST_SECONDS`].
///
/// # Panics
/// The scene is refused.
pub fn without_rest(scene: &str, count: u32) -> [Vec<f64>; 2] {
    let read = ShaftScene::parse(scene, Path::new("random.toml")).unwrap_or_else(|error| panic!("{error}\n{scene}"));
    let engine = engine(&read).unwrap_or_else(|error| panic!("{error}")).expect("throws");
    let compiled = compile_shaft(&read, ECCENTRICITY).unwrap_or_else(|error| panic!("{error}"));
    let mut lists = [Vec::new(), Vec::new()];
    for k in 0..count {
        let angle = read.crankshaft.period * f64::from(k) / f64::from(count);
        let asked = compiled.shaft.loads(&engine.loads(angle), angle);
        let deadline = Deadline::after(REST_SECONDS, Interrupt::default());
        match compiled.films().balance(&asked, angle, deadline) {
            Ok(_) => {}
            Err(NoBalance::Ended) => lists[1].push(angle.to_degrees()),
            Err(_) => lists[0].push(angle.to_degrees()),
        }
    }
    lists
}

/// What is wrong with an answer: neither closed nor explained, a journal in the wall, a balance that is off, or no
/// number.
pub fn fault(result: &ShaftResult) -> Option<String> {
    let quantities = result.bearings.iter().flat_map(|bearing| &bearing.quantities);
    if let Some(quantity) = quantities.into_iter().find(|quantity| !quantity.value.is_finite()) {
        return Some(format!("{} is {}", quantity.name, quantity.value));
    }
    if result.head.status != Status::Converged {
        return result.head.reason.is_none().then(|| "not converged, without a reason".to_owned());
    }
    let balances = result.balances;
    let off = [balances.force, balances.moment, balances.journals, balances.power.unwrap_or(f64::NAN)];
    if !off.iter().all(|off| *off < BALANCED) {
        return Some(format!("{balances:?}"));
    }
    match least_film(result) {
        Some(film) if film > 0.0 && film < CLEARANCE => None,
        film => Some(format!("the least film is {film:?}")),
    }
}

/// The least film of all bearings [m]; `None`: there are no numbers, or those of a bearing lack it.
pub fn least_film(result: &ShaftResult) -> Option<f64> {
    let films = result.bearings.iter().map(|bearing| Some(bearing.quantity(&CYCLE_FILM_THICKNESS_MIN)?.value));
    films.collect::<Option<Vec<f64>>>()?.into_iter().reduce(f64::min)
}
