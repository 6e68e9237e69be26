//! Stiffness and damping against differences of the same discrete film, and identities that they must meet.

use std::sync::Arc;

use oilwedge_bearing::Coefficients;
use oilwedge_bearing::dynamics::Square;
use oilwedge_reynolds::lubricant::PressureLaw;
use oilwedge_reynolds::lubricant::barus::Barus;
use oilwedge_reynolds::quantities::load::load;
use oilwedge_reynolds::solve::Neighbour;
use oilwedge_reynolds::{Cavitation, FilmProblem, FilmSystem, JournalState, SolvedFilm, terms};
use oilwedge_tests::tilted_bearings::{slope, tilted};
use oilwedge_tests::*;

const LENGTH: f64 = 0.06;
const MODELS: [Cavitation; 4] = [
    Cavitation::None,
    Cavitation::Guembel { pressure: 0.0 },
    Cavitation::Reynolds { pressure: 0.0 },
    Cavitation::Jfo { pressure: 0.0 },
];

/// A tilted journal that moves, in a ring with a film start.
fn moving(cavitation: Cavitation) -> (FilmProblem, Arc<FilmSystem>) {
    let system = ring_system(72, 12, LENGTH, Some(160f64.to_radians()));
    let mut problem = tilted(plain_film(LENGTH, 0.6, 0.3, SPEED), slope([0.25, -0.15]));
    problem.cavitation = cavitation;
    problem.lubricant.pressure_law = PressureLaw::Barus(Barus { alpha: 2e-8 });
    problem.terms.push(Arc::new(terms::squeeze::Squeeze));
    problem.journal.tilt_rate = [2e-3, 4e-3];
    (problem, system)
}

/// Sizes of the four coordinates: an offset, or an offset at an end [m, rad].
const SIZES: [f64; 4] = [1.0, 1.0, 2.0 / LENGTH, 2.0 / LENGTH];

fn assert_tangent(tangent: &Square, at: impl Fn(usize, f64) -> [f64; 4], step: f64, to: f64, what: &str) {
    let force = |row: usize| SIZES[row];
    let size = |row: usize| (tangent[row][row] * SIZES[row] * force(row)).abs();
    for k in 0..4 {
        let (ahead, behind) = (at(k, step * SIZES[k]), at(k, -step * SIZES[k]));
        for d in 0..4 {
            let difference = (ahead[d] - behind[d]) / (2.0 * step) * force(d);
            let exact = tangent[d][k] * SIZES[k] * force(d);
            let error = (difference - exact).abs() / (size(d) * size(k)).sqrt();
            assert!(error < to, "{what} {d} {k} step {step:e}: {error:e}");
        }
    }
}

#[test]
fn stiffness_and_damping_are_differences_of_films() {
    for model in MODELS {
        let (problem, system) = moving(model);
        let film = problem.solve(&system).unwrap_or_else(|reason| panic!("{reason}"));
        let coefficients = Coefficients::of(&film, 0.0).expect("coefficients");
        let carried = |journal: JournalState| {
            let problem = FilmProblem { journal, ..problem.clone() };
            let film =
                (problem.solve_from(&system, Neighbour::Start(&film))).unwrap_or_else(|reason| panic!("{reason}"));
            let total = load(&film).total;
            let ([x, y], [z_x, z_y]) = (total.force, total.moment);
            ([x, y, z_x, z_y], film.solution.cavity.clone())
        };
        let moved = |of: &dyn Fn(&mut JournalState) -> &mut [f64; 2], axis: usize, by: f64| {
            let mut journal = problem.journal;
            of(&mut journal)[axis] += by;
            let (forces, cavity) = carried(journal);
            assert_eq!(cavity, film.solution.cavity, "the set has changed");
            forces
        };
        let placed = |k: usize, by: f64| match k {
            0 | 1 => moved(&|journal| &mut journal.offset, k, by),
            _ => moved(&|journal| &mut journal.tilt, k - 2, by),
        };
        for step in [1e-7 * CLEARANCE, 1e-6 * CLEARANCE] {
            // Points of integration of the longer step cross the kink of Guembel's pressure: that set is not the same
            // any more.
            let crosses = matches!(model, Cavitation::Guembel { .. }) && step > 5e-7 * CLEARANCE;
            let to = if crosses { 1e-5 } else { 1e-6 };
            assert_tangent(&coefficients.stiffness, placed, step, to, &format!("K {model:?}"));
        }
        if model.conserves_oil() {
            // A steady film whose journal moves on is not one whose journal moves to and fro.
            continue;
        }
        let driven = |k: usize, by: f64| match k {
            0 | 1 => moved(&|journal| &mut journal.velocity, k, by),
            _ => moved(&|journal| &mut journal.tilt_rate, k - 2, by),
        };
        let to = if matches!(model, Cavitation::Guembel { .. }) { 1e-5 } else { 1e-6 };
        assert_tangent(&coefficients.damping, driven, 1e-6 * SPEED * CLEARANCE, to, &format!("C {model:?}"));
    }
}

