//! Counterweights against a case in closed form.

use oilwedge_tests::crankshafts::CLOSED_THROW;

#[test]
fn the_best_counterweight_of_a_crank_is_half_of_what_goes_to_and_fro() {
    let best = CLOSED_THROW.found();
    let wanted = -CLOSED_THROW.best();
    assert!((best.at[0] / wanted - 1.0).abs() < 1e-5, "{best:?} {wanted}");
    assert!(best.at[1].abs() < 1e-5 * wanted.abs(), "{best:?}");
    let least = CLOSED_THROW.least_peak();
    assert!((-best.value / least - 1.0).abs() < 1e-5, "{best:?} {least}");
}
