use std::f64::consts::PI;

use super::*;
use crate::scene::tests::{STUDY, read};
use crate::{Gas, PositionTable};

const CRANK: &str = "crank = { radius = \"62.5 mm\", rod_length = \"230 mm\", reciprocating_mass = \"3.43 kg\", \
    rotating_mass = \"2.025 kg\", bore = \"125 mm\", gas = { peak = \"8 MPa\", angle = \"12 deg\", sharpness = 14 } }\n";
const LINKAGE: &str = "crank = { radius = \"62.5 mm\", rod_length = \"230 mm\" }\n";
const FILE: &str = "load = { file = \"a.csv\", frame = \"shell\", period = \"720 deg\" }\n";
const STUDY_LOAD: &str = "load = { force = \"5 kN\", angle = \"270 deg\" }\n";
const BIG_END: &str = "load = { bearing = \"big-end\", period = \"720 deg\" }\n";
const HARMONICS: &str = "load = { frame = \"pin\", period = \"720 deg\", harmonics = [{ order = 0.5, cos = { x = \"1 kN\" } }, { order = 1, sin = { y = \"2 kN\" } }] }\n";

/// The study with a load over a cycle in place of its position.
fn text(tables: &str) -> String {
    tables.to_owned() + &STUDY.replacen(", eccentricity = 0.6, min_film_angle = \"180 deg\"", "", 1)
}

fn scene(tables: &str) -> Scene {
    read(&text(tables)).unwrap_or_else(|error| panic!("{tables}: {error}"))
}

/// The one complaint about the scene.
fn wrong(tables: &str, wanted: &str) {
    let error = read(&text(tables)).expect_err(wanted).to_string();
    assert!(error.contains(wanted) && error.lines().count() == 2, "{wanted}\n{error}");
}

#[test]
fn loads_over_a_cycle_are_read() {
    let from_file = scene(FILE);
    let cycle = from_file.load_cycle.expect("a cycle");
    assert_eq!(cycle.period, 4.0 * PI);
    let path = PathBuf::from("scenes/a.csv");
    let frame = LoadFrame::Shell;
    assert_eq!(cycle.source, LoadSource::File { path, frame });
    assert_eq!(from_file.journal.position, PositionTable::Cycle);
    assert!(from_file.crank.is_none() && from_file.journal.load().is_none());

    let harmonics = scene(HARMONICS).load_cycle.expect("a cycle");
    let LoadSource::Harmonics { orders, frame } = harmonics.source else { panic!("harmonics") };
    assert_eq!((frame, orders.len()), (LoadFrame::Pin, 2));
    assert_eq!((orders[0].order, orders[0].cos, orders[1].sin), (0.5, [1e3, 0.0], [0.0, 2e3]));

    assert_eq!(harmonics.frequency, None);
    let free = HARMONICS.replace("period = \"720 deg\"", "frequency = \"50 Hz\"");
    let free = free.replace("pin", "shell").replace("0.5", "2");
    let at_rest = text(&free).replacen("3000 rpm", "0 rpm", 1);
    let cycle = read(&at_rest).expect("a scene").load_cycle.expect("a cycle");
    assert_eq!((cycle.period, cycle.frequency), (2.0 * PI, Some(100.0 * PI)));

    let of_crank = scene(&format!("{BIG_END}{CRANK}"));
    let crank = of_crank.crank.expect("a crank");
    let drive = crank.drive.expect("a drive");
    assert_eq!((crank.radius, crank.rod_length, drive.bore), (0.0625, 0.23, 0.125));
    assert!(matches!(drive.gas, Gas::Peak { sharpness: 14.0, .. }));
    let turning = scene(&format!("{}{LINKAGE}", FILE.replace("shell", "cylinder")));
    assert!(turning.crank.is_some_and(|crank| crank.drive.is_none()));
    let gas = CRANK.replace("peak = \"8 MPa\", angle = \"12 deg\", sharpness = 14", "file = \"gas.csv\"");
    let by_file = scene(&format!("{BIG_END}{gas}")).crank.expect("a crank");
    assert_eq!(by_file.gas_file(), Some(Path::new("scenes/gas.csv")));
}

