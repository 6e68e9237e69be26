//! A wall that gives way along the path of a journal: against the rigid wall, the position at rest, differences of
//! films, and itself with shorter steps.

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use oilwedge_bearing::deflection::{EXACT, carried_changes, closed_film};
use oilwedge_bearing::duty_cycle::{Duty, DutyCycle, ForceAxes, Harmonic, Turning};
use oilwedge_bearing::orbit::{Motion, OrbitOptions, PathStep, Span};
use oilwedge_bearing::{Deadline, JournalLoad, SearchOptions, find};
use oilwedge_reynolds::film_thickness::WallStage;
use oilwedge_reynolds::solve::Neighbour;
use oilwedge_reynolds::terms::squeeze::Squeeze;
use oilwedge_reynolds::{Cavitation, FilmProblem, FilmSystem, Gap, JournalChange, JournalState, SolvedFilm, Storage};
use oilwedge_tests::elastic_liner::{carried, force_scale, layer, walled};
use oilwedge_tests::*;
use serde_json::Value;

use oilwedge_tests::rough_surfaces::contacts;

const MODELS: [Cavitation; 3] =
    [Cavitation::None, Cavitation::Guembel { pressure: 0.0 }, Cavitation::Reynolds { pressure: 0.0 }];

/// A film that squeezes, its wall a layer that moves by this compliance [m/Pa].
fn squeezed(cavitation: Cavitation, per_pressure: f64) -> FilmProblem {
    let mut problem = walled(RADIUS, 0.0, cavitation, |_| per_pressure);
    problem.terms.push(Arc::new(Squeeze));
    problem
}

fn ring() -> Arc<FilmSystem> {
    ring_system(36, 4, RADIUS, None)
}

/// A constant force of 1.5 units towards x, and a part of it that turns with the crank.
fn load_with(turning: f64) -> DutyCycle {
    let unit = force_scale();
    let of = |order: f64, cos: [f64; 2], sin: [f64; 2]| Harmonic {
        order,
        cos: [unit * cos[0], unit * cos[1], 0.0, 0.0],
        sin: [unit * sin[0], unit * sin[1], 0.0, 0.0],
    };
    let orders = vec![of(0.0, [1.5, 0.0], [0.0; 2]), of(1.0, [turning, 0.0], [0.0, 0.7 * turning])];
    let rotation = Turning { speed: SPEED, rod: None };
    DutyCycle::of_harmonics(orders, TAU, ForceAxes::Shell, rotation)
}

fn motion<'a>(problem: &'a FilmProblem, system: &'a Arc<FilmSystem>, cycle: &'a DutyCycle) -> Motion<'a> {
    Motion { problem, system, gap: Gap::of(problem, system), cycle, support: None, mass: 0.0 }
}

fn options(tolerance: f64, cycles: usize) -> OrbitOptions<'static> {
    OrbitOptions { tolerance, closure: 1e-10, cycles, deadline: Deadline::default(), observer: None }
}

/// Oil is conserved.
const CONSERVING: Cavitation = Cavitation::Jfo { pressure: 0.0 };
const START: [f64; 4] = [0.4 * CLEARANCE, 0.3 * CLEARANCE, 0.0, 0.0];

/// A ring with a groove, which feeds a film that conserves its oil.
fn fed_ring() -> Arc<FilmSystem> {
    ring_system(36, 4, RADIUS, Some(PI))
}

#[test]
fn a_wall_that_hardly_moves_leaves_the_orbit_as_it_is() {
    hardly_moves(Cavitation::Reynolds { pressure: 0.0 }, &ring());
    hardly_moves(CONSERVING, &fed_ring());
}

fn hardly_moves(model: Cavitation, system: &Arc<FilmSystem>) {
    let cycle = load_with(1.0);
    let soft = squeezed(model, 1e-30);
    let mut rigid = soft.clone();
    rigid.film_thickness.pop();
    let orbit = |problem: &FilmProblem| {
        let motion = motion(problem, system, &cycle);
        let orbit = motion.orbit(START, &options(1e-2, 1));
        orbit.unwrap_or_else(|reason| panic!("{reason}")).steps
    };
    let (soft, rigid) = (orbit(&soft), orbit(&rigid));
    assert_eq!(soft.len(), rigid.len());
    // Both solve a stage to 1e-3 of the tolerance, by iterations that end by rules of their own.
    for (soft, rigid) in soft.iter().zip(&rigid) {
        for k in 0..2 {
            let apart = (soft.at[k] - rigid.at[k]).abs() / CLEARANCE;
            assert!(apart < 1e-3 * 1e-2, "{apart:e} at {}", rigid.time);
        }
    }
}

