//! What differs between two results, and between two scenes.

use crate::Error;
use oilwedge_study::quantities::CATALOGUE;
use serde::Serialize;
use serde_json::{Map, Value};

/// A key of a scene or result whose value differs.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Changed {
    /// The key with its tables.
    pub key: String,
    /// Value in the first scene or result; `null` where it is absent.
    pub a: Value,
    /// Value in the second scene or result; `null` where it is absent.
    pub b: Value,
}

/// A quantity whose value differs.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ChangedQuantity {
    /// Name of the quantity.
    pub name: String,
    /// Unit of the quantity.
    pub unit: String,
    /// Value of the first; `null` where it is absent.
    pub a: Option<f64>,
    /// Value of the second; `null` where it is absent.
    pub b: Option<f64>,
    /// `b - a`; of angles the lesser way round.
    pub change: Option<f64>,
    /// Sum of the half widths of both error bars; `null` where one has none.
    pub bars: Option<f64>,
    /// Whether the change is more than this sum, so that the bars do not overlap; `null` where it cannot be known.
    pub exceeds_bars: Option<bool>,
}

/// All that differs.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct Difference {
    /// Keys of the scenes; those of a list of tables by their number in it, `feed[0].pressure`.
    pub keys: Vec<Changed>,
    /// Facts of the results that differ: status, reason, mesh, and the effects that only one of the two has; check sum
    /// of the scene and geometry where a result does not hold the text of its scene.
    pub facts: Vec<Changed>,
    /// Quantities that differ by more than round-off, in the order of the catalogue.
    pub quantities: Vec<ChangedQuantity>,
}

impl Difference {
    /// Whether nothing differs.
    pub fn is_none(&self) -> bool {
        self.keys.is_empty() && self.facts.is_empty() && self.quantities.is_empty()
    }
}

/// Round-off relative to the greatest value of a unit [1].
const ROUND_OFF: f64 = 1e-12;

/// The facts of a result that are compared.
const FACTS: [&str; 3] = ["status", "reason", "mesh_sha256"];
/// Facts that follow from the scene, and are compared where a result does not hold its text.
const FACTS_OF_SCENE: [&str; 2] = ["scene_sha256", "geometry"];

/// What differs between two results, the texts of `result.json` as values.
///
/// # Errors
/// [`Error::Unreadable`]: the scene of one of them is no TOML.
pub fn of_results(a: &Value, b: &Value) -> Result<Difference, Error> {
    let mut facts = Vec::new();
    let keys = match (a["scene"].as_str(), b["scene"].as_str()) {
        // A comment makes another text of the same scene, so the check sums are not compared.
        (Some(a), Some(b)) => of_scenes(a, b)?,
        _ => {
            for name in FACTS_OF_SCENE {
                compare(name, &a[name], &b[name], &mut facts);
            }
            Vec::new()
        }
    };
    for name in FACTS {
        compare(name, &a[name], &b[name], &mut facts);
    }
    let [first, second] = [a, b].map(|side| &side["effects"]["simulated"]);
    compare("effects", &less(first, second), &less(second, first), &mut facts);
    Ok(Difference { keys, facts, quantities: quantities(&a["quantities"], &b["quantities"]) })
}

/// The items of a list that are not in another one.
fn less(list: &Value, other: &Value) -> Value {
    let items = |list: &Value| list.as_array().cloned().unwrap_or_default();
    let other = items(other);
    items(list).into_iter().filter(|item| !other.contains(item)).collect()
}

/// Keys whose values differ between the texts of two scenes.
fn of_scenes(a: &str, b: &str) -> Result<Vec<Changed>, Error> {
    let value = |text: &str| {
        toml::from_str::<Value>(text).map_err(|error| Error::Unreadable { format: "scene", message: error.to_string() })
    };
    let mut changed = Vec::new();
    compare("", &value(a)?, &value(b)?, &mut changed);
    Ok(changed)
}

fn compare(path: &str, a: &Value, b: &Value, changed: &mut Vec<Changed>) {
    if a == b {
        return;
    }
    let below = |name: &str| match path.is_empty() {
        true => name.to_owned(),
        false => format!("{path}.{name}"),
    };
    let absent = Value::Null;
    match (a, b) {
        (Value::Object(_), Value::Object(_)) | (Value::Object(_), Value::Null) | (Value::Null, Value::Object(_)) => {
            let none = Map::new();
            let [a, b] = [a, b].map(|side| side.as_object().unwrap_or(&none));
            let of = |side: &'_ Map<String, Value>, name: &str| side.get(name).unwrap_or(&absent).clone();
            for name in names(a, b) {
                compare(&below(name), &of(a, name), &of(b, name), changed);
            }
        }
        (Value::Array(a), Value::Array(b)) if a.iter().chain(b).all(Value::is_object) => {
            for index in 0..a.len().max(b.len()) {
                let [a, b] = [a, b].map(|side| side.get(index).unwrap_or(&absent));
                compare(&format!("{path}[{index}]"), a, b, changed);
            }
        }
        _ => changed.push(Changed { key: path.to_owned(), a: a.clone(), b: b.clone() }),
    }
}

/// The keys of both, those of the second that are not of the first at the end.
fn names<'a>(a: &'a Map<String, Value>, b: &'a Map<String, Value>) -> impl Iterator<Item = &'a str> {
    let others = b.keys().filter(|name| !a.contains_key(name.as_str()));
    a.keys().chain(others).map(String::as_str)
}

