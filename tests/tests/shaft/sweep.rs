//! Crankshafts over the values of their keys.

use std::path::Path;

use oilwedge_campaign::sweep::Sweep;
use oilwedge_report::page::sweep_page;
use oilwedge_report::plot::{PlotOptions, figures_of_sweep};
use oilwedge_report::sweep::{SweepOptions, SweepReport, SweepResult, TABLE_FILE, run as run_sweep};
use oilwedge_scene::ShaftScene;
use oilwedge_study::RunOptions;
use oilwedge_study::quantities::{CYCLE_FILM_THICKNESS_MIN, FILM_THICKNESS_MIN, LOAD};
use oilwedge_study::result::Status;
use oilwedge_study::shaft::ShaftError;
use oilwedge_tests::crankshafts::*;

/// The sweep of a scene.
fn sweep_of(text: &str) -> Sweep {
    let scene = ShaftScene::parse(text, &engines("scene.toml")).unwrap_or_else(|error| panic!("{error}"));
    let sweep = Sweep::of_shaft(&scene).unwrap_or_else(|error| panic!("{error}"));
    sweep.expect("a sweep")
}

/// What it finds, without error bars, in the folder `dir`.
fn swept(sweep: &Sweep, dir: &Path) -> SweepReport {
    let options = SweepOptions {
        case: RunOptions { bars: false, max_seconds: f64::INFINITY, ..RunOptions::default() },
        ..SweepOptions::default()
    };
    run_sweep(sweep, &options, dir, &mut |_| {}).unwrap_or_else(|error| panic!("{error}"))
}

/// The numbers of a quantity, case by case.
fn column(report: &SweepReport, name: &str) -> Vec<f64> {
    let column = (report.columns.quantities.iter()).position(|column| column.quantity == name);
    let column = column.unwrap_or_else(|| panic!("no {name}"));
    let value = |row| report.value(row, column).unwrap_or_else(|| panic!("{row:?}"));
    report.rows.iter().map(value).collect()
}

/// A shaft at rest on three films at two speeds and with two moduli: a row for each of its bearings, with the numbers
/// that it has by itself.
#[test]
fn each_bearing_of_each_shaft_has_a_row() {
    let moduli = "[sweep]\n\"crankshaft.youngs_modulus\" = [\"206 GPa\", \"150 GPa\"]\n";
    let text = format!("{}\n{moduli}speed = [\"1000 rpm\", \"2000 rpm\"]\n", text("three_films.toml"));
    let sweep = sweep_of(&text);
    let folder = tempfile::tempdir().expect("a folder");
    let report = swept(&sweep, folder.path());
    assert_eq!((report.rows.len(), report.count("converged")), (12, 12));
    let of_row = |case: usize| report.rows[case][1..4].join(" ");
    assert_eq!(of_row(3), "206.0 2000.0 left");
    assert_eq!(of_row(10), "150.0 2000.0 middle");
    // By itself: the second shaft is the one of the scene.
    let alone = run(&text);
    for row in [&LOAD, &FILM_THICKNESS_MIN] {
        assert_eq!(column(&report, row.name)[3..6], numbers(&alone, row)[..], "{}", row.name);
    }
    // A softer shaft leaves more to the middle; a slower one has thinner films.
    let (loads, films) = (column(&report, LOAD.name), column(&report, FILM_THICKNESS_MIN.name));
    assert!(loads[10] > loads[4] && films[1] < films[4], "{loads:?} {films:?}");

    // Taken up again where it was: the shaft that was not complete is solved anew.
    let table = folder.path().join(TABLE_FILE);
    let whole = std::fs::read_to_string(&table).expect("a table");
    let lines: Vec<&str> = whole.lines().take(5).collect();
    std::fs::write(&table, lines.join("\n") + "\n").expect("a file");
    let again = swept(&sweep, folder.path());
    let timeless = |report: &SweepReport| -> Vec<Vec<String>> {
        let timeless = |row: &Vec<String>| row[..row.len() - 1].to_vec();
        report.rows.iter().map(timeless).collect()
    };
    assert_eq!(again.kept, 4);
    assert_eq!(timeless(&again), timeless(&report));

    let result = SweepResult::from(&report);
    let page = sweep_page(&result, &[]).expect("a page");
    assert!(page.contains("middle") && page.contains("crankshaft.youngs"), "{}", page.len());
    let options = PlotOptions { selected: Vec::new(), width: 180.0 };
    let figures = figures_of_sweep(&result, &options).expect("pictures");
    assert!(figures.iter().any(|(name, _)| name == "sweep"));
}

