//! Random liners: every mesh made is good, every refusal is named.

use std::f64::consts::TAU;

use oilwedge_mesh::developed::LinerDomain;
use oilwedge_mesh::generate::{
    Blueprint, DrawingError, Feature, Grading, RoundedRectangle, RowLengths, Sense, generate, generate_graded,
    generate_in_rows,
};
use oilwedge_mesh::quality::share_across_flow;
use oilwedge_mesh::{Mesh, Quality};

/// A plain liner in rows follows the flow everywhere; the two senses are mirror images.
#[test]
fn plain_liners_in_rows_are_mirror_images() {
    let plain = Blueprint { features: Vec::new(), ..liner_with_groove(0.075, [0.01, 0.003], 0.0) };
    let [forwards, backwards] = [Sense::Forwards, Sense::Backwards].map(|sense| {
        let rows = RowLengths { along: &|_| 0.008, across: &|_| 0.005, sense, grading: Grading::RESOLVED };
        generate_in_rows(&plain, &rows).expect("a mesh")
    });
    assert_eq!(share_across_flow(&forwards), 0.0);
    // Centres of the triangles, in thirtieths of the 29 by 16 cells.
    let turn = TAU * plain.liner.radius;
    let centres = |mesh: &Mesh, sign: f64| {
        let centre = |t: usize| {
            let corners = mesh.corners(t);
            let [x, z] = [0, 1].map(|d| (corners[0][d] + corners[1][d] + corners[2][d]) / 3.0);
            [(sign * x).rem_euclid(turn) / turn * 870.0, z / plain.liner.length * 480.0].map(|x| x.round() as i64)
        };
        let mut centres: Vec<[i64; 2]> = (0..mesh.triangles().len()).map(centre).collect();
        centres.sort_unstable();
        centres
    };
    assert!(centres(&forwards, 1.0) == centres(&backwards, -1.0));
}

