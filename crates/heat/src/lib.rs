//! Temperature across a lubricating film. The film is a network of cells with flows of oil between them, whatever
//! solved it: this crate knows no finite elements and no equation of films, and depends on no other crate of the house.
//!
//! Across the film, from the bush (eta = y/h = 0) to the journal that moves (eta = 1), a temperature is a polynomial
//! through its values at the points of [`Layers`]. Viscosities at these points make a [`LayerProfile`]: conductance and
//! drag of the film, and the shares of the layers in its flow and heat. A [`FilmNetwork`] says how much oil flows from
//! cell to cell, how much heat friction makes, and what the walls and feeds are. [`solve`] gives the
//! [`LayerTemperatures`] that balance, and the [`PowerSheet`] with what goes where. Whoever calls it makes viscosities
//! of the temperatures, a film of the viscosities, and asks again.
//!
//! All is SI, temperatures are in kelvin. Reading order: `layers.rs`, `profile.rs` (flow and friction of layers),
//! `eddies.rs` (those of turbulent films), `network.rs` (what is given), `transport.rs` (the balances), `walls.rs`
//! (which unknowns there are), `bush.rs` (the ring; `bessel.rs`, `waves.rs`), `order.rs`, `sweep.rs` and `gmres.rs`
//! (the linear solver), `solve.rs`, `temperatures.rs`, `power_sheet.rs`.

mod bessel;
mod bush;
mod eddies;
mod gmres;
mod layers;
mod network;
mod order;
mod power_sheet;
mod profile;
mod small_matrix;
mod solve;
mod sweep;
mod temperatures;
mod transport;
mod walls;
mod waves;

pub use bush::{BushRing, BushShape};
pub use eddies::{EddyScales, TurbulentFlow};
pub use layers::{COUNTS, Layers, MOST_POINTS};
pub use network::{
    BushSide, FeedSupply, FilmCell, FilmLink, FilmNetwork, FilmPort, JournalSide, OilProperties, PortKind,
};
pub use power_sheet::PowerSheet;
pub use profile::{LayerProfile, PerLayer};
pub use solve::{NetworkFailure, NetworkOptions, SolvedNetwork, Thinning, solve};
pub use temperatures::LayerTemperatures;
