//! Rough surfaces that touch where the films of the tests are thin.

use std::sync::Arc;

use oilwedge_reynolds::contact::{BearingCurve, Contact, ContactLaw, Fineness, GreenwoodTripp};
use serde_json::Value;

use crate::program::repository;

/// Contact of elastic asperities of a roughness of 2 um, and by a bearing curve of 4 um: they touch where films of the
/// tests are thin.
pub fn contacts() -> [Contact; 2] {
    let laws: [Arc<dyn ContactLaw>; 2] = [
        Arc::new(GreenwoodTripp::new(2e-6, 0.05, 0.01, 115e9, 2e9)),
        Arc::new(BearingCurve { depth: 4e-6, hardness: 1e8 }),
    ];
    laws.map(|law| Contact { law, friction: 0.1, fineness: Fineness::Reported })
}

/// A block of `tests/data/contact.json`.
///
/// # Panics
/// If there is none of this name.
pub fn block(name: &str) -> Value {
    let path = repository().join("tests/data/contact.json");
    let text = std::fs::read_to_string(path).expect("reference of contact");
    let data: Value = serde_json::from_str(&text).expect("reference is JSON");
    data.get(name).unwrap_or_else(|| panic!("no block {name}")).clone()
}

/// Keys of contact by elastic asperities.
pub const ASPERITIES: &str =
    "model = \"greenwood-tripp\"\neta_beta_sigma = 0.05\nsigma_over_beta = 0.01\nmodulus = \"115 GPa\"";
/// Keys of contact by a bearing curve.
pub const CURVE: &str = "model = \"bearing-curve\"\ndepth = \"1.2 um\"";

/// The bearing of the table at a speed, with these keys of contact and of the flow.
pub fn mixed_scene(rpm: f64, contact: &str, flow: &str) -> String {
    format!(
        "bearing = {{ diameter = \"50 mm\", length = \"25 mm\", clearance = \"25 um\", roughness = \"0.6 um\" }}\n\
         journal = {{ speed = \"{rpm} rpm\" }}\nload = {{ force = \"10 kN\", angle = \"0 deg\" }}\noil.viscosity = \"8 mPa.s\"\n\
         cavitation.model = \"reynolds\"\nmesh.size = \"2 mm\"\n[contact]\n{contact}\nhardness = \"900 MPa\"\nfriction = 0.1\n{flow}"
    )
}
