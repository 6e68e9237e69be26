//! Orbits of short films under loads of harmonics.

use std::sync::Arc;

use oilwedge_bearing::duty_cycle::{ForceAxes, Harmonic, Turning};
use oilwedge_bearing::orbit::{Motion, Orbit, OrbitOptions};
use oilwedge_bearing::{Deadline, DutyCycle};
use oilwedge_reynolds::terms::squeeze::Squeeze;
use oilwedge_reynolds::{Cavitation, FilmProblem, FilmSystem, Gap, Theory};

use crate::{CLEARANCE, RADIUS, SPEED, plain_film, pressure_scale, ring_system};

/// A short ring of the slenderness B/D = b; triangles couple its lines, so that rows count too.
pub fn short(b: f64, cavitation: Cavitation, [columns, rows]: [u32; 2]) -> (FilmProblem, Arc<FilmSystem>) {
    let length = 2.0 * RADIUS * b;
    let mut problem = plain_film(length, 0.0, 0.0, SPEED);
    problem.terms.push(Arc::new(Squeeze));
    problem.theory = Theory::Short;
    problem.cavitation = cavitation;
    (problem, ring_system(columns, rows, length, None))
}

/// Unit of force `mu omega R^2/psi^2` [N].
pub fn unit_of_force() -> f64 {
    pressure_scale() * RADIUS * RADIUS
}

/// The orbit of a massless journal from `start`, over the clearance, in so many cycles.
///
/// # Panics
/// If it leaves the bearing.
pub fn orbit(
    film: &(FilmProblem, Arc<FilmSystem>),
    cycle: &DutyCycle,
    start: [f64; 2],
    tolerance: f64,
    cycles: usize,
) -> Orbit {
    let motion =
        Motion { problem: &film.0, system: &film.1, gap: Gap::of(&film.0, &film.1), cycle, support: None, mass: 0.0 };
    let options = OrbitOptions { tolerance, closure: 0.0, cycles, deadline: Deadline::default(), observer: None };
    let [x, y] = start.map(|part| part * CLEARANCE);
    motion.orbit([x, y, 0.0, 0.0], &options).expect("an orbit")
}

/// Place at which the last cycle ends, over the clearance.
///
/// # Panics
/// If the orbit has no step.
pub fn end(orbit: &Orbit) -> [f64; 2] {
    let at = orbit.steps.last().expect("steps").at;
    [at[0] / CLEARANCE, at[1] / CLEARANCE]
}

/// Harmonics of order, cosine and sine towards x and y, in units of the force.
pub fn harmonics(orders: &[(f64, [f64; 2], [f64; 2])], period: f64) -> DutyCycle {
    let force = |[x, y]: [f64; 2]| [x * unit_of_force(), y * unit_of_force(), 0.0, 0.0];
    let orders = orders.iter().map(|&(order, cos, sin)| Harmonic { order, cos: force(cos), sin: force(sin) });
    let turning = Turning { speed: SPEED, rod: None };
    DutyCycle::of_harmonics(orders.collect(), period, ForceAxes::Shell, turning)
}

/// `F = (0.02 + 0.01 cos tau, 0.005 sin 2 tau) mu omega R^2/psi^2`.
pub const TWO_HARMONICS: [(f64, [f64; 2], [f64; 2]); 3] =
    [(0.0, [0.02, 0.0], [0.0; 2]), (1.0, [0.01, 0.0], [0.0; 2]), (2.0, [0.0; 2], [0.0, 0.005])];
