//! Mass-conserving films, judged by their companions on the vertices alone.

use oilwedge_study::RunOptions;

use super::films::{answer, bar, drawn, quantity, set};

/// What the companion says covers the error of the load and of what flows, against a mesh four times as fine.
#[test]
fn the_bars_of_a_mass_conserving_film_hold() {
    let ring = |size| {
        drawn("13_grooved_ring", size, |scene| {
            set(scene, "mesh", "size", format!("{size} mm"))
        })
    };
    let fine = answer(&ring(2.0), &RunOptions::default());
    for size in [8.0, 5.0] {
        let coarse = answer(&ring(size), &RunOptions::default());
        for name in [
            "load",
            "load_x",
            "load_y",
            "attitude_angle",
            "pressure_max",
            "side_flow",
        ] {
            let (value, error) = bar(&coarse, name);
            let off = (value - quantity(&fine, name).value).abs();
            let own = quantity(&fine, name).error().expect("a bar");
            assert!(off < error + own, "{size} mm, {name}: off {off:e}, bar {error:e}");
        }
    }
}
