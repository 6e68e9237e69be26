//! The pages of the book: the blocks of code in them, and their links.

pub mod blocks;
pub mod links;

use std::path::{Path, PathBuf};

use oilwedge_tests::program::repository;

/// The list of chapters.
pub const SUMMARY: &str = "docs/SUMMARY.md";
/// The page at the root of the repository.
pub const README: &str = "README.md";

/// A page.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Page {
    /// Path of the page below the repository, with `/`.
    pub path: String,
    /// Text of the page.
    pub text: String,
}

impl Page {
    /// The page at this path below the repository.
    ///
    /// # Panics
    /// It cannot be read.
    pub fn read(path: &str) -> Self {
        let text = std::fs::read_to_string(repository().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"));
        Self { path: path.to_owned(), text }
    }
}

/// README and all pages below `docs`, the list of chapters too.
///
/// # Panics
/// One cannot be read.
pub fn pages() -> Vec<Page> {
    let root = repository();
    let mut pages = vec![Page::read(README)];
    for path in files_below(&root.join("docs")) {
        if path.extension().is_some_and(|ending| ending == "md") {
            let relative = path.strip_prefix(&root).expect("a page of the repository");
            let names: Vec<_> = relative.iter().map(|name| name.to_string_lossy()).collect();
            pages.push(Page::read(&names.join("/")));
        }
    }
    pages.sort();
    pages
}

/// All files below a folder.
///
/// # Panics
/// A folder cannot be read.
pub fn files_below(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display())) {
        let path = entry.expect("an entry").path();
        match path.is_dir() {
            true => found.extend(files_below(&path)),
            false => found.push(path),
        }
    }
    found
}
