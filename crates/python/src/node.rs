//! Objects of Python as TOML, in the order in which they are given: the order of axes is that of cases.

use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyFloat, PyInt, PyList, PyMapping, PyString, PyTuple};
use serde::{Serialize, Serializer};

/// Deepest value that is read; a scene has four.
const DEEPEST: usize = 64;
/// Letters of its key that are shown.
const MOST_SHOWN: usize = 60;

/// A value of TOML.
#[derive(Debug, Clone)]
enum TomlNode {
    Text(String),
    Truth(bool),
    Integer(i64),
    Float(f64),
    List(Vec<TomlNode>),
    Table(Vec<(String, TomlNode)>),
}

impl Serialize for TomlNode {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Text(text) => serializer.serialize_str(text),
            Self::Truth(truth) => serializer.serialize_bool(*truth),
            Self::Integer(number) => serializer.serialize_i64(*number),
            Self::Float(number) => serializer.serialize_f64(*number),
            Self::List(items) => serializer.collect_seq(items),
            Self::Table(entries) => serializer.collect_map(entries.iter().map(|(key, value)| (key, value))),
        }
    }
}

impl TomlNode {
    /// The value of an object; `key` is where it stands, and `depth` how far below the whole.
    ///
    /// # Errors
    /// TOML has no such value, or it lies deeper than [`DEEPEST`].
    fn of(object: &Bound<'_, PyAny>, key: &str, depth: usize) -> PyResult<Self> {
        if depth > DEEPEST {
            return Err(PyTypeError::new_err(format!(
                "{}: lists and dicts lie more than {DEEPEST} deep; a scene has tables of values",
                key.chars().take(MOST_SHOWN).collect::<String>()
            )));
        }
        if object.is_instance_of::<PyString>() {
            return Ok(Self::Text(object.extract()?));
        }
        if object.is_instance_of::<PyBool>() {
            return Ok(Self::Truth(object.extract()?));
        }
        if object.is_instance_of::<PyInt>() {
            let number = object.extract().map_err(|_| {
                PyValueError::new_err(format!("{key}: the whole number {object} has more digits than a scene may have"))
            })?;
            return Ok(Self::Integer(number));
        }
        if object.is_instance_of::<PyFloat>() {
            return Ok(Self::Float(object.extract()?));
        }
        if object.is_instance_of::<PyDict>() || object.cast::<PyMapping>().is_ok() {
            return table(object, key, depth).map(Self::Table);
        }
        if object.is_instance_of::<PyList>() || object.is_instance_of::<PyTuple>() {
            let items = object.try_iter()?.map(|item| Self::of(&item?, key, depth + 1));
            return items.collect::<PyResult<_>>().map(Self::List);
        }
        // Numbers and arrays of numpy, columns of pandas.
        if let Ok(plain) = object.call_method0("tolist") {
            return Self::of(&plain, key, depth + 1);
        }
        if let Ok(path) = object.call_method0("__fspath__") {
            return Self::of(&path, key, depth + 1);
        }
        let kind = object.get_type().name()?.to_string();
        Err(PyTypeError::new_err(format!(
            "{key}: a {kind} is no value of a scene; give a text with its unit, a number, a list or a dict, and leave out a key that has no value"
        )))
    }

    /// The value in a line, as it stands behind `=`.
    fn line(&self) -> PyResult<String> {
        let mut text = String::new();
        let inner = toml::ser::ValueSerializer::new(&mut text);
        self.serialize(inner).map(drop).map_err(refused)?;
        Ok(text)
    }
}

/// A mapping as a document of TOML.
///
/// # Errors
/// It is no mapping, or holds what TOML has not.
pub(crate) fn document(object: &Bound<'_, PyAny>) -> PyResult<String> {
    if object.cast::<PyMapping>().is_err() {
        let kind = object.get_type().name()?.to_string();
        return Err(PyTypeError::new_err(format!(
            "a scene is made of a mapping, and this is a {kind}; Scene.read reads a file, Scene.parse a text"
        )));
    }
    let whole = TomlNode::Table(table(object, "", 0)?);
    toml::to_string(&whole).map_err(refused)
}

fn refused(error: toml::ser::Error) -> PyErr {
    PyValueError::new_err(format!("this cannot be written as TOML: {error}"))
}

/// The entries of a mapping in their order.
fn table(object: &Bound<'_, PyAny>, above: &str, depth: usize) -> PyResult<Vec<(String, TomlNode)>> {
    let items = object.cast::<PyMapping>()?.items()?;
    let entry = |item: Bound<'_, PyAny>| {
        let (key, value): (Bound<'_, PyAny>, Bound<'_, PyAny>) = item.extract()?;
        let key: String = key.extract().map_err(|_| {
            PyTypeError::new_err(format!("{above}: the key {key} is no text; keys of a scene are texts"))
        })?;
        let whole = match above {
            "" => key.clone(),
            above => format!("{above}.{key}"),
        };
        Ok((key, TomlNode::of(&value, &whole, depth + 1)?))
    };
    items.iter().map(entry).collect()
}

/// The lines `key = value` of a mapping, in its order.
pub(crate) fn lines(object: &Bound<'_, PyAny>, values: Values) -> PyResult<String> {
    let mut text = String::new();
    for (key, value) in table(object, "", 0)? {
        let value = match values {
            Values::Single => TomlNode::List(vec![value]),
            Values::Listed => value,
        };
        text += &format!("{} = {}\n", TomlNode::Text(key).line()?, value.line()?);
    }
    Ok(text)
}

/// What the values of a mapping are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Values {
    /// One value each, which becomes a list of one.
    Single,
    /// Lists and ranges.
    Listed,
}
