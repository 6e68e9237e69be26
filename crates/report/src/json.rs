//! Results as JSON: every number is finite, and every name stands once.

use crate::Error;
use ciborium::Value;
use oilwedge_campaign::AddOn;
use oilwedge_study::result::RunResult;
use serde::{Serialize, Serializer};

/// A value as JSON, with a line break at its end.
///
/// # Errors
/// [`Error`] where a number is not finite or two values of one object bear the same name.
pub fn json(value: &impl Serialize) -> Result<String, Error> {
    check("", &Value::serialized(value).map_err(Error::format("JSON"))?)?;
    let text = serde_json::to_string_pretty(value).map_err(Error::format("JSON"))?;
    Ok(text + "\n")
}

/// The text of `result.json`.
///
/// # Errors
/// As [`json`].
pub fn result_json(result: &RunResult, add_ons: &[AddOn]) -> Result<String, Error> {
    #[derive(Serialize)]
    struct Whole<'a> {
        #[serde(flatten)]
        result: &'a RunResult,
        #[serde(flatten, serialize_with = "by_key")]
        add_ons: &'a [AddOn],
    }
    fn by_key<S: Serializer>(add_ons: &&[AddOn], serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(add_ons.iter().map(|it| (it.key, &it.record)))
    }
    json(&Whole { result, add_ons })
}

fn check(place: &str, value: &Value) -> Result<(), Error> {
    let inner = |name: &dyn std::fmt::Display| match place {
        "" => name.to_string(),
        place => format!("{place}.{name}"),
    };
    match value {
        Value::Float(number) if !number.is_finite() => Err(Error::NotFinite {
            name: place.to_owned(),
            value: *number,
        }),
        Value::Array(values) => (values.iter().enumerate()).try_for_each(|(index, value)| check(&inner(&index), value)),
        Value::Map(entries) => (entries.iter().enumerate()).try_for_each(|(index, (key, value))| {
            let name = inner(&key.as_text().unwrap_or_default());
            match entries[..index].iter().any(|(other, _)| other == key) {
                true => Err(Error::Twice { name }),
                false => check(&name, value),
            }
        }),
        _ => Ok(()),
    }
}

#[cfg(test)]
pub(crate) mod tests;
