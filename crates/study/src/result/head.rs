//! The beginning of every file of results: the scene, the program, and how the run ended.

use serde::{Deserialize, Serialize};

use super::Status;

/// Scene and program of a result, and the end of the run. A key that a file does not have is empty.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct ResultHead {
    /// Name and version of the form of the file.
    pub format: String,
    /// Title of the scene.
    pub title: String,
    /// Version of the program.
    pub version: String,
    /// The text of the scene.
    pub scene: String,
    /// SHA-256 of the scene's text, hexadecimal.
    pub scene_sha256: String,
    /// SHA-256 of the mesh file, hexadecimal; absent in JSON where the result is not that of one mesh.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mesh_sha256: Option<String>,
    /// How the run ended.
    pub status: Status,
    /// Why there is no solution, or why it was not reached.
    pub reason: Option<String>,
}

impl ResultHead {
    /// The head of a file of this format about a scene with this title, text and SHA-256, of a run that converged.
    pub fn of(format: &str, [title, scene, scene_sha256]: [&str; 3]) -> Self {
        Self {
            format: format.to_owned(),
            title: title.to_owned(),
            version: env!("CARGO_PKG_VERSION").to_owned(),
            scene: scene.to_owned(),
            scene_sha256: scene_sha256.to_owned(),
            mesh_sha256: None,
            status: Status::Converged,
            reason: None,
        }
    }

    /// Ends the run in this way, for a reason.
    pub fn end(&mut self, status: Status, reason: impl ToString) {
        (self.status, self.reason) = (status, Some(reason.to_string()));
    }
}
