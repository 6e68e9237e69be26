//! How long a search may run.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// A request, such as Ctrl-C, that a run ends with what it has reached.
#[derive(Debug, Clone, Copy, Default)]
pub struct Interrupt(Option<&'static AtomicBool>);

impl Interrupt {
    /// It never comes.
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

/// When a search must end: at a moment, or when it is interrupted. By default never.
#[derive(Debug, Clone, Copy, Default)]
pub struct Deadline {
    until: Option<Instant>,
    interrupt: Interrupt,
}

impl Deadline {
    /// In `seconds` [s] from now, which may be infinite, or with the interrupt.
    pub fn after(seconds: f64, interrupt: Interrupt) -> Self {
        let time = Duration::try_from_secs_f64(seconds).ok();
        Self {
            until: time.and_then(|time| Instant::now().checked_add(time)),
            interrupt,
        }
    }

    /// Whether it has passed.
    pub fn is_over(&self) -> bool {
        self.interrupt.is_asked() || self.until.is_some_and(|until| Instant::now() >= until)
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
        ASKED.store(true, Ordering::Relaxed);
        assert!(Deadline::after(f64::INFINITY, interrupt).is_over());
    }
}
