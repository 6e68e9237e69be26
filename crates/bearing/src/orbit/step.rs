//! One step in time: its stages, and the estimate of its error.

use oilwedge_reynolds::NoFilm;

use super::motion::{Instant, Motion};
use super::path::Span;
use super::scheme::{COEFFICIENTS, DIAGONAL, EMBEDDED, NODES, STAGES};
use super::stage::{Accuracy, Known, NoStage};
use crate::coordinates::Vector;

/// A step that was made.
#[derive(Debug)]
pub(super) struct Made {
    /// Its end.
    pub(super) end: Instant,
    /// The acceleration of a rotor with mass there [m/s2].
    pub(super) acceleration: Vector,
    /// Estimate of the local error of the offsets [m], as the film damps it.
    pub(super) error: Vector,
}

/// Where a step begins.
pub(super) struct Begin<'a> {
    /// The journal there.
    pub(super) instant: &'a Instant,
    /// The acceleration of a rotor with mass [m/s2].
    pub(super) acceleration: Vector,
    /// The path before; none at the beginning.
    pub(super) before: Option<Span>,
}

impl Motion<'_> {
    /// A step of the length `dt` [s].
    pub(super) fn step(&self, from: &Begin, dt: f64, accuracy: Accuracy, films: &mut usize) -> Result<Made, NoStage> {
        let start = from.instant;
        let per_time = 1.0 / (DIAGONAL * dt);
        let mut rates = [start.velocity; STAGES];
        let mut accelerations = [from.acceleration; STAGES];
        let mut latest: Option<Instant> = None;
        let mut way = from.before;
        for stage in 1..STAGES {
            let so_far =
                |first: Vector, rates: &[Vector; STAGES]| combined(first, dt, &COEFFICIENTS[stage][..stage], rates);
            let known = Known {
                time: start.time + dt * NODES[stage],
                per_time,
                offset: so_far(start.at, &rates),
                rate: so_far(start.velocity, &accelerations),
            };
            let guess = match way {
                Some(span) => span.at(known.time),
                None => combined(start.at, dt * NODES[stage], &[1.0], &rates),
            };
            let is_nearer = |latest: &&Instant| (latest.time - known.time).abs() < (start.time - known.time).abs();
            let near = latest.as_ref().filter(is_nearer).unwrap_or(start);
            let found = self.stage(&known, guess, near, accuracy, films)?;
            rates[stage] = found.velocity;
            accelerations[stage] = [0, 1, 2, 3].map(|k| (found.velocity[k] - known.rate[k]) * per_time);
            if latest.as_ref().is_none_or(|latest| latest.time < found.time) {
                way = Some(Span::of_instants(start, &found));
            }
            latest = Some(found);
        }
        // The last stage is the end of the step.
        let end = latest.ok_or(NoStage::Diverged)?;
        let last = &COEFFICIENTS[STAGES - 1];
        let difference: [f64; STAGES] = std::array::from_fn(|j| last[j] - EMBEDDED[j]);
        let error = combined([0.0; 4], dt, &difference, &rates);
        Ok(Made {
            error: self.damped_error(&end, error, dt)?,
            acceleration: accelerations[STAGES - 1],
            end,
        })
    }

    /// `(m/(gamma dt) + C + gamma dt K)^-1 (m/(gamma dt) + C)` times an error: what stiffness leaves of it.
    fn damped_error(&self, end: &Instant, error: Vector, dt: f64) -> Result<Vector, NoFilm> {
        let inertia = self.masses().map(|mass| mass / (DIAGONAL * dt));
        let damping = self.tangent(end, 0.0, 1.0)?.with_diagonal(inertia);
        let with_stiffness = self.tangent(end, DIAGONAL * dt, 1.0)?.with_diagonal(inertia);
        Ok(with_stiffness.solve(damping.times(error)))
    }
}

/// `first + dt sum_j weight_j rate_j`.
fn combined(first: Vector, dt: f64, weights: &[f64], rates: &[Vector]) -> Vector {
    let sum = |k: usize| {
        weights
            .iter()
            .zip(rates)
            .map(|(weight, rate)| weight * rate[k])
            .sum::<f64>()
    };
    [0, 1, 2, 3].map(|k| first[k] + dt * sum(k))
}
