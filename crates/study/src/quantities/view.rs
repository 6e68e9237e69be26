//! A measured film as the rows of the catalogue see it.

use oilwedge_reynolds::quantities::flow::RegionFlow;
use oilwedge_reynolds::quantities::friction::{Friction, friction};
use oilwedge_reynolds::quantities::pressure::Extremes;
use oilwedge_reynolds::quantities::similarity;
use oilwedge_reynolds::supply::{BoundaryKind, SupplyRegion};
use oilwedge_reynolds::{FilmProblem, JournalState};

use crate::film::Film;
use crate::measure::{Measured, drag};

/// A load below this fraction of (greatest pressure difference, or pressure of drag) x (projected area) has no
/// direction.
const NO_LOAD: f64 = 1e-12;

/// A measured film.
pub struct View<'a> {
    /// The film at the position found.
    pub base: &'a Film,
    /// Problem of the film, whose journal may be elsewhere.
    pub problem: &'a FilmProblem,
    /// What was measured on it.
    pub measured: &'a Measured,
    /// Magnitude of the load [N].
    pub force: f64,
    /// True if the load is more than rounding, so that it has a direction.
    pub is_directed: bool,
}

impl<'a> View<'a> {
    /// A film whose journal is that of `problem`.
    pub fn new(base: &'a Film, problem: &'a FilmProblem, measured: &'a Measured) -> Self {
        let (bearing, force) = (&problem.bearing, measured.load.magnitude());
        let reference = excess(problem, &measured.extremes).max(drag(problem)) * 2.0 * bearing.radius * bearing.length;
        Self { base, problem, measured, force, is_directed: force > NO_LOAD * reference }
    }

    /// The journal.
    pub fn journal(&self) -> &'a JournalState {
        &self.problem.journal
    }

    /// Regions of the supply of one kind, with their flows.
    pub fn regions(&self, kind: BoundaryKind) -> impl Iterator<Item = (&'a SupplyRegion, &'a RegionFlow)> + use<'a> {
        let regions = self.base.system.supply.regions().iter();
        regions.zip(&self.measured.flows.regions).filter(move |(region, _)| region.kind == kind)
    }

    /// Oil [m3/s] that leaves at both ends; none where they are sealed.
    pub fn side_flow(&self) -> Option<f64> {
        self.regions(BoundaryKind::End).next()?;
        Some(self.regions(BoundaryKind::End).map(|(_, flow)| -flow.net).sum())
    }

    /// Unit [m3/s] of the flow numbers; none at rest.
    pub fn flow_unit(&self) -> Option<f64> {
        similarity::flow_unit(&self.problem.bearing, self.journal())
    }

    /// Torques; none at rest.
    pub fn friction(&self) -> Option<Friction> {
        friction(self.journal(), &self.measured.power)
    }
}

/// Greatest difference [Pa] of the pressure from that of the ends.
fn excess(problem: &FilmProblem, extremes: &Extremes) -> f64 {
    let off = |p: f64| (p - problem.bearing.end_pressure).abs();
    off(extremes.greatest).max(off(extremes.least))
}

/// An angle [deg] in [0, 360).
pub(super) fn degrees(angle: f64) -> f64 {
    // A remainder may round to the whole turn.
    angle.to_degrees().rem_euclid(360.0) % 360.0
}
