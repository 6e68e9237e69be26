//! The synthetic big end of scene 27: reference numbers of structured finite volumes and of a closed film.

use oilwedge_study::parse;
use oilwedge_study::quantities::{
    CYCLE_FILM_THICKNESS_MIN, CYCLE_FILM_THICKNESS_MIN_CRANK_ANGLE, CYCLE_FRICTION_SHEAR_POWER, CYCLE_POWER_LOSS,
    CYCLE_PRESSURE_MAX, CYCLE_PRESSURE_MAX_CRANK_ANGLE, Row,
};

use crate::scenes::path;

/// A number of both lands by a second code: quantity, factor from SI and of one land to the unit here, name with the
/// unit, digits, the number.
pub type Known = (&'static Row, f64, &'static str, usize, f64);

/// Swift and Stieber: finite volumes on 240 x 12 and 480 x 24 cells a land, extrapolated.
pub const FINITE: [Known; 6] = [
    (&CYCLE_FILM_THICKNESS_MIN, 1e6, "least film [um]", 4, 5.7389),
    (&CYCLE_FILM_THICKNESS_MIN_CRANK_ANGLE, 1.0, "its crank angle [deg]", 2, 256.86),
    (&CYCLE_PRESSURE_MAX, 1e-6, "greatest pressure [MPa]", 3, 43.739),
    (&CYCLE_PRESSURE_MAX_CRANK_ANGLE, 1.0, "its crank angle [deg]", 2, 17.27),
    (&CYCLE_FRICTION_SHEAR_POWER, 2.0, "shear [W]", 2, 1140.17),
    (&CYCLE_POWER_LOSS, 2.0, "heat [W]", 2, 1242.98),
];
/// The short half film by quadrature, integrated to 1e-10.
pub const SHORT: [Known; 6] = [
    (&CYCLE_FILM_THICKNESS_MIN, 1e6, "least film [um]", 4, 7.194337),
    (&CYCLE_FILM_THICKNESS_MIN_CRANK_ANGLE, 1.0, "its crank angle [deg]", 2, 257.31),
    (&CYCLE_PRESSURE_MAX, 1e-6, "greatest pressure [MPa]", 3, 48.2473),
    (&CYCLE_PRESSURE_MAX_CRANK_ANGLE, 1.0, "its crank angle [deg]", 2, 18.211),
    (&CYCLE_FRICTION_SHEAR_POWER, 2.0, "shear [W]", 2, 1058.34),
    (&CYCLE_POWER_LOSS, 2.0, "heat [W]", 2, 1160.98),
];
/// What makes the shipped scene a short one that is sharp enough for its reference.
pub const MAKE_SHORT: [(&str, &str); 4] = [
    ("clearance = \"82.55 um\"", "clearance = \"82.55 um\"\ntheory = \"short\""),
    ("\"reynolds\"", "\"guembel\""),
    ("tolerance = 1e-3", "tolerance = 1e-4"),
    ("[orbit]", "[mesh]\nsize = \"12 mm\"\n\n[orbit]"),
];

/// The shipped scene of the big end with its text changed.
///
/// # Panics
/// It has no such text, or is no scene then.
pub fn changed(changes: &[(&str, &str)]) -> oilwedge_scene::Scene {
    let path = path("27_big_end_orbit");
    let text = std::fs::read_to_string(&path).expect("a scene");
    let text = changes.iter().fold(text, |text, (from, to)| {
        assert!(text.contains(from), "no {from}");
        text.replace(from, to)
    });
    parse(&text, &path).unwrap_or_else(|error| panic!("{error}"))
}
