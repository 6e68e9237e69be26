//! Orbits of films that conserve their oil.

use std::f64::consts::TAU;
use std::sync::Arc;

use oilwedge_bearing::duty_cycle::{ForceAxes, Harmonic, Turning};
use oilwedge_bearing::orbit::{Motion, Orbit, OrbitOptions, Span};
use oilwedge_bearing::{Deadline, Duty, DutyCycle};
use oilwedge_reynolds::quantities::load::load;
use oilwedge_reynolds::solve::Neighbour;
use oilwedge_reynolds::terms::squeeze::Squeeze;
use oilwedge_reynolds::{Cavitation, FilmProblem, FilmSystem, Gap};
use oilwedge_tests::*;

const CONSERVING: Cavitation = Cavitation::Jfo { pressure: 0.0 };

/// One land beside a groove all around: B/R = 0.6, the groove at a tenth of `mu omega/psi^2`.
fn land(cavitation: Cavitation, [columns, rows]: [u32; 2]) -> (FilmProblem, Arc<FilmSystem>) {
    let length = 0.6 * RADIUS;
    let mut problem = plain_film(length, 0.0, 0.0, SPEED);
    problem.terms.push(Arc::new(Squeeze));
    problem.cavitation = cavitation;
    let mesh = ring(columns, rows, length, 0.0);
    let mut regions = ends(&mesh, length, None);
    regions[0].pressure = 0.1 * pressure_scale();
    let system = Arc::new(FilmSystem::new(Arc::new(mesh), 2, regions).expect("a land"));
    (problem, system)
}

fn motion<'a>(film: &'a (FilmProblem, Arc<FilmSystem>), cycle: &'a DutyCycle) -> Motion<'a> {
    Motion { problem: &film.0, system: &film.1, gap: Gap::of(&film.0, &film.1), cycle, support: None, mass: 0.0 }
}

/// Follows a journal until its path closes to 1e-5, from 0.3 of the clearance towards the first load.
fn follow(film: &(FilmProblem, Arc<FilmSystem>), cycle: &DutyCycle, tolerance: f64, cycles: usize) -> Orbit {
    follow_from([0.3, 0.0], film, cycle, tolerance, cycles)
}

fn follow_from(
    start: [f64; 2],
    film: &(FilmProblem, Arc<FilmSystem>),
    cycle: &DutyCycle,
    tolerance: f64,
    cycles: usize,
) -> Orbit {
    let options = OrbitOptions { tolerance, closure: 1e-5, cycles, deadline: Deadline::default(), observer: None };
    let [x, y] = start.map(|part| part * CLEARANCE);
    (motion(film, cycle).orbit([x, y, 0.0, 0.0], &options)).expect("an orbit")
}

fn unit_of_force() -> f64 {
    pressure_scale() * RADIUS * RADIUS
}

fn end(orbit: &Orbit) -> [f64; 2] {
    let [x, y, ..] = orbit.steps.last().expect("steps").at;
    [x / CLEARANCE, y / CLEARANCE]
}

/// A load turns with the journal, and so with a shell that carries its groove all around, the journal runs round at the
/// eccentricity of the bearing whose load is at rest: turning frames exchange the speeds omega and omega - 2 omega.
/// Nodes fill and empty all along: 35 steps a turn leave 6e-4, 82 steps leave 5e-5.
#[test]
fn a_turning_load_leads_round_the_circle_of_the_load_at_rest() {
    let film = land(CONSERVING, [96, 1]);
    let load = 0.15 * unit_of_force();
    let duty = Duty { force: [load, 0.0], moment: [0.0; 2], speed: SPEED };
    let still = follow(&film, &DutyCycle::constant(duty, 2.0 * TAU, SPEED), 2e-3, 6);
    let [x, y] = end(&still);
    let turning = Harmonic { order: 1.0, cos: [load, 0.0, 0.0, 0.0], sin: [0.0, load, 0.0, 0.0] };
    let speed = Turning { speed: SPEED, rod: None };
    let cycle = DutyCycle::of_harmonics(vec![turning], TAU, ForceAxes::Shell, speed);
    // Mirrored: it runs behind the load by as much as it ran before it.
    let orbit = follow_from([x, -y], &film, &cycle, 5e-5, 7);
    let eccentricity = x.hypot(y);
    let off = |at: [f64; 4]| (at[0].hypot(at[1]) / CLEARANCE - eccentricity).abs();
    let off = orbit.steps.iter().map(|step| off(step.at)).fold(0.0, f64::max);
    assert!(off < 1e-4, "{eccentricity}: {off}");
    let last = orbit.steps.last().expect("steps").at;
    let angle = last[1].atan2(last[0]);
    assert!((angle + y.atan2(x)).abs() < 1e-3, "{angle} {x} {y}");
}

