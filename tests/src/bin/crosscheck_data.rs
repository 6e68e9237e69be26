//! `crosscheck_data SCENE FOLDER`: our quadrature rule and our own evaluation inside cells, for tests/crosscheck.

use std::path::Path;

use oilwedge_fem::mapping::Mapping;
use oilwedge_fem::{Field, Quadrature};
use oilwedge_tests::scenes::solve;

/// Reference points at which every cell is probed.
const PROBES: [[f64; 2]; 3] = [[0.2, 0.3], [0.61, 0.11], [0.05, 0.9]];
/// One cell in so many is probed, and every curved one.
const STRIDE: usize = 7;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().collect();
    let [_, scene, folder] = &arguments[..] else {
        return Err("usage: crosscheck_data SCENE FOLDER".into());
    };
    let solved = solve(&oilwedge_study::read(Path::new(scene))?)?;
    let space = solved.study.system.space();
    let problem = &solved.study.problem;
    let pressure: Vec<f64> = solved.film.solution.unknown.iter().map(|&u| problem.pressure_at(u)).collect();
    let thickness: Vec<f64> =
        (space.positions().iter()).map(|&position| problem.thickness_at(0, &[position])[0]).collect();
    let (mut points, mut pressures, mut thicknesses) = (Vec::new(), Vec::new(), Vec::new());
    for t in 0..space.mesh().triangles().len() {
        if t % STRIDE == 0 || space.mesh().is_curved(t) {
            for probe in PROBES {
                points.push(Mapping::of(space.mesh(), t).at(probe).position);
                pressures.push(Field { space, values: &pressure }.value(t, probe));
                thicknesses.push(Field { space, values: &thickness }.value(t, probe));
            }
        }
    }
    let rule = Quadrature::for_degree(space.degree());
    let folder = Path::new(folder);
    std::fs::create_dir_all(folder)?;
    let quadrature = serde_json::json!({ "degree": rule.degree, "points": rule.points, "weights": rule.weights });
    let probes = serde_json::json!({ "points": points, "pressure": pressures, "film_thickness": thicknesses });
    std::fs::write(folder.join("quadrature.json"), quadrature.to_string())?;
    std::fs::write(folder.join("probes.json"), probes.to_string())?;
    Ok(())
}
