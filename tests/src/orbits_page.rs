//! The page `docs/validation/orbits.md`: the synthetic big end of scene 27 against structured finite volumes and a closed film, and its orbits by maps.

use oilwedge_study::orbit::by_maps;
use oilwedge_study::quantities::{
    CYCLE_FILM_THICKNESS_MIN, CYCLE_FILM_THICKNESS_MIN_CRANK_ANGLE, CYCLE_FRICTION_SHEAR_POWER, CYCLE_POWER_LOSS,
    CYCLE_PRESSURE_MAX, CYCLE_PRESSURE_MAX_CRANK_ANGLE, Row,
};
use oilwedge_study::{Run, RunOptions, parse, run};

use crate::scenes::path;
use crate::tables::{replace, row};

/// A number of both lands by a second code: quantity, factor from SI and of one land to the unit here, name with the unit, digits, the number.
type Known = (&'static Row, f64, &'static str, usize, f64);

/// Swift and Stieber: finite volumes on 240 x 12 and 480 x 24 cells a land, extrapolated.
pub const FINITE: [Known; 6] = [
    (&CYCLE_FILM_THICKNESS_MIN, 1e6, "least film [um]", 4, 5.7389),
    (
        &CYCLE_FILM_THICKNESS_MIN_CRANK_ANGLE,
        1.0,
        "its crank angle [deg]",
        2,
        256.86,
    ),
    (&CYCLE_PRESSURE_MAX, 1e-6, "greatest pressure [MPa]", 3, 43.739),
    (&CYCLE_PRESSURE_MAX_CRANK_ANGLE, 1.0, "its crank angle [deg]", 2, 17.27),
    (&CYCLE_FRICTION_SHEAR_POWER, 2.0, "shear [W]", 2, 1140.17),
    (&CYCLE_POWER_LOSS, 2.0, "heat [W]", 2, 1242.98),
];
/// The short half film by quadrature, integrated to 1e-10.
pub const SHORT: [Known; 6] = [
    (&CYCLE_FILM_THICKNESS_MIN, 1e6, "least film [um]", 4, 7.194337),
    (
        &CYCLE_FILM_THICKNESS_MIN_CRANK_ANGLE,
        1.0,
        "its crank angle [deg]",
        2,
        257.31,
    ),
    (&CYCLE_PRESSURE_MAX, 1e-6, "greatest pressure [MPa]", 3, 48.2473),
    (&CYCLE_PRESSURE_MAX_CRANK_ANGLE, 1.0, "its crank angle [deg]", 2, 18.211),
    (&CYCLE_FRICTION_SHEAR_POWER, 2.0, "shear [W]", 2, 1058.34),
    (&CYCLE_POWER_LOSS, 2.0, "heat [W]", 2, 1160.98),
];
/// What makes the shipped scene a short one that is sharp enough for its reference.
pub const MAKE_SHORT: [(&str, &str); 4] = [
    (
        "clearance = \"82.55 um\"",
        "clearance = \"82.55 um\"\ntheory = \"short\"",
    ),
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

/// The page with its tables computed anew.
///
/// # Panics
/// A scene has no orbit.
pub fn page(page: &str) -> String {
    let scene = changed(&[]);
    let of = |scene: &oilwedge_scene::Scene| run(scene, &RunOptions::of(scene)).expect("an orbit");
    let (finite, short) = (of(&scene), of(&changed(&MAKE_SHORT)));
    let page = replace(page, "finite", &table(&finite, &FINITE));
    let page = replace(&page, "short", &table(&short, &SHORT));
    let mut maps = vec![row(["map", "least film [um]", "its crank angle [deg]", "films"])];
    for by in by_maps(&scene, finite.orbit.as_ref().expect("a path")).expect("a film") {
        let by = by.unwrap_or_else(|reason| panic!("{reason}"));
        let value = |row: &Row| by.quantities.iter().find(|it| it.row == row).expect("a number").value;
        maps.push(vec![
            by.name.to_owned(),
            format!("{:.4}", 1e6 * value(&CYCLE_FILM_THICKNESS_MIN)),
            format!("{:.2}", value(&CYCLE_FILM_THICKNESS_MIN_CRANK_ANGLE)),
            by.films.to_string(),
        ]);
    }
    replace(&page, "maps", &maps)
}

fn table(found: &Run, known: &[Known]) -> Vec<Vec<String>> {
    let mut rows = vec![row(["number", "reference", "found", "bar", "difference"])];
    for (row, factor, name, digits, reference) in known {
        let quantity = found.result.quantity(row).expect(row.name);
        let value = factor * quantity.value;
        let bar = quantity
            .error()
            .map_or("-".to_owned(), |bar| format!("{:.*}", *digits, factor * bar));
        let difference = match name.contains("[deg]") {
            true => format!("{:.2} deg", value - reference),
            false => format!("{:.3} %", 100.0 * (value / reference - 1.0)),
        };
        rows.push(vec![
            (*name).to_owned(),
            reference.to_string(),
            format!("{value:.digits$}", digits = *digits),
            bar,
            difference,
        ]);
    }
    rows
}
