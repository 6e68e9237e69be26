//! Walls that give way to film and contact together: tangents, limits, and a wall that contact alone bends.

use std::f64::consts::PI;
use std::sync::Arc;

use oilwedge_bearing::deflection::{EXACT, carried_changes, closed_film};
use oilwedge_bearing::{Coefficients, JournalLoad, SearchOptions, find};
use oilwedge_reynolds::contact::Contact;
use oilwedge_reynolds::flow_factors::PatirCheng;
use oilwedge_reynolds::quantities::LoadGradient;
use oilwedge_reynolds::quantities::contact_points::ContactPoints;
use oilwedge_reynolds::quantities::load::load_change;
use oilwedge_reynolds::solve::Neighbour;
use oilwedge_reynolds::wall::GapTangent;
use oilwedge_reynolds::{Cavitation, FilmChange, FilmProblem, FilmSystem, JournalChange, SolvedFilm, terms};
use oilwedge_tests::elastic_liner::{carried, closed, force_scale, layer, walled};
use oilwedge_tests::tilted_bearings::{run, slope, tilted};
use oilwedge_tests::*;

use oilwedge_tests::rough_surfaces::contacts;
use oilwedge_tests::rough_surfaces::{ASPERITIES, CURVE, mixed_scene as scene};

const LENGTH: f64 = 0.06;
const REYNOLDS: Cavitation = Cavitation::Reynolds { pressure: 0.0 };

/// Films whose surfaces touch at one end of a soft wall, smooth and rough, with both laws of contact.
fn films() -> [(String, FilmProblem, Arc<FilmSystem>); 3] {
    let [elastic, plastic] = contacts();
    [
        (Cavitation::None, plastic, false),
        (REYNOLDS, elastic.clone(), true),
        (Cavitation::Jfo { pressure: 0.0 }, elastic, false),
    ]
    .map(|(model, contact, is_rough)| {
        let system = ring_system(72, 12, LENGTH, Some(160f64.to_radians()));
        let problem = walled(LENGTH, 0.87, model, |_| layer(5e-4));
        let mut problem = tilted(problem, slope([0.15, -0.1]));
        let what = format!("{model:?} {:?} {is_rough}", contact.law);
        problem.contact = Some(contact);
        problem.terms.push(Arc::new(terms::squeeze::Squeeze));
        if is_rough {
            problem.flow_factors = vec![Arc::new(PatirCheng { roughness: 2e-6 })];
        }
        (what, problem, system)
    })
}

/// Forces in one unit: moments over half of the length.
fn forces(by: &oilwedge_reynolds::quantities::load::Resultant) -> [f64; 4] {
    let arm = 0.5 * LENGTH;
    [by.force[0], by.force[1], by.moment[0] / arm, by.moment[1] / arm]
}

fn unit_change(k: usize, by: f64) -> JournalChange {
    let mut change = JournalChange::default();
    match k {
        0 | 1 => change.offset[k] = by,
        _ => change.tilt[k - 2] = 2.0 / LENGTH * by,
    }
    change
}

/// Central differences of closed films, cavities kept, steps of 1e-7 and 1e-6 of the clearance.
#[test]
fn tangents_of_film_wall_and_contact_are_differences() {
    for (what, problem, system) in films() {
        let film = closed(problem, &system);
        let problem = &film.problem;
        let closing = problem.deflection().expect("a wall").closing;
        assert!(closing.residual < 1e-10, "{what}: {closing:?}");
        let changes: [JournalChange; 4] = std::array::from_fn(|k| unit_change(k, 1.0));
        let changed = carried_changes(&film, &changes, EXACT).expect("a tangent");
        let tangent: [[f64; 4]; 4] = std::array::from_fn(|k| forces(&changed[k].by_film));
        let at = |change: &JournalChange| {
            let moved = FilmProblem { journal: problem.journal.changed(change), ..problem.clone() };
            let moved = closed_film(moved, &system, Neighbour::Start(&film));
            forces(&carried(&moved.unwrap_or_else(|reason| panic!("{what}: {reason}"))))
        };
        for step in [1e-7 * CLEARANCE, 1e-6 * CLEARANCE] {
            for (k, column) in tangent.iter().enumerate() {
                let (ahead, behind) = (at(&unit_change(k, step)), at(&unit_change(k, -step)));
                for d in 0..4 {
                    let difference = (ahead[d] - behind[d]) / (2.0 * step);
                    let size = (tangent[d][d] * tangent[k][k]).abs().sqrt();
                    let off = (difference - column[d]).abs() / size;
                    assert!(off < 1e-6, "{what}: {d} by {k}, step {step:e}: {off:e}");
                }
            }
        }
        let slow = Coefficients::of(&film, 0.0).expect("coefficients");
        for d in 0..2 {
            for k in 0..2 {
                let off = (slow.stiffness[d][k] - tangent[k][d]).abs() / tangent[k][k].abs();
                assert!(off < 1e-7, "{what}: K {d} {k}: {off:e}");
            }
        }
    }
}

