//! Counterweights against a case in closed form, and shafts that have none to move.

use oilwedge_tests::bench::Bench;
use oilwedge_tests::crankshafts::{CLOSED_THROW, changed, engines, text};

#[test]
fn the_best_counterweight_of_a_crank_is_half_of_what_goes_to_and_fro() {
    let best = CLOSED_THROW.found();
    let wanted = -CLOSED_THROW.best();
    assert!((best.at[0] / wanted - 1.0).abs() < 1e-5, "{best:?} {wanted}");
    assert!(best.at[1].abs() < 1e-5 * wanted.abs(), "{best:?}");
    let least = CLOSED_THROW.least_peak();
    assert!((-best.value / least - 1.0).abs() < 1e-5, "{best:?} {least}");
}

/// A shaft whose counterweights cannot move is refused before its films are solved, and so is one that is cut twice.
#[test]
fn what_cannot_stand_beside_a_shaft_is_refused_before_its_films_are_solved() {
    let bench = Bench::new();
    let refused = |name: &str, argument: &str, words: &[&str]| {
        bench.refuses(&["solve", &engines(name).display().to_string(), argument], words);
    };
    refused("three_films.toml", "--counterweights", &["--counterweights", "no [crank]"]);
    refused(
        "three_throws.toml",
        "--counterweights",
        &["--counterweights: ", "on 0 webs leave no choice", "give [[crankshaft.counterweight]] on three webs or more"],
    );
    let bearings = engines("bearings").display().to_string();
    let cut = changed(&text("three_throws.toml"), "period         = \"720 deg\"", "statics = \"cut\"");
    bench.write("cut.toml", cut.replace("bearings/", &format!("{bearings}/")));
    bench.refuses(&["solve", "cut.toml", "--cut"], &["statics = \"cut\" in [crankshaft]", "remove it"]);
}
