//! The shaft as it is bent between its journals.

use oilwedge_report::json;
use oilwedge_study::quantities::{ECCENTRICITY, LOAD_X, LOAD_Y, MIN_FILM_ANGLE};
use oilwedge_tests::crankshafts::*;

const LENGTH: f64 = 0.4;
/// E I [N m2] of the shaft of `three_films.toml`.
const BENDING: f64 = 206e9 * std::f64::consts::PI / 64.0 * 0.06 * 0.06 * 0.06 * 0.06;

/// Deflection at z of a beam on two supports at its ends under a force at a (S. P. Timoshenko, Strength of Materials I,
/// 1930, art. 34).
fn sag(force: f64, a: f64, z: f64) -> f64 {
    let (b, z) = if z <= a { (LENGTH - a, z) } else { (a, LENGTH - z) };
    force * b * z * (LENGTH * LENGTH - b * b - z * z) / (6.0 * LENGTH * BENDING)
}

/// Two films that resist no tilt, the shell of the left one on a soft housing, under 12 kN downwards in the middle and
/// 1 kN towards x beside it.
#[test]
fn the_line_of_a_shaft_on_two_films_is_that_of_a_simply_supported_beam_between_its_journals() {
    let scene = two_films_with("youngs_modulus = \"206 GPa\"\ntilt = \"none\"");
    let scene = changed(&scene, "at    = \"100 mm\"", "at    = \"200 mm\"");
    let scene = changed(&scene, "force = \"1 kN\"\nangle = \"270 deg\"", "force = \"1 kN\"\nangle = \"0 deg\"");
    let scene = changed(&scene, "at    = \"0 mm\"", "at    = \"0 mm\"\nsupport = { stiffness = \"200 MN/m\" }");
    let run = run(&scene);
    let text = json(&run.result).expect("numbers");
    let line = &serde_json::from_str::<serde_json::Value>(&text).expect("JSON")["deflection"];
    let list = |key: &str| -> Vec<f64> {
        let numbers = line[key].as_array().expect(key).iter();
        numbers.map(|number| number.as_f64().expect("a number")).collect()
    };
    let [z, x, y] = ["z", "x", "y"].map(list);
    // The right one carries more.
    assert!(line["crank_angle_deg"].is_null() && line["bearing"] == "right", "{line}");
    let load = [&LOAD_X, &LOAD_Y].map(|row| numbers(&run, row)[1]);
    let off = [0, 1].map(|k: usize| line["force"][k].as_f64().expect("a force") - load[k]);
    assert!(off.iter().all(|off| off.abs() < 1e-6), "{off:?}");

    // At its ends the line is where the journals are: their offsets in the films, and what the shells give way.
    let offsets = numbers(&run, &ECCENTRICITY).into_iter().zip(numbers(&run, &MIN_FILM_ANGLE));
    let ends = offsets.zip([0, z.len() - 1]).enumerate().map(|(bearing, ((offset, angle), end))| {
        let shell = |k: usize| line["shells"][bearing][k].as_f64().expect("a shell");
        let (sin, cos) = angle.to_radians().sin_cos();
        let journal = [cos, sin].map(|part| CLEARANCE * offset * part);
        let journal = [journal[0] + shell(0), journal[1] + shell(1)];
        let apart = (x[end] - journal[0]).hypot(y[end] - journal[1]);
        assert!(apart < 1e-9 * CLEARANCE, "{bearing}: {apart:e} m");
        journal
    });
    let [left, right] = <[[f64; 2]; 2]>::try_from(ends.collect::<Vec<_>>()).expect("two bearings");
    let housing = line["shells"][0][1].as_f64().expect("a shell");
    assert!((housing / (-6e3 / 200e6) - 1.0).abs() < 1e-6 && line["shells"][1][1] == 0.0, "{line}");

    // The middle sinks by F L^3/(48 E I) against the mean of the journals, and the line is bent as the handbook says.
    let most = 12e3 * LENGTH.powi(3) / (48.0 * BENDING);
    let middle = z.iter().position(|z| *z == 0.2).expect("the place of the load");
    assert!((y[middle] - 0.5 * (left[1] + right[1]) + most).abs() < 1e-9 * most, "{} {most}", y[middle]);
    assert!(z[0] == 0.0 && z[z.len() - 1] == LENGTH && z.windows(2).all(|pair| pair[0] < pair[1]), "{z:?}");
    assert!(z.len() > 20);
    for ((z, x), y) in z.iter().zip(x).zip(y) {
        let straight = [0, 1].map(|k: usize| left[k] + (right[k] - left[k]) * z / LENGTH);
        let off = [x - straight[0] - sag(1e3, 0.22, *z), y - straight[1] + sag(12e3, 0.2, *z)];
        assert!(off.iter().all(|off| off.abs() < 1e-9 * most), "z = {z}: {off:?} of {most}");
    }
}

#[test]
fn a_shaft_that_is_cut_has_no_line() {
    assert!(by_statics()[0].result.deflection.is_some() && by_statics()[1].result.deflection.is_none());
}
