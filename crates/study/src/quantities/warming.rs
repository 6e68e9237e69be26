//! How a film whose temperature is found answers to the error of that temperature.

use std::borrow::Cow;
use std::collections::HashMap;

use oilwedge_bearing::{ThermalBalance, ThermalFlows};

/// What bars of a film whose temperature is found are made of.
#[derive(Debug)]
pub struct Warming<'a> {
    /// The balance.
    pub balance: ThermalBalance,
    /// What heats and what cools the film.
    pub film: ThermalFlows,
    /// Bar [W] of what heats the film; none where it has none.
    pub power: Option<f64>,
    /// Bar [m3/s] of what carries heat off; none where it has none.
    pub flow: Option<f64>,
    /// Bar [1] of what is carried over for each part that leaves; none where it has none.
    pub carried_over: Option<f64>,
    /// Temperature of the film [K].
    pub temperature: f64,
    /// How each number changes with the temperature [1/K], by name.
    pub slopes: &'a HashMap<Cow<'static, str>, f64>,
}

impl Warming<'_> {
    /// How the number of this name changes with the temperature [1/K], as far as it is known.
    pub fn slope(&self, name: &str) -> Option<f64> {
        self.slopes.get(name).copied()
    }

    /// How the temperatures with which oil enters and leaves change with that of the film [1].
    pub fn ends(&self) -> [f64; 2] {
        let ends = self.balance.ends(self.balance.inlet + 1.0, self.film.carried_over);
        ends.map(|end| end - self.balance.inlet)
    }

    /// What the bar of the oil carried over makes of the temperatures with which oil enters and leaves [K].
    pub fn of_mixing(&self) -> Option<f64> {
        let per_unit = (self.balance).ends_per_carried_over(self.temperature, self.film.carried_over);
        Some(self.carried_over? * per_unit.abs())
    }

    /// Conductance of the housing [W/K], if it gives off heat.
    pub fn conductance(&self) -> Option<f64> {
        self.balance.housing.map(|housing| housing.conductance)
    }
}