fn quantities(a: &Value, b: &Value) -> Vec<ChangedQuantity> {
    let empty = Map::new();
    let (a, b) = (a.as_object().unwrap_or(&empty), b.as_object().unwrap_or(&empty));
    let changed = |name| {
        let mut changed = quantity(name, a.get(name), b.get(name))?;
        let round_off = ROUND_OFF * greatest(a, &changed.unit).max(greatest(b, &changed.unit));
        if changed.change.is_some_and(|change| change.abs() <= round_off) {
            return None;
        }
        let exceeds = |(change, bars): (f64, f64)| change.abs() > bars;
        changed.exceeds_bars = changed.change.zip(changed.bars).map(exceeds);
        Some(changed)
    };
    let mut all: Vec<_> = names(a, b).filter_map(changed).collect();
    all.sort_by_key(|quantity| CATALOGUE.iter().position(|row| row.has(&quantity.name)));
    all
}

/// The greatest magnitude of the quantities of a unit.
fn greatest(quantities: &Map<String, Value>, unit: &str) -> f64 {
    let of_unit = quantities.values().filter(|entry| entry["unit"] == unit);
    of_unit.filter_map(|entry| entry["value"].as_f64()).fold(0.0, |greatest, value| greatest.max(value.abs()))
}

fn quantity(name: &str, a: Option<&Value>, b: Option<&Value>) -> Option<ChangedQuantity> {
    let number = |entry: Option<&Value>, key: &str| entry?.get(key)?.as_f64();
    let (first, second) = (number(a, "value"), number(b, "value"));
    let row = oilwedge_study::quantities::row(name);
    let change = first.zip(second).map(|(a, b)| row.map_or(b - a, |row| row.difference(b, a)));
    if first == second {
        return None;
    }
    let bars = number(a, "error").zip(number(b, "error")).map(|(a, b)| a + b);
    let unit = a.or(b).and_then(|entry| entry["unit"].as_str()).unwrap_or_default();
    Some(ChangedQuantity {
        name: name.to_owned(),
        unit: unit.to_owned(),
        a: first,
        b: second,
        change,
        bars,
        exceeds_bars: None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn result(load: f64, error: Option<f64>, angle: f64) -> Value {
        let entry =
            |value: f64, unit: &str, error: Option<f64>| json!({ "value": value, "unit": unit, "error": error });
        json!({ "status": "converged", "quantities": { "load": entry(load, "N", error), "load_angle": entry(angle, "deg", Some(0.5)) } })
    }

    #[test]
    fn a_change_is_held_against_both_bars() {
        let a = result(100.0, Some(1.0), 359.0);
        let to = |b: &Value| of_results(&a, b).expect("a difference");
        assert!(to(&a).is_none());
        let exceeds = |load: f64, error: Option<f64>| to(&result(load, error, 359.0)).quantities[0].exceeds_bars;
        assert_eq!(exceeds(102.9, Some(2.0)), Some(false));
        assert_eq!(exceeds(96.9, Some(2.0)), Some(true));
        assert_eq!(exceeds(96.9, None), None);
        // Angles differ the lesser way round.
        let turned = to(&result(100.0, Some(1.0), 1.0)).quantities;
        assert_eq!((turned[0].change, turned[0].exceeds_bars), (Some(2.0), Some(true)));
    }

    #[test]
    fn scenes_are_compared_by_their_keys_where_results_hold_them() -> Result<(), Error> {
        let with = |scene: &str, sum: &str| json!({ "scene": scene, "scene_sha256": sum });
        assert!(of_results(&with("title = 'a'", "1"), &with("title = 'a' # b", "2"))?.is_none());
        let without = json!({ "scene_sha256": "2" });
        assert_eq!(of_results(&with("", "1"), &without)?.facts[0].key, "scene_sha256");
        Ok(())
    }

    #[test]
    fn effects_of_one_alone_are_listed() -> Result<(), Error> {
        let with = |effects: &[&str]| json!({ "scene": "", "effects": { "simulated": effects } });
        let facts = of_results(&with(&["couette", "barus"]), &with(&["couette", "heat"]))?.facts;
        assert_eq!((&facts[0].a, &facts[0].b), (&json!(["barus"]), &json!(["heat"])));
        assert!(of_results(&with(&["couette"]), &with(&["couette"]))?.is_none());
        Ok(())
    }

    #[test]
    fn keys_differ_by_path() -> Result<(), Error> {
        let scene = |from: &str| format!("[bearing]\ndiameter = \"75 mm\"\narc = {{ from = \"{from}\" }}");
        let changed = of_scenes(&scene("40 deg"), &scene("50 deg"))?;
        assert_eq!(changed.len(), 1);
        assert_eq!((changed[0].key.as_str(), &changed[0].b), ("bearing.arc.from", &json!("50 deg")));
        let added = of_scenes("", "load.force = '5 kN'")?;
        assert_eq!((added[0].key.as_str(), &added[0].a), ("load.force", &Value::Null));
        let feeds = of_scenes(
            "feed = [{ group = 'a', pressure = '1 bar' }]",
            "feed = [{ group = 'a', pressure = '2 bar' }, { group = 'b' }]",
        )?;
        let keys: Vec<_> = feeds.iter().map(|feed| feed.key.as_str()).collect();
        assert_eq!(keys, ["feed[0].pressure", "feed[1].group"]);
        Ok(())
    }
}
