//! Steps of the length that the tolerance allows, from cycle to cycle, until the orbit closes.

use oilwedge_reynolds::NoFilm;
use oilwedge_reynolds::solve::Neighbour;

use super::motion::{Held, Instant, Motion, Moving};
use super::no_orbit::NoOrbit;
use super::oil::Oil;
use super::pace::Pace;
use super::path::{Between, Span, Step};
use super::stage::{Accuracy, NoStage};
use super::step::{Begin, Made};
use super::wall::Way;
use crate::Deadline;
use crate::coordinates::{Vector, length, moved};

/// Loads are sampled at so many times to find their peak.
const SAMPLES: u32 = 1440;

/// From this cycle on the steps of the cycle before are repeated: what both differ by is then the path, not what other
/// steps make of it.
const REPEATED: usize = 3;

/// How an orbit is sought.
#[derive(Debug, Clone, Copy)]
pub struct OrbitOptions<'a> {
    /// Local error of a step [1]: offset over the least gap, which is the error of the logarithm of the least film.
    pub tolerance: f64,
    /// An orbit is closed where two cycles end within this part of the clearance.
    pub closure: f64,
    /// Most cycles.
    pub cycles: usize,
    /// When it must end.
    pub deadline: Deadline,
    /// Notified of each step.
    pub observer: Option<&'a dyn OrbitObserver>,
}

/// Is notified of the progress of an orbit.
pub trait OrbitObserver: std::fmt::Debug + Sync {
    /// The cycle `number`, from 1, has got to this crank angle of its period [deg].
    fn step(&self, number: usize, angle: f64, period: f64);
}

/// One cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cycle {
    /// Distance between the places in which it begins and ends, or by which the wall moves further, if that is more
    /// [m].
    pub closure: f64,
    /// Steps made.
    pub steps: usize,
    /// Steps tried with an error beyond the tolerance, or without a solution.
    pub rejected: usize,
    /// Films solved.
    pub films: usize,
    /// The oil of films that conserve it; `None` for others.
    pub oil: Option<CycleOil>,
}

/// Oil over one cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CycleOil {
    /// Oil that lies elsewhere at the end than at the beginning, over all oil in the film [1].
    pub closure: f64,
    /// What the film holds more at the end, less what it has received: over what has come in or, where that is more,
    /// what it holds [1].
    pub imbalance: f64,
}

impl CycleOil {
    fn between(begin: &Oil, end: &Oil) -> Self {
        let missing = end.total() - begin.total() - (end.received - begin.received);
        Self { closure: end.differs(begin), imbalance: missing.abs() / (end.passed - begin.passed).max(end.total()) }
    }
}

impl Cycle {
    /// True if it ends as it began, within this part of the clearance and of the oil.
    fn is_closed(&self, clearance: f64, within: f64) -> bool {
        self.closure < within * clearance && self.oil.is_none_or(|oil| oil.closure < within)
    }
}

/// An orbit.
#[derive(Debug, Clone, PartialEq)]
pub struct Orbit {
    /// Steps of the last complete cycle; the first entry is its beginning.
    pub steps: Vec<Step>,
    /// The cycles, the last one being that of the steps.
    pub cycles: Vec<Cycle>,
    /// How it ended.
    pub end: OrbitEnd,
}

/// How an orbit ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OrbitEnd {
    /// Its last two cycles agree.
    Closed,
    /// They do not, and no more cycles were asked for.
    NotClosed,
    /// It was ended before.
    Ended,
}

/// Where an orbit is.
struct Traveller {
    here: Instant,
    acceleration: Vector,
    before: Option<Way>,
}

