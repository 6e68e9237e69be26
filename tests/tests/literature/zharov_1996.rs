//! Zharov, Modelling of the tribosystem crankshaft - bearings - supports (dissertation, VNIIZhT Moscow, 1996), table 2:
//! least films of the main bearings of a diesel engine over its cycle, `Delta_gamma = h_0 - min(h_1, h_2)`,
//! `h* = h_0/(1 + k Delta_gamma^2)` with k = 0.01/um^2, and the crown for all bearings of the shaft.
//!
//! Printed to 0.1 um: Delta_gamma is a difference of printed numbers, so that it is met to the digit; h* to 0.05 um.
//! Bearing 2 of the second block is not legible.

use oilwedge_reynolds::quantities::deviation::{Sections, common_crown};
use oilwedge_tests::journal_bearings::number;
use oilwedge_tests::shaped_bearings::block;
use oilwedge_tests::tilted_bearings::numbers;
use serde_json::Value;

/// Deviation [um] that halves the film: `k = 1/s^2`.
const SCALE: f64 = 10.0;

fn check(block: &Value, illegible: Option<usize>) {
    let column = |name: &str| numbers(&block[name]);
    let [h_0, h_1, h_2] = ["h0", "h1", "h2"].map(column);
    let bearings: Vec<Sections> = (0..h_0.len()).map(|k| Sections { middle: h_0[k], ends: [h_1[k], h_2[k]] }).collect();
    let (deviations, equivalents) = (column("Delta_gamma"), column("h_star"));
    let legible = || (0..bearings.len()).filter(|&k| Some(k) != illegible);
    for k in legible() {
        let deviation = bearings[k].deviation();
        assert!((deviation - deviations[k]).abs() < 0.05, "bearing {}: {deviation}", k + 1);
        let equivalent = bearings[k].equivalent_film(SCALE);
        assert!((equivalent - equivalents[k]).abs() <= 0.05 + 1e-9, "bearing {}: {equivalent}", k + 1);
    }
    let all: Vec<Sections> = legible().map(|k| bearings[k]).collect();
    let crown = common_crown(&all).expect("bearings");
    assert!((crown - number(block, "E_n")).abs() < 0.05, "{crown}");
    assert!(common_crown(&[]).is_none());
}

#[test]
fn deviation_equivalent_film_and_common_crown_are_those_of_the_table() {
    let table = block("zharov_table_2");
    check(&table["block1"], None);
    check(&table["block2_full_ring_groove"], Some(1));
}
