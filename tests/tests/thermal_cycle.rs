//! Orbits whose films have temperatures across them, which do not follow the motion.

use oilwedge_tests::thermal_films::engine_over_cycle;

/// What the mean films make of heat is what their journals and their oil put in, and leaves with oil and through the
/// bush.
#[test]
fn the_mean_heat_of_a_cycle_is_balanced() {
    let cycle = engine_over_cycle([[0.0, -5.0], [2.0, -3.0], [0.0, -1.0], [-2.0, -3.0]]);
    cycle.heat_closes();
    // Without what the pressure of the groove puts in: 4 bar on some 6 ml/s.
    let (power, loss) = (cycle.value("heat_power"), cycle.value("cycle_power_loss"));
    assert!((loss..1.03 * loss).contains(&power), "{power} for {loss}");
    let [journal, bore] = ["temperature_journal", "temperature_bush_max"].map(|name| cycle.value(name));
    assert!(journal < bore && journal > 92.0, "{journal} and {bore}");
}
