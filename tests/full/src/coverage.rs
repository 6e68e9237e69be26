//! How often error bars hold: bearings by chance and shipped scenes, solved on meshes of several sizes and compared
//! with far finer ones.
//!
//! | file | what |
//! |---|---|
//! | `bearings` | the bearings of a seed, by family |
//! | `meshes` | each on several meshes, drawn and locally refined |
//! | `reference` | its numbers on a mesh refined for all of them |
//! | `tally` | how often and how closely bars hold |
//! | `tolerances` | tolerances asked for and what they cost |
//! | `page` | the tables of `docs/validation/accuracy.md` |

pub mod bearings;
pub mod meshes;
pub mod page;
pub mod reference;
pub mod tally;
pub mod tolerances;
