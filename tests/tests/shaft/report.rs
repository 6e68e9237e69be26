//! Pages of crankshafts, and shafts beside each other.

use std::path::Path;

use oilwedge_report::page::shaft_page;
use oilwedge_report::shaft::write_shaft;
use oilwedge_report::shaft_view::ShaftViews;
use oilwedge_study::shaft::{ShaftRun, Variant};
use oilwedge_tests::crankshafts::*;

/// What people see of a page: JSON rounds the numbers behind cells in their last digit when it is read.
fn shown(page: &str) -> String {
    let mut parts = page.split("<data value=\"");
    let first = parts.next().unwrap_or_default().to_owned();
    let rests = parts.filter_map(|part| Some(part.split_once('>')?.1));
    rests.fold(first, |shown, rest| shown + rest)
}

/// The page of an engine shows all bearings and the cut shaft beside it, from the runs and from the files in a folder.
pub(super) fn shows_all_bearings_and_the_cut_shaft(folder: &Path, whole: &ShaftRun, cut: ShaftRun) {
    let beside = [(Variant::Cut, cut)];
    let views = ShaftViews::of_runs(whole, &beside).expect("views");
    let page = shaft_page(&views).expect("a page");
    for part in [
        "main 1</td>",
        "main 4</td>",
        "Beside the shaft cut at its bearings",
        "id=\"figure-shaft_loads\"",
        "id=\"figure-shaft_orbits\"",
        "id=\"figure-shaft_films\"",
        "id=\"figure-cut_films\"",
        "Design criteria",
        ">pass<",
        "oilwedge solve scene.toml --report --bars none --cut",
    ] {
        assert!(page.contains(part), "no {part}");
    }
    // The folder has all that the page shows.
    write_shaft(folder, whole, &beside).expect("files");
    let from_files = ShaftViews::read(folder).expect("views");
    assert_eq!(from_files.own.courses, views.own.courses);
    let again = shaft_page(&from_files).expect("a page");
    assert!(shown(&again) == shown(&page));
    // A run without the cut shaft leaves none behind.
    write_shaft(folder, whole, &[]).expect("files");
    assert!(ShaftViews::read(folder).expect("views").beside.is_empty());
}

#[test]
fn the_page_of_a_shaft_at_rest_has_its_balances_and_no_courses() {
    let whole = run(&text("three_films.toml"));
    let views = ShaftViews::of_runs(&whole, &[]).expect("views");
    let page = shaft_page(&views).expect("a page");
    for part in ["middle</td>", "load towards", "Balances", "The shaft"] {
        assert!(page.contains(part), "no {part}");
    }
    assert!(!page.contains("figure-shaft_orbits"));
}
