//! Oil that a film holds along an orbit, where its cavity conserves it.
//!
//! The oil `V theta` of each cell is integrated by the method of the journal's path: a stage leaves
//! `m = V_n theta_n + dt sum_{j<i} a_ij (V theta)_j'` to the cell, and the film of the stage takes up
//! `(V theta - m)/(gamma dt)` ([`Storage`]). The same sum of what enters the film is what it has received, to rounding
//! what it holds more.

use std::sync::Arc;

use oilwedge_fem::Error;
use oilwedge_reynolds::{SolvedFilm, Storage};

use super::scheme::Scheme;

/// What the stages before leave to a stage.
#[derive(Debug, Clone, PartialEq)]
pub struct Before {
    /// What they leave to the cells.
    pub storage: Arc<Storage>,
    /// What the film has received in them [m3].
    pub received: f64,
    /// What has come in through places of given pressure in them, whatever left by others [m3].
    pub passed: f64,
}

impl Before {
    /// A stage of the length of `1/per_time` [s] after a time in which the cells held `known` [m3].
    pub fn at_rest(per_time: f64, known: Vec<f64>) -> Self {
        Self { storage: Arc::new(Storage { per_time, known }), received: 0.0, passed: 0.0 }
    }

    /// The oil of the stage, whose film is solved.
    ///
    /// # Errors
    /// The sub-mesh does not fit in memory.
    pub fn oil(&self, film: &SolvedFilm) -> Result<StoredOil, Error> {
        let held = film.oil_held()?.unwrap_or_default();
        let inflow: f64 = film.solution.inflow.iter().sum();
        let given = film.solution.inflow.iter().enumerate().filter(|(dof, _)| film.system.supply.owner(*dof).is_some());
        let entering: f64 = given.map(|(_, inflow)| inflow.max(0.0)).sum();
        let time = 1.0 / self.storage.per_time;
        Ok(StoredOil {
            rate: self.storage.taken_up(&held),
            held,
            received: self.received + time * inflow,
            inflow,
            passed: self.passed + time * entering,
            entering,
        })
    }
}

/// Oil of a film.
#[derive(Debug, Clone, PartialEq)]
pub struct StoredOil {
    /// What the cell of each dof holds [m3].
    pub held: Vec<f64>,
    /// What it takes up [m3/s].
    pub rate: Vec<f64>,
    /// What the film has received on balance since the beginning [m3].
    pub received: f64,
    /// What enters it on balance [m3/s].
    pub inflow: f64,
    /// What has come in through places of given pressure since the beginning, whatever left by others [m3].
    pub passed: f64,
    /// What comes in there [m3/s].
    pub entering: f64,
}

impl StoredOil {
    /// What stage number `stage` of a step of the length `dt` [s] from here begins with, after these `stages`, of which
    /// the first is this one.
    pub fn before(&self, scheme: &Scheme, stage: usize, dt: f64, stages: &[Arc<Self>]) -> Before {
        let mut known = self.held.clone();
        let (mut received, mut passed) = (self.received, self.passed);
        for (a, oil) in scheme.coefficients[stage][..stage].iter().zip(stages) {
            let weight = dt * a;
            known.iter_mut().zip(&oil.rate).for_each(|(known, rate)| *known += weight * rate);
            received += weight * oil.inflow;
            passed += weight * oil.entering;
        }
        let per_time = 1.0 / (scheme.diagonal * dt);
        Before { storage: Arc::new(Storage { per_time, known }), received, passed }
    }

    /// What a stage of the length of `1/per_time` [s] begins with after a time in which films kept this.
    pub(super) fn at_rest(&self, per_time: f64) -> Before {
        let storage = Arc::new(Storage { per_time, known: self.held.clone() });
        Before { storage, received: self.received, passed: self.passed }
    }

    /// All oil [m3].
    pub fn total(&self) -> f64 {
        self.held.iter().sum()
    }

    /// Oil that lies elsewhere than in another film, over all oil [1].
    pub fn differs(&self, other: &Self) -> f64 {
        let apart: f64 = self.held.iter().zip(&other.held).map(|(a, b)| (a - b).abs()).sum();
        apart / self.total().max(f64::MIN_POSITIVE)
    }
}
