//! Text to scene: a TOML file about one bearing becomes a checked description in SI. The crate knows no film.
//!
//! [`Scene::read`] reads a file and reports everything that is wrong with it at once. A scene never changes; whoever
//! computes passes its own [`Check`]s of what it cannot compute.
//!
//! Each table of the file has one source file of its name, with its data type, keys, units, defaults and ranges:
//! `bearing.rs`, `bore.rs`, `shaft.rs`, `mesh.rs` (and the tolerance in it, `tolerance.rs`), `ends.rs`, `feed.rs`,
//! `journal.rs` (and `squeeze.rs`, `tilt.rs` in it), `load.rs` (and `cycle.rs` in it), `crank.rs`, `orbit.rs`,
//! `support.rs`, `oil.rs`, `heat.rs`, `limits.rs`, `criteria.rs`, `cavitation.rs`, `contact.rs`, `roughness.rs`,
//! `turbulence.rs`, `dynamics.rs`, `cap.rs`, `sweep.rs`; a crankshaft has a scene of its own, in `crankshaft.rs`.
//! `scene.rs` lists them; `key_tolerance.rs` is about the tolerances of their numbers; [`periodic_table`] and
//! [`surface_table`] read the tables in files that a scene names.
//!
//! Reading order: `scene.rs`, `bearing.rs` as an example of a table, `reader.rs` (how a table is read and what is wrong
//! with it collected), [`unit`] (quantities with units, by the table in `dimension.rs`), `complaint.rs`.

#[macro_use]
pub mod keys;

mod bearing;
mod bore;
mod bounds;
mod cap;
pub mod catalogue;
mod cavitation;
mod complaint;
pub mod compliance_table;
mod contact;
mod crank;
mod crankshaft;
mod criteria;
mod design;
mod dimension;
mod dynamics;
mod ends;
mod error;
mod feed;
mod heat;
mod journal;
mod key_tolerance;
mod limits;
mod liner;
mod load;
mod mesh;
mod oil;
mod orbit;
pub mod periodic_table;
mod reader;
mod roughness;
mod scene;
mod shaft;
pub mod spelling;
mod support;
pub mod surface_table;
pub mod sweep;
mod tolerance;
mod turbulence;
pub mod unit;
pub mod wording;

pub use bearing::{Arc, BearingTable, TheoryKey};
pub use bore::Bore;
pub use cap::{Bolts, Cap, ShellTable};
pub use cavitation::{CavitationModel, CavitationTable};
pub use complaint::{Check, Complaint, Complaints};
pub use contact::{ContactModel, ContactTable};
pub use crank::{CrankDrive, CrankTable, Gas, ThrowTable};
pub use crankshaft::*;
pub use criteria::Criteria;
pub use design::{Design, DesignSense, FreeKey, no_design};
pub use dynamics::DynamicsTable;
pub use ends::Ends;
pub use error::SceneError;
pub use feed::{Feed, Groove, Hole};
pub use heat::*;
pub use journal::*;
pub use key_tolerance::KeyTolerance;
pub use liner::{Layer, Liner, OuterSurface, WallMaterial};
pub use load::cycle::{CrankBearing, HarmonicTable, LoadCycle, LoadFrame, LoadSource};
pub use mesh::{Layout, MeshSource};
pub use oil::*;
pub use orbit::OrbitTable;
pub use roughness::Roughness;
pub use scene::{MESH_FILE, SCENE_LIMIT, SWEPT, SWEPT_OF_SHAFT, Scene};
pub use shaft::JournalShape;
pub use support::{Support, TiltingTable};
pub use tolerance::{Target, Tolerance};
pub use turbulence::Turbulence;
