//! A shaft on the films of all its bearings.
//!
//! | file | what |
//! |---|---|
//! | `beam.rs` | how a piece resists the motions of its ends |
//! | `crankshaft.rs` | pieces and throws laid along the axis as beams |
//! | `frame.rs` | the beams as the journals see them: stiffness, and loads moved to them |
//! | `centre_line.rs` | how the shaft bends between its journals |
//! | `engine.rs`, `cut.rs` | loads of all throws by firing order; the shaft cut at its mains |
//! | `joined.rs` | the balance of shaft and films |
//! | `films.rs` | the films of all journals, which move over a cycle as those of [`crate::orbit`] |
//! | `equilibrium.rs` | the shaft at rest |
//! | `counterweights.rs` | where they serve the bearings best |
//! | `matrix.rs` | dense matrices |
//!
//! **Source.** `docs/theory/crankshaft.md`.

pub mod beam;
mod centre_line;
pub mod counterweights;
pub mod crankshaft;
mod cut;
pub mod engine;
mod equilibrium;
pub mod films;
pub mod frame;
pub mod joined;
pub mod matrix;

pub use beam::Material;
pub use centre_line::LinePoint;
pub use crankshaft::{CrankThrow, Crankshaft, Piece, Round};
pub use cut::shares;
pub use engine::Engine;
pub use equilibrium::{NoBalance, NoFilmAt, ShaftEquilibrium};
pub use films::{Films, ShaftFilm, compliance_of_shell};
pub use frame::{BeamFrame, NoShaft, NodeForce, Place, Shaft};
pub use joined::ShaftBalance;
