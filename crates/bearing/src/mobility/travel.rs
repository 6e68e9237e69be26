//! The orbit by a map: `e' = V(e, F) + (omega/2) k x e`, by the same implicit steps as that of a film, with the
//! derivative of the right side by differences.

use super::FilmMap;
use crate::coordinates::Vector;
use crate::duty_cycle::DutyCycle;
use crate::orbit::pace::Pace;
use crate::orbit::scheme::{FOURTH_ORDER, Scheme};
use crate::orbit::{Between, PathStep};
use oilwedge_reynolds::Bearing;

/// A film that is a map has no memory.
const SCHEME: Scheme = FOURTH_ORDER;
/// Iterations of a stage, and the part of the tolerance below which it is solved.
const MOST_ITERATIONS: usize = 12;
const SOLVED: f64 = 1e-4;
/// Part of the least film by which the derivative is taken.
const SMALL: f64 = 1e-6;
/// No iteration leaves less than this part of the least film.
const LEAST_SHRINK: f64 = 0.2;

/// A journal without mass that a map leads.
pub struct Travel<'a> {
    /// The film.
    pub map: &'a dyn FilmMap,
    /// The bearing.
    pub bearing: Bearing,
    /// Viscosity [Pa s].
    pub viscosity: f64,
    /// What acts on the journal.
    pub cycle: &'a DutyCycle,
}

/// An orbit by a map.
#[derive(Debug, Clone, PartialEq)]
pub struct MapOrbit {
    /// Steps of the last cycle; the first entry is its beginning.
    pub steps: Vec<PathStep>,
    /// Cycles that were followed.
    pub cycles: usize,
    /// Distance between the places in which the last one begins and ends, over the clearance [1].
    pub closure: f64,
}

type JournalOffset = [f64; 2];

