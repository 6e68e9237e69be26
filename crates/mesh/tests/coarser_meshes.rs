//! Coarser meshes of shipped, generated and refined liners: how many unknowns are left, and where.

use std::f64::consts::{PI, TAU};
use std::path::PathBuf;

use oilwedge_mesh::coarsen::{Coarser, coarser, coarser_in_rows};
use oilwedge_mesh::developed::{LinerDomain, read};
use oilwedge_mesh::generate::{
    Blueprint, Feature, Grading, RoundedRectangle, RowLengths, Sense, generate, generate_in_rows,
};
use oilwedge_mesh::quality::share_across_flow;
use oilwedge_mesh::{Locator, Mesh, Quality, refine};

const RADIUS: f64 = 0.0375;

fn liner(arc: Option<(f64, f64)>) -> LinerDomain {
    LinerDomain { radius: RADIUS, length: 0.075, arc }
}

fn shell() -> LinerDomain {
    liner(Some((40f64.to_radians(), 220f64.to_radians())))
}

fn shipped(name: &str, liner: &LinerDomain) -> Mesh {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../meshes").join(name);
    read(path, liner, 1.0).unwrap_or_else(|error| panic!("{error}"))
}

fn feature(name: &str, degrees: f64, z: f64, half: [f64; 2], corner: f64, meshed: bool) -> Feature {
    let shape = RoundedRectangle { centre: [RADIUS * degrees.to_radians(), z], half, corner };
    Feature { name: name.to_owned(), shape, meshed }
}

/// A round hole, a cut-out groove and a meshed one.
fn features() -> Vec<Feature> {
    vec![
        feature("hole", 130.0, 0.0, [0.0085; 2], 0.0085, false),
        feature("groove", 85.0, 0.0, [0.004, 0.028], 0.0, false),
        feature("pocket", 180.0, 0.01, [0.006, 0.012], 0.002, true),
    ]
}

fn area(mesh: &Mesh, t: usize) -> f64 {
    let [a, b, c] = mesh.corners(t);
    0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))
}

fn centroid(mesh: &Mesh, t: usize) -> [f64; 2] {
    let [a, b, c] = mesh.corners(t);
    [0, 1].map(|d| (a[d] + b[d] + c[d]) / 3.0)
}

/// Ratios of the local edge lengths, ascending: of triangles whose centroid lies in a triangle of the finer mesh.
fn ratios(mesh: &Mesh, coarse: &Coarser) -> Vec<f64> {
    let locator = Locator::new(mesh);
    let coarser = &coarse.mesh;
    let inside = (0..coarser.triangles().len()).filter(|&t| locator.find(centroid(coarser, t)).is_some());
    let ratio = |t: usize| (area(coarser, t) / area(mesh, coarse.parents[t] as usize)).sqrt();
    let mut ratios: Vec<f64> = inside.map(ratio).collect();
    ratios.sort_unstable_by(f64::total_cmp);
    ratios
}

/// Checks the coarser mesh of `mesh` and describes it.
fn check(name: &str, mesh: &Mesh, liner: &LinerDomain, line: Option<f64>) {
    let coarse = coarser(mesh, liner, line, 2.0).unwrap_or_else(|| panic!("{name}: no coarser mesh"));
    let fall = mesh.quadratic_nodes() as f64 / coarse.mesh.quadratic_nodes() as f64;
    let ratios = ratios(mesh, &coarse);
    let [low, median, high] = [0.05, 0.5, 0.95].map(|part| ratios[(part * (ratios.len() - 1) as f64) as usize]);
    let quality = Quality::of(&coarse.mesh);
    assert!((3.0..6.0).contains(&fall), "{name}: {fall}");
    assert!(quality.least_angle > 25.0, "{name}: {}", quality.least_angle);
    // The areas of single triangles scatter, in both meshes.
    assert!((1.7..2.2).contains(&median), "{name}: {median}");
    assert!(low > 1.1 && high < 3.0, "{name}: {low} {high}");
    check_geometry(name, mesh, &coarse.mesh, liner);
}

