//! Why results are not written. Which argument of the command line helps is said by the command line.

use oilwedge_study::CompileError;
use std::io;
use std::path::{Path, PathBuf};

/// Why a report was not made or not written; files that stood in its place stand there still.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The mesh is unreadable, defective, or not that of the scene.
    #[error(transparent)]
    Compile(#[from] CompileError),
    /// A number is NaN or infinite.
    #[error("{name} is {value}, which is not a finite number; this is a fault of the program, please report the scene")]
    NotFinite {
        /// Name under which the number stands.
        name: String,
        /// The number.
        value: f64,
    },
    /// Two values have one name.
    #[error("{name} is reported twice; this is a fault of the program, please report the scene")]
    Twice {
        /// The name.
        name: String,
    },
    /// A field has another length than the nodes or triangles.
    #[error("the field {name} has {values} values for {wanted} places; this is a fault of the program")]
    Length {
        /// Name of the field.
        name: String,
        /// Length of the array.
        values: usize,
        /// Number of nodes or triangles.
        wanted: usize,
    },
    /// A triangle refers to a node that does not exist.
    #[error("triangle {cell} refers to a node that does not exist; this is a fault of the program")]
    Node {
        /// Number of the triangle.
        cell: usize,
    },
    /// The writer of a file format failed.
    #[error("the {format} cannot be written: {message}; this is a fault of the program, please report the scene")]
    Format {
        /// Name of the format.
        format: &'static str,
        /// The writer's message.
        message: String,
    },
    /// A file is not what this program writes.
    #[error("the {format} cannot be read: {message}")]
    Unreadable {
        /// Name of the format.
        format: &'static str,
        /// What is wrong with it.
        message: String,
    },
    /// The operating system refused.
    #[error("cannot write {}: {source}", path.display())]
    System {
        /// File or folder.
        path: PathBuf,
        /// The system's message.
        source: io::Error,
    },
    /// The folder stays locked: another run keeps writing into it.
    #[error("cannot write into {}: another run has been writing there for some time", path.display())]
    Busy {
        /// The folder.
        path: PathBuf,
    },
    /// A folder stands in the place of a file.
    #[error("cannot write {}: a folder stands there", path.display())]
    Folder {
        /// The path.
        path: PathBuf,
    },
}

impl Error {
    /// The operating system refused to write to `path`.
    pub(crate) fn system(path: &Path) -> impl FnOnce(io::Error) -> Self {
        let path = path.to_path_buf();
        move |source| Self::System { path, source }
    }

    /// The writer of a format failed.
    pub(crate) fn format<E: ToString>(format: &'static str) -> impl Fn(E) -> Self {
        move |error| Self::Format { format, message: error.to_string() }
    }
}
