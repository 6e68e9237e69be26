//! Criteria of shaped and tilted bearings: values, bars and verdicts.

use oilwedge_study::result::Verdict;
use oilwedge_tests::tilted_bearings::{quantity, run, scene};

const TILTED: &str =
    "eccentricity = 0.7\nmin_film_angle = \"250 deg\"\ntilt = { x = \"-0.1 mrad\", y = \"-0.2 mrad\" }\n";

/// `Delta_gamma` and `h*` of circles follow from `c - |e + z g|` at mid-length and at the ends.
#[test]
fn the_deviation_of_circles_has_a_closed_form() {
    let keys = format!("{TILTED}[criteria]\nequivalent_film_min = \"8 um\"\ndeviation_scale = \"8 um\"");
    let result = run(&scene(0.5, "\"1 %\"", &keys));
    let of = |name: &str| quantity(&result, name)[0];
    let (sin, cos) = 250f64.to_radians().sin_cos();
    let film = |z: f64| 50e-6 - (35e-6 * cos - 1e-4 * z).hypot(35e-6 * sin - 2e-4 * z);
    let (middle, end) = (film(0.0), film(0.025).min(film(-0.025)));
    assert!((of("middle_film_min") - middle).abs() < 1e-15);
    assert!((of("deviation") - (middle - end)).abs() < 1e-15);
    let equivalent = middle / (1.0 + ((middle - end) / 8e-6).powi(2));
    assert!((of("equivalent_film") - equivalent).abs() < 1e-15);
    // The position is given, so that nothing is left open.
    assert_eq!(result.criteria.len(), 1);
    let criterion = &result.criteria[0];
    assert_eq!(criterion.bar, Some(0.0));
    assert!((criterion.value - 1e6 * equivalent).abs() < 1e-9);
    assert_eq!(criterion.verdict == Verdict::Pass, equivalent > 8e-6);
}

/// A limit inside the bar of the greatest pressure is undecided, beside it it is decided.
#[test]
fn a_limit_inside_the_bar_is_undecided() {
    let run_with = |bar: f64| {
        let keys = format!("{TILTED}[criteria]\npressure_max = \"{bar} bar\"\nfilm_min = \"1 um\"");
        run(&scene(0.5, "\"1 %\"", &keys))
    };
    let [pressure, bar] = quantity(&run_with(100.0), "pressure_max");
    for (limit, verdict) in [
        (pressure + 3.0 * bar, Verdict::Pass),
        (pressure + 0.3 * bar, Verdict::Undecided),
        (pressure - 0.3 * bar, Verdict::Undecided),
        (pressure - 3.0 * bar, Verdict::Fail),
    ] {
        let result = run_with(1e-5 * limit);
        let criterion = result.criteria.iter().find(|it| it.what == "greatest pressure").expect("a criterion");
        assert_eq!(criterion.verdict, verdict, "{criterion:?}");
        assert_eq!(result.criteria[0].verdict, Verdict::Pass);
    }
}

/// A number that the mesh does not resolve decides nothing; the least film, which follows from the position, does.
#[test]
fn a_number_that_is_not_resolved_is_undecided() {
    let result = run("[bearing]\ndiameter = \"100 mm\"\nlength = \"50 mm\"\nclearance = \"50 um\"\n\
         [journal]\nspeed = \"30 rad/s\"\neccentricity = 0.998\nmin_film_angle = \"0 deg\"\n\
         [oil]\nviscosity = \"20 mPa.s\"\n[cavitation]\nmodel = \"reynolds\"\n[mesh]\nsize = \"60 mm\"\n\
         [criteria]\nfilm_min = \"1 nm\"\npressure_max = \"1 GPa\"\n");
    let [film, pressure] = &result.criteria[..] else {
        panic!("{:?}", result.criteria);
    };
    assert_eq!((film.verdict, film.bar), (Verdict::Pass, Some(0.0)));
    assert_eq!((pressure.verdict, pressure.bar), (Verdict::Undecided, None));
}

/// The crown that the deviation asks for brings the least film to the middle of a tilted journal's bearing.
#[test]
fn a_crown_of_the_deviation_evens_the_film() {
    let keys = |tables: &str| format!("{TILTED}[criteria]\ndeviation_max = \"1 um\"\n{tables}");
    let plain = run(&scene(0.5, "\"1 %\"", &keys("")));
    let [deviation, _] = quantity(&plain, "deviation");
    let crown = format!("[[bore]]\ncrown = \"{} um\"", 1e6 * deviation);
    let crowned = run(&scene(0.5, "\"1 %\"", &keys(&crown)));
    let [left, _] = quantity(&crowned, "deviation");
    assert!(deviation > 3e-6 && left.abs() < 1e-9, "{deviation:e} {left:e}");
    assert_eq!(crowned.criteria[0].verdict, Verdict::Pass);
    assert_eq!(plain.criteria[0].verdict, Verdict::Fail);
}
