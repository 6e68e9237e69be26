//! What the full tier of tests and the pages of `docs` are made of: random lists, measurements, tables and figures.
//!
//! `cargo test --release --workspace --test full` runs the full tier; `cargo run --release -p oilwedge-full` lists the
//! commands that measure, or write pages anew. Neither is built by the quick tier.

pub mod book;
pub mod cavitation_page;
pub mod coverage;
pub mod crankshafts_page;
pub mod crate_arrows;
pub mod docs_images;
pub mod engine_page;
pub mod flexpde_page;
pub mod flow_meshes;
pub mod gallery;
pub mod mesh_page;
pub mod mesh_readers;
pub mod msh_file;
pub mod notation_page;
pub mod orbits_page;
pub mod performance;
pub mod prices_page;
pub mod quantities_page;
pub mod random_orbits;
pub mod random_page;
pub mod random_sensitivity;
pub mod random_shafts;
pub mod random_thermal;
pub mod random_tilted;
pub mod random_walls;
pub mod scene_page;
pub mod short_bearing_figures;
pub mod short_bearing_page;
pub mod stability;
pub mod tables;
pub mod thermal_page;
