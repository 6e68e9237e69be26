//! Why a scene is not read.

use std::path::PathBuf;

use crate::Complaint;

/// Why a scene is not read.
#[derive(Debug, thiserror::Error)]
pub enum SceneError {
    /// The file does not exist or may not be read.
    #[error("cannot read the scene {}: {source}; give the path of a scene in TOML", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// The system's message.
        source: std::io::Error,
    },
    /// The path names a directory, a device or a pipe.
    #[error("the scene {} is not a plain file; give the path of a scene in TOML", path.display())]
    NotAFile {
        /// The path.
        path: PathBuf,
    },
    /// The file is far larger than any scene.
    #[error("the scene {} is larger than {limit} bytes, so it is no scene; is it a mesh or a result?", path.display())]
    TooLarge {
        /// The file.
        path: PathBuf,
        /// The largest size that is read [bytes].
        limit: u64,
    },
    /// The file is a mesh.
    #[error(
        "{} is a gmsh mesh, not a scene; a scene names it as file below [mesh] (by itself it can be checked if its name ends in .msh: oilwedge check NAME.msh)",
        path.display()
    )]
    Mesh {
        /// The file.
        path: PathBuf,
    },
    /// The file is the scene of a crankshaft, where that of one bearing is wanted.
    #[error("the scene {} is that of a crankshaft, not of one bearing; oilwedge solve, oilwedge sweep and oilwedge check read it, and it names the scenes of its bearings", path.display())]
    Crankshaft {
        /// The file.
        path: PathBuf,
    },
    /// The file is not text.
    #[error("the scene {} is not UTF-8 text (first wrong byte: {offset}); save it as UTF-8", path.display())]
    NotText {
        /// The file.
        path: PathBuf,
        /// Offset of the first wrong byte.
        offset: usize,
    },
    /// The text is not TOML.
    #[error("the scene {} is not valid TOML{}", path.display(), list(complaints))]
    Syntax {
        /// The file.
        path: PathBuf,
        /// Text of the file.
        text: String,
        /// All faults, in the order of the text; their key is empty.
        complaints: Vec<Complaint>,
    },
    /// The TOML is not a scene that can be computed.
    #[error("the scene {} cannot be used{}", path.display(), list(complaints))]
    Complaints {
        /// The file.
        path: PathBuf,
        /// Text of the file.
        text: String,
        /// All complaints, in the order of the text.
        complaints: Vec<Complaint>,
    },
}

fn list(complaints: &[Complaint]) -> String {
    complaints.iter().map(|complaint| format!("\n  {complaint} ({})", complaint.help)).collect()
}
