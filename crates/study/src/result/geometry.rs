//! The shape of the bearing, as much of it as a picture of the film needs.

use serde::{Deserialize, Serialize};

use crate::model::Model;

/// The liner and the turning of its journal.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Geometry {
    /// Radius R of the liner [m].
    pub radius: f64,
    /// Length B [m].
    pub length: f64,
    /// Radial clearance c [m].
    pub clearance: f64,
    /// Angles at which an arc begins and ends [deg]; `null` for a ring.
    pub arc: Option<[f64; 2]>,
    /// Angle at which the film of a ring is cut [deg]; `null` where it is not.
    pub film_start: Option<f64>,
    /// Angular speed of the journal against the clock [rad/s].
    pub speed: f64,
}

impl Geometry {
    /// The geometry of a model.
    pub fn of(model: &Model) -> Self {
        let (outline, bearing) = (&model.mesh.outline, &model.mesh.bearing);
        Self {
            radius: bearing.radius,
            length: bearing.length,
            clearance: bearing.clearance,
            arc: outline.liner.arc.map(|(from, to)| [from.to_degrees(), to.to_degrees()]),
            film_start: outline.film_start.map(f64::to_degrees),
            speed: model.scope.speed,
        }
    }
}