#[test]
fn a_load_at_rest_leads_to_the_position_at_rest() {
    let problem = squeezed(Cavitation::Reynolds { pressure: 0.0 }, layer(0.05));
    let way = Way { start: START, turns: 6.0, options: options(1e-4, 1) };
    comes_to_rest(&problem, &ring(), 1.5, &way, 1e-8);
}

/// The peaks that touch press the wall out, and the journal follows it beyond the clearance.
#[test]
fn a_load_at_rest_leads_to_the_position_at_rest_where_surfaces_touch() {
    let mut problem = squeezed(Cavitation::Reynolds { pressure: 0.0 }, layer(0.05));
    problem.contact = contacts().into_iter().next();
    let way = Way { start: [0.9 * CLEARANCE, 0.2 * CLEARANCE, 0.0, 0.0], turns: 3.0, options: options(1e-2, 1) };
    let rest = comes_to_rest(&problem, &ring(), 6.0, &way, 1e-6);
    assert!(rest > CLEARANCE, "{rest}");
}

/// On triangles, films with a history carry their oil by another scheme than films at rest: on this mesh the place
/// differs by 2e-3 of the clearance, the deflection by 4e-3.
#[test]
fn a_load_at_rest_leads_to_the_position_at_rest_where_oil_is_conserved() {
    let way = Way { start: START, turns: 3.0, options: options(1e-4, 2) };
    comes_to_rest(&squeezed(CONSERVING, layer(0.05)), &fed_ring(), 1.5, &way, 5e-3);
}

/// How a journal comes to rest: steps are no longer than 1/32 of a cycle, and those near the place at rest may be as
/// long.
struct Way {
    start: [f64; 4],
    /// Turns of the journal in a cycle.
    turns: f64,
    options: OrbitOptions<'static>,
}

/// The film at rest under so many units of force is that to which the path leads; its eccentricity [m].
fn comes_to_rest(problem: &FilmProblem, system: &Arc<FilmSystem>, units: f64, way: &Way, within: f64) -> f64 {
    let force = units * force_scale();
    let duty = Duty { force: [force, 0.0], moment: [0.0; 2], speed: SPEED };
    let cycle = DutyCycle::constant(duty, way.turns * TAU, SPEED);
    let motion = motion(problem, system, &cycle);
    let orbit = motion.orbit(way.start, &way.options);
    let orbit = orbit.unwrap_or_else(|reason| panic!("{reason}"));
    let end = orbit.steps.last().expect("steps");
    let load: JournalLoad = [force, 0.0].into();
    let begin = FilmProblem {
        journal: JournalState { offset: [way.start[0], way.start[1]], ..problem.journal },
        ..problem.clone()
    };
    let rest = find(&begin, system, load, &SearchOptions::default()).unwrap_or_else(|reason| panic!("{reason}"));
    for k in 0..2 {
        let apart = (end.at[k] - rest.film.problem.journal.offset[k]).abs() / CLEARANCE;
        assert!(apart < within, "{apart:e}");
    }
    let wall = rest.film.problem.deflection().expect("a wall");
    let apart = end.wall.as_ref().expect("a wall").distance(wall) / CLEARANCE;
    assert!(apart < within, "{apart:e}");
    rest.film.problem.journal.eccentricity()
}

