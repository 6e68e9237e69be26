//! Journals that contact carries alone, or at one edge.

use oilwedge_tests::tilted_bearings::run;

use oilwedge_tests::rough_surfaces::{ASPERITIES, CURVE, mixed_scene as scene};

/// A journal that does not turn rests on its asperities: contact carries all, straight towards the load.
#[test]
fn a_journal_at_rest_lies_on_its_asperities() {
    for contact in [ASPERITIES, CURVE] {
        let result = run(&scene(0.0, contact, ""));
        let of = |name: &str| {
            let quantity = result.by_name(name).unwrap_or_else(|| panic!("no {name}: {:?}", result.head.reason));
            quantity.value
        };
        assert!((of("contact_share") - 1.0).abs() < 1e-9, "{}", of("contact_share"));
        assert!((of("contact_load_x") / 10e3 - 1.0).abs() < 1e-9);
        assert!(of("attitude_angle").abs() < 1e-3, "{}", of("attitude_angle"));
        assert!(result.by_name("friction_torque").is_none());
    }
}

/// A load far off the middle, which no film carries, is carried by film and contact at one end.
#[test]
fn contact_at_one_edge_bears_a_moment() {
    let text = scene(300.0, CURVE, "").replace("angle = \"0 deg\" }", "angle = \"0 deg\", at = \"3 mm\" }");
    let result = run(&text);
    let of = |name: &str| {
        let quantity = result.by_name(name).unwrap_or_else(|| panic!("no {name}: {:?}", result.head.reason));
        quantity.value
    };
    assert!((of("load_z") / 3e-3 - 1.0).abs() < 1e-8);
    assert!(of("contact_moment_x") > 0.0 && of("contact_share") > 0.1);
    assert!(of("film_thickness_min") < 1.2e-6 && of("film_thickness_min") > 0.0);
}
