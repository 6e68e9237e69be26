//! One scene to one answer: a model, its film on a mesh, its analysis, its quantities with error bars, and the result
//! as data.
//!
//! ```text
//! Scene -> compile -> Model (sockets, plan of meshes)
//! Model -> film on a mesh -> analysis (position, temperature) -> solved film
//! film  -> quantities, bars -> RunResult + FilmPicture
//! ```
//!
//! Reading order: [`mod@compile`], [`model`], [`mesh_plan`], [`film`], [`isothermal`], [`thermal`], [`analysis`],
//! [`mod@measure`], [`quantities`], [`estimate`], [`refinement`], [`mod@run`], [`result`], [`mod@picture`],
//! [`film_lines`], [`fields`]; [`duty`] (the load over a cycle), [`mod@orbit`], [`shaft`] (many bearings).

pub mod analysis;
mod cap_joint;
mod cavity_line;
pub mod checks;
pub mod column;
pub mod compile;
pub mod compile_error;
pub mod effects;
pub mod estimate;
pub mod fields;
pub mod film;
pub mod film_lines;
mod film_scale;
pub mod grading;
pub mod isothermal;
pub mod level;
pub mod limits;
pub mod liner_mesh;
pub mod measure;
pub mod mesh_plan;
pub mod minimax;
pub mod model;
pub mod no_answer;
pub mod observer;
pub mod oil;
pub mod orbit;
pub mod outline;
pub mod picture;
pub mod position;
pub mod quadratic;
pub mod quantities;
pub mod reasons;
pub mod refinement;
pub mod regime;
pub mod result;
mod row_distances;
pub mod run;
pub mod run_options;
pub mod scope;
pub mod sensitivity;
pub mod shaft;
pub mod solved;
pub mod symbol;
pub mod targets;
pub mod thermal;
pub mod thermal_model;
pub mod warning;
pub mod warnings;

pub use oilwedge_bearing::orbit::OrbitObserver;
pub use oilwedge_bearing::{Clock, Interrupt, SearchObserver, pool};

pub use checks::{CHECKS, check_columns, complaints, parse, read};
pub use compile::{compile, duty};
pub use compile_error::CompileError;
pub use observer::{Reached, RunObserver};
pub use run::{Run, run, run_telling};
pub use run_options::RunOptions;
