//! Rough surfaces that touch: closed forms, tangents, and the positions of a second code.

mod closed_forms;
pub(crate) mod mixed;
mod orbit;
mod rest;
mod scenes;
mod tangent;

use oilwedge_reynolds::contact::{BearingCurve, Contact, ContactLaw, Fineness, GreenwoodTripp};
use oilwedge_tests::program::repository;
use serde_json::Value;

/// A block of `tests/data/contact.json`.
fn block(name: &str) -> Value {
    let path = repository().join("tests/data/contact.json");
    let text = std::fs::read_to_string(path).expect("reference of contact");
    let data: Value = serde_json::from_str(&text).expect("reference is JSON");
    data.get(name).unwrap_or_else(|| panic!("no block {name}")).clone()
}

/// Contact of elastic asperities of a roughness of 2 um, and by a bearing curve of 4 um: they touch where films of the tests are thin.
pub(crate) fn contacts() -> [Contact; 2] {
    let laws = [
        ContactLaw::GreenwoodTripp(GreenwoodTripp::new(2e-6, 0.05, 0.01, 115e9, 2e9)),
        ContactLaw::BearingCurve(BearingCurve {
            depth: 4e-6,
            hardness: 1e8,
        }),
    ];
    laws.map(|law| Contact {
        law,
        friction: 0.1,
        fineness: Fineness::Reported,
    })
}
