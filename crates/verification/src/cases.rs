//! The cases of the families: each a scene as text, and its expected end.

use toml::{Table, Value};

use crate::family::{CaseSeries, Expect, Family, LimitedLaw, MeshRecipe, Other, Vary};

/// The family that asks an installation for known values.
pub const KNOWN_VALUES: &str = "known_values";

/// The families, by the names of their files in `tests/hard_cases`.
const FAMILIES: [(&str, &str); 22] = [
    (KNOWN_VALUES, include_str!("../../../tests/hard_cases/known_values.toml")),
    ("eccentricity", include_str!("../../../tests/hard_cases/eccentricity.toml")),
    ("slenderness", include_str!("../../../tests/hard_cases/slenderness.toml")),
    ("viscosity", include_str!("../../../tests/hard_cases/viscosity.toml")),
    ("feed_pressure", include_str!("../../../tests/hard_cases/feed_pressure.toml")),
    ("holes", include_str!("../../../tests/hard_cases/holes.toml")),
    ("grooves", include_str!("../../../tests/hard_cases/grooves.toml")),
    ("along_flow", include_str!("../../../tests/hard_cases/along_flow.toml")),
    ("arcs", include_str!("../../../tests/hard_cases/arcs.toml")),
    ("squeeze", include_str!("../../../tests/hard_cases/squeeze.toml")),
    ("tilt", include_str!("../../../tests/hard_cases/tilt.toml")),
    ("shapes", include_str!("../../../tests/hard_cases/shapes.toml")),
    ("liner", include_str!("../../../tests/hard_cases/liner.toml")),
    ("dynamics", include_str!("../../../tests/hard_cases/dynamics.toml")),
    ("speed", include_str!("../../../tests/hard_cases/speed.toml")),
    ("supply", include_str!("../../../tests/hard_cases/supply.toml")),
    ("meshes", include_str!("../../../tests/hard_cases/meshes.toml")),
    ("placement", include_str!("../../../tests/hard_cases/placement.toml")),
    ("loads", include_str!("../../../tests/hard_cases/loads.toml")),
    ("scales", include_str!("../../../tests/hard_cases/scales.toml")),
    ("contact", include_str!("../../../tests/hard_cases/contact.toml")),
    ("orbits", include_str!("../../../tests/hard_cases/orbits.toml")),
];

/// One hard case.
#[derive(Debug, Clone)]
pub struct Case {
    /// Name of the family's file.
    pub family: &'static str,
    /// Name of the series.
    pub series: String,
    /// What sets it apart in its series; empty where it is alone.
    pub variant: String,
    /// The scene.
    pub scene: Table,
    /// How the mesh file of the scene is made, if it has one.
    pub mesh: Option<MeshRecipe>,
    /// The coefficient of the viscosity law is this part of its limit.
    pub of_limit: Option<(f64, LimitedLaw)>,
    /// How it must end.
    pub expect: Expect,
    /// Words that its reason or a warning must hold.
    pub says: Option<String>,
}

impl Case {
    /// Series and variant.
    pub fn name(&self) -> String {
        match self.variant.is_empty() {
            true => self.series.clone(),
            false => format!("{}: {}", self.series, self.variant),
        }
    }
}

/// Why a family cannot be used.
#[derive(Debug, thiserror::Error)]
#[error("the family of hard cases {name} cannot be read: {reason}")]
pub struct BadFamily {
    /// Name of its file.
    pub name: &'static str,
    /// What is wrong.
    pub reason: String,
}

/// All families, by name.
///
/// # Errors
/// [`BadFamily`]: a file is not of the form of [`Family`].
pub fn families() -> Result<Vec<(&'static str, Family)>, BadFamily> {
    let read = |&(name, text): &(&'static str, &str)| {
        let family = toml::from_str(text).map_err(|error| BadFamily { name, reason: error.to_string() })?;
        Ok((name, family))
    };
    FAMILIES.iter().map(read).collect()
}

