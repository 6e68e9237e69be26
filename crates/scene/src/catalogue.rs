//! The catalogue of the keys of a scene: one row each, in the source file of its table.
//!
//! The rows stand beside the code that reads the keys; a test keeps them equal to what the readers ask for. The schema,
//! `oilwedge explain` and `docs/reference/scene.md` are made of them.

use crate::keys::Key;

/// The keys of each table, in the order of the reference page.
#[rustfmt::skip]
static TABLES: &[&[Key]] = &[
    crate::scene::KEYS,
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
    crate::limits::KEYS,
    crate::criteria::KEYS,
    crate::cavitation::KEYS,
    crate::contact::KEYS,
    crate::roughness::KEYS,
    crate::liner::KEYS,
    crate::dynamics::KEYS,
    crate::cap::KEYS,
    crate::sweep::KEYS,
    crate::crankshaft::KEYS,
    crate::crankshaft::piece::KEYS,
    crate::crankshaft::bearing::KEYS,
    crate::crankshaft::weight::KEYS,
];

/// All keys of scenes, in the order of the reference page.
pub fn keys() -> impl Iterator<Item = &'static Key> {
    TABLES.iter().copied().flatten()
}

#[cfg(test)]
mod tests;
