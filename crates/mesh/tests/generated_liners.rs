//! Random liners: every mesh made is good, every refusal is named.

use std::f64::consts::TAU;

use oilwedge_mesh::developed::Liner;
use oilwedge_mesh::generate::{Blueprint, DrawingError, Feature, Rows, Sense, Shape, generate, generate_in_rows};
use oilwedge_mesh::quality::share_across_flow;
use oilwedge_mesh::{Mesh, Quality};

/// A plain liner in rows follows the flow everywhere; the two senses are mirror images.
#[test]
fn plain_liners_in_rows_are_mirror_images() {
    let plain = Blueprint {
        features: Vec::new(),
        ..liner_with_groove(0.075, [0.01, 0.003], 0.0)
    };
    let [forwards, backwards] = [Sense::Forwards, Sense::Backwards].map(|sense| {
        let rows = Rows {
            along: &|_| 0.008,
            across: &|_| 0.005,
            sense,
        };
        generate_in_rows(&plain, &rows).expect("a mesh")
    });
    assert_eq!(share_across_flow(&forwards), 0.0);
    // Centres of the triangles, in thirtieths of the 29 by 16 cells.
    let turn = TAU * plain.liner.radius;
    let centres = |mesh: &Mesh, sign: f64| {
        let centre = |t: usize| {
            let corners = mesh.corners(t);
            let [x, z] = [0, 1].map(|d| (corners[0][d] + corners[1][d] + corners[2][d]) / 3.0);
            [
                (sign * x).rem_euclid(turn) / turn * 870.0,
                z / plain.liner.length * 480.0,
            ]
            .map(|x| x.round() as i64)
        };
        let mut centres: Vec<[i64; 2]> = (0..mesh.triangles().len()).map(centre).collect();
        centres.sort_unstable();
        centres
    };
    assert!(centres(&forwards, 1.0) == centres(&backwards, -1.0));
}

fn liner_with_groove(length: f64, half: [f64; 2], corner: f64) -> Blueprint {
    let liner = Liner {
        radius: 0.0375,
        length,
        arc: None,
    };
    let shape = Shape {
        centre: [0.1, 0.0],
        half,
        corner,
    };
    let groove = Feature {
        name: "groove".to_owned(),
        shape,
        meshed: false,
    };
    Blueprint {
        liner,
        features: vec![groove],
        line: None,
    }
}

/// Small round corners, and the short sides that large ones leave, are refined where they are, not along the whole rim.
#[test]
fn small_corners_are_refined_for_themselves() {
    for corner in [2e-5, 0.0029] {
        let blueprint = liner_with_groove(0.075, [0.01, 0.003], corner);
        let mesh = generate(&blueprint, &|_| 0.004).expect("a mesh");
        let triangles = mesh.triangles().len();
        assert!(triangles < 12_000, "corners of {corner} m: {triangles}");
        assert!(Quality::of(&mesh).least_angle > 25.0);
    }
    let blueprint = liner_with_groove(0.075, [0.01, 0.003], 1e-7);
    let faults = generate(&blueprint, &|_| 0.004).expect_err("corners too small");
    assert!(matches!(faults[..], [DrawingError::SmallCorner { .. }]), "{faults:?}");
}

/// A rim of millions of edges is refused before it is cut, also where it lies between the samples of sizes.
#[test]
fn a_rim_too_long_for_its_width_is_refused() {
    let blueprint = liner_with_groove(1000.0, [2e-5, 450.0], 0.0);
    let faults = generate(&blueprint, &|_| 1.0).expect_err("too many triangles");
    assert!(
        matches!(&faults[..], [DrawingError::Failed { reason, .. }] if reason.contains("of them")),
        "{faults:?}"
    );
}