/// The first throw of the shipped engine on the two main bearings beside it.
fn one_throw() -> String {
    let without = |text: &str, from: &str, to: &str| {
        let (before, rest) = text.split_once(from).expect(from);
        let (_, after) = rest.split_once(to).expect(to);
        format!("{before}{to}{after}")
    };
    let text = text("three_throws.toml");
    let text = without(&text, "    { fires_at = \"240 deg\" },", "]\n\n[crankshaft.throw]");
    without(&text, "[[crankshaft.bearing]]\nname  = \"main 3\"", "[crank]\n")
}

/// At each speed the engine has the least films that it has by itself: one throw, cut at its main bearings, on coarse
/// films with long steps.
#[test]
fn an_engine_is_swept_over_its_speed() {
    let folder = tempfile::tempdir().expect("a folder");
    let coarse = ("[journal]", "[mesh]\nsize = \"12 mm\"\n\n[journal]");
    let scene = with_bearing(folder.path(), "main_85", coarse, &three_throws_cut(&one_throw()));
    let scene = changed(&scene, "tolerance = 1e-3", "tolerance = 2e-2");
    let columns = format!("columns = [\"{} um\"]", CYCLE_FILM_THICKNESS_MIN.symbol);
    let sweep = format!("{scene}\n[sweep]\nspeed = [\"1500 rpm\", \"2000 rpm\"]\n{columns}\n");
    let report = swept(&sweep_of(&sweep), folder.path());
    assert_eq!(report.count("converged"), 4);
    let alone = run(&sweep);
    assert_eq!(alone.result.head.status, Status::Converged, "{:?}", alone.result.head.reason);
    let films = column(&report, CYCLE_FILM_THICKNESS_MIN.name);
    let of_scene = numbers(&alone, &CYCLE_FILM_THICKNESS_MIN);
    assert_eq!((films.len(), of_scene.len()), (4, 2));
    for (film, wanted) in films[2..].iter().zip(&of_scene) {
        assert!((film / (1e6 * wanted) - 1.0).abs() < 1e-12, "{film} {wanted}");
    }
    assert!(films[..2].iter().zip(&films[2..]).all(|(slow, fast)| slow != fast), "{films:?}");
}

#[test]
fn axes_and_columns_that_a_crankshaft_has_not_are_refused() {
    let refused = |axes: &str| {
        let text = format!("{}\n[sweep]\n{axes}\n", text("three_films.toml"));
        let scene = ShaftScene::parse(&text, &engines("scene.toml")).map_err(ShaftError::from);
        match scene.and_then(|scene| Sweep::of_shaft(&scene)) {
            Err(error) => format!("{error} {error:?}"),
            Ok(_) => panic!("{axes} is accepted"),
        }
    };
    for (axes, words) in [
        ("\"journal.speed\" = [\"1 rpm\"]", "no table of a scene"),
        ("eccentricity = [0.1]", "not known as an axis"),
        ("\"crankshaft.bearing.at\" = [\"1 mm\"]", "crankshaft.bearing"),
        ("speed = [\"-1 rpm\"]", "with speed = -1 rpm"),
        ("speed = [\"1 rpm\"]\ncolumns = [\"h_cycle um\"]", "no quantity"),
        ("speed = [\"1 rpm\"]\ncolumns = [\"W um\"]", "um"),
    ] {
        let told = refused(axes);
        assert!(told.contains(words), "{axes}: {told}");
    }
}
