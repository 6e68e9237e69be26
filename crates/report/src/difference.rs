//! What differs between two results, and between two scenes.

use std::collections::BTreeSet;

use crate::Error;
use crate::comparison::sheet;
use oilwedge_campaign::{Alternative, Comparison, QuantityPair};
use oilwedge_study::quantities::{CATALOGUE, Quantity, Unit};
use oilwedge_study::result::RunResult;
use serde::{Serialize, Serializer};
use serde_json::{Map, Value, json};

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

/// All that differs.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct Difference {
    /// Keys of the scenes; those of a list of tables by their number in it, `feed[0].pressure`.
    pub keys: Vec<Changed>,
    /// Facts of the results that differ: status, reason, mesh, and the effects that only one of the two has; check sum
    /// of the scene and geometry where a result does not hold the text of its scene.
    pub facts: Vec<Changed>,
    /// Quantities that differ by more than round-off, in the order of the catalogue.
    #[serde(serialize_with = "in_json")]
    pub quantities: Vec<QuantityPair>,
}

impl Difference {
    /// Whether nothing differs.
    pub fn is_none(&self) -> bool {
        self.keys.is_empty() && self.facts.is_empty() && self.quantities.is_empty()
    }

    /// The quantities of both side by side, and how many of their changes exceed the error bars.
    pub fn table(&self) -> String {
        let count = |wanted| self.quantities.iter().filter(|it| it.exceeds_bars() == wanted).count();
        let (more, of) = (count(Some(true)), self.quantities.len());
        let unknown = match count(None) {
            0 => String::new(),
            unknown => format!("; of {unknown} it is not known"),
        };
        let note = format!("{more} of {of} changed quantities exceed both error bars together{unknown}");
        let b = Alternative { name: "B".to_owned(), pairs: self.quantities.clone(), seconds: None };
        sheet(&Comparison { film: "A".to_owned(), alternatives: vec![b], notes: vec![note], ..Comparison::default() })
            .terminal()
    }
}

fn in_json<S: Serializer>(quantities: &[QuantityPair], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(quantities.iter().map(|it| {
        let [a, b] = it.values();
        let (unit, change, bars) = (it.row.unit.name(), it.difference(), it.error());
        json!({ "name": it.name, "unit": unit, "a": a, "b": b, "change": change, "bars": bars,
            "exceeds_bars": it.exceeds_bars() })
    }))
}

/// Round-off relative to the greatest value of a unit [1].
const ROUND_OFF: f64 = 1e-12;

