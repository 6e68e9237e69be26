//! Position and tilt under a force and a moment.

use std::sync::Arc;

use oilwedge_bearing::{BranchEnd, BranchLimit, Coordinates, JournalLoad, NoEquilibrium, SearchOptions, Tilting, find};
use oilwedge_reynolds::levels::LevelLayout;
use oilwedge_reynolds::lubricant::PressureLaw;
use oilwedge_reynolds::lubricant::barus::Barus;
use oilwedge_reynolds::wall::Wall;
use oilwedge_reynolds::{Cavitation, CentreVelocity, FilmProblem, FilmSystem, Gap, terms};
use oilwedge_study::result::Status;
use oilwedge_tests::bench::edited;
use oilwedge_tests::elastic_liner::{layer, with_wall};
use oilwedge_tests::journal_bearings::{each, number};
use oilwedge_tests::tilted_bearings::{
    FORCE, MOMENT, block, carried, numbers, quantity, rows, run, scene, slope, tilted,
};
use oilwedge_tests::*;

const LENGTH: f64 = 0.06;

/// `W = F`, `m = z_F F + k (g_0 - g)` against finite volumes and their own Newton: offsets and slopes in units of c and
/// c/R.
#[test]
fn positions_and_tilts_are_those_of_finite_volumes() {
    each(&rows(&block("balance_of_moment")["rows"]), |row| {
        let force = numbers(&row["F"]);
        let (size, angle) = (FORCE * force[0].hypot(force[1]), force[1].atan2(force[0]).to_degrees());
        let at = 50.0 * number(row, "load_offset_z");
        let stiffness = 1e3 * MOMENT * number(row, "support_stiffness");
        let support = match stiffness > 0.0 {
            true => {
                let tilt = numbers(&row["support_tilt"]);
                format!(
                    "[support]\ntilt_stiffness = \"{stiffness} N.m/rad\"\ntilt = {{ x = \"{} mrad\", y = \"{} mrad\" }}",
                    tilt[0], tilt[1]
                )
            }
            false => String::new(),
        };
        let keys = format!("[load]\nforce = \"{size} N\"\nangle = \"{angle} deg\"\nat = \"{at} mm\"\n{support}");
        let result = run(&scene(number(row, "b"), "\"0.1 %\"", &keys));
        let of = |name: &str| quantity(&result, name)[0];
        let (eps, towards) = (of("eccentricity"), of("min_film_angle").to_radians());
        let found = [eps * towards.cos(), eps * towards.sin(), 1e3 * of("tilt_x"), 1e3 * of("tilt_y")];
        let wanted = ["X", "Y", "gx", "gy"].map(|key| number(row, key));
        let moment = numbers(&row["m"]);
        let is_met = (0..4).all(|k| (found[k] - wanted[k]).abs() < 1e-3)
            && (of("moment_x") / MOMENT - moment[0]).abs() < 1e-3
            && (of("moment_y") / MOMENT - moment[1]).abs() < 1e-3;
        let balances = result.balances;
        let is_balanced = balances.force < 1e-10 && balances.tilt < 1e-10 && result.counts.position_steps <= 12;
        match is_met && is_balanced {
            true => Ok(()),
            false => Err(format!("{row}: {found:?}, {balances:?}, {:?}", result.counts)),
        }
    });
}

/// A ring with a film start, its journal tilted and moving, and what is free of it.
fn moving(cavitation: Cavitation) -> (FilmProblem, Arc<FilmSystem>) {
    let system = ring_alone(72, 12, LENGTH, Some(160f64.to_radians()));
    let mut problem = tilted(plain_film(LENGTH, 0.6, 0.3, SPEED), slope([0.25, -0.15]));
    problem.cavitation = cavitation;
    problem.lubricant.pressure_law = PressureLaw::Barus(Barus { alpha: 2e-8 });
    problem.terms.push(Arc::new(terms::squeeze::Squeeze));
    problem.journal.tilt_rate = [2e-3, 4e-3];
    let system = Arc::new(match problem.needs_start() {
        true => system.with_coarser(&problem, oilwedge_reynolds::levels::LevelLayout::Rows),
        false => system,
    });
    (problem, system)
}

