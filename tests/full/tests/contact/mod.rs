//! Rough surfaces that touch: the positions of a second code, orbits, verdicts.

pub(crate) mod mixed;
mod orbit;
mod scenes;
