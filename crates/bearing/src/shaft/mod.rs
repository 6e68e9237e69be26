//! A shaft on the films of all its bearings.
//!
//! | file | what |
//! |---|---|
//! | `beam.rs` | how a piece resists the motions of its ends |
//! | `crankshaft.rs` | pieces and throws laid along the axis as beams |
//! | `frame.rs` | the beams as the journals see them: stiffness, and loads moved to them |
//! | `centre_line.rs` | how the shaft bends between its journals |
//! | `engine.rs`, `cut.rs` | loads of all throws by firing order; the shaft cut at its mains |
//! | `films.rs`, `stage.rs` | the balance of shaft and films, and Newton's method for it |
//! | `step.rs` | one step in time, and what it is off by |
//! | `equilibrium.rs`, `march.rs`, `no_orbit.rs` | the shaft at rest, and over cycles; why it is not led on |
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
mod march;
pub mod matrix;
mod no_orbit;
mod stage;
mod step;

pub use beam::Material;
pub use centre_line::LinePoint;
pub use crankshaft::{CrankThrow, Crankshaft, Piece, Round};
pub use cut::shares;
pub use engine::Engine;
pub use equilibrium::{Balance, NoBalance};
pub use films::{Film, Films, NoFilmAt};
pub use frame::{Frame, NoShaft, NodeForce, Place, Shaft};
pub use march::{MarchOptions, ShaftCycle, ShaftOrbit};
pub use no_orbit::NoShaftOrbit;
pub use step::{Drive, ShaftStep};
