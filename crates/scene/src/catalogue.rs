//! The catalogue of the keys of a scene: one row each, in the source file of its table.
//!
//! The rows stand beside the code that reads the keys and drive it: a reader asks for a key, and takes form, example
//! and range from its row. The schema, `oilwedge explain` and `docs/reference/scene.md` are made of the rows, too.

use std::collections::HashMap;
use std::sync::LazyLock;

use crate::keys::Key;

keys! {
    "title" = Text; "Plain journal bearing", "the name of the file", "",
        "title of the study in reports";
}

/// The keys of each table, in the order of the reference page.
#[rustfmt::skip]
static TABLES: &[&[Key]] = &[
    KEYS,
    crate::bearing::KEYS,
    crate::bore::KEYS,
    crate::shaft::KEYS,
    crate::mesh::KEYS,
    crate::ends::KEYS,
    crate::feed::KEYS,
    crate::feed::hole::KEYS,
    crate::feed::groove::KEYS,
    crate::journal::KEYS,
    crate::journal::squeeze::KEYS,
    crate::journal::tilt::KEYS,
    crate::load::KEYS,
    crate::load::cycle::KEYS,
    crate::crank::KEYS,
    crate::orbit::KEYS,
    crate::support::KEYS,
    crate::oil::KEYS,
    crate::oil::temperature::KEYS,
    crate::oil::density::KEYS,
    crate::oil::high_shear::KEYS,
    crate::oil::barus::KEYS,
    crate::oil::roelands::KEYS,
    crate::heat::KEYS,
    crate::heat::field::KEYS,
    crate::limits::KEYS,
    crate::criteria::KEYS,
    crate::cavitation::KEYS,
    crate::contact::KEYS,
    crate::roughness::KEYS,
    crate::turbulence::KEYS,
    crate::liner::KEYS,
    crate::dynamics::KEYS,
    crate::cap::KEYS,
    crate::sweep::KEYS,
    crate::design::KEYS,
    crate::crankshaft::KEYS,
    crate::crankshaft::piece::KEYS,
    crate::crankshaft::bearing::KEYS,
    crate::crankshaft::weight::KEYS,
];

/// All keys of scenes, in the order of the reference page.
pub fn keys() -> impl Iterator<Item = &'static Key> {
    TABLES.iter().copied().flatten()
}

/// The rows by the first part of their paths, which no user chooses.
static BY_FIRST_PART: LazyLock<HashMap<&str, Vec<&Key>>> = LazyLock::new(|| {
    let mut rows: HashMap<&str, Vec<&Key>> = HashMap::new();
    keys().for_each(|key| rows.entry(parted(key.path).0).or_default().push(key));
    rows
});

/// The row of the key at a path, whose lists of tables may have numbers, `feed[0].group`; a name that the user chooses
/// may be one of several parts.
pub(crate) fn row(path: &str) -> Option<&'static Key> {
    let rows = BY_FIRST_PART.get(parted(path).0.split('[').next()?)?;
    rows.iter().copied().filter(|key| is_row(key.path, path)).max_by_key(|key| key.path.len())
}

/// The row of the key at a path below `[sweep]`.
pub(crate) fn row_of_axis(path: &str) -> Option<&'static Key> {
    row(&format!("sweep.{path}"))
}

fn is_row(row: &str, path: &str) -> bool {
    let (first, rest) = parted(row);
    let (own, further) = parted(path);
    let is_chosen = first.bytes().all(|letter| letter.is_ascii_uppercase());
    if !is_chosen && own.split('[').next() != Some(first) {
        return false;
    }
    let ends = match (rest, further) {
        (None, None) => true,
        (Some(rest), Some(further)) => is_row(rest, further),
        _ => false,
    };
    ends || is_chosen && further.is_some_and(|further| is_row(row, further))
}

/// The first part of a path, and what follows it.
fn parted(path: &str) -> (&str, Option<&str>) {
    match path.bytes().position(|letter| letter == b'.') {
        Some(end) => (&path[..end], Some(&path[end + 1..])),
        None => (path, None),
    }
}

#[cfg(test)]
mod tests;
