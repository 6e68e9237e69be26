//! Bars of flows of Guembel films, against finer meshes: where the ends have the pressure of the cavity, and where a
//! thin full film lies between end and cavity.

use oilwedge_study::result::RunResult;
use oilwedge_study::{RunOptions, run};
use oilwedge_tests::scenes::written;

fn solved(bearing: &str, journal: &str, pressure: &str, size: &str) -> RunResult {
    let scene = written(&format!(
        "[bearing]\ndiameter = '75 mm'\nclearance = '37.5 um'\n{bearing}\n[mesh]\nsize = '{size}'\n[journal]\nspeed = '10 rad/s'\n{journal}\n\
         [oil]\nviscosity = '0.4 Pa.s'\n[cavitation]\nmodel = 'guembel'\npressure = '{pressure}'\n"
    ));
    run(&scene, &RunOptions::default()).expect("a run").result
}

fn flow(result: &RunResult, name: &str) -> [f64; 2] {
    let quantity = result.quantities.iter().find(|quantity| quantity.name == name);
    let quantity = quantity.unwrap_or_else(|| panic!("no {name}"));
    [quantity.value, quantity.error().unwrap_or_else(|| panic!("{name} has no bar"))]
}

/// Bars hold on each mesh, against one four to ten times finer, and are at most the part `most` of the flow.
fn bars_hold(bearing: &str, journal: &str, pressure: &str, most: f64) {
    let better = solved(bearing, journal, pressure, "0.7 mm");
    for size in ["7 mm", "3 mm"] {
        let coarse = solved(bearing, journal, pressure, size);
        for name in ["inlet_flow", "side_flow"] {
            let ([value, bar], [known, rest]) = (flow(&coarse, name), flow(&better, name));
            let rounding = 1e-12 * known.abs();
            assert!(
                (value - known).abs() <= bar + rest + rounding,
                "{name} {size}: {value} +- {bar}, {known} +- {rest}"
            );
            assert!(bar <= most * known.abs(), "{name} {size}: {value} +- {bar}");
        }
    }
}

/// The flow through the leading edge of a short arc at a great eccentricity.
#[test]
fn through_the_edge_of_an_arc() {
    bars_hold(
        "length = '18.75 mm'\narc = { from = '65.27 deg', to = '146.02 deg' }",
        "eccentricity = 0.92285\nmin_film_angle = '87.53 deg'",
        "0 bar",
        0.3,
    );
}

/// Short bearing at a great eccentricity.
#[test]
fn out_of_a_short_bearing() {
    bars_hold("length = '18.75 mm'\ntheory = 'short'", "eccentricity = 0.95\nmin_film_angle = '180 deg'", "0 bar", 0.1);
}

/// Ends above the pressure of the cavity: how much of the thin film between them is dropped depends on the mesh, and
/// the bars include it.
#[test]
fn through_ends_above_the_cavity() {
    bars_hold(
        "length = '37.5 mm'\narc = { from = '147.5 deg', to = '272.2 deg' }",
        "eccentricity = 0.7157\nmin_film_angle = '211.4 deg'",
        "-1 bar",
        f64::INFINITY,
    );
    bars_hold(
        "length = '18.75 mm'\ntheory = 'short'",
        "eccentricity = 0.775\nmin_film_angle = '201.5 deg'",
        "-1 bar",
        f64::INFINITY,
    );
}
