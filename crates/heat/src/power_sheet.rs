//! # Power sheet: where the heat of friction goes
//!
//! **Equation.** `power = carried + bush + journal + left`, with
//! ```text
//! carried   rho c (sum of Q T through openings - sum of Q_s T_s of supplies)
//! bush      C_00 A b_00          journal   G (T_j - T_a)
//! ```
//! | symbol | unit | code |
//! |---|---|---|
//! | power, carried, bush, journal, left | W | fields of [`PowerSheet`] |
//!
//! **Source.** The sum of all rows of [`crate::solve`].
//! **Range.** Any network whose oil balances; what is left is rounding and the tolerance of the solver.
//! **Verified by** `crates/heat/tests/ring.rs`.

use crate::{BushSide, FilmNetwork, JournalSide, LayerProfile, LayerTemperatures, Layers, PortKind};

/// Heat of a film [W].
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct PowerSheet {
    /// Heat of friction.
    pub power: f64,
    /// Heat that oil carries away, above that with which it comes.
    pub carried: f64,
    /// Heat into the bush.
    pub bush: f64,
    /// Heat into the journal.
    pub journal: f64,
    /// What is left; zero but for rounding and the tolerance of the solver.
    pub left: f64,
    /// Temperature [K] of the oil that leaves through openings, weighted by flow; `None` where no oil leaves.
    pub outlet: Option<f64>,
}

impl PowerSheet {
    /// The sheet of `temperatures`, for what films give to the points at the bush and at the journal [W].
    pub(crate) fn new(
        network: &FilmNetwork,
        layers: &Layers,
        profiles: &[LayerProfile],
        temperatures: &LayerTemperatures,
        to_walls: [f64; 2],
    ) -> Self {
        let reference = network.reference();
        let (mut carried, mut out, mut out_power) = (0.0, 0.0, 0.0);
        let mut from_supply = vec![0.0; network.feeds.len()];
        for port in &network.ports {
            let profile = &profiles[port.cell];
            let flow = profile.flows(profile, port.dragged, port.driven);
            match port.kind {
                PortKind::Feed(feed) => from_supply[feed] += flow.iter().sum::<f64>(),
                PortKind::Opening { temperature } => {
                    for (flow, own) in flow.iter().zip(temperatures.of_cell(layers, port.cell)) {
                        if *flow < 0.0 {
                            out -= flow;
                            out_power -= flow * (own - reference);
                        } else {
                            carried -= network.oil.capacity * flow * (temperature - reference);
                        }
                    }
                }
            }
        }
        carried += network.oil.capacity * out_power;
        for ((supply, flow), own) in network.feeds.iter().zip(&from_supply).zip(&temperatures.feeds) {
            let temperature = if *flow > 0.0 { supply.temperature } else { *own };
            carried -= network.oil.capacity * flow * (temperature - reference);
        }
        let bush = match &network.bush {
            BushSide::Adiabatic => 0.0,
            BushSide::Fixed(_) => to_walls[0],
            BushSide::Ring(ring) => ring.conductances[0] * temperatures.bush[0],
        };
        let journal = match (network.journal, temperatures.journal) {
            (JournalSide::Turning { conductance, ambient }, Some(own)) => conductance * (own - ambient),
            (JournalSide::Fixed(_), _) => to_walls[1],
            _ => 0.0,
        };
        let power = network.cells.iter().map(|cell| cell.shear_power + cell.driven_power).sum::<f64>();
        let outlet = (out > 0.0).then(|| reference + out_power / out);
        Self { power, carried, bush, journal, left: power - carried - bush - journal, outlet }
    }
}
