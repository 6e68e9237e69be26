//! Results out: JSON, CSV, VTU, pictures, the HTML page, and folders that are whole after a kill.
//!
//! Reading order: [`mod@json`], [`folder`], [`results`] (the folder of a run), [`shaft`] (that of a crankshaft),
//! [`sweep`], [`convergence`], [`vtu`], [`plot`], [`page`], [`tables`], [`mod@check`].

mod balances;
pub mod catalogue;
pub mod characteristics;
pub mod check;
pub mod comparison;
pub mod convergence;
mod criteria;
pub mod design_sheet;
pub mod difference;
pub mod digits;
mod error;
pub mod folder;
pub mod frames;
pub mod json;
pub mod kinds;
pub mod load_sheet;
mod number_columns;
pub mod oil_sheet;
pub mod orbit_course;
pub mod orbit_table;
pub mod page;
pub mod plot;
pub mod readable;
pub mod results;
pub mod schema;
pub mod shaft;
mod shaft_sheet;
pub mod shaft_view;
pub mod sheet;
mod sketch;
mod spread_sheet;
pub mod sweep;
pub mod tables;
pub mod vtu;
pub mod vtu_read;

pub use check::{check_mesh, check_scene, write_mesh};
pub use error::Error;
pub use json::{json, result_json};