/// A load of three orders over two turns, this many times the usual one.
fn three_orders(times: f64) -> DutyCycle {
    let unit = times * unit_of_force();
    let orders = [(0.0, [0.2, 0.0], [0.0; 2]), (1.0, [0.15, 0.0], [0.0, 0.2]), (2.0, [0.0; 2], [0.1, 0.0])];
    let orders = orders.map(|(order, cos, sin): (f64, [f64; 2], [f64; 2])| Harmonic {
        order,
        cos: [unit * cos[0], unit * cos[1], 0.0, 0.0],
        sin: [unit * sin[0], unit * sin[1], 0.0, 0.0],
    });
    let speed = Turning { speed: SPEED, rod: None };
    DutyCycle::of_harmonics(orders.into(), 2.0 * TAU, ForceAxes::Shell, speed)
}

/// Least film on the path, over the clearance.
fn thinnest(orbit: &Orbit) -> f64 {
    let gaps = orbit.steps.windows(2).flat_map(|pair| {
        let span = Span::between(&pair[0], &pair[1]);
        let [from, to] = span.times;
        (0..=20).map(move |k| {
            let [x, y, ..] = span.at(from + (to - from) * f64::from(k) / 20.0);
            1.0 - x.hypot(y) / CLEARANCE
        })
    });
    gaps.fold(f64::INFINITY, f64::min)
}

/// The film that remembers has less oil, so less pressure at the same place and velocity. Under a heavy load that is
/// missing below the load, and the film is thinner than that of Swift and Stieber. Under a light one it is missing on
/// the other side, where the groove presses the journal into its load: the film is thicker.
#[test]
fn what_memory_takes_from_the_film_makes_it_thinner_under_heavy_loads_and_thicker_under_light_ones() {
    let [conserving, forgetting] =
        [CONSERVING, Cavitation::Reynolds { pressure: 0.0 }].map(|model| land(model, [24, 2]));
    for (times, is_thinner) in [(4.0, true), (1.0, false)] {
        let cycle = three_orders(times);
        let [with, without] = [&conserving, &forgetting].map(|film| follow(film, &cycle, 1e-3, 3));
        let [with_memory, without_memory] = [&with, &without].map(thinnest);
        assert_eq!(with_memory < 0.99 * without_memory, is_thinner, "{with_memory} {without_memory}");
        assert_eq!(with_memory > 1.01 * without_memory, !is_thinner, "{with_memory} {without_memory}");
        let here = |step: &&oilwedge_bearing::orbit::PathStep| step.at[0].hypot(step.at[1]);
        let step = with.steps.iter().max_by(|a, b| here(a).total_cmp(&here(b))).expect("steps");
        let film = motion(&conserving, &cycle).film_at(step, Neighbour::None).expect("a film");
        let other = FilmProblem { journal: film.film.problem.journal, ..forgetting.0.clone() };
        let forgetful = other.solve(&forgetting.1).expect("a film");
        let missing =
            (forgetful.solution.unknown.iter().zip(&film.film.solution.unknown)).map(|(without, with)| without - with);
        assert!(missing.sum::<f64>() > 0.0, "{times}");
        let towards_film = |force: [f64; 2]| (force[0] * step.at[0] + force[1] * step.at[1]) / here(&step);
        let carried = towards_film(load(&film.film).total.force);
        let forgetful = towards_film(load(&forgetful).total.force);
        assert_eq!(carried < forgetful, is_thinner, "{times}: {carried} {forgetful}");
    }
}

/// Load of a cycle with a peak: the film breaks all along, and the oil returns.
#[test]
fn an_orbit_closes_with_its_oil() {
    let film = land(CONSERVING, [24, 2]);
    let orbit = follow(&film, &three_orders(1.0), 1e-3, 5);
    let oils: Vec<_> = orbit.cycles.iter().filter_map(|cycle| cycle.oil).collect();
    assert_eq!(oils.len(), orbit.cycles.len());
    assert!(oils.iter().all(|oil| oil.imbalance < 1e-12), "{oils:?}");
    let last = orbit.cycles.last().expect("a cycle");
    assert!(last.closure < 1e-4, "{:?}", orbit.cycles);
    assert!(oils.last().is_some_and(|oil| oil.closure < 1e-4), "{oils:?}");
}

/// A journal that does not turn sinks: the film above it breaks and none of it fills again, the film below is full. So
/// the film of Swift and Stieber, which forgets, is the same.
#[test]
fn a_journal_at_rest_sinks_as_in_a_film_without_memory() {
    let duty = Duty { force: [0.2 * unit_of_force(), 0.0], moment: [0.0; 2], speed: 0.0 };
    // In the time in which the shaft would turn by six radians.
    let cycle = DutyCycle::constant(duty, 1.0, SPEED / 6.0);
    let [x, y] = end(&follow(&land(CONSERVING, [32, 4]), &cycle, 1e-3, 1));
    let [expected, _] = end(&follow(&land(Cavitation::Reynolds { pressure: 0.0 }, [32, 4]), &cycle, 1e-3, 1));
    assert!(expected > 0.5 && (x - expected).abs() < 5e-3 && y.abs() < 1e-3, "{x} {y} {expected}");
}
