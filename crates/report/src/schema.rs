//! The JSON schema (draft 7) of scenes, made of the catalogue of keys: for editors, and for tools that check TOML by a
//! schema.
//!
//! It knows forms, units and words, not the ranges of numbers nor keys that must fit each other: these are checked by
//! the program alone.

use oilwedge_scene::catalogue::keys;
use oilwedge_scene::keys::{Key, KeyForm};
use oilwedge_scene::sweep::SHORT_NAMES;
use oilwedge_scene::unit::{Dimension, is_composed, symbols_like};
use oilwedge_scene::{SWEPT, SWEPT_OF_SHAFT};
use oilwedge_study::quantities::CATALOGUE;
use serde_json::{Map, Value, json};
use std::collections::BTreeSet;

/// Title of the schema, by which its files are known.
pub const TITLE: &str = "Scene of oilwedge";
/// A finite decimal number.
const NUMBER: &str = r"[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?";
/// The beginning of a number with a tolerance, or of a range.
const TOLERANCE: &str = r"^\s*[+-]?[0-9.][^+±]*(\+-|\+/-|±|\.\.)\s*[+-]?[0-9.]+([eE][+-]?[0-9]+)?";
/// A product: a point, a star or a space.
const TIMES: &str = r"[\s.*·⋅]";

/// The schema.
pub fn schema() -> Value {
    let dimensions = Dimension::all().map(|dimension| (definition(dimension), quantity(dimension)));
    let axes = swept().filter_map(|key| Some((key.path.to_owned(), axis(key)?)));
    let mut schema = table("");
    schema["$schema"] = json!("http://json-schema.org/draft-07/schema#");
    schema["title"] = json!(TITLE);
    schema["description"] = json!("One journal bearing. A table that is absent is an effect that is not simulated.");
    // A crankshaft has a scene of its own, without the tables of a bearing.
    if let Some(required) = schema.as_object_mut().and_then(|schema| schema.remove("required")) {
        schema["if"] = json!({ "required": ["crankshaft"] });
        schema["else"] = json!({ "required": required });
    }
    schema["definitions"] = Value::Object(dimensions.chain(axes).collect());
    schema
}

fn definition(dimension: Dimension) -> String {
    format!("{dimension:?}")
}

/// A quantity in any spelling of its units that scenes accept.
fn quantity(dimension: Dimension) -> Value {
    let mut units: Vec<_> = dimension.units().iter().flat_map(|(unit, _)| unit_patterns(unit, dimension)).collect();
    let composed = dimension.units().iter().find(|(unit, _)| is_composed(unit, dimension));
    units.extend(composed.iter().flat_map(|(unit, _)| symbols_like(unit)).map(|symbol| spelled(&symbol)));
    let mut known = BTreeSet::new();
    units.retain(|unit| known.insert(unit.clone()));
    json!({
        "type": "string",
        "pattern": format!(r"^\s*{NUMBER}\s*({})\s*$|{TOLERANCE}\s*\S.*$", units.join("|")),
        "description": format!("{} with its unit: {}", dimension.name(), dimension.unit_names()),
        "examples": [dimension.example()],
    })
}

/// Patterns of a unit and of those composed of symbols of the same kinds, the factors of a product in either order.
fn unit_patterns(unit: &str, dimension: Dimension) -> Vec<String> {
    if !is_composed(unit, dimension) {
        return vec![unit_pattern(unit, &[])];
    }
    let symbols: Vec<&str> = unit.split(|letter: char| !letter.is_ascii_alphabetic()).collect();
    let (product, rest) = unit.split_once('/').map_or((unit, None), |(product, rest)| (product, Some(rest)));
    let turned = product.split_once('.').filter(|(_, last)| !last.contains('.')).map(|(first, last)| match rest {
        Some(rest) => format!("{last}.{first}/{rest}"),
        None => format!("{last}.{first}"),
    });
    std::iter::once(unit.to_owned()).chain(turned).map(|unit| unit_pattern(&unit, &symbols)).collect()
}

