//! The heat balance of a scene: what heats the oil and what carries the heat off.

use oilwedge_bearing::{HeatBalance, Housing};

use super::Scene;

/// The film's temperature is first taken to be so much above that of the oil fed [K].
const FIRST_RISE: f64 = 10.0;

/// The heat balance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Heat {
    /// Temperature of the oil that is fed [K].
    pub inlet: f64,
    /// Heat capacity per volume rho c [J/(m3 K)].
    pub heat_capacity: f64,
    /// What the housing gives off; `None`: all heat leaves with the oil.
    pub housing: Option<Housing>,
    /// Hot oil that goes round and mixes with the fresh one; `None`: the film gets fresh oil.
    pub mixing: Option<Mixing>,
    /// The engine that the bearing is one of.
    pub engine: Option<Engine>,
    /// Least film thickness that will do [m].
    pub least_film: f64,
    /// Mean temperature of the film that must not be reached [K].
    pub greatest_temperature: f64,
}

/// How much hot oil is carried over.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Mixing {
    /// So much over the fresh oil, q_0/q_1 [1].
    Ratio(f64),
    /// This share [1] of the oil that the film carries round.
    Share(f64),
}

/// Usual values of an engine's crankshaft bearings.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Engine {
    /// Spark ignition.
    Petrol,
    /// Compression ignition.
    Diesel,
}

impl Engine {
    /// Name in scenes and reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::Petrol => "petrol",
            Self::Diesel => "diesel",
        }
    }

    /// Usual diametral clearance over the diameter [1].
    pub fn clearance_ratio(self) -> [f64; 2] {
        match self {
            Self::Petrol => [0.5e-3, 0.7e-3],
            Self::Diesel => [0.7e-3, 1.0e-3],
        }
    }

    /// Usual pressure of the oil that is fed [Pa].
    pub fn feed_pressure(self) -> [f64; 2] {
        match self {
            Self::Petrol => [0.3e6, 0.4e6],
            Self::Diesel => [0.4e6, 0.6e6],
        }
    }

    /// Its usual temperature [K].
    pub fn inlet(self) -> [f64; 2] {
        match self {
            Self::Petrol => [343.15, 348.15],
            Self::Diesel => [348.15, 353.15],
        }
    }

    /// The middle of a range.
    pub fn middle([from, to]: [f64; 2]) -> f64 {
        0.5 * (from + to)
    }
}

impl Heat {
    /// What is balanced.
    pub fn balance(&self) -> HeatBalance {
        HeatBalance {
            inlet: self.inlet,
            heat_capacity: self.heat_capacity,
            housing: self.housing,
        }
    }

    /// Temperature [K] at which the search for that of the film begins.
    pub fn first_temperature(&self) -> f64 {
        self.inlet + FIRST_RISE
    }
}

impl Scene {
    /// The scene with a film of this temperature [K]; its oil has the viscosity there.
    pub fn at_temperature(&self, temperature: f64) -> Self {
        let mut scene = self.clone();
        scene.oil.heat_to(temperature);
        scene
    }
}
