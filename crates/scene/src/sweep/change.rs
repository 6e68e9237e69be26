//! Texts of scenes that are made of another one: with other values of keys, or with other axes.

use std::cell::RefCell;
use std::path::Path;

use serde::ser::Error;
use serde::{Deserialize, Serialize};
use toml::Spanned;
use toml::de::{DeTable, DeValue, ValueDeserializer};

use super::axis::SweepAxis;
use super::plan::put;
use super::{column, read};
use crate::catalogue;
use crate::complaint::in_order;
use crate::reader::TableReader;
use crate::{Complaint, Complaints, SceneError};

/// The table of a sweep.
const SWEEP: &str = "sweep";

/// The text of the scene `text` with keys set to other values; comments are lost. `changes` is TOML: keys as the axes
/// of a sweep have them, each with a list of one value.
///
/// # Errors
/// A key is none of a scene, or has no value that an axis may have.
pub fn changed(text: &str, path: &Path, changes: &str) -> Result<String, SceneError> {
    let refused = |complaints: Vec<Complaint>| SceneError::Complaints {
        path: path.to_path_buf(),
        text: changes.to_owned(),
        complaints: in_order(complaints),
    };
    let (values, _) = DeTable::parse_recoverable(changes);
    let (mut document, _) = DeTable::parse_recoverable(text);
    let document = document.get_mut();
    for axis in axes(changes).map_err(refused)? {
        let list = values.get_ref().get(axis.name.as_str()).and_then(|list| list.get_ref().as_array());
        // The value as it is written: the name of a file may begin like a number with its unit.
        let Some(value) = list.and_then(|list| list.first()) else {
            continue;
        };
        put(document, &axis, value.get_ref().clone()).map_err(|complaint| {
            refused(vec![Complaint { key: complaint.key.trim_start_matches("sweep.").to_owned(), ..complaint }])
        })?;
    }
    written(document).map_err(refused)
}

/// The text of the scene `text` with other axes; `sweep` is TOML, the table `[sweep]`. Comments are kept where the
/// scene has no axes of its own.
///
/// # Errors
/// The text has a value that TOML cannot write.
pub fn with_axes(text: &str, path: &Path, sweep: &str) -> Result<String, SceneError> {
    let (mut document, _) = DeTable::parse_recoverable(text);
    let scene = match document.get_mut().remove(SWEEP) {
        None => text.to_owned(),
        Some(_) => written(document.get_ref()).map_err(|complaints| SceneError::Complaints {
            path: path.to_path_buf(),
            text: text.to_owned(),
            complaints,
        })?,
    };
    Ok(format!("{}\n\n{sweep}", scene.trim_end()))
}

/// The axes that a text has at its top.
fn axes(text: &str) -> Result<Vec<SweepAxis>, Vec<Complaint>> {
    let (document, _) = DeTable::parse_recoverable(text);
    let complaints = RefCell::new(Complaints::new(text));
    // A table gets one complaint: it is not read as an axis too.
    let tables: Vec<String> = (document.get_ref().iter())
        .filter(|(_, list)| list.get_ref().as_array().is_some_and(|list| list.iter().any(|it| it.get_ref().is_table())))
        .map(|(key, _)| key.get_ref().to_string())
        .collect();
    if !tables.is_empty() {
        let mut complaints = complaints.into_inner();
        for table in tables {
            let help = format!("name the key in it: \"{table}.KEY\", with its value");
            complaints.add(&table, "is a table, and keys are changed one by one", help);
        }
        return Err(complaints.into_list());
    }
    let (axes, columns) =
        read::read(TableReader::root(&complaints, document.get_ref(), catalogue::row_of_axis), &read::OF_CHANGES);
    let mut complaints = complaints.into_inner();
    if columns.is_some() {
        complaints.add(column::KEY, "is no key of a scene but one of [sweep]", "remove it");
    }
    let several = axes.iter().filter(|axis| axis.values.len() > 1);
    for name in several.map(|axis| axis.name.clone()).collect::<Vec<_>>() {
        complaints.add(&name, "has several values", "give one value, or make a sweep of them");
    }
    match complaints.into_list() {
        none if none.is_empty() => Ok(axes),
        complaints => Err(complaints),
    }
}

