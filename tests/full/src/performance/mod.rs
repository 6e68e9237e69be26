//! How fast the program is: one function for each thing that is timed, and the page `docs/performance.md`.
//!
//! Benches (`tests/full/benches/paths.rs`) and page (`commands/performance.rs`) time the same functions. Reading order:
//! [`films`] (what is solved), [`phases`] (the parts of a solve, one a function), [`machine`] (what this machine can
//! do), [`floor`] (what a part must move and do, and how long that takes at least), [`process`] (the whole program),
//! [`bearings`] (engineers' cases), [`clock`], [`page`] with its tables.
//!
//! A new path is a function in [`phases`] or [`process`], its floor, a group in the benches, and a row of the page.

pub mod bearings;
pub mod clock;
pub mod figures;
pub mod films;
pub mod floor;
pub mod gate;
pub mod machine;
pub mod page;
pub mod peers;
pub mod phase_table;
pub mod phases;
pub mod process;
