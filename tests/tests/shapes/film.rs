//! Shapes as parts of the film thickness: their neutral values, sums, and tangents.

use std::sync::Arc;

use oilwedge_bearing::Coordinates;
use oilwedge_bearing::coordinates::{moved, unit};
use oilwedge_reynolds::film_thickness::MeasuredSurface;
use oilwedge_reynolds::film_thickness::{Crown, Oval, Profile, Shape, SurfaceGrid, Worn};
use oilwedge_reynolds::quantities::load::{load, load_change};
use oilwedge_reynolds::solve::Neighbour;
use oilwedge_reynolds::{Cavitation, CentreVelocity, FilmProblem};
use oilwedge_tests::tilted_bearings::{carried, slope, tilted};
use oilwedge_tests::*;

const LENGTH: f64 = 0.06;

fn shaped(mut problem: FilmProblem, profiles: &[Arc<dyn Profile>]) -> FilmProblem {
    let shapes = profiles.iter().map(|profile| Arc::new(Shape(profile.clone())) as _);
    problem.film_thickness.extend(shapes);
    problem
}

fn crown(depth: f64) -> Arc<dyn Profile> {
    Arc::new(Crown { depth, half_length: 0.5 * LENGTH })
}

fn worn(depth: f64) -> Arc<dyn Profile> {
    Arc::new(Worn { radius: RADIUS, depth, angle: 0.4, half_width: 0.6 })
}

fn oval(depth: f64) -> Arc<dyn Profile> {
    Arc::new(Oval { radius: RADIUS, depth, angle: 1.1 })
}

/// A tilted film of this model.
fn bearing(cavitation: Cavitation) -> FilmProblem {
    let mut problem = tilted(plain_film(LENGTH, 0.6, 0.3, SPEED), slope([0.2, -0.1]));
    problem.cavitation = cavitation;
    problem
}

const MODELS: [Cavitation; 3] =
    [Cavitation::None, Cavitation::Reynolds { pressure: 0.0 }, Cavitation::Jfo { pressure: 0.0 }];

#[test]
fn depth_zero_is_absence() {
    let system = ring_system(48, 8, LENGTH, Some(std::f64::consts::PI));
    let flat = SurfaceGrid {
        angles: (0..36).map(|k| std::f64::consts::TAU * f64::from(k) / 36.0).collect(),
        zs: vec![-0.03, 0.0, 0.03],
        depths: vec![vec![0.0; 3]; 36],
    };
    let measured: Arc<dyn Profile> = Arc::new(MeasuredSurface::new(&flat, RADIUS, LENGTH, true));
    for model in MODELS {
        let plain = carried(&bearing(model), &system);
        for profile in [crown(0.0), worn(0.0), oval(0.0), measured.clone()] {
            let zero = carried(&shaped(bearing(model), std::slice::from_ref(&profile)), &system);
            for k in 0..2 {
                let size = plain.force[0].hypot(plain.force[1]);
                let off =
                    [(plain.force[k] - zero.force[k]) / size, (plain.moment[k] - zero.moment[k]) / (size * LENGTH)];
                assert!(off.iter().all(|off| off.abs() < 1e-12), "{model:?} {profile:?}: {off:?}");
            }
        }
    }
}

/// A crown on the bore and one on the shaft that cancel it leave the cylinder.
#[test]
fn depths_add_up() {
    let system = ring_system(48, 8, LENGTH, None);
    let plain = carried(&bearing(MODELS[1]), &system);
    let both = carried(&shaped(bearing(MODELS[1]), &[crown(4e-6), oval(3e-6), crown(-4e-6), oval(-3e-6)]), &system);
    for k in 0..2 {
        assert!((plain.force[k] - both.force[k]).abs() < 1e-11 * plain.force[0].hypot(plain.force[1]));
    }
}

/// `d(W, m)/d(e, g)` of a shaped film against central differences, its set unchanged.
#[test]
fn the_tangent_matches_differences() {
    for model in MODELS {
        let system = ring_alone(72, 12, LENGTH, Some(160f64.to_radians()));
        let problem = shaped(bearing(model), &[crown(5e-6), worn(6e-6), oval(3e-6)]);
        let system = Arc::new(match problem.needs_start() {
            true => system.with_coarser(&problem, oilwedge_reynolds::levels::LevelLayout::Rows),
            false => system,
        });
        let film = problem.solve(&system).unwrap_or_else(|reason| panic!("{reason}"));
        let coordinates = Coordinates { order: 4, arm: 0.5 * LENGTH };
        let here = coordinates.at(&problem.journal);
        let at = |place| {
            let problem = FilmProblem { journal: coordinates.placed(&problem.journal, place), ..problem.clone() };
            let moved = problem.solve_from(&system, Neighbour::Start(&film)).expect("a film");
            assert_eq!(moved.solution.cavity, film.solution.cavity, "the set has changed");
            coordinates.forces(&load(&moved).total.resultant())
        };
        let columns: Vec<_> = (0..4)
            .map(|k| {
                let change = coordinates.change(&problem.journal, &CentreVelocity::default(), unit(k));
                let unknown = film.unknown_change(&change).expect("a tangent");
                coordinates.forces(&load_change(&film, &[(&change).into()], &unknown))
            })
            .collect();
        let step = 1e-6 * CLEARANCE;
        for k in 0..4 {
            let (ahead, behind) = (at(moved(here, step, unit(k))), at(moved(here, -step, unit(k))));
            for d in 0..4 {
                let difference = (ahead[d] - behind[d]) / (2.0 * step);
                let size = (columns[d][d] * columns[k][k]).abs().sqrt();
                let error = (difference - columns[k][d]).abs() / size;
                assert!(error < 1e-6, "{model:?} {d} {k}: {error:e}");
            }
        }
    }
}
