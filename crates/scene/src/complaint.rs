//! What is wrong with a scene, in words that name the key, the value and the way out. All complaints come at once.

use std::collections::BTreeMap;
use std::ops::Range;

use crate::{KeyTolerance, Scene};

/// No more complaints are collected than this: a hostile text causes a million.
const MOST_COLLECTED: usize = 1000;
/// How many complaints about a scene are reported.
const MOST_REPORTED: usize = 100;
/// Longer keys, values and messages are cut [letters].
const LONGEST_TEXT: usize = 600;

/// One thing that is wrong with a scene.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Complaint {
    /// The key with its tables, `feed "groove".hole.diameter`; feeds without a name of their own are counted from 0,
    /// `feed[0]`. Empty for a fault of the TOML itself.
    pub key: String,
    /// The value as it is written; empty where there is none.
    pub value: String,
    /// What is wrong, as the end of a sentence that begins with the key.
    pub message: String,
    /// The way out.
    pub help: String,
    /// Bytes of the scene's text that are meant.
    pub span: Option<Range<usize>>,
}

impl std::fmt::Display for Complaint {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.key.is_empty() {
            true => write!(formatter, "{}", self.message),
            false => write!(formatter, "{}: {}", self.key, self.message),
        }
    }
}

/// A check of a whole scene. A number that was refused already is NaN, so that no comparison is true of it.
pub type Check = fn(&Scene, &mut Complaints);

/// The complaints about one scene, and where its values stand in its text.
#[derive(Debug, Default)]
pub struct Complaints {
    text: String,
    spans: BTreeMap<String, Range<usize>>,
    names: Vec<(String, String)>,
    /// The numbers that were read and may have tolerances, by their keys as they stand in the text.
    pub(crate) inputs: Vec<KeyTolerance>,
    list: Vec<Complaint>,
}

impl Complaints {
    /// None yet, about a scene with this text.
    pub(crate) fn new(text: &str) -> Self {
        Self { text: text.to_owned(), ..Self::default() }
    }

    /// Whether the key is written in the text.
    pub fn has(&self, key: &str) -> bool {
        self.spans.contains_key(key)
    }

    /// Whether there is a complaint about `key` or, where that is a table, about a key of it.
    pub fn concern(&self, key: &str) -> bool {
        let is_below = |rest: &str| rest.is_empty() || rest.starts_with(['.', '[']);
        self.list.iter().any(|it| it.key.strip_prefix(key).is_some_and(is_below))
    }

    /// Whether there are so many complaints that no more are collected.
    pub(crate) fn are_full(&self) -> bool {
        self.list.len() >= MOST_COLLECTED
    }

    /// Records where the value of `key` stands.
    pub(crate) fn mark(&mut self, key: &str, span: Range<usize>) {
        self.spans.insert(key.to_owned(), span);
    }

    /// Names the tables of a list, each by its key (`feed[0]`): complaints call them `list "name"` where no other has
    /// that name.
    pub(crate) fn name(&mut self, names: impl IntoIterator<Item = (String, String)>) {
        self.names.extend(names);
    }

    /// The key with the name of its table.
    fn named(&self, key: &str) -> String {
        let is_only =
            |name: &str| !name.is_empty() && self.names.iter().filter(|(_, other)| other == name).count() == 1;
        let renamed = self.names.iter().find_map(|(table, name)| {
            let rest = key.strip_prefix(table.as_str())?;
            let list = table.split('[').next().unwrap_or_default();
            is_only(name).then(|| format!("{list} \"{name}\"{rest}"))
        });
        renamed.unwrap_or_else(|| key.to_owned())
    }

    /// A complaint about the value of `key`; about the table above it where the key is not written.
    pub fn add(&mut self, key: &str, message: impl Into<String>, help: impl Into<String>) {
        if self.are_full() {
            return;
        }
        let written = self.spans.get(key).cloned();
        let value = written.clone().and_then(|span| self.text.get(span)).unwrap_or_default();
        let above = || (key.rsplit_once('.')).and_then(|(table, _)| self.spans.get(table).cloned());
        self.list.push(Complaint {
            key: cut(key),
            value: cut(value),
            message: cut(&message.into()),
            help: cut(&help.into()),
            span: written.or_else(above),
        });
    }

    /// [`Complaints::add`] if something is wrong.
    pub fn refuse_if(&mut self, wrong: bool, key: &str, message: impl Into<String>, help: impl Into<String>) {
        if wrong {
            self.add(key, message, help);
        }
    }

    /// The first complaints in the order of the text; the last one of many says that there are more.
    pub fn into_list(mut self) -> Vec<Complaint> {
        let mut list = in_order(std::mem::take(&mut self.list));
        for complaint in &mut list {
            complaint.key = self.named(&complaint.key);
        }
        if list.len() > MOST_REPORTED {
            list.truncate(MOST_REPORTED);
            list.push(Complaint {
                key: String::new(),
                value: String::new(),
                message: format!("there are more complaints; these are the first {MOST_REPORTED}"),
                help: "correct these first".to_owned(),
                span: None,
            });
        }
        list
    }
}

/// The complaints in the order of the text; those without a place come last.
pub(crate) fn in_order(mut complaints: Vec<Complaint>) -> Vec<Complaint> {
    complaints.sort_by_key(|complaint| complaint.span.as_ref().map_or(usize::MAX, |span| span.start));
    complaints
}

/// The beginning and the end of a long text: a message begins with the value and ends with the reason.
fn cut(text: &str) -> String {
    let letter = |at| text.char_indices().nth(at).map(|(start, _)| start);
    let tail = text.char_indices().rev().nth(LONGEST_TEXT / 2 - 1);
    match (letter(LONGEST_TEXT), letter(LONGEST_TEXT / 2), tail) {
        (Some(_), Some(head), Some((tail, _))) => format!("{} ... {}", &text[..head], &text[tail..]),
        _ => text.to_owned(),
    }
}
