//! Results as JSON: every number is finite, and every name stands once.

use ciborium::Value;
use oilwedge_campaign::AddOns;
use oilwedge_study::result::RunResult;
use serde::Serialize;

/// Why a result was not written.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ReportError {
    /// A number is NaN or infinite.
    #[error("{name} is {value}, which is no number to report; this is a fault of the program, please report the scene")]
    NotFinite {
        /// Where the number stands in the result.
        name: String,
        /// The number.
        value: f64,
    },
    /// Two values bear one name.
    #[error("{name} is reported twice; this is a fault of the program, please report the scene")]
    Twice {
        /// The name.
        name: String,
    },
    /// The writer of JSON failed.
    #[error("the result cannot be written as JSON: {0}")]
    Json(String),
}

/// A value as JSON, with a line break at its end.
///
/// # Errors
/// [`ReportError`] where a number is not finite or two values of one object bear the same name.
pub fn json(value: &impl Serialize) -> Result<String, ReportError> {
    let fault = |error: &dyn std::fmt::Display| ReportError::Json(error.to_string());
    check("", &Value::serialized(value).map_err(|error| fault(&error))?)?;
    let text = serde_json::to_string_pretty(value).map_err(|error| fault(&error))?;
    Ok(text + "\n")
}

/// The text of `result.json`.
///
/// # Errors
/// As [`json`].
pub fn result_json(result: &RunResult, add_ons: &AddOns) -> Result<String, ReportError> {
    #[derive(Serialize)]
    struct Whole<'a> {
        #[serde(flatten)]
        result: &'a RunResult,
        #[serde(flatten)]
        add_ons: &'a AddOns,
    }
    json(&Whole { result, add_ons })
}

fn check(place: &str, value: &Value) -> Result<(), ReportError> {
    let inner = |name: &dyn std::fmt::Display| match place {
        "" => name.to_string(),
        place => format!("{place}.{name}"),
    };
    match value {
        Value::Float(number) if !number.is_finite() => Err(ReportError::NotFinite {
            name: place.to_owned(),
            value: *number,
        }),
        Value::Array(values) => (values.iter().enumerate()).try_for_each(|(index, value)| check(&inner(&index), value)),
        Value::Map(entries) => (entries.iter().enumerate()).try_for_each(|(index, (key, value))| {
            let name = inner(&key.as_text().unwrap_or_default());
            match entries[..index].iter().any(|(other, _)| other == key) {
                true => Err(ReportError::Twice { name }),
                false => check(&name, value),
            }
        }),
        _ => Ok(()),
    }
}

#[cfg(test)]
pub(crate) mod tests;
