//! The wall along an orbit: its deflection is integrated by the method of the journal's path.
//!
//! A stage knows `d_0 = d_n + dt sum_{j<i} a_ij d_j'` and moves by `d' = (d - d_0)/(gamma dt)` ([`WallStage`]); the deflection closes with the film of the stage, whose thickness
//! changes by d' too. Where the film conserves its oil, the oil is what is integrated, and the deflection has no rate of its own.

use std::sync::Arc;

use oilwedge_reynolds::film_thickness::WallStage;

use super::motion::Instant;
use super::scheme::Scheme;

/// The wall in the stages of one step.
pub(super) struct WallStages {
    /// Coefficients where the step begins [m].
    begin: Arc<[f64]>,
    /// Those of the rates of the stages [m/s], the first one being that of the beginning.
    rates: Vec<Arc<[f64]>>,
}

impl WallStages {
    /// Of a step from an instant; none where the wall is rigid or follows the oil.
    pub(super) fn from(start: &Instant) -> Option<Self> {
        let deflection = start.problem.deflection().filter(|_| start.oil.is_none())?;
        let at_rest = || vec![0.0; deflection.coefficients.len()].into();
        Some(Self {
            begin: deflection.coefficients.clone(),
            rates: vec![deflection.rate().cloned().unwrap_or_else(at_rest)],
        })
    }

    /// What stage number `stage` of a step of the length `dt` [s] knows.
    pub(super) fn stage(&self, scheme: &Scheme, stage: usize, dt: f64) -> WallStage {
        let known = self.combined(&self.begin, dt, &scheme.coefficients[stage][..stage]);
        WallStage {
            per_time: 1.0 / (scheme.diagonal * dt),
            known: known.into(),
        }
    }

    /// A stage that was found.
    pub(super) fn add(&mut self, found: &Instant) {
        let rate = found.problem.deflection().and_then(|deflection| deflection.rate());
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
            sum.iter_mut()
                .zip(&**rate)
                .for_each(|(sum, rate)| *sum += dt * weight * rate);
        }
        sum
    }
}