fn liner_with_groove(length: f64, half: [f64; 2], corner: f64) -> Blueprint {
    let liner = LinerDomain { radius: 0.0375, length, arc: None };
    let shape = RoundedRectangle { centre: [0.1, 0.0], half, corner };
    let groove = Feature { name: "groove".to_owned(), shape, meshed: false };
    Blueprint { liner, features: vec![groove], line: None }
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

/// A half groove that is narrow for the wanted size: by size it brings a few times the triangles of the plain liner (72
/// of edges of 9.5 mm), resolved fifty times as many.
#[test]
fn the_wanted_size_counts_beside_a_narrow_groove() {
    let groove = |grading| {
        let mut blueprint = liner_with_groove(0.019, [0.0424, 0.0015], 0.0);
        blueprint.liner.radius = 0.027;
        let mesh = generate_graded(&blueprint, &|_| 0.012, grading).expect("a mesh");
        assert!(Quality::of(&mesh).least_angle > 25.0);
        mesh.triangles().len()
    };
    let [resolved, by_size] = [Grading::RESOLVED, Grading::BY_SIZE].map(groove);
    assert!(by_size < 5 * 72 && resolved > 5 * by_size, "{resolved} {by_size}");
}

/// A rim of millions of edges is refused before it is cut, also where it lies between the samples of sizes.
#[test]
fn a_rim_too_long_for_its_width_is_refused() {
    let blueprint = liner_with_groove(1000.0, [2e-5, 450.0], 0.0);
    let faults = generate(&blueprint, &|_| 1.0).expect_err("too many triangles");
    assert!(matches!(&faults[..], [DrawingError::Failed { reason, .. }] if reason.contains("of them")), "{faults:?}");
}

/// Features touch each other, ends, edges of an arc and the film start; sides of other lengths end amid each other.
#[test]
fn features_that_touch_share_their_sides() {
    let rectangle = |name: &str, [from, to]: [f64; 2], [low, high]: [f64; 2], meshed| Feature {
        name: name.to_owned(),
        shape: RoundedRectangle {
            centre: [0.5 * (from + to), 0.5 * (low + high)],
            half: [0.5 * (to - from), 0.5 * (high - low)],
            corner: 0.0,
        },
        meshed,
    };
    let band = |name: &str, low: f64, high: f64| Feature {
        shape: RoundedRectangle {
            half: [f64::INFINITY, 0.5 * (high - low)],
            ..rectangle("", [0.0; 2], [low, high], true).shape
        },
        ..rectangle(name, [0.0; 2], [0.0; 2], true)
    };
    let (ends, tiny) = ([-0.03, 0.03], 1e-9);
    let cases = [
        // A dam behind a groove across the film, off by rounding.
        (
            None,
            None,
            vec![
                rectangle("groove", [0.0, 0.01], ends, false),
                rectangle("dam", [0.01 + tiny, 0.06], [-0.02, 0.02], true),
            ],
        ),
        // A step over the whole width at the edge of an arc, a narrower one at the other, a feed at an end.
        (
            Some(0.12),
            None,
            vec![
                rectangle("step", [0.0, 0.04], ends, true),
                rectangle("other", [0.1, 0.12], [0.0, 0.02], true),
                rectangle("feed", [0.06, 0.08], [0.02, 0.03], false),
            ],
        ),
        // A feed at the edge of an arc, a pocket behind it that is wider.
        (
            Some(0.12),
            None,
            vec![
                rectangle("feed", [0.0, 0.01], [-0.01, 0.01], false),
                rectangle("pocket", [0.01, 0.03], [-0.02, 0.015], true),
            ],
        ),
        // Pockets that touch at sides and at a corner, one beside a band, bands at an end.
        (
            None,
            None,
            vec![
                rectangle("a", [0.05, 0.07], [-0.01, 0.0], true),
                rectangle("b", [0.07, 0.1], [-0.005, 0.01], true),
                rectangle("c", [0.1, 0.12], [0.01, 0.015], true),
                band("low", -0.03, -0.025),
                band("lower", -0.025, -0.02),
                rectangle("d", [0.15, 0.17], [-0.02, -0.01], true),
            ],
        ),
        // Pockets on both sides of the film start.
        (
            None,
            Some(1.0),
            vec![
                rectangle("before", [0.02, 0.0375], [-0.01, 0.01], true),
                rectangle("behind", [0.0375, 0.05], [-0.015, 0.01], true),
            ],
        ),
    ];
    for (arc, line, features) in cases {
        let liner = LinerDomain { radius: 0.0375, length: 0.06, arc: arc.map(|width| (0.0, width / 0.0375)) };
        let blueprint = Blueprint { liner, features, line };
        let rows =
            RowLengths { along: &|_| 0.006, across: &|_| 0.005, sense: Sense::Forwards, grading: Grading::RESOLVED };
        let of =
            |mesh: Result<Mesh, Vec<DrawingError>>| mesh.unwrap_or_else(|faults| panic!("{faults:?}: {blueprint:?}"));
        for (mesh, least) in
            [(of(generate(&blueprint, &|_| 0.006)), 20.0), (of(generate_in_rows(&blueprint, &rows)), 0.5)]
        {
            let quality = Quality::of(&mesh);
            assert!(quality.least_angle >= least, "{} deg: {blueprint:?}", quality.least_angle);
            assert_eq!(quality.unnamed_boundary_edges, 0, "{blueprint:?}");
            let area = arc.unwrap_or(TAU * liner.radius) * liner.length;
            let cut_out = blueprint.features.iter().filter(|feature| !feature.meshed);
            let (found, wanted) =
                (quality.area, area - cut_out.map(|feature| feature.shape.area(TAU * liner.radius)).sum::<f64>());
            assert!((found / wanted - 1.0).abs() < 1e-6, "{found} {wanted}: {blueprint:?}");
            for feature in blueprint.features.iter().filter(|feature| feature.meshed) {
                let cells = &mesh.region(&feature.name).expect("a region").cells;
                let own: f64 = (cells.iter())
                    .map(|&t| {
                        let [a, b, c] = mesh.corners(t as usize);
                        0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))
                    })
                    .sum();
                let wanted = feature.shape.area(TAU * liner.radius);
                assert!((own / wanted - 1.0).abs() < 1e-6, "{}: {own} {wanted}", feature.name);
            }
        }
    }
    let refused = |features: Vec<Feature>| {
        let liner = liner_with_groove(0.06, [0.01, 0.003], 0.0).liner;
        let line = None;
        let faults = generate(&Blueprint { liner, features, line }, &|_| 0.006).expect_err("a fault");
        faults[0].to_string()
    };
    let feed = || rectangle("feed", [0.0, 0.02], [-0.01, 0.01], false);
    let hole = Feature { name: "hole".to_owned(), shape: RoundedRectangle::disc([0.03, 0.0], 0.01), meshed: false };
    let pocket = |x: [f64; 2], z: [f64; 2]| rectangle("pocket", x, z, true);
    for (features, words) in [
        (vec![hole.clone(), pocket([0.04, 0.06], [-0.01, 0.01])], "meet at 0.0 deg"),
        (vec![hole, pocket([0.035, 0.06], [-0.01, 0.01])], "\"hole\" and \"pocket\" overlap"),
        (vec![feed(), pocket([0.02001, 0.06], [-0.01, 0.02])], "leave 1.0e-5 m of land"),
        (vec![feed(), pocket([0.02, 0.06], [-0.01, 0.01001])], "with a part of 1.0e-5 m"),
        (vec![feed(), rectangle("other", [0.02, 0.06], [-0.01, 0.01], false)], "no film is between"),
        (vec![band("all", -0.03, 0.03)], "\"all\" is the whole liner"),
    ] {
        let told = refused(features);
        assert!(told.contains(words), "{told}");
    }
}