#[test]
fn the_tangent_of_a_stage_is_differences_of_closed_films() {
    for model in MODELS {
        let system = ring_system(72, 8, RADIUS, Some(PI));
        let problem = squeezed(model, layer(0.02));
        let known = [0.55 * CLEARANCE, -0.25 * CLEARANCE];
        let per_time = 8.0 * SPEED;
        let at = |offset: [f64; 2], near: Option<(&FilmProblem, Neighbour)>| {
            let (from, near) = near.unwrap_or((&problem, Neighbour::None));
            let journal =
                JournalState { offset, velocity: [0, 1].map(|k| per_time * (offset[k] - known[k])), ..from.journal };
            let moved = FilmProblem { journal, ..from.clone() };
            closed_film(moved, &system, near).unwrap_or_else(|reason| panic!("{}: {reason}", model.name()))
        };
        // A wall that was bent by a film before, and has followed in part.
        let here = [0.57 * CLEARANCE, -0.22 * CLEARANCE];
        let before = at(here, None);
        let bent = before.problem.deflection().expect("a wall");
        let stage = WallStage { per_time, known: bent.coefficients.iter().map(|d| 0.9 * d).collect() };
        let staged = before.problem.clone().deflected(Some(&bent.in_stage(stage)));
        let staged = at(here, Some((&staged, Neighbour::Start(&before))));
        let size = (0..2).map(|k| column(&staged, k, per_time)[k].abs());
        let size = size.fold(0.0, f64::max);
        for k in 0..2 {
            // Where negative pressures are left out, each point of quadrature that the zero line passes within a step
            // is missed.
            let step = 1e-7 * CLEARANCE;
            let by = |sign: f64| {
                let mut offset = here;
                offset[k] += sign * step;
                carried(&at(offset, Some((&staged.problem, Neighbour::Start(&staged))))).force
            };
            let (ahead, behind) = (by(1.0), by(-1.0));
            let tangent = column(&staged, k, per_time);
            for d in 0..2 {
                let difference = (ahead[d] - behind[d]) / (2.0 * step);
                let error = (difference - tangent[d]).abs() / size;
                assert!(error < 1e-6, "{} {d} {k}: {error:e}", model.name());
            }
        }
    }
}

/// A film that was full is torn apart, and its wall has followed in part: the oil of its cells counts as long as it
/// fills them.
#[test]
fn the_tangent_of_a_stage_that_conserves_its_oil_is_differences_of_closed_films() {
    let system = ring_system(72, 8, RADIUS, Some(PI));
    let problem = squeezed(CONSERVING, layer(0.02));
    let (known, here) = ([0.55 * CLEARANCE, -0.25 * CLEARANCE], [0.57 * CLEARANCE, -0.22 * CLEARANCE]);
    let per_time = 8.0 * SPEED;
    let placed = |offset: [f64; 2]| JournalState {
        offset,
        velocity: [0, 1].map(|k| per_time * (offset[k] - known[k])),
        ..problem.journal
    };
    // The wall as a film without memory bends it, and the oil of a full film under it.
    let swift =
        FilmProblem { cavitation: Cavitation::Reynolds { pressure: 0.0 }, journal: placed(known), ..problem.clone() };
    let before = closed_film(swift, &system, Neighbour::None).expect("a film");
    let bent = before.problem.deflection().expect("a wall");
    let full = FilmProblem { journal: placed(known), ..problem.clone() };
    let full = full.deflected(Some(bent)).oil_of_full_film(&system).expect("oil");
    let begin = FilmProblem { storage: Some(Arc::new(Storage { per_time, known: full })), ..problem.clone() };
    let begin = begin.deflected(Some(&bent.in_stage(bent.resting(per_time))));
    let at = |offset: [f64; 2], (from, near): (&FilmProblem, Neighbour)| {
        let moved = FilmProblem { journal: placed(offset), ..from.clone() };
        closed_film(moved, &system, near).unwrap_or_else(|reason| panic!("{reason}"))
    };
    let staged = at(here, (&begin, Neighbour::None));
    let broken = staged.solution.cavity.iter().filter(|cavity| **cavity).count();
    assert!(broken > 100, "{broken}");
    let size = (0..2).map(|k| column(&staged, k, per_time)[k].abs());
    let size = size.fold(0.0, f64::max);
    for k in 0..2 {
        let step = 1e-8 * CLEARANCE;
        let by = |sign: f64| {
            let mut offset = here;
            offset[k] += sign * step;
            carried(&at(offset, (&staged.problem, Neighbour::Start(&staged)))).force
        };
        let (ahead, behind) = (by(1.0), by(-1.0));
        let tangent = column(&staged, k, per_time);
        for d in 0..2 {
            let difference = (ahead[d] - behind[d]) / (2.0 * step);
            let error = (difference - tangent[d]).abs() / size;
            assert!(error < 1e-6, "{d} {k}: {error:e}");
        }
    }
}

