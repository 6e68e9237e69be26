use std::cell::RefCell;
use std::collections::BTreeMap;
use std::path::Path;

use toml::de::DeTable;

use super::*;
use crate::Complaints;
use crate::reader::{TableReader, asked};

/// A text with every table that a scene may have, so that every reader runs; as a scene it is refused.
const EVERY_TABLE: &str = r#"
bearing = { arc = {} }
mesh = { tolerance = { QUANTITY = "1 %" } }
feed = [{ hole = {}, groove = {} }]
journal = { squeeze = {}, tilt = {}, tilt_rate = {} }
load = { moment = {}, harmonics = [{ cos = {}, sin = {} }] }
crank = { gas = {}, throws = [{}] }
support = { tilt = {} }
heat = { housing = {}, mixing = {} }
limits = {}
criteria = {}
bore = [{ oval = {}, worn = {}, envelope = {} }]
shaft = {}
cavitation = {}
contact = {}
roughness = {}
liner = { winkler = {}, wall = {}, compliance = {} }
dynamics = {}
orbit = { start = {} }
cap = { bolts = {}, shell = {} }
ends = {}
oil = { walther = {}, vogel = {}, table = [{}], density = {}, barus = {}, roelands = {} }
sweep = { columns = ["load"], KEY = { from = 1, to = 2, steps = 2 } }
"#;

/// Forms that a key has in another text.
const OTHER_FORMS: &str = r#"
mesh.tolerance = "1 %"
liner.winkler = "0.02 um/MPa"
oil = { density = "870 kg/m3", high_shear = "2.9 mPa.s" }
"#;

/// A text with every table that the scene of a crankshaft may have.
const CRANKSHAFT: &str =
    "crankshaft = { piece = [{}], throw = {}, bearing = [{ support = {} }], load = [{}], counterweight = [{}] }";

fn asked_for() -> asked::Asked {
    asked::take();
    for text in [EVERY_TABLE, OTHER_FORMS] {
        let document = DeTable::parse(text).expect("TOML");
        let complaints = RefCell::new(Complaints::new(text));
        crate::scene::read(TableReader::root(&complaints, document.get_ref()), text, Path::new("scene.toml"));
    }
    let document = DeTable::parse(CRANKSHAFT).expect("TOML");
    let complaints = RefCell::new(Complaints::new(CRANKSHAFT));
    crate::crankshaft::read_scene(
        TableReader::root(&complaints, document.get_ref()),
        CRANKSHAFT,
        Path::new("scene.toml"),
    );
    asked::take()
}

#[test]
fn the_rows_are_the_keys_that_the_readers_ask_for() {
    let mut asked: BTreeMap<String, (Vec<String>, Vec<String>)> = BTreeMap::new();
    for (path, entries) in asked_for() {
        let (mut forms, mut examples): (Vec<_>, Vec<_>) = entries.into_iter().unzip();
        // The reader of a choice reads a text.
        if forms.iter().any(|form| form.starts_with("Choice")) {
            forms.retain(|form| form != "Text");
        }
        forms.sort();
        forms.dedup();
        examples.retain(|example| !example.is_empty());
        asked.insert(path, (forms, examples));
    }
    for key in keys() {
        let (forms, examples) = asked.remove(key.path).unwrap_or_else(|| panic!("nothing reads {}", key.path));
        let mut own: Vec<_> = key.forms.iter().map(|form| format!("{form:?}")).collect();
        own.sort();
        assert_eq!(own, forms, "{}", key.path);
        let is_asked = examples.iter().any(|example| example == key.example);
        assert!(is_asked || examples.is_empty(), "{}: {:?} is none of {examples:?}", key.path, key.example);
    }
    assert!(asked.is_empty(), "no row for {:?}", asked.keys());
}
