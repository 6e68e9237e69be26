//! One step in time of all journals of a shaft: its stages, and the estimates of its error.

use super::films::{Films, Train, all_moved};
use super::stage::{Accuracy, Known, NoStage, Staged};
use crate::coordinates::Vector;
use crate::orbit::scheme::{FOURTH_ORDER, Scheme};
use crate::orbit::{Instant, Span};
use crate::stiffness::Stiffness;

/// The films of a shaft have no memory.
pub(super) const SCHEME: Scheme = FOURTH_ORDER;
/// The guess of a stage leaves this part of each least gap.
const LEAST_SHRINK: f64 = 0.4;

/// What drives a shaft over a cycle.
pub struct Drive<'a> {
    /// The shaft and its films.
    pub films: &'a Films<'a>,
    /// Loads as forces on the journals [N] at a crank angle [rad].
    pub loads: &'a (dyn Fn(f64) -> Vec<Vector> + Sync),
    /// Period of the crank angle [rad].
    pub period: f64,
    /// Angular speed of the crank [rad/s].
    pub speed: f64,
}

/// All journals at the end of a step.
#[derive(Debug, Clone, PartialEq)]
pub struct ShaftStep {
    /// Time [s], from the beginning of the cycle.
    pub time: f64,
    /// The journals.
    pub train: Train,
    /// Forces of their films [N].
    pub carried: Vec<Vector>,
    /// Estimate of the error that the step has made [m].
    pub error: Vec<Vector>,
    /// What is left of the balance of the shaft, over its greatest load [1].
    pub residual: f64,
}

/// Where a march is.
pub(super) struct Here {
    pub(super) instants: Vec<Instant>,
    pub(super) time: f64,
    pub(super) residual: f64,
    /// The paths of the step before; none at the beginning.
    pub(super) before: Option<Vec<Span>>,
    /// How the force of each film changes with its offset, and with the rate of that; none at the beginning.
    pub(super) slopes: Option<[Vec<Stiffness>; 2]>,
}

/// A step that was made.
pub(super) struct Made {
    pub(super) end: Here,
    pub(super) error: Vec<Vector>,
    /// Place of a stage within the step [m], and how far it is from the path [m].
    pub(super) within: [Vec<Vector>; 2],
}

impl Here {
    pub(super) fn at(&self) -> Vec<Vector> {
        places(&self.instants)
    }

    pub(super) fn velocity(&self) -> Vec<Vector> {
        self.instants.iter().map(|here| here.velocity).collect()
    }

    pub(super) fn recorded(&self, error: Vec<Vector>) -> ShaftStep {
        ShaftStep {
            time: self.time,
            train: Train { at: self.at(), velocity: self.velocity() },
            carried: self.instants.iter().map(|here| here.excess).collect(),
            error,
            residual: self.residual,
        }
    }
}

/// What the stages of a step have found.
struct Stages {
    /// Rates at the beginning and of each stage [m/s].
    rates: Vec<Vec<Vector>>,
    /// Time [s] and places [m] of the first one.
    first: Option<(f64, Vec<Vector>)>,
    latest: Option<Staged>,
    /// The paths from the beginning to the farthest one, or those of the step before.
    way: Option<Vec<Span>>,
    farthest: f64,
}

