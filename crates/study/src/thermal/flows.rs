//! What heats and what cools a film, as it is measured.

use oilwedge_bearing::ThermalFlows;
use oilwedge_reynolds::quantities::flow::{Flows, flows};
use oilwedge_reynolds::quantities::inlet::inlet_flow;
use oilwedge_reynolds::quantities::load::load;
use oilwedge_reynolds::supply::BoundaryKind;
use oilwedge_reynolds::{FilmProblem, FilmSystem, SolvedFilm, Theory};
use oilwedge_scene::Mixing;

use crate::film::Film;
use crate::measure::{Measured, motion_power, powers};
use crate::thermal_model::ThermalModel;

/// Oil [m3/s] that leaves the film: at the ends, at the edge of an arc, at a film start, and where a feed drains it;
/// none from between the sealed ends of a long bearing, where it goes round.
pub fn leaving(problem: &FilmProblem, system: &FilmSystem, flows: &Flows) -> f64 {
    if problem.theory == Theory::Long {
        return 0.0;
    }
    let regions = system.supply.regions().iter().zip(&flows.regions);
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
    let power = measured.power.friction() + measured.motion_power(&film.problem.journal);
    let flow = leaving(&film.problem, &film.system, &measured.flows);
    of_parts(model, (power, flow), || measured.inlet_flow)
}

/// What heats and what cools a film on which nothing else is measured.
pub(crate) fn thermal_flows_of(model: &ThermalModel, film: &SolvedFilm) -> ThermalFlows {
    let load = load(film);
    let power = powers(film, &load).friction() + motion_power(&film.problem.journal, &load);
    let flow = leaving(&film.problem, &film.system, &flows(film));
    of_parts(model, (power, flow), || inlet_flow(film))
}

/// By the power [W] of a film, the oil that leaves it [m3/s] and, where hot oil mixes, that which enters it.
fn of_parts(model: &ThermalModel, (power, flow): (f64, f64), inlet: impl FnOnce() -> Option<f64>) -> ThermalFlows {
    let carried_over = match model.mixing {
        None => 0.0,
        Some(Mixing::Ratio(ratio)) => ratio,
        Some(Mixing::Share(_)) if flow == 0.0 => 0.0,
        Some(Mixing::Share(share)) => share * inlet().map_or(0.0, |inlet| (inlet - flow).max(0.0)) / flow,
    };
    ThermalFlows { power, flow, carried_over }
}

/// The temperature to a tenth of a kelvin [K].
pub(crate) fn rounded(temperature: f64) -> f64 {
    // That of the ice point is a tenth and a twentieth.
    (10.0 * (temperature - 0.05)).round() / 10.0 + 0.05
}
