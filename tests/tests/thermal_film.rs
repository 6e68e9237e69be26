//! Films whose temperature is found at each place and across it: rows of two independent codes, limits, symmetries, and
//! the scenes that are refused.

use std::path::Path;

use oilwedge_scene::{Complaint, SceneError};
use oilwedge_tests::scenes::parsed;
use oilwedge_tests::thermal_films::{AT_POSITION, BUSH, FERRON, LOAD, ThermalFilm, edited, is_that_of_the_reference};

/// A mesh for films that are compared with each other.
const COARSE: (&str, &str) = ("size = \"6 mm\"", "size = \"8 mm\"");
/// Layers that are enough on such a mesh.
const FOUR: (&str, &str) = ("layers = 6\n", "");

#[test]
fn films_are_those_of_two_other_codes() {
    for name in ["F1", "F4", "E1"] {
        is_that_of_the_reference(name);
    }
}

/// An oil whose viscosity does not fall with temperature has the film of one viscosity, whatever temperatures are
/// found.
#[test]
fn a_viscosity_that_does_not_fall_is_one_viscosity() {
    let field = edited(FERRON, &[COARSE, FOUR, ("0.034 1/K", "0 1/K")]);
    let (oil, heat) = (field.find("[oil]").expect("a table"), field.find("[cavitation]").expect("a table"));
    let plain = format!("{}[oil]\nviscosity = \"27.7 mPa.s\"\n{}", &field[..oil], &field[heat..]);
    let plain = plain.split("[heat]").next().expect("a part").to_owned();
    let [field, plain] = [field, plain].map(|text| ThermalFilm::of(&text));
    for name in [
        "eccentricity",
        "attitude_angle",
        "pressure_max",
        "friction_power",
        "side_flow",
        "feed_flow.groove",
        "cavity_share",
    ] {
        let [found, expected] = [&field, &plain].map(|film| film.value(name));
        assert!((found / expected - 1.0).abs() < 1e-6, "{name}: {found}, not {expected}");
    }
    assert!(field.value("temperature_max") > field.value("temperature_journal"));
}

/// A bearing that is turned with its load, and one that is mirrored and turns backwards, have the same numbers.
#[test]
fn a_film_turned_and_a_film_mirrored_are_the_same() {
    let upright = edited(FERRON, &[COARSE, FOUR]);
    let turned = edited(&upright, &[("\"81 deg\"", "\"121 deg\""), ("\"99 deg\"", "\"139 deg\""), ("270", "310")]);
    let mirrored = edited(&upright, &[("\"4000 rpm\"", "\"-4000 rpm\"")]);
    let [upright, others @ ..] = [upright, turned, mirrored].map(|text| ThermalFilm::of(&text));
    for other in others {
        other.heat_closes();
        for (name, tolerance) in [
            ("eccentricity", 1e-3),
            ("film_thickness_min", 1e-3),
            ("pressure_max", 5e-3),
            ("heat_power", 1e-3),
            ("heat_carried", 1e-3),
            ("side_flow", 1e-3),
        ] {
            let [found, expected] = [&other, &upright].map(|film| film.value(name));
            assert!((found / expected - 1.0).abs() < tolerance, "{name}: {found}, not {expected}");
        }
        for name in ["temperature_max", "temperature_journal", "temperature_bush_max", "feed_temperature.groove"] {
            let [found, expected] = [&other, &upright].map(|film| film.value(name));
            assert!((found - expected).abs() < 0.03, "{name}: {found}, not {expected}");
        }
    }
}

/// The clearance grows by `R (a_bush (T_bush - t) - a_shaft (T_journal - t))`. Coefficients of zero leave it as it is,
/// equal ones make the temperature of the measurement irrelevant, a journal that expands alone makes it smaller.
#[test]
fn the_clearance_follows_the_temperatures_of_the_walls() {
    let base = edited(FERRON, &[AT_POSITION.as_slice(), &[COARSE, FOUR]].concat());
    let expanding = |[shaft, bush, at]: [&str; 3]| {
        let keys = format!("expansion = {{ shaft = \"{shaft} 1/K\", bush = \"{bush} 1/K\", at = \"{at} C\" }}");
        ThermalFilm::of(&format!("{base}{keys}\n"))
    };
    let least = |film: &ThermalFilm| film.value("film_thickness_min");
    let rigid = ThermalFilm::of(&base);
    assert_eq!(least(&expanding(["0", "0", "20"])), least(&rigid));
    let equal = ["20", "40"].map(|at| expanding(["1.2e-5", "1.2e-5", at]));
    let [cold, warm] = [&equal[0], &equal[1]].map(least);
    assert!((cold / warm - 1.0).abs() < 1e-5, "{cold}, not {warm}");
    let shrunk = expanding(["1.2e-5", "0", "20"]);
    let expected = -0.05 * 1.2e-5 * (shrunk.value("temperature_journal") - 20.0);
    let growth = least(&shrunk) - least(&rigid);
    assert!((growth / expected - 1.0).abs() < 1e-3, "{growth:e} m, not {expected:e} m");
}

