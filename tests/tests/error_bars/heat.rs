//! Numbers of a heat balance: what leaves at the edges of an arc and what goes round and mixes have errors too.

use oilwedge_study::RunOptions;
use oilwedge_study::result::RunResult;
use oilwedge_tests::scenes::written;

use super::films::{answer, quantity};

/// A shell: oil leaves at the edge of the arc, and none goes round.
const SHELL: &str = r#"
[bearing]
diameter = "60 mm"
length = "300 mm"
clearance = "40 um"
arc = { from = "100 deg", to = "260 deg" }
[journal]
speed = "3000 rpm"
eccentricity = 0.3
min_film_angle = "200 deg"
"#;

/// A ring fed by a groove, about which most of the oil goes.
const RING: &str = r#"
[bearing]
diameter = "50 mm"
length = "20 mm"
clearance = "25 um"
[[feed]]
group = "groove"
groove = { from = "60 deg", to = "120 deg", width = "8 mm" }
pressure = "3 bar"
[journal]
speed = "4000 rpm"
eccentricity = 0.7
min_film_angle = "300 deg"
[cavitation]
model = "reynolds"
"#;

const HEAT: &str = r#"
[oil]
grade = "SAE 10W-40"
[heat]
inlet = "60 C"
mixing = { share = 0.4 }
"#;

fn solved(bearing: &str, size: f64) -> RunResult {
    let scene = format!("{bearing}{HEAT}[mesh]\nsize = \"{size} mm\"\n");
    answer(&written(&scene), &RunOptions::default())
}

const NAMES: [&str; 4] = ["cooling_flow", "temperature_effective", "temperature_inlet", "temperature_outlet"];

#[track_caller]
fn hold(coarse: &RunResult, fine: &RunResult) {
    for name in NAMES {
        let [coarse, fine] = [coarse, fine].map(|result| quantity(result, name));
        let [bar, of_fine] = [coarse, fine].map(|quantity| quantity.error().expect("a bar"));
        let off = (coarse.value - fine.value).abs();
        assert!(off <= bar + of_fine, "{name}: {off:e} is more than {bar:e}");
    }
}

#[test]
fn what_leaves_at_the_edge_of_an_arc_has_its_error() {
    let [coarse, fine] = [30.0, 6.0].map(|size| solved(SHELL, size));
    hold(&coarse, &fine);
    let bar = |name| quantity(&coarse, name).error().expect("a bar");
    let value = |name| quantity(&coarse, name).value;
    assert!(value("cooling_flow") > 10.0 * value("side_flow"));
    assert!(bar("cooling_flow") > 1.1 * bar("side_flow"));
}

#[test]
fn what_goes_round_and_mixes_has_its_error() {
    let [coarse, fine] = [4.0, 1.5].map(|size| solved(RING, size));
    hold(&coarse, &fine);
    // The oil enters as it is fed, but for what is mixed in: all of its bar comes from there.
    let entering = quantity(&coarse, "temperature_inlet");
    let parts = entering.bar.expect("a bar");
    assert!(entering.value > 61.0 && parts.total() > parts.temperature, "{parts:?}");
}
