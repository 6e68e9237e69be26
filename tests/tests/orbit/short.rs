//! Orbits of short films, whose equation of motion has closed solutions.

use std::f64::consts::{PI, TAU};

use oilwedge_bearing::orbit::{Motion, NoOrbit, OrbitOptions, Span};
use oilwedge_bearing::{Deadline, Duty, DutyCycle, SearchOptions, find};
use oilwedge_reynolds::{Cavitation, Gap};
use oilwedge_tests::short_orbits::*;
use oilwedge_tests::*;

const HALF: Cavitation = Cavitation::Guembel { pressure: 0.0 };

/// `q = e/(1 - eps^2)^(3/2)` obeys `q' = (i/2) q + F/(8 pi b^3)` for any load: where the journal is after one turn.
#[test]
fn a_full_short_film_whirls_as_the_closed_solution() {
    let film = short(0.25, Cavitation::None, [96, 4]);
    let [x, y] = end(&orbit(&film, &harmonics(&TWO_HARMONICS, TAU), [0.2, 0.3], 1e-5, 1));
    assert!((x + 0.21670557).hypot(y + 0.187731447) < 5e-6, "{x} {y}");
    // With half as many columns and rows it is 16 times as far off: the film, not the steps.
    let rough = short(0.25, Cavitation::None, [48, 2]);
    let [x, y] = end(&orbit(&rough, &harmonics(&TWO_HARMONICS, TAU), [0.2, 0.3], 1e-5, 1));
    let off = (x + 0.21670557).hypot(y + 0.187731447);
    assert!(off > 1e-5 && off < 1e-4, "{off}");
}

/// Steps of a cycle of eight turns are as long as the tolerance allows: a hundredth of the tolerance leaves a twentieth
/// of the error.
#[test]
fn errors_fall_with_the_tolerance() {
    let film = short(0.25, HALF, [24, 2]);
    let orders = [(0.0, [0.3, 0.0], [0.0; 2]), (1.0, [0.5, 0.0], [0.0, 0.5])];
    let heavy = harmonics(&orders, 8.0 * TAU);
    let at = |tolerance: f64| end(&orbit(&film, &heavy, [0.3, 0.0], tolerance, 1));
    let exact = at(1e-6);
    let [coarse, fine] = [1e-2, 1e-4].map(|tolerance| {
        let [x, y] = at(tolerance);
        (x - exact[0]).hypot(y - exact[1])
    });
    assert!(fine < 0.05 * coarse && fine < 1e-4, "{coarse} {fine}");
}

/// A journal whose load turns with omega_l runs round at the eccentricity of the bearing at rest at the speed |omega -
/// 2 omega_l|.
fn runs_round_a_circle((b, load, ratio, eps): (f64, f64, f64, f64), start: [f64; 2], cycles: usize) {
    let film = short(b, HALF, [64, 4]);
    let turning = harmonics(&[(ratio, [load, 0.0], [0.0, load])], TAU / ratio);
    let orbit = orbit(&film, &turning, start, 1e-4, cycles);
    let circle = |at: [f64; 4]| (at[0].hypot(at[1]) / CLEARANCE - eps).abs();
    let off = orbit.steps.iter().map(|step| circle(step.at)).fold(0.0, f64::max);
    assert!(off < 1e-4, "{ratio}: {off}");
}

/// Where a journal begins that runs behind a load that turns with it, at the attitude angle of Ocvirk's film: the film
/// turns backwards, seen from the load.
fn behind_the_load(eps: f64) -> [f64; 2] {
    let attitude = f64::atan2(PI * f64::sqrt(1.0 - eps * eps), 4.0 * eps);
    [eps * attitude.cos(), -eps * attitude.sin()]
}

#[test]
fn a_turning_load_leads_round_a_circle() {
    let eps = 0.36148589;
    runs_round_a_circle((0.4, 0.2, 1.0, eps), behind_the_load(eps), 2);
    // From elsewhere.
    runs_round_a_circle((0.25, 0.02, 0.25, 0.31887577), [0.1, 0.0], 4);
}

