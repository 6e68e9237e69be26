//! The folder of a film's characteristics: `characteristics.json`, written whole or not at all.

use std::ffi::OsStr;
use std::path::Path;

use crate::json::json;
use crate::{Error, folder};
use oilwedge_campaign::characteristics::Characteristics;

/// Everything that was found, for scripts.
pub const FILE: &str = "characteristics.json";

/// Whether the file may stand in the folder `dir`: better asked before the films than after them.
///
/// # Errors
/// `dir` is no folder, or a folder stands in the place of the file.
pub fn check(dir: &Path) -> Result<(), Error> {
    folder::check(dir, [OsStr::new(FILE)].into_iter())
}

/// Writes the file into the folder `dir`, which is made if need be; an earlier one is replaced.
///
/// # Errors
/// A number is not finite, or the system refuses; the old file is then left as it was.
pub fn write(dir: &Path, characteristics: &Characteristics) -> Result<(), Error> {
    let text = json(characteristics)?;
    folder::replace(dir, &[(OsStr::new(FILE), Some(text.as_bytes()))])
}
