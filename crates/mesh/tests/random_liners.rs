//! Random liners with holes, grooves and pockets are meshed well, or refused with a reason.

use std::f64::consts::TAU;

use oilwedge_mesh::developed::LinerDomain;
use oilwedge_mesh::generate::{
    Blueprint, DrawingError, Feature, Grading, RoundedRectangle, RowLengths, Sense, generate_graded, generate_in_rows,
};
use oilwedge_mesh::quality::share_across_flow;
use oilwedge_mesh::{Mesh, Quality};

use crate::random::Random;

fn feature(random: &mut Random, liner: &LinerDomain, index: usize) -> Feature {
    let (from, to) = liner.arc.unwrap_or((0.0, TAU));
    let centre = [liner.radius * random.between(from, to), liner.length * random.between(-0.4, 0.4)];
    let small = liner.radius.min(liner.length);
    let shape = match random.below(8) {
        0..=3 => RoundedRectangle::disc(centre, small * random.between(0.02, 0.2)),
        4 | 5 => {
            let half = [small * random.between(0.02, 0.25), small * random.between(0.02, 0.4)];
            let corner = if random.unit() < 0.5 { 0.0 } else { half[0].min(half[1]) * random.between(0.1, 1.0) };
            RoundedRectangle { centre, half, corner }
        }
        6 => RoundedRectangle {
            centre,
            half: [liner.radius * random.between(0.3, 1.5), small * random.between(0.02, 0.1)],
            corner: 0.0,
        },
        _ => RoundedRectangle { centre, half: [f64::INFINITY, small * random.between(0.02, 0.1)], corner: 0.0 },
    };
    let meshed = shape.is_full_turn() || random.unit() < 0.3;
    Feature { name: format!("feature_{index}"), shape, meshed }
}

fn blueprint(random: &mut Random) -> Blueprint {
    let radius = 10f64.powf(random.between(-3.0, 0.5));
    let arc = (random.unit() < 0.4).then(|| {
        let from = random.between(-1.0, 3.0);
        (from, from + random.between(0.3, 5.5))
    });
    let liner = LinerDomain { radius, length: radius * random.between(0.3, 4.0), arc };
    let count = random.below(5);
    let features = (0..count).map(|index| feature(random, &liner, index)).collect();
    Blueprint { liner, features, line: None }
}

/// Area [m2] of what is left of the liner, its rims as the quadratic arcs that a mesh has.
fn area(blueprint: &Blueprint) -> f64 {
    let liner = &blueprint.liner;
    let around = liner.arc.map_or(TAU, |(from, to)| to - from) * liner.radius;
    let cut_out = blueprint.features.iter().filter(|feature| !feature.meshed);
    around * liner.length - cut_out.map(|feature| feature.shape.area(around)).sum::<f64>()
}

/// What quadratic arcs add to or take from the area of circles: `r^2 a^5/960` an edge of the angle `a`.
fn arc_error(mesh: &Mesh, blueprint: &Blueprint) -> f64 {
    let mut error = 0.0;
    for feature in blueprint.features.iter().filter(|feature| !feature.meshed && feature.shape.corner > 0.0) {
        let Some(region) = mesh.region(&feature.name) else {
            continue;
        };
        for &edge in &region.edges {
            let [a, b, m] = mesh.edge_nodes(edge);
            let chord = (b[0] - a[0]).hypot(b[1] - a[1]);
            let bulge = (m[0] - 0.5 * (a[0] + b[0])).hypot(m[1] - 0.5 * (a[1] + b[1]));
            if bulge > 0.0 {
                let radius = feature.shape.corner;
                let angle = 2.0 * (0.5 * chord / radius).asin();
                let segment = 0.5 * radius * radius * (angle - angle.sin());
                error += segment - 2.0 / 3.0 * chord * bulge;
            }
        }
    }
    error
}