/// A load turning against the rotation, and one at rest, which leads to the position of equilibrium.
#[test]
fn a_load_at_rest_leads_to_its_equilibrium() {
    let film = short(0.25, HALF, [32, 2]);
    let force = [0.1 * unit_of_force(), 0.0];
    let duty = Duty { force, moment: [0.0; 2], speed: SPEED };
    let cycle = DutyCycle::constant(duty, 2.0 * TAU, SPEED);
    let [x, y] = end(&orbit(&film, &cycle, [0.3, 0.0], 1e-8, 12));
    let mut start = film.0.clone();
    start.journal.offset = [0.3 * CLEARANCE, 0.0];
    let found = find(&start, &film.1, force, &SearchOptions::default()).expect("a position");
    let [e_x, e_y] = found.film.problem.journal.offset.map(|part| part / CLEARANCE);
    assert!((x - e_x).abs() < 1e-8 && (y - e_y).abs() < 1e-8, "{x} {y} {e_x} {e_y}");
}

/// Times in which a journal at rest sinks from the middle, in `mu R^2 b^3/(F psi^2)`.
#[test]
fn a_journal_that_does_not_turn_sinks_in_the_time_of_the_closed_film() {
    let b: f64 = 0.25;
    let film = short(b, HALF, [64, 4]);
    let force = 100.0;
    let psi = CLEARANCE / RADIUS;
    let unit = VISCOSITY * RADIUS * RADIUS * b.powi(3) / (force * psi * psi);
    let duty = Duty { force: [force, 0.0], moment: [0.0; 2], speed: 0.0 };
    for (eps, time) in [(0.5, 15.5647955), (0.8, 88.2397495), (0.9, 268.01361)] {
        let cycle = DutyCycle::constant(duty, 1.0, 1.0 / (time * unit));
        let [x, y] = end(&orbit(&film, &cycle, [0.0, 0.0], 1e-5, 1));
        // Eccentricity by time: d eps/d ln t is 0.5 at 0.5 and less beyond.
        assert!((x - eps).abs() < 5e-5 && y.abs() < 1e-12, "{eps}: {x} {y}");
    }
}

/// A rotor with mass under a load at rest: below the speed at which it whirls it comes to rest in the same place.
#[test]
fn a_rotor_with_mass_settles_in_the_same_place() {
    let film = short(0.25, HALF, [32, 2]);
    let duty = Duty { force: [0.3 * unit_of_force(), 0.0], moment: [0.0; 2], speed: SPEED };
    let cycle = DutyCycle::constant(duty, 2.0 * TAU, SPEED);
    let [x, y] = end(&orbit(&film, &cycle, [0.5, 0.0], 1e-4, 10));
    let motion = Motion {
        problem: &film.0,
        system: &film.1,
        gap: Gap::of(&film.0, &film.1),
        cycle: &cycle,
        support: None,
        mass: 0.1 * 0.3 * unit_of_force() / (CLEARANCE * SPEED * SPEED),
    };
    let options =
        OrbitOptions { tolerance: 1e-4, closure: 0.0, cycles: 20, deadline: Deadline::default(), observer: None };
    let heavy = motion.orbit([0.5 * CLEARANCE, 0.0, 0.0, 0.0], &options).expect("an orbit");
    let [with_x, with_y] = end(&heavy);
    assert!((x - with_x).hypot(y - with_y) < 1e-3, "{x} {y} {with_x} {with_y}");
}

/// Two steps inside the bearing between which the cubic path runs into the wall: that is no squeezed film, and the
/// answer says where it is.
#[test]
fn a_path_that_leaves_the_bearing_between_two_steps_is_told() {
    let film = short(0.25, HALF, [32, 2]);
    let duty = Duty { force: [0.3 * unit_of_force(), 0.0], moment: [0.0; 2], speed: SPEED };
    let cycle = DutyCycle::constant(duty, 2.0 * TAU, SPEED);
    let motion = Motion {
        problem: &film.0,
        system: &film.1,
        gap: Gap::of(&film.0, &film.1),
        cycle: &cycle,
        support: None,
        mass: 0.0,
    };
    let orbit = orbit(&film, &cycle, [0.5, 0.0], 1e-2, 1);
    let (dt, place) = (1e-3, [0.9 * CLEARANCE, 0.0, 0.0, 0.0]);
    let rate = CLEARANCE / dt;
    let span = Span { times: [0.0, dt], places: [place; 2], rates: [[rate, 0.0, 0.0, 0.0], [-rate, 0.0, 0.0, 0.0]] };
    // In the middle at 0.9 + 1/4.
    let found = motion.between(&orbit.steps[0], &span, 0.5 * dt, 1e-4);
    let reason = found.expect_err("no film");
    let NoOrbit::Between { gap, .. } = reason else {
        panic!("{reason}");
    };
    assert!((gap + 0.15).abs() < 1e-9, "{gap}");
}
