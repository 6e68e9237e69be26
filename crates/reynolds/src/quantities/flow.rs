//! # Oil flow through the places of given pressure
//!
//! **Equation.** `Q_i = -Int J . grad phi_i` [m3/s]: the residual of the discrete equation at a given
//! node is the volume that enters the film there, so flows sum to zero (nothing is differentiated).
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | Q of a region | m3/s | `net`, `inward`, `outward` |
//!
//! **Source.** Hughes, Engel, Mazzei, Larson, J. Comput. Phys. 163 (2000) 467.
//! **Range.** A balance for the conservative form only: the as-printed form makes oil, and Guembel's
//! clip comes after the solve. **Verified by** `flows_balance` in the tests of the scenes.

use crate::{FilmProblem, FilmSolution, FilmSystem};

/// Volume flow [m3/s] of one region, into the film.
#[derive(Debug, Clone, PartialEq)]
pub struct RegionFlow {
    /// Name of the region.
    pub name: String,
    /// Net flow into the film [m3/s].
    pub net: f64,
    /// The part that enters [m3/s].
    pub inward: f64,
    /// The part that leaves [m3/s].
    pub outward: f64,
}

/// All flows.
#[derive(Debug, Clone, PartialEq)]
pub struct Flows {
    /// One entry a region of the supply.
    pub regions: Vec<RegionFlow>,
    /// Sum of all that enters [m3/s].
    pub throughput: f64,
    /// Sum of the net flows of all nodes over the throughput: the error of the oil balance.
    pub imbalance: f64,
}

/// A throughput below this part of the flow that the film could have is rounding.
const STILL: f64 = 1e-12;

/// Flow [m3/s] that speed or given pressures would drive through the clearance.
fn natural_flow(problem: &FilmProblem, system: &FilmSystem) -> f64 {
    let (bearing, journal) = (&problem.bearing, &problem.journal);
    let heads = system
        .supply
        .regions()
        .iter()
        .map(|region| (region.pressure - bearing.end_pressure).abs());
    let driven = bearing.clearance.powi(3) / (12.0 * problem.lubricant.viscosity) * heads.fold(0.0, f64::max);
    0.5 * (journal.speed * bearing.radius).abs() * bearing.clearance * bearing.length + driven
}

/// Flows of a solved film.
pub fn flows(problem: &FilmProblem, system: &FilmSystem, film: &FilmSolution) -> Flows {
    let mut regions: Vec<RegionFlow> = (system.supply.regions().iter())
        .map(|region| RegionFlow {
            name: region.name.clone(),
            net: 0.0,
            inward: 0.0,
            outward: 0.0,
        })
        .collect();
    for (dof, &inflow) in film.inflow.iter().enumerate() {
        if let Some(region) = system.supply.owner(dof) {
            let flow = &mut regions[region];
            flow.net += inflow;
            flow.inward += inflow.max(0.0);
            flow.outward += (-inflow).max(0.0);
        }
    }
    let throughput: f64 = regions.iter().map(|region| region.inward).sum();
    let net: f64 = regions.iter().map(|region| region.net).sum();
    Flows {
        imbalance: if throughput > STILL * natural_flow(problem, system) {
            (net / throughput).abs()
        } else {
            0.0
        },
        regions,
        throughput,
    }
}
