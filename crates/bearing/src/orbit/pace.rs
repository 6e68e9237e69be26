//! How long steps in time are.

/// Length of the next step over the one that would just meet the tolerance.
const SAFETY: f64 = 0.85;
/// Least and greatest length of a step, over that of the last one.
const CHANGES: [f64; 2] = [0.2, 3.0];
/// A step whose stages have no solution is divided by this.
const RETRY: f64 = 4.0;
/// Longest step, of the cycle.
const LONGEST: f64 = 1.0 / 32.0;
/// Shortest step, of the cycle.
const SHORTEST: f64 = 1e-9;
/// First step of a cycle: of the time in which a journal would move by the least gap.
const FIRST: f64 = 0.1;

/// The steps of a cycle.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pace {
    /// Length of the cycle [s].
    pub(crate) period: f64,
    /// The local error of a step goes like this power of its length.
    pub(crate) error_power: f64,
}

impl Pace {
    /// The first step [s] of a journal that has a least gap [m] and moves at this rate [m/s].
    pub(crate) fn first(&self, gap: f64, rate: f64) -> f64 {
        let time = FIRST * gap / rate.max(f64::MIN_POSITIVE);
        time.clamp(10.0 * SHORTEST * self.period, 0.1 * LONGEST * self.period)
    }

    /// The step [s] that is taken of `dt` where a stop is `left` [s] away: no short step is left before it.
    pub(crate) fn before(&self, left: f64, dt: f64) -> f64 {
        if dt >= left {
            left
        } else if dt > 0.5 * left {
            0.5 * left
        } else {
            dt
        }
    }

    /// The next step [s] after one that had this error over the tolerance.
    pub(crate) fn next(&self, taken: f64, part: f64) -> f64 {
        let change = SAFETY * part.max(1e-10).powf(-1.0 / self.error_power);
        (taken * change.clamp(CHANGES[0], CHANGES[1])).min(LONGEST * self.period)
    }

    /// The step [s] that is tried where one had no solution.
    pub(crate) fn retried(&self, taken: f64) -> f64 {
        taken / RETRY
    }

    /// True for a step that is not divided further.
    pub(crate) fn is_shortest(&self, dt: f64) -> bool {
        dt <= SHORTEST * self.period
    }
}
