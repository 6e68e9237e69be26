//! The page `docs/validation/orbits.md`: the synthetic big end of scene 27 against structured finite volumes and a
//! closed film, and its orbits by maps.

use oilwedge_study::orbit::by_maps;
use oilwedge_study::quantities::{CYCLE_FILM_THICKNESS_MIN, CYCLE_FILM_THICKNESS_MIN_CRANK_ANGLE, Row};
use oilwedge_study::{Run, RunOptions, compile, run};
use oilwedge_tests::big_end::{FINITE, Known, MAKE_SHORT, SHORT, changed};

use crate::tables::{replace, row};

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
    for by in by_maps(&compile(&scene).expect("a model"), finite.orbit.as_ref().expect("a path")).expect("a film") {
        let by = by.unwrap_or_else(|reason| panic!("{reason}"));
        let value = |row: &Row| by.quantities.iter().find(|it| it.row == row).expect("a number").value;
        maps.push(vec![
            by.map.clone(),
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
        let bar = quantity.error().map_or("-".to_owned(), |bar| format!("{:.*}", *digits, factor * bar));
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
