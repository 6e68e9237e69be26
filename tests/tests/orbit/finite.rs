//! Orbits of finite films against structured finite volumes, extrapolated.

use std::f64::consts::TAU;
use std::sync::Arc;

use oilwedge_bearing::Deadline;
use oilwedge_bearing::duty_cycle::{DutyCycle, ForceAxes, Harmonic, Turning};
use oilwedge_bearing::orbit::{Motion, OrbitOptions, TiltSupport};
use oilwedge_reynolds::film_thickness::Tilt;
use oilwedge_reynolds::terms::squeeze::Squeeze;
use oilwedge_reynolds::{Cavitation, Gap};
use oilwedge_tests::*;

/// A plain ring, B/D = 0.5, Swift-Stieber; `F = (2 + 1.5 cos tau, sin tau) mu omega R^2/psi^2` acts at z = 0.08 R, and
/// a support of the stiffness 0.4 holds the tilt: least film, and place and tilt at a quarter, half and the end of a
/// cycle that begins in the place of the reference.
#[test]
fn a_tilting_journal_runs_the_orbit_of_finite_volumes() {
    let length = RADIUS;
    let mut problem = plain_film(length, 0.0, 0.0, SPEED);
    problem.terms.push(Arc::new(Squeeze));
    problem.film_thickness.push(Arc::new(Tilt { radius: RADIUS }));
    problem.cavitation = Cavitation::Reynolds { pressure: 0.0 };
    let system = ring_system(56, 8, length, None);
    let unit = pressure_scale() * RADIUS * RADIUS;
    let of = |order: f64, cos: [f64; 2], sin: [f64; 2]| Harmonic {
        order,
        cos: [unit * cos[0], unit * cos[1], 0.0, 0.0],
        sin: [unit * sin[0], unit * sin[1], 0.0, 0.0],
    };
    let orders = vec![of(0.0, [2.0, 0.0], [0.0; 2]), of(1.0, [1.5, 0.0], [0.0, 1.0])];
    let turning = Turning { speed: SPEED, rod: None };
    let cycle = DutyCycle::of_harmonics(orders, TAU, ForceAxes::Shell, turning).acting_at(0.08 * RADIUS);
    let motion = Motion {
        problem: &problem,
        system: &system,
        gap: Gap::of(&problem, &system),
        cycle: &cycle,
        support: Some(TiltSupport { stiffness: 0.4 * unit * RADIUS * RADIUS / CLEARANCE, slope: [0.0; 2] }),
        mass: 0.0,
    };
    let options =
        OrbitOptions { tolerance: 1e-3, closure: 0.0, cycles: 1, deadline: Deadline::default(), observer: None };
    // X, Y, g_x R/c, g_y R/c at the beginning and the end; the arm of the coordinates is half of the length, R/2.
    let begin = [0.72956, 0.196, 0.1978, -0.014728];
    let [x, y, g_x, g_y] = begin;
    let start = [x, y, 0.5 * g_x, 0.5 * g_y].map(|part| part * CLEARANCE);
    let orbit = motion.orbit(start, &options).expect("an orbit");
    let path: Vec<_> =
        orbit.steps.windows(2).map(|pair| oilwedge_bearing::orbit::Span::between(&pair[0], &pair[1])).collect();
    let period = path.last().expect("steps").times[1];
    let at = |part: f64| {
        let time = part * period;
        let span = path.iter().find(|span| span.times[1] >= time).expect("a span");
        span.at(time)
    };
    let rows =
        [(0.25, [0.57331, 0.60504, 0.14094, 0.058482]), (0.5, [0.15471, 0.78872, 0.11298, 0.025898]), (1.0, begin)];
    for (part, expected) in rows {
        let [x, y, z_x, z_y] = at(part).map(|part| part / CLEARANCE);
        let found = [x, y, 2.0 * z_x, 2.0 * z_y];
        for (found, expected) in found.into_iter().zip(expected) {
            assert!((found - expected).abs() < 2e-3, "{part}: {found} {expected}");
        }
    }
    let gap = |time: f64| {
        let journal = motion.coordinates().placed(&problem.journal, at(time));
        motion.gap.least(&journal) / CLEARANCE
    };
    let least = (0..=2000).map(|k| gap(f64::from(k) / 2000.0)).fold(f64::INFINITY, f64::min);
    assert!((least / 0.093196 - 1.0).abs() < 3e-3, "{least}");
}
