//! Error bars: where an error comes from, and the meshes on the way to a tolerance.

use serde::Serialize;

use super::in_parts;

/// Where the error of a quantity comes from, all in its unit. The half width of its bar is their sum.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize)]
pub struct ErrorParts {
    /// Of the pressure's shape on the triangles.
    pub discretisation: f64,
    /// Of the place of the cavity's edge.
    pub front: f64,
    /// Of oil that triangles across the flow spread.
    pub transport: f64,
    /// Of the liner's shape as the triangles have it.
    pub geometry: f64,
    /// Of the nonlinear iteration, where it was ended.
    pub nonlinear: f64,
    /// Of rounding in the linear solves.
    pub algebra: f64,
    /// Of the journal's position, where it was sought.
    pub position: f64,
    /// Of the film's temperature, where it was sought.
    pub temperature: f64,
}

impl ErrorParts {
    /// The parts by the names of their fields.
    pub fn by_name(&self) -> [(&'static str, f64); 8] {
        [
            ("discretisation", self.discretisation),
            ("front", self.front),
            ("transport", self.transport),
            ("geometry", self.geometry),
            ("nonlinear", self.nonlinear),
            ("algebra", self.algebra),
            ("position", self.position),
            ("temperature", self.temperature),
        ]
    }

    /// Half width of the bar: the sum of the parts.
    pub fn sum(&self) -> f64 {
        self.by_name().iter().map(|(_, part)| part).sum()
    }
}

/// How a mesh came from the one before.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Refinement {
    /// The first mesh: that of the file, or the one made of the liner described.
    #[default]
    Given,
    /// Every triangle was divided.
    Uniform,
    /// Triangles were divided where the error comes from.
    Local,
}

/// One mesh on the way to a tolerance.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct LevelFacts {
    /// Nodes whose pressure was sought.
    pub unknowns: usize,
    /// Triangles.
    pub cells: usize,
    /// How the mesh came from the one before.
    pub refinement: Refinement,
    /// Bars on this mesh, by name of quantity and in its unit; an object in JSON.
    #[serde(serialize_with = "in_parts")]
    pub errors: Vec<(String, f64)>,
    /// Wall time of this mesh [s].
    pub seconds: f64,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_bar_is_the_sum_of_its_parts() {
        let parts = ErrorParts {
            discretisation: 1.0,
            front: 2.0,
            transport: 0.0,
            geometry: 4.0,
            nonlinear: 8.0,
            algebra: 16.0,
            position: 32.0,
            temperature: 64.0,
        };
        assert_eq!(parts.sum(), 127.0);
        let json = serde_json::to_value(parts).expect("numbers");
        assert!(parts.by_name().iter().all(|(name, value)| json[name] == *value));
    }

    #[test]
    fn a_level_is_told_by_name() {
        let level = LevelFacts {
            unknowns: 5,
            cells: 4,
            refinement: Refinement::Local,
            errors: vec![("load".into(), 0.5)],
            seconds: 0.25,
        };
        let wanted = serde_json::json!({
            "unknowns": 5, "cells": 4, "refinement": "local", "errors": { "load": 0.5 }, "seconds": 0.25
        });
        assert_eq!(serde_json::to_value(level).expect("numbers"), wanted);
    }
}