/// A document as text, its keys in the order of their places: axes keep theirs, which is that of the cases.
fn written(document: &DeTable<'_>) -> Result<String, Vec<Complaint>> {
    let mut text = String::new();
    lines(&mut text, document).map_err(|error| {
        vec![Complaint {
            key: String::new(),
            value: String::new(),
            message: error.to_string(),
            help: "write the scene anew".to_owned(),
            span: None,
        }]
    })?;
    Ok(text)
}

fn lines(text: &mut String, document: &DeTable<'_>) -> Result<(), toml::ser::Error> {
    let is_list_of_tables = |value: &DeValue| {
        let list = value.as_array();
        list.is_some_and(|list| !list.is_empty() && list.iter().all(|item| item.get_ref().is_table()))
    };
    let (below, plain): (Vec<_>, Vec<_>) =
        in_places(document).into_iter().partition(|(_, value)| value.is_table() || is_list_of_tables(value));
    for (key, value) in plain {
        line(text, key, value)?;
    }
    for (key, value) in below {
        let key = written_key(key)?;
        let tables: Vec<(String, &DeTable)> = match value {
            DeValue::Table(table) => vec![(format!("[{key}]"), table)],
            DeValue::Array(list) => (list.iter().filter_map(|item| item.get_ref().as_table()))
                .map(|table| (format!("[[{key}]]"), table))
                .collect(),
            _ => Vec::new(),
        };
        for (heading, table) in tables {
            *text += &format!("\n{heading}\n");
            for (key, value) in in_places(table) {
                line(text, key, value)?;
            }
        }
    }
    Ok(())
}

fn line(text: &mut String, key: &str, value: &DeValue<'_>) -> Result<(), toml::ser::Error> {
    *text += &format!("{} = {}\n", written_key(key)?, inline(value)?);
    Ok(())
}

/// A key, in quotes where it needs them.
fn written_key(key: &str) -> Result<String, toml::ser::Error> {
    let is_bare = |letter: char| letter.is_ascii_alphanumeric() || "_-".contains(letter);
    match !key.is_empty() && key.chars().all(is_bare) {
        true => Ok(key.to_owned()),
        false => inline(&DeValue::String(key.into())),
    }
}

/// The entries of a table in the order of their places.
fn in_places<'d>(table: &'d DeTable<'_>) -> Vec<(&'d str, &'d DeValue<'d>)> {
    let mut entries: Vec<_> = table.iter().collect();
    entries.sort_by_key(|(key, _)| key.span().start);
    let entries = entries.into_iter();
    entries.map(|(key, value)| (key.get_ref().as_ref(), value.get_ref())).collect()
}

