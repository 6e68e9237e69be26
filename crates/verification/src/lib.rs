//! Hard cases of the oil film: that the solver converges, or gives the reason why there is no answer.
//!
//! A case is a scene at the edge of what can be computed, with the reason why it is there and how it must end. Each
//! answer is judged twice: by itself (balances, signs, bars: `faults.rs`), and by a second method (a finer mesh,
//! another scene, known values: `reference_film.rs`).
//!
//! ```text
//! tests/hard_cases/*.toml -> family -> cases -> answer (made_mesh) -> faults, reference_film -> CaseVerdict
//! ```
//!
//! Reading order: [`family`] (the form of the files), [`cases`], [`answer`], `faults.rs`, `reference_film.rs`,
//! [`suite`].
//! The full tier of tests judges each answer beside the others of its series, and draws the map of stability.

pub mod answer;
pub mod cases;
pub mod family;
mod faults;
mod made_mesh;
mod reference_film;
pub mod suite;

pub use suite::{CaseVerdict, SuiteError, run_suite};