/// What differs between two results.
///
/// # Errors
/// [`Error::Unreadable`]: the scene of one of them is no TOML.
pub fn of_results(a: &RunResult, b: &RunResult) -> Result<Difference, Error> {
    let mut facts = Vec::new();
    let mut fact = |key: &str, [a, b]: [Value; 2]| compare(key, &a, &b, &mut facts);
    let of_both = |value: &dyn Fn(&RunResult) -> Value| [a, b].map(value);
    let keys = match a.head.scene.is_empty() || b.head.scene.is_empty() {
        // A comment makes another text of the same scene, so the check sums are not compared.
        false => of_scenes(&a.head.scene, &b.head.scene)?,
        true => {
            fact("scene_sha256", of_both(&|it| json!(it.head.scene_sha256)));
            fact("geometry", of_both(&|it| json!(it.geometry)));
            Vec::new()
        }
    };
    fact("status", of_both(&|it| json!(it.head.status)));
    fact("reason", of_both(&|it| json!(it.head.reason)));
    fact("mesh_sha256", of_both(&|it| json!(it.head.mesh_sha256)));
    let less = |a: &RunResult, b: &RunResult| {
        let others = &b.effects.simulated;
        a.effects.simulated.iter().filter(|effect| !others.contains(effect)).map(|effect| effect.name).collect()
    };
    fact("effects", [less(a, b), less(b, a)]);
    Ok(Difference { keys, facts, quantities: quantities(&a.quantities, &b.quantities) })
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

fn quantities(a: &[Quantity], b: &[Quantity]) -> Vec<QuantityPair> {
    let names: BTreeSet<&str> = a.iter().chain(b).map(|it| it.name.as_ref()).collect();
    let pairs = names.into_iter().filter_map(|name| {
        let [first, second] = [a, b].map(|all| all.iter().find(|it| it.name == name));
        QuantityPair::between(first, second)
    });
    let is_changed = |it: &QuantityPair| {
        let round_off = ROUND_OFF * greatest(a, it.row.unit).max(greatest(b, it.row.unit));
        it.difference().is_none_or(|change| change.abs() > round_off)
    };
    let mut all: Vec<_> = pairs.filter(is_changed).collect();
    all.sort_by_key(|it| CATALOGUE.iter().position(|row| row.has(&it.name)));
    all
}

/// The greatest magnitude of the quantities of a unit.
fn greatest(quantities: &[Quantity], unit: Unit) -> f64 {
    let of_unit = quantities.iter().filter(|it| it.row.unit == unit);
    of_unit.fold(0.0, |greatest, it| it.value.abs().max(greatest))
}

#[cfg(test)]
mod tests {
    use super::*;
    use oilwedge_study::effects::{EFFECTS, Effect, Effects};
    use oilwedge_study::quantities::{Bar, LOAD, LOAD_ANGLE};
    use oilwedge_study::result::ResultHead;

    fn result(load: f64, error: Option<f64>, angle: f64) -> RunResult {
        let quantity =
            |row, value, error: Option<f64>| Quantity { bar: error.map(Bar::of), ..Quantity::new(row, value) };
        let quantities = vec![quantity(&LOAD, load, error), quantity(&LOAD_ANGLE, angle, Some(0.5))];
        RunResult { quantities, ..RunResult::default() }
    }

    #[test]
    fn a_change_is_held_against_both_bars() {
        let a = result(100.0, Some(1.0), 359.0);
        let to = |b: &RunResult| of_results(&a, b).expect("a difference");
        assert!(to(&a).is_none());
        let exceeds = |load: f64, error: Option<f64>| to(&result(load, error, 359.0)).quantities[0].exceeds_bars();
        assert_eq!(exceeds(102.9, Some(2.0)), Some(false));
        assert_eq!(exceeds(96.9, Some(2.0)), Some(true));
        assert_eq!(exceeds(96.9, None), None);
        // Angles differ the lesser way round.
        let turned = to(&result(100.0, Some(1.0), 1.0)).quantities;
        assert_eq!((turned[0].difference(), turned[0].exceeds_bars()), (Some(2.0), Some(true)));
    }

    #[test]
    fn scenes_are_compared_by_their_keys_where_results_hold_them() -> Result<(), Error> {
        let with = |scene: &str, sum: &str| RunResult {
            head: ResultHead { scene: scene.to_owned(), scene_sha256: sum.to_owned(), ..ResultHead::default() },
            ..RunResult::default()
        };
        assert!(of_results(&with("title = 'a'", "1"), &with("title = 'a' # b", "2"))?.is_none());
        assert_eq!(of_results(&with("title = 'a'", "1"), &with("", "2"))?.facts[0].key, "scene_sha256");
        Ok(())
    }

    #[test]
    fn effects_of_one_alone_are_listed() -> Result<(), Error> {
        let with = |simulated: &[&'static Effect]| RunResult {
            effects: Effects { simulated: simulated.to_vec(), not_simulated: Vec::new() },
            ..RunResult::default()
        };
        let [first, second, third] = [EFFECTS[0], EFFECTS[1], EFFECTS[2]];
        let facts = of_results(&with(&[first, second]), &with(&[first, third]))?.facts;
        assert_eq!((&facts[0].a, &facts[0].b), (&json!([second.name]), &json!([third.name])));
        assert!(of_results(&with(&[first]), &with(&[first]))?.is_none());
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
