//! Contact along the orbit of a journal.

use oilwedge_study::result::RunResult;
use oilwedge_tests::tilted_bearings::{quantity, run};

use super::mixed::{ASPERITIES, scene};

/// The bearing of the second code at 300 rpm on a coarse mesh, with this load and these tables.
fn at_300_rpm(load: &str, tables: &str) -> RunResult {
    let at_rest = "load = { force = \"10 kN\", angle = \"0 deg\" }";
    let text = scene(300.0, ASPERITIES, tables);
    assert!(text.contains(at_rest), "{text}");
    run(&text.replace(at_rest, load).replace("\"2 mm\"", "\"4 mm\""))
}

/// Under a load that does not change the orbit ends where film and contact together carry it at rest.
#[test]
fn a_load_at_rest_leads_to_its_mixed_film() {
    let load = "load = { force = \"10 kN\", angle = \"0 deg\" }";
    let orbit = "[orbit]\ntolerance = 1e-4\ncycles = 4\nclosure = 1e-6\n";
    let (moving, resting) = (at_300_rpm(load, orbit), at_300_rpm(load, ""));
    let differ = |of_cycle: &str, at_rest: &str| quantity(&moving, of_cycle)[0] - quantity(&resting, at_rest)[0];
    let [film, _] = quantity(&resting, "film_thickness_min");
    let by = differ("cycle_film_thickness_min", "film_thickness_min") / film;
    assert!(by.abs() < 1e-3, "{by} of the film");
    let by = differ("cycle_contact_share_max", "contact_share");
    assert!(by.abs() < 5e-4, "{by} of the load");
    assert_eq!(quantity(&moving, "cycle_contact_duration")[0], 1.0);
}

/// A load that pulses: contact carries a part of its peak, and nothing of what is left between.
#[test]
fn a_pulsing_load_touches_for_a_part_of_the_cycle() {
    let wave = |mean: f64, wave: f64| {
        format!(
            "load = {{ frame = \"shell\", period = \"720 deg\", harmonics = [{{ order = 0, cos = {{ x = \"{mean} kN\", y = \"0 N\" }} }}, \
             {{ order = 0.5, cos = {{ x = \"{wave} kN\", y = \"0 N\" }} }}] }}"
        )
    };
    let tables = "[criteria]\ncontact_share_max = 0.5\n[orbit]\ntolerance = 1e-3\n";
    let (heavy, light) = (at_300_rpm(&wave(7.0, 6.0), tables), at_300_rpm(&wave(1.5, 1.0), tables));
    let of = |result: &RunResult| {
        let share = quantity(result, "cycle_contact_share_max");
        let duration = quantity(result, "cycle_contact_duration");
        println!("share {share:?}, duration {duration:?}");
        [share, duration]
    };
    let [[share, bar], [duration, doubt]] = of(&heavy);
    assert!(share > 0.02 && share < 0.5 && bar < share, "{share} +- {bar}");
    assert!(
        duration > 0.05 && duration < 0.95 && doubt < 0.2,
        "{duration} +- {doubt}"
    );
    let criterion = heavy.criteria.first().expect("a criterion");
    assert!(
        criterion.is_met && (criterion.value - share).abs() < 1e-12,
        "{criterion:?}"
    );
    let [[share, _], [duration, _]] = of(&light);
    assert!(share < 0.01 && duration == 0.0, "{share} {duration}");
}
