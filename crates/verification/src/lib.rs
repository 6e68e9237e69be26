//! Hard cases of the oil film: that the solver converges, or gives the reason why there is no answer.
//!
//! A case is a scene at the edge of what can be computed, with the reason why it is there and how it must end. Each
//! answer is judged three times: by itself (balances, signs, bars: `faults.rs`), beside the other cases of its series
//! (trends, the same digits: `series.rs`), and by a second method (a finer mesh, another scene, known values:
//! `reference_film.rs`).
//!
//! ```text
//! tests/hard_cases/*.toml -> family -> cases -> answer (made_mesh) -> faults, series, reference_film -> Verdict
//! Verdict                 -> page
//! grid of eccentricities  -> map -> cells -> page, picture
//! ```
//!
//! Reading order: [`family`] (the form of the files), [`cases`], `answer.rs`, `faults.rs`, `reference_film.rs`,
//! [`suite`], [`map`], [`page`].

mod answer;
pub mod cases;
pub mod family;
mod faults;
mod made_mesh;
pub mod map;
pub mod map_picture;
pub mod page;
mod reference_film;
mod series;
pub mod suite;

pub use map::run_map;
pub use reference_film::Comparison;
pub use suite::{SuiteError, Verdict, run_suite};