/// The coarser mesh is the plain liner.
fn check_geometry(name: &str, mesh: &Mesh, coarser: &Mesh, liner: &LinerDomain) {
    let (from, to) = liner.arc.unwrap_or((0.0, TAU));
    let quality = Quality::of(coarser);
    let whole = liner.radius * (to - from) * liner.length;
    assert!((quality.area / whole - 1.0).abs() < 1e-12, "{name}");
    assert_eq!((quality.curved_cells, quality.unnamed_boundary_edges), (0, 0), "{name}");
    assert_eq!(coarser.period(), mesh.period(), "{name}");
    let mut names: Vec<&str> = coarser.regions().iter().map(|region| region.name.as_str()).collect();
    names.sort_unstable();
    match liner.arc {
        None => assert_eq!(names, ["end_high", "end_low", "film"], "{name}"),
        Some(_) => assert_eq!(names, ["arc_from", "arc_to", "end_high", "end_low", "film"], "{name}"),
    }
}

#[test]
fn shipped_meshes() {
    for name in
        ["ring.msh", "flexpde_ring.msh", "flexpde_ring_straight.msh", "flexpde_ring_top.msh", "grooved_liner.msh"]
    {
        check(name, &shipped(name, &liner(None)), &liner(None), None);
    }
    for name in ["flexpde_shell.msh", "flexpde_shell_meshed_hole.msh", "flexpde_study_size.msh"] {
        check(name, &shipped(name, &shell()), &shell(), None);
    }
}

/// Sizes [m] thirty times finer at one angle than far from it.
fn graded(size: f64) -> impl Fn([f64; 2]) -> f64 {
    move |[x, _]| {
        let off = (x / RADIUS - 2.8 + 0.5 * TAU).rem_euclid(TAU) - 0.5 * TAU;
        size * (0.4 * off.abs() + 1.0 / 30.0).min(1.0)
    }
}

/// Refined again and again around a place.
fn refined(mut mesh: Mesh, rounds: i32) -> Mesh {
    for round in 0..rounds {
        let near = |t: usize| {
            let [x, z] = centroid(&mesh, t);
            (x - 2.0 * RADIUS).hypot(z - 0.02) < 0.02 * 0.6f64.powi(round)
        };
        let marked: Vec<bool> = (0..mesh.triangles().len()).map(near).collect();
        mesh = refine::local(&mesh, &marked).unwrap().mesh;
    }
    mesh
}

#[test]
fn generated_meshes_even_graded_and_refined() {
    for (liner, kind) in [(liner(None), "ring"), (shell(), "arc")] {
        for features in [vec![], features()] {
            let kind = format!("{kind}, {} features", features.len());
            let blueprint = Blueprint { liner, features, line: None };
            for size in [0.006, 0.003, 0.0015] {
                let mesh = generate(&blueprint, &|_| size).unwrap();
                check(&format!("{kind}, {size}"), &mesh, &liner, None);
                let mesh = generate(&blueprint, &graded(4.0 * size)).unwrap();
                // Cut elsewhere than the finer ring.
                let line = liner.arc.is_none().then_some(4.0);
                check(&format!("{kind}, {size}, graded"), &mesh, &liner, line);
                let mesh = generate(&blueprint, &|_| 2.0 * size).unwrap();
                check(&format!("{kind}, {size}, refined"), &refined(mesh, 6), &liner, None);
            }
        }
    }
}

#[test]
fn parents_hold_the_centroids_or_are_nearest() {
    let mesh = shipped("flexpde_ring.msh", &liner(None));
    let coarse = coarser(&mesh, &liner(None), None, 2.0).unwrap();
    let locator = Locator::new(&mesh);
    assert_eq!(coarse.parents.len(), coarse.mesh.triangles().len());
    let mut in_the_hole = 0;
    for (t, &parent) in coarse.parents.iter().enumerate() {
        let [x, z] = centroid(&coarse.mesh, t);
        match locator.find([x, z]) {
            Some((found, _)) => assert_eq!(found, parent as usize),
            None => {
                in_the_hole += 1;
                let out = (x - RADIUS * 130f64.to_radians()).hypot(z);
                assert!(out < 0.0085);
                let near = centroid(&mesh, parent as usize);
                assert!((near[0] - x).hypot(near[1] - z) < 0.0085 - out + 0.001);
            }
        }
    }
    assert!(in_the_hole > 10, "{in_the_hole}");
}

