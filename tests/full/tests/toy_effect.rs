//! An effect that is added to a copy of the tree by the steps of `CONTRIBUTING.md`, and taken out again: a gap that is
//! wider by the same everywhere.

use std::collections::BTreeMap;
use std::path::Path;

use oilwedge_tests::program::repository;

/// Files of the effect.
const FILES: [(&str, &str); 3] = [
    (
        "crates/reynolds/src/film_thickness/growth.rs",
        r#"//! The gap is wider by the same everywhere.

use std::sync::Arc;

use super::FilmContribution;
use crate::{FilmPoint, JournalState};

/// A gap that is wider by the same everywhere.
#[derive(Debug, Clone, Copy)]
pub struct Growth {
    /// How much wider it is [m].
    pub depth: f64,
}

impl FilmContribution for Growth {
    fn add(&self, _journal: &JournalState, _cell: usize, _positions: &[[f64; 2]], film: &mut [FilmPoint]) {
        film.iter_mut().for_each(|point| point.thickness += self.depth);
    }

    fn carried(&self, _parents: &[u32]) -> Arc<dyn FilmContribution> {
        Arc::new(*self)
    }
}
"#,
    ),
    (
        "crates/scene/src/growth.rs",
        r#"//! `[growth]`: the gap is wider by the same everywhere.

use crate::reader::TableReader;

keys! {
    "growth" = Table; "", "the gap is that of its clearance", "",
        "the gap is wider by the same everywhere";
    "growth.depth" = Quantity(Length); "1 um", "required", ">= 0",
        "how much wider it is";
}

/// A gap that is wider by the same everywhere.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Growth {
    /// How much wider it is [m].
    pub depth: f64,
}

pub(crate) fn read(mut table: TableReader<'_>) -> Growth {
    Growth { depth: table.required("depth") }
}
"#,
    ),
    (
        "crates/study/src/effects/growth.rs",
        r#"//! The gap is wider by the same everywhere.

use std::sync::Arc;

use oilwedge_reynolds::film_thickness::Growth;

use super::{BLANK, Contribution, Effect, Socket, changed};

pub(super) const ROW: Effect = Effect {
    name: "growth",
    sentence: "the gap is wider by the same everywhere",
    socket: Socket::FilmThickness,
    is_in: |scene| scene.growth.is_some(),
    install: |scene, sockets| {
        if let Some(growth) = scene.growth {
            sockets.film_thickness.push(Contribution::Given(Arc::new(Growth { depth: growth.depth })));
        }
    },
    instead: "the gap of the clearance",
    remove: |scene| changed(scene, |scene| scene.growth = None),
    ..BLANK
};
"#,
    ),
];

/// Rows of the effect: the file, the line below which the row stands, and the row.
const ROWS: [(&str, &str, &str); 10] = [
    ("crates/reynolds/src/film_thickness/mod.rs", "mod groove_depth;", "mod growth;"),
    ("crates/reynolds/src/film_thickness/mod.rs", "pub use groove_depth::GrooveDepth;", "pub use growth::Growth;"),
    ("crates/scene/src/lib.rs", "mod feed;", "mod growth;"),
    ("crates/scene/src/lib.rs", "pub use roughness::Roughness;", "pub use growth::Growth;"),
    ("crates/scene/src/catalogue.rs", "    crate::roughness::KEYS,", "    crate::growth::KEYS,"),
    (
        "crates/scene/src/scene.rs",
        "    pub roughness: Option<Roughness>,",
        "    /// How much wider the gap is.\n    pub growth: Option<crate::Growth>,",
    ),
    (
        "crates/scene/src/scene.rs",
        "        roughness: root.table_if_given(\"roughness\").and_then(roughness::read),",
        "        growth: root.table_if_given(\"growth\").map(crate::growth::read),",
    ),
    ("crates/study/src/effects/mod.rs", "mod groove_depth;", "mod growth;"),
    ("crates/study/src/effects/mod.rs", "    &groove_depth::ROW,", "    &growth::ROW,"),
    ("crates/scene/src/scene.rs", "    \"roughness\",", "    \"growth\","),
];

/// Adds the effect to a tree, and returns the texts of the files that got rows.
///
/// # Panics
/// If `CONTRIBUTING.md` does not name a file, or the file lacks the place of a row.
pub(crate) fn add(tree: &Path) -> BTreeMap<&'static str, String> {
    let steps = std::fs::read_to_string(repository().join("CONTRIBUTING.md")).expect("the steps");
    let steps = steps.replace("SOCKET", "film_thickness").replace("NAME", "growth");
    let is_step = |file: &str| assert!(steps.contains(&format!("`{file}`")), "CONTRIBUTING.md does not name {file}");
    for (file, text) in FILES {
        is_step(file);
        std::fs::write(tree.join(file), text).expect("a file");
    }
    let mut before = BTreeMap::new();
    for (file, above, row) in ROWS {
        is_step(file);
        let text = std::fs::read_to_string(tree.join(file)).unwrap_or_else(|error| panic!("{file}: {error}"));
        let (head, rest) = text.split_once(&format!("\n{above}\n")).unwrap_or_else(|| panic!("{file}: no {above}"));
        std::fs::write(tree.join(file), format!("{head}\n{above}\n{row}\n{rest}")).expect("a file");
        before.entry(file).or_insert(text);
    }
    before
}

/// Takes the effect out again: its files go away, and the rows with them.
pub(crate) fn remove(tree: &Path, before: &BTreeMap<&'static str, String>) {
    for (file, _) in FILES {
        std::fs::remove_file(tree.join(file)).expect("a file");
    }
    for (file, _, row) in ROWS {
        let text = std::fs::read_to_string(tree.join(file)).expect("a file");
        let kept = text.replacen(&format!("{row}\n"), "", 1);
        std::fs::write(tree.join(file), kept).expect("a file");
    }
    for (file, text) in before {
        assert!(std::fs::read_to_string(tree.join(file)).expect("a file") == *text, "{file} is not as before");
    }
}

/// The plain ring with and without the effect, and with a clearance and eccentricity that give the same gap.
pub(crate) fn scenes() -> [String; 3] {
    let ring = |clearance: f64, eccentricity: f64, more: &str| {
        format!(
            "bearing = {{ diameter = \"60 mm\", length = \"30 mm\", clearance = \"{clearance} um\" }}\n\
             journal = {{ speed = \"100 rad/s\", eccentricity = {eccentricity}, min_film_angle = \"90 deg\" }}\n\
             oil = {{ viscosity = \"0.02 Pa.s\" }}\nmesh = {{ size = \"4 mm\" }}\n{more}"
        )
    };
    [ring(30.0, 0.6, ""), ring(30.0, 0.6, "growth = { depth = \"6 um\" }\n"), ring(36.0, 0.5, "")]
}
