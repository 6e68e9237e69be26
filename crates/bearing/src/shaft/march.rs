//! All journals of a shaft over cycles of the crank angle, by the implicit steps of [`crate::orbit`], until they
//! repeat.

use super::NoShaftOrbit;
use super::films::{all_moved, magnitude};
use super::stage::Accuracy;
use super::step::{Drive, Here, Made, SCHEME, ShaftStep, of_stage};
use crate::Deadline;
use crate::coordinates::Vector;
use crate::orbit::pace::Pace;
use crate::orbit::{OrbitEnd, OrbitObserver};

/// A stage is solved where the residual over the greatest load is below this.
const BALANCED: f64 = 1e-9;
/// A tangent is corrected by what it missed, not made anew, where it has reduced the residual to less than this part.
const STEEP: f64 = 0.3;
/// Stages before the last one of a step are solved to this part of the tolerance.
const INNER: f64 = 1e-4;
/// The path between two steps may be off by this multiple of the tolerance.
const PATH: f64 = 2.0;
/// What the first stage is off by goes like this power of the step.
const PATH_POWER: f64 = 3.0;
/// A cycle takes the steps of the last one, so that both make the same errors and close, where they are at most this
/// multiple of what the tolerance suggests.
const KEPT: f64 = 1.25;
/// Steps do not end nearer to each other than this part of the cycle.
const APART: f64 = 1e-9;
/// The motion begins with a step of this part of the cycle.
const BEGINNING: f64 = 1e-7;
/// Loads are sampled at so many crank angles to find their peak.
const SAMPLES: u32 = 720;

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

