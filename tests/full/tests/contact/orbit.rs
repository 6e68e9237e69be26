//! Contact along the orbit of a journal.

use std::path::Path;

use oilwedge_study::RunOptions;
use oilwedge_study::result::RunResult;
use oilwedge_tests::tilted_bearings::quantity;

use oilwedge_tests::rough_surfaces::{ASPERITIES, mixed_scene as scene};

/// The bearing of the second code at 300 rpm on a mesh of this size, with this load and these tables; with error bars
/// or without.
fn at_300_rpm(size: &str, load: &str, tables: &str, bars: bool) -> RunResult {
    let at_rest = "load = { force = \"10 kN\", angle = \"0 deg\" }";
    let text = scene(300.0, ASPERITIES, tables);
    assert!(text.contains(at_rest), "{text}");
    let text = text.replace(at_rest, load).replace("2 mm", size);
    let scene = oilwedge_study::parse(&text, Path::new("orbit.toml")).unwrap_or_else(|error| panic!("{error}"));
    let options = RunOptions { bars, ..RunOptions::of(&scene) };
    oilwedge_study::run(&scene, &options).unwrap_or_else(|error| panic!("{error}")).result
}

fn value(result: &RunResult, name: &str) -> f64 {
    let quantity = result.by_name(name);
    quantity.unwrap_or_else(|| panic!("no {name}: {:?}", result.head.reason)).value
}

/// An orbit whose load does not change ends where film and contact together carry it at rest.
#[test]
fn a_load_at_rest_leads_to_its_mixed_film() {
    let load = "load = { force = \"10 kN\", angle = \"0 deg\" }";
    let orbit = "[orbit]\ntolerance = 1e-3\ncycles = 4\nclosure = 1e-6\n";
    let [moving, resting] = [orbit, ""].map(|tables| at_300_rpm("4 mm", load, tables, false));
    let differ = |of_cycle: &str, at_rest: &str| value(&moving, of_cycle) - value(&resting, at_rest);
    let film = value(&resting, "film_thickness_min");
    let by = differ("cycle_film_thickness_min", "film_thickness_min") / film;
    assert!(by.abs() < 1e-3, "{by} of the film");
    let by = differ("cycle_contact_share_max", "contact_share");
    assert!(by.abs() < 5e-4, "{by} of the load");
    assert_eq!(value(&moving, "cycle_contact_duration"), 1.0);
}

/// A load that pulses: contact carries a part of its peak, and nothing of what is left between. Contact that never
/// carries a hundredth of the load lasts no time.
#[test]
fn a_pulsing_load_touches_for_a_part_of_the_cycle() {
    let wave = |mean: f64, wave: f64| {
        format!(
            "load = {{ frame = \"shell\", period = \"720 deg\", harmonics = [{{ order = 0, cos = {{ x = \"{mean} kN\", y = \"0 N\" }} }}, \
             {{ order = 0.5, cos = {{ x = \"{wave} kN\", y = \"0 N\" }} }}] }}"
        )
    };
    let tables = |tolerance: &str| format!("[criteria]\ncontact_share_max = 0.5\n[orbit]\ntolerance = {tolerance}\n");
    let heavy = at_300_rpm("6 mm", &wave(7.0, 6.0), &tables("3e-3"), true);
    let [share, bar] = quantity(&heavy, "cycle_contact_share_max");
    let [duration, doubt] = quantity(&heavy, "cycle_contact_duration");
    assert!(share > 0.02 && share < 0.5 && bar < share, "{share} +- {bar}");
    assert!(duration > 0.05 && duration < 0.95 && doubt < 0.2, "{duration} +- {doubt}");
    let criterion = heavy.criteria.first().expect("a criterion");
    assert!(criterion.is_met && (criterion.value - share).abs() < 1e-12, "{criterion:?}");
    let light = at_300_rpm("6 mm", &wave(1.5, 1.0), &tables("1e-2"), false);
    let [share, duration] = ["cycle_contact_share_max", "cycle_contact_duration"].map(|name| value(&light, name));
    assert!(share < 0.01 && duration == 0.0, "{share} {duration}");
}
