//! One step in time: its stages, and the estimate of its error.

use std::sync::Arc;

use oilwedge_reynolds::quantities::contact_points::ContactPoints;
use oilwedge_reynolds::{CentreVelocity, NoFilm};

use super::motion::{Instant, Motion};
use super::oil::Oil;
use super::stage::{Accuracy, Known, NoStage};
use super::wall::{WallStages, Way};
use crate::coordinates::Vector;
use crate::deflection::{Follower, Joint, contact_points};

/// Accuracy of the linear systems of the damped error.
const FOLLOWED: f64 = 1e-3;

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
    pub(super) before: Option<&'a Way>,
}

impl Motion<'_> {
    /// A step of the length `dt` [s].
    pub(super) fn step(&self, from: &Begin, dt: f64, accuracy: Accuracy, films: &mut usize) -> Result<Made, NoStage> {
        let start = from.instant;
        let scheme = self.scheme();
        let per_time = 1.0 / (scheme.diagonal * dt);
        let mut rates = vec![start.velocity];
        let mut accelerations = vec![from.acceleration];
        let mut oils: Vec<Arc<Oil>> = start.oil.iter().cloned().collect();
        let mut walls = WallStages::from(start);
        let mut latest: Option<Instant> = None;
        let mut way = from.before.cloned();
        for stage in 1..scheme.stages() {
            let so_far =
                |first: Vector, rates: &[Vector]| combined(first, dt, &scheme.coefficients[stage][..stage], rates);
            let time = start.time + dt * scheme.nodes[stage];
            let known = Known {
                time,
                per_time,
                offset: so_far(start.at, &rates),
                rate: so_far(start.velocity, &accelerations),
                before: (start.oil.as_ref()).map(|oil| oil.before(scheme, stage, dt, &oils)),
                wall: (walls.as_ref()).map(|walls| walls.stage((scheme, stage), dt, (way.as_ref(), time))),
            };
            let guess = match &way {
                Some(way) => way.span.at(time),
                None => combined(start.at, dt * scheme.nodes[stage], &[1.0], &rates),
            };
            let is_nearer = |latest: &&Instant| (latest.time - known.time).abs() < (start.time - known.time).abs();
            let near = latest.as_ref().filter(is_nearer).unwrap_or(start);
            let found = self.stage(&known, guess, near, accuracy, films)?;
            rates.push(found.velocity);
            accelerations.push([0, 1, 2, 3].map(|k| (found.velocity[k] - known.rate[k]) * per_time));
            oils.extend(found.oil.clone());
            if let Some(walls) = &mut walls {
                walls.add(&found);
            }
            if latest.as_ref().is_none_or(|latest| latest.time < found.time) {
                way = Some(Way::between(start, &found));
            }
            latest = Some(found);
        }
        // The last stage is the end of the step.
        let end = latest.ok_or(NoStage::Diverged)?;
        let error = combined([0.0; 4], dt, &scheme.error_weights(), &rates);
        let error = match walls {
            Some(walls) => self.damped_with_wall(&end, error, &walls.error(scheme, dt), per_time)?,
            None => self.damped_error(&end, error, dt)?,
        };
        Ok(Made { error, acceleration: accelerations.last().copied().unwrap_or_default(), end })
    }

    /// `(m/(gamma dt) + C + gamma dt K)^-1 (m/(gamma dt) + C)` times an error: what stiffness leaves of it.
    fn damped_error(&self, end: &Instant, error: Vector, dt: f64) -> Result<Vector, NoFilm> {
        let diagonal = self.scheme().diagonal;
        let inertia = self.masses().map(|mass| mass / (diagonal * dt));
        let damping = self.tangent(end, 0.0, 1.0)?.with_diagonal(inertia);
        let with_stiffness = self.tangent(end, diagonal * dt, 1.0)?.with_diagonal(inertia);
        Ok(with_stiffness.solve(damping.times(error)))
    }
}

impl Motion<'_> {
    /// What stiffness of film and wall leaves of an error of the place and of one of the wall, in the place: both push
    /// the film as rates in the stage do.
    pub(super) fn damped_with_wall(
        &self,
        end: &Instant,
        error: Vector,
        of_wall: &[f64],
        per_time: f64,
    ) -> Result<Vector, NoStage> {
        let joint = self.joint(per_time, end, contact_points(&end.film.problem, self.system))?;
        let along = (self.coordinates()).change(&end.film.problem.journal, &CentreVelocity::default(), error);
        let (by_film, bent) = joint.pushed(&along.as_rate(), of_wall)?;
        let masses = self.masses();
        let force = [0, 1, 2, 3].map(|k| per_time * (by_film[k] + masses[k] * per_time * error[k]));
        let bent: Vec<f64> = bent.iter().map(|bent| -per_time * bent).collect();
        Ok(joint.solve(force, Some(&bent))?.place)
    }

    /// The tangent of journal and wall in a stage, by its points of contact; `per_time` is its `1/(gamma dt)` [1/s].
    fn joint<'a>(
        &'a self,
        per_time: f64,
        here: &'a Instant,
        contact: Option<Arc<ContactPoints>>,
    ) -> Result<Joint<'a>, NoStage> {
        let follower = Follower::touching(&here.film, contact)?;
        let follower = follower.ok_or(NoStage::Diverged)?;
        let masses = self.masses();
        let held = [0, 1, 2, 3].map(|k| {
            let support = if k >= 2 { self.support_stiffness() } else { 0.0 };
            support + masses[k] * per_time.powi(2)
        });
        let change = |k: usize| self.change(&here.film.problem.journal, k, [1.0, per_time]);
        Ok(Joint::of(follower, self.coordinates(), change, held, FOLLOWED)?)
    }
}

/// `first + dt sum_j weight_j rate_j`.
fn combined(first: Vector, dt: f64, weights: &[f64], rates: &[Vector]) -> Vector {
    let sum = |k: usize| weights.iter().zip(rates).map(|(weight, rate)| weight * rate[k]).sum::<f64>();
    [0, 1, 2, 3].map(|k| first[k] + dt * sum(k))
}
