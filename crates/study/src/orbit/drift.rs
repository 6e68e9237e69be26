//! What the errors of mesh and steps do to an orbit: they are carried along it by the film's stiffness K and damping C.
//!
//! ```text
//! C d' + K d = -D                       d: off by the mesh; D: force of the better film less that of the orbit's
//! C d' + K d = 0,  d -> d + e_n         off by the steps in time; e_n: estimate of the error of each step
//! ```
//!
//! Both are solved by implicit Euler steps from film to film, twice around a closed orbit, and each step's part by
//! itself: `d = sum d_n`. The estimate e_n is that of the embedded method: its size is right, its sign is not that of
//! the error, so parts that cancel are not trusted to do so. The estimate D has the sign of the error, and is itself
//! off by some [`UNSURE`] of it. For a number with the derivatives `s` by d and d':
//! ```text
//! time: sum_n |s.d_n|           mesh: |sum_n s.d_n| + 1/4 sum_n |s.d_n|
//! ```
//!
//! Between two steps the path is a cubic, which is off by `k s^2 (1 - s)^2` to first order, s from 0 to 1. The film at
//! s = 1/4 shows k: its velocity, by which it carries the load, differs from that of the path by v, and
//! `C d' + K d = -C v` there. In a wall that gives way that film is led on to by a step, and shows k by its place.
//!
//! An orbit that closes is still off by what further cycles would move it: by `distance/(1 - rho)` at the beginning of
//! the last cycle and `rho` times that at its end, where `rho` is the contraction from cycle to cycle. Its direction is
//! not known: unit deviations `u_k` of all coordinates are carried along the orbit, and a number is off by
//! `distance/(1 - rho) sqrt(sum_k (s.u_k)^2)`.
//!
//! K and C of such a wall are those of slow motions, which it follows; its deflection has no deviation of its own.

use oilwedge_bearing::coordinates::{Vector, dot, length, moved, unit};
use oilwedge_bearing::orbit::{Cycle, Motion, OrbitEnd, PathStep, Span};

use super::sample::{FilmTangents, Sampled, TOLERANCE};
use crate::no_answer::NoAnswer;

/// Rounds of a closed orbit: what is left of the first start is forgotten.
const ROUNDS: usize = 2;

/// Part of the cubic film's force less that of the quadratic one by which it may differ from the error.
const UNSURE: f64 = 0.25;

/// Gives each sample how far its numbers are off.
pub(super) fn carry(steps: &[PathStep], samples: &mut [Sampled], end: OrbitEnd) {
    // An interrupt leaves later films without their bars: then none has one.
    if samples.iter().any(|one| one.tangents.is_none()) {
        return;
    }
    let rounds = match end {
        OrbitEnd::Closed => ROUNDS,
        OrbitEnd::NotClosed | OrbitEnd::Ended => 1,
    };
    // Where the first film begins nothing is off yet, but its force.
    let (mut by_mesh, mut by_time) = (DriftParts(vec![[0.0; 4]]), DriftParts(Vec::new()));
    for _ in 0..rounds {
        for number in 0..samples.len() {
            let before = number.checked_sub(1).map(|before| samples[before].sample.time);
            let Sampled { sample, tangents, .. } = &mut samples[number];
            let Some(tangents) = tangents else { return };
            if let Some(before) = before {
                let dt = sample.time - before;
                by_time.add(steps[number].error);
                by_time.carry(tangents, dt);
                by_mesh.carry(tangents, dt);
                by_mesh.add(tangents.step([0.0; 4], tangents.defect, dt));
            }
            let (mesh, time) = (by_mesh.of_numbers(tangents, tangents.defect), by_time.of_numbers(tangents, [0.0; 4]));
            sample.drift = (mesh.iter().zip(&time))
                .map(|(mesh, time)| [mesh.sum.abs() + UNSURE * mesh.sizes, time.sizes])
                .collect();
        }
    }
}

