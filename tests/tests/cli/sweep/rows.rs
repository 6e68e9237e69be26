//! Sweeps meet the rows of the studies they repeat.

use oilwedge_tests::bench::Bench;
use oilwedge_tests::flexpde_study::rows;
use oilwedge_tests::printed;
use oilwedge_tests::sweeps::*;

#[test]
fn the_sweep_of_the_study_meets_its_rows() {
    let bench = Bench::new();
    bench.scene("18_sweep_eccentricity", &[]);
    let report = done(&bench.run(&["sweep", "scene.toml", "--json"]));
    assert_eq!((report["cases"].as_u64(), report["complete"].as_bool()), (Some(16), Some(true)));
    let study = rows();
    for row in report["rows"].as_array().expect("rows") {
        let number = |name: &str| row["inputs"][name].as_f64().expect("an input");
        let viscosity = if number("oil.barus.alpha") == 0.0 { "constant" } else { "conservative" };
        let reference = study.iter().find(|reference| {
            (reference.liner.as_str(), reference.cavitation.as_str()) == ("shell", "none")
                && reference.viscosity == viscosity
                && (reference.eccentricity, reference.mu0, reference.omega) == (number("eccentricity"), 0.4, 10.0)
        });
        let reference = reference.unwrap_or_else(|| panic!("no reference for {row}"));
        // As in literature/flexpde_2016.rs; bars are there, so the numbers are those of the cubic film.
        let c_w = reference.reference("C_w").expect("C_w");
        assert!((value(row, "load_coefficient") - c_w).abs() < 1e-4 * c_w + 6e-5, "{row}");
        let attitude = reference.reference("attitude_deg").expect("an angle");
        assert!((value(row, "attitude_angle") - attitude).abs() < 0.01, "{row}");
        let bar = row["quantities"]["load"]["error"].as_f64().expect("a bar");
        assert!(bar > 0.0 && bar < 2e-3 * value(row, "load"), "{row}");
    }
}

/// The closed form and finite differences of the real length (`literature/short_crankshaft_bearing.rs`,
/// `short_bearing_finite_length.rs`): a film refined to 0.5 % of its load is asked for 1 % of it, 1.5 % of its greatest
/// pressure, 2 % of its flow and 0.2 degrees.
#[test]
fn the_sweeps_of_the_crankshaft_bearing_meet_their_rows() {
    let wanted = printed::rows("source000/finite_length.csv");
    for (name, squeeze) in [("21_short_crankshaft_bearing", 0.0), ("22_squeezed_crankshaft_bearing", 0.4)] {
        let bench = Bench::new();
        bench.scene(name, &[]);
        let report = done(&bench.run(&["sweep", "scene.toml", "--json"]));
        let cases = report["rows"].as_array().expect("rows");
        assert_eq!(cases.len(), 10);
        for row in cases {
            // A short film under Reynolds' condition is the half film: each line along the axis has pressure or none.
            let model = match row["inputs"]["bearing.theory"].as_str() {
                Some("short") => "short_GUM",
                _ => "finite_REY",
            };
            let speed = row["inputs"]["speed"].as_f64().expect("a speed");
            let wanted = wanted.iter().find(|it| {
                (it.text("model"), it.number("E")) == (model, squeeze) && (it.number("n") - speed).abs() < 1e-6
            });
            let wanted = wanted.unwrap_or_else(|| panic!("no {model} at {speed}: {row}"));
            for (quantity, column, scale, tolerance) in [
                ("load", "R", 1.0, 1e-2),
                ("pressure_max", "p_max", 1e-6, 1.5e-2),
                ("side_flow", "Q_both_ends", 1.0, 2e-2),
            ] {
                let off = scale * value(row, quantity) / wanted.number(column) - 1.0;
                assert!(off.abs() < tolerance, "{quantity} is {off:.1e} off: {row}");
            }
            assert!((value(row, "attitude_angle") - wanted.number("theta")).abs() < 0.2, "{row}");
        }
    }
}
