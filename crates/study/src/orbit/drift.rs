//! What the errors of mesh and steps do to an orbit: they are carried along it by the film's stiffness K and damping C.
//!
//! ```text
//! C d' + K d = -D                       d: off by the mesh; D: force of the better film less that of the orbit's
//! C d' + K d = 0,  d -> d + e_n         off by the steps in time; e_n: estimate of the error of each step
//! ```
//!
//! Both are solved by implicit Euler steps from film to film, twice around a closed orbit.
//!
//! Between two steps the path is a cubic, which is off by `k s^2 (1 - s)^2` to first order, s from 0 to 1. The film at s = 1/4 shows k: its velocity, by which it carries
//! the load, differs from that of the path by v, and `C d' + K d = -C v` there.

use oilwedge_bearing::coordinates::{Vector, length, moved};
use oilwedge_bearing::orbit::{Motion, OrbitEnd, Span, Step};

use super::sample::{Sampled, TOLERANCE, Tangents};
use crate::no_answer::NoAnswer;

/// Rounds of a closed orbit: what is left of the first start is forgotten.
const ROUNDS: usize = 2;

/// Gives each sample how far its numbers are off.
pub(super) fn carry(steps: &[Step], samples: &mut [Sampled], end: OrbitEnd) {
    let rounds = match end {
        OrbitEnd::Closed => ROUNDS,
        OrbitEnd::NotClosed | OrbitEnd::Ended => 1,
    };
    let (mut by_mesh, mut by_time) = ([0.0; 4], [0.0; 4]);
    for _ in 0..rounds {
        for number in 0..samples.len() {
            let before = number.checked_sub(1).map(|before| samples[before].sample.time);
            let Sampled { sample, tangents, .. } = &mut samples[number];
            let Some(tangents) = tangents else { return };
            if let Some(before) = before {
                let dt = sample.time - before;
                by_mesh = tangents.step(by_mesh, tangents.defect, dt);
                by_time = tangents.step(moved(by_time, 1.0, steps[number].error), [0.0; 4], dt);
            }
            let rates = [
                tangents.rate(by_mesh, tangents.defect),
                tangents.rate(by_time, [0.0; 4]),
            ];
            let off = |index: usize, by: Vector, rate: Vector| {
                dot(tangents.by_offset[index], by) + dot(tangents.by_rate[index], rate)
            };
            sample.drift = (0..sample.quantities.len())
                .map(|index| [off(index, by_mesh, rates[0]), off(index, by_time, rates[1])])
                .collect();
        }
    }
}

/// How far the path between two steps is off at a time [m], estimated; nothing for a rotor with mass, whose film carries another load.
///
/// # Errors
/// [`NoAnswer`]: there is no film between the steps.
pub(super) fn between(motion: &Motion, (step, span): (&Step, Span), time: f64) -> Result<f64, NoAnswer> {
    const QUARTER: f64 = 0.25;
    if motion.mass > 0.0 {
        return Ok(0.0);
    }
    let [from, to] = span.times;
    let (dt, at) = (to - from, from + QUARTER * (to - from));
    let instant = motion.between(step, &span, at, TOLERANCE).map_err(NoAnswer::Orbit)?;
    let differs = moved(instant.velocity, -1.0, span.rate(at));
    let damping = motion.tangent(&instant, 0.0, 1.0)?;
    let stiffness = motion.tangent(&instant, 1.0, 0.0)?;
    // s^2 (1 - s)^2 and its derivative 2 s (1 - s) (1 - 2 s) at s = 1/4.
    let (value, slope) = (9.0 / 256.0, 3.0 / 16.0);
    let pushed = damping.times(differs).map(|part| dt / slope * part);
    let k = damping.plus(dt * value / slope, &stiffness).solve(pushed);
    let s = (time - from) / dt;
    Ok(length(k) * (s * (1.0 - s)).powi(2))
}

impl Tangents {
    /// `(C + dt K)^-1 (C d - dt D)`.
    fn step(&self, from: Vector, defect: Vector, dt: f64) -> Vector {
        let pushed = moved(self.damping.times(from), -dt, defect);
        self.damping.plus(dt, &self.stiffness).solve(pushed)
    }

    /// `C^-1 (-D - K d)`.
    fn rate(&self, at: Vector, defect: Vector) -> Vector {
        let pushed = moved(self.stiffness.times(at), 1.0, defect).map(|part| -part);
        self.damping.solve(pushed)
    }
}

fn dot(a: Vector, b: Vector) -> f64 {
    (0..4).map(|k| a[k] * b[k]).sum()
}