/// The tangent by the gap has that by the place of the journal: the residual that a pass over the film itself finds. It
/// has none by a velocity.
#[test]
fn the_gap_tangent_answers_to_the_journal() {
    for (what, problem, system) in films() {
        let film = closed(problem, &system);
        let deflection = film.problem.deflection().expect("a wall");
        let tangent = GapTangent::of(&film, deflection).expect("a tangent");
        for k in 0..4 {
            let change = unit_change(k, 1.0);
            let residual = tangent.by_journal(&system, &change).expect("a wall at rest");
            let found = film.answer(&residual, 0.0).expect("an answer");
            let wanted = film.unknown_change(&change).expect("a change");
            let size = wanted.iter().fold(0.0f64, |most, x| most.max(x.abs()));
            let off = found.iter().zip(&wanted).fold(0.0f64, |most, (a, b)| most.max((a - b).abs()));
            assert!(size > 0.0 && off < 1e-11 * size, "{what}: {k}: {off:e} of {size:e}");
            assert!(tangent.by_journal(&system, &change.as_rate()).is_none(), "{what}: {k}");
        }
    }
}

/// A journal that does not turn is carried by contact alone: the layer gives way at each place by itself,
/// `d = k p_a(h_0 + d)`, a root of one equation.
#[test]
fn a_layer_under_contact_alone_gives_way_place_by_place() {
    let (eps, per_pressure) = (0.97, layer(5e-4));
    for contact in contacts() {
        let system = ring_system(144, 12, LENGTH, Some(PI));
        let mut problem = walled(LENGTH, eps, REYNOLDS, |_| per_pressure);
        problem.journal.speed = 0.0;
        problem.contact = Some(contact.clone());
        let carried = carried(&closed(problem, &system)).force;
        let (force, rigid) = (contact_force(&contact, eps, per_pressure), contact_force(&contact, eps, 0.0));
        let off = carried[0].hypot(carried[1]) / force - 1.0;
        assert!(off.abs() < 2e-4, "{off:e}");
        assert!(force < 0.97 * rigid, "{force} {rigid}");
    }
}

/// The forces on the splines are those of the gap, however coarse the triangles are beside the cells of the wall.
#[test]
fn contact_presses_on_the_splines_whatever_the_triangles() {
    for contact in contacts() {
        let mut problem = walled(LENGTH, 0.96, REYNOLDS, |_| layer(5e-4));
        problem.contact = Some(contact.clone());
        let of = |columns: u32, rows: u32| {
            let system = ring_system(columns, rows, LENGTH, None);
            ContactPoints::of(&problem, &system).expect("contact").forces()
        };
        let (coarse, fine) = (of(18, 3), of(144, 24));
        let greatest = fine.iter().copied().fold(0.0, f64::max);
        let apart = coarse.iter().zip(&fine).map(|(coarse, fine)| (coarse - fine).abs());
        let off = apart.fold(0.0, f64::max) / greatest;
        assert!(off < 2e-3, "{:?}: {off:e}", contact.law);
    }
}

/// Sums over the points of contact are continuous where a part of a triangle is divided further: with sums that jump
/// there, these loads, between both sides, have no balance.
#[test]
fn loads_are_balanced_where_coarse_triangles_are_divided() {
    let system = ring_system(36, 4, RADIUS, None);
    for units in [5.0, 6.0] {
        let mut problem = walled(RADIUS, 0.5, REYNOLDS, |_| layer(0.05));
        problem.contact = contacts().into_iter().next();
        let load: JournalLoad = [units * force_scale(), 0.0].into();
        let rest = find(&problem, &system, load, &SearchOptions::default());
        let rest = rest.unwrap_or_else(|reason| panic!("{units} units: {reason}"));
        assert!(rest.residual < 1e-10, "{:e}", rest.residual);
    }
}

/// The linear form of a film is the change of what the journal carries.
#[test]
fn the_gradient_of_the_load_is_its_change() {
    for (what, problem, system) in films() {
        let film = closed(problem, &system);
        let problem = &film.problem;
        let bent = problem.deflection().expect("a wall");
        let of =
            |number: usize, scale: f64| -> Vec<f64> { (0..number).map(|k| scale * (7.0 * k as f64).sin()).collect() };
        let (unknown, wall) = (of(film.solution.unknown.len(), 1e5), of(bent.coefficients.len(), 1e-3 * CLEARANCE));
        let shape = bent.change(wall.clone());
        let change = load_change(&film, &[FilmChange::Gap(&shape)], &unknown);
        let contact = ContactPoints::of(problem, &system);
        let gradient = LoadGradient::of(&film, contact.as_ref());
        let (change, gradient) = (forces(&change), forces(&gradient.change(&unknown, &wall)));
        let size = change.iter().fold(0.0_f64, |size, part| size.max(part.abs()));
        for (change, gradient) in change.iter().zip(gradient) {
            assert!((change - gradient).abs() < 1e-11 * size, "{what}: {change} {gradient}");
        }
    }
}