impl Motion<'_> {
    /// The orbit from the place `start` [m] on.
    ///
    /// # Errors
    /// [`NoOrbit`]: why there is none.
    pub fn orbit(&self, start: Vector, options: &OrbitOptions) -> Result<Orbit, NoOrbit> {
        let accuracy = Accuracy { tolerance: options.tolerance, scale: self.peak_load() };
        let mut films = 0;
        let period = self.cycle.period() / self.cycle.angular_speed();
        let here = (self.beginning(start, period, accuracy, &mut films))
            .map_err(|reason| self.told(reason, 0.0, 1, self.least_gap(start)))?;
        let mut traveller = Traveller { here, acceleration: [0.0; 4], before: None };
        let mut cycles = Vec::new();
        let mut last = Vec::new();
        for number in 1..=options.cycles {
            let (begin, velocity, oil) = (traveller.here.at, traveller.here.velocity, traveller.here.oil.clone());
            let wall = traveller.here.film.problem.deflection().cloned();
            let stops = if number < REPEATED { &[] } else { &last[..] };
            let (steps, mut cycle) = match self.cycle(&mut traveller, (number, stops), accuracy, options) {
                Ok(Some(made)) => made,
                Ok(None) if number == 1 => {
                    let angle = (self.cycle.angular_speed() * traveller.here.time).to_degrees();
                    return Err(NoOrbit::Ended { angle });
                }
                Ok(None) => {
                    let end = OrbitEnd::Ended;
                    return Ok(Orbit { steps: last, cycles, end });
                }
                Err(reason) => return Err(reason),
            };
            cycle.films += std::mem::take(&mut films);
            let by_wall = wall.zip(traveller.here.film.problem.deflection());
            let by_wall = by_wall.map_or(0.0, |(begin, end)| begin.distance(end));
            let by_place = length(moved(traveller.here.at, -1.0, begin));
            cycle.closure = by_place.max(by_wall).max(self.closure_of_velocity(velocity, traveller.here.velocity));
            cycle.oil = oil.zip(traveller.here.oil.as_ref()).map(|(begin, end)| CycleOil::between(&begin, end));
            cycles.push(cycle);
            last = steps;
            if cycle.is_closed(self.problem.bearing.clearance, options.closure) {
                let end = OrbitEnd::Closed;
                return Ok(Orbit { steps: last, cycles, end });
            }
            traveller.here.time = 0.0;
            traveller.before = None;
        }
        Ok(Orbit { steps: last, cycles, end: OrbitEnd::NotClosed })
    }

    /// By how much a rotor with mass would be off after the crank has turned by one radian with the difference of two
    /// velocities [m]; a journal without mass moves as its place asks.
    fn closure_of_velocity(&self, begin: Vector, end: Vector) -> f64 {
        let masses = self.masses();
        let moves = [0, 1, 2, 3].map(|k| if masses[k] > 0.0 { end[k] - begin[k] } else { 0.0 });
        length(moves) / self.cycle.angular_speed()
    }

    /// One cycle, whose steps meet the times of these stops; `None` where the deadline came.
    fn cycle(
        &self,
        traveller: &mut Traveller,
        (number, stops): (usize, &[Step]),
        accuracy: Accuracy,
        options: &OrbitOptions,
    ) -> Result<Option<(Vec<Step>, Cycle)>, NoOrbit> {
        let period = self.cycle.period() / self.cycle.angular_speed();
        let mut cycle = Cycle { closure: 0.0, steps: 0, rejected: 0, films: 0, oil: None };
        let mut steps = vec![self.recorded(traveller, [0.0; 4], accuracy)];
        let pace = Pace { period, error_power: self.scheme().error_power };
        let here = &traveller.here;
        let first = pace.first(self.least_gap_under(here.wall(), here.at), length(here.velocity));
        let mut dt = if stops.is_empty() { first } else { f64::INFINITY };
        while traveller.here.time < period {
            if options.deadline.is_over() {
                return Ok(None);
            }
            let now = traveller.here.time;
            let stop = stops.iter().map(|step| step.time).find(|time| *time > now).unwrap_or(period);
            let left = stop - now;
            let taken = pace.before(left, dt);
            let begin = Begin {
                instant: &traveller.here,
                acceleration: traveller.acceleration,
                before: traveller.before.as_ref(),
            };
            match self.step(&begin, taken, accuracy, &mut cycle.films) {
                Ok(Made { mut end, acceleration, error }) => {
                    let part = length(error) / self.least_gap_under(end.wall(), end.at) / accuracy.tolerance;
                    dt = pace.next(taken, part);
                    if part > 1.0 && !pace.is_shortest(taken) {
                        cycle.rejected += 1;
                        continue;
                    }
                    if taken == left {
                        end.time = stop;
                        dt = if stops.is_empty() { dt } else { f64::INFINITY };
                    }
                    let way = Way::between(&traveller.here, &end);
                    *traveller = Traveller { here: end, acceleration, before: Some(way) };
                    steps.push(self.recorded(traveller, error, accuracy));
                    cycle.steps += 1;
                    if let Some(observer) = options.observer {
                        let turn = self.cycle.period().to_degrees();
                        observer.step(number, turn * traveller.here.time / period, turn);
                    }
                }
                Err(reason) => {
                    cycle.rejected += 1;
                    dt = pace.retried(taken);
                    if pace.is_shortest(dt) {
                        let gap = self.least_gap_under(traveller.here.wall(), traveller.here.at);
                        return Err(self.told(reason, now, number, gap));
                    }
                }
            }
        }
        Ok(Some((steps, cycle)))
    }

    fn recorded(&self, traveller: &Traveller, error: Vector, accuracy: Accuracy) -> Step {
        let (here, masses) = (&traveller.here, self.masses());
        let left: Vector = [0, 1, 2, 3].map(|k| here.excess[k] + masses[k] * traveller.acceleration[k]);
        Step { error, ..Step::of(here, length(left) / accuracy.scale) }
    }

    /// Greatest load over the cycle [N]; where there is none, that of drag.
    pub fn peak_load(&self) -> f64 {
        let period = self.cycle.period() / self.cycle.angular_speed();
        let sampled = (0..SAMPLES).map(|k| length(self.asked(period * f64::from(k) / f64::from(SAMPLES))));
        match sampled.fold(0.0, f64::max) {
            0.0 => self.drag(),
            peak => peak,
        }
    }

    /// Load that drag through the clearance could carry [N].
    fn drag(&self) -> f64 {
        let bearing = &self.problem.bearing;
        let speed = self.duty(0.0).speed.abs().max(self.cycle.angular_speed().abs());
        let pressure = self.problem.lubricant.viscosity * speed * (bearing.radius / bearing.clearance).powi(2);
        pressure * 2.0 * bearing.radius * bearing.length
    }

    /// Whether the velocity of the journal between a step and the next is that of the path.
    pub fn moves_by_path(&self, from: &Step) -> bool {
        self.mass > 0.0 || from.until_next == Between::Path
    }

    /// The film at a time within a span of the orbit that begins with the step `from`. The place is that of the path,
    /// and the velocity that in which the film carries the load, or that of the path for a rotor with mass and on a
    /// shaft; a film that conserves its oil, or whose wall gives way, is led on from the step.
    ///
    /// # Errors
    /// [`NoOrbit`]: there is no such film.
    pub fn between(&self, from: &Step, span: &Span, time: f64, tolerance: f64) -> Result<Instant, NoOrbit> {
        let (at, velocity) = (span.at(time), span.rate(time));
        let accuracy = Accuracy { tolerance, scale: self.peak_load() };
        let found = match self.moves_by_path(from) {
            _ if from.history.is_some() || from.wall.is_some() => self.led_on(from, time, accuracy),
            _ if self.least_gap(at) <= 0.0 => Err(NoStage::Diverged),
            true => (self.film(Moving { time, at, velocity }, Held::default(), Neighbour::None)).map_err(NoStage::Film),
            false => self.carried((time, at), velocity, accuracy, &mut 0),
        };
        found.map_err(|reason| self.told_between(reason, time, at))
    }

    /// The end of one step from another one.
    fn led_on(&self, from: &Step, time: f64, accuracy: Accuracy) -> Result<Instant, NoStage> {
        let instant = self.film_at(from, Neighbour::None)?;
        if time <= from.time {
            return Ok(instant);
        }
        let masses = self.masses();
        let acceleration = [0, 1, 2, 3].map(|k| match masses[k] > 0.0 {
            true => -instant.excess[k] / masses[k],
            false => 0.0,
        });
        let begin = Begin { instant: &instant, acceleration, before: None };
        let made = self.step(&begin, time - from.time, accuracy, &mut 0)?;
        Ok(Instant { time, ..made.end })
    }

    /// The film of a step: that which was found, where it conserves its oil; else started from a neighbouring one.
    ///
    /// # Errors
    /// [`NoFilm`]: why there is none.
    pub fn film_at(&self, step: &Step, near: Neighbour) -> Result<Instant, NoFilm> {
        let wall = step.wall.as_ref();
        let Some(history) = &step.history else {
            return self.film(step.moving(), Held { storage: None, wall }, near);
        };
        let held = Held { storage: Some(&history.before), wall };
        let found = self.film(step.moving(), held, Neighbour::Found(&history.trace))?;
        Ok(Instant { oil: Some(history.oil.clone()), ..found })
    }
}
