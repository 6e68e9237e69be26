//! How long a study may take, and what still fits.

use std::time::Instant;

use oilwedge_bearing::{Deadline, Interrupt};

/// What a level is expected to take, over what it was predicted to: machines are shared, and bad luck is no excuse.
const CAUTION: f64 = 1.25;
/// Part of the time, and most seconds of it, that is kept for drawing and writing.
const KEPT: (f64, f64) = (0.1, 1.0);
/// Part of the time that may go into repeating one level.
const REPEATING: f64 = 0.015;
/// Most times that a level is run.
const MOST_RUNS: usize = 5;

/// The time that a study has, counted from when the budget was made.
#[derive(Debug, Clone, Copy)]
pub struct Budget {
    started: Instant,
    max_seconds: f64,
    interrupt: Interrupt,
}

impl Budget {
    /// A budget that ends `max_seconds` [s] from now.
    pub fn seconds(max_seconds: f64) -> Self {
        Self { started: Instant::now(), max_seconds, interrupt: Interrupt::default() }
    }

    /// A budget that an interrupt ends too.
    pub fn until(self, interrupt: Interrupt) -> Self {
        Self { interrupt, ..self }
    }

    /// Whether the study was interrupted.
    pub fn is_interrupted(&self) -> bool {
        self.interrupt.is_asked()
    }

    /// How long a search that begins now may go on. A study without levels has no result, so only an interrupt ends the
    /// first.
    pub(super) fn deadline(&self, is_first: bool) -> Deadline {
        let seconds = match is_first {
            true => f64::INFINITY,
            false => f64::max(self.max_seconds - self.spent(), 0.0),
        };
        Deadline::after(seconds, self.interrupt)
    }

    /// The whole [s].
    pub fn max_seconds(&self) -> f64 {
        self.max_seconds
    }

    /// What has passed [s].
    pub fn spent(&self) -> f64 {
        self.started.elapsed().as_secs_f64()
    }

    /// What is left for levels [s], not negative.
    pub fn left(&self) -> f64 {
        if self.is_interrupted() {
            return 0.0;
        }
        let kept = f64::min(KEPT.0 * self.max_seconds, KEPT.1);
        f64::max(self.max_seconds - kept - self.spent(), 0.0)
    }

    /// Whether a level that is predicted to take so long [s] may be started.
    pub fn fits(&self, predicted: f64) -> bool {
        CAUTION * predicted < self.left()
    }

    /// Whether a level that took `runs` [s] so far is run once more for the sake of its timing.
    pub(super) fn repeats(&self, runs: &[f64]) -> bool {
        let Some(last) = runs.last() else { return true };
        let repeated: f64 = runs.iter().skip(1).sum();
        runs.len() < MOST_RUNS && repeated + last <= REPEATING * self.max_seconds && self.fits(*last)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_would_not_end_in_time_does_not_fit() {
        let budget = Budget::seconds(100.0);
        assert!(budget.fits(75.0) && !budget.fits(82.0));
        assert!(budget.left() < 99.0 && budget.spent() < 50.0);
        assert_eq!(Budget::seconds(0.0).left(), 0.0);
        assert!(!Budget::seconds(0.0).fits(0.0));
    }

    #[test]
    fn cheap_levels_are_repeated() {
        let budget = Budget::seconds(100.0);
        assert!(budget.repeats(&[1.5]) && !budget.repeats(&[1.6]));
        assert!(budget.repeats(&[0.1; 4]) && !budget.repeats(&[0.1; 5]));
        assert!(!budget.repeats(&[0.9, 0.9]));
    }
}
