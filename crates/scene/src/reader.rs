//! A small reader of TOML tables that collects complaints instead of stopping at the first.
//!
//! Where a value is wrong, the complaint is kept and a neutral value is handed on: NaN for a number, nothing for a
//! text. Texts and numbers of a scene are never NaN, so the checks of ranges pass over what was complained about
//! already. Keys that were not asked for when a table is finished are unknown.

use crate::complaint::Complaint;
use crate::spelling::nearest;
use crate::unit::{self, Dimension};
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// No more complaints are collected than this: who wrote them has no use for more, and a hostile text makes a million.
const MOST_COLLECTED: usize = 1000;
/// Most tables of one list.
const MOST_TABLES: usize = 1000;
/// Angles beyond so many turns have lost their digits.
const MOST_TURNS: f64 = 1e6;
/// Longer keys, values and messages are cut [letters].
const LONGEST_TOLD: usize = 600;

/// Where the values of a scene stand in its text.
#[derive(Debug, Default)]
pub struct Marks {
    text: String,
    spans: BTreeMap<String, Range<usize>>,
}

impl Marks {
    /// Whether the key is written.
    pub fn has(&self, key: &str) -> bool {
        self.spans.contains_key(key)
    }

    /// A complaint about the value of `key`; about the table above it where the key is not written.
    pub fn complaint(&self, key: &str, message: impl Into<String>, help: impl Into<String>) -> Complaint {
        let written = self.spans.get(key).cloned();
        let value = written.clone().and_then(|span| self.text.get(span)).unwrap_or_default();
        let above = || {
            key.rsplit_once('.')
                .and_then(|(table, _)| self.spans.get(table).cloned())
        };
        Complaint {
            key: cut(key),
            value: cut(value),
            message: cut(&message.into()),
            help: cut(&help.into()),
            span: written.or_else(above),
        }
    }
}

/// The beginning and the end of a long text: a message begins with the value and ends with the reason.
fn cut(text: &str) -> String {
    let letter = |at| text.char_indices().nth(at).map(|(start, _)| start);
    let tail = text.char_indices().rev().nth(LONGEST_TOLD / 2 - 1);
    match (letter(LONGEST_TOLD), letter(LONGEST_TOLD / 2), tail) {
        (Some(_), Some(head), Some((tail, _))) => format!("{} ... {}", &text[..head], &text[tail..]),
        _ => text.to_owned(),
    }
}

/// What the readers of all tables of one text collect.
#[derive(Debug)]
pub struct Collector {
    marks: RefCell<Marks>,
    complaints: RefCell<Vec<Complaint>>,
}

impl Collector {
    /// Nothing yet, for a scene of this text.
    pub fn new(text: &str) -> Self {
        let marks = Marks {
            text: text.to_string(),
            spans: BTreeMap::new(),
        };
        Self {
            marks: RefCell::new(marks),
            complaints: RefCell::default(),
        }
    }

    /// The places of all values, and what was wrong.
    pub fn finish(self) -> (Marks, Vec<Complaint>) {
        (self.marks.into_inner(), self.complaints.into_inner())
    }

    fn complain(&self, key: &str, message: impl Into<String>, help: impl Into<String>) {
        if !self.is_full() {
            let complaint = self.marks.borrow().complaint(key, message, help);
            self.complaints.borrow_mut().push(complaint);
        }
    }

    fn is_full(&self) -> bool {
        self.complaints.borrow().len() >= MOST_COLLECTED
    }

    fn mark(&self, key: &str, span: Range<usize>) {
        self.marks.borrow_mut().spans.insert(key.to_string(), span);
    }
}

/// Reads one table.
#[derive(Debug)]
pub struct TableReader<'a> {
    collector: &'a Collector,
    /// `None`: the table is not there or not a table, and was complained about.
    table: Option<&'a DeTable<'a>>,
    path: String,
    known: Vec<&'a str>,
    /// Keys that must be there and are not, with an example.
    missing: Vec<(&'static str, String)>,
}

impl<'a> TableReader<'a> {
    /// Reads the table of the whole text.
    pub fn root(collector: &'a Collector, table: &'a DeTable<'a>) -> Self {
        Self::at(collector, Some(table), String::new())
    }

    fn at(collector: &'a Collector, table: Option<&'a DeTable<'a>>, path: String) -> Self {
        Self {
            collector,
            table,
            path,
            known: Vec::new(),
            missing: Vec::new(),
        }
    }

    /// Path of a key of this table.
    pub fn key(&self, key: &str) -> String {
        if self.path.is_empty() {
            key.to_string()
        } else {
            format!("{}.{key}", self.path)
        }
    }

    /// Whether the key is written.
    pub fn has(&self, key: &str) -> bool {
        self.table.is_some_and(|table| table.contains_key(key))
    }

    /// Whether the value of `key` is a list.
    pub fn is_list(&self, key: &str) -> bool {
        let value = self.table.and_then(|table| table.get(key));
        value.is_some_and(|value| value.get_ref().is_array())
    }

