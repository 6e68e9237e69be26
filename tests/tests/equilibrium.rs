//! The journal under a load: the tangent of the load, positions given back by their loads, the range of loads, and
//! loads that no position carries.

use std::sync::Arc;

use oilwedge_bearing::{Equilibrium, NoEquilibrium, SearchOptions, find};
use oilwedge_reynolds::lubricant::PressureLaw;
use oilwedge_reynolds::lubricant::barus::Barus;
use oilwedge_reynolds::quantities::load::load;
use oilwedge_reynolds::solve::Neighbour;
use oilwedge_reynolds::terms;
use oilwedge_reynolds::{Cavitation, CentreVelocity, FilmProblem, FilmSystem, JournalState, NoFilm};
use oilwedge_tests::*;

const LENGTH: f64 = 0.06;
const MODELS: [Cavitation; 4] = [
    Cavitation::None,
    Cavitation::Guembel { pressure: 0.0 },
    Cavitation::Reynolds { pressure: 0.0 },
    Cavitation::Jfo { pressure: 0.0 },
];

/// A ring with a film start at 160 degrees, and the film at eccentricity `eps` towards `angle` [rad].
fn bearing(cavitation: Cavitation, eps: f64, angle: f64, speed: f64) -> (FilmProblem, Arc<FilmSystem>) {
    let system = ring_alone(72, 12, LENGTH, Some(160f64.to_radians()));
    let mut problem = plain_film(LENGTH, eps, angle, speed);
    problem.cavitation = cavitation;
    let system = Arc::new(match problem.needs_start() {
        true => system.with_coarser(&problem, oilwedge_reynolds::levels::LevelLayout::Rows),
        false => system,
    });
    (problem, system)
}

/// Half a shell about angle zero, starved if its inlet has a film fraction.
fn half_shell(cavitation: Cavitation, film_fraction: Option<f64>) -> (FilmProblem, Arc<FilmSystem>) {
    let mesh = oilwedge_mesh::generate::generate(
        &oilwedge_mesh::generate::Blueprint {
            liner: oilwedge_mesh::developed::LinerDomain { radius: RADIUS, length: LENGTH, arc: Some((-1.5, 1.5)) },
            features: Vec::new(),
            line: None,
        },
        &|_| 0.1 * RADIUS,
    )
    .expect("a half shell");
    let kind = |name: &str| match name {
        "arc_from" | "arc_to" => oilwedge_reynolds::supply::BoundaryKind::Line,
        _ => oilwedge_reynolds::supply::BoundaryKind::End,
    };
    let regions = ["end_low", "end_high", "arc_from", "arc_to"].map(|name| oilwedge_reynolds::supply::SupplyRegion {
        name: name.to_owned(),
        kind: kind(name),
        pressure: 0.0,
        edges: mesh.region(name).expect("a group").edges.clone(),
        cells: Vec::new(),
        disc: None,
        film_fraction,
    });
    let mut problem = plain_film(LENGTH, 0.5, 0.3, SPEED);
    problem.cavitation = cavitation;
    let system = FilmSystem::new(Arc::new(mesh), 2, regions.into()).expect("it fits");
    let system = Arc::new(system.with_coarser(&problem, oilwedge_reynolds::levels::LevelLayout::Rows));
    (problem, system)
}

fn force(problem: &FilmProblem, system: &Arc<FilmSystem>) -> [f64; 2] {
    let film = problem.solve(system).unwrap_or_else(|reason| panic!("{reason}"));
    load(&film).total.force
}

fn started_at(problem: &FilmProblem, eps: f64, angle: f64) -> FilmProblem {
    let start = JournalState::at_eccentricity(eps, angle, CLEARANCE, problem.journal.speed);
    FilmProblem { journal: JournalState { velocity: problem.journal.velocity, ..start }, ..problem.clone() }
}

/// `dW/de` against central differences. The cavity moves without changing the load to first order; a mass-conserving
/// film is differenced with its forms kept.
#[test]
fn tangent_matches_differences() {
    let squeeze = CentreVelocity { radial: 4e-4, tangential: -2e-4 };
    let mut bearings: Vec<_> = MODELS.map(|model| bearing(model, 0.6, 0.3, SPEED)).into();
    // A starved inlet in the cavity, and one where pressure builds up.
    bearings.extend([0.7, 1.0].map(|fraction| half_shell(Cavitation::Jfo { pressure: 0.0 }, Some(fraction))));
    for (mut problem, system) in bearings {
        problem.lubricant.pressure_law = PressureLaw::Barus(Barus { alpha: 2e-8 });
        problem.terms.push(Arc::new(terms::squeeze::Squeeze));
        problem.journal = problem.journal.with_centre_velocity(squeeze, 0.3);
        let asked = force(&problem, &system);
        let moving = SearchOptions { centre_velocity: squeeze, ..SearchOptions::default() };
        let found = find(&problem, &system, asked, &moving).unwrap_or_else(|reason| panic!("{reason}"));
        let step = 1e-4 * CLEARANCE;
        for k in 0..2 {
            let at = |sign: f64| {
                let mut offset = found.film.problem.journal.offset;
                offset[k] += sign * step;
                let moved = JournalState { offset, ..found.film.problem.journal };
                let moved = moved.with_centre_velocity(squeeze, offset[1].atan2(offset[0]));
                let problem = FilmProblem { journal: moved, ..found.film.problem.clone() };
                let film = problem.solve_from(&system, Neighbour::Start(&found.film)).expect("a film");
                load(&film).total.force
            };
            let (ahead, behind) = (at(1.0), at(-1.0));
            for d in 0..2 {
                let difference = (ahead[d] - behind[d]) / (2.0 * step);
                let size = found.stiffness[0][0].abs() + found.stiffness[1][1].abs();
                let error = (difference - found.stiffness[d][k]).abs() / size;
                assert!(
                    error < 1e-3,
                    "{:?} dW{d}/de{k}: {difference:e} {:e}",
                    problem.cavitation,
                    found.stiffness[d][k]
                );
            }
        }
    }
}

