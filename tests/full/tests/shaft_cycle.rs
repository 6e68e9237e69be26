//! Shafts over a cycle of their throws.

use std::path::Path;

use oilwedge_report::page::shaft_page;
use oilwedge_report::shaft::write_shaft;
use oilwedge_report::shaft_view::ShaftViews;
use oilwedge_scene::ShaftScene;
use oilwedge_study::RunOptions;
use oilwedge_study::quantities::*;
use oilwedge_study::result::Status;
use oilwedge_study::shaft::{ShaftRun, Variant, best_counterweights, run_cut};
use oilwedge_tests::crankshafts::*;
use oilwedge_tests::program::repository;

/// What people see of a page: JSON rounds the numbers behind cells in their last digit when it is read.
fn shown(page: &str) -> String {
    let mut parts = page.split("<data value=\"");
    let first = parts.next().unwrap_or_default().to_owned();
    let rests = parts.filter_map(|part| Some(part.split_once('>')?.1));
    rests.fold(first, |shown, rest| shown + rest)
}

/// The page of an engine shows all bearings and the cut shaft beside it, from the runs and from the files in a folder.
fn shows_all_bearings_and_the_cut_shaft(folder: &Path, whole: &ShaftRun, cut: ShaftRun) {
    let beside = [(Variant::Cut, cut)];
    let views = ShaftViews::of_runs(whole, &beside);
    let page = shaft_page(&views, &[]).expect("a page");
    for part in [
        "main 1</td>",
        "main 4</td>",
        "Beside the shaft cut at its bearings",
        "id=\"figure-shaft_bent\"",
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
    let again = shaft_page(&from_files, &[]).expect("a page");
    assert!(shown(&again) == shown(&page));
    // A run without the cut shaft leaves none behind.
    write_shaft(folder, whole, &[]).expect("files");
    assert!(ShaftViews::read(folder).expect("views").beside.is_empty());
}

/// The mesh of the films.
const MESH: &str = "[mesh]\nsize = \"12 mm\"\n\n";

/// Three throws on coarse films with long steps, as one shaft and cut at its main bearings.
#[test]
fn an_engine_runs_as_one_shaft_and_cut_at_its_mains() {
    let folder = tempfile::tempdir().expect("a folder");
    let judged = format!("{MESH}[criteria]\nfilm_min = \"1 um\"\n\n[journal]");
    let scene = text("three_throws.toml");
    let engine = with_bearing(folder.path(), "main_85", ("[journal]", &judged), &scene);
    let engine = changed(&engine, "tolerance = 1e-3", "tolerance = 2e-2");
    let whole = run(&engine);
    assert_eq!(whole.result.head.status, Status::Converged, "{:?}", whole.result.head.reason);
    all_films_balance_the_loads_at_every_step(&whole);

    let options = RunOptions { bars: false, max_seconds: f64::INFINITY, ..RunOptions::default() };
    let read = ShaftScene::parse(&engine, &engines("scene.toml")).expect("a scene");
    let cut = run_cut(&read, &options).expect("a run");
    assert_eq!(cut.result.head.status, Status::Converged, "{:?}", cut.result.head.reason);
    mains_have_the_orbits_of_single_bearings(&cut, &engine);
    // The text of the cut shaft is that of its own scene.
    let again = ShaftScene::parse(&cut.result.head.scene, &engines("scene.toml")).expect("a scene");
    let told = run_cut(&again, &options).expect_err("cut already").to_string();
    assert!(told.contains("statics") && told.contains("remove it"), "{told}");
    // Statics leaves the outer bearings what the whole shaft takes from them.
    let [of_whole, of_cut] = [&whole, &cut].map(|run| numbers(run, &CYCLE_LOAD_MAX)[0]);
    assert!(of_cut > 1.03 * of_whole, "{of_cut} {of_whole}");
    shows_all_bearings_and_the_cut_shaft(folder.path(), &whole, cut);
}

/// Checks the least film of each main bearing of the `cut` shaft over the cycle against that of a single bearing under
/// the loads of its throws, to 1e-6: meshes and steps in time are the same.
fn mains_have_the_orbits_of_single_bearings(cut: &ShaftRun, engine: &str) {
    let films = numbers(cut, &CYCLE_FILM_THICKNESS_MIN);
    let bearing = changed(&text("bearings/main_85.toml"), "[journal]", &format!("{MESH}[journal]"));
    for (number, throws) in BESIDE.iter().enumerate() {
        let film = single_main(engine, throws, &bearing);
        assert!((films[number] / film - 1.0).abs() < 1e-6, "{number}: {} {film}", films[number]);
    }
}

fn all_films_balance_the_loads_at_every_step(whole: &ShaftRun) {
    let balances = whole.result.balances;
    let power = balances.power.expect("films without memory");
    assert!([balances.force, balances.moment, balances.journals, power].iter().all(|off| *off < 1e-8), "{balances:?}");
    assert!(power > 0.0, "its terms come by two ways");
    for bearing in &whole.result.bearings {
        // Of the order of what steps may be off by.
        assert!(bearing.energy.is_some_and(|energy| energy < 1e-2), "{}: {:?}", bearing.name, bearing.energy);
    }
    // Films and cavities mirror each other in no throw: the outer bearings bear one throw each, the inner ones two.
    let loads = numbers(whole, &CYCLE_LOAD_MAX);
    assert!(loads[1] > 0.8 * loads[0] && loads.iter().all(|load| *load > 1e4), "{loads:?}");
}

/// The counterweights of the in-line four, moved so that the least film by maps is greatest, keep force and moment of
/// the shaft.
#[test]
fn moved_counterweights_make_the_least_film_greater() {
    let path = repository().join("scenes/engines/in_line_four.toml");
    let scene = ShaftScene::read(&path).unwrap_or_else(|error| panic!("{error}"));
    let (_, found) = best_counterweights(&scene).unwrap_or_else(|error| panic!("{error}"));
    println!("{:?} {}", found.film_by_maps, found.asked);
    let [before, after] = found.film_by_maps;
    assert!(after > 1.02 * before && found.force_change < 1e-9 && found.moment_change < 1e-9, "{found:?}");
}
