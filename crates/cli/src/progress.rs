//! Progress of a long run on stderr: a line that changes on a terminal, else a plain line every few seconds.

use crate::complain::say;
use crate::readable::{bar, readable_unit, significant};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use oilwedge_campaign::convergence::{LevelReport, Observer, Strategy};
use oilwedge_report::sweep::Progress as Cases;
use oilwedge_report::tables::{duration, time};
use oilwedge_study::{OrbitObserver, Reached, RunObserver, SearchObserver};
use std::io::IsTerminal;
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// Time between two frames.
const TICK: Duration = Duration::from_millis(100);
/// Time between two lines where there is no terminal.
const SILENCE: Duration = Duration::from_secs(5);

/// How a run gets on: one line that changes on a terminal, else a line for each mesh and every few seconds.
#[derive(Debug)]
pub(crate) struct RunSteps {
    bar: ProgressBar,
    now: Mutex<Now>,
}

/// Place at which a run is.
#[derive(Debug)]
struct Now {
    /// Time at which the last line was written where there is no terminal.
    told: Instant,
    /// The cycle of an orbit that is followed, and when it began.
    cycle: Option<(usize, Instant)>,
    task: &'static str,
    level: String,
    temperature: String,
    position: String,
    reached: String,
}

impl Now {
    fn at_first() -> Self {
        Self {
            told: Instant::now(),
            cycle: None,
            task: "",
            level: String::new(),
            temperature: String::new(),
            position: String::new(),
            reached: String::new(),
        }
    }

    /// Time at which the cycle `number` began, which now is where the cycle before was another one.
    fn begin_of_cycle(&mut self, number: usize) -> Instant {
        match self.cycle {
            Some((before, begun)) if before == number => begun,
            _ => {
                let begun = Instant::now();
                self.cycle = Some((number, begun));
                begun
            }
        }
    }
}

impl RunSteps {
    fn show(&self, change: impl FnOnce(&mut Now)) {
        let Ok(mut now) = self.now.lock() else { return };
        change(&mut now);
        let parts: [&str; 5] = [now.task, &now.level, &now.temperature, &now.position, &now.reached];
        let parts: Vec<&str> = parts.into_iter().filter(|part| !part.is_empty()).collect();
        let line = parts.join(", ");
        if self.bar.is_hidden() && now.told.elapsed() > SILENCE {
            say(&line);
            now.told = Instant::now();
        }
        self.bar.set_message(format!("{line}; Ctrl-C ends with the best so far"));
    }
}

impl SearchObserver for RunSteps {
    fn position(&self, number: usize, residual: f64) {
        self.show(|now| now.position = format!("position {number} off the load by {} of it", significant(residual, 2)));
    }
}

impl OrbitObserver for RunSteps {
    fn step(&self, number: usize, angle: f64, period: f64) {
        self.show(|now| {
            let taken = now.begin_of_cycle(number).elapsed().as_secs_f64();
            let left = duration(taken * (period - angle) / angle);
            now.position = format!("cycle {number}: {angle:.0} of {period:.0} deg, about {left} left of it");
        });
    }
}

impl RunObserver for RunSteps {
    fn level(&self, number: usize, unknowns: usize) {
        self.show(|now| {
            now.level = format!("level {number}: {unknowns} unknowns");
            (now.temperature, now.position) = (String::new(), String::new());
        });
    }

    fn reached(&self, reached: &Reached) {
        let Reached { level, unknowns, .. } = reached;
        let bars = bars(reached);
        if self.bar.is_hidden() {
            say(&format!("level {level}: {unknowns} unknowns, {bars}, {}", time(reached.seconds)));
        }
        self.show(|now| now.reached = format!("level {level} reached {bars}"));
    }

    fn counterweights(&self, part: f64, film: [f64; 2]) {
        let [before, after] = film.map(|film| significant(1e6 * film, 4));
        let line = format!("counterweights moved {part} of the way: least film {before} -> {after} um");
        if self.bar.is_hidden() {
            say(&line);
        }
        self.show(|now| now.reached = line);
    }

    fn expects(&self, unknowns: usize, seconds: Option<f64>) {
        if let Some(seconds) = seconds.filter(|seconds| *seconds > SILENCE.as_secs_f64()) {
            let line = format!("the orbit on {unknowns} unknowns takes some {} of processor time", duration(seconds));
            self.bar.suspend(|| say(&line));
        }
    }

    fn turns_to(&self, task: &'static str) {
        self.show(|now| {
            (now.task, now.cycle) = (task, None);
            now.position = String::new();
        });
    }

    fn temperature(&self, number: usize, celsius: f64) {
        self.show(|now| {
            now.cycle = None;
            now.temperature = format!("temperature {number}: {celsius:.1} C");
            now.position = String::new();
        });
    }
}

