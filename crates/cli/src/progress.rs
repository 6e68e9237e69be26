//! Progress of a long run on stderr; nothing is drawn where stderr is no terminal.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use oilwedge_campaign::convergence::{LevelReport, Observer, Strategy};
use oilwedge_report::sweep::Progress as Cases;
use std::io::IsTerminal;
use std::time::Duration;

/// Time between two frames.
const TICK: Duration = Duration::from_millis(100);

/// A line of progress, taken away when it is dropped.
pub(crate) struct Progress {
    bar: ProgressBar,
    begun: bool,
}

impl Progress {
    /// What is being computed, and for how long.
    pub(crate) fn of(task: &'static str) -> Self {
        let progress = Self::drawn("{spinner} {elapsed} {msg}", None);
        progress.turns_to(task);
        progress
    }

    /// A bar that fills within a time [s].
    pub(crate) fn of_seconds(max_seconds: f64) -> Self {
        let progress = Self::drawn("{spinner} {elapsed} [{bar:24}] {msg}", Some((1e3 * max_seconds) as u64));
        progress.turns_to("the first mesh");
        progress
    }

    /// A bar that fills as cases end, with the time left.
    pub(crate) fn of_cases() -> Self {
        Self::drawn("{spinner} {elapsed} [{bar:24}] {pos} of {len} cases, {eta} left", None)
    }

    fn drawn(template: &str, length: Option<u64>) -> Self {
        let target = match std::io::stderr().is_terminal() {
            true => ProgressDrawTarget::stderr(),
            false => ProgressDrawTarget::hidden(),
        };
        let bar = ProgressBar::with_draw_target(length, target);
        if let Ok(style) = ProgressStyle::with_template(template) {
            bar.set_style(style.progress_chars("=> "));
        }
        bar.enable_steady_tick(TICK);
        Self { bar, begun: false }
    }

    /// The run turns to another task.
    pub(crate) fn turns_to(&self, task: &'static str) {
        self.bar.set_message(task);
    }

    /// So many cases have ended of so many.
    pub(crate) fn cases(&mut self, now: Cases) {
        self.bar.set_length(now.cases as u64);
        self.bar.set_position(now.done as u64);
        if !self.begun {
            // Cases of an earlier run do not count in the estimate of the time left.
            self.begun = true;
            self.bar.reset_eta();
        }
    }

    fn show_time(&self) {
        self.bar.set_position(self.bar.elapsed().as_millis() as u64);
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

impl Observer for Progress {
    fn begins(&mut self, strategy: Strategy, level: usize, cells: usize, expected: Option<f64>) {
        let expected = expected.map_or(String::new(), |seconds| format!(", some {seconds:.1} s"));
        self.show_time();
        self.bar.set_message(format!(
            "{}, level {level}: some {cells} triangles{expected}",
            strategy.name()
        ));
    }

    fn ended(&mut self, _: Strategy, _: &LevelReport) {
        self.show_time();
    }
}
