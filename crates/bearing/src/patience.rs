//! How long a search may go on.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// A wish that a run ends with what it has, which may come at any time: from Ctrl-C, for example.
#[derive(Debug, Clone, Copy, Default)]
pub struct Interrupt(Option<&'static AtomicBool>);

impl Interrupt {
    /// It never comes.
    pub const NEVER: Self = Self(None);

    /// The wish has come as soon as `asked` is true.
    pub fn when(asked: &'static AtomicBool) -> Self {
        Self(Some(asked))
    }

    /// Whether it has come.
    pub fn is_asked(&self) -> bool {
        self.0.is_some_and(|asked| asked.load(Ordering::Relaxed))
    }
}

/// How long a search may go on: until a moment, and as long as nobody asks it to end. By default as long as it takes.
#[derive(Debug, Clone, Copy, Default)]
pub struct Patience {
    until: Option<Instant>,
    interrupt: Interrupt,
}

impl Patience {
    /// For `seconds` [s] from now, infinite for without end, and until the interrupt.
    pub fn of(seconds: f64, interrupt: Interrupt) -> Self {
        let time = Duration::try_from_secs_f64(seconds).ok();
        Self {
            until: time.and_then(|time| Instant::now().checked_add(time)),
            interrupt,
        }
    }

    /// Whether it is at its end.
    pub fn is_over(&self) -> bool {
        self.interrupt.is_asked() || self.until.is_some_and(|until| Instant::now() >= until)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn patience_ends_with_the_time_or_when_asked() {
        static ASKED: AtomicBool = AtomicBool::new(false);
        let interrupt = Interrupt::when(&ASKED);
        assert!(!Patience::default().is_over());
        assert!(!Patience::of(f64::INFINITY, interrupt).is_over());
        assert!(!Patience::of(1e300, interrupt).is_over());
        assert!(!Patience::of(100.0, interrupt).is_over());
        assert!(Patience::of(0.0, interrupt).is_over());
        ASKED.store(true, Ordering::Relaxed);
        assert!(Patience::of(f64::INFINITY, interrupt).is_over());
    }
}