impl Travel<'_> {
    /// The orbit from a place [m], followed until a cycle closes to `closure` of the clearance, or for so many
    /// `cycles`; each step may be off by `tolerance` of the least film. `None` where no step leads on.
    pub fn orbit(&self, start: [f64; 2], tolerance: f64, closure: f64, cycles: usize) -> Option<MapOrbit> {
        let clearance = self.bearing.clearance;
        let mut place = start.map(|part| part / clearance);
        let mut found = None;
        for number in 1..=cycles {
            let steps = self.cycle(place, tolerance)?;
            let end = steps.last()?.at;
            let end = [end[0] / clearance, end[1] / clearance];
            let closed = (end[0] - place[0]).hypot(end[1] - place[1]);
            place = end;
            found = Some(MapOrbit { steps, cycles: number, closure: closed });
            if closed < closure {
                break;
            }
        }
        found
    }

    /// Rate of the place [1/s].
    fn rate(&self, time: f64, [x, y]: JournalOffset) -> JournalOffset {
        let duty = self.cycle.at(self.cycle.angular_speed() * time);
        let bearing = &self.bearing;
        let unit = self.viscosity * bearing.length.powi(3) * bearing.radius / bearing.clearance.powi(2);
        let force = duty.force.map(|part| part / unit);
        let (eccentricity, size) = (x.hypot(y), force[0].hypot(force[1]));
        let turning = [-0.5 * duty.speed * y, 0.5 * duty.speed * x];
        if size == 0.0 {
            return turning;
        }
        // Along the line of centres and across it; a force on the other side of the line is mirrored.
        let axis = match eccentricity > 0.0 {
            true => [x / eccentricity, y / eccentricity],
            false => force.map(|part| part / size),
        };
        let along = force[0] * axis[0] + force[1] * axis[1];
        let across = force[1] * axis[0] - force[0] * axis[1];
        let [a, b] = self.map.mobility(eccentricity, size, across.abs().atan2(along));
        let b = b.copysign(across);
        [a * axis[0] - b * axis[1] + turning[0], a * axis[1] + b * axis[0] + turning[1]]
    }

    /// One cycle from a place.
    fn cycle(&self, start: JournalOffset, tolerance: f64) -> Option<Vec<PathStep>> {
        let period = self.cycle.period() / self.cycle.angular_speed();
        let pace = Pace { period, error_power: SCHEME.error_power };
        let (mut time, mut place, mut rate) = (0.0, start, self.rate(0.0, start));
        let mut steps = vec![self.recorded(time, place, rate)];
        let mut dt = 1e-3 * period;
        while time < period {
            let taken = dt.min(period - time);
            let outcome = self.step((time, place, rate), taken, tolerance);
            let part = outcome.map_or(f64::INFINITY, |(_, _, error)| error / tolerance);
            dt = pace.next(taken, part);
            match outcome {
                Some((end, end_rate, _)) if part <= 1.0 => {
                    time = if taken == period - time { period } else { time + taken };
                    (place, rate) = (end, end_rate);
                    steps.push(self.recorded(time, place, rate));
                }
                _ if pace.is_shortest(dt) => return None,
                _ => {}
            }
        }
        Some(steps)
    }

    /// A step: place and rate at its end, and its error over the least film.
    fn step(
        &self,
        (time, place, rate): (f64, JournalOffset, JournalOffset),
        dt: f64,
        tolerance: f64,
    ) -> Option<(JournalOffset, JournalOffset, f64)> {
        let mut rates = vec![rate];
        let mut at = place;
        let mut slope = [[0.0; 2]; 2];
        for stage in 1..SCHEME.stages() {
            let known: JournalOffset = [0, 1].map(|k| {
                let earlier = rates.iter().zip(SCHEME.coefficients[stage]);
                place[k] + dt * earlier.map(|(rate, coefficient)| coefficient * rate[k]).sum::<f64>()
            });
            let now = time + dt * SCHEME.nodes[stage];
            (at, slope) = self.stage(now, known, at, dt, tolerance)?;
            rates.push([0, 1].map(|k| (at[k] - known[k]) / (SCHEME.diagonal * dt)));
        }
        let weights = SCHEME.error_weights();
        let error: JournalOffset = [0, 1].map(|k| {
            let parts = rates.iter().zip(&weights);
            dt * parts.map(|(rate, weight)| weight * rate[k]).sum::<f64>()
        });
        let [x, y] = solved(implicit(slope, dt), error)?;
        Some((at, *rates.last()?, x.hypot(y) / (1.0 - at[0].hypot(at[1]))))
    }

    /// The place at which `at = known + gamma dt rate(at)`, and the derivative of the rate there.
    fn stage(
        &self,
        time: f64,
        known: JournalOffset,
        start: JournalOffset,
        dt: f64,
        tolerance: f64,
    ) -> Option<(JournalOffset, [[f64; 2]; 2])> {
        let mut at = start;
        for _ in 0..MOST_ITERATIONS {
            let gap = 1.0 - at[0].hypot(at[1]);
            let rate = self.rate(time, at);
            let small = SMALL * gap;
            let [by_x, by_y] = [[small, 0.0], [0.0, small]].map(|by| {
                let there = self.rate(time, [at[0] + by[0], at[1] + by[1]]);
                [0, 1].map(|k| (there[k] - rate[k]) / small)
            });
            let slope = [[by_x[0], by_y[0]], [by_x[1], by_y[1]]];
            let left = [0, 1].map(|k| known[k] + SCHEME.diagonal * dt * rate[k] - at[k]);
            let way = solved(implicit(slope, dt), left)?;
            let mut part = 1.0;
            let next = |part: f64| [at[0] + part * way[0], at[1] + part * way[1]];
            while 1.0 - next(part)[0].hypot(next(part)[1]) < LEAST_SHRINK * gap {
                part *= 0.7;
            }
            at = next(part);
            let change = way[0].hypot(way[1]) / gap;
            if !change.is_finite() {
                return None;
            }
            if change < SOLVED * tolerance.max(1e-9) {
                return Some((at, slope));
            }
        }
        None
    }

    fn recorded(&self, time: f64, place: JournalOffset, rate: JournalOffset) -> PathStep {
        let clearance = self.bearing.clearance;
        let vector = |[x, y]: JournalOffset| -> Vector { [clearance * x, clearance * y, 0.0, 0.0] };
        PathStep {
            time,
            at: vector(place),
            excess: [0.0; 4],
            velocity: vector(rate),
            error: [0.0; 4],
            residual: 0.0,
            history: None,
            wall: None,
            until_next: Between::Load,
        }
    }
}

/// `1 - gamma dt slope`.
fn implicit(slope: [[f64; 2]; 2], dt: f64) -> [[f64; 2]; 2] {
    let unit = |i: usize, j: usize| f64::from(u8::from(i == j));
    [0, 1].map(|i| [0, 1].map(|j| unit(i, j) - SCHEME.diagonal * dt * slope[i][j]))
}

/// Solves two equations.
fn solved([[a, b], [c, d]]: [[f64; 2]; 2], [x, y]: JournalOffset) -> Option<JournalOffset> {
    let determinant = a * d - b * c;
    let found = [(d * x - b * y) / determinant, (a * y - c * x) / determinant];
    found.iter().all(|part| part.is_finite()).then_some(found)
}
