//! Orbits whose films have temperatures across them, which do not follow the motion.

use oilwedge_study::quantities::Quantity;
use oilwedge_tests::thermal_films::{ThermalFilm, engine_over_cycle};

/// What the mean films make of heat is what their journals and their oil put in, and leaves with oil and through the
/// bush.
#[test]
fn the_mean_heat_of_a_cycle_is_balanced() {
    let run = engine_over_cycle([[0.0, -5.0], [2.0, -3.0], [0.0, -1.0], [-2.0, -3.0]]);
    let cycle = ThermalFilm(run.result);
    cycle.heat_closes();
    // Without what the pressure of the groove puts in: 4 bar on some 6 ml/s.
    let (power, loss) = (cycle.value("heat_power"), cycle.value("cycle_power_loss"));
    assert!((loss..1.03 * loss).contains(&power), "{power} for {loss}");
    let [journal, bore] = ["temperature_journal", "temperature_bush_max"].map(|name| cycle.value(name));
    assert!(journal < bore && journal > 92.0, "{journal} and {bore}");
    // The temperatures are one for the cycle, what a film makes of heat is not.
    let path = run.orbit.expect("a path").quantities;
    let values = |name: &str| -> Vec<f64> {
        let of_film = |film: &Vec<Quantity>| film.iter().find(|it| it.name == name).expect("a number").value;
        path.iter().map(of_film).collect()
    };
    assert!(values("temperature_journal").iter().all(|t| *t == journal));
    let [least, greatest] = values("heat_power").iter().fold([f64::MAX, 0.0], |[a, b], p| [a.min(*p), b.max(*p)]);
    assert!(least < power && power < greatest, "{power} amid {least} and {greatest}");
    for frame in &run.frames {
        let bore = frame.picture.at_points("temperature_at_bush").expect("a field").numbers();
        let hottest = bore.iter().copied().fold(0.0, f64::max);
        assert!((hottest - cycle.value("temperature_bush_max")).abs() < 0.1, "{hottest}");
    }
}
