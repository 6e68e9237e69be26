//! The ways to more accuracy that are compared.

use serde::{Deserialize, Serialize};

use oilwedge_study::model::Model;

/// How accuracy is bought.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Strategy {
    /// Linear elements, every triangle divided into four from level to level.
    P1Uniform,
    /// Quadratic elements, likewise.
    P2Uniform,
    /// Quadratic elements, triangles divided where the error of the goal comes from.
    P2Adaptive,
}

impl Strategy {
    /// Degree of the pressure.
    pub fn degree(self) -> usize {
        match self {
            Self::P1Uniform => 1,
            Self::P2Uniform | Self::P2Adaptive => 2,
        }
    }

    /// Name for people.
    pub fn name(self) -> &'static str {
        match self {
            Self::P1Uniform => "P1 uniform",
            Self::P2Uniform => "P2 uniform",
            Self::P2Adaptive => "P2 adaptive",
        }
    }

    /// Name in files.
    pub fn key(self) -> &'static str {
        match self {
            Self::P1Uniform => "p1_uniform",
            Self::P2Uniform => "p2_uniform",
            Self::P2Adaptive => "p2_adaptive",
        }
    }

    /// The order s of the error of a load, `error ~ unknowns^-s`: that of the bar on quadratic elements, 1 on linear
    /// ones.
    pub fn order(self, model: &Model) -> f64 {
        match self.degree() {
            1 => 1.0,
            _ => model.sockets.cavitation.convergence_order(&model.lubricant(&model.oil).pressure_law),
        }
    }
}
