//! Text to scene: a TOML file about one bearing becomes a checked description in SI.
//!
//! [`Scene::read`] reads a file and reports everything that is wrong with it at once.
//!
//! ```text
//! scene.toml -> schema (keys, units) -> Scene (SI) -> validate (ranges)
//! ```
//!
//! Reading order: [`unit`] (quantities with units, over the table in `dimension.rs`), [`scene`] (what a user can
//! describe), [`schema`] (how it is written, over the collecting `reader.rs`), [`validate`] (what can be computed),
//! [`complaint`] (what is wrong with a scene), [`sweep`] (the cases that one scene describes).

pub mod complaint;
mod dimension;
pub mod lubricant;
pub mod reader;
pub mod scene;
pub mod schema;
pub mod spelling;
pub mod sweep;
pub mod unit;
pub mod validate;
pub mod wording;

pub use complaint::{Complaint, SceneError};
pub use scene::Scene;
