//! What a result says of itself holds: bars of what no mesh shows, balances that are identities, meshes and work as
//! they were.

use std::path::Path;

use oilwedge_study::quantities::{
    CAVITY_FLOW, CAVITY_SHARE, FRICTION_CAVITY_POWER, FRICTION_COEFFICIENT, FRICTION_TORQUE, FRICTION_TORQUE_BEARING,
    INLET_FLOW, Row, SIDE_FLOW,
};
use oilwedge_study::result::{Refinement, RunResult};
use oilwedge_study::{RunOptions, parse, run};

/// An arc below a journal, loaded downwards, as text of a scene.
fn arc(model: &str, mesh: &str) -> String {
    format!(
        r#"
bearing = {{ diameter = "60 mm", length = "30 mm", clearance = "30 um", arc = {{ from = "210 deg", to = "330 deg" }} }}
journal = {{ speed = "3000 rpm" }}
load = {{ force = "2 kN", angle = "270 deg" }}
oil = {{ grade = "ISO VG 46", temperature = "60 C" }}
cavitation = {{ model = "{model}" }}
{mesh}
"#
    )
}

fn result(text: &str) -> RunResult {
    let scene = parse(text, Path::new("scene.toml")).unwrap_or_else(|error| panic!("{error}"));
    run(&scene, &RunOptions::default()).expect("a film").result
}

/// Value and half width of the bar.
fn number(result: &RunResult, row: &Row) -> [f64; 2] {
    let quantity = result.quantity(row).unwrap_or_else(|| panic!("no {}", row.name));
    [quantity.value, quantity.error().expect("a bar")]
}

#[test]
fn a_cavity_that_the_mesh_does_not_show_is_within_the_bar() {
    let coarse = result(&arc("reynolds", ""));
    let fine = result(&arc("reynolds", "mesh = { size = \"0.6 mm\" }"));
    for row in [&CAVITY_SHARE, &FRICTION_CAVITY_POWER] {
        let ([value, bar], [finer, _]) = (number(&coarse, row), number(&fine, row));
        assert!(finer > 0.0, "{}: the fine mesh shows none", row.name);
        assert!((value - finer).abs() <= bar, "{}: {value} +- {bar}, but {finer}", row.name);
    }
}

/// The journal brings oil in at one edge of an arc and carries it out at the other, whatever pressures are dropped.
#[test]
fn the_edges_of_an_arc_are_no_cavity_of_guembel() {
    for mesh in ["", "mesh = { size = \"1.5 mm\" }"] {
        let film = result(&arc("guembel", mesh));
        let ([made, bar], [brought, _]) = (number(&film, &CAVITY_FLOW), number(&film, &INLET_FLOW));
        assert!(made.abs() <= bar.max(0.02 * brought), "{made} of {brought} m3/s");
    }
    // A liner whose film diverges over half of it: the journal carries a full gap of oil out, U h/2 for each length,
    // though less is left where the film was dropped. The difference is made.
    let wide = arc("guembel", "").replace("330 deg", "380 deg");
    let film = result(
        &wide
            .replace("load = { force = \"2 kN\", angle = \"270 deg\" }", "")
            .replace("speed = \"3000 rpm\"", "speed = \"3000 rpm\", eccentricity = 0.6, min_film_angle = \"290 deg\""),
    );
    let [made, _] = number(&film, &CAVITY_FLOW);
    let [brought, _] = number(&film, &INLET_FLOW);
    let [leaves, _] = number(&film, &SIDE_FLOW);
    let gap = 30e-6 * (1.0 - 0.6 * 90f64.to_radians().cos());
    let dragged = 0.5 * 3000.0 * std::f64::consts::PI / 30.0 * 0.03 * gap * 0.03;
    let expected = leaves + dragged - brought;
    assert!((made / expected - 1.0).abs() < 0.02, "{made}, not {expected} m3/s");
    assert!(film.balances.mass < 1e-9, "{}", film.balances.mass);
}

/// `T - T_b = W_y e_x - W_x e_y`, by signs of the journal's offset towards the thinnest film.
#[test]
fn torques_differ_by_the_moment_of_the_load() {
    let base = r#"
bearing = { diameter = "60 mm", length = "25 mm", clearance = "30 um" }
journal = { speed = "3000 rpm", eccentricity = 0.7, min_film_angle = "200 deg" }
oil = { viscosity = "10 mPa.s" }
ends = { pressure = "0 bar" }
feed = [{ group = "hole", pressure = "4 bar", hole = { angle = "30 deg", z = "0 mm", diameter = "6 mm" } }]
"#;
    for model in ["jfo", "reynolds"] {
        let film = result(&format!("{base}cavitation = {{ model = \"{model}\" }}\n"));
        let [torque, _] = number(&film, &FRICTION_TORQUE);
        let [held, _] = number(&film, &FRICTION_TORQUE_BEARING);
        let force =
            ["load_x", "load_y"].map(|name| film.quantities.iter().find(|it| it.name == name).expect("a force").value);
        let (sin, cos) = 200f64.to_radians().sin_cos();
        let moment = 0.7 * 30e-6 * (sin * force[0] - cos * force[1]);
        let off = (torque - held - moment).abs() / torque;
        assert!(off < if model == "jfo" { 1e-9 } else { 1e-4 }, "{model}: {off:e}");
        if model == "jfo" {
            // The hole brings what leaves at the ends.
            let [side, fed] = ["side_flow", "feed_flow.hole"]
                .map(|name| film.quantities.iter().find(|it| it.name == name).expect("a flow"));
            assert!((side.value / fed.value - 1.0).abs() < 1e-8 && side.error() == fed.error(), "{side:?} {fed:?}");
        }
        // The pressures on the mesh have it to their own error.
        assert!(film.balances.moment > 0.0 && film.balances.moment < 0.1, "{model}: {}", film.balances.moment);
    }
}

