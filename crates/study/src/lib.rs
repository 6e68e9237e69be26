//! One scene to one answer: a compiled film, its analysis, its quantities with error bars, and the result as data.
//!
//! ```text
//! Scene -> compile (sockets) -> analysis (position, temperature) -> film -> quantities, bars -> RunResult + FilmPicture
//! ```
//!
//! Reading order: [`mod@compile`], [`analysis`], [`thermal`], [`mod@measure`], [`quantities`], [`estimate`], [`refinement`], [`mod@run`], [`result`],
//! [`mod@picture`].

pub mod analysis;
mod cap_joint;
pub mod checks;
pub mod compile;
pub mod effects;
pub mod estimate;
pub mod film;
pub mod level;
pub mod liner_mesh;
pub mod measure;
pub mod oil;
pub mod picture;
pub mod position;
pub mod quantities;
pub mod reasons;
pub mod refinement;
pub mod regime;
pub mod result;
pub mod run;
pub mod thermal;
pub mod warnings;

pub use oilwedge_bearing::Interrupt;

pub use checks::{CHECKS, complaints, parse, read};
pub use compile::CompileError;
pub use run::{Run, RunOptions, run};
