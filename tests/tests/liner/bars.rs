//! Error bars of films with elastic walls hold the numbers of finer meshes.

use oilwedge_study::result::RunResult;
use oilwedge_tests::tilted_bearings::{quantity, run};

/// A ring on a mesh of this size, with a table of a liner.
fn found(size: &str, eps: f64, model: &str, liner: &str) -> RunResult {
    let result = run(&format!(
        "bearing = {{ diameter = \"100 mm\", length = \"50 mm\", clearance = \"50 um\" }}\nmesh.size = \"{size}\"\n\
         oil.viscosity = \"20 mPa.s\"\ncavitation.model = \"{model}\"\n\
         journal = {{ speed = \"300 rad/s\", eccentricity = {eps}, min_film_angle = \"0 deg\" }}\n{liner}\n"
    ));
    assert_eq!(result.reason, None);
    result
}

#[test]
fn bars_hold_the_numbers_of_finer_meshes() {
    const WALL: &str = "liner.wall = { thickness = \"50 mm\", modulus = \"210 GPa\", poisson = 0.3 }";
    const SOFT: &str = "liner.winkler = \"0.167 um/MPa\"";
    let mut missed = Vec::new();
    let mut compared = 0;
    for (eps, model, liner) in [(0.8, "reynolds", WALL), (0.8, "reynolds", SOFT), (0.7, "none", SOFT)] {
        let fine = found("2.5 mm", eps, model, liner);
        for size in ["12 mm", "6 mm"] {
            let coarse = found(size, eps, model, liner);
            let names = [
                "load",
                "attitude_angle",
                "pressure_max",
                "film_thickness_min",
                "deflection_max",
                "side_flow",
                "friction_torque",
            ];
            for name in names {
                let ([value, bar], [better, rest]) = (quantity(&coarse, name), quantity(&fine, name));
                compared += 1;
                if (value - better).abs() > bar + rest {
                    missed.push(format!("{model} {size} {name}: {value} +- {bar}, {better} +- {rest}"));
                }
            }
        }
    }
    assert!(missed.is_empty(), "{} of {compared}: {missed:#?}", missed.len());
}
