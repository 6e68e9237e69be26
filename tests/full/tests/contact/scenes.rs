//! Contact through the program: with heat, in films that conserve oil, at given positions, and the tables that are
//! refused.

use oilwedge_tests::tilted_bearings::{quantity, run};

use oilwedge_tests::rough_surfaces::{ASPERITIES, mixed_scene as scene};

const ROUGH: &str = "[roughness]\nmodel = \"patir-cheng\"\n";

/// What contact rubs heats the film as shear does: without friction of contact it is cooler.
#[test]
fn the_friction_of_contact_heats() {
    let heated = |friction: &str| {
        let text = scene(
            300.0,
            ASPERITIES,
            "[heat]\ninlet = \"90 C\"\nhousing = { conductance = \"20 W/K\", ambient = \"90 C\" }\n",
        )
        .replace("oil.viscosity = \"8 mPa.s\"", "oil.grade = \"ISO VG 46\"")
        .replace("\"2 mm\"", "\"3 mm\"")
        .replace("friction = 0.1", friction);
        let result = run(&text);
        let of = |name: &str| quantity(&result, name)[0];
        (of("temperature_effective"), of("friction_contact_power"), of("friction_power"))
    };
    let ((hot, rubbed, all), (cool, none, _)) = (heated("friction = 0.1"), heated("friction = 0"));
    assert!(none == 0.0 && rubbed > 0.0 && rubbed < all, "{rubbed} {all}");
    assert!(hot > cool + 0.1, "{hot} {cool}");
}

/// A film that conserves its oil carries the mean gap; contact takes the same place as in the Swift-Stieber film.
#[test]
fn a_film_that_conserves_oil_touches_too() {
    let with = |model: &str| {
        let feed = "[[feed]]\ngroup = \"groove\"\npressure = \"1 bar\"\ngroove = { from = \"170 deg\", to = \"190 deg\", width = \"20 mm\" }\n";
        let text = scene(300.0, ASPERITIES, &format!("{ROUGH}{feed}")).replace("\"reynolds\"", model);
        let result = run(&text);
        assert!(result.balances.mass.abs() < 1e-9, "{:?}", result.balances);
        quantity(&result, "contact_share")
    };
    let ([conserving, bar], [other, _]) = (with("\"jfo\""), with("\"reynolds\""));
    assert!((conserving - other).abs() < 0.02 && bar < 0.02, "{conserving} +- {bar}, {other}");
}

/// The load at the position found is that which was balanced; viscosity that grows with pressure carries more of it.
#[test]
fn a_given_position_carries_what_was_balanced() {
    let found = run(&scene(300.0, ASPERITIES, ""));
    let of = |name: &str| quantity(&found, name)[0];
    let position =
        format!("eccentricity = {}, min_film_angle = \"{} deg\" }}\n", of("eccentricity"), of("min_film_angle"));
    let text = scene(300.0, ASPERITIES, "")
        .replace("\"300 rpm\" }\n", &format!("\"300 rpm\", {position}"))
        .replace("load = { force = \"10 kN\", angle = \"0 deg\" }", "");
    let there = run(&text);
    let load = quantity(&there, "load");
    assert!((load[0] / 10e3 - 1.0).abs() < 1e-3 + load[1] / 10e3, "{load:?}");
    let share = quantity(&there, "contact_share")[0];
    assert!((share - of("contact_share")).abs() < 1e-3, "{share}");
    let barus = text
        .replace("oil.viscosity = \"8 mPa.s\"", "oil = { viscosity = \"8 mPa.s\", barus = { alpha = \"5e-9 1/Pa\" } }");
    let thicker = run(&barus);
    assert!(quantity(&thicker, "load")[0] > load[0]);
    assert!(quantity(&thicker, "contact_share")[0] < share);
}
