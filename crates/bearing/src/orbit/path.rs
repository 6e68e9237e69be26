//! The path between two instants: the cubic through both places with both velocities (Hermite).

use std::sync::Arc;

use oilwedge_reynolds::film_thickness::Deflection;
use oilwedge_reynolds::{FilmTrace, Storage};

use super::motion::{Instant, Moving};
use super::oil::StoredOil;
use crate::coordinates::Vector;

/// One step of an orbit: the journal at its end.
#[derive(Debug, Clone, PartialEq)]
pub struct PathStep {
    /// Time [s], from the beginning of the cycle.
    pub time: f64,
    /// Offsets [m] in the coordinates of the motion.
    pub at: Vector,
    /// Rates of the coordinates [m/s].
    pub velocity: Vector,
    /// Estimate of the error that the step has made [m].
    pub error: Vector,
    /// Forces of film and support less the load of the journal's own cycle [N].
    pub excess: Vector,
    /// What is left of the equation of motion, over the peak of the load [1].
    pub residual: f64,
    /// What a film that conserves its oil has of the time before; `None` for others.
    pub history: Option<Arc<StepHistory>>,
    /// The deflection of a wall that gives way; `None` of a rigid one.
    pub wall: Option<Deflection>,
    /// What decides how the journal moves between this step and the next.
    pub until_next: Between,
}

/// What decides how a journal without mass moves at a place between two steps.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Between {
    /// The load: the velocity is that in which the film carries it.
    Load,
    /// The path: what a shaft leaves to one of its bearings is known at the steps alone, and a load that is drawn
    /// through them may be one that no film carries.
    Path,
}

/// What makes the film of a step again, and leads on from it, where the cavity conserves its oil.
#[derive(Debug, Clone, PartialEq)]
pub struct StepHistory {
    /// What the film held before.
    pub before: Arc<Storage>,
    /// The cavity that was found.
    pub trace: FilmTrace,
    /// The oil that it holds.
    pub oil: Arc<StoredOil>,
}

impl StepHistory {
    pub(super) fn of(here: &Instant) -> Option<Self> {
        Some(Self {
            before: here.film.problem.storage.clone()?,
            trace: here.film.solution.trace(),
            oil: here.oil.clone()?,
        })
    }
}

impl PathStep {
    /// A step that ends with an instant, with no estimate of an error.
    pub fn of(here: &Instant, residual: f64) -> Self {
        Self {
            time: here.time,
            at: here.at,
            velocity: here.velocity,
            excess: here.excess,
            error: [0.0; 4],
            residual,
            history: StepHistory::of(here).map(Arc::new),
            wall: here.film.problem.deflection().cloned(),
            until_next: Between::Load,
        }
    }

    /// Place [m] of the journal, and the wall that it has there.
    pub fn under_wall(&self) -> (Vector, Option<&Deflection>) {
        (self.at, self.wall.as_ref())
    }

    pub(super) fn moving(&self) -> Moving {
        Moving { time: self.time, at: self.at, velocity: self.velocity }
    }
}

/// A part of the path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Span {
    /// Times of both ends [s].
    pub times: [f64; 2],
    /// Places there [m].
    pub places: [Vector; 2],
    /// Rates there [m/s].
    pub rates: [Vector; 2],
}

impl Span {
    /// From one step to the next.
    pub fn between(from: &PathStep, to: &PathStep) -> Self {
        Self { times: [from.time, to.time], places: [from.at, to.at], rates: [from.velocity, to.velocity] }
    }

    /// From one instant to another.
    pub(super) fn of_instants(from: &Instant, to: &Instant) -> Self {
        Self { times: [from.time, to.time], places: [from.at, to.at], rates: [from.velocity, to.velocity] }
    }

    /// The place at a time [s], which may lie beyond the ends.
    pub fn at(&self, time: f64) -> Vector {
        self.summed(self.weights(time))
    }

    /// Weights at a time [s] of the values at both ends [1] and of their rates [s].
    pub fn weights(&self, time: f64) -> [f64; 4] {
        let (dt, s) = self.local(time);
        let (t, u) = (1.0 - s, s);
        [t * t * (1.0 + 2.0 * u), u * u * (1.0 + 2.0 * t), dt * t * t * u, -dt * u * u * t]
    }

    /// The rate at a time [s].
    pub fn rate(&self, time: f64) -> Vector {
        let (dt, s) = self.local(time);
        let (t, u) = (1.0 - s, s);
        let slope = 6.0 * t * u / dt;
        self.summed([-slope, slope, t * (t - 2.0 * u), u * (u - 2.0 * t)])
    }

    /// The wall at a time [s] on its way from one deflection to another, as coefficients [m]: on the cubic through
    /// both.
    pub fn wall(&self, [from, to]: [&Deflection; 2], time: f64) -> Vec<f64> {
        let [a, b, v, w] = self.weights(time);
        let ends = from.coefficients.iter().zip(&*to.coefficients);
        let mut wall: Vec<f64> = ends.map(|(from, to)| a * from + b * to).collect();
        for (weight, rate) in [(v, from.rate()), (w, to.rate())] {
            let rates = rate.iter().flat_map(|rate| rate.iter());
            wall.iter_mut().zip(rates).for_each(|(wall, rate)| *wall += weight * rate);
        }
        wall
    }

    /// Length of the span [s], and how far along it a time is [1].
    fn local(&self, time: f64) -> (f64, f64) {
        let dt = self.times[1] - self.times[0];
        (dt, (time - self.times[0]) / dt)
    }

    fn summed(&self, [from, to, rate_from, rate_to]: [f64; 4]) -> Vector {
        let ([a, b], [v, w]) = (&self.places, &self.rates);
        [0, 1, 2, 3].map(|k| from * a[k] + to * b[k] + rate_from * v[k] + rate_to * w[k])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cubic_is_its_own_path() {
        let place = |t: f64| [1.0 + 2.0 * t - t * t + 0.5 * t * t * t, t, -t * t, 0.0];
        let rate = |t: f64| [2.0 - 2.0 * t + 1.5 * t * t, 1.0, -2.0 * t, 0.0];
        let span = Span { times: [0.5, 2.0], places: [0.5, 2.0].map(place), rates: [0.5, 2.0].map(rate) };
        for time in [0.2, 0.5, 1.1, 2.0, 2.6] {
            for (found, right) in [(span.at(time), place(time)), (span.rate(time), rate(time))] {
                assert!((0..4).all(|k| (found[k] - right[k]).abs() < 1e-13), "{time}: {found:?}");
            }
        }
    }
}