/// Beside a bush that takes no heat four layers would put the hottest oil many kelvins too high.
#[test]
fn an_adiabatic_bush_has_six_layers() {
    let free = edited(FERRON, &[AT_POSITION.as_slice(), &[COARSE, FOUR, (BUSH, "")]].concat());
    let with = |layers: u32| edited(&free, &[("field = true", &format!("field = true\nlayers = {layers}"))]);
    let hottest = |text: &str| ThermalFilm::of(text).value("temperature_max");
    let (found, [four, six]) = (hottest(&free), [4, 6].map(|layers| hottest(&with(layers))));
    assert!(found == six && four > six + 5.0, "{found}: {four} with four layers, {six} with six");
}

/// The complaints about a text.
fn complaints(text: &str) -> Vec<Complaint> {
    match oilwedge_study::parse(text, Path::new("a.toml")) {
        Err(SceneError::Complaints { complaints, .. }) => complaints,
        other => panic!("no complaint: {other:?}"),
    }
}

/// What does not go with a temperature field is refused with one message that names the key and the way out.
#[test]
fn what_does_not_go_with_a_field_is_refused() {
    let jfo = "model = \"jfo\"";
    let field = "field = true";
    let refused = [
        ("heat.field", vec![(jfo, "model = \"reynolds\"")]),
        ("heat.field", vec![(jfo, "model = \"guembel\"")]),
        ("heat.field", vec![(jfo, "model = \"none\"")]),
        ("heat.housing", vec![(field, "field = true\nhousing = { conductance = \"5 W/K\", ambient = \"20 C\" }")]),
        ("heat.mixing", vec![(field, "field = true\nmixing = { ratio = 0.4 }")]),
        ("heat.layers", vec![("layers = 6", "layers = 5")]),
        ("heat.bush.outer_diameter", vec![("outer_diameter = \"200 mm\"", "outer_diameter = \"100 mm\"")]),
        (
            "heat.bush",
            vec![("length = \"80 mm\"", "length = \"80 mm\"\narc = { from = \"20 deg\", to = \"200 deg\" }")],
        ),
        ("heat.bush", vec![("field = true\nlayers = 6", "")]),
        ("heat.layers", vec![("field = true", ""), (BUSH, "")]),
    ];
    for (key, edits) in refused {
        let found = complaints(&edited(FERRON, &edits));
        let of_key: Vec<&Complaint> = found.iter().filter(|complaint| complaint.key == key).collect();
        assert!(found.len() == 1 && of_key.len() == 1, "{key}: {found:?}");
        let texts = [&of_key[0].message, &of_key[0].help];
        assert!(texts.iter().all(|text| !text.is_empty() && !text.contains('\n')), "{key}: {found:?}");
    }
}

/// A journal that moves has no field of temperatures.
#[test]
fn a_field_of_a_journal_that_is_squeezed_is_refused() {
    let squeezed = edited(
        FERRON,
        &[
            (LOAD, ""),
            (
                "speed = \"4000 rpm\"",
                "speed = \"4000 rpm\"\neccentricity = 0.7\nmin_film_angle = \"310 deg\"\n\
                 squeeze = { radial = \"1 mm/s\", tangential = \"0 mm/s\" }",
            ),
        ],
    );
    let found = complaints(&squeezed);
    assert!(found.iter().any(|complaint| complaint.key == "journal.squeeze"), "{found:?}");
}

/// The exponential law of viscosity is one law beside the others, with all of its keys.
#[test]
fn the_exponential_law_is_read_and_refused() {
    let law = "exponential = { viscosity = \"27.7 mPa.s\", at = \"40 C\", beta = \"0.034 1/K\" }";
    parsed(FERRON).expect("a scene");
    for (replaced, told) in [
        (law.replace(", beta = \"0.034 1/K\"", ""), "oil.exponential.beta"),
        (law.replace("0.034 1/K", "0.3 1/K"), "oil.exponential.beta"),
        (law.replace("27.7 mPa.s", "0 mPa.s"), "oil.exponential.viscosity"),
        (law.replace("40 C", "400 C"), "oil.exponential.at"),
        (law.replace("0.034 1/K", "0.034 K"), "oil.exponential.beta"),
        (format!("{law}\ngrade = \"ISO VG 46\""), "oil."),
    ] {
        let found = complaints(&edited(FERRON, &[(law, &replaced)]));
        assert!(found.len() == 1 && found[0].key.starts_with(told), "{replaced}: {found:?}");
    }
}
