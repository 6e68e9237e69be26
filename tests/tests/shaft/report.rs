//! Pages of crankshafts, and shafts beside each other.

use oilwedge_report::page::shaft_page;
use oilwedge_report::shaft_view::ShaftViews;
use oilwedge_tests::crankshafts::*;

#[test]
fn the_page_of_a_shaft_at_rest_has_its_balances_and_no_courses() {
    let whole = run(&text("three_films.toml"));
    let views = ShaftViews::of_runs(&whole, &[]);
    let page = shaft_page(&views, &[]).expect("a page");
    for part in ["middle</td>", "load towards", "Balances", "The shaft", "id=\"figure-shaft_bent\""] {
        assert!(page.contains(part), "no {part}");
    }
    assert!(!page.contains("figure-shaft_orbits"));
}
