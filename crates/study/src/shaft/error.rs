//! Why a scene does not become a shaft on films.

use std::path::PathBuf;

use oilwedge_bearing::shaft::NoShaft;
use oilwedge_scene::SceneError;

use crate::compile_error::CompileError;

/// Why a scene does not become a shaft on films, though it is well written.
#[derive(Debug, thiserror::Error)]
pub enum ShaftError {
    /// The scene asks for the cut shaft itself.
    #[error(
        "statics = \"cut\" in [crankshaft] cuts the shaft already; remove it to have the whole shaft beside the cut one"
    )]
    CutAlready,
    /// The scene of a bearing cannot be used.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The scene of a bearing does not become a film.
    #[error("the scene {} of a bearing: {source}", path.display())]
    Film {
        /// File of the bearing's scene.
        path: PathBuf,
        /// The cause.
        source: CompileError,
    },
    /// The scene of a bearing has what is not solved on a shaft.
    #[error("the scene {} of a bearing: {reason}; {help}", path.display())]
    Refused {
        /// File of the bearing's scene.
        path: PathBuf,
        /// The key or table, and why.
        reason: &'static str,
        /// The way out.
        help: &'static str,
    },
    /// The bearings do not hold the shaft.
    #[error("crankshaft: {0}; correct its pieces and bearings")]
    Shaft(#[from] NoShaft),
    /// The loads of the throws cannot be computed.
    #[error("crank: {0}")]
    Load(String),
}