/// The load of an eccentricity gives the eccentricity back, from another start.
#[test]
fn positions_come_back_from_their_loads() {
    for cavitation in MODELS {
        for (eps, angle, speed) in [(0.03, 2.0, SPEED), (0.5, 0.2, SPEED), (0.8, -1.0, -SPEED), (0.95, 3.0, SPEED)] {
            let (problem, system) = bearing(cavitation, eps, angle, speed);
            let asked = force(&problem, &system);
            let start = started_at(&problem, 0.4, angle + 0.7);
            let Equilibrium { film: found, residual, .. } =
                find(&start, &system, asked, &SearchOptions::default()).unwrap_or_else(|reason| panic!("{reason}"));
            assert!(residual < 1e-10, "{residual:e}");
            let back = found.problem.journal.eccentricity() / CLEARANCE;
            assert!((back / eps - 1.0).abs() < 1e-8, "{cavitation:?} {eps}: {back}");
            let turn = (found.problem.journal.min_film_angle() - angle).sin();
            assert!(turn.abs() < 1e-8, "{cavitation:?} {eps}: {turn:e}");
        }
    }
}

/// From any start, for loads over four decades (So 0.01 to 200 in a bearing as long as it is wide).
#[test]
fn any_start_leads_to_the_same_position() {
    let (problem, system) = bearing(Cavitation::Reynolds { pressure: 0.0 }, 0.5, 0.0, SPEED);
    let unit = pressure_scale() * 2.0 * RADIUS * LENGTH;
    for so in [0.01, 0.3, 5.0, 40.0] {
        let mut positions = Vec::new();
        for (eps, angle) in [(0.0, 0.0), (0.5, 1.0), (0.3, -2.5), (0.97, 3.0), (0.05, 0.5)] {
            let start = started_at(&problem, eps, angle);
            let found = find(&start, &system, [0.0, -so * unit], &SearchOptions::default());
            let found = found.unwrap_or_else(|reason| panic!("So {so} from {eps}, {angle}: {reason}"));
            assert!(found.residual < 1e-10);
            positions.push(found.film.problem.journal.offset);
        }
        for offset in &positions {
            let apart = (offset[0] - positions[0][0]).hypot(offset[1] - positions[0][1]);
            assert!(apart < 1e-9 * CLEARANCE, "So {so}: {positions:?}");
        }
    }
}

/// Half a bearing does not pull: a load away from it is not carried.
#[test]
fn loads_out_of_reach_are_told() {
    let (problem, system) = half_shell(Cavitation::Reynolds { pressure: 0.0 }, None);
    let carried =
        find(&problem, &system, [500.0, 0.0], &SearchOptions::default()).expect("it is pushed into the shell");
    assert!(carried.film.problem.journal.offset[0] > 0.0);
    match find(&problem, &system, [-500.0, 0.0], &SearchOptions::default()) {
        Err(reason @ NoEquilibrium::Unreachable { asked, towards, .. }) => {
            assert_eq!((asked, towards), (500.0, 180.0));
            assert!(!reason.is_unreached() && reason.to_string().contains("out of the shell"), "{reason}");
        }
        other => panic!("{:?}", other.map(|found| found.film.problem.journal)),
    }
    // Where a cavity may suck, a load that is not carried there is not shown to be carried nowhere.
    let (problem, system) = half_shell(Cavitation::Reynolds { pressure: -1.0 }, None);
    let reason = find(&problem, &system, [-500.0, 0.0], &SearchOptions::default()).expect_err("a light pull at most");
    assert!(reason.is_unreached(), "{reason}");
}

/// A start beyond the limit of Barus' law is no reason to give up.
#[test]
fn a_start_without_a_film_is_left() {
    let system = ring_system(72, 12, LENGTH, Some(160f64.to_radians()));
    let mut problem = plain_film(LENGTH, 0.9, 0.3, SPEED);
    problem.cavitation = Cavitation::Reynolds { pressure: 0.0 };
    problem.lubricant.pressure_law = PressureLaw::Barus(Barus { alpha: 3e-7 });
    assert!(matches!(problem.solve(&system), Err(NoFilm::AboveLimit { .. })));
    let found = find(&problem, &system, [800.0, 0.0], &SearchOptions::default()).expect("a light load is carried");
    assert!(found.residual < 1e-10);
}
