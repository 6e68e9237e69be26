//! What differs between two results, and between two scenes.

use crate::Error;
use serde::Serialize;
use serde_json::{Map, Value};

/// A key of a scene or result whose value differs.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Changed {
    /// The key with its tables.
    pub key: String,
    /// Its value in the first; `null` where it is absent.
    pub a: Value,
    /// Its value in the second; `null` where it is absent.
    pub b: Value,
}

/// A quantity whose value differs.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ChangedQuantity {
    /// Its name.
    pub name: String,
    /// Its unit.
    pub unit: String,
    /// Value of the first; `null` where it is absent.
    pub a: Option<f64>,
    /// Value of the second; `null` where it is absent.
    pub b: Option<f64>,
    /// `b - a`; of angles the lesser way round.
    pub change: Option<f64>,
    /// Sum of the half widths of both error bars; `null` where one has none.
    pub bars: Option<f64>,
    /// Whether the change is more than this sum and the round-off of the greatest value of this unit, so that the bars do not overlap; `null`
    /// where it cannot be known.
    pub exceeds_bars: Option<bool>,
}

/// All that differs.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct Difference {
    /// Keys of the scenes; empty where one of the two is a folder of results, which holds no scene.
    pub keys: Vec<Changed>,
    /// Facts of the results that differ: status, scene, mesh file, effects, geometry.
    pub facts: Vec<Changed>,
    /// Quantities.
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
const FACTS: [&str; 6] = ["status", "reason", "scene_sha256", "mesh_sha256", "effects", "geometry"];

/// What differs between two results, the texts of `result.json` as values.
pub fn of_results(a: &Value, b: &Value) -> Difference {
    let mut facts = Vec::new();
    for name in FACTS {
        compare(name, &a[name], &b[name], &mut facts);
    }
    Difference {
        keys: Vec::new(),
        facts,
        quantities: quantities(&a["quantities"], &b["quantities"]),
    }
}

/// Keys whose values differ between the texts of two scenes.
///
/// # Errors
/// [`Error::Unreadable`]: one of them is no TOML.
pub fn of_scenes(a: &str, b: &str) -> Result<Vec<Changed>, Error> {
    let value = |text: &str| {
        toml::from_str::<Value>(text).map_err(|error| Error::Unreadable {
            format: "scene",
            message: error.to_string(),
        })
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
    match (a, b) {
        (Value::Object(a), Value::Object(b)) => {
            let absent = Value::Null;
            for name in names(a, b) {
                compare(
                    &below(name),
                    a.get(name).unwrap_or(&absent),
                    b.get(name).unwrap_or(&absent),
                    changed,
                );
            }
        }
        _ => changed.push(Changed {
            key: path.to_owned(),
            a: a.clone(),
            b: b.clone(),
        }),
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
        let exceeds = |(change, bars): (f64, f64)| change.abs() > bars + round_off;
        changed.exceeds_bars = changed.change.zip(changed.bars).map(exceeds);
        Some(changed)
    };
    names(a, b).filter_map(changed).collect()
}

/// The greatest magnitude of the quantities of a unit.
fn greatest(quantities: &Map<String, Value>, unit: &str) -> f64 {
    let of_unit = quantities.values().filter(|entry| entry["unit"] == unit);
    of_unit
        .filter_map(|entry| entry["value"].as_f64())
        .fold(0.0, |greatest, value| greatest.max(value.abs()))
}

fn quantity(name: &str, a: Option<&Value>, b: Option<&Value>) -> Option<ChangedQuantity> {
    let number = |entry: Option<&Value>, key: &str| entry?.get(key)?.as_f64();
    let (first, second) = (number(a, "value"), number(b, "value"));
    let row = oilwedge_study::quantities::row(name);
    let change = first
        .zip(second)
        .map(|(a, b)| row.map_or(b - a, |row| row.difference(b, a)));
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
        assert!(of_results(&a, &a).is_none());
        let exceeds =
            |load: f64, error: Option<f64>| of_results(&a, &result(load, error, 359.0)).quantities[0].exceeds_bars;
        assert_eq!(exceeds(102.9, Some(2.0)), Some(false));
        assert_eq!(exceeds(96.9, Some(2.0)), Some(true));
        assert_eq!(exceeds(96.9, None), None);
        // Angles differ the lesser way round.
        let turned = of_results(&a, &result(100.0, Some(1.0), 1.0)).quantities;
        assert_eq!((turned[0].change, turned[0].exceeds_bars), (Some(2.0), Some(true)));
    }

    #[test]
    fn keys_differ_by_path() -> Result<(), Error> {
        let scene = |from: &str| format!("[bearing]\ndiameter = \"75 mm\"\narc = {{ from = \"{from}\" }}");
        let changed = of_scenes(&scene("40 deg"), &scene("50 deg"))?;
        assert_eq!(changed.len(), 1);
        assert_eq!(
            (changed[0].key.as_str(), &changed[0].b),
            ("bearing.arc.from", &json!("50 deg"))
        );
        let added = of_scenes("", "load.force = '5 kN'")?;
        assert_eq!((added[0].key.as_str(), &added[0].a), ("load", &Value::Null));
        Ok(())
    }
}