/// What a film carries, as a load that it balances.
fn balanced_by(problem: &FilmProblem, system: &Arc<FilmSystem>) -> JournalLoad {
    let carried = carried(problem, system);
    JournalLoad {
        force: carried.force,
        tilting: Some(Tilting { moment: carried.moment, stiffness: 0.0, support: [0.0; 2] }),
    }
}

/// A position and a tilt are given back by the force and the moment of their film, from another start.
#[test]
fn position_and_tilt_are_given_back() {
    for model in [Cavitation::None, Cavitation::Reynolds { pressure: 0.0 }] {
        let (problem, system) = moving(model);
        let asked = balanced_by(&problem, &system);
        let mut start = problem.clone();
        start.journal.offset = [0.3 * CLEARANCE, 0.0];
        start.journal.tilt = [0.0; 2];
        let found = find(&start, &system, asked, &SearchOptions::default()).unwrap_or_else(|reason| panic!("{reason}"));
        let coordinates = Coordinates::of(&asked, &problem.bearing);
        let (here, back) = (coordinates.at(&problem.journal), coordinates.at(&found.film.problem.journal));
        assert!((0..4).all(|k| (here[k] - back[k]).abs() < 1e-9 * CLEARANCE), "{here:?} {back:?}");
        assert!(found.residual < 1e-10 && found.parts.iter().all(|part| *part < 1e-10));
    }
}

/// A very stiff support gives the tilt that it has; the position is that of a journal with this tilt.
#[test]
fn a_stiff_support_gives_the_tilt() {
    let (problem, system) = moving(Cavitation::Guembel { pressure: 0.0 });
    let force = carried(&problem, &system).force;
    let by_support = JournalLoad {
        force,
        tilting: Some(Tilting { moment: [0.0; 2], stiffness: 1e15, support: problem.journal.tilt }),
    };
    let mut start = problem.clone();
    start.journal.tilt = [0.0; 2];
    let held = find(&start, &system, by_support, &SearchOptions::default()).unwrap_or_else(|reason| panic!("{reason}"));
    let given = find(&problem, &system, force, &SearchOptions::default()).unwrap_or_else(|reason| panic!("{reason}"));
    for d in 0..2 {
        assert!((held.film.problem.journal.tilt[d] - problem.journal.tilt[d]).abs() < 1e-9 * 1e-3);
        let apart = held.film.problem.journal.offset[d] - given.film.problem.journal.offset[d];
        assert!(apart.abs() < 1e-7 * CLEARANCE, "{apart:e}");
    }
}

/// A load in the middle of a symmetric film tilts nothing; one on the other side tilts the other way.
#[test]
fn the_tilt_follows_the_place_of_the_load() {
    let system = ring_system(48, 8, LENGTH, None);
    let mut problem = tilted(plain_film(LENGTH, 0.5, 0.0, SPEED), [0.0; 2]);
    problem.cavitation = Cavitation::Guembel { pressure: 0.0 };
    let force = carried(&problem, &system).force;
    let at = |place: f64| {
        let asked = JournalLoad {
            force,
            tilting: Some(Tilting { moment: force.map(|part| place * part), stiffness: 0.0, support: [0.0; 2] }),
        };
        let velocity = CentreVelocity::default();
        let options = SearchOptions { centre_velocity: velocity, ..SearchOptions::default() };
        find(&problem, &system, asked, &options)
    };
    let tilt = |place: f64| at(place).unwrap_or_else(|reason| panic!("{reason}")).film.problem.journal.tilt;
    let unit = CLEARANCE / LENGTH;
    assert!(tilt(0.0).iter().all(|g| g.abs() < 1e-9 * unit));
    let (up, down) = (tilt(0.003), tilt(-0.003));
    assert!((0..2).all(|d| (up[d] + down[d]).abs() < 1e-8 * unit) && up[0].hypot(up[1]) > 0.05 * unit);
    // Beyond what the film can carry the end that touches is named.
    match at(0.025) {
        Err(NoEquilibrium::Branch(end)) => {
            let BranchEnd { z, carried, thickness, .. } = *end;
            assert!(z == 0.5 * LENGTH && carried < 0.99 && thickness < 0.05 * CLEARANCE, "{carried} {thickness:e}");
        }
        other => panic!("{other:?}"),
    }
}

