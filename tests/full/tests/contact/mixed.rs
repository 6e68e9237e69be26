//! Mixed lubrication of a main bearing against a second code: ten positions under a load, from a full film to one that
//! contact all but replaces.

use oilwedge_tests::rough_surfaces::{ASPERITIES, CURVE, block, mixed_scene};
use oilwedge_tests::tilted_bearings::run;

/// Film to 0.5 %, share of contact to 0.005: the table has 0.2 % and 0.002.
#[test]
fn positions_of_a_second_code() {
    for row in block("mixed")["rows"].as_array().expect("rows") {
        let number = |name: &str| row[name].as_f64().unwrap_or_else(|| panic!("no {name}"));
        let contact = if row["contact"] == "greenwood-tripp" { ASPERITIES } else { CURVE };
        let flow = if row["flow"] == "smooth" { "" } else { "[roughness]\nmodel = \"patir-cheng\"\n" };
        let result = run(&mixed_scene(number("rpm"), contact, flow));
        let of = |name: &str| {
            let quantity = result.by_name(name).unwrap_or_else(|| panic!("no {name}: {:?}", result.head.reason));
            (quantity.value, quantity.error().unwrap_or(f64::NAN))
        };
        let ((film, _), (share, bar)) = (of("film_thickness_min"), of("contact_share"));
        assert!((1e6 * film / number("h_min_um") - 1.0).abs() < 5e-3, "{row}: {film}");
        assert!((share - number("contact_share")).abs() < 5e-3, "{row}: {share}");
        assert!(bar.is_finite(), "{row}: no bar of the share");
        let thrust = of("contact_thrust").0;
        assert!((thrust - number("contact_pressure_integral_N")).abs() < 0.005 * 10e3, "{row}: {thrust}");
    }
}
