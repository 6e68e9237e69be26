//! Meshes with obtuse angles, on which the scheme of the mass-conserving film is not positive: a film is right, or
//! refused with the place where it is not, or with its circles; nothing is NaN.

use std::f64::consts::TAU;
use std::sync::Arc;

use oilwedge_fem::newton::NewtonFailure;
use oilwedge_mesh::Mesh;
use oilwedge_reynolds::quantities::{flow::flows, load::load};
use oilwedge_reynolds::supply::BoundaryKind;
use oilwedge_reynolds::{Cavitation, FilmSystem, NoFilm};
use oilwedge_tests::random_bearings::Dice;
use oilwedge_tests::*;

const LENGTH: f64 = 0.05;

/// A ring with a meshed feed whose inner vertices are moved by up to `part` of a cell; none if it folds.
fn shaken(columns: u32, rows: u32, part: f64, seed: u64) -> Option<Arc<FilmSystem>> {
    let mut raw = ring(columns, rows, LENGTH, 0.0).to_raw();
    let cell = [TAU * RADIUS / f64::from(columns), LENGTH / f64::from(rows)];
    let mut dice = Dice::new(seed);
    for point in raw.points.iter_mut().filter(|point| point[1].abs() < 0.499 * LENGTH) {
        (0..2).for_each(|d| point[d] += part * cell[d] * dice.between(-1.0, 1.0));
    }
    let mesh = Mesh::build(raw).ok()?;
    let near = |c: &[f64; 2]| (c[0] - 0.15).abs() < 1.5 * cell[0] && c[1].abs() < 0.25 * LENGTH;
    let inside = |t: &u32| mesh.corners(*t as usize).iter().all(near);
    let mut regions = ends(&mesh, LENGTH, None);
    let mut feed = regions[0].clone();
    feed.name = "feed".into();
    feed.kind = BoundaryKind::Feed;
    feed.pressure = 1e5;
    feed.edges = Vec::new();
    feed.cells = (0..mesh.triangles().len() as u32).filter(inside).collect();
    regions.push(feed);
    FilmSystem::new(Arc::new(mesh), 2, regions).ok().map(Arc::new)
}

#[test]
fn shaken_meshes_have_a_film_or_a_place_where_it_is_wrong() {
    let (mut films, mut refused) = (0, 0);
    for (columns, rows) in [(16, 64), (24, 24), (96, 6)] {
        // Both eccentricities at every second step of the way to folded meshes.
        for seed in (0..30u64).filter(|seed| seed % 4 < 2) {
            let part = 0.05 + 0.01 * seed as f64;
            let Some(system) = shaken(columns, rows, part, seed) else {
                continue;
            };
            let mut film = plain_film(LENGTH, if seed % 2 == 0 { 0.6 } else { 0.9 }, 0.3, SPEED);
            film.cavitation = Cavitation::Jfo { pressure: 0.0 };
            let told = format!("{columns} x {rows}, {part}");
            match film.solve(&system) {
                Ok(solution) => {
                    films += 1;
                    let fraction = solution.solution.film_fraction.as_ref().expect("a mass-conserving film");
                    let sound = |theta: &f64| *theta >= -1e-9 && *theta <= 1.0 + 1e-9;
                    assert!(fraction.values.iter().all(sound), "{told}");
                    assert!(flows(&solution).imbalance < 1e-10, "{told}");
                    assert!(load(&solution).magnitude() > 0.0, "{told}");
                }
                Err(NoFilm::FilmFraction { fraction, angle, z, couplings }) => {
                    refused += 1;
                    assert!(fraction < 0.0 && couplings > 0, "{told}: {fraction} {couplings}");
                    assert!(z.abs() <= 0.5 * LENGTH && angle.abs() < 7.0, "{told}: {angle} {z}");
                }
                Err(NoFilm::NotConverged(NewtonFailure::Cycling { .. })) => refused += 1,
                Err(other) => panic!("{told}: {other}"),
            }
        }
    }
    assert!(films >= 5 && refused >= 5, "{films} films, {refused} refused");
}
