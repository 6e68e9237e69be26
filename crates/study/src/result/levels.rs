//! The meshes on the way to a tolerance.

use serde::{Deserialize, Serialize};

use super::in_order;

/// How a mesh came from the one before.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Refinement {
    /// The first mesh: that of the file, or the one made of the liner described.
    #[default]
    Given,
    /// Every triangle was divided.
    Uniform,
    /// The liner was meshed again with shorter edges.
    Drawn,
    /// Triangles were divided where the error comes from.
    Local,
}

impl Refinement {
    /// Name of the refinement in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Given => "given",
            Self::Uniform => "uniform",
            Self::Drawn => "drawn",
            Self::Local => "local",
        }
    }
}

/// One mesh on the way to a tolerance.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct LevelFacts {
    /// Nodes whose pressure was sought.
    pub unknowns: usize,
    /// Triangles.
    pub cells: usize,
    /// How the mesh came from the one before.
    pub refinement: Refinement,
    /// Bars on this mesh, by name of quantity and in its unit; an object in JSON.
    #[serde(with = "in_order")]
    pub errors: Vec<(String, f64)>,
    /// Wall time of this mesh [s].
    pub seconds: f64,
}

#[cfg(test)]
mod tests {
    use super::*;

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