    /// Whether there is a table at all; if not, that was complained about.
    pub fn is_readable(&self) -> bool {
        self.table.is_some()
    }

    /// Whether the value of the key is a table.
    pub fn holds_table(&self, key: &str) -> bool {
        self.table
            .and_then(|table| table.get(key))
            .is_some_and(|value| value.get_ref().is_table())
    }

    /// The keys as they are written, where they are names that the scene gives.
    pub fn keys(&self) -> Vec<&'a str> {
        let table = self.table.into_iter();
        table
            .flat_map(|table| table.iter().map(|(key, _)| key.get_ref().as_ref()))
            .collect()
    }

    /// The keys in the order of the text.
    pub fn keys_in_order(&self) -> Vec<&'a str> {
        let table = self.table.into_iter();
        let mut keys: Vec<_> = table
            .flat_map(|table| table.iter().map(|(key, _)| (key.span().start, key.get_ref().as_ref())))
            .collect();
        keys.sort_unstable();
        keys.into_iter().map(|(_, key)| key).collect()
    }

    /// The value of the key as it is written.
    pub fn written(&mut self, key: &'a str) -> Option<&'a Spanned<DeValue<'a>>> {
        self.take(key)?;
        self.table?.get(key)
    }

    /// Complains about a key of this table.
    pub fn complain(&self, key: &str, message: impl Into<String>, help: impl Into<String>) {
        self.collector.complain(&self.key(key), message, help);
    }

    /// Complains about this table itself.
    pub fn complain_here(&self, message: impl Into<String>, help: impl Into<String>) {
        self.collector.complain(&self.path, message, help);
    }

    /// A physical quantity in SI that must be there.
    pub fn quantity(&mut self, key: &'static str, dimension: Dimension, example: &str) -> f64 {
        self.require(key, &format!("\"{example}\""));
        self.quantity_if_given(key, dimension, example).unwrap_or(f64::NAN)
    }

    /// A physical quantity in SI, if it is written.
    pub fn quantity_if_given(&mut self, key: &'a str, dimension: Dimension, example: &str) -> Option<f64> {
        let write = format!("write {key} = \"{example}\"");
        match self.take(key)? {
            DeValue::String(text) => match unit::parse(text, dimension) {
                Ok(value) if dimension == Dimension::Angle && value.abs() > MOST_TURNS * TAU => self.complain(
                    key,
                    format!("is more than {MOST_TURNS} turns, whose digits hide where it points"),
                    "give an angle from 0 to 360 deg",
                ),
                Ok(value) => return Some(value),
                Err(error) => self.complain(key, error.to_string(), error.help(example)),
            },
            DeValue::Integer(_) | DeValue::Float(_) => {
                let message = format!("a bare number has no unit; {} is wanted", dimension.name());
                self.complain(
                    key,
                    message,
                    format!("{write} (a text with a unit: {})", dimension.unit_names()),
                );
            }
            other => self.complain(
                key,
                format!("{} is wanted, not {}", dimension.name(), kind(other)),
                write,
            ),
        }
        Some(f64::NAN)
    }

    /// A plain number, if it is written.
    pub fn number_if_given(&mut self, key: &'static str, example: &str) -> Option<f64> {
        let value = self.take(key)?;
        if !matches!(value, DeValue::Integer(_) | DeValue::Float(_)) {
            let message = format!("a plain number is wanted, not {}", kind(value));
            self.complain(
                key,
                message,
                format!("write {key} = {example}, without quotes and unit"),
            );
            return Some(f64::NAN);
        }
        match plain_number(value) {
            Some(value) => Some(value),
            None => {
                self.complain(
                    key,
                    "is not a finite number",
                    format!("write for example {key} = {example}"),
                );
                Some(f64::NAN)
            }
        }
    }

    /// A text that must be there and not be empty; empty where it was complained about.
    pub fn text(&mut self, key: &'static str, example: &str) -> String {
        self.require(key, &format!("\"{example}\""));
        self.text_if_given(key, example).unwrap_or_default()
    }

    /// A text, if it is written.
    pub fn text_if_given(&mut self, key: &'static str, example: &str) -> Option<String> {
        let write = format!("write for example {key} = \"{example}\"");
        match self.take(key)? {
            DeValue::String(text) if !text.trim().is_empty() => return Some(text.to_string()),
            DeValue::String(_) => self.complain(key, "is empty", write),
            other => self.complain(key, format!("a text in quotes is wanted, not {}", kind(other)), write),
        }
        None
    }

    /// One of a few words, if it is written.
    pub fn word_if_given<T: Copy>(&mut self, key: &'static str, words: &[(&str, T)]) -> Option<T> {
        let served = words
            .iter()
            .map(|(word, _)| format!("\"{word}\""))
            .collect::<Vec<_>>()
            .join(" or ");
        let text = self.text_if_given(key, words.first().map_or("", |(word, _)| word))?;
        if let Some((_, value)) = words.iter().find(|(word, _)| *word == text) {
            return Some(*value);
        }
        let near = nearest(&text, words.iter().map(|(word, _)| *word));
        let hint = near.map_or(String::new(), |word| format!("; did you mean \"{word}\"?"));
        self.complain(
            key,
            format!("\"{text}\" is not known"),
            format!("write {key} = {served}{hint}"),
        );
        None
    }

    /// A table that must be there; `example` is how one writes it.
    pub fn table(&mut self, key: &'static str, example: &str) -> TableReader<'a> {
        if !self.has(key) && self.is_readable() {
            self.complain(key, "this table is missing", format!("write {example}"));
        }
        let path = self.key(key);
        self.table_if_given(key)
            .unwrap_or_else(|| Self::at(self.collector, None, path))
    }

    /// A table, if it is written.
    pub fn table_if_given(&mut self, key: &'a str) -> Option<TableReader<'a>> {
        let value = self.take(key)?;
        if !value.is_table() {
            let message = format!("a table is wanted, not {}", kind(value));
            let help = match self.path.is_empty() {
                true => format!("write a line [{key}] and its keys below"),
                false => format!("write {key} = {{ ... }}"),
            };
            self.complain(key, message, help);
        }
        Some(Self::at(self.collector, value.as_table(), self.key(key)))
    }

    /// A list of tables; none where the key is not written.
    pub fn tables(&mut self, key: &'static str) -> Vec<TableReader<'a>> {
        let Some(value) = self.take(key) else { return Vec::new() };
        let Some(items) = value.as_array() else {
            let message = format!("a list of tables is wanted, not {}", kind(value));
            self.complain(
                key,
                message,
                format!("begin each one with a line [[{}]] (two brackets)", self.key(key)),
            );
            return Vec::new();
        };
        if items.len() > MOST_TABLES {
            let message = format!("are {} tables, more than {MOST_TABLES}", items.len());
            self.complain(key, message, "split the scene into several ones");
            return Vec::new();
        }
        let reader = |(index, item): (usize, &'a Spanned<DeValue<'a>>)| {
            let path = format!("{}[{index}]", self.key(key));
            self.collector.mark(&path, item.span());
            if !item.get_ref().is_table() {
                let message = format!("a table is wanted, not {}", kind(item.get_ref()));
                self.collector
                    .complain(&path, message, format!("begin it with a line [[{}]]", self.key(key)));
            }
            Self::at(self.collector, item.get_ref().as_table(), path)
        };
        items.iter().enumerate().map(reader).collect()
    }

    /// Complains about every key that nobody asked for, and about keys that are missing. A key that is misspelt is
    /// not missing too.
    pub fn finish(mut self) {
        let Some(table) = self.table else { return };
        self.known.sort_unstable();
        let mut meant = Vec::new();
        for (key, value) in table {
            let name = key.get_ref().as_ref();
            if self.known.contains(&name) {
                continue;
            }
            if self.collector.is_full() {
                break;
            }
            self.collector
                .mark(&self.key(name), key.span().start..value.span().end.max(key.span().end));
            let near = nearest(name, self.known.iter().copied());
            meant.extend(near);
            let help = match near {
                Some(near) => format!("did you mean \"{near}\"?"),
                None => format!("known here: {}", self.known.join(", ")),
            };
            let message = if value.get_ref().is_table() {
                "this table is not known"
            } else {
                "this key is not known"
            };
            self.complain(name, message, help);
        }
        for (key, example) in self.missing.iter().filter(|(key, _)| !meant.contains(key)) {
            self.complain(key, "is missing", format!("write for example {key} = {example}"));
        }
    }

    /// Asks for a key that must be there; `example` is its value as one would write it.
    pub fn require(&mut self, key: &'static str, example: &str) {
        if !self.has(key) {
            self.missing.push((key, example.to_owned()));
        }
    }

    fn take(&mut self, key: &'a str) -> Option<&'a DeValue<'a>> {
        self.known.push(key);
        self.value(key)
    }

    fn value(&self, key: &str) -> Option<&'a DeValue<'a>> {
        let value = self.table?.get(key)?;
        self.collector.mark(&self.key(key), value.span());
        Some(value.get_ref())
    }
}

/// The finite number that a value without quotes is.
pub fn plain_number(value: &DeValue<'_>) -> Option<f64> {
    let number: Option<f64> = match value {
        DeValue::Integer(digits) if digits.radix() == 10 => digits.as_str().parse().ok(),
        DeValue::Integer(digits) => i64::from_str_radix(digits.as_str(), digits.radix())
            .ok()
            .map(|value| value as f64),
        DeValue::Float(digits) => digits.as_str().parse().ok(),
        _ => None,
    };
    number.filter(|number| number.is_finite())
}

/// The kind of a value in words, with its article.
pub fn kind(value: &DeValue<'_>) -> &'static str {
    match value {
        DeValue::String(_) => "a text in quotes",
        DeValue::Integer(_) | DeValue::Float(_) => "a bare number",
        DeValue::Boolean(_) => "true or false",
        DeValue::Datetime(_) => "a date",
        DeValue::Array(_) => "a list",
        DeValue::Table(_) => "a table",
    }
}
