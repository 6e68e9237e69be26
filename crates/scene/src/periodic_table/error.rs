//! Why a file is not a table of the wanted kind.

use std::path::{Path, PathBuf};

/// A file that is not a table of the wanted kind.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("the table {}{}: {message}; {help}", path.display(), line.map_or(String::new(), |line| format!(", line {line}")))]
pub struct TableError {
    /// The file.
    pub path: PathBuf,
    /// The line that is meant, counted from 1, if it is one.
    pub line: Option<usize>,
    /// What is wrong.
    pub message: String,
    /// The way out.
    pub help: String,
}

/// What is wrong with the text of a table.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct TableFault {
    line: Option<usize>,
    message: String,
    help: String,
}

impl TableFault {
    /// A fault of a line, counted from 1.
    pub(crate) fn at(line: usize, message: impl Into<String>, help: impl Into<String>) -> Self {
        Self { line: Some(line), ..Self::of_all(message, help) }
    }

    /// A fault of the whole table.
    pub(crate) fn of_all(message: impl Into<String>, help: impl Into<String>) -> Self {
        Self { line: None, message: message.into(), help: help.into() }
    }

    pub(crate) fn in_file(self, path: &Path) -> TableError {
        let Self { line, message, help } = self;
        let path = path.to_path_buf();
        TableError { path, line, message, help }
    }
}
