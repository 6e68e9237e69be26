//! The book does what it says: its blocks run, its links lead somewhere, its list of chapters is whole, and it needs no
//! network.

mod built;
mod gallery;
mod links;
mod marks;
mod run;

use std::path::Path;

use oilwedge_full::book::files_below;

/// Path and text of the files below a folder whose names end so.
fn texts_below(folder: &Path, endings: &[&str]) -> Vec<(String, String)> {
    let files = files_below(folder).into_iter();
    let wanted = files.filter(|path| path.extension().is_some_and(|own| endings.iter().any(|ending| own == *ending)));
    wanted.map(|path| (path.display().to_string(), std::fs::read_to_string(&path).expect("a text"))).collect()
}
