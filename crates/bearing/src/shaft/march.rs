//! All journals of a shaft over cycles of the crank angle, by the implicit steps of [`crate::orbit`], until they repeat.

use super::NoShaftOrbit;
use super::films::{Films, Train, all_moved, magnitude};
use super::stage::{Accuracy, Known, NoStage, Staged};
use crate::Deadline;
use crate::coordinates::Vector;
use crate::orbit::pace::Pace;
use crate::orbit::scheme::{FOURTH_ORDER, Scheme};
use crate::orbit::{Instant, OrbitEnd, OrbitObserver, Span};

/// The films of a shaft have no memory.
const SCHEME: Scheme = FOURTH_ORDER;
/// A stage is solved where the residual over the greatest load is below this.
const BALANCED: f64 = 1e-9;
/// The guess of a stage leaves this part of each least gap.
const LEAST_SHRINK: f64 = 0.4;
/// The motion begins with a step of this part of the cycle.
const BEGINNING: f64 = 1e-7;
/// Loads are sampled at so many crank angles to find their peak.
const SAMPLES: u32 = 720;

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

/// How the journals are followed.
#[derive(Debug, Clone, Copy)]
pub struct MarchOptions<'a> {
    /// Local error of a step [1]: offset over the least gap of the journal.
    pub tolerance: f64,
    /// The journals repeat where two cycles end within this part of the clearance.
    pub closure: f64,
    /// Most cycles.
    pub cycles: usize,
    /// When it must end.
    pub deadline: Deadline,
    /// Notified of each step.
    pub observer: Option<&'a dyn OrbitObserver>,
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

/// One cycle of a shaft.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShaftCycle {
    /// Greatest distance between the places in which a journal begins and ends, over its clearance [1].
    pub closure: f64,
    /// Steps made.
    pub steps: usize,
    /// Steps tried with an error beyond the tolerance, or without a solution.
    pub rejected: usize,
    /// Films solved, of all bearings.
    pub films: usize,
}

/// The journals of a shaft over a cycle.
#[derive(Debug, Clone, PartialEq)]
pub struct ShaftOrbit {
    /// Steps of the last complete cycle; the first entry is its beginning.
    pub steps: Vec<ShaftStep>,
    /// The cycles, the last one being that of the steps.
    pub cycles: Vec<ShaftCycle>,
    /// How it ended.
    pub end: OrbitEnd,
}

/// Where a march is.
struct Here {
    instants: Vec<Instant>,
    time: f64,
    residual: f64,
    /// The paths of the step before; none at the beginning.
    before: Option<Vec<Span>>,
}

/// A step that was made.
struct Made {
    end: Here,
    error: Vec<Vector>,
}

impl Here {
    fn at(&self) -> Vec<Vector> {
        self.instants.iter().map(|here| here.at).collect()
    }

    fn velocity(&self) -> Vec<Vector> {
        self.instants.iter().map(|here| here.velocity).collect()
    }

    fn recorded(&self, error: Vec<Vector>) -> ShaftStep {
        ShaftStep {
            time: self.time,
            train: Train {
                at: self.at(),
                velocity: self.velocity(),
            },
            carried: self.instants.iter().map(|here| here.excess).collect(),
            error,
            residual: self.residual,
        }
    }
}

