//! Thermal films of the reference on finer meshes: a turbine bearing with two grooves, a slow bearing under a high
//! load, a bearing whose shaft takes heat away.

use oilwedge_tests::thermal_films::{BUSH, FERRON, ReferenceRow, TURBINE, ThermalFilm, edited};

/// Row T1 of the reference.
#[test]
fn a_turbine_bearing_is_that_of_two_other_codes() {
    let film = ThermalFilm::of(TURBINE);
    film.heat_closes();
    film.is(&ReferenceRow {
        eccentricity: [0.550_459, 0.0013],
        least_film: [67.4312, 0.19],
        pressure: [3.530_72, 0.02],
        power: [14_824.3, 47.0],
        flow: [356.031, 2.3],
        hottest: [87.387, 0.14],
        journal: [70.0941, 0.2],
        bush: Some([87.3208, 0.17]),
    });
}

/// Row F3 of the reference: half of the speed, and half as much load again.
#[test]
fn a_slow_bearing_is_that_of_two_other_codes() {
    let film = ThermalFilm::of(&edited(FERRON, &[("4000 rpm", "2000 rpm"), ("6 kN", "9 kN"), ("6 mm", "4 mm")]));
    film.heat_closes();
    film.is(&ReferenceRow {
        eccentricity: [0.750_392, 0.000_89],
        least_film: [36.1932, 0.13],
        pressure: [3.411_55, 0.014],
        power: [596.859, 1.8],
        flow: [108.14, 0.33],
        hottest: [51.0729, 0.089],
        journal: [46.2434, 0.15],
        bush: Some([50.4718, 0.079]),
    });
}

/// Row F5 of the reference: heat leaves along the shaft.
#[test]
fn a_shaft_that_takes_heat_is_that_of_two_other_codes() {
    let shaft = format!("{BUSH}\njournal = {{ conductance = \"5 W/K\", ambient = \"30 C\" }}");
    let film = ThermalFilm::of(&edited(FERRON, &[(BUSH, &shaft), ("6 mm", "4 mm")]));
    film.heat_closes();
    film.is(&ReferenceRow {
        eccentricity: [0.542_194, 0.000_73],
        least_film: [66.3819, 0.11],
        pressure: [1.7939, 0.0071],
        power: [1676.72, 2.2],
        flow: [126.925, 0.53],
        hottest: [57.1028, 0.032],
        journal: [47.4047, 0.077],
        bush: Some([56.0939, 0.015]),
    });
    let leaves = film.value("heat_journal");
    assert!((leaves - 87.0236).abs() < 0.39 + 0.005 * 87.0, "{leaves} W along the shaft");
}
