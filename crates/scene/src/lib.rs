//! The door of oilwedge: text in, numbers out.
//!
//! A scene is a TOML file about one bearing. [`Scene::read`] makes it a [`scene::Scene`] in SI, or tells everything
//! that is wrong with it at once; [`run`](run()) computes it; [`results::write_results`] writes what was found.
//!
//! ```text
//! scene.toml -> schema (keys, units) -> Scene (SI) -> validate (ranges) -> compile (sockets) -> analysis (position) -> film
//!      film -> measure (quantities) + picture (fields) -> RunResult + FilmPicture -> files
//! ```
//!
//! Reading order: [`unit`] (quantities with units, over the table in `dimension.rs`), [`scene`] (what a user can
//! say), [`schema`] (how it is written, over the collecting `reader.rs`), [`validate`] (what can be computed),
//! [`complaint`] (what is said where it cannot), [`mod@compile`] (the one place that knows all effects), [`analysis`] (given
//! position or given load), [`thermal`] (its temperature), [`mod@run`], [`mod@measure`], [`joint`] and [`report`] (the numbers, in `doubts.rs` what to doubt, in
//! [`regime`] which assumptions hold),
//! [`mod@picture`] and [`vtu`] (the fields), [`results`] (the files), [`cost`] (the same again without each effect),
//! [`mod@theories`] (the same again as a short and as a long bearing), [`mod@standard`] (the same by ISO 7902).
//! What is known of oils: [`oil_sheet`]. What accuracy costs: [`convergence`], over [`level`] and with [`plot`].

pub mod analysis;
pub mod bars;
mod companion_bars;
pub mod compile;
pub mod complaint;
pub mod convergence;
pub mod cost;
mod dimension;
mod doubts;
pub mod folder;
pub mod joint;
pub mod level;
pub mod liner_mesh;
pub mod measure;
mod moved;
pub mod oil_sheet;
pub mod picture;
pub mod plot;
mod reader;
pub mod refinement;
pub mod regime;
pub mod report;
pub mod results;
pub mod run;
pub mod scene;
pub mod schema;
pub mod sketch;
pub mod spelling;
pub mod standard;
pub mod sweep;
pub mod theories;
pub mod thermal;
pub mod unit;
pub mod validate;
pub mod vtu;
mod wording;

pub use oilwedge_bearing::Interrupt;

pub use complaint::{Complaint, SceneError};
pub use convergence::converge;
pub use cost::effect_costs;
pub use run::{Error, Run, RunOptions, check_mesh, check_scene, mesh_scene, run, write_mesh};
pub use scene::Scene;
pub use standard::standard;
pub use theories::theories;
