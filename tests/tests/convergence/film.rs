//! The load of a smooth film converges at twice the order of the gradient.

use oilwedge_reynolds::quantities::load::load;
use oilwedge_tests::{SPEED, order, plain_film, ring_system};

/// Full Sommerfeld film, eps 0.5, B/D 1. The load is a smooth functional, so P2 gives order 4
/// (twice the order of the gradient); 3.5 leaves room for levels that are not yet asymptotic.
#[test]
fn load_of_a_smooth_film_converges_at_order_four() {
    let film = plain_film(0.1, 0.5, 1.0, SPEED);
    let loads: Vec<f64> = [8, 16, 32, 64]
        .map(|rows| {
            let system = ring_system(3 * rows, rows, 0.1, None);
            let solution = film.solve(&system).unwrap();
            load(&solution).magnitude()
        })
        .into();
    let changes: Vec<f64> = loads.windows(2).map(|pair| (pair[1] - pair[0]).abs()).collect();
    assert!(order(&changes) > 3.5);
}