/// The error reached and the one asked for.
fn bars(reached: &Reached) -> String {
    let name = &reached.quantity;
    match (reached.error, reached.asked) {
        (Some(error), Some(asked)) => {
            let (unit, size) = readable_unit(error, reached.unit);
            let text = format!("{name} ± {}, asked for ± {} {unit}", bar(error / size), bar(asked / size));
            text.trim_end().to_owned()
        }
        _ => format!("{name} not resolved yet"),
    }
}

/// A line of progress, taken away when it is dropped.
pub(crate) struct ProgressLine {
    bar: ProgressBar,
    begun: Instant,
    /// Time at which the last line was written where there is no terminal.
    told: Instant,
}

/// Seconds that the cases left will take at the speed of this run: those of an earlier run are not counted. `None`
/// before the first case, and after the last.
fn seconds_left(now: Cases, elapsed: f64) -> Option<f64> {
    let own = now.done.saturating_sub(now.kept);
    let left = now.cases.saturating_sub(now.done);
    (own > 0 && left > 0).then(|| elapsed * left as f64 / own as f64)
}

impl ProgressLine {
    /// What is being computed, and for how long.
    pub(crate) fn of(task: &'static str) -> Self {
        let progress = Self::drawn("{spinner} {elapsed} {msg}", None);
        progress.turns_to(task);
        progress
    }

    /// Shows how a run gets on.
    pub(crate) fn observer(&self) -> &'static dyn RunObserver {
        let steps = RunSteps { bar: self.bar.clone(), now: Mutex::new(Now::at_first()) };
        // One for each run of the program.
        Box::leak(Box::new(steps))
    }

    /// A bar that fills within a time [s].
    pub(crate) fn of_seconds(max_seconds: f64) -> Self {
        let progress = Self::drawn("{spinner} {elapsed} [{bar:24}] {msg}", Some((1e3 * max_seconds) as u64));
        progress.turns_to("the first mesh");
        progress
    }

    /// A bar that fills as cases end, with the time left.
    pub(crate) fn of_cases() -> Self {
        Self::drawn("{spinner} {elapsed} [{bar:24}] {pos} of {len} cases{msg}", None)
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
        Self { bar, begun: Instant::now(), told: Instant::now() }
    }

    /// The run turns to another task.
    pub(crate) fn turns_to(&self, task: &'static str) {
        self.bar.set_message(task);
    }

    /// The run turns to another task, in a line of its own where there is no terminal.
    pub(crate) fn goes_on_to(&self, task: &'static str) {
        if self.bar.is_hidden() {
            say(task);
        }
        self.turns_to(task);
    }

    /// Shows how many cases have ended of how many.
    pub(crate) fn cases(&mut self, now: Cases) {
        self.bar.set_length(now.cases as u64);
        self.bar.set_position(now.done as u64);
        let Some(left) = seconds_left(now, self.begun.elapsed().as_secs_f64()) else {
            return;
        };
        let left = format!(", about {} left", duration(left));
        self.bar.set_message(left.clone());
        if self.bar.is_hidden() && self.told.elapsed() > SILENCE {
            self.told = Instant::now();
            say(&format!("{} of {} cases{left}", now.done, now.cases));
        }
    }

    /// A line of progress where there is no terminal, on which the bar shows it.
    pub(crate) fn line(&mut self, line: &str) {
        match self.bar.is_hidden() {
            true => say(line),
            false => self.bar.set_message(format!(": {line}")),
        }
        self.told = Instant::now();
    }

    /// A line that stays.
    pub(crate) fn say(&self, line: &str) {
        self.bar.suspend(|| say(line));
    }

    fn show_time(&self) {
        self.bar.set_position(self.bar.elapsed().as_millis() as u64);
    }
}

impl Drop for ProgressLine {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

impl Observer for ProgressLine {
    fn begins(&mut self, strategy: Strategy, level: usize, cells: usize, expected: Option<f64>) {
        let expected = expected.map_or(String::new(), |seconds| format!(", some {seconds:.1} s"));
        self.show_time();
        self.bar.set_message(format!("{}, level {level}: some {cells} triangles{expected}", strategy.name()));
    }

    fn ended(&mut self, _: Strategy, _: &LevelReport) {
        self.show_time();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_of_an_earlier_run_are_no_speed() {
        let now = Cases { kept: 900, done: 910, cases: 1000 };
        assert_eq!(seconds_left(now, 20.0), Some(180.0));
        assert_eq!(seconds_left(Cases { done: 900, ..now }, 20.0), None);
        assert_eq!(seconds_left(Cases { done: 1000, ..now }, 20.0), None);
    }
}
