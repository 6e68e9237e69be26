//! Steps of the length that the tolerance allows, from cycle to cycle, until the journals repeat.

use oilwedge_reynolds::film_thickness::Deflection;

use super::journals::Journals;
use super::motion::{Instant, Motion};
use super::no_orbit::{NoOrbit, NoOrbitAt};
use super::oil::StoredOil;
use super::pace::Pace;
use super::path::{Between, PathStep};
use super::stage::{NoStage, StageTolerance};
use super::step::{Made, StepStart, ways_between};
use super::wall::WallPath;
use crate::Deadline;
use crate::coordinates::{Vector, length, moved};

/// From this cycle on the steps of the cycle before are repeated: what both differ by is then the path, not what other
/// steps make of it.
const REPEATED: usize = 3;
/// The path of a journal on a shaft may be off between two steps by this multiple of the tolerance.
const PATH: f64 = 2.0;
/// What the first stage is off by goes like this power of the step.
const PATH_POWER: f64 = 3.0;

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
    /// Distance between the places in which a journal begins and ends, or by which its wall moves further, if that is
    /// more: the greatest of all, over the clearance [1].
    pub closure: f64,
    /// Steps made.
    pub steps: usize,
    /// Steps tried with an error beyond the tolerance, or without a solution.
    pub rejected: usize,
    /// Films solved, of all journals.
    pub films: usize,
    /// The oil of films that conserve it, where it is worst; `None` where there are none.
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
    fn between(begin: &StoredOil, end: &StoredOil) -> Self {
        let missing = end.total() - begin.total() - (end.received - begin.received);
        Self { closure: end.differs(begin), imbalance: missing.abs() / (end.passed - begin.passed).max(end.total()) }
    }

    fn or_worse(self, other: Self) -> Self {
        Self { closure: self.closure.max(other.closure), imbalance: self.imbalance.max(other.imbalance) }
    }
}

impl Cycle {
    /// True if it ends as it began, within this part of the clearance and of the oil.
    fn is_closed(&self, within: f64) -> bool {
        self.closure < within && self.oil.is_none_or(|oil| oil.closure < within)
    }
}

/// An orbit.
#[derive(Debug, Clone, PartialEq)]
pub struct Orbit {
    /// Steps of the last complete cycle; the first entry is its beginning.
    pub steps: Vec<PathStep>,
    /// The cycles, the last one being that of the steps.
    pub cycles: Vec<Cycle>,
    /// How it ended.
    pub end: OrbitEnd,
}

/// How an orbit ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OrbitEnd {
    /// The last two cycles agree.
    Closed,
    /// The last two cycles differ, and no more were asked for.
    NotClosed,
    /// The orbit was ended before.
    Ended,
}

/// Where journals are.
struct Travellers {
    here: Vec<Instant>,
    accelerations: Vec<Vector>,
    before: Option<Vec<WallPath>>,
}

/// A journal where a cycle begins.
struct Begun {
    at: Vector,
    velocity: Vector,
    oil: Option<std::sync::Arc<StoredOil>>,
    wall: Option<Deflection>,
}

/// The steps of one cycle, each that of all journals.
type Steps = Vec<Vec<PathStep>>;

/// The orbits of journals that move at the same time.
#[derive(Debug, Clone, PartialEq)]
pub struct Orbits {
    /// Steps of the last complete cycle, each that of all journals; the first entry is its beginning.
    pub steps: Vec<Vec<PathStep>>,
    /// The cycles, the last one being that of the steps.
    pub cycles: Vec<Cycle>,
    /// How they ended.
    pub end: OrbitEnd,
}

impl Orbits {
    /// The orbit of the journal of this number.
    pub fn of(&self, number: usize) -> Orbit {
        let steps = self.steps.iter().map(|step| step[number].clone());
        Orbit { steps: steps.collect(), cycles: self.cycles.clone(), end: self.end }
    }
}

impl Motion<'_> {
    /// The orbit from the place `start` [m] on.
    ///
    /// # Errors
    /// [`NoOrbit`]: why there is none.
    pub fn orbit(&self, start: Vector, options: &OrbitOptions) -> Result<Orbit, NoOrbit> {
        let orbits = Journals::alone(self).orbits(&[start], options).map_err(|at| at.reason)?;
        Ok(orbits.of(0))
    }

    /// The orbit from the end of another one on, under the same load, of which this is the last step.
    ///
    /// # Errors
    /// [`NoOrbit`]: why there is none.
    pub fn orbit_after(&self, step: &PathStep, options: &OrbitOptions) -> Result<Orbit, NoOrbit> {
        let orbits = Journals::alone(self).orbits_after(std::slice::from_ref(step), options);
        Ok(orbits.map_err(|at| at.reason)?.of(0))
    }
}