/// A value as it stands behind `=`.
fn inline(value: &DeValue<'_>) -> Result<String, toml::ser::Error> {
    Ok(match value {
        DeValue::Table(table) => {
            let mut entries = Vec::new();
            for (key, value) in in_places(table) {
                entries.push(format!("{} = {}", written_key(key)?, inline(value)?));
            }
            format!("{{ {} }}", entries.join(", "))
        }
        DeValue::Array(list) => {
            let items = list.iter().map(|item| inline(item.get_ref()));
            format!("[{}]", items.collect::<Result<Vec<_>, _>>()?.join(", "))
        }
        leaf => {
            let leaf = ValueDeserializer::from(Spanned::new(0..0, leaf.clone()));
            let leaf = toml::Value::deserialize(leaf).map_err(|error| toml::ser::Error::custom(error.to_string()))?;
            let mut text = String::new();
            leaf.serialize(toml::ser::ValueSerializer::new(&mut text))?;
            text
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Scene;

    const TEXT: &str = "title = \"ring\" # a comment
[bearing]
diameter = \"75 mm\"
length = \"75 mm\"
clearance = \"37.5 um\"
[[feed]]
group = \"hole\"
hole = { diameter = \"5 mm\", angle = \"90 deg\", z = \"0 mm\" }
pressure = \"1 bar\"
[journal]
speed = \"10 rad/s\"
eccentricity = 0.6
min_film_angle = \"180 deg\"
[oil]
viscosity = \"0.4 Pa.s\"
";

    fn scene(text: &str) -> Scene {
        Scene::parse(text, Path::new("ring.toml"), &[]).unwrap_or_else(|error| panic!("{error}\n{text}"))
    }

    fn after(changes: &str) -> Result<Scene, SceneError> {
        changed(TEXT, Path::new("ring.toml"), changes).map(|text| scene(&text))
    }

    #[test]
    fn keys_are_set_by_their_names_as_axes() {
        let changes = "speed = [\"20 rad/s\"]\n\"journal.eccentricity\" = [0.5]\n\"oil.barus.alpha\" = [\"1e-8 1/Pa\"]\n\"feed.hole.pressure\" = [\"2 bar\"]\n";
        let [before, after] = [scene(TEXT), after(changes).expect("a scene")];
        assert_eq!(after.journal.speed, 20.0);
        assert_eq!(after.title, "ring");
        assert_eq!(after.feeds[0].pressure, Some(2e5));
        assert_eq!(after.bearing, before.bearing);
        assert_ne!(after.oil, before.oil);
        assert_eq!(after.sha256.len(), 64);
        let worn = format!(
            "{TEXT}[[bore]]\ncrown = \"1 um\"\n[[bore]]\nworn = {{ depth = \"3 um\", angle = \"90 deg\", half_width = \"40 deg\" }}\n"
        );
        let changes = "\"bore.crown\" = [\"2 um\"]\n\"bore.worn.depth\" = [\"7 um\"]\n";
        let text = super::changed(&worn, Path::new("ring.toml"), changes).expect("a text");
        assert_eq!(scene(&text).bores, scene(&worn.replace("1 um", "2 um").replace("3 um", "7 um")).bores);
        let changes = "eccentricity = [\"0.55 .. 0.65\"]\nspeed = [\"20 rad/s +- 5 %\"]\n";
        let toleranced = scene(&super::changed(TEXT, Path::new("ring.toml"), changes).expect("a text"));
        let widths: Vec<f64> = toleranced.tolerances.iter().map(|tolerance| tolerance.half_width).collect();
        assert!(widths.len() == 2 && toleranced.journal.speed == 20.0, "{widths:?}");
        let mesh = super::changed(TEXT, Path::new("ring.toml"), "\"mesh.file\" = [\"3-ring.msh\"]").expect("a text");
        assert!(mesh.contains("file = \"3-ring.msh\""), "{mesh}");
    }

    #[test]
    fn what_is_no_key_or_no_value_is_refused_by_its_name() {
        for (changes, key, words) in [
            ("sped = [1]", "sped", "not known"),
            ("jornal.speed = [1]", "jornal.speed", "no table of a scene"),
            ("eccentricity = [true]", "eccentricity", "no value"),
            ("eccentricity = [0.1, 0.2]", "eccentricity", "several values"),
            ("columns = [\"W N\"]\neccentricity = [0.1]", "columns", "no key of a scene"),
            ("\"feed.other.pressure\" = [\"1 bar\"]", "feed.other.pressure", "names no [[feed]]"),
            ("\"bore.crown\" = [\"1 um\"]", "bore.crown", "names no shape"),
        ] {
            match after(changes) {
                Err(SceneError::Complaints { complaints, .. }) => {
                    assert_eq!(complaints[0].key, key, "{complaints:?}");
                    assert!(complaints[0].message.contains(words), "{complaints:?}");
                }
                other => panic!("{changes}: {other:?}"),
            }
        }
    }

    #[test]
    fn axes_are_added_or_replaced() {
        let path = Path::new("ring.toml");
        let once = with_axes(TEXT, path, "[sweep]\neccentricity = [0.1, 0.2]\n").expect("a text");
        assert!(once.contains("# a comment"));
        assert_eq!(scene(&once).sweep.expect("a sweep").cases(), 2);
        let twice = with_axes(&once, path, "[sweep]\nspeed = [\"1 rpm\", \"2 rpm\", \"3 rpm\"]\n").expect("a text");
        let plan = scene(&twice).sweep.expect("a sweep");
        assert_eq!((plan.axes.len(), plan.cases()), (1, 3));
        let ordered = "[sweep]\nspeed = { from = \"1 rpm\", to = \"2 rpm\", steps = 2 }\neccentricity = [0.1]\nclearance = [\"30 um\"]\n";
        let text = with_axes(TEXT, path, ordered).and_then(|text| changed(&text, path, "length = [\"50 mm\"]"));
        let axes = scene(&text.expect("a text")).sweep.expect("a sweep").axes;
        let names: Vec<_> = axes.iter().map(|axis| axis.name.as_str()).collect();
        assert_eq!(names, ["speed", "eccentricity", "clearance"]);
    }
}
