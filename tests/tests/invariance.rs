//! What must not change the answer: the frame, the mirror, the numbers of the mesh, the threads.

use std::f64::consts::PI;
use std::sync::Arc;

use oilwedge_mesh::Mesh;
use oilwedge_reynolds::FilmSystem;
use oilwedge_reynolds::quantities::{flow::flows, load::load, similarity::attitude_angle};
use oilwedge_tests::*;

const LENGTH: f64 = 0.1;

/// Load [N] in polar form and attitude angle [rad].
fn solve(system: &Arc<FilmSystem>, min_film_angle: f64, speed: f64) -> [f64; 3] {
    let film = plain_film(LENGTH, 0.7, min_film_angle, speed);
    let solution = film.solve(system).unwrap();
    let load = load(&solution);
    assert!(flows(&solution).imbalance < 1e-10);
    [load.magnitude(), load.angle(), attitude_angle(&film.journal, load.angle())]
}

fn close(a: f64, b: f64) {
    assert!((a - b).abs() < 1e-10 * a.abs().max(1.0), "{a} {b}");
}

#[test]
fn rotation_of_the_frame() {
    let reference = solve(&ring_system(48, 8, LENGTH, Some(0.0)), PI, SPEED);
    for turn in [0.3, 2.0, -1.0] {
        let turned = solve(&ring_system(48, 8, LENGTH, Some(turn)), PI + turn, SPEED);
        close(turned[0], reference[0]);
        close((turned[1] - reference[1] - turn + PI).rem_euclid(2.0 * PI), PI);
        close(turned[2], reference[2]);
    }
}

/// The mesh is its own mirror image, so phi -> -phi with reversed speed is the same discrete problem.
#[test]
fn mirror_with_reversed_speed() {
    let system = ring_system(48, 8, LENGTH, None);
    let ahead = solve(&system, 1.0, SPEED);
    let back = solve(&system, -1.0, -SPEED);
    close(back[0], ahead[0]);
    close(back[1], -ahead[1]);
    close(back[2], ahead[2]);
}

#[test]
fn renumbered_mesh() {
    let mesh = ring(48, 8, LENGTH, 0.0);
    let turned = renumbered(&mesh);
    let system_of = |mesh: Mesh| {
        let regions = ends(&mesh, LENGTH, None);
        Arc::new(FilmSystem::new(Arc::new(mesh), 2, regions).unwrap())
    };
    let (reference, other) = (system_of(mesh), system_of(turned));
    let (a, b) = (solve(&reference, 1.0, SPEED), solve(&other, 1.0, SPEED));
    a.iter().zip(b).for_each(|(a, b)| close(*a, b));
}

#[test]
fn threads_give_the_same_bits() {
    let system = ring_system(96, 24, LENGTH, None);
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| solve(&system, 1.0, SPEED).map(f64::to_bits))
    };
    assert_eq!(on(1), on(3));
}
