//! Rough surfaces that touch: closed forms, tangents, and the positions of a second code.

mod closed_forms;
pub(crate) mod mixed;
mod orbit;
mod rest;
mod scenes;
mod tangent;

use oilwedge_tests::program::repository;
use serde_json::Value;

/// A block of `tests/data/contact.json`.
fn block(name: &str) -> Value {
    let path = repository().join("tests/data/contact.json");
    let text = std::fs::read_to_string(path).expect("reference of contact");
    let data: Value = serde_json::from_str(&text).expect("reference is JSON");
    data.get(name).unwrap_or_else(|| panic!("no block {name}")).clone()
}
