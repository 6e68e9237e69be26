//! How often error bars hold: bearings by chance and shipped scenes, solved on meshes of several sizes and compared with
//! far finer ones.
//!
//! | file | what |
//! |---|---|
//! | `bearings` | the bearings of a seed, by family |
//! | `meshes` | each on several meshes, drawn and locally refined |
//! | `reference` | its numbers on a mesh refined for all of them |
//! | `tally` | how often and how closely bars hold |

pub mod bearings;
pub mod meshes;
pub mod reference;
