//! How the temperature of a film is found: what the balance of its heat is made of.

use oilwedge_bearing::ThermalBalance;
use oilwedge_bearing::heat_round::HeatSurroundings;
use oilwedge_heat::Layers;
use oilwedge_scene::{EngineKind, Mixing};

/// A film whose temperature is found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ThermalModel {
    /// The balance that the temperature closes.
    pub balance: ThermalBalance,
    /// Hot oil that is carried over; `None`: the film gets fresh oil.
    pub mixing: Option<Mixing>,
    /// The engine whose usual values are compared.
    pub engine: Option<EngineKind>,
}

/// A film whose temperatures are found at each place and across it.
#[derive(Debug, Clone)]
pub struct HeatFieldModel {
    /// What surrounds the film.
    pub surroundings: HeatSurroundings,
    /// Points across the film; `None`: as many as its Graetz number asks for.
    pub layers: Option<Layers>,
    /// The balance of the one temperature with which the search begins.
    pub even: ThermalModel,
}
