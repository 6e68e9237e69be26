//! A sweep that several runs share: each computes a part in a folder of its own, and one joins their tables.
//!
//! Runs do not share a file, so that they need no locks and may be on other machines. A part is a sweep in its folder:
//! it survives a kill like one.

use std::collections::BTreeSet;
use std::io;
use std::path::{Path, PathBuf};

use oilwedge_campaign::sweep::{Part, Sweep};

use super::SweepError;
use super::files::{Earlier, TABLE_FILE, case_of};
use super::report::{Identity, SweepReport};
use super::table::TextRow;

/// Folder of the parts, below that of the sweep.
pub const PARTS_FOLDER: &str = "parts";
/// Word between the number of a part and how many there are.
const OF: &str = "-of-";
/// Least digits of both, so that parts are listed in their order.
const DIGITS: usize = 3;

/// Folder of a part of the sweep in the folder `dir`, such as `parts/003-of-040`.
pub fn part_folder(dir: &Path, part: Part) -> PathBuf {
    dir.join(PARTS_FOLDER).join(name(part))
}

fn name(part: Part) -> String {
    let (number, of) = (part.number(), part.of());
    let width = of.to_string().len().max(DIGITS);
    format!("{number:0width$}{OF}{of:0width$}")
}

/// The part whose folder has this name.
fn part_named(text: &str) -> Option<Part> {
    let (number, of) = text.split_once(OF)?;
    let part = Part::new(number.parse().ok()?, of.parse().ok()?)?;
    (name(part) == text).then_some(part)
}

/// The rows of a whole sweep, in the order of the cases, from its parts below the folder `dir`.
///
/// # Errors
/// Parts are missing or have not ended, belong to other sweeps, or do not have each case once.
pub(super) fn rows_of_parts(sweep: &Sweep, begun: &SweepReport, dir: &Path) -> Result<Vec<TextRow>, SweepError> {
    let of = division(dir)?;
    let (mut missing, mut unfinished) = (Vec::new(), Vec::new());
    let mut rows = Vec::new();
    for (part, cases) in sweep.parts(of) {
        let identity = Identity { part: Some(part), ..begun.identity.clone() };
        let folder = part_folder(dir, part);
        let earlier = Earlier::read(&folder, &identity, &begun.columns);
        let earlier =
            earlier.map_err(|cause| SweepError::Part { part, dir: dir.to_path_buf(), cause: Box::new(cause) })?;
        match earlier {
            None => missing.push(part.number()),
            Some(earlier) if !earlier.is_complete => unfinished.push(part.number()),
            Some(earlier) => {
                let mut own = earlier.rows.iter().map(case_of);
                let wrong = cases.clone().find(|case| own.next() != Some(Some(*case)));
                // A row too many is found as well.
                if let Some(case) = wrong.or_else(|| own.next().map(|_| cases.end)) {
                    return Err(SweepError::Rows {
                        part,
                        dir: dir.to_path_buf(),
                        table: folder.join(TABLE_FILE),
                        case: case + 1,
                    });
                }
                rows.extend(earlier.rows);
            }
        }
    }
    match missing.is_empty() && unfinished.is_empty() {
        true => Ok(rows),
        false => Err(SweepError::Gaps { dir: dir.to_path_buf(), missing, unfinished, of }),
    }
}

/// Number of parts into which the sweep below the folder `dir` is divided.
///
/// # Errors
/// There is no part, or parts of several divisions, or something that is no part.
fn division(dir: &Path) -> Result<u32, SweepError> {
    let folder = dir.join(PARTS_FOLDER);
    let none = || SweepError::NoParts { dir: dir.to_path_buf() };
    let mut divisions = BTreeSet::new();
    let unreadable = |source: io::Error| SweepError::Earlier { path: folder.clone(), source };
    let entries = std::fs::read_dir(&folder).map_err(|error| match error.kind() {
        io::ErrorKind::NotFound => none(),
        _ => unreadable(error),
    })?;
    for entry in entries {
        let entry = entry.map_err(unreadable)?;
        let name = entry.file_name();
        let name = name.to_string_lossy();
        match part_named(&name) {
            Some(part) => _ = divisions.insert(part.of()),
            // What file systems and their tools leave behind.
            None if name.starts_with('.') => {}
            None => return Err(SweepError::NotAPart { path: entry.path() }),
        }
    }
    match divisions.into_iter().collect::<Vec<_>>()[..] {
        [] => Err(none()),
        [of] => Ok(of),
        [first, second, ..] => Err(SweepError::Divisions { folder, divisions: [first, second] }),
    }
}

/// Numbers in their order as people list them, runs as `7-9`.
pub(super) fn listed(numbers: &[u32]) -> String {
    let runs = numbers.chunk_by(|a, b| a + 1 == *b);
    let words = runs.map(|run| match run {
        [first, .., last] => format!("{first}-{last}"),
        [one] => one.to_string(),
        [] => String::new(),
    });
    words.collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_parts_are_read_back_and_no_others() {
        for (number, of, text) in [(3, 40, "003-of-040"), (1, 1, "001-of-001"), (12, 20_000, "00012-of-20000")] {
            let part = Part::new(number, of).expect("a part");
            assert_eq!((name(part).as_str(), part_named(text)), (text, Some(part)));
        }
        for text in ["3-of-40", "003-of-040 (copy)", "041-of-040", "000-of-040", "+03-of-040", "003", "a-of-b"] {
            assert_eq!(part_named(text), None, "{text}");
        }
    }

    #[test]
    fn runs_of_numbers_are_short() {
        assert_eq!(listed(&[3, 7, 8, 9, 12]), "3, 7-9, 12");
        assert_eq!(listed(&[1, 2]), "1-2");
        assert_eq!(listed(&[]), "");
    }
}
