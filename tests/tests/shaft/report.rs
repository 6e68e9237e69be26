//! Pages of crankshafts, and shafts beside each other.

use oilwedge_report::page::shaft_page;
use oilwedge_report::shaft::write_shaft;
use oilwedge_report::shaft_view::ShaftViews;
use oilwedge_scene::ShaftScene;
use oilwedge_study::RunOptions;
use oilwedge_study::quantities::CYCLE_LOAD_MAX;
use oilwedge_study::result::Status;
use oilwedge_study::shaft::{Variant, run_cut};
use oilwedge_tests::crankshafts::*;

/// The three throws with coarse films, as a scene that is written to a folder.
fn coarse(folder: &std::path::Path) -> String {
    let mesh = "[mesh]\nsize = \"9 mm\"\n\n[criteria]\nfilm_min = \"1 um\"\n\n[journal]";
    let scene = with_bearing(folder, "main_85", ("[journal]", mesh), &text("three_throws.toml"));
    changed(&scene, "tolerance = 1e-3", "tolerance = 2e-2")
}

/// What people see of a page: JSON rounds the numbers behind cells in their last digit when it is read.
fn shown(page: &str) -> String {
    let mut parts = page.split("<data value=\"");
    let first = parts.next().unwrap_or_default().to_owned();
    let rests = parts.filter_map(|part| Some(part.split_once('>')?.1));
    rests.fold(first, |shown, rest| shown + rest)
}

#[test]
fn the_page_of_a_shaft_shows_all_bearings_and_the_cut_shaft_beside_it() {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = coarse(folder.path());
    let whole = run(&scene);
    let options = RunOptions {
        bars: false,
        max_seconds: f64::INFINITY,
        ..RunOptions::default()
    };
    let read = ShaftScene::parse(&scene, &engines("scene.toml")).expect("a scene");
    let cut = run_cut(&read, &options).expect("a run");
    assert_eq!([whole.result.status, cut.result.status], [Status::Converged; 2]);
    // The text of the cut shaft is that of its own scene.
    let again = ShaftScene::parse(&cut.result.scene, &engines("scene.toml")).expect("a scene");
    let told = run_cut(&again, &options).expect_err("cut already").to_string();
    assert!(told.contains("statics") && told.contains("remove it"), "{told}");
    // Statics leaves the outer bearings what the whole shaft takes from them.
    let [of_whole, of_cut] = [&whole, &cut].map(|run| numbers(run, &CYCLE_LOAD_MAX)[0]);
    assert!(of_cut > 1.03 * of_whole, "{of_cut} {of_whole}");

    let beside = [(Variant::Cut, cut)];
    let views = ShaftViews::of_runs(&whole, &beside).expect("views");
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
    write_shaft(folder.path(), &whole, &beside).expect("files");
    let from_files = ShaftViews::read(folder.path()).expect("views");
    assert_eq!(from_files.own.courses, views.own.courses);
    let again = shaft_page(&from_files).expect("a page");
    assert!(shown(&again) == shown(&page));
    // A run without the cut shaft leaves none behind.
    write_shaft(folder.path(), &whole, &[]).expect("files");
    assert!(ShaftViews::read(folder.path()).expect("views").beside.is_empty());
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
