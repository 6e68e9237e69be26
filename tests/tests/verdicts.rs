//! Verdicts under a balance of heat, and what they keep in reserve: the oil that leaves, broken assumptions, and oil at
//! high shear.

use oilwedge_study::result::RunResult;
use oilwedge_study::{RunOptions, run};
use oilwedge_tests::bench::Bench;
use oilwedge_tests::scenes::written;

/// A main bearing of 60 mm, with more lines in its tables.
fn bearing(oil: &str, heat: &str) -> String {
    format!(
        "[bearing]\ndiameter = '60 mm'\nlength = '20 mm'\nclearance = '30 um'\nfilm_start = '0 deg'\n[mesh]\nsize = '4 mm'\n\
         [journal]\nspeed = '3000 rpm'\neccentricity = 0.85\nmin_film_angle = '180 deg'\n\
         [oil]\n{oil}\n[cavitation]\nmodel = 'reynolds'\n{heat}\n"
    )
}

fn solved(scene: &str) -> RunResult {
    run(&written(scene), &RunOptions::default()).expect("a run").result
}

fn viscosity(result: &RunResult) -> f64 {
    let found = result.quantities.iter().find(|quantity| quantity.name == "viscosity_effective");
    found.expect("a viscosity").value
}

const GRADE: &str = "grade = 'SAE 5W-30'\ntemperature = '100 C'";

/// Oil that leaves too hot is a reason against a bearing whose film is cool enough.
#[test]
fn the_oil_that_leaves_is_a_criterion() {
    let heat = |limit: &str| format!("[heat]\ninlet = '40 C'\nfilm_min = '1 um'\ntemperature_max = '200 C'\n{limit}");
    let report = |limit: &str| {
        let result = solved(&bearing("grade = 'SAE 30'", &heat(limit)));
        result.temperature.expect("a balance of heat")
    };
    let free = report("outlet_max = '300 C'");
    let outlet = |report: &oilwedge_study::result::TemperatureReport| {
        let found = report.criteria.iter().find(|criterion| criterion.what == "temperature of the oil that leaves");
        found.expect("a criterion").clone()
    };
    let hot = outlet(&free);
    assert!(free.is_fit && hot.decides && hot.is_met, "{hot:?}");
    let limited = report(&format!("outlet_max = '{} C'", hot.value - 1.0));
    assert!(!limited.is_fit && !outlet(&limited).is_met);
    // By default that of ISO 7902-3.
    assert_eq!(outlet(&report("")).most, Some(125.0));
}

/// One viscosity for oil that leaves several times thinner is a broken assumption, and no verdict is without reserve
/// beside one.
#[test]
fn no_verdict_without_reserve_beside_a_broken_assumption() {
    let bench = Bench::new();
    let heat = "[heat]\ninlet = '40 C'\nfilm_min = '1 um'\ntemperature_max = '200 C'\noutlet_max = '300 C'";
    bench.write("scene.toml", bearing("grade = 'SAE 5W-30'", heat));
    let told = bench.run(&["solve", "scene.toml"]);
    assert_eq!(told.status, 0, "{}", told.stderr);
    let broken = told.stderr.matches("an assumption does not hold").count();
    assert!(broken >= 2 && told.stderr.contains("one temperature of the film"), "{}", told.stderr);
    let verdict = format!(
        "the bearing meets its design criteria, but {broken} assumptions of the film are broken: see the warnings"
    );
    assert!(told.stdout.contains(&verdict), "{}", told.stdout);
    let result = std::fs::read_to_string(bench.path().join("out/scene/result.json")).expect("a result");
    let result: serde_json::Value = serde_json::from_str(&result).expect("JSON");
    assert_eq!(result["heat"]["broken_assumptions"], broken);
    assert_eq!(result["heat"]["is_fit"], true);
}

/// A multigrade oil above 1e6 1/s needs `high_shear`; a monograde and a slow film do not.
#[test]
fn a_sheared_multigrade_is_told() {
    let is_told = |scene: &str| {
        let result = solved(scene);
        result.tail.warnings.iter().any(|warning| warning.contains("give oil.high_shear"))
    };
    // 9.42 m/s over 4.5 um are 2.1e6 1/s.
    assert!(is_told(&bearing(GRADE, "")));
    assert!(!is_told(&bearing(&GRADE.replace("5W-30", "30"), "")));
    assert!(!is_told(&bearing(GRADE, "").replace("3000 rpm", "1000 rpm")));
    assert!(!is_told(&bearing(&format!("{GRADE}\nhigh_shear = 0.8"), "")));
}

/// The viscosity of the film is the part that shear leaves, at any temperature: a factor, or the viscosity at 150
/// degrees C over that at low shear.
#[test]
fn shear_takes_its_part_of_the_viscosity() {
    let plain = viscosity(&solved(&bearing(GRADE, "")));
    let whole = viscosity(&solved(&bearing(&format!("{GRADE}\nhigh_shear = 1.0"), "")));
    assert_eq!(plain, whole);
    let factor = viscosity(&solved(&bearing(&format!("{GRADE}\nhigh_shear = 0.8"), "")));
    assert!((factor / plain - 0.8).abs() < 1e-12);
    let at_150 = viscosity(&solved(&bearing(&GRADE.replace("100 C", "150 C"), "")));
    let hths = format!("{GRADE}\nhigh_shear = '{} Pa.s'", 0.75 * at_150);
    assert!((viscosity(&solved(&bearing(&hths, ""))) / plain - 0.75).abs() < 1e-9);
}

#[test]
fn what_is_wrong_with_high_shear_is_told() {
    let bench = Bench::new();
    for (oil, wanted) in [
        (format!("{GRADE}\nhigh_shear = 1.4"), ["oil.high_shear", "0.3 to 1"]),
        (format!("{GRADE}\nhigh_shear = '29 mPa.s'"), ["oil.high_shear", "at low shear the oil has"]),
        (format!("{GRADE}\nhigh_shear = '3 mm2/s'"), ["oil.high_shear", "dynamic viscosity"]),
        ("viscosity = '9 mPa.s'\nhigh_shear = 0.8".to_owned(), ["oil.high_shear", "has a meaning only"]),
    ] {
        bench.write("scene.toml", bearing(&oil, ""));
        let told = bench.run(&["solve", "scene.toml"]);
        assert_eq!(told.status, 2, "{oil}: {}", told.stderr);
        for word in wanted {
            assert!(told.stderr.contains(word), "{oil}: {}", told.stderr);
        }
    }
}
