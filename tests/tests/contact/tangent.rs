//! Tangents of films with contact and flow factors against differences.

use std::sync::Arc;

use oilwedge_bearing::Coefficients;
use oilwedge_reynolds::flow_factors::PatirCheng;
use oilwedge_reynolds::quantities::load::{load, load_change};
use oilwedge_reynolds::solve::Neighbour;
use oilwedge_reynolds::{Cavitation, FilmProblem, FilmSystem, JournalChange, JournalState, terms};
use oilwedge_tests::tilted_bearings::{slope, tilted};
use oilwedge_tests::*;

use oilwedge_tests::rough_surfaces::contacts;

const LENGTH: f64 = 0.06;

/// Films whose surfaces touch at one end, smooth and rough.
fn films() -> Vec<(String, FilmProblem, Arc<FilmSystem>)> {
    let mut films = Vec::new();
    for model in [Cavitation::None, Cavitation::Reynolds { pressure: 0.0 }, Cavitation::Jfo { pressure: 0.0 }] {
        for contact in contacts() {
            for is_rough in [false, true] {
                let system = ring_system(72, 12, LENGTH, Some(160f64.to_radians()));
                let mut problem = tilted(plain_film(LENGTH, 0.87, 0.3, SPEED), slope([0.15, -0.1]));
                problem.cavitation = model;
                problem.contact = Some(contact.clone());
                problem.terms.push(Arc::new(terms::squeeze::Squeeze));
                if is_rough {
                    problem.flow_factors = vec![Arc::new(PatirCheng { roughness: 2e-6 })];
                }
                films.push((format!("{model:?} {:?} {is_rough}", contact.law), problem, system));
            }
        }
    }
    films
}

/// Central differences of the same discrete film, cavities kept, steps of 1e-7 and 1e-6 of the clearance.
#[test]
fn tangents_with_contact_are_differences() {
    for (what, problem, system) in films() {
        let film = problem.solve(&system).unwrap_or_else(|reason| panic!("{what}: {reason}"));
        let carried = |journal: JournalState| {
            let problem = FilmProblem { journal, ..problem.clone() };
            let film = (problem.solve_from(&system, Neighbour::Start(&film)))
                .unwrap_or_else(|reason| panic!("{what}: {reason}"));
            let total = load(&film).total;
            [total.force[0], total.force[1], 2.0 / LENGTH * total.moment[0], 2.0 / LENGTH * total.moment[1]]
        };
        let change = |k: usize, by: f64| {
            let mut change = JournalChange::default();
            match k {
                0 | 1 => change.offset[k] = by,
                _ => change.tilt[k - 2] = 2.0 / LENGTH * by,
            }
            change
        };
        let tangent: [[f64; 4]; 4] = std::array::from_fn(|k| {
            let change = change(k, 1.0);
            let unknown = film.unknown_change(&change).expect("a tangent");
            let by = load_change(&film, &[(&change).into()], &unknown);
            [by.force[0], by.force[1], 2.0 / LENGTH * by.moment[0], 2.0 / LENGTH * by.moment[1]]
        });
        for step in [1e-7 * CLEARANCE, 1e-6 * CLEARANCE] {
            for (k, column) in tangent.iter().enumerate() {
                let at = |by: f64| carried(problem.journal.changed(&change(k, by)));
                let (ahead, behind) = (at(step), at(-step));
                for d in 0..4 {
                    let difference = (ahead[d] - behind[d]) / (2.0 * step);
                    let size = (tangent[d][d] * tangent[k][k]).abs().sqrt();
                    let off = (difference - column[d]).abs() / size;
                    assert!(off < 1e-6, "{what}: {d} by {k}, step {step:e}: {off:e}");
                }
            }
        }
    }
}

/// K has the stiffness of contact, C nothing of it.
#[test]
fn contact_stiffens_and_does_not_damp() {
    let (_, with, system) = films().swap_remove(4);
    let without = FilmProblem { contact: None, ..with.clone() };
    let of = |problem: &FilmProblem| {
        let film = problem.solve(&system).unwrap_or_else(|reason| panic!("{reason}"));
        Coefficients::of(&film, 0.0).expect("coefficients")
    };
    let (with, without) = (of(&with), of(&without));
    assert_eq!(with.damping, without.damping);
    let more = |i: usize, j: usize| with.stiffness[i][j] - without.stiffness[i][j];
    assert!(more(0, 0) > 0.0 && more(1, 1) > 0.0 && more(2, 2) > 0.0);
    // A force that depends on the place alone and comes from a potential.
    for i in 0..4 {
        for j in 0..i {
            let size = (more(i, i) * more(j, j)).abs().sqrt();
            assert!((more(i, j) - more(j, i)).abs() < 1e-9 * size, "{i} {j}");
        }
    }
}
