//! Thermal films of the reference on finer meshes: a turbine bearing with two grooves, a slow bearing under a high
//! load, a bearing whose shaft takes heat away; and a cycle under a load that stands still.

use oilwedge_tests::thermal_films::{ThermalFilm, coarse_engine, engine_over_cycle, is_that_of_the_reference};

#[test]
fn films_are_those_of_two_other_codes() {
    for name in ["T1", "F3"] {
        is_that_of_the_reference(name);
    }
    let leaves = is_that_of_the_reference("F5").value("heat_journal");
    assert!((leaves - 87.0236).abs() < 0.39 + 0.005 * 87.0, "{leaves} W along the shaft");
}

/// A journal under a load that does not change comes to rest, and its film has the temperatures of a
/// film at rest.
#[test]
fn under_a_load_that_stands_still_the_temperatures_are_those_of_a_film_at_rest() {
    let rest = ThermalFilm::of(&coarse_engine());
    let cycle = ThermalFilm(engine_over_cycle([[0.0, -5.0]; 4]).result);
    for name in ["temperature_max", "temperature_journal", "temperature_bush_max", "feed_temperature.groove"] {
        let [rest, cycle] = [&rest, &cycle].map(|film| film.value(name));
        assert!((rest - cycle).abs() < 0.1, "{name}: {cycle} for {rest}");
    }
    for (of_rest, of_cycle) in [("film_thickness_min", "cycle_film_thickness_min"), ("heat_power", "heat_power")] {
        let [rest, cycle] = [rest.value(of_rest), cycle.value(of_cycle)];
        assert!((rest / cycle - 1.0).abs() < 3e-3, "{of_cycle}: {cycle} for {rest}");
    }
}