/// The cases of a series, in their order.
pub fn cases(name: &'static str, family: &Family, series: &CaseSeries) -> Vec<Case> {
    let mut scene = family.scene.clone();
    change(&mut scene, &series.set, &series.without);
    let case = Case {
        family: name,
        series: series.name.clone(),
        variant: String::new(),
        scene,
        mesh: series.mesh.clone(),
        of_limit: None,
        expect: series.expect,
        says: series.says.clone(),
    };
    let variants = match series.variants.is_empty() {
        true => vec![case],
        false => series.variants.iter().map(|variant| variant_of(&case, variant)).collect(),
    };
    variants.iter().flat_map(|case| along(case, series)).collect()
}

/// A case for each value that the series varies.
fn along(case: &Case, series: &CaseSeries) -> Vec<Case> {
    match &series.vary {
        None => vec![case.clone()],
        Some(Vary::Key { key, values }) => values.iter().map(|value| varied(case, key, value)).collect(),
        Some(Vary::OfLimit { of_limit, law }) => (of_limit.iter())
            .map(|&part| Case {
                variant: joined(&case.variant, &format!("{part} of the limit")),
                of_limit: Some((part, law.clone())),
                ..case.clone()
            })
            .collect(),
    }
}

fn joined(variant: &str, value: &str) -> String {
    match variant.is_empty() {
        true => value.to_owned(),
        false => format!("{variant}, {value}"),
    }
}

fn varied(case: &Case, key: &str, value: &Value) -> Case {
    let mut case = case.clone();
    put(&mut case.scene, key, value.clone());
    let last = key.rsplit('.').next().unwrap_or(key);
    let shown = match value {
        Value::String(text) => format!("{last} {text}"),
        other => format!("{last} {other}"),
    };
    case.variant = joined(&case.variant, &shown);
    case
}

fn variant_of(case: &Case, variant: &crate::family::CaseVariant) -> Case {
    let mut case = case.clone();
    change(&mut case.scene, &variant.set, &[]);
    case.variant.clone_from(&variant.name);
    case.mesh = variant.mesh.clone().or(case.mesh);
    case.expect = variant.expect.unwrap_or(case.expect);
    case.says = variant.says.clone().or(case.says);
    case
}

/// The scene that stands against a case.
pub(crate) fn other(scene: &Table, other: &Other) -> Table {
    let mut scene = scene.clone();
    change(&mut scene, &other.set, &other.without);
    scene
}

/// The scene of a case on a finer mesh.
pub(crate) fn finer(scene: &Table, tolerance: f64) -> Table {
    let mut scene = scene.clone();
    put(&mut scene, "mesh.tolerance", Value::String(format!("{} %", 100.0 * tolerance)));
    scene
}

/// Takes keys away, then sets others.
fn change(scene: &mut Table, set: &Table, without: &[String]) {
    for key in without {
        let (table, key) = match key.rsplit_once('.') {
            Some((tables, key)) => (table_at(scene, tables), key),
            None => (&mut *scene, key.as_str()),
        };
        table.remove(key);
    }
    for (key, value) in set {
        put(scene, key, value.clone());
    }
}

/// Sets a key with dots; tables on its way are made.
pub fn put(scene: &mut Table, key: &str, value: Value) {
    let (table, key) = match key.rsplit_once('.') {
        Some((tables, key)) => (table_at(scene, tables), key),
        None => (scene, key),
    };
    table.insert(key.to_owned(), value);
}

fn table_at<'a>(scene: &'a mut Table, path: &str) -> &'a mut Table {
    path.split('.').fold(scene, |table, name| {
        let entry = table.entry(name).or_insert_with(|| Value::Table(Table::new()));
        if !entry.is_table() {
            *entry = Value::Table(Table::new());
        }
        match entry {
            Value::Table(inner) => inner,
            _ => unreachable!("it was made a table"),
        }
    })
}
