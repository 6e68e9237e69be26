use std::cell::RefCell;
use std::path::Path;

use toml::de::DeTable;

use super::*;
use crate::keys::KeyForm;
use crate::reader::TableReader;
use crate::{Complaint, Complaints};

/// Names that a user may choose, in place of the words in capitals that stand for them.
const CHOSEN: [(&str, &str); 2] = [("QUANTITY", "load"), ("KEY", "clearance")];

/// Ways to write a value of a form; `example` is one without quotes.
fn values(form: &KeyForm<'_>, example: &str) -> Vec<String> {
    match form {
        KeyForm::Quantity(_) | KeyForm::Text => vec![format!("\"{example}\"")],
        // The example of a key may be a text that is read otherwise.
        KeyForm::Number | KeyForm::Value => {
            vec![example.parse::<f64>().map_or("0.5".to_owned(), |_| example.to_owned())]
        }
        KeyForm::Numbers => vec![format!("[{example}]")],
        KeyForm::Texts => vec![format!("[{example}]")],
        KeyForm::Choice(words) => words.iter().map(|word| format!("\"{word}\"")).collect(),
        KeyForm::Switch => vec!["true".to_owned(), "false".to_owned()],
        KeyForm::Table => vec!["{}".to_owned()],
        KeyForm::Tables => vec!["[{}]".to_owned()],
        KeyForm::Values => vec!["[1, 2]".to_owned()],
    }
}

/// A text with one key alone.
fn text(key: &Key, value: &str) -> String {
    let parts: Vec<&str> = key.path.split('.').collect();
    let whole = (1..parts.len()).rev().fold(value.to_owned(), |inner, depth| {
        let table = format!("{{ {} = {inner} }}", parts[depth]);
        let is_list = keys().any(|row| row.path == parts[..depth].join(".") && row.forms.contains(&KeyForm::Tables));
        if is_list { format!("[{table}]") } else { table }
    });
    CHOSEN.into_iter().fold(format!("{} = {whole}", parts[0]), |text, (word, name)| text.replace(word, name))
}

/// What is said about the key of a text with it alone.
fn complaints(key: &Key, text: &str) -> Vec<Complaint> {
    let document = DeTable::parse(text).unwrap_or_else(|error| panic!("{text}: {error}"));
    let complaints = RefCell::new(Complaints::new(text));
    let root = TableReader::root(&complaints, document.get_ref(), row);
    match key.path.starts_with("crankshaft") {
        true => drop(crate::crankshaft::read_scene(root, text, Path::new("scene.toml"))),
        false => drop(crate::scene::read(root, text, Path::new("scene.toml"))),
    }
    complaints
        .into_inner()
        .into_list()
        .into_iter()
        .filter(|it| row(&it.key).is_none_or(|row| row.path == key.path))
        .collect()
}

/// A reader takes every key in each of its forms: none is unknown, and no other form is wanted.
#[test]
fn each_row_is_read_in_all_its_forms() {
    let is_refused = |it: &&Complaint| it.message.contains("is not known") || it.message.contains("wanted");
    for key in keys() {
        for value in key.forms.iter().flat_map(|form| values(form, key.example)) {
            let text = text(key, &value);
            let complaints = complaints(key, &text);
            let refused: Vec<_> = complaints.iter().filter(is_refused).map(ToString::to_string).collect();
            assert!(refused.is_empty(), "{text}: {refused:?}");
        }
    }
}

#[test]
fn a_key_without_a_row_is_not_read() {
    let path = |path: &str| row(path).map(|row| row.path);
    assert_eq!(path("feed[3].hole.diameter"), Some("feed.hole.diameter"));
    assert_eq!(path("sweep.bearing.clearance"), Some("sweep.KEY"));
    assert_eq!(path("sweep.bearing.clearance.steps"), Some("sweep.KEY.steps"));
    assert!(
        row("feed.hole").is_some() && row("feed.hole.depth").is_none() && row("mesh.tolerance.feed_flow.a").is_some()
    );
}
