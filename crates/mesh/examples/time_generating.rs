//! `time_generating [SIZE ...]`: seconds to mesh a ring with a feed hole, by edge length in mm.

use oilwedge_mesh::Quality;
use oilwedge_mesh::developed::LinerDomain;
use oilwedge_mesh::generate::{Blueprint, Feature, RoundedRectangle, generate};

fn main() {
    let liner = LinerDomain { radius: 0.0375, length: 0.075, arc: None };
    let shape = RoundedRectangle::disc([0.0375 * 130f64.to_radians(), 0.0], 0.0085);
    let hole = Feature { name: "feed_hole".to_owned(), shape, meshed: false };
    let blueprint = Blueprint { liner, features: vec![hole], line: None };
    let sizes: Vec<f64> = std::env::args().skip(1).filter_map(|text| text.parse().ok()).collect();
    for size in if sizes.is_empty() { vec![12.0, 4.0, 1.0, 0.26] } else { sizes } {
        let start = std::time::Instant::now();
        match generate(&blueprint, &|_| 1e-3 * size) {
            Ok(mesh) => {
                let quality = Quality::of(&mesh);
                println!(
                    "{size} mm: {} unknowns, least angle {:.1} deg, {:.1} ms",
                    quality.quadratic_nodes,
                    quality.least_angle,
                    1e3 * start.elapsed().as_secs_f64()
                );
            }
            Err(faults) => println!("{size} mm: {faults:?}"),
        }
    }
}