/// A pattern of the spellings of a unit: `um`, `µm`; `Pa.s`, `Pa s`, `Pa·s`; `mm2`, `mm^2`, `mm²`; `rad/s`, `rad s^-1`.
/// Others of their kinds stand for these symbols of it.
fn unit_pattern(unit: &str, symbols: &[&str]) -> String {
    let letters = |part: &str| letters(part, symbols);
    let direct = letters(unit);
    match unit.rsplit_once('/') {
        Some((front, last))
            if !last.contains(['(', '.']) && !last.ends_with(|letter: char| letter.is_ascii_digit()) =>
        {
            let front = match front {
                "1" => String::new(),
                front => format!("{}{TIMES}+", letters(front)),
            };
            format!(r"{direct}|{front}{}\^?[-⁻][1¹]", letters(last))
        }
        _ => direct,
    }
}

/// A symbol with its other spellings.
fn spelled(symbol: &str) -> String {
    let symbol = symbol.replace("deg", "(deg|°)");
    symbol.strip_prefix('u').map_or(symbol.clone(), |rest| format!("[uµμ]{rest}"))
}

fn letters(unit: &str, symbols: &[&str]) -> String {
    let (mut pattern, mut word) = (String::new(), String::new());
    let end = |word: &mut String, pattern: &mut String| {
        let alike = if symbols.contains(&word.as_str()) { symbols_like(word) } else { Vec::new() };
        // A prefix that its kind lacks may stand in the unit, as in mPa.s.
        let own = Some(word.clone()).filter(|own| !alike.contains(own));
        let all: Vec<String> = own.iter().chain(&alike).map(|symbol| spelled(symbol)).collect();
        *pattern += &if alike.is_empty() { spelled(word) } else { format!("({})", all.join("|")) };
        word.clear();
    };
    for letter in unit.chars() {
        if letter.is_ascii_alphabetic() {
            word.push(letter);
            continue;
        }
        end(&mut word, &mut pattern);
        pattern += &mark(letter);
    }
    end(&mut word, &mut pattern);
    pattern
}

/// What stands between the symbols of a unit, with its other spellings.
fn mark(letter: char) -> String {
    match letter {
        '.' => format!("{TIMES}+"),
        '/' => format!("{TIMES}*/{TIMES}*"),
        '2' => r"\^?[2²]".to_owned(),
        '3' => r"\^?[3³]".to_owned(),
        '(' | ')' => format!(r"\{letter}"),
        letter => letter.to_string(),
    }
}

/// The keys of the table at `path`; the empty path is the whole scene.
fn children(path: &str) -> impl Iterator<Item = (&'static Key, &'static str)> + '_ {
    keys().filter_map(move |key| {
        let (table, name) = key.table_and_name();
        (table == path).then_some((key, name))
    })
}

/// A table with its keys, and no others.
fn table(path: &str) -> Value {
    let required: Vec<_> = children(path).filter(|(key, _)| key.is_required()).map(|(_, name)| name).collect();
    match path {
        "sweep" => return sweep(),
        "design.free" | "design.choose" => return named_axes(Map::new()),
        "mesh.tolerance" => return tolerances(),
        _ => (),
    }
    let properties: Map<_, _> = children(path).map(|(key, name)| (name.to_owned(), of_key(key))).collect();
    let mut table = json!({ "type": "object", "properties": properties, "additionalProperties": false });
    if !required.is_empty() {
        table["required"] = json!(required);
    }
    table
}

/// A key in any of its forms, with its row in words.
fn of_key(key: &Key) -> Value {
    let forms = key.forms.iter().map(|form| of_form(key, form)).collect();
    let mut schema = any_of(forms).unwrap_or_default();
    let mut words = key.what.to_owned();
    for (name, text) in [("absent", key.absent.to_owned()), ("range", key.range_in_words())] {
        if !text.is_empty() {
            words += &format!("\n{name}: {text}");
        }
    }
    schema["description"] = json!(words);
    if !key.example.is_empty() {
        schema["examples"] = json!([example(key)]);
    }
    schema
}

