//! Orbits whose films have temperatures across them, which do not follow the motion.

use oilwedge_tests::thermal_films::{ENGINE, ThermalFilm, edited};
use tempfile::TempDir;

/// The engine bearing with a coarse mesh.
const COARSE: (&str, &str) = ("size = \"1.5 mm\"", "size = \"4 mm\"");
/// Its load, and that of a file of crank angles in place of it.
const LOAD: (&str, &str) = (
    "[load]\nforce = \"5 kN\"\nangle = \"270 deg\"\n",
    "[load]\nfile = \"load.csv\"\nframe = \"shell\"\nperiod = \"360 deg\"\n[orbit]\ntolerance = 1e-2\n",
);

/// The result of the engine bearing under the load in x and y [kN] of four crank angles, or at rest.
fn solved(text: &str, loads: [[f64; 2]; 4]) -> ThermalFilm {
    let folder = TempDir::new().expect("a folder");
    let row = |(k, [x, y]): (usize, &[f64; 2])| format!("{}, {x}, {y}\n", 90 * k);
    let rows: String = loads.iter().enumerate().map(row).collect();
    std::fs::write(folder.path().join("load.csv"), format!("angle [deg], Fx [kN], Fy [kN]\n{rows}")).expect("a file");
    let path = folder.path().join("scene.toml");
    std::fs::write(&path, text).expect("a file");
    ThermalFilm::of_scene(&oilwedge_study::read(&path).unwrap_or_else(|error| panic!("{error}")))
}

/// Under a load that does not change the journal comes to rest, and its film has the temperatures of one at rest.
#[test]
fn under_a_load_that_stands_still_the_temperatures_are_those_of_a_film_at_rest() {
    let load = [[0.0, -5.0]; 4];
    let text = edited(ENGINE, &[COARSE]);
    let [rest, cycle] = [text.clone(), edited(&text, &[LOAD])].map(|text| solved(&text, load));
    for name in ["temperature_max", "temperature_journal", "temperature_bush_max", "feed_temperature.groove"] {
        let [rest, cycle] = [&rest, &cycle].map(|result| result.value(name));
        assert!((rest - cycle).abs() < 0.1, "{name}: {cycle} for {rest}");
    }
    for (of_rest, of_cycle) in [("film_thickness_min", "cycle_film_thickness_min"), ("heat_power", "heat_power")] {
        let [rest, cycle] = [rest.value(of_rest), cycle.value(of_cycle)];
        assert!((rest / cycle - 1.0).abs() < 3e-3, "{of_cycle}: {cycle} for {rest}");
    }
}

/// What the mean films make of heat is what their journals and their oil put in, and leaves with oil and through the
/// bush.
#[test]
fn the_mean_heat_of_a_cycle_is_balanced() {
    let cycle = solved(&edited(ENGINE, &[COARSE, LOAD]), [[0.0, -5.0], [2.0, -3.0], [0.0, -1.0], [-2.0, -3.0]]);
    let [power, oil, bush] = ["heat_power", "heat_carried", "heat_bush"].map(|name| cycle.value(name));
    assert!((oil + bush - power).abs() < 1e-9 * power, "{power} for {oil} and {bush}");
    // Without what the pressure of the groove puts in: 4 bar on some 6 ml/s.
    let loss = cycle.value("cycle_power_loss");
    assert!((loss..1.03 * loss).contains(&power), "{power} for {loss}");
    let [journal, bore] = ["temperature_journal", "temperature_bush_max"].map(|name| cycle.value(name));
    assert!(journal < bore && journal > 92.0, "{journal} and {bore}");
}
