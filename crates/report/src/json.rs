//! Results as JSON: every number is finite, and every name stands once.

use crate::Error;
use ciborium::Value;
use oilwedge_campaign::Records;
use oilwedge_study::result::RunResult;
use serde::{Deserialize, Serialize};

/// A value as JSON, with a line break at its end.
///
/// # Errors
/// [`Error`] where a number is not finite or two values of one object bear the same name.
pub fn json(value: &impl Serialize) -> Result<String, Error> {
    check(&Value::serialized(value).map_err(Error::format("JSON"))?)?;
    let text = serde_json::to_string_pretty(value).map_err(Error::format("JSON"))?;
    Ok(text + "\n")
}

/// Everything in `result.json` of a film or an orbit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ResultFile {
    /// The run.
    #[serde(flatten)]
    pub result: RunResult,
    /// What was asked for beside it.
    #[serde(flatten)]
    pub records: Records,
}

/// The text of `result.json`.
///
/// # Errors
/// As [`json`].
pub fn result_json(result: &RunResult, records: &Records) -> Result<String, Error> {
    json(&ResultFile { result: result.clone(), records: records.clone() })
}

/// What a value must not hold.
enum JsonFault {
    NotFinite(f64),
    Twice,
}

fn check(value: &Value) -> Result<(), Error> {
    match fault(value) {
        None => Ok(()),
        Some((name, JsonFault::NotFinite(value))) => Err(Error::NotFinite { name, value }),
        Some((name, JsonFault::Twice)) => Err(Error::Twice { name }),
    }
}

/// The first fault of a value, and its place in it as `heat.curve.3`.
fn fault(value: &Value) -> Option<(String, JsonFault)> {
    let within = |name: &dyn std::fmt::Display, value: &Value| {
        let (place, fault) = fault(value)?;
        let name = match place.is_empty() {
            true => name.to_string(),
            false => format!("{name}.{place}"),
        };
        Some((name, fault))
    };
    match value {
        Value::Float(number) => (!number.is_finite()).then(|| (String::new(), JsonFault::NotFinite(*number))),
        Value::Array(values) => values.iter().enumerate().find_map(|(index, value)| within(&index, value)),
        Value::Map(entries) => entries.iter().enumerate().find_map(|(index, (key, value))| {
            let name = key.as_text().unwrap_or_default();
            match entries[..index].iter().any(|(other, _)| other == key) {
                true => Some((name.to_owned(), JsonFault::Twice)),
                false => within(&name, value),
            }
        }),
        _ => None,
    }
}

#[cfg(test)]
pub(crate) mod tests;