impl Drive<'_> {
    fn duration(&self) -> f64 {
        self.period / self.speed
    }

    /// How exactly the stages before the last one of a step are solved, and the last one.
    fn accuracy(&self, tolerance: f64) -> [Accuracy; 2] {
        let angle = |k: u32| self.period * f64::from(k) / f64::from(SAMPLES);
        let peak = (0..SAMPLES).map(|k| magnitude(&(self.loads)(angle(k)))).fold(f64::MIN_POSITIVE, f64::max);
        [(INNER * tolerance).max(BALANCED), BALANCED].map(|balanced| Accuracy {
            balanced,
            settled: None,
            scale: peak,
            steep: STEEP,
        })
    }

    /// The journals from the places `start` [m] on.
    ///
    /// # Errors
    /// [`NoShaftOrbit`]: why they cannot be followed.
    pub fn follow(&self, start: &[Vector], options: &MarchOptions) -> Result<ShaftOrbit, NoShaftOrbit> {
        let accuracy = self.accuracy(options.tolerance);
        let mut films = 0;
        let known = self.known(0.0, 1.0 / (BEGINNING * self.duration()), start.to_vec());
        let begun = self.films.stage(&known, start.to_vec(), None, accuracy[1], &mut films);
        let begun = begun.map_err(|reason| self.told(reason, 0.0, 1, start))?;
        let mut here = of_stage(begun, 0.0);
        let (mut cycles, mut last) = (Vec::new(), Vec::new());
        for number in 1..=options.cycles {
            let begin = here.at();
            let Some((steps, mut cycle)) = self.cycle(&mut here, number, accuracy, &last, options)? else {
                return match number {
                    1 => Err(NoShaftOrbit::Ended { angle: (self.speed * here.time).to_degrees() }),
                    _ => Ok(ShaftOrbit { steps: last, cycles, end: OrbitEnd::Ended }),
                };
            };
            cycle.films += std::mem::take(&mut films);
            cycle.closure = self.apart(&begin, &here.at());
            cycles.push(cycle);
            last = steps;
            if cycle.closure < options.closure {
                return Ok(ShaftOrbit { steps: last, cycles, end: OrbitEnd::Closed });
            }
            here.time = 0.0;
            here.before = None;
        }
        Ok(ShaftOrbit { steps: last, cycles, end: OrbitEnd::NotClosed })
    }

    /// The greater error of a step of this length [s] and of its path, over the tolerance, and the length of the next
    /// step [s].
    fn judged(&self, made: &Made, taken: f64, pace: Pace, tolerance: f64) -> (f64, f64) {
        let [at, off] = &made.within;
        let of_step = self.films.change(&made.end.at(), &made.error) / tolerance;
        let of_path = self.films.change(at, off) / (PATH * tolerance);
        let by_path = Pace { error_power: PATH_POWER, ..pace };
        let next = pace.next(taken, of_step).min(by_path.next(taken, of_path));
        (of_step.max(of_path), next)
    }

    /// Greatest distance of a journal in two places, over its clearance.
    fn apart(&self, from: &[Vector], to: &[Vector]) -> f64 {
        let ways = all_moved(to, -1.0, from);
        let films = self.films.films.iter().zip(ways);
        films.map(|(film, way)| magnitude(&[way]) / film.problem.bearing.clearance).fold(0.0, f64::max)
    }

    /// One cycle, by the steps of the last one where they suit; `None` where the deadline came.
    fn cycle(
        &self,
        here: &mut Here,
        number: usize,
        accuracy: [Accuracy; 2],
        last: &[ShaftStep],
        options: &MarchOptions,
    ) -> Result<Option<(Vec<ShaftStep>, ShaftCycle)>, NoShaftOrbit> {
        let period = self.duration();
        let pace = Pace { period, error_power: SCHEME.error_power };
        let mut cycle = ShaftCycle { closure: 0.0, steps: 0, rejected: 0, films: 0 };
        let none = vec![[0.0; 4]; here.instants.len()];
        let mut steps = vec![here.recorded(none)];
        let mut dt = pace.first(1.0, self.films.change(&here.at(), &here.velocity()));
        let mut refused = f64::INFINITY;
        while here.time < period {
            if options.deadline.is_over() {
                return Ok(None);
            }
            let left = period - here.time;
            let again = ended(last, here.time, period).filter(|again| is_kept(*again, dt, refused));
            let taken = again.unwrap_or_else(|| pace.before(left, dt));
            match self.step(here, taken, accuracy, &mut cycle.films) {
                Ok(made) => {
                    let part;
                    (part, dt) = self.judged(&made, taken, pace, options.tolerance);
                    let Made { mut end, error, .. } = made;
                    if part > 1.0 && !pace.is_shortest(taken) {
                        refused = taken;
                        cycle.rejected += 1;
                        continue;
                    }
                    refused = f64::INFINITY;
                    if taken == left {
                        end.time = period;
                    }
                    steps.push(end.recorded(error));
                    *here = end;
                    cycle.steps += 1;
                    if let Some(observer) = options.observer {
                        let turn = (self.speed * period).to_degrees();
                        observer.step(number, turn * here.time / period, turn);
                    }
                }
                Err(reason) => {
                    refused = taken;
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
}

/// How long it is [s] from a time until the next step of the last cycle ended; `None` where there was no cycle.
fn ended(last: &[ShaftStep], time: f64, period: f64) -> Option<f64> {
    let next = last.iter().find(|step| step.time > time + APART * period)?;
    Some(next.time - time)
}

/// Whether a step takes the length `again` [s] of one of the last cycle, where the tolerance suggests `dt` [s] and one
/// of the length `refused` [s] has just been rejected.
fn is_kept(again: f64, dt: f64, refused: f64) -> bool {
    again <= KEPT * dt && again < refused
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_step_of_the_last_cycle_is_taken_where_it_suits_but_not_again_after_it_was_rejected() {
        assert!(is_kept(1.0, 0.9, f64::INFINITY));
        assert!(!is_kept(1.0, 0.7, f64::INFINITY));
        // What a step rejected by little suggests is hardly shorter: the same step would be rejected for ever.
        assert!(!is_kept(1.0, 0.9, 1.0));
        assert!(is_kept(0.3, 0.9, 1.0));
    }
}
