//! What heats and what cools a film, as it is measured.

use oilwedge_bearing::ThermalFlows;
use oilwedge_reynolds::supply::BoundaryKind;
use oilwedge_reynolds::{FilmProblem, FilmSystem, Theory};
use oilwedge_scene::Mixing;

use crate::film::Film;
use crate::measure::Measured;
use crate::thermal_model::ThermalModel;

/// Oil [m3/s] that leaves the film: at the ends, at the edge of an arc, at a film start, and where a feed drains it;
/// none from between the sealed ends of a long bearing, where it goes round.
pub fn leaving(problem: &FilmProblem, system: &FilmSystem, measured: &Measured) -> f64 {
    if problem.theory == Theory::Long {
        return 0.0;
    }
    let regions = system.supply.regions().iter().zip(&measured.flows.regions);
    let leaves = regions.map(|(region, flow)| match region.kind {
        // No film has less pressure than its cavity, so that no oil enters at such an end.
        BoundaryKind::End if problem.cavitation.pressure().is_some_and(|least| region.pressure <= least) => {
            (-flow.net).max(0.0)
        }
        BoundaryKind::End => flow.outward,
        BoundaryKind::Line | BoundaryKind::Feed => (-flow.net).max(0.0),
        BoundaryKind::Sealed => 0.0,
    });
    leaves.sum()
}

/// What heats and what cools the film.
pub(crate) fn thermal_flows(model: &ThermalModel, film: &Film, measured: &Measured) -> ThermalFlows {
    let flow = leaving(&film.problem, &film.system, measured);
    let round = measured.inlet_flow.map_or(0.0, |inlet| (inlet - flow).max(0.0));
    ThermalFlows {
        power: measured.power.friction() + measured.motion_power(&film.problem.journal),
        flow,
        carried_over: match model.mixing {
            None => 0.0,
            Some(Mixing::Ratio(ratio)) => ratio,
            Some(Mixing::Share(_)) if flow == 0.0 => 0.0,
            Some(Mixing::Share(share)) => share * round / flow,
        },
    }
}

/// The temperature to a tenth of a kelvin [K].
pub(crate) fn rounded(temperature: f64) -> f64 {
    // That of the ice point is a tenth and a twentieth.
    (10.0 * (temperature - 0.05)).round() / 10.0 + 0.05
}