/// The part that the film carries of a moment 25 mm times the force that it carries without tilt, the error of that
/// part, and whether no finer mesh need be asked.
fn refused(problem: &FilmProblem, system: &Arc<FilmSystem>) -> (f64, f64, bool) {
    let force = carried(problem, system).force;
    let asked = JournalLoad {
        force,
        tilting: Some(Tilting { moment: force.map(|part| 0.025 * part), stiffness: 0.0, support: [0.0; 2] }),
    };
    let reason = find(problem, system, asked, &SearchOptions::default()).map(|found| found.residual);
    let reason = reason.expect_err("a moment that no film carries");
    let is_last = reason.is_far_beyond();
    match reason {
        NoEquilibrium::Branch(end) => (end.carried, end.error.expect("a film to compare with"), is_last),
        other => panic!("{other}"),
    }
}

/// A load beyond what a journal held at a tilt carries is refused with the force of the film in contact: that force is
/// towards the load, and what the reason says it is.
#[test]
fn a_growing_load_ends_in_contact_with_the_force_of_the_film_there() {
    let system = ring_system(48, 8, LENGTH, None);
    for cavitation in [Cavitation::Guembel { pressure: 0.0 }, Cavitation::Reynolds { pressure: 0.0 }] {
        let mut problem = tilted(plain_film(LENGTH, 0.3, 0.0, SPEED), [0.4 * CLEARANCE / LENGTH, 0.0]);
        problem.cavitation = cavitation;
        let load = carried(&problem, &system).force.map(|part| 1e3 * part);
        let reason = find(&problem, &system, load, &SearchOptions::default()).expect_err("a load beyond contact");
        assert!(reason.is_far_beyond() && !reason.is_unreached(), "{reason}");
        let end = reason.branch_end().expect("the end of a branch");
        assert_eq!((end.limit, end.is_tilting), (BranchLimit::Contact, false));
        assert!(end.thickness < 1e-4 * CLEARANCE && end.carried < 0.5, "{end:?}");
        let [x, y] = carried(&FilmProblem { journal: end.journal, ..problem.clone() }, &system).force;
        let apart = (x - end.carried * load[0]).hypot(y - end.carried * load[1]);
        assert!(apart < 2e-4 * x.hypot(y), "{apart:e} of {:e} N", x.hypot(y));
    }
}

/// The part of the moment with which a coarse mesh refuses a load is that of finer ones, within its error.
#[test]
fn reasons_of_coarse_meshes_hold_on_finer_ones() {
    let refused = |across: u32, model: Cavitation| {
        let system = ring_system(6 * across, across, LENGTH, None);
        let mut problem = tilted(plain_film(LENGTH, 0.5, 0.0, SPEED), [0.0; 2]);
        problem.cavitation = model;
        refused(&problem, &system)
    };
    let mut known = 0;
    let films: [(Cavitation, &[u32]); 3] = [
        (Cavitation::None, &[6, 12]),
        (Cavitation::Guembel { pressure: 0.0 }, &[6, 12]),
        (Cavitation::Reynolds { pressure: 0.0 }, &[6, 12, 18]),
    ];
    for (model, meshes) in films {
        let found: Vec<_> = meshes.iter().map(|&across| refused(across, model)).collect();
        let (fine, ..) = found[found.len() - 1];
        for (across, (coarse, error, _)) in meshes.iter().zip(&found[..found.len() - 1]) {
            assert!((coarse - fine).abs() < *error, "{model:?} {across}: {coarse} +- {error}, {fine}");
        }
        known += found.iter().filter(|(.., is_last)| *is_last).count();
    }
    assert!(known > 0, "no reason is the last one");
}

