//! Orbits of one journal on one film after the other, each begun where the one before had closed.

use oilwedge_bearing::coordinates::Vector;
use oilwedge_bearing::duty_cycle::DutyCycle;
use oilwedge_bearing::orbit::PathStep;
use oilwedge_scene::OrbitTable;

use super::{FollowedCycle, OrbitStart, followed};
use crate::film::Film;
use crate::no_answer::NoAnswer;
use crate::observer::Watch;
use crate::run_options::RunOptions;

/// The orbits by which a balance of heat is found.
pub(super) struct OrbitSeries<'a> {
    /// Film of the first orbit, by which the others differ in temperature.
    pub(super) film: Film,
    pub(super) orbit: OrbitTable,
    pub(super) cycle: &'a DutyCycle,
    pub(super) watch: Watch,
    /// Options of the orbits that only lead to the balance.
    pub(super) options: RunOptions,
    /// Offsets at which the first orbit begins [m].
    pub(super) begin: Vector,
    /// Last step of the orbit before; `None` before the first one.
    pub(super) last: Option<PathStep>,
}

impl OrbitSeries<'_> {
    /// The next orbit, on a film like that of the series.
    ///
    /// # Errors
    /// [`NoAnswer`]: the film has no orbit.
    pub(super) fn followed(&self, film: &Film, options: &RunOptions) -> Result<FollowedCycle, NoAnswer> {
        let begin = self.last.as_ref().map_or(OrbitStart::At(self.begin), OrbitStart::After);
        followed(film, (&self.orbit, self.cycle), (begin, self.watch.deadline), options)
    }
}
