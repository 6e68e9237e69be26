//! A short film whose orbit returns: its equation of motion has a closed solution (`tests/tests/orbit/short.rs`).

use std::f64::consts::TAU;

use oilwedge_reynolds::Cavitation;
use oilwedge_tests::short_orbits::{TWO_HARMONICS, end, harmonics, orbit, short};

/// After twenty turns, ten of the whirl, the journal is where it began, to 1e-6: on two meshes, whose difference shows
/// what the finer one is still off by, with its order four.
#[test]
fn a_full_short_film_returns_after_twenty_turns() {
    let cycle = harmonics(&TWO_HARMONICS, 20.0 * TAU);
    let on = |mesh: [u32; 2]| end(&orbit(&short(0.25, Cavitation::None, mesh), &cycle, [0.2, 0.3], 1e-8, 1));
    let [rough, fine] = [[32, 2], [64, 4]].map(on);
    let [x, y] = [0, 1].map(|d| fine[d] + (fine[d] - rough[d]) / 15.0);
    assert!((x - 0.2).hypot(y - 0.3) < 1e-6, "{x} {y} {rough:?} {fine:?}");
}
