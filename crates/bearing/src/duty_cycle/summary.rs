//! Extremes and means of a load over its period.

use std::f64::consts::TAU;

use super::{CycleSource, Duty, DutyCycle};

/// At how many angles of a period a load is sampled.
const SAMPLES: u32 = 7200;
/// Golden sections by which an extreme between samples is narrowed: to 1e-8 of the distance of samples.
const SECTIONS: u32 = 40;
/// How far a number of turns may be from a whole one.
const WHOLE: f64 = 1e-9;

/// Extremes and means of a load over its period.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Summary {
    /// Greatest magnitude of the force: crank angle [rad], and force [N] in the frame of the shell.
    pub peak: (f64, [f64; 2]),
    /// Least magnitude of the force: crank angle [rad], and force [N] in the frame of the shell.
    pub least: (f64, [f64; 2]),
    /// Mean force over the crank angle [N], in the frame of the shell.
    pub mean: [f64; 2],
    /// Mean magnitude of the force over the crank angle [N].
    pub mean_magnitude: f64,
    /// Greatest magnitude of the moment [N m].
    pub greatest_moment: f64,
    /// Least and greatest speed of the journal against the shell [rad/s].
    pub speeds: [f64; 2],
    /// How much of the force turns at half the speed of the journal, as the oil does that the journal drags along:
    /// `|mean F exp(-i alpha)|/mean |F|` with `d alpha/dt = speed/2` (0 to 1). There a film has no wedge, and carries
    /// by squeeze alone.
    pub half_speed_share: f64,
}

/// Extremes and means of the rows of a table of loads, which a curve joins.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RowsSummary {
    /// Number of rows of a period.
    pub count: usize,
    /// Greatest magnitude of the force in a row: crank angle [rad], and force [N] in the frame of the shell.
    pub peak: (f64, [f64; 2]),
    /// Mean force of straight lines from row to row over the crank angle [N], in the frame of the shell.
    pub mean: [f64; 2],
    /// Mean over the crank angle [N] of the magnitude that is linear from row to row.
    pub mean_magnitude: f64,
}

impl DutyCycle {
    /// Extremes and means of the rows of a table, in the frame of the shell; `None`: the load is not given by a table.
    pub fn rows_summary(&self) -> Option<RowsSummary> {
        let CycleSource::Table(_, curve) = &self.source else {
            return None;
        };
        let rows: Vec<(f64, [f64; 2])> = curve.points().map(|(angle, _)| (angle, self.at(angle).force)).collect();
        let magnitude = |[x, y]: [f64; 2]| x.hypot(y);
        let peak = (rows.iter().copied()).max_by(|a, b| magnitude(a.1).total_cmp(&magnitude(b.1)))?;
        let (mut mean, mut mean_magnitude) = ([0.0; 2], 0.0);
        for (k, &(angle, force)) in rows.iter().enumerate() {
            let (next, next_force) = match rows.get(k + 1) {
                Some(&(next, force)) => (next, force),
                None => (rows[0].0 + self.period, rows[0].1),
            };
            let half = 0.5 * (next - angle) / self.period;
            (0..2).for_each(|d| mean[d] += half * (force[d] + next_force[d]));
            mean_magnitude += half * (magnitude(force) + magnitude(next_force));
        }
        Some(RowsSummary { count: rows.len(), peak, mean, mean_magnitude })
    }

    /// Extremes and means over the period.
    pub fn summary(&self) -> Summary {
        let step = self.period / f64::from(SAMPLES);
        let angles = (0..SAMPLES).map(|k| step * f64::from(k));
        let duties: Vec<_> = angles.map(|angle| (angle, self.at(angle))).collect();
        let magnitude = |[x, y]: [f64; 2]| x.hypot(y);
        let extreme = |sign: f64| {
            let value = |angle: f64| sign * magnitude(self.at(angle).force);
            let samples = duties.iter().map(|(angle, duty)| (*angle, sign * magnitude(duty.force)));
            let first = samples.fold((0.0, f64::NEG_INFINITY), |best, it| if it.1 > best.1 { it } else { best });
            let refined = greatest(value, [first.0 - step, first.0 + step]);
            let angle = if value(refined) > first.1 { refined } else { first.0 };
            let angle = angle.rem_euclid(self.period);
            (angle, self.at(angle).force)
        };
        let share = 1.0 / f64::from(SAMPLES);
        let mean =
            |part: &dyn Fn([f64; 2]) -> f64| duties.iter().map(|(_, duty)| share * part(duty.force)).sum::<f64>();
        let speeds = duties.iter().map(|(_, duty)| duty.speed);
        let mean_magnitude = mean(&magnitude);
        Summary {
            peak: extreme(1.0),
            least: extreme(-1.0),
            mean: [mean(&|[x, _]| x), mean(&|[_, y]| y)],
            mean_magnitude,
            half_speed_share: match mean_magnitude > 0.0 {
                true => self.half_speed_amplitude() / mean_magnitude,
                false => 0.0,
            },
            greatest_moment: duties.iter().map(|(_, duty)| magnitude(duty.moment)).fold(0.0, f64::max),
            speeds: speeds
                .fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], speed| [least.min(speed), most.max(speed)]),
        }
    }
}

impl DutyCycle {
    /// `|mean F exp(-i alpha)|` [N], with `d alpha/dt` half the speed of the journal, over two turns of the load's
    /// angle. It is zero where the journal does not make whole turns in one of them: no part of the load turns with
    /// alpha then.
    fn half_speed_amplitude(&self) -> f64 {
        let turns = self.turns_of_journal();
        if (turns - turns.round()).abs() > WHOLE {
            return 0.0;
        }
        let step = 2.0 * TAU / f64::from(SAMPLES);
        let (mut turned, mut sum) = (0.0, [0.0; 2]);
        for k in 0..SAMPLES {
            // The middle of a step, where the midpoint rule has the angle turned too.
            let Duty { force: [x, y], speed, .. } = self.at(step * (f64::from(k) + 0.5));
            let half = 0.25 * step * speed / self.angular_speed;
            turned += half;
            let (sin, cos) = turned.sin_cos();
            turned += half;
            sum = [sum[0] + x * cos + y * sin, sum[1] + y * cos - x * sin];
        }
        sum[0].hypot(sum[1]) / f64::from(SAMPLES)
    }

    /// Turns of the journal against the shell in one turn of the load's angle.
    fn turns_of_journal(&self) -> f64 {
        let step = TAU / f64::from(SAMPLES);
        let speeds = (0..SAMPLES).map(|k| self.at(step * (f64::from(k) + 0.5)).speed);
        speeds.sum::<f64>() / (f64::from(SAMPLES) * self.angular_speed)
    }
}

/// Where a function with one maximum in an interval has it, by golden sections.
fn greatest(value: impl Fn(f64) -> f64, [mut from, mut to]: [f64; 2]) -> f64 {
    let ratio = 0.5 * (5f64.sqrt() - 1.0);
    let [mut a, mut b] = [to - ratio * (to - from), from + ratio * (to - from)];
    let [mut at_a, mut at_b] = [value(a), value(b)];
    for _ in 0..SECTIONS {
        if at_a < at_b {
            (from, a, at_a) = (a, b, at_b);
            b = from + ratio * (to - from);
            at_b = value(b);
        } else {
            (to, b, at_b) = (b, a, at_a);
            a = to - ratio * (to - from);
            at_a = value(a);
        }
    }
    0.5 * (from + to)
}
