//! The bar of a temperature found, and what it adds to those of all other numbers.

use oilwedge_reynolds::error_bar::Bar;
use oilwedge_scene::Mixing;

use super::flows::thermal_flows;
use crate::film::Film;
use crate::measure::Measured;
use crate::quantities::{
    COOLING_FLOW, ErrorRule, FRICTION_POWER, INLET_FLOW, MOTION_POWER, Quantity, Row, Table, Warming,
};
use crate::solved::TemperatureFound;

impl TemperatureFound {
    /// Bar [K] of the temperature: those of friction, flow and mixing, over the slope of their balance. None where they
    /// have none.
    fn bar(&self, warming: &Warming) -> Option<f64> {
        let film = &self.balanced.film;
        let carried = warming.balance.carried(self.balanced.temperature, film);
        // From a sealed film nothing leaves.
        let flow = match film.flow > 0.0 {
            true => warming.flow? / film.flow,
            false => 0.0,
        };
        let by_mixing = warming.balance.heat_capacity * film.flow * warming.of_mixing()?;
        let off = warming.power? + carried.abs() * flow + by_mixing + self.balanced.surplus.abs();
        let bar = off / self.balanced.slope.abs();
        bar.is_finite().then_some(bar)
    }

    /// Gives the quantities of the balance their bars, and adds to all others what the bar of the temperature makes of
    /// them.
    pub fn widen(&self, film: &Film, measured: &Measured, quantities: &mut [Quantity]) {
        let Some(model) =
            film.model.sockets.thermal.filter(|_| quantities.iter().any(|quantity| quantity.bar.is_some()))
        else {
            return;
        };
        let flows = thermal_flows(&model, film, measured);
        let flow = error(quantities, &COOLING_FLOW);
        let carried_over = match model.mixing {
            // q_0/q_1 is a share of Q/Q_out - 1.
            Some(Mixing::Share(share)) if flows.flow > 0.0 => {
                let inlet = measured.inlet_flow.unwrap_or(0.0);
                let bars = error(quantities, &INLET_FLOW).zip(flow);
                bars.map(|(of_inlet, of_flow)| {
                    let bar = of_inlet + (inlet / flows.flow).abs() * of_flow;
                    // Where less enters than leaves, nothing goes round.
                    share * (inlet - flows.flow + bar).min(bar).max(0.0) / flows.flow
                })
            }
            _ => Some(0.0),
        };
        let warming = Warming {
            balance: model.balance,
            film: flows,
            temperature: self.balanced.temperature,
            carried_over,
            power: error(quantities, &FRICTION_POWER)
                .zip(error(quantities, &MOTION_POWER))
                .map(|(turning, moving)| turning + moving),
            flow,
            slopes: &self.slopes,
        };
        let temperature = self.bar(&warming);
        for quantity in quantities {
            if quantity.value == 0.0 && quantity.row.table == Table::Temperature {
                quantity.bar = Some(Bar::default());
                continue;
            }
            let (own, per_kelvin) = match quantity.row.error {
                ErrorRule::Exact => (quantity.bar, Some(0.0)),
                ErrorRule::Temperature(per_kelvin) => (quantity.bar, per_kelvin(&warming)),
                ErrorRule::Balance(own, per_kelvin) => (own(&warming).map(Bar::of), per_kelvin(&warming)),
                _ => (quantity.bar, self.slopes.get(&quantity.name).copied()),
            };
            let widened = own.zip(temperature).zip(per_kelvin);
            quantity
                .set_bar(widened.map(|((own, bar), per_kelvin)| Bar { temperature: bar * per_kelvin.abs(), ..own }));
        }
    }
}

/// Half width of the bar of a quantity, zero where there is none such; none without a bar.
fn error(quantities: &[Quantity], row: &Row) -> Option<f64> {
    let quantity = quantities.iter().find(|quantity| quantity.row == row);
    quantity.map_or(Some(0.0), Quantity::error)
}