/// Adds what the closure of the last cycle leaves of the distance to the limit of all cycles; an orbit that does not
/// contract has no bars.
pub(super) fn add_closure((cycles, clearance): (&[Cycle], f64), samples: &mut [Sampled], order: usize) {
    let Some(last) = cycles.last() else { return };
    let mut deviations = DriftParts((0..order).map(unit).collect());
    let (mut before, mut sizes) = (None, Vec::with_capacity(samples.len()));
    for Sampled { sample, tangents, .. } in samples.iter() {
        let Some(tangents) = tangents else { return };
        if let Some(before) = before.replace(sample.time) {
            deviations.carry(tangents, sample.time - before);
        }
        sizes.push(deviations.size_of_numbers(tangents));
    }
    let carried = deviations.0.iter().map(|deviation| length(*deviation));
    let by_tangents = carried.fold(0.0, f64::hypot);
    let by_cycles = match cycles {
        [.., before, _] => Some(last.closure / before.closure).filter(|ratio| *ratio < 1.0),
        _ => None,
    };
    let left = 1.0 - by_cycles.unwrap_or(by_tangents);
    for (Sampled { sample, .. }, sizes) in samples.iter_mut().zip(sizes) {
        match left > 0.0 {
            true => (sample.drift.iter_mut().zip(sizes))
                .for_each(|([_, time], size)| *time += clearance * last.closure / left * size),
            false => sample.drift.clear(),
        }
    }
}

/// What each step has made a journal deviate by until now [m].
#[derive(Debug)]
struct DriftParts(Vec<Vector>);

/// What the parts change a number by: together, and the sum of their sizes.
struct OfNumber {
    sum: f64,
    sizes: f64,
}

impl DriftParts {
    fn add(&mut self, part: Vector) {
        self.0.push(part);
    }

    fn carry(&mut self, tangents: &FilmTangents, dt: f64) {
        for part in &mut self.0 {
            *part = tangents.step(*part, [0.0; 4], dt);
        }
    }

    /// What parts of unknown sign, at right angles to each other at first, change each number of a film by.
    fn size_of_numbers(&self, tangents: &FilmTangents) -> Vec<f64> {
        let moving: Vec<[Vector; 2]> = (self.0.iter()).map(|&part| [part, tangents.rate(part, [0.0; 4])]).collect();
        let size = |(by_offset, by_rate): (&Vector, &Vector)| {
            let parts = moving.iter().map(|[part, rate]| dot(*by_offset, *part) + dot(*by_rate, *rate));
            parts.fold(0.0, f64::hypot)
        };
        tangents.by_offset.iter().zip(&tangents.by_rate).map(size).collect()
    }

    /// What they change each number of a film by, the last of them being pushed on by a `defect` of force [N].
    fn of_numbers(&self, tangents: &FilmTangents, defect: Vector) -> Vec<OfNumber> {
        let last = self.0.len().saturating_sub(1);
        let moving: Vec<[Vector; 2]> = (self.0.iter().enumerate())
            .map(|(number, &part)| {
                let pushed = if number == last { defect } else { [0.0; 4] };
                [part, tangents.rate(part, pushed)]
            })
            .collect();
        let of_number = |(by_offset, by_rate): (&Vector, &Vector)| {
            let parts = moving.iter().map(|[part, rate]| dot(*by_offset, *part) + dot(*by_rate, *rate));
            parts.fold(OfNumber { sum: 0.0, sizes: 0.0 }, |all, part| OfNumber {
                sum: all.sum + part,
                sizes: all.sizes + part.abs(),
            })
        };
        tangents.by_offset.iter().zip(&tangents.by_rate).map(of_number).collect()
    }
}

/// How far the path between two steps is off at a time [m], estimated; nothing where the path decides how the journal
/// moves: the film carries another load than that of the motion.
///
/// # Errors
/// [`NoAnswer`]: there is no film between the steps.
pub(super) fn between(motion: &Motion, (step, span): (&PathStep, Span), time: f64) -> Result<f64, NoAnswer> {
    const QUARTER: f64 = 0.25;
    if motion.moves_by_path(step) {
        return Ok(0.0);
    }
    let [from, to] = span.times;
    let (dt, at) = (to - from, from + QUARTER * (to - from));
    let instant = motion.between(step, &span, at, TOLERANCE).map_err(NoAnswer::Orbit)?;
    let s = (time - from) / dt;
    let shape = (s * (1.0 - s)).powi(2);
    // s^2 (1 - s)^2 and its derivative 2 s (1 - s) (1 - 2 s) at s = 1/4.
    let (value, slope) = (9.0 / 256.0, 3.0 / 16.0);
    if instant.film.problem.deflection().is_some() {
        let differs = moved(instant.at, -1.0, span.at(at));
        return Ok(length(differs) / value * shape);
    }
    let differs = moved(instant.velocity, -1.0, span.rate(at));
    let damping = motion.tangent(&instant, 0.0, 1.0)?;
    let stiffness = motion.tangent(&instant, 1.0, 0.0)?;
    let pushed = damping.times(differs).map(|part| dt / slope * part);
    let k = damping.plus(dt * value / slope, &stiffness).solve(pushed);
    Ok(length(k) * shape)
}

impl FilmTangents {
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