#[test]
fn loads_over_a_cycle_are_checked() {
    let file = |from: &str, to: &str| FILE.replacen(from, to, 1);
    wrong(&file("720 deg", "180 deg"), "load.period: is neither one turn of the crank nor two");
    wrong(&file(", period = \"720 deg\"", ""), "load.period: is missing");
    wrong(&file(", frame = \"shell\"", ""), "load.frame: is missing");
    let free = |from: &str, to: &str| {
        let free = FILE.replace("period = \"720 deg\"", "frequency = \"50 Hz\"");
        free.replace(from, to)
    };
    wrong(&free("50 Hz", "0 Hz"), "load.frequency: is not positive");
    wrong(&free("frequency", "period = \"720 deg\", frequency"), "load.frequency: stands beside period");
    wrong(&free("shell", "pin"), "load.frame: is that of a crank, but the load repeats");
    wrong(&format!("{}{LINKAGE}", free("", "")), "load.frequency: stands beside [crank]");
    wrong(
        &format!("{}{CRANK}", BIG_END.replace("period", "frequency = \"50 Hz\", period")),
        "load.frequency: stands beside bearing",
    );
    wrong(
        &STUDY_LOAD.replace("force", "frequency = \"50 Hz\", force"),
        "load.frequency: has a meaning for a load over a cycle only",
    );
    wrong(&file("shell", "rod"), "load.frame: \"rod\" is not known");
    wrong(&file("shell", "cylinder"), "load.frame: is \"cylinder\", but without [crank]");
    wrong(&file("frame", "force = \"5 kN\", frame"), "load.force: stands beside file");
    wrong(
        &file("frame", "moment = { x = \"5 N.m\" }, frame"),
        "load.moment: stands beside file, by which the load changes over a cycle (remove moment; a table",
    );
    wrong(&file("frame", "harmonics = [], frame"), "load.harmonics: stands beside file");
    wrong(&format!("{FILE}{CRANK}").replace(", rotating_mass = \"2.025 kg\", bore = \"125 mm\", gas = { peak = \"8 MPa\", angle = \"12 deg\", sharpness = 14 }", ""), "crank.reciprocating_mass: has no effect, since the load is given");
    wrong(BIG_END, "load.bearing: is computed from [crank], which is missing");
    wrong(&format!("{}{CRANK}", BIG_END.replace("big-end", "small-end")), "load.bearing: \"small-end\" is not known");
    let crank = |from: &str, to: &str| format!("{BIG_END}{}", CRANK.replacen(from, to, 1));
    wrong(&crank("62.5 mm", "230 mm"), "crank.radius: is not less than rod_length");
    wrong(&crank("bore = \"125 mm\", ", ""), "crank.bore: is missing");
    wrong(&crank(", sharpness = 14", ""), "crank.gas.sharpness: is missing");
    wrong(&crank("sharpness = 14", "sharpness = 0"), "crank.gas.sharpness: is not positive");
    wrong(&crank("rotating_mass = \"2", "rotating_mass = \"-2"), "crank.rotating_mass: is negative");
    wrong(
        &crank("peak", "file = \"a.csv\", peak").replace(", angle = \"12 deg\", sharpness = 14", ""),
        "crank.gas.peak: stands beside file",
    );
    wrong(&HARMONICS.replace("0.5", "0.3"), "load.harmonics[0].order: makes no whole number of cycles");
    wrong(&HARMONICS.replace("720", "360"), "load.harmonics[0].order: makes no whole number of cycles");
    wrong(&HARMONICS.replace("0.5", "-1"), "load.harmonics[0].order: is negative");
    let journal = |tables: &str, from: &str, to: &str, wanted: &str| {
        let error = read(&text(tables).replacen(from, to, 1)).expect_err(wanted).to_string();
        assert!(error.contains(wanted) && error.lines().count() == 2, "{wanted}\n{error}");
    };
    journal(FILE, "3000 rpm", "0 rpm", "journal.speed: is zero");
    journal(
        FILE,
        "speed = \"3000 rpm\"",
        "speed = \"3000 rpm\", tilt_rate = { x = \"1 rad/s\" }",
        "journal.tilt_rate: stands beside",
    );
    journal(
        FILE,
        "speed = \"3000 rpm\"",
        "speed = \"3000 rpm\", eccentricity = 0.5",
        "journal.eccentricity: stands beside [load]",
    );
}

#[test]
fn main_bearings_have_throws() {
    let main = |throws: &str| {
        format!("{}{}", BIG_END.replace("big-end", "main"), CRANK.replace(" }\n", &format!("{throws} }}\n")))
    };
    let throws = ", throws = [{ share = 0.5 }, { share = 0.25, angle = \"360 deg\", web_mass = \"-1 kg\" }]";
    let crank = scene(&main(throws)).crank.and_then(|crank| crank.drive).expect("a drive");
    assert_eq!(crank.throws.len(), 2);
    assert_eq!((crank.throws[0].angle, crank.throws[0].share, crank.throws[0].web_mass), (0.0, 0.5, 0.0));
    assert_eq!((crank.throws[1].angle, crank.throws[1].web_mass), (2.0 * PI, -1.0));
    wrong(&main(""), "crank.throws: is missing");
    wrong(&main(", throws = []"), "crank.throws: is empty");
    wrong(&main(", throws = [{}]"), "crank.throws[0].share: is missing");
    wrong(&main(&throws.replace("0.25", "1.25")), "crank.throws[1].share: is not above 0 and at most 1");
    wrong(&main(throws).replace("main", "big-end"), "crank.throws: has a meaning for a main bearing only");
}

#[test]
fn keys_of_a_cycle_stand_with_a_cycle() {
    let load = "load = { force = \"5 kN\", angle = \"0 deg\" }\n";
    wrong(&format!("{load}{LINKAGE}"), "crank: has a meaning for a load over a cycle only");
    wrong(&load.replace("force", "frame = \"pin\", force"), "load.frame: has a meaning for a load over a cycle only");
    wrong("load = { angle = \"0 deg\" }\n", "load.force: is missing");
}

/// A file that is not there is reported as one of meshes is.
#[test]
fn tables_must_be_there() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("scene.toml");
    let text = text(FILE).replace("mesh = { file = \"../meshes/shell.msh\", unit = \"mm\" }", "");
    std::fs::write(&path, text).expect("written");
    let error = Scene::read(&path, &[]).expect_err("no table").to_string();
    assert!(error.contains("load.file: there is no file") && error.lines().count() == 2, "{error}");
    std::fs::write(folder.path().join("a.csv"), "").expect("written");
    assert!(Scene::read(&path, &[]).is_ok());
}