/// Damping does not ask whether the scene moves its journal: a film at rest takes up as much.
#[test]
fn the_damping_of_a_journal_at_rest_needs_no_squeeze() {
    for model in MODELS {
        let (mut problem, system) = moving(model);
        problem.journal.tilt_rate = [0.0; 2];
        let film = problem.solve(&system).unwrap_or_else(|reason| panic!("{reason}"));
        let with = Coefficients::of(&film, 0.3 * SPEED).expect("coefficients");
        problem.terms.pop();
        let without = SolvedFilm { problem, ..film };
        let without = Coefficients::of(&without, 0.3 * SPEED).expect("coefficients");
        assert_eq!(with, without, "{model:?}");
        assert!(with.damping[0][0] > 0.0);
    }
}

/// Swift-Stieber and full films: force and moment are gradients by the rates, so that C is symmetric and positive
/// definite; with a cavity held too.
#[test]
fn damping_is_symmetric() {
    for model in [Cavitation::None, Cavitation::Reynolds { pressure: 0.0 }] {
        let (mut problem, system) = moving(model);
        problem.lubricant.pressure_law = PressureLaw::Constant;
        let film = problem.solve(&system).unwrap_or_else(|reason| panic!("{reason}"));
        let Coefficients { damping, .. } = Coefficients::of(&film, 0.0).expect("coefficients");
        for i in 0..4 {
            for j in 0..i {
                let size = (damping[i][i] * damping[j][j]).sqrt();
                let off = (damping[i][j] - damping[j][i]).abs() / size;
                assert!(off < 1e-7 && damping[i][j].abs() < size, "{model:?} {i} {j}: {off:e}");
            }
        }
    }
}

/// On a mesh that is its own mirror image offsets of a parallel journal make no moment, and slopes no force.
#[test]
fn translation_and_tilt_decouple_in_a_symmetric_bearing() {
    for model in MODELS {
        let system = ring_system(48, 8, LENGTH, Some(std::f64::consts::PI));
        let mut problem = tilted(plain_film(LENGTH, 0.6, 0.0, SPEED), [0.0; 2]);
        problem.cavitation = model;
        let film = problem.solve(&system).unwrap_or_else(|reason| panic!("{reason}"));
        let Coefficients { stiffness, damping, .. } = Coefficients::of(&film, 0.5 * SPEED).expect("coefficients");
        for of in [stiffness, damping] {
            let greatest = |block: usize| {
                let entries = [of[block][block], of[block + 1][block], of[block][block + 1], of[block + 1][block + 1]];
                entries.into_iter().fold(0.0, |most: f64, entry| most.max(entry.abs()))
            };
            let size = (greatest(0) * greatest(2)).sqrt();
            for i in 0..2 {
                for j in 0..2 {
                    let off = of[i][2 + j].abs().max(of[2 + i][j].abs()) / size;
                    assert!(off < 1e-9, "{model:?} {i} {j}: {off:e}");
                }
            }
        }
    }
}

/// The journal of a full film goes to the side: without feeds `W(e)` turns with e, so that `K t = d/dphi W`.
#[test]
fn turning_the_line_of_centres_turns_the_load() {
    let system = ring_system(96, 12, LENGTH, None);
    let mut problem = plain_film(LENGTH, 0.5, 0.0, SPEED);
    problem.cavitation = Cavitation::Reynolds { pressure: 0.0 };
    let film = problem.solve(&system).unwrap_or_else(|reason| panic!("{reason}"));
    let coefficients = Coefficients::of(&film, 0.0).expect("coefficients");
    let [x, y] = load(&film).total.force;
    let e = problem.journal.offset[0];
    let found = [0, 1].map(|d| e * coefficients.stiffness[d][1]);
    let off = (found[0] + y).hypot(found[1] - x) / x.hypot(y);
    assert!(off < 3e-3, "{found:?} {x} {y}: {off:e}");
}
