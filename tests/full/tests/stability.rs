//! The map of stability: its cells, and its picture.

use oilwedge_full::stability::map::{MOST_UNKNOWNS, Recipe, cell, recipe};
use oilwedge_full::stability::map_picture::{CellMap, Outcome, cells_figure};
use oilwedge_verification::answer::{limit, solve_within, with_law};
use oilwedge_verification::cases::put;
use toml::Value;

#[test]
fn cells_are_explained_on_their_side_of_the_limit() {
    let Recipe { mut scene, limited, .. } = recipe();
    put(&mut scene, "journal.eccentricity", Value::Float(0.7));
    let alpha = limit(&scene, &limited).expect("a film");
    let at = |part: f64| solve_within(&with_law(&scene, part * alpha, &limited), MOST_UNKNOWNS);
    let (below, beyond) = (at(0.5), at(2.0));
    assert!(matches!(cell(&below, false), Outcome::Answer(1..)));
    assert!(matches!(cell(&beyond, true), Outcome::Absent(_)));
    // On the wrong side both would be grey.
    assert!(matches!(cell(&below, true), Outcome::Unexplained(_)));
    assert!(matches!(cell(&beyond, false), Outcome::Unexplained(_)));
}

#[test]
fn every_cell_is_drawn_with_its_word() {
    let map = CellMap {
        title: "A map".into(),
        x: "eccentricity".into(),
        columns: vec!["0.1".into(), "0.9".into()],
        y: "slenderness".into(),
        rows: vec!["1".into(), "2".into()],
        cells: vec![
            vec![Outcome::Answer(7), Outcome::Absent("limit".into())],
            vec![Outcome::Answer(23), Outcome::Unexplained("?".into())],
        ],
    };
    let figure = cells_figure(&[map.clone(), map]);
    let svg = figure.to_svg();
    for word in ["A map", "eccentricity", "slenderness", "\n7\n", "\nlimit\n", "\n23\n", "\n?\n"] {
        assert!(svg.contains(word), "no {word:?} in {svg}");
    }
    assert!(figure.to_png().is_ok());
}