#[test]
fn cut_outs_are_filled_with_few_triangles() {
    let blueprint = Blueprint { liner: liner(None), features: features(), line: None };
    let mesh = generate(&blueprint, &|_| 0.001).unwrap();
    let coarse = coarser(&mesh, &liner(None), None, 2.0).unwrap().mesh;
    let rim = mesh.region("hole").unwrap().edges.len() as f64;
    let in_hole = |t: usize| {
        let [x, z] = centroid(&coarse, t);
        (x - RADIUS * 130f64.to_radians()).hypot(z) < 0.0085
    };
    let filled = (0..coarse.triangles().len()).filter(|&t| in_hole(t)).count() as f64;
    // A disc of n edges h = 2 pi r/n around, filled with equilateral triangles of edge 2 h: pi r^2/(0.433 (2 h)^2).
    let even = rim * rim / (16.0 * PI * 0.433);
    assert!(filled < 0.5 * even && filled > 0.5 * rim);
}

#[test]
fn a_line_stays_a_line_of_edges() {
    let angle = 1.234;
    let blueprint = Blueprint { liner: liner(None), features: features(), line: Some(angle) };
    let mut mesh = generate(&blueprint, &graded(0.006)).unwrap();
    for _ in 0..2 {
        mesh = coarser(&mesh, &liner(None), Some(angle), 2.0).unwrap().mesh;
        let on = |point: [f64; 2]| (point[0] - RADIUS * angle).abs() < 1e-12;
        let edges = 0..mesh.topology().edges.len() as u32;
        let nodes = edges.map(|edge| mesh.edge_nodes(edge));
        let length: f64 = nodes.filter(|[a, b, _]| on(*a) && on(*b)).map(|[a, b, _]| (b[1] - a[1]).abs()).sum();
        assert!((length - 0.075).abs() < 1e-12, "{length}");
    }
}

#[test]
fn no_mesh_rather_than_a_useless_one() {
    let mesh = shipped("ring.msh", &liner(None));
    assert!(coarser(&mesh, &liner(None), None, 2.0).is_some());
    assert!(coarser(&mesh, &liner(None), None, 6.0).is_none(), "too few triangles");
    assert!(coarser(&mesh, &shell(), None, 2.0).is_none(), "a ring is no arc");
    for ratio in [0.0, -1.0, f64::NAN, 1e-6] {
        assert!(coarser(&mesh, &liner(None), None, ratio).is_none(), "{ratio}");
    }
}

/// Thin rows at one end stay thin.
#[test]
fn coarser_meshes_of_rows_are_rows() {
    let blueprint = Blueprint { liner: liner(None), features: features(), line: None };
    let across = |z: f64| 0.0005 + 0.03 * (z + 0.0375);
    let rows = RowLengths { along: &|_| 0.002, across: &across, sense: Sense::Forwards, grading: Grading::RESOLVED };
    let fine = generate_in_rows(&blueprint, &rows).expect("a mesh");
    let coarse = coarser_in_rows(&fine, &blueprint.liner, None, 2.0, Sense::Forwards).expect("a mesh").mesh;
    assert!(share_across_flow(&fine) > 0.0);
    assert_eq!(share_across_flow(&coarse), 0.0);
    let share = fine.triangles().len() as f64 / coarse.triangles().len() as f64;
    assert!((3.0..6.0).contains(&share), "{share}");
    let lowest = |mesh: &Mesh| {
        let above = mesh.points().iter().map(|point| point[1] + 0.0375).filter(|z| *z > 1e-9);
        above.fold(f64::INFINITY, f64::min)
    };
    let thicker = lowest(&coarse) / lowest(&fine);
    assert!((1.4..3.0).contains(&thicker), "{thicker}");
}