#[test]
fn a_liner_meshed_again_is_not_called_divided() {
    let levels = result(&arc("guembel", "mesh = { tolerance = \"0.0001 %\" }")).levels;
    assert!(levels.len() > 1, "one mesh");
    assert!(levels[1..].iter().all(|level| level.refinement == Refinement::Drawn), "{levels:?}");
}

#[test]
fn a_temperature_found_counts_all_films() {
    let text = arc("reynolds", "heat = { inlet = \"50 C\" }").replace(", temperature = \"60 C\"", "");
    let counts = result(&text).counts;
    assert!(counts.temperature_steps > 1, "{counts:?}");
    assert!(counts.position_steps >= counts.temperature_steps && counts.factorisations > 1, "{counts:?}");
}

/// Steel yields by microns under a high pressure, and a pressure beyond that of metals is an error of the load.
#[test]
fn surfaces_that_deflect_are_compared_with_the_film() {
    let film = |force: &str, more: &str| {
        let text = arc("reynolds", "").replace("2 kN", force);
        result(&text.replace("clearance = ", &format!("{more}clearance = ")))
    };
    let rigid = |film: &RunResult| film.tail.warnings.iter().any(|warning| warning.contains("rigid surfaces"));
    let light = film("2 kN", "");
    assert!(!rigid(&light), "{:?}", light.tail.warnings);
    // 1512 bar on a square that carries F/(p/2): by hand 2 x 0.95 x 0.91/2.1e11 x sqrt(F p/2).
    let heavy = film("80 kN", "");
    let (load, pressure) = (80e3, heavy.quantities.iter().find(|it| it.name == "pressure_max").expect("p_max").value);
    let by_hand = 2.0 * 0.95 * 0.91 / 2.1e11 * (load * pressure / 2.0).sqrt();
    let deflection = heavy.regime.expect("a film").deflection;
    assert!((deflection / by_hand - 1.0).abs() < 1e-6, "{deflection} is not {by_hand}");
    assert!(rigid(&heavy), "{deflection}: {:?}", heavy.tail.warnings);
    // A stiffer pair deflects less.
    let stiff = film("80 kN", "elastic_modulus = \"210000 GPa\", ");
    assert!(!rigid(&stiff), "{:?}", stiff.tail.warnings);
}

/// A groove over the widest film brings oil: what is carried into the loaded film is at least what leaves at the ends
/// downstream.
#[test]
fn the_oil_of_a_groove_on_the_widest_film_is_carried_in() {
    let film = |groove: &str| {
        result(&format!(
            r#"
bearing = {{ diameter = "60 mm", length = "25 mm", clearance = "30 um" }}
journal = {{ speed = "3000 rpm", eccentricity = 0.7, min_film_angle = "270 deg" }}
oil = {{ viscosity = "10 mPa.s" }}
cavitation = {{ model = "reynolds" }}
feed = [{{ group = "groove", pressure = "4 bar", groove = {{ {groove}, width = "8 mm" }} }}]
"#
        ))
    };
    let half = film("from = \"10 deg\", to = \"170 deg\"");
    let [over_groove, _] = number(&half, &INLET_FLOW);
    // The whole gap there by hand: h = c (1 + eps cos 80 deg), at least half of U h B is dragged in.
    let gap = 30e-6 * (1.0 + 0.7 * 80f64.to_radians().cos());
    let dragged = 0.5 * 0.03 * 3000.0 * std::f64::consts::PI / 30.0 * gap * 0.025;
    assert!(over_groove > 0.5 * dragged, "{over_groove} of {dragged}");
    // A groove beside that line changes it by what it is nearer, not by a cut of it.
    let [beside, _] = number(&film("from = \"110 deg\", to = \"170 deg\""), &INLET_FLOW);
    assert!((over_groove / beside - 1.0).abs() < 0.6, "{over_groove} and {beside}");
}

/// With the load given the coefficient of friction is off by as much as the torque, in proportion.
#[test]
fn bars_of_torque_and_coefficient_agree_under_a_load() {
    let film = result(&arc("reynolds", "mesh = { size = \"3 mm\" }"));
    let ([torque, of_torque], [coefficient, of_coefficient]) =
        (number(&film, &FRICTION_TORQUE), number(&film, &FRICTION_COEFFICIENT));
    let ratio = (of_coefficient / coefficient) / (of_torque / torque);
    assert!((ratio - 1.0).abs() < 1e-9, "{ratio}");
}
