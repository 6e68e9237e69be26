//! The wall along an orbit: its deflection is integrated by the method of the journal's path.
//!
//! A stage knows `d_0 = d_n + dt sum_{j<i} a_ij d_j'` and moves by `d' = (d - d_0)/(gamma dt)` ([`WallStage`]); the
//! deflection closes with the film of the stage, whose thickness changes by d' too. A film that conserves its oil takes
//! the rate of its thickness from what its cells held before; that of the wall is the one of its tangent.

use std::sync::Arc;

use oilwedge_reynolds::film_thickness::{Deflection, WallStage};

use super::motion::Instant;
use super::path::Span;
use super::scheme::Scheme;

/// The way from one instant to another, of journal and wall.
#[derive(Debug, Clone)]
pub(super) struct WallPath {
    /// Path of the journal.
    pub(super) span: Span,
    /// The wall at both ends; none where it is rigid.
    walls: Option<[Deflection; 2]>,
}

impl WallPath {
    pub(super) fn between(from: &Instant, to: &Instant) -> Self {
        let walls = from.film.problem.deflection().zip(to.film.problem.deflection());
        Self { span: Span::of_instants(from, to), walls: walls.map(|(from, to)| [from.clone(), to.clone()]) }
    }

    /// Where the wall is to be expected at a time [s], as coefficients [m]: on the cubic through both ends.
    fn wall(&self, time: f64) -> Option<Vec<f64>> {
        let [from, to] = self.walls.as_ref()?;
        Some(self.span.wall([from, to], time))
    }
}

/// The wall in the stages of one step.
pub(super) struct WallStages {
    /// Coefficients where the step begins [m].
    begin: Arc<[f64]>,
    /// Coefficients of the rates of the stages [m/s], the first one being that of the beginning.
    rates: Vec<Arc<[f64]>>,
}

impl WallStages {
    /// Stages of a step from an instant; none where the wall is rigid.
    pub(super) fn from(start: &Instant) -> Option<Self> {
        let deflection = start.film.problem.deflection()?;
        let at_rest = || vec![0.0; deflection.coefficients.len()].into();
        Some(Self {
            begin: deflection.coefficients.clone(),
            rates: vec![deflection.rate().cloned().unwrap_or_else(at_rest)],
        })
    }

    /// What stage number `stage` of a step of the length `dt` [s] knows, and where the wall is to be expected at its
    /// `time` [s] on its way: without one, further at the rate of the beginning.
    pub(super) fn stage(
        &self,
        (scheme, stage): (&Scheme, usize),
        dt: f64,
        (way, time): (Option<&WallPath>, f64),
    ) -> (WallStage, Vec<f64>) {
        let known = self.combined(&self.begin, dt, &scheme.coefficients[stage][..stage]);
        let expected = way.and_then(|way| way.wall(time));
        let straight = || self.combined(&self.begin, dt * scheme.nodes[stage], &[1.0]);
        let stage = WallStage { per_time: 1.0 / (scheme.diagonal * dt), known: known.into() };
        (stage, expected.unwrap_or_else(straight))
    }

    /// A stage that was found.
    pub(super) fn add(&mut self, found: &Instant) {
        let rate = found.film.problem.deflection().and_then(|deflection| deflection.rate());
        self.rates.extend(rate.cloned());
    }

    /// Estimate of the error of the step, as coefficients [m].
    pub(super) fn error(&self, scheme: &Scheme, dt: f64) -> Vec<f64> {
        self.combined(&vec![0.0; self.begin.len()], dt, &scheme.error_weights())
    }

    /// `first + dt sum_j weight_j rate_j`.
    fn combined(&self, first: &[f64], dt: f64, weights: &[f64]) -> Vec<f64> {
        let mut sum = first.to_vec();
        for (weight, rate) in weights.iter().zip(&self.rates) {
            sum.iter_mut().zip(&**rate).for_each(|(sum, rate)| *sum += dt * weight * rate);
        }
        sum
    }
}
