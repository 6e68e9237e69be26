//! Shafts at rest on their films.

use oilwedge_study::RunOptions;
use oilwedge_study::quantities::*;
use oilwedge_study::result::Status;
use oilwedge_tests::crankshafts::*;

/// Forces to 0.3 % of the load, least films to 1 %, tilts to 0.5 %, by structured finite volumes of a second code on
/// all films, extrapolated.
fn compare(case: &ThreeFilms) {
    let run = case.solved();
    assert_eq!(run.result.head.status, Status::Converged, "{:?}", run.result.head.reason);
    let columns = [&LOAD_X, &LOAD_Y, &TILT_X, &TILT_Y, &FILM_THICKNESS_MIN].map(|row| numbers(run, row));
    let scale = CLEARANCE / RADIUS;
    let tilt = case.greatest_tilt();
    for (number, bearing) in case.bearings.iter().enumerate() {
        let found = [0, 1, 2, 3, 4].map(|k: usize| columns[k][number]);
        let force = bearing[0].hypot(bearing[1]);
        for k in 0..2 {
            assert!((found[k] - bearing[k]).abs() < 3e-3 * force, "{number}, force {k}: {} {}", found[k], bearing[k]);
            let slope = found[k + 2] / scale;
            assert!((slope - bearing[k + 2]).abs() < 5e-3 * tilt, "{number}, tilt {k}: {slope} {}", bearing[k + 2]);
        }
        let film = 1e6 * found[4];
        assert!((film / bearing[4] - 1.0).abs() < 1e-2, "{number}, film: {film} {}", bearing[4]);
    }
    let balances = run.result.balances;
    assert!(balances.force < 1e-8 && balances.moment < 1e-8 && balances.journals < 1e-8, "{balances:?}");
}

/// Three films share the loads of a shaft on stiff supports, on a soft one, and under crossed loads that tilt the
/// journals every way.
#[test]
fn three_films_share_the_loads_of_a_shaft() {
    THREE_FILMS.iter().for_each(compare);
}

/// With bars the films that are reported balance the loads, and what the shaft decides has bars that hold what a second
/// code finds; where statics alone gives a load, that has next to none.
#[test]
fn films_with_bars_balance_the_loads() {
    let run = run_with(&text("three_films.toml"), &RunOptions::default());
    for (row, wanted) in [(&LOAD_X, 0.0), (&LOAD_Y, -24e3)] {
        let sum: f64 = numbers(&run, row).iter().sum();
        assert!((sum - wanted).abs() < 1e-4, "{}: {sum}", row.name);
    }
    assert!(run.result.bearings.iter().all(|bearing| bearing.tilt_max_error.is_some_and(|bar| bar > 0.0)));
    let slope = CLEARANCE / RADIUS;
    for (bearing, wanted) in run.result.bearings.iter().zip(THREE_FILMS[0].bearings) {
        // The second code's last digits.
        let rows = [
            (&LOAD_X, wanted[0], 0.05),
            (&LOAD_Y, wanted[1], 1.0),
            (&TILT_X, slope * wanted[2], 2e-6 * slope),
            (&TILT_Y, slope * wanted[3], 2e-5 * slope),
            (&FILM_THICKNESS_MIN, 1e-6 * wanted[4], 5e-9),
        ];
        for (row, wanted, unsure) in rows {
            let quantity = bearing.quantity(row).expect(row.name);
            let bar = quantity.error().unwrap_or_else(|| panic!("no bar of {}", row.name));
            println!("{} {} {} +- {bar}, not {wanted}", bearing.name, row.name, quantity.value);
            assert!(
                bar > 0.0 && (quantity.value - wanted).abs() < bar + unsure,
                "{} {}: {} +- {bar}, not {wanted}",
                bearing.name,
                row.name,
                quantity.value
            );
        }
    }
    let [(_, by_hand), _] = BY_STATICS;
    let run = run_with(&two_films_with(by_hand), &RunOptions::default());
    for (bearing, wanted) in run.result.bearings.iter().zip([13.0 - RIGHT, RIGHT]) {
        let [load, film] = [&LOAD_Y, &FILM_THICKNESS_MIN].map(|row| bearing.quantity(row).expect(row.name));
        assert!((load.value / (-1e3 * wanted) - 1.0).abs() < 1e-8, "{}", load.value);
        let [of_load, of_film] = [load, film].map(|number| number.error().expect("a bar") / number.value.abs());
        assert!(of_load < 1e-6 && of_film > 1e-5, "{of_load} {of_film}");
    }
}

/// Films of a hundredth of the clearance hold a shaft as rigid knife edges do: 5/16, 11/8, 5/16 of one load.
#[test]
fn thin_films_are_knife_edges() {
    let run = on_thin_films();
    assert_eq!(run.result.head.status, Status::Converged, "{:?}", run.result.head.reason);
    for (force, part) in numbers(run, &LOAD_Y).iter().zip(KNIFE_EDGES) {
        assert!((force / (-12e3 * part) - 1.0).abs() < 1e-6, "{force} {part}");
    }
}

#[test]
fn two_films_bear_what_statics_gives_them() {
    for ((name, _), run) in BY_STATICS.iter().zip(by_statics()) {
        assert_eq!(run.result.head.status, Status::Converged, "{:?}", run.result.head.reason);
        for (force, wanted) in numbers(run, &LOAD_Y).iter().zip([13.0 - RIGHT, RIGHT]) {
            assert!((force / (-1e3 * wanted) - 1.0).abs() < 1e-9, "{name}: {force} {wanted}");
        }
    }
}

/// What the peaks of rough surfaces carry is a part of the force of the film that statics asks for.
#[test]
fn peaks_that_touch_carry_a_part_of_the_shaft() {
    let [_, (_, cut)] = BY_STATICS;
    let rough = "\"30 um\"\nroughness = \"3 um\"\n\n[contact]\nmodel = \"greenwood-tripp\"\neta_beta_sigma = 0.05\n\
                 sigma_over_beta = 0.01\nmodulus = \"115 GPa\"\nhardness = \"900 MPa\"\nfriction = 0.1\n";
    let folder = tempfile::tempdir().expect("a folder");
    let change = ("\"30 um\"\n", rough);
    let run = run(&with_bearing(folder.path(), "small_ring", change, &two_films_with(cut)));
    assert_eq!(run.result.head.status, Status::Converged, "{:?}", run.result.head.reason);
    for (force, wanted) in numbers(&run, &LOAD_Y).iter().zip([13.0 - RIGHT, RIGHT]) {
        assert!((force / (-1e3 * wanted) - 1.0).abs() < 1e-9, "{force} {wanted}");
    }
    let shares = numbers(&run, &CONTACT_SHARE);
    assert!(shares.iter().all(|share| *share > 1e-3 && *share < 0.9), "{shares:?}");
}
