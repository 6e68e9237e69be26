//! What `oilwedge check` tells about a scene or mesh that can be used.

use oilwedge_mesh::Quality;
use serde::Serialize;

use super::{Effects, MeshFacts, ReportError, finite, in_parts, json};

/// Name and version of the form of what `oilwedge check --json` prints.
pub const CHECK_FORMAT: &str = "oilwedge-check/1";

/// What `oilwedge check` found in a scene or mesh that can be used.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CheckReport {
    /// [`CHECK_FORMAT`].
    pub format: String,
    /// Title of the scene; `None` where a mesh was checked.
    pub title: Option<String>,
    /// The mesh file.
    pub mesh_file: String,
    /// What would be computed; `None` where a mesh was checked.
    pub effects: Option<Effects>,
    /// The mesh.
    pub mesh: MeshFacts,
    /// How small error bars would be made by refinement, relative, by name of quantity; empty without a tolerance.
    #[serde(serialize_with = "in_parts")]
    pub tolerance: Vec<(String, f64)>,
    /// The axes of the sweep and their numbers of values; empty without one.
    #[serde(serialize_with = "in_axes")]
    pub sweep: Vec<(String, usize)>,
    /// The liner in words, a line each; empty where a mesh was checked.
    pub liner: Vec<String>,
    /// The unrolled liner drawn in letters; empty where a mesh was checked.
    pub sketch: String,
    /// How good the mesh is.
    pub quality: Quality,
    /// The named regions of the mesh.
    pub regions: Vec<RegionFacts>,
    /// Unknowns and the entries of the Cholesky factor (8 bytes each): the cost of a solve; `None` where a mesh was checked.
    pub cost: Option<Cost>,
    /// Doubts, in sentences.
    pub warnings: Vec<String>,
}

/// What a solve costs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Cost {
    /// Nodes whose pressure is not given.
    pub unknowns: usize,
    /// Entries of the Cholesky factor.
    pub factor_entries: usize,
}

/// Facts about a named region of a mesh.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct RegionFacts {
    /// Name of the physical group.
    pub name: String,
    /// `curve` or `surface`.
    pub kind: String,
    /// Number of its edges or cells.
    pub parts: usize,
}

fn in_axes<S: serde::Serializer>(axes: &[(String, usize)], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map(axes.iter().map(|(name, values)| (name, values)))
}

impl CheckReport {
    /// The report as JSON, with a line break at its end.
    ///
    /// # Errors
    /// [`ReportError`] where a number is not finite.
    pub fn to_json(&self) -> Result<String, ReportError> {
        finite("mesh.min_angle_deg", self.mesh.min_angle_deg)?;
        json(self)
    }
}