impl Journals<'_> {
    /// The orbits of all journals from these places [m] on.
    ///
    /// # Errors
    /// [`NoOrbitAt`]: why there are none.
    pub fn orbits(&self, starts: &[Vector], options: &OrbitOptions) -> Result<Orbits, NoOrbitAt> {
        let accuracy = StageTolerance::of(options.tolerance, self.peak_load());
        let mut films = 0;
        let places: Vec<(Vector, Option<&Deflection>)> = starts.iter().map(|&start| (start, None)).collect();
        let here = self.beginning(starts, self.accuracy_of_beginning(accuracy), &mut films);
        let here = here.map_err(|reason| self.told(reason, (0.0, 1), &places))?;
        self.led_on(here, films, accuracy, options)
    }

    /// The orbits of all journals from the ends of others on, under the same loads, of which these are the last steps.
    /// Films carry on the oil that they hold.
    ///
    /// # Errors
    /// [`NoOrbitAt`]: why there are none.
    pub fn orbits_after(&self, steps: &[PathStep], options: &OrbitOptions) -> Result<Orbits, NoOrbitAt> {
        let accuracy = StageTolerance::of(options.tolerance, self.peak_load());
        let places: Vec<(Vector, Option<&Deflection>)> =
            steps.iter().map(|step| (step.at, step.wall.as_ref())).collect();
        let mut films = 0;
        let here = self.beginning_after(steps, self.accuracy_of_beginning(accuracy), &mut films);
        let here = here.map_err(|reason| self.told(reason, (0.0, 1), &places))?;
        self.led_on(here, films, accuracy, options)
    }

    /// How exactly a motion begins.
    fn accuracy_of_beginning(&self, accuracy: StageTolerance) -> StageTolerance {
        StageTolerance { balanced: accuracy.balanced.min(self.balanced_at_steps()), ..accuracy }
    }

    /// The orbits of all journals from these instants on, for which so many films were solved.
    fn led_on(
        &self,
        here: Vec<Instant>,
        mut films: usize,
        accuracy: StageTolerance,
        options: &OrbitOptions,
    ) -> Result<Orbits, NoOrbitAt> {
        let mut travellers = Travellers { accelerations: vec![[0.0; 4]; here.len()], here, before: None };
        let (mut cycles, mut last): (Vec<Cycle>, Steps) = (Vec::new(), Vec::new());
        let mut end = OrbitEnd::NotClosed;
        for number in 1..=options.cycles {
            let begun: Vec<Begun> = travellers.here.iter().map(Begun::of).collect();
            let Some((steps, mut cycle)) = self.cycle(&mut travellers, (number, &last), accuracy, options)? else {
                if number == 1 {
                    let angle = self.crank_angle(travellers.here[0].time);
                    return Err(NoOrbitAt { bearing: 0, reason: NoOrbit::Ended { angle } });
                }
                end = OrbitEnd::Ended;
                break;
            };
            cycle.films += std::mem::take(&mut films);
            for ((motion, begun), here) in self.motions.iter().zip(&begun).zip(&travellers.here) {
                cycle.closure = cycle.closure.max(begun.apart(motion, here));
                let oil = begun.oil.as_ref().zip(here.oil.as_ref()).map(|(begin, end)| CycleOil::between(begin, end));
                cycle.oil = cycle.oil.map_or(oil, |worst| Some(oil.map_or(worst, |oil| oil.or_worse(worst))));
            }
            cycles.push(cycle);
            last = steps;
            if cycle.is_closed(options.closure) {
                end = OrbitEnd::Closed;
                break;
            }
            travellers.here.iter_mut().for_each(|here| here.time = 0.0);
            travellers.before = None;
        }
        Ok(Orbits { steps: last, cycles, end })
    }

    /// One cycle; `None` where the deadline came. It meets the times of the steps of the last one from the cycle
    /// [`REPEATED`] on.
    fn cycle(
        &self,
        travellers: &mut Travellers,
        (number, last): (usize, &[Vec<PathStep>]),
        accuracy: StageTolerance,
        options: &OrbitOptions,
    ) -> Result<Option<(Steps, Cycle)>, NoOrbitAt> {
        let period = self.duration();
        let stops: Vec<f64> =
            if number < REPEATED { Vec::new() } else { last.iter().map(|step| step[0].time).collect() };
        let mut cycle = Cycle { closure: 0.0, steps: 0, rejected: 0, films: 0, oil: None };
        let none = vec![[0.0; 4]; travellers.here.len()];
        let mut steps = vec![self.recorded(travellers, &none, accuracy)];
        let pace = Pace { period, error_power: self.scheme().error_power };
        let velocities = travellers.here.iter().map(|here| here.velocity);
        let first = pace
            .first(1.0, Self::greatest_part(velocities, &self.gaps(travellers.here.iter().map(Instant::under_wall))));
        let mut dt = if stops.is_empty() { first } else { f64::INFINITY };
        while travellers.here[0].time < period {
            if options.deadline.is_over() {
                return Ok(None);
            }
            let now = travellers.here[0].time;
            let stop = stops.iter().copied().find(|time| *time > now).unwrap_or(period);
            let left = stop - now;
            let taken = pace.before(left, dt);
            let begin = StepStart {
                instants: &travellers.here,
                accelerations: &travellers.accelerations,
                before: travellers.before.as_deref(),
            };
            match self.step(begin, taken, accuracy, &mut cycle.films) {
                Ok(made) => {
                    let part;
                    (part, dt) = self.judged(&made, taken, pace, accuracy.tolerance);
                    if part > 1.0 && !pace.is_shortest(taken) {
                        cycle.rejected += 1;
                        continue;
                    }
                    let Made { mut end, accelerations, errors, .. } = made;
                    if taken == left {
                        end.iter_mut().for_each(|end| end.time = stop);
                        dt = if stops.is_empty() { dt } else { f64::INFINITY };
                    }
                    let before = Some(ways_between(&travellers.here, &end));
                    *travellers = Travellers { here: end, accelerations, before };
                    steps.push(self.recorded(travellers, &errors, accuracy));
                    cycle.steps += 1;
                    if let Some(observer) = options.observer {
                        let turn = self.crank_angle(period);
                        observer.step(number, turn * travellers.here[0].time / period, turn);
                    }
                }
                Err(reason) => {
                    cycle.rejected += 1;
                    dt = pace.retried(taken);
                    if pace.is_shortest(dt) {
                        let places: Vec<(Vector, Option<&Deflection>)> =
                            travellers.here.iter().map(|here| (here.at, here.wall())).collect();
                        return Err(self.told(reason, (now, number), &places));
                    }
                }
            }
        }
        Ok(Some((steps, cycle)))
    }

    /// The greatest error of a step of this length [s], over the tolerance, and the length of the next step [s]. On a
    /// shaft the path between two steps counts too, which decides how the journals move there.
    fn judged(&self, made: &Made, taken: f64, pace: Pace, tolerance: f64) -> (f64, f64) {
        let of_step =
            Self::greatest_part(made.errors.iter().copied(), &self.gaps(made.end.iter().map(Instant::under_wall)))
                / tolerance;
        let next = pace.next(taken, of_step);
        if self.shaft.is_none() {
            return (of_step, next);
        }
        let of_path = made.off_path / (PATH * tolerance);
        let by_path = Pace { error_power: PATH_POWER, ..pace };
        (of_step.max(of_path), next.min(by_path.next(taken, of_path)))
    }

    fn recorded(&self, travellers: &Travellers, errors: &[Vector], accuracy: StageTolerance) -> Vec<PathStep> {
        let residual = self.residual(&travellers.here, &travellers.accelerations, accuracy.scale);
        let until_next = if self.shaft.is_some() { Between::Path } else { Between::Load };
        let step = |(here, &error): (&Instant, &Vector)| PathStep { error, until_next, ..PathStep::of(here, residual) };
        travellers.here.iter().zip(errors).map(step).collect()
    }

    /// What a stage without a solution means for journals that have come to these places, under these walls.
    fn told(
        &self,
        reason: NoStage,
        (time, cycle): (f64, usize),
        places: &[(Vector, Option<&Deflection>)],
    ) -> NoOrbitAt {
        let (thinnest, part) = self.thinnest(places.iter().copied());
        let bearing = if let NoStage::Film(bearing, _) = reason { bearing } else { thinnest };
        let at = if self.shaft.is_some() { Some(places[bearing].0) } else { None };
        let motion = &self.motions[bearing];
        let gap = part * motion.problem.bearing.clearance;
        NoOrbitAt { bearing, reason: motion.told(reason, (time, self.crank_angle(time)), cycle, (gap, at)) }
    }
}

impl Begun {
    fn of(here: &Instant) -> Self {
        Self { at: here.at, velocity: here.velocity, oil: here.oil.clone(), wall: here.wall().cloned() }
    }

    /// How far journal or wall are from here at another instant, over the clearance [1]; for a rotor with mass also by
    /// how much it would be off after the crank has turned by one radian with the difference of velocities.
    fn apart(&self, motion: &Motion, there: &Instant) -> f64 {
        let by_wall = self.wall.as_ref().zip(there.wall());
        let by_wall = by_wall.map_or(0.0, |(begin, end)| begin.distance(end));
        let by_place = length(moved(there.at, -1.0, self.at));
        let masses = motion.masses();
        let hastened = [0, 1, 2, 3].map(|k| if masses[k] > 0.0 { there.velocity[k] - self.velocity[k] } else { 0.0 });
        let by_velocity = length(hastened) / motion.cycle.angular_speed();
        by_place.max(by_wall).max(by_velocity) / motion.problem.bearing.clearance
    }
}
