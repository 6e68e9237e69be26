//! How a long run gets on, on stderr; nothing where nobody looks.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use oilwedge_campaign::convergence::{LevelReport, Observer, Strategy};
use oilwedge_report::sweep::Progress as Progressed;
use std::io::IsTerminal;
use std::time::{Duration, Instant};

/// Between two looks at the clock.
const TICK: Duration = Duration::from_millis(100);

/// A bar that fills as the given time passes, with what is being computed.
pub(crate) struct Progress {
    bar: ProgressBar,
    started: Instant,
}

impl Progress {
    /// For a run of at most so many seconds [s].
    pub(crate) fn new(max_seconds: f64) -> Self {
        let bar = ProgressBar::with_draw_target(Some((1e3 * max_seconds) as u64), target());
        if let Ok(style) = ProgressStyle::with_template("{spinner} {elapsed} [{bar:24}] {msg}") {
            bar.set_style(style.progress_chars("=> "));
        }
        bar.set_message("the first mesh");
        bar.enable_steady_tick(TICK);
        Self {
            bar,
            started: Instant::now(),
        }
    }

    fn move_on(&self) {
        self.bar.set_position(self.started.elapsed().as_millis() as u64);
    }

    /// Takes the bar away.
    pub(crate) fn end(&self) {
        self.bar.finish_and_clear();
    }
}

impl Observer for Progress {
    fn begins(&mut self, strategy: Strategy, level: usize, cells: usize, expected: Option<f64>) {
        let expected = expected.map_or(String::new(), |seconds| format!(", some {seconds:.1} s"));
        self.move_on();
        self.bar.set_message(format!(
            "{}, level {level}: some {cells} triangles{expected}",
            strategy.name()
        ));
    }

    fn ended(&mut self, _: Strategy, _: &LevelReport) {
        self.move_on();
    }
}

/// A sign that something is being computed, and for how long. It goes when this is dropped.
pub(crate) struct Working(ProgressBar);

impl Working {
    /// On `what`.
    pub(crate) fn on(what: &'static str) -> Self {
        let bar = ProgressBar::with_draw_target(None, target());
        if let Ok(style) = ProgressStyle::with_template("{spinner} {elapsed} {msg}") {
            bar.set_style(style);
        }
        bar.set_message(what);
        bar.enable_steady_tick(TICK);
        Self(bar)
    }

    /// Now on `what`.
    pub(crate) fn turns_to(&self, what: &'static str) {
        self.0.set_message(what);
    }
}

impl Drop for Working {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}

/// A bar that fills as cases end, with the time left.
pub(crate) struct SweepProgress {
    bar: ProgressBar,
    begun: bool,
}

impl SweepProgress {
    /// Before the first case.
    pub(crate) fn new() -> Self {
        let bar = ProgressBar::with_draw_target(None, target());
        if let Ok(style) =
            ProgressStyle::with_template("{spinner} {elapsed} [{bar:24}] {pos} of {len} cases, {eta} left")
        {
            bar.set_style(style.progress_chars("=> "));
        }
        bar.enable_steady_tick(TICK);
        Self { bar, begun: false }
    }

    /// So many cases have ended of so many.
    pub(crate) fn ended(&mut self, done: usize, cases: usize) {
        self.bar.set_length(cases as u64);
        self.bar.set_position(done as u64);
    }

    /// So many cases have ended. Those of an earlier run tell nothing of the time left.
    pub(crate) fn move_on(&mut self, now: Progressed) {
        if !self.begun {
            self.begun = true;
            self.bar.set_length(now.cases as u64);
            self.bar.set_position(now.done as u64);
            self.bar.reset_eta();
        }
        self.bar.set_position(now.done as u64);
    }

    /// Takes the bar away.
    pub(crate) fn end(&self) {
        self.bar.finish_and_clear();
    }
}

/// Nothing is drawn where nobody looks.
fn target() -> ProgressDrawTarget {
    match std::io::stderr().is_terminal() {
        true => ProgressDrawTarget::stderr(),
        false => ProgressDrawTarget::hidden(),
    }
}
