//! Orbits of films that conserve their oil.

use std::f64::consts::TAU;
use std::sync::Arc;

use oilwedge_bearing::duty_cycle::{Frame, Harmonic, Turning};
use oilwedge_bearing::orbit::{Motion, Orbit, OrbitOptions};
use oilwedge_bearing::{Deadline, Duty, DutyCycle};
use oilwedge_reynolds::terms::squeeze::Squeeze;
use oilwedge_reynolds::{Cavitation, FilmProblem, FilmSystem, Gap};
use oilwedge_tests::*;

const CONSERVING: Cavitation = Cavitation::Jfo { pressure: 0.0 };

/// One land beside a groove all around: B/R = 0.6, the groove at a tenth of `mu omega/psi^2`.
fn land(cavitation: Cavitation, [columns, rows]: [u32; 2]) -> (FilmProblem, FilmSystem) {
    let length = 0.6 * RADIUS;
    let mut problem = plain_film(length, 0.0, 0.0, SPEED);
    problem.terms.push(Arc::new(Squeeze));
    problem.cavitation = cavitation;
    let mesh = ring(columns, rows, length, 0.0);
    let mut regions = ends(&mesh, length, None);
    regions[0].pressure = 0.1 * pressure_scale();
    let system = FilmSystem::new(Arc::new(mesh), 2, regions).expect("a land");
    (problem, system)
}

fn follow(film: &(FilmProblem, FilmSystem), cycle: &DutyCycle, tolerance: f64, cycles: usize) -> Orbit {
    let motion = Motion {
        problem: &film.0,
        system: &film.1,
        gap: Gap::of(&film.0, &film.1),
        cycle,
        support: None,
        mass: 0.0,
    };
    let options = OrbitOptions {
        tolerance,
        closure: 1e-5,
        cycles,
        deadline: Deadline::default(),
        observer: None,
    };
    let start = [0.3 * CLEARANCE, 0.0, 0.0, 0.0];
    motion.orbit(start, &options).expect("an orbit")
}

fn unit_of_force() -> f64 {
    pressure_scale() * RADIUS * RADIUS
}

fn end(orbit: &Orbit) -> [f64; 2] {
    let [x, y, ..] = orbit.steps.last().expect("steps").at;
    [x / CLEARANCE, y / CLEARANCE]
}

/// Under a load that turns with the journal, and so with a shell that carries its groove all around, the journal runs round at the eccentricity of the bearing
/// whose load is at rest: turning frames exchange the speeds omega and omega - 2 omega.
#[test]
fn a_turning_load_leads_round_the_circle_of_the_load_at_rest() {
    let film = land(CONSERVING, [32, 3]);
    let load = 0.15 * unit_of_force();
    let duty = Duty {
        force: [load, 0.0],
        moment: [0.0; 2],
        speed: SPEED,
    };
    let still = follow(&film, &DutyCycle::constant(duty, 2.0 * TAU, SPEED), 2e-3, 6);
    let [x, y] = end(&still);
    let turning = Harmonic {
        order: 1.0,
        cos: [load, 0.0, 0.0, 0.0],
        sin: [0.0, load, 0.0, 0.0],
    };
    let speed = Turning {
        speed: SPEED,
        rod: None,
    };
    let cycle = DutyCycle::of_harmonics(vec![turning], TAU, Frame::Shell, speed);
    let orbit = follow(&film, &cycle, 2e-3, 8);
    let eccentricity = x.hypot(y);
    let off = |at: [f64; 4]| (at[0].hypot(at[1]) / CLEARANCE - eccentricity).abs();
    let off = orbit.steps.iter().map(|step| off(step.at)).fold(0.0, f64::max);
    assert!(off < 1e-3, "{eccentricity}: {off}");
    // Mirrored: it runs behind the load by as much as it ran before it.
    let last = orbit.steps.last().expect("steps").at;
    let angle = last[1].atan2(last[0]);
    assert!((angle + y.atan2(x)).abs() < 1e-2, "{angle} {x} {y}");
}

/// Load of a cycle with a peak: the film breaks all along, and the oil returns.
#[test]
fn an_orbit_closes_with_its_oil() {
    let film = land(CONSERVING, [24, 2]);
    let unit = unit_of_force();
    let orders = [
        (0.0, [0.2, 0.0], [0.0; 2]),
        (1.0, [0.15, 0.0], [0.0, 0.2]),
        (2.0, [0.0; 2], [0.1, 0.0]),
    ];
    let orders = orders.map(|(order, cos, sin): (f64, [f64; 2], [f64; 2])| Harmonic {
        order,
        cos: [unit * cos[0], unit * cos[1], 0.0, 0.0],
        sin: [unit * sin[0], unit * sin[1], 0.0, 0.0],
    });
    let speed = Turning {
        speed: SPEED,
        rod: None,
    };
    let cycle = DutyCycle::of_harmonics(orders.into(), 2.0 * TAU, Frame::Shell, speed);
    let orbit = follow(&film, &cycle, 1e-3, 5);
    let oils: Vec<_> = orbit.cycles.iter().filter_map(|cycle| cycle.oil).collect();
    assert_eq!(oils.len(), orbit.cycles.len());
    assert!(oils.iter().all(|oil| oil.imbalance < 1e-12), "{oils:?}");
    let last = orbit.cycles.last().expect("a cycle");
    assert!(last.closure < 1e-4 * CLEARANCE, "{:?}", orbit.cycles);
    assert!(oils.last().is_some_and(|oil| oil.closure < 1e-4), "{oils:?}");
}

/// A journal that does not turn sinks: the film above it breaks and none of it fills again, the film below is full. So the film of Swift and Stieber, which
/// forgets, is the same.
#[test]
fn a_journal_at_rest_sinks_as_in_a_film_without_memory() {
    let duty = Duty {
        force: [0.2 * unit_of_force(), 0.0],
        moment: [0.0; 2],
        speed: 0.0,
    };
    // In the time in which the shaft would turn by six radians.
    let cycle = DutyCycle::constant(duty, 1.0, SPEED / 6.0);
    let [x, y] = end(&follow(&land(CONSERVING, [32, 4]), &cycle, 1e-3, 1));
    let [expected, _] = end(&follow(
        &land(Cavitation::Reynolds { pressure: 0.0 }, [32, 4]),
        &cycle,
        1e-3,
        1,
    ));
    assert!(
        expected > 0.5 && (x - expected).abs() < 5e-3 && y.abs() < 1e-3,
        "{x} {y} {expected}"
    );
}