/// How the force changes [N/m] where a coordinate changes, and its rate in a stage.
fn column(film: &SolvedFilm, k: usize, per_time: f64) -> [f64; 2] {
    let along = [0, 1].map(|d| if d == k { 1.0 } else { 0.0 });
    let change =
        JournalChange { offset: along, velocity: along.map(|part| per_time * part), ..JournalChange::default() };
    let changed = carried_changes(film, &[change], EXACT);
    changed.expect("a tangent")[0].by_film.force
}

/// Place and wall after a quarter of the second cycle in even steps, `fewest` and 4 times as many, against 8 times as
/// many. Order 4 in time, until what edges of the cavity that pass nodes leave is in sight: on this mesh 1e-6 of the
/// clearance, with a rigid wall too. The stages are solved far more exactly than that.
fn converges_with_the_step(model: Cavitation, system: &Arc<FilmSystem>, fewest: u32) {
    let cycle = load_with(1.0);
    let problem = squeezed(model, layer(0.05));
    let motion = motion(&problem, system, &cycle);
    let period = TAU / cycle.angular_speed();
    let orbit = motion.orbit(START, &options(5e-2, 1)).expect("an orbit");
    let begin = orbit.steps.last().expect("an end");
    let end = |steps: u32| {
        let mut here: PathStep = begin.clone();
        let idle = Span::between(begin, begin);
        for number in 1..=steps {
            let time = begin.time + period / 4.0 * f64::from(number) / f64::from(steps);
            let next = motion.between(&here, &idle, time, 1e-6);
            here = PathStep::of(&next.unwrap_or_else(|reason| panic!("{reason}")), 0.0);
        }
        here
    };
    let exact = end(8 * fewest);
    let errors = [fewest, 4 * fewest].map(end).map(|end| {
        let place = (end.at[0] - exact.at[0]).hypot(end.at[1] - exact.at[1]);
        let [wall, other] = [&end, &exact].map(|step| step.wall.as_ref().expect("a wall"));
        [place, wall.distance(other)].map(|apart| apart / CLEARANCE)
    });
    for k in 0..2 {
        let order = (errors[0][k] / errors[1][k]).log2() / 2.0;
        assert!(order > 1.9, "{} {k}: order {order}, {errors:?}", model.name());
    }
}

#[test]
fn place_and_wall_converge_with_the_step() {
    converges_with_the_step(Cavitation::Reynolds { pressure: 0.0 }, &ring(), 2);
    converges_with_the_step(CONSERVING, &fed_ring(), 8);
}

/// The shipped big end with a wall: structured finite volumes for half of the land, C_n by linear elements in r, film
/// and wall in one Newton iteration, the backward differentiation formula of second order with 720 steps a cycle. 64 x
/// 5 and 96 x 8 volumes: least film 5.6335 and 5.5796 um, deflection at the centres of volumes 3.866 and 3.891 um.
/// Greatest pressure, parabolas through the volumes around it: 33.352, 33.502 and 33.736 MPa on 48 x 4, 64 x 5 and 96 x
/// 8 volumes. Extrapolated by second order; the pressure on three grids leaves 0.2 MPa open, the place between centres
/// 1 % of the deflection.
pub(crate) fn the_big_end_with_a_wall_is_that_of_finite_volumes(result: &Value) {
    let number = |value: &Value, key: &str| value[key].as_f64().unwrap_or_else(|| panic!("no {key}: {value}"));
    for (name, reference, uncertain, part) in [
        ("cycle_film_thickness_min", 5.541e-6, 0.01e-6, 5e-3),
        ("cycle_pressure_max", 33.92e6, 0.2e6, 1e-2),
        ("cycle_deflection_max", 3.908e-6, 0.04e-6, 1e-2),
    ] {
        let quantity = &result["quantities"][name];
        let (value, bar) = (number(quantity, "value"), number(quantity, "error"));
        assert!((value / reference - 1.0).abs() < part, "{name}: {value}");
        assert!((value - reference).abs() <= bar + uncertain, "{name}: {value} {bar}");
    }
    let balances = &result["balances"];
    let [force, energy] = ["force", "energy"].map(|name| number(balances, name));
    assert!(force < 1e-5 && energy < 1e-3, "{balances}");
}