impl Drive<'_> {
    fn duration(&self) -> f64 {
        self.period / self.speed
    }

    fn accuracy(&self) -> Accuracy {
        let angle = |k: u32| self.period * f64::from(k) / f64::from(SAMPLES);
        let peak = (0..SAMPLES)
            .map(|k| magnitude(&(self.loads)(angle(k))))
            .fold(f64::MIN_POSITIVE, f64::max);
        Accuracy {
            balanced: BALANCED,
            settled: None,
            scale: peak,
        }
    }

    fn known(&self, time: f64, per_time: f64, offset: Vec<Vector>) -> Known {
        let angle = self.speed * time;
        Known {
            time,
            angle,
            per_time,
            offset,
            asked: (self.loads)(angle),
            shift: 0.0,
        }
    }

    /// The journals from the places `start` [m] on.
    ///
    /// # Errors
    /// [`NoShaftOrbit`]: why they cannot be followed.
    pub fn follow(&self, start: &[Vector], options: &MarchOptions) -> Result<ShaftOrbit, NoShaftOrbit> {
        let accuracy = self.accuracy();
        let mut films = 0;
        let known = self.known(0.0, 1.0 / (BEGINNING * self.duration()), start.to_vec());
        let begun = self.films.stage(&known, start.to_vec(), None, accuracy, &mut films);
        let begun = begun.map_err(|reason| self.told(reason, 0.0, 1, start))?;
        let mut here = of_stage(begun, 0.0);
        let (mut cycles, mut last) = (Vec::new(), Vec::new());
        for number in 1..=options.cycles {
            let begin = here.at();
            let Some((steps, mut cycle)) = self.cycle(&mut here, number, accuracy, options)? else {
                return match number {
                    1 => Err(NoShaftOrbit::Ended {
                        angle: (self.speed * here.time).to_degrees(),
                    }),
                    _ => Ok(ShaftOrbit {
                        steps: last,
                        cycles,
                        end: OrbitEnd::Ended,
                    }),
                };
            };
            cycle.films += std::mem::take(&mut films);
            cycle.closure = self.apart(&begin, &here.at());
            cycles.push(cycle);
            last = steps;
            if cycle.closure < options.closure {
                return Ok(ShaftOrbit {
                    steps: last,
                    cycles,
                    end: OrbitEnd::Closed,
                });
            }
            here.time = 0.0;
            here.before = None;
        }
        Ok(ShaftOrbit {
            steps: last,
            cycles,
            end: OrbitEnd::NotClosed,
        })
    }

    /// Greatest distance of a journal in two places, over its clearance.
    fn apart(&self, from: &[Vector], to: &[Vector]) -> f64 {
        let ways = all_moved(to, -1.0, from);
        let films = self.films.films.iter().zip(ways);
        films
            .map(|(film, way)| magnitude(&[way]) / film.problem.bearing.clearance)
            .fold(0.0, f64::max)
    }

    /// One cycle; `None` where the deadline came.
    fn cycle(
        &self,
        here: &mut Here,
        number: usize,
        accuracy: Accuracy,
        options: &MarchOptions,
    ) -> Result<Option<(Vec<ShaftStep>, ShaftCycle)>, NoShaftOrbit> {
        let period = self.duration();
        let pace = Pace {
            period,
            error_power: SCHEME.error_power,
        };
        let mut cycle = ShaftCycle {
            closure: 0.0,
            steps: 0,
            rejected: 0,
            films: 0,
        };
        let none = vec![[0.0; 4]; here.instants.len()];
        let mut steps = vec![here.recorded(none)];
        let mut dt = pace.first(1.0, self.films.change(&here.at(), &here.velocity()));
        while here.time < period {
            if options.deadline.is_over() {
                return Ok(None);
            }
            let left = period - here.time;
            let taken = pace.before(left, dt);
            match self.step(here, taken, accuracy, &mut cycle.films) {
                Ok(Made { mut end, error }) => {
                    let part = self.films.change(&end.at(), &error) / options.tolerance;
                    dt = pace.next(taken, part);
                    if part > 1.0 && !pace.is_shortest(taken) {
                        cycle.rejected += 1;
                        continue;
                    }
                    if taken == left {
                        end.time = period;
                    }
                    steps.push(end.recorded(error));
                    *here = end;
                    cycle.steps += 1;
                    if let Some(observer) = options.observer {
                        observer.step(number, here.time / period);
                    }
                }
                Err(reason) => {
                    cycle.rejected += 1;
                    dt = pace.retried(taken);
                    if pace.is_shortest(dt) {
                        return Err(self.told(reason, here.time, number, &here.at()));
                    }
                }
            }
        }
        Ok(Some((steps, cycle)))
    }

    /// A step of the length `dt` [s].
    fn step(&self, from: &Here, dt: f64, accuracy: Accuracy, films: &mut usize) -> Result<Made, NoStage> {
        let (start, first) = (from.at(), from.velocity());
        let per_time = 1.0 / (SCHEME.diagonal * dt);
        let mut rates = vec![first];
        let mut latest: Option<Staged> = None;
        let (mut way, mut farthest) = (from.before.clone(), from.time);
        for stage in 1..SCHEME.stages() {
            let time = from.time + dt * SCHEME.nodes[stage];
            let offset = combined(&start, dt, &SCHEME.coefficients[stage][..stage], &rates);
            let known = self.known(time, per_time, offset.clone());
            let guess: Vec<Vector> = match &way {
                Some(paths) => paths.iter().map(|path| path.at(time)).collect(),
                None => all_moved(&start, time - from.time, &rates[0]),
            };
            let near = latest.as_ref().map_or(&from.instants, |latest| &latest.instants);
            let at: Vec<Vector> = near.iter().map(|here| here.at).collect();
            let towards = all_moved(&guess, -1.0, &at);
            let begin = all_moved(&at, self.films.inside(&at, &towards, LEAST_SHRINK), &towards);
            let found = self.films.stage(&known, begin, Some(near), accuracy, films)?;
            rates.push(found.instants.iter().map(|here| here.velocity).collect());
            if time > farthest {
                way = Some(paths((&from.instants, from.time), (&found.instants, time)));
                farthest = time;
            }
            latest = Some(found);
        }
        // The last stage is the end of the step.
        let Some(end) = latest else {
            return Err(NoStage::Diverged(f64::INFINITY, start));
        };
        let end = Here {
            before: way,
            ..of_stage(end, from.time + dt)
        };
        let none = vec![[0.0; 4]; start.len()];
        let error = combined(&none, dt, &SCHEME.error_weights(), &rates);
        Ok(Made {
            error: self.damped(&end, &error, dt)?,
            end,
        })
    }

    /// `(C + gamma dt K)^-1 C` times an error, of shaft and films: what stiffness leaves of it.
    fn damped(&self, end: &Here, error: &[Vector], dt: f64) -> Result<Vec<Vector>, NoStage> {
        let angle = self.speed * end.time;
        let damping = self.films.tangent(&end.instants, (0.0, 1.0), angle)?;
        let both = self.films.tangent(&end.instants, (SCHEME.diagonal * dt, 1.0), angle)?;
        let forces = damping.times(&self.films.shaft.gathered(error));
        let left = both.factors().map(|factors| factors.solve(&forces));
        Ok(left.map_or_else(|| error.to_vec(), |left| self.films.shaft.spread(&left)))
    }
}

fn of_stage(staged: Staged, time: f64) -> Here {
    Here {
        instants: staged.instants,
        time,
        residual: staged.residual,
        before: None,
    }
}

/// The paths of journals from one time to another.
fn paths(from: (&[Instant], f64), to: (&[Instant], f64)) -> Vec<Span> {
    let pairs = from.0.iter().zip(to.0);
    pairs
        .map(|(a, b)| Span {
            times: [from.1, to.1],
            places: [a.at, b.at],
            rates: [a.velocity, b.velocity],
        })
        .collect()
}

/// `first + dt sum_j weight_j rate_j`.
fn combined(first: &[Vector], dt: f64, weights: &[f64], rates: &[Vec<Vector>]) -> Vec<Vector> {
    let sum = first.to_vec();
    (weights.iter().zip(rates)).fold(sum, |sum, (weight, rate)| all_moved(&sum, dt * weight, rate))
}
