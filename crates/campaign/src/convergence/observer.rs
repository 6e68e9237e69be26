//! Progress of a study, for whoever shows it.

use super::report::LevelReport;
use super::strategy::Strategy;

/// Receives the progress of a study while it runs.
pub trait Observer {
    /// Level `level` begins, of some `cells` triangles; `expected` seconds, where they can be predicted.
    fn begins(&mut self, strategy: Strategy, level: usize, cells: usize, expected: Option<f64>);

    /// A level has ended with an answer; its error is not known yet.
    fn ended(&mut self, strategy: Strategy, level: &LevelReport);
}

/// Ignores the progress.
impl Observer for () {
    fn begins(&mut self, _: Strategy, _: usize, _: usize, _: Option<f64>) {}

    fn ended(&mut self, _: Strategy, _: &LevelReport) {}
}
