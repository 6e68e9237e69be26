//! Coarser meshes of shipped, generated and refined liners: how many unknowns are left, and where.

use std::f64::consts::TAU;
use std::path::PathBuf;
use std::time::Instant;

use oilwedge_mesh::coarsen::{Coarser, coarser};
use oilwedge_mesh::developed::{Liner, read};
use oilwedge_mesh::generate::{Blueprint, Feature, Shape, generate};
use oilwedge_mesh::{Locator, Mesh, Quality, refine};

const RADIUS: f64 = 0.0375;

fn liner(arc: Option<(f64, f64)>) -> Liner {
    Liner {
        radius: RADIUS,
        length: 0.075,
        arc,
    }
}

fn shell() -> Liner {
    liner(Some((40f64.to_radians(), 220f64.to_radians())))
}

fn shipped(name: &str, liner: &Liner) -> Mesh {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR"))
        .join("../../meshes")
        .join(name);
    read(path, liner, 1.0).unwrap_or_else(|error| panic!("{error}"))
}

fn feature(name: &str, degrees: f64, z: f64, half: [f64; 2], corner: f64, meshed: bool) -> Feature {
    let shape = Shape {
        centre: [RADIUS * degrees.to_radians(), z],
        half,
        corner,
    };
    Feature {
        name: name.to_owned(),
        shape,
        meshed,
    }
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

fn check(name: &str, mesh: &Mesh, liner: &Liner) {
    let started = Instant::now();
    let coarse = coarser(mesh, liner, None, 2.0).unwrap_or_else(|| panic!("{name}: no coarser mesh"));
    let elapsed = started.elapsed();
    let fall = mesh.quadratic_nodes() as f64 / coarse.mesh.quadratic_nodes() as f64;
    let ratios = ratios(mesh, &coarse);
    let part = |part: f64| ratios[(part * (ratios.len() - 1) as f64) as usize];
    let quality = Quality::of(&coarse.mesh);
    let finer = Quality::of(mesh);
    println!(
        "{name:40} {:7} -> {:6} /{fall:.2}  size ratio {:.2} {:.2} {:.2}  grading {:5.1} -> {:5.1}  least angle {:.1}  {:.1} ms",
        mesh.quadratic_nodes(),
        coarse.mesh.quadratic_nodes(),
        part(0.05),
        part(0.5),
        part(0.95),
        finer.longest_edge / finer.shortest_edge,
        quality.longest_edge / quality.shortest_edge,
        quality.least_angle,
        elapsed.as_secs_f64() * 1e3,
    );
}

#[test]
fn unknowns_fall_by_four() {
    for name in [
        "ring.msh",
        "flexpde_ring.msh",
        "flexpde_ring_straight.msh",
        "flexpde_ring_top.msh",
        "grooved_liner.msh",
    ] {
        check(name, &shipped(name, &liner(None)), &liner(None));
    }
    for name in [
        "flexpde_shell.msh",
        "flexpde_shell_meshed_hole.msh",
        "flexpde_study_size.msh",
    ] {
        check(name, &shipped(name, &shell()), &shell());
    }
    for liner in [liner(None), shell()] {
        for features in [vec![], features()] {
            for size in [0.006, 0.003, 0.0015, 0.0008] {
                let blueprint = Blueprint {
                    liner,
                    features: features.clone(),
                    line: None,
                };
                let kind = format!(
                    "{} {} features {size}",
                    if liner.arc.is_some() { "arc" } else { "ring" },
                    features.len()
                );
                let mesh = generate(&blueprint, &|_| size).unwrap();
                check(&kind, &mesh, &liner);
                // Thirty times finer at one angle, over a tenth of a radian.
                let graded = |[x, _]: [f64; 2]| {
                    let off = (x / RADIUS - 2.8 + 0.5 * TAU).rem_euclid(TAU) - 0.5 * TAU;
                    8.0 * size * (off.abs() * 0.8 + 1.0 / 30.0).min(1.0)
                };
                let mesh = generate(&blueprint, &graded).unwrap();
                check(&format!("{kind} graded"), &mesh, &liner);
                let mut mesh = generate(&blueprint, &|_| 2.0 * size).unwrap();
                for round in 0..8 {
                    let place = [RADIUS * 2.0, 0.02];
                    let near = |t: usize| {
                        let c = centroid(&mesh, t);
                        (c[0] - place[0]).hypot(c[1] - place[1]) < 0.02 * 0.6f64.powi(round)
                    };
                    let marked: Vec<bool> = (0..mesh.triangles().len()).map(near).collect();
                    mesh = refine::local(&mesh, &marked).unwrap().mesh;
                }
                check(&format!("{kind} refined"), &mesh, &liner);
            }
        }
    }
}