/// The reason of a mass-conserving film in a wall that gives way holds on a finer mesh: it follows the branch into
/// contact itself.
#[test]
fn a_reason_of_a_film_that_conserves_oil_in_an_elastic_liner_holds_on_a_finer_mesh() {
    let [(coarse, error, _), (fine, ..)] = [12, 18].map(|across| {
        let mut problem = tilted(plain_film(LENGTH, 0.5, 0.0, SPEED), [0.0; 2]);
        problem.cavitation = Cavitation::Jfo { pressure: 0.0 };
        let compliance = layer(0.02);
        let problem = with_wall(
            problem.clone(),
            Wall::of_slices(&problem.bearing, |_| compliance).expect("a bearing with a length"),
        );
        let system = ring_alone(6 * across, across, LENGTH, Some(std::f64::consts::PI));
        refused(&problem, &Arc::new(system.with_coarser(&problem, LevelLayout::Rows)))
    });
    assert!((coarse - fine).abs() < error, "{coarse} +- {error}, {fine}");
    assert!(error < 0.1 && (0.4..0.6).contains(&fine), "{fine} +- {error}");
}

#[test]
fn contact_at_an_end_is_told_with_a_way_out() {
    let keys = "[load]\nforce = \"20 kN\"\nangle = \"270 deg\"\nat = \"-20 mm\"";
    let result = run(&scene(0.5, "\"2 %\"", keys));
    assert_eq!(result.head.status, Status::NoSolution);
    let reason = result.head.reason.unwrap_or_default();
    for part in ["contact with the liner at its end z = -25 mm", "% of the moment", "tilt_stiffness"] {
        assert!(reason.contains(part), "{reason}");
    }
}

/// A moment of which the film lacks no more than the error of its mesh may be carried: a finer mesh is asked, and where
/// that does not show it either there is no answer, but no refusal.
#[test]
fn a_moment_within_the_error_of_its_mesh_is_not_refused() {
    let at = |place: f64| {
        let edits = [("4.1596 kN", "20 kN"), ("\"5 mm\"", &format!("\"{place} mm\""))];
        run(&edited("24_load_off_the_middle", &edits))
    };
    assert_eq!(at(10.4).head.status, Status::Converged);
    let undecided = at(10.6);
    let reason = undecided.head.reason.unwrap_or_default();
    assert_eq!(undecided.head.status, Status::NotConverged, "{reason}");
    for part in [" ± ", "% of the moment", "a finer mesh"] {
        assert!(reason.contains(part), "{reason}");
    }
    let refused = at(14.0);
    let reason = refused.head.reason.unwrap_or_default();
    assert_eq!(refused.head.status, Status::NoSolution, "{reason}");
    assert!(!reason.contains('±'), "{reason}");
}

/// The film of a journal whose gap is negative at the very end of the bearing, where no point of integration sees it,
/// is no start: the search ends all the same, at the balance.
#[test]
fn a_search_that_begins_in_contact_ends() {
    let (problem, system) = moving(Cavitation::Reynolds { pressure: 0.0 });
    let asked = balanced_by(&problem, &system);
    let mut start = problem.clone();
    let [along, across] = [0.3 * CLEARANCE, 0.7 * CLEARANCE * (1.0 + 1e-4)];
    (start.journal.offset, start.journal.tilt) = ([along, 0.0], [across / (0.5 * LENGTH), 0.0]);
    let gap = Gap::of(&start, &system).least(&start.journal);
    assert!(gap < 0.0 && gap > -1e-4 * CLEARANCE && start.solve(&system).is_ok(), "{gap:e}");
    let found = find(&start, &system, asked, &SearchOptions::default()).unwrap_or_else(|reason| panic!("{reason}"));
    let off = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
    let (here, wanted) = (found.film.problem.journal, problem.journal);
    assert!(off(here.offset, wanted.offset) < 1e-9 * CLEARANCE, "{here:?}");
    assert!(off(here.tilt, wanted.tilt) < 1e-9 * CLEARANCE / LENGTH, "{here:?}");
}