/// Where the film does not answer, contact and wall are solved in closed form: each step of Newton's method takes one
/// product.
#[test]
fn contact_alone_is_solved_in_closed_form() {
    for contact in contacts() {
        let system = ring_system(72, 12, LENGTH, Some(PI));
        let mut problem = walled(LENGTH, 0.97, REYNOLDS, |n| layer(5e-4) / (1.0 + n as f64));
        problem.journal.speed = 0.0;
        problem.contact = Some(contact.clone());
        let SolvedFilm { problem, .. } = closed(problem, &system);
        let closing = problem.deflection().expect("a wall").closing;
        assert!(closing.residual < 1e-10, "{closing:?}");
        // Each step solves a film, and the first one is that of the unbent wall; a step takes one product, or two where
        // its system is solved to more digits.
        assert!(closing.outer > 2 && closing.inner <= closing.outer, "{closing:?}");
    }
}

/// Force [N] of the contact of a parallel journal in a layer, by bisection at each angle.
fn contact_force(contact: &Contact, eps: f64, per_pressure: f64) -> f64 {
    const POINTS: u32 = 20_000;
    let at = |k: u32| {
        let cos = (PI * (f64::from(k) + 0.5) / f64::from(POINTS)).cos();
        let gap = CLEARANCE * (1.0 - eps * cos);
        let (mut low, mut high) = (0.0, per_pressure * contact.law.hardness());
        for _ in 0..200 {
            let middle = 0.5 * (low + high);
            match middle < per_pressure * contact.law.at(gap + middle).pressure {
                true => low = middle,
                false => high = middle,
            }
        }
        contact.law.at(gap + low).pressure * cos
    };
    2.0 * RADIUS * LENGTH * PI / f64::from(POINTS) * (0..POINTS).map(at).sum::<f64>()
}

/// A main bearing in mixed lubrication on a polymer layer: balanced, with bars, and less of the load on its asperities
/// than on a rigid wall.
#[test]
fn loads_are_balanced_in_mixed_films_on_soft_walls() {
    for contact in [ASPERITIES, CURVE] {
        let share = |keys: &str| {
            let result = run(&scene(300.0, contact, keys).replace("\"2 mm\"", "\"3 mm\""));
            let of = |name: &str| {
                let quantity = result.by_name(name).unwrap_or_else(|| panic!("no {name}: {:?}", result.head.reason));
                (quantity.value, quantity.error().unwrap_or(f64::NAN))
            };
            assert!(result.balances.force < 1e-10, "{:e}", result.balances.force);
            assert!(result.balances.deflection.is_none_or(|left| left < 1e-10));
            let (share, bar) = of("contact_share");
            assert!(bar.is_finite(), "no bar of the share");
            share
        };
        let (rigid, soft) = (share(""), share("[liner]\nwinkler = \"0.005 um/MPa\"\n"));
        assert!(soft < rigid - 0.02, "{soft} {rigid}");
    }
}

/// Points of contact under a wall that gives way a little further are those found there.
#[test]
fn points_of_contact_follow_the_wall() {
    for (what, problem, system) in films() {
        let SolvedFilm { problem, .. } = closed(problem, &system);
        let (bent, contact) = (problem.deflection().expect("a wall"), problem.contact.as_ref().expect("contact"));
        let more: Vec<f64> = (0..bent.coefficients.len()).map(|k| 1e-3 * CLEARANCE * (7.0 * k as f64).sin()).collect();
        let points = ContactPoints::of(&problem, &system).expect("contact");
        let followed = points.bent_further(&*contact.law, &more).forces();
        let there = problem.clone().deflected(Some(&bent.with_more(&more)));
        let found = ContactPoints::of(&there, &system).expect("contact").forces();
        let greatest = found.iter().copied().fold(0.0, f64::max);
        let apart = found.iter().zip(&followed).map(|(found, followed)| (found - followed).abs());
        let off = apart.fold(0.0, f64::max) / greatest;
        let moved = found.iter().zip(points.forces()).map(|(found, before)| (found - before).abs());
        let moved = moved.fold(0.0, f64::max) / greatest;
        assert!(off < 1e-5 * moved, "{what}: {off:e} {moved:e}");
    }
}
