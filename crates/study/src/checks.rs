//! What a scene must be so that it can be computed, beyond the ranges of its keys: the checks that need physics or the
//! catalogue of quantities.

mod columns;
mod feed;
mod journal;
mod oil;
mod tolerance;

use std::path::Path;

use oilwedge_scene::{Check, Complaint, Scene, SceneError};

pub use columns::check_columns;
pub use tolerance::targets;

/// All checks.
pub const CHECKS: [Check; 5] = [oil::check, feed::check, journal::check, tolerance::check, columns::check];

/// Reads the scene in the file `path` with all checks.
///
/// # Errors
/// As [`Scene::read`].
pub fn read(path: &Path) -> Result<Scene, SceneError> {
    Scene::read(path, &CHECKS)
}

/// Reads the scene `text` with all checks; `path` is where it stands.
///
/// # Errors
/// As [`Scene::parse`].
pub fn parse(text: &str, path: &Path) -> Result<Scene, SceneError> {
    Scene::parse(text, path, &CHECKS)
}

/// Why a scene that was made of another one cannot be computed.
pub fn complaints(scene: &Scene) -> Vec<Complaint> {
    scene.complaints(&CHECKS)
}

#[cfg(test)]
mod tests;
