//! The bar of a temperature found, and what it adds to those of all other numbers.

use super::{HeatFound, balance, film_heat, is_of_heat};
use crate::bars::is_given;
use crate::compile::Study;
use crate::measure::Measured;
use crate::result::{ErrorParts, Quantity};

impl HeatFound {
    /// Bar [K] of the temperature: those of friction and flow, over the slope of their balance. None where they have none.
    fn bar(&self, study: &Study, quantities: &[Quantity]) -> Option<f64> {
        let heat = study.heat?;
        let film = &self.balanced.film;
        let carried = balance(&heat).carried(self.balanced.temperature, film);
        // Of a film whose ends take oil in too the side flow is less than what leaves, and of a sealed one there is none.
        let flow = match film.flow > 0.0 {
            true => flow_error(quantities)? / film.flow,
            false => 0.0,
        };
        let power = power_error(quantities)?;
        let bar = (power + carried.abs() * flow + self.balanced.surplus.abs()) / self.balanced.slope.abs();
        bar.is_finite().then_some(bar)
    }

    /// Gives the quantities of the balance their bars, and adds to all others what the bar of the temperature makes of them.
    pub fn widen(&self, study: &Study, measured: &Measured, quantities: &mut [Quantity]) {
        if quantities.iter().all(|quantity| quantity.error.is_none()) {
            return;
        }
        let bar = self.bar(study, quantities);
        let balance = study.heat.map(|heat| balance(&heat));
        let (power, flow) = (power_error(quantities), flow_error(quantities));
        let film = study.heat.map(|heat| film_heat(&heat, study, measured));
        for quantity in quantities {
            if quantity.value == 0.0 && is_of_heat(&quantity.name) {
                (quantity.error, quantity.error_parts) = (Some(0.0), Some(ErrorParts::default()));
                continue;
            }
            let per_kelvin = match (quantity.name.as_str(), balance, film) {
                ("temperature_effective", ..) => Some(1.0),
                ("temperature_inlet" | "temperature_outlet", Some(balance), Some(film)) => {
                    let [inlet, outlet] = balance.ends(balance.inlet + 1.0, film.carried_over);
                    let end = if quantity.name == "temperature_inlet" {
                        inlet
                    } else {
                        outlet
                    };
                    Some(end - balance.inlet)
                }
                ("heat_housing", Some(balance), _) => balance.housing.map(|housing| housing.conductance),
                // What friction makes and the housing does not take.
                ("heat_carried", Some(balance), _) => Some(
                    balance.housing.map_or(0.0, |housing| housing.conductance)
                        + self.slope("friction_power")
                        + self.squeeze_slope(),
                ),
                (name, ..) if is_given(name) && name != "viscosity_effective" => Some(0.0),
                (name, ..) => Some(self.slope(name)),
            };
            let own = match quantity.name.as_str() {
                "heat_carried" => power,
                "cooling_flow" => flow,
                _ => quantity.error,
            };
            let widened = own
                .zip(bar)
                .zip(per_kelvin)
                .map(|((own, bar), per_kelvin)| (own, bar * per_kelvin.abs()));
            match widened.filter(|(own, part)| (own + part).is_finite()) {
                Some((own, part)) => {
                    let mut parts = quantity.error_parts.unwrap_or_default();
                    if matches!(quantity.name.as_str(), "heat_carried" | "cooling_flow") {
                        parts = ErrorParts {
                            discretisation: own,
                            ..ErrorParts::default()
                        };
                    }
                    parts.temperature = part;
                    quantity.error = Some(parts.sum());
                    quantity.error_parts = Some(parts);
                }
                None => (quantity.error, quantity.error_parts) = (None, None),
            }
        }
    }

    /// That of the power of a moving centre [W/K], zero where none moves.
    fn squeeze_slope(&self) -> f64 {
        self.slopes.get("squeeze_power").copied().unwrap_or(0.0)
    }

    fn slope(&self, name: &str) -> f64 {
        self.slopes.get(name).copied().unwrap_or(f64::NAN)
    }
}

fn error(quantities: &[Quantity], name: &str) -> Option<Option<f64>> {
    let quantity = quantities.iter().find(|quantity| quantity.name == name)?;
    Some(quantity.error)
}

/// Bar [W] of what heats the film.
fn power_error(quantities: &[Quantity]) -> Option<f64> {
    let parts = ["friction_power", "squeeze_power"].map(|name| error(quantities, name).unwrap_or(Some(0.0)));
    Some(parts[0]? + parts[1]?)
}

/// Bar [m3/s] of what carries heat off: that of the side flow, zero where there is none.
fn flow_error(quantities: &[Quantity]) -> Option<f64> {
    error(quantities, "side_flow").unwrap_or(Some(0.0))
}
