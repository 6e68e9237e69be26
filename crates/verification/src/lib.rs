//! Hard cases of the oil film: that the solver converges, or says why there is no answer.
//!
//! A case is a scene at the edge of what can be computed, with the reason why it is there and how it must end. Each answer is
//! judged three times: by itself (balances, signs, bars: `judge.rs`), beside the other cases of its series (trends, the same
//! digits: `series.rs`), and by a second method (a finer mesh, another scene, known values: `witness.rs`).
//!
//! ```text
//! tests/hard_cases/*.toml -> family -> cases -> answer (made_mesh) -> judge, series, witness -> Verdict -> page
//! grid of eccentricities  -> map -> cells -> page, picture
//! ```
//!
//! Reading order: [`family`] (the form of the files), [`cases`], `answer.rs`, `judge.rs`, `witness.rs`, [`suite`], [`map`], [`page`].

mod answer;
pub mod cases;
pub mod family;
mod judge;
mod made_mesh;
pub mod map;
pub mod page;
mod series;
pub mod suite;
mod witness;

pub use map::run_map;
pub use suite::{SuiteError, Verdict, run_suite};
