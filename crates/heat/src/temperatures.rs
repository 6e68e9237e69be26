//! Temperatures of a film, its walls and its feeds.

use crate::{BushSide, FilmNetwork, Layers};

/// Temperatures [K] that balance the heat of a network.
#[derive(Debug, Clone, PartialEq)]
pub struct LayerTemperatures {
    /// Temperatures at the points of cell after cell, from the bush to the journal, walls included.
    pub layers: Vec<f64>,
    /// Temperature of the journal, where it has one.
    pub journal: Option<f64>,
    /// Amplitudes of the modes of the bush above the surroundings; empty where the bush is no ring.
    pub bush: Vec<f64>,
    /// Temperatures of the oil in feeds.
    pub feeds: Vec<f64>,
}

impl LayerTemperatures {
    /// Temperatures of the points of a cell.
    pub fn of_cell(&self, layers: &Layers, cell: usize) -> &[f64] {
        let points = layers.points.len();
        &self.layers[cell * points..(cell + 1) * points]
    }

    /// Highest temperature of all points.
    pub fn highest(&self) -> f64 {
        self.layers.iter().copied().fold(f64::NEG_INFINITY, f64::max)
    }

    /// Temperature of the bore of the bush at an angle [rad] and a place z/L;
    /// `None` where the bush has no temperature away from cells.
    pub fn bush_at(&self, network: &FilmNetwork, angle: f64, along: f64) -> Option<f64> {
        match &network.bush {
            BushSide::Adiabatic => None,
            BushSide::Fixed(temperature) => Some(*temperature),
            BushSide::Ring(ring) => Some(ring.temperature(&self.bush, angle, along)),
        }
    }
}
