//! How long a search may run.

use std::sync::LazyLock;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use crate::processor;

/// A request, such as Ctrl-C, that a run ends with what it has reached.
#[derive(Debug, Clone, Copy, Default)]
pub struct Interrupt(Option<&'static AtomicBool>);

impl Interrupt {
    /// A deadline that never comes.
    pub const NEVER: Self = Self(None);

    /// The request has come as soon as `asked` is true.
    pub fn when(asked: &'static AtomicBool) -> Self {
        Self(Some(asked))
    }

    /// Whether it has come.
    pub fn is_asked(&self) -> bool {
        self.0.is_some_and(|asked| asked.load(Ordering::Relaxed))
    }
}

/// What counts the seconds of a run; by default the time on the wall.
#[derive(Debug, Clone, Copy, Default)]
pub enum Clock {
    /// The time on the wall.
    #[default]
    Wall,
    /// The time of the processor in the threads of the run or, where that is less, the time on the wall: a busy machine
    /// shortens no run.
    Processor,
    /// A clock that shows the seconds [s] since some moment.
    Showing(fn() -> f64),
}

impl Clock {
    /// The moment now, from which seconds are counted.
    pub fn start(self) -> Moment {
        Moment { clock: self, shown: self.shown() }
    }

    /// What each of its clocks shows now [s]; the least time that passes by one of them counts.
    fn shown(self) -> [f64; 2] {
        match self {
            Self::Wall => [on_the_wall(); 2],
            Self::Processor => [on_the_wall(), processor::seconds()],
            Self::Showing(seconds) => [seconds(); 2],
        }
    }
}

/// A moment from which the seconds of a run are counted.
#[derive(Debug, Clone, Copy)]
pub struct Moment {
    clock: Clock,
    shown: [f64; 2],
}

impl Moment {
    /// Seconds since then [s].
    pub fn elapsed(&self) -> f64 {
        let [before, now] = [self.shown, self.clock.shown()];
        f64::min(now[0] - before[0], now[1] - before[1])
    }
}

/// Seconds since the first call [s].
fn on_the_wall() -> f64 {
    static START: LazyLock<Instant> = LazyLock::new(Instant::now);
    START.elapsed().as_secs_f64()
}

/// When a search must end: at a moment, or when it is interrupted. By default never.
#[derive(Debug, Clone, Copy)]
pub struct Deadline {
    begun: Moment,
    seconds: f64,
    interrupt: Interrupt,
}

impl Deadline {
    /// In `seconds` [s] from now, which may be infinite, or with the interrupt.
    pub fn after(seconds: f64, interrupt: Interrupt) -> Self {
        Self::by(Clock::default(), seconds, interrupt)
    }

    /// In `seconds` [s] of this clock from now, which may be infinite, or with the interrupt.
    pub fn by(clock: Clock, seconds: f64, interrupt: Interrupt) -> Self {
        Self { begun: clock.start(), seconds, interrupt }
    }

    /// Whether it has passed.
    pub fn is_over(&self) -> bool {
        self.interrupt.is_asked() || self.seconds.is_finite() && self.begun.elapsed() >= self.seconds
    }
}

impl Default for Deadline {
    fn default() -> Self {
        Self::after(f64::INFINITY, Interrupt::NEVER)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_deadline_passes_with_the_time_or_when_interrupted() {
        static ASKED: AtomicBool = AtomicBool::new(false);
        let interrupt = Interrupt::when(&ASKED);
        assert!(!Deadline::default().is_over());
        assert!(!Deadline::after(f64::INFINITY, interrupt).is_over());
        assert!(!Deadline::after(1e300, interrupt).is_over());
        assert!(!Deadline::after(100.0, interrupt).is_over());
        assert!(Deadline::after(0.0, interrupt).is_over());
        let stopped = Clock::Showing(|| 3.0);
        assert!(!Deadline::by(stopped, 1e-9, interrupt).is_over());
        assert!(Deadline::by(stopped, 0.0, interrupt).is_over());
        ASKED.store(true, Ordering::Relaxed);
        assert!(Deadline::after(f64::INFINITY, interrupt).is_over());
    }
}
