//! The shaped bearings of `tests/data/shaped_bearings.json`, numbers of a second, independent code: scenes of them, and
//! tables of measured points.

use std::f64::consts::TAU;
use std::fmt::Write;
use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::journal_bearings::number;
use crate::program::repository;
use crate::tilted_bearings::{numbers, scene};

/// A block of the reference.
///
/// # Panics
/// If there is none of that name.
pub fn block(name: &str) -> Value {
    let path = repository().join("tests/data/shaped_bearings.json");
    let text = std::fs::read_to_string(path).expect("reference of shaped bearings");
    let data: Value = serde_json::from_str(&text).expect("reference is JSON");
    data.get(name).unwrap_or_else(|| panic!("no block {name}")).clone()
}

/// Depth over the clearance at an angle [rad] and a part of half of the length, of the profiles of the reference.
pub type Depth = fn(f64, f64) -> f64;

/// The table `[[bore]]` of a profile of the reference with a clearance of 50 um, and its depth.
///
/// # Panics
/// If it has another profile.
pub fn bore(profile: &str) -> (&'static str, Depth) {
    let worn = |phi: f64, _: f64| {
        let off = phi.sin().atan2(phi.cos()) / 40f64.to_radians();
        0.15 * (1.0 - off * off).max(0.0)
    };
    match profile {
        "crown 0.2" => ("crown = \"10 um\"", |_, part| 0.2 * part * part),
        "crown 0.1" => ("crown = \"5 um\"", |_, part| 0.1 * part * part),
        "oval 0.2 at 0" => ("oval = { depth = \"10 um\", angle = \"0 deg\" }", |phi, _| 0.2 * (2.0 * phi).cos()),
        "oval 0.3 at 60 deg" => ("oval = { depth = \"15 um\", angle = \"60 deg\" }", |phi, _| {
            0.3 * (2.0 * (phi - 60f64.to_radians())).cos()
        }),
        "worn 0.15 at 0, half width 40 deg" => {
            ("worn = { depth = \"7.5 um\", angle = \"0 deg\", half_width = \"40 deg\" }", worn)
        }
        other => panic!("no profile {other}"),
    }
}

/// The scene of a row of the reference with this table of its bore.
pub fn scene_of(row: &Value, tolerance: &str, bore: &str) -> String {
    let q = numbers(&row["q"]);
    let (eps, angle) = (q[0].hypot(q[1]), q[1].atan2(q[0]).to_degrees());
    let keys = format!(
        "eccentricity = {eps}\nmin_film_angle = \"{angle} deg\"\ntilt = {{ x = \"{} mrad\", y = \"{} mrad\" }}\n[[bore]]\n{bore}",
        q[2], q[3]
    );
    scene(number(row, "b"), tolerance, &keys)
}

/// Writes measured points of a bore of this length [m], `columns` around and `rows` along, of a clearance of 50 um.
///
/// # Panics
/// If the file cannot be written.
pub fn measured(path: &Path, length: f64, [columns, rows]: [u32; 2], depth: impl Fn(f64, f64) -> f64) -> PathBuf {
    let mut text = "angle [deg], z [mm], depth [um]\n".to_owned();
    for i in 0..columns {
        for j in 0..rows {
            let (phi, part) = (TAU * f64::from(i) / f64::from(columns), 2.0 * f64::from(j) / f64::from(rows - 1) - 1.0);
            let (angle, z) = (phi.to_degrees(), 500.0 * length * part);
            let _ = writeln!(text, "{angle}, {z}, {}", 50.0 * depth(phi, part));
        }
    }
    std::fs::write(path, text).expect("a table");
    path.to_owned()
}