fn check(blueprint: &Blueprint, mesh: &Mesh, least_angle: f64) -> f64 {
    let quality = Quality::of(mesh);
    assert!(quality.least_angle >= least_angle, "{} deg: {blueprint:?}", quality.least_angle);
    assert_eq!(quality.unnamed_boundary_edges, 0, "{blueprint:?}");
    let expected = area(blueprint);
    let difference = quality.area - expected - arc_error(mesh, blueprint);
    assert!(difference.abs() < 1e-9 * expected, "area {difference:e}: {blueprint:?}");
    for feature in &blueprint.features {
        let region = mesh.region(&feature.name).unwrap_or_else(|| panic!("{}: {blueprint:?}", feature.name));
        assert_eq!(region.cells.is_empty(), !feature.meshed);
    }
    let ends = mesh.region("end_low").zip(mesh.region("end_high"));
    assert!(ends.is_some() && mesh.region("film").is_some());
    let length = |name: &str, axis: usize| -> f64 {
        let edges = mesh.region(name).map_or(&[][..], |region| &region.edges);
        let extent = |&edge: &u32| {
            let [a, b, _] = mesh.edge_nodes(edge);
            (b[axis] - a[axis]).abs()
        };
        edges.iter().map(extent).sum()
    };
    let around = blueprint.liner.arc.map_or(TAU, |(from, to)| to - from) * blueprint.liner.radius;
    assert!((length("end_low", 0) - around).abs() < 1e-9 * around);
    assert!((length("end_high", 0) - around).abs() < 1e-9 * around);
    if blueprint.liner.arc.is_some() {
        for name in ["arc_from", "arc_to"] {
            assert!((length(name, 1) - blueprint.liner.length).abs() < 1e-9 * around);
        }
    } else {
        // Both sides of the seam match: glued, it is no boundary.
        assert_eq!(mesh.period(), Some(blueprint.liner.circumference()));
    }
    quality.least_angle
}

/// One grading after the other.
fn grading(number: usize) -> Grading {
    [Grading::RESOLVED, Grading::BY_SIZE][number / 2 % 2]
}

/// Whether a refusal says what is wrong with the drawing.
fn are_named(faults: &[DrawingError], blueprint: &Blueprint) {
    for fault in faults {
        let unnamed = matches!(fault, DrawingError::Failed { .. } | DrawingError::Defective(_));
        assert!(!unnamed, "{fault}: {blueprint:?}");
    }
}

#[test]
fn random_liners_are_meshed_or_refused() {
    let mut random = Random(2024);
    let mut angles = Vec::new();
    while angles.len() < 300 {
        let blueprint = blueprint(&mut random);
        let size = blueprint.liner.radius.min(blueprint.liner.length) * random.between(0.05, 0.3);
        match generate_graded(&blueprint, &|_| size, grading(angles.len())) {
            Ok(mesh) => angles.push(check(&blueprint, &mesh, 20.0)),
            Err(faults) => are_named(&faults, &blueprint),
        }
    }
    angles.sort_unstable_by(f64::total_cmp);
    assert!(angles[150] >= 30.0, "median of the least angles {}", angles[150]);
}

/// Random liners in rows along the flow, up to four times as long as wide. Measured: no angle below 1 degree (beside
/// narrow grooves all around, where cells are long rectangles), 15 % of the area across the flow in the worst of small
/// liners with many features, 3 % in the median.
#[test]
fn random_liners_in_rows() {
    let mut random = Random(2025);
    let (mut angles, mut across) = (Vec::new(), Vec::new());
    while angles.len() < 100 {
        let blueprint = blueprint(&mut random);
        let size = blueprint.liner.radius.min(blueprint.liner.length) * random.between(0.05, 0.3);
        let spacing = size * random.between(0.25, 1.0);
        let rows = RowLengths {
            along: &|_| size,
            across: &|_| spacing,
            sense: if angles.len() % 2 == 0 { Sense::Forwards } else { Sense::Backwards },
            grading: grading(angles.len()),
        };
        match generate_in_rows(&blueprint, &rows) {
            Ok(mesh) => {
                angles.push(check(&blueprint, &mesh, 0.5));
                across.push(share_across_flow(&mesh));
            }
            Err(faults) => are_named(&faults, &blueprint),
        }
    }
    across.sort_unstable_by(f64::total_cmp);
    assert!(across[50] < 0.05 && across[99] < 0.3, "{across:?}");
}