impl Drive<'_> {
    pub(super) fn known(&self, time: f64, per_time: f64, offset: Vec<Vector>) -> Known {
        let angle = self.speed * time;
        Known { time, angle, per_time, offset, asked: (self.loads)(angle), shift: 0.0, slopes: None }
    }

    /// A step of the length `dt` [s]; the last stage is solved to the second accuracy, those before to the first one.
    pub(super) fn step(
        &self,
        from: &Here,
        dt: f64,
        [inner, last]: [Accuracy; 2],
        films: &mut usize,
    ) -> Result<Made, NoStage> {
        let start = from.at();
        let per_time = 1.0 / (SCHEME.diagonal * dt);
        let mut stages = Stages {
            rates: vec![from.velocity()],
            first: None,
            latest: None,
            way: from.before.clone(),
            farthest: from.time,
        };
        let from_step = |[by_offset, by_rate]: &[Vec<Stiffness>; 2]| sum(by_offset, per_time, by_rate);
        let mut slopes = from.slopes.as_ref().map(from_step);
        for stage in 1..SCHEME.stages() {
            let time = from.time + dt * SCHEME.nodes[stage];
            let offset = combined(&start, dt, &SCHEME.coefficients[stage][..stage], &stages.rates);
            let known = Known { slopes: slopes.take(), ..self.known(time, per_time, offset) };
            let near = stages.latest.as_ref().map_or(&from.instants, |latest| &latest.instants);
            let begin = self.begin(near, &stages.guess(&start, time - from.time, time));
            let accuracy = if stage + 1 == SCHEME.stages() { last } else { inner };
            let mut found = self.films.stage(&known, begin, Some(near), accuracy, films)?;
            slopes = found.slopes.take();
            stages.add(from, found, time);
        }
        self.made(from, dt, stages)
    }

    /// A guess of the places, or places on the way to it from films nearby that leave enough of each gap.
    fn begin(&self, near: &[Instant], guess: &[Vector]) -> Vec<Vector> {
        let at = places(near);
        let towards = all_moved(guess, -1.0, &at);
        all_moved(&at, self.films.inside(&at, &towards, LEAST_SHRINK), &towards)
    }

    /// The step of its stages, with the estimates of its error.
    fn made(&self, from: &Here, dt: f64, stages: Stages) -> Result<Made, NoStage> {
        // The last stage is the end of the step.
        let (Some(end), Some((time, at))) = (stages.latest, stages.first) else {
            return Err(NoStage::Diverged(f64::INFINITY, from.at()));
        };
        let path = paths((&from.instants, from.time), (&end.instants, from.time + dt));
        let passed: Vec<Vector> = path.iter().map(|path| path.at(time)).collect();
        let slopes = [self.films.slopes(&end.instants, (1.0, 0.0))?, self.films.slopes(&end.instants, (0.0, 1.0))?];
        let none = vec![[0.0; 4]; at.len()];
        let error = combined(&none, dt, &SCHEME.error_weights(), &stages.rates);
        let angle = self.speed * (from.time + dt);
        Ok(Made {
            error: self.damped(&slopes, &error, dt, angle),
            within: [at.clone(), all_moved(&passed, -1.0, &at)],
            end: Here { before: stages.way, slopes: Some(slopes), ..of_stage(end, from.time + dt) },
        })
    }

    /// `(C + gamma dt K)^-1 C` times an error, of shaft and films: what stiffness leaves of it.
    fn damped(&self, [by_offset, by_rate]: &[Vec<Stiffness>; 2], error: &[Vector], dt: f64, angle: f64) -> Vec<Vector> {
        let gamma = SCHEME.diagonal * dt;
        let damping = self.films.tangent(by_rate, 0.0, angle);
        let both = self.films.tangent(&sum(by_rate, gamma, by_offset), gamma, angle);
        let forces = damping.times(&self.films.shaft.gathered(error));
        let left = both.factors().map(|factors| factors.solve(&forces));
        left.map_or_else(|| error.to_vec(), |left| self.films.shaft.spread(&left))
    }
}

impl Stages {
    /// Where the journals may be at a time [s], so long after the beginning at these places.
    fn guess(&self, start: &[Vector], after: f64, time: f64) -> Vec<Vector> {
        match &self.way {
            Some(paths) => paths.iter().map(|path| path.at(time)).collect(),
            None => all_moved(start, after, &self.rates[0]),
        }
    }

    fn add(&mut self, from: &Here, found: Staged, time: f64) {
        self.first.get_or_insert_with(|| (time, places(&found.instants)));
        self.rates.push(found.instants.iter().map(|here| here.velocity).collect());
        if time > self.farthest {
            self.way = Some(paths((&from.instants, from.time), (&found.instants, time)));
            self.farthest = time;
        }
        self.latest = Some(found);
    }
}

fn places(instants: &[Instant]) -> Vec<Vector> {
    instants.iter().map(|here| here.at).collect()
}

/// `a + factor b`, film by film.
fn sum(a: &[Stiffness], factor: f64, b: &[Stiffness]) -> Vec<Stiffness> {
    a.iter().zip(b).map(|(a, b)| a.plus(factor, b)).collect()
}

pub(super) fn of_stage(staged: Staged, time: f64) -> Here {
    Here { instants: staged.instants, time, residual: staged.residual, before: None, slopes: None }
}

/// The paths of journals from one time to another.
fn paths(from: (&[Instant], f64), to: (&[Instant], f64)) -> Vec<Span> {
    let pairs = from.0.iter().zip(to.0);
    pairs.map(|(a, b)| Span { times: [from.1, to.1], places: [a.at, b.at], rates: [a.velocity, b.velocity] }).collect()
}

/// `first + dt sum_j weight_j rate_j`.
fn combined(first: &[Vector], dt: f64, weights: &[f64], rates: &[Vec<Vector>]) -> Vec<Vector> {
    let sum = first.to_vec();
    (weights.iter().zip(rates)).fold(sum, |sum, (weight, rate)| all_moved(&sum, dt * weight, rate))
}