/// One schema, or any of several.
fn any_of(mut forms: Vec<Value>) -> Option<Value> {
    match forms.len() {
        0 | 1 => forms.pop(),
        _ => Some(json!({ "anyOf": forms })),
    }
}

fn example(key: &Key) -> Value {
    match key.forms[0] {
        KeyForm::Number => serde_json::from_str(key.example).unwrap_or(Value::Null),
        KeyForm::Texts => serde_json::from_str(&format!("[{}]", key.example)).unwrap_or(Value::Null),
        _ => json!(key.example),
    }
}

fn of_form(key: &Key, form: &KeyForm<'_>) -> Value {
    match form {
        KeyForm::Quantity(dimension) => json!({ "allOf": [reference(*dimension)] }),
        KeyForm::Number if key.may_have_tolerance() => json!({ "anyOf": [
            { "type": "number" },
            { "type": "string", "pattern": format!(r"{TOLERANCE}\s*%?\s*$") },
        ] }),
        KeyForm::Number => json!({ "type": "number" }),
        KeyForm::Numbers => json!({ "type": "array", "items": { "type": "number" }, "minItems": 1 }),
        KeyForm::Text => json!({ "type": "string", "pattern": r"\S" }),
        KeyForm::Texts => json!({ "type": "array", "items": { "type": "string", "pattern": r"\S" }, "minItems": 1 }),
        KeyForm::Choice(words) => json!({ "enum": words }),
        KeyForm::Switch => json!({ "type": "boolean" }),
        KeyForm::Table => table(key.path),
        KeyForm::Tables => json!({ "type": "array", "items": table(key.path) }),
        KeyForm::Value => json!({ "type": ["number", "string"] }),
        KeyForm::Values => json!({ "type": "array", "items": { "type": ["number", "string"] }, "minItems": 1 }),
    }
}

fn reference(dimension: Dimension) -> Value {
    json!({ "$ref": format!("#/definitions/{}", definition(dimension)) })
}

/// Ratios by name of quantity; TOML reads `feed_flow.GROUP` as a table unless it is quoted.
fn tolerances() -> Value {
    let ratio = reference(Dimension::Ratio);
    let (mut properties, mut patterns) = (Map::new(), Map::new());
    for row in CATALOGUE.iter().filter(|row| row.may_be_tolerance) {
        match row.name.strip_suffix('.') {
            Some(family) => {
                let region = json!({ "anyOf": [ratio, { "type": "object" }] });
                properties.insert(family.to_owned(), json!({ "type": "object", "additionalProperties": region }));
                patterns.insert(format!(r"^{family}\..+$"), ratio.clone());
            }
            None => drop(properties.insert(row.name.to_owned(), ratio.clone())),
        }
    }
    table_of(properties, patterns)
}

/// The keys that a sweep can vary, below their tables. Of lists of tables those of feeds alone have names.
fn swept() -> impl Iterator<Item = &'static Key> {
    let lists: Vec<String> = keys()
        .filter(|key| key.forms.contains(&KeyForm::Tables) && key.path != "feed")
        .map(|key| format!("{}.", key.path))
        .collect();
    keys().filter(move |key| {
        let (table, _) = key.path.split_once('.').unwrap_or_default();
        let is_listed = lists.iter().any(|list| key.path.starts_with(list.as_str()));
        swept_tables().any(|swept| swept == table) && !is_listed
    })
}

/// A table with at least one of these keys, and no other.
fn table_of(properties: Map<String, Value>, patterns: Map<String, Value>) -> Value {
    json!({
        "type": "object",
        "properties": properties,
        "patternProperties": patterns,
        "additionalProperties": false,
        "minProperties": 1,
    })
}

/// The tables of a bearing's scene and of a crankshaft's whose keys can be swept.
fn swept_tables() -> impl Iterator<Item = &'static str> {
    let of_shaft = SWEPT_OF_SHAFT.into_iter().filter(|table| !SWEPT.contains(table));
    SWEPT.iter().copied().chain(of_shaft)
}

/// The axes of a sweep, and the columns of its table.
fn sweep() -> Value {
    let columns = children("sweep").filter(|(key, _)| key.path == "sweep.columns");
    named_axes(columns.map(|(key, name)| (name.to_owned(), of_key(key))).collect())
}

/// Axes by the names of keys: short, in quotes with their tables, or below their tables; and `more`.
fn named_axes(more: Map<String, Value>) -> Value {
    let to = |path: &str| json!({ "$ref": format!("#/definitions/{path}") });
    let mut properties: Map<_, _> = SHORT_NAMES.iter().map(|(name, path)| ((*name).to_owned(), to(path))).collect();
    let mut patterns = Map::new();
    for key in swept().filter(|key| axis(key).is_some()) {
        match key.path.strip_prefix("feed.") {
            Some(rest) => patterns.insert(format!(r"^feed\..+\.{}$", rest.replace('.', r"\.")), to(key.path)),
            None => properties.insert(key.path.to_owned(), to(key.path)),
        };
    }
    for table in swept_tables() {
        properties.insert(table.to_owned(), axes(table));
    }
    properties.extend(more);
    table_of(properties, patterns)
}

/// The axes of the keys of a table; those of a feed stand below the name of its region.
fn axes(path: &str) -> Value {
    let below = children(path).filter_map(|(key, name)| {
        let own = axis(key).map(|_| json!({ "$ref": format!("#/definitions/{}", key.path) }));
        let nested = key.forms.contains(&KeyForm::Table).then(|| axes(key.path));
        let schema = match (own, nested) {
            (Some(own), Some(nested)) => json!({ "anyOf": [own, nested] }),
            (own, nested) => own.or(nested)?,
        };
        Some((name.to_owned(), schema))
    });
    let mut table =
        json!({ "type": "object", "properties": below.collect::<Map<_, _>>(), "additionalProperties": false });
    if path == "mesh.tolerance" {
        table = json!({ "type": "object" });
    }
    match path {
        "feed" => json!({ "type": "object", "additionalProperties": table }),
        _ => table,
    }
}

/// The axis of a key; `None` of one that holds tables alone.
fn axis(key: &Key) -> Option<Value> {
    let is_table = |form: &&KeyForm<'_>| matches!(form, KeyForm::Table | KeyForm::Tables);
    let forms: Vec<_> = key.forms.iter().filter(|form| !is_table(form)).collect();
    let is_number = |form: &&KeyForm<'_>| matches!(form, KeyForm::Quantity(_) | KeyForm::Number);
    let has_ranges = forms.iter().any(is_number);
    let value = any_of(forms.into_iter().map(|form| of_form(key, form)).collect())?;
    let list = json!({ "type": "array", "items": value, "minItems": 1 });
    Some(match has_ranges {
        true => json!({ "anyOf": [list, range(&value)] }),
        false => list,
    })
}

/// A range of an axis: its ends are values of the key.
fn range(value: &Value) -> Value {
    let keys = children("sweep.KEY").map(|(key, name)| {
        let schema = match key.forms {
            [KeyForm::Value] => value.clone(),
            _ => of_key(key),
        };
        (name.to_owned(), schema)
    });
    json!({
        "type": "object",
        "properties": keys.collect::<Map<_, _>>(),
        "required": ["from", "to", "steps"],
        "additionalProperties": false,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_key_has_a_place_in_the_schema() {
        let schema = schema();
        for key in keys().filter(|key| !key.path.contains(|letter: char| letter.is_ascii_uppercase())) {
            let place = key.path.split('.').fold(&schema, |table, name| {
                let forms =
                    table["anyOf"].as_array().and_then(|forms| forms.iter().find(|form| form["type"] == "object"));
                let table = forms.unwrap_or(table);
                let table = if table["type"] == "array" { &table["items"] } else { table };
                assert_eq!(table["additionalProperties"], false, "{}", key.path);
                &table["properties"][name]
            });
            assert!(place["description"].as_str().is_some_and(|words| words.starts_with(key.what)), "{}", key.path);
        }
    }
}
