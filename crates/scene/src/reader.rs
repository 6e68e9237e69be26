//! Reads TOML tables and collects complaints instead of stopping at the first.
//!
//! Where a value is wrong, the complaint is kept and a neutral value is returned: NaN for a number, nothing for a
//! text. No number of a scene is NaN, so later checks pass over what was refused already. Keys that were not read
//! when the reader of their table goes out of scope are unknown.

mod number;

pub(crate) use number::{Number, plain_number, written_tolerance};

use std::cell::RefCell;
use std::ops::Range;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::Complaints;
use crate::keys::Key;
use crate::spelling::nearest;

/// Most tables of one list.
const MOST_TABLES: usize = 1000;

/// The row of the key at a path.
pub(crate) type KeyRows = fn(&str) -> Option<&'static Key>;

/// Reads one table.
#[derive(Debug)]
pub(crate) struct TableReader<'a> {
    complaints: &'a RefCell<Complaints>,
    /// `None`: the table is not there or not a table, which is a complaint already.
    table: Option<&'a DeTable<'a>>,
    path: String,
    rows: KeyRows,
    known: Vec<&'a str>,
    /// Keys that must be there and are not, with an example.
    missing: Vec<(&'a str, String)>,
}

impl<'a> TableReader<'a> {
    /// Reads the table of the whole text, whose keys have these rows.
    pub(crate) fn root(complaints: &'a RefCell<Complaints>, table: &'a DeTable<'a>, rows: KeyRows) -> Self {
        Self { complaints, table: Some(table), path: String::new(), rows, known: Vec::new(), missing: Vec::new() }
    }

    /// Reads a table at a path below that of this one; `None`: it is none.
    fn inner(&self, table: Option<&'a DeTable<'a>>, path: String) -> Self {
        let Self { complaints, rows, .. } = *self;
        Self { complaints, table, path, rows, known: Vec::new(), missing: Vec::new() }
    }

    /// Path of a key of this table.
    fn key(&self, key: &str) -> String {
        match self.path.is_empty() {
            true => key.to_owned(),
            false => format!("{}.{key}", self.path),
        }
    }

    fn peek(&self, key: &str) -> Option<&'a Spanned<DeValue<'a>>> {
        self.table?.get(key)
    }

    /// Whether the key is written.
    pub(crate) fn has(&self, key: &str) -> bool {
        self.peek(key).is_some()
    }

    /// Whether there is a table at all; if not, there is a complaint about that.
    pub(crate) fn is_readable(&self) -> bool {
        self.table.is_some()
    }

    /// Whether the value of the key is a table.
    pub(crate) fn holds_table(&self, key: &str) -> bool {
        self.peek(key).is_some_and(|value| value.get_ref().is_table())
    }

    /// True if a text is given for the key.
    pub(crate) fn holds_text(&self, key: &str) -> bool {
        self.peek(key).is_some_and(|value| value.get_ref().is_str())
    }

    /// The keys in the order of the text.
    pub(crate) fn keys(&self) -> Vec<&'a str> {
        let keys = self.table.into_iter().flat_map(|table| table.iter());
        let mut keys: Vec<_> = keys.map(|(key, _)| (key.span().start, key.get_ref().as_ref())).collect();
        keys.sort_unstable();
        keys.into_iter().map(|(_, key)| key).collect()
    }

    /// The value of the key as it is written. A key without a row is not known.
    pub(crate) fn written(&mut self, key: &'a str) -> Option<&'a Spanned<DeValue<'a>>> {
        self.row(key)?;
        self.known.push(key);
        let value = self.peek(key)?;
        self.complaints.borrow_mut().mark(&self.key(key), value.span());
        Some(value)
    }

    /// The row of a key of this table.
    fn row(&self, key: &str) -> Option<&'static Key> {
        (self.rows)(&self.key(key))
    }

    /// An example of the value of a key.
    fn example(&self, key: &str) -> &'static str {
        self.row(key).map_or("", |row| row.example)
    }

    fn take(&mut self, key: &'a str) -> Option<&'a DeValue<'a>> {
        Some(self.written(key)?.get_ref())
    }

    /// Complains about a key of this table.
    pub(crate) fn complain(&self, key: &str, message: impl Into<String>, help: impl Into<String>) {
        self.complaints.borrow_mut().add(&self.key(key), message, help);
    }

    /// Complains about this table itself.
    pub(crate) fn complain_here(&self, message: impl Into<String>, help: impl Into<String>) {
        self.complaints.borrow_mut().add(&self.path, message, help);
    }

    /// Complains about a key of this table if something is wrong.
    pub(crate) fn refuse_if(&self, wrong: bool, key: &str, message: impl Into<String>, help: impl Into<String>) {
        if wrong {
            self.complain(key, message, help);
        }
    }

    /// A text that must be there and not be empty; empty where it was refused.
    pub(crate) fn text(&mut self, key: &'static str) -> String {
        self.require(key);
        self.text_if_given(key).unwrap_or_default()
    }

    /// A text, if it is written.
    pub(crate) fn text_if_given(&mut self, key: &'static str) -> Option<String> {
        let write = format!("write for example {key} = \"{}\"", self.example(key));
        match self.take(key)? {
            DeValue::String(text) if !text.trim().is_empty() => return Some(text.to_string()),
            DeValue::String(_) => self.complain(key, "is empty", write),
            other => self.complain(key, format!("a text in quotes is wanted, not {}", kind(other)), write),
        }
        None
    }

    /// A list of texts with their places, if it is written.
    pub(crate) fn texts_if_given(&mut self, key: &'a str) -> Option<Vec<(&'a str, Range<usize>)>> {
        let path = self.key(key);
        let items = self.take(key)?.as_array();
        let text = |(index, item): (usize, &'a Spanned<DeValue<'a>>)| {
            self.complaints.borrow_mut().mark(&format!("{path}[{index}]"), item.span());
            Some((item.get_ref().as_str().filter(|text| !text.trim().is_empty())?, item.span()))
        };
        let texts = items.and_then(|items| items.iter().enumerate().map(text).collect::<Option<Vec<_>>>());
        let texts = texts.filter(|texts| !texts.is_empty());
        if texts.is_none() {
            let help = format!("write for example {key} = [{}]", self.example(key));
            self.complain(key, "a list of texts in quotes is wanted", help);
        }
        texts
    }

    /// One of a few words, if it is written.
    pub(crate) fn word<T: Copy>(&mut self, key: &'static str, words: &[(&str, T)]) -> Option<T> {
        let text = self.text_if_given(key)?;
        let found = words.iter().find(|(word, _)| *word == text);
        if found.is_none() {
            let served: Vec<_> = words.iter().map(|(word, _)| format!("\"{word}\"")).collect();
            let near = nearest(&text, words.iter().map(|(word, _)| *word));
            let hint = near.map_or(String::new(), |word| format!("; did you mean \"{word}\"?"));
            let help = format!("write {key} = {}{hint}", served.join(" or "));
            self.complain(key, format!("\"{text}\" is not known"), help);
        }
        found.map(|(_, value)| *value)
    }

    /// True or false, if it is written.
    pub(crate) fn switch(&mut self, key: &'static str) -> Option<bool> {
        match self.take(key)? {
            DeValue::Boolean(value) => Some(*value),
            other => {
                let message = format!("true or false is wanted, not {}", kind(other));
                self.complain(key, message, format!("write {key} = true or {key} = false, without quotes"));
                None
            }
        }
    }

    /// A table that must be there; `example` is how one writes it.
    pub(crate) fn table(&mut self, key: &'static str, example: &str) -> TableReader<'a> {
        if !self.has(key) && self.is_readable() {
            self.complain(key, "this table is missing", format!("write {example}"));
        }
        self.table_if_given(key).unwrap_or_else(|| self.inner(None, self.key(key)))
    }

    /// A table, if it is written.
    pub(crate) fn table_if_given(&mut self, key: &'a str) -> Option<TableReader<'a>> {
        let value = self.take(key)?;
        if !value.is_table() {
            let help = match self.path.is_empty() {
                true => format!("write a line [{key}] and its keys below"),
                false => format!("write {key} = {{ ... }}"),
            };
            self.complain(key, format!("a table is wanted, not {}", kind(value)), help);
        }
        Some(self.inner(value.as_table(), self.key(key)))
    }

    /// A list of tables; none where the key is not written.
    pub(crate) fn tables(&mut self, key: &'static str) -> Vec<TableReader<'a>> {
        let Some(value) = self.take(key) else { return Vec::new() };
        let path = self.key(key);
        let Some(items) = value.as_array() else {
            let help = format!("begin each one with a line [[{path}]] (two brackets)");
            self.complain(key, format!("a list of tables is wanted, not {}", kind(value)), help);
            return Vec::new();
        };
        if items.len() > MOST_TABLES {
            let message = format!("are {} tables, more than {MOST_TABLES}", items.len());
            self.complain(key, message, "split the scene into several ones");
            return Vec::new();
        }
        let reader = |(index, item): (usize, &'a Spanned<DeValue<'a>>)| {
            let own = format!("{path}[{index}]");
            self.complaints.borrow_mut().mark(&own, item.span());
            let reader = self.inner(item.get_ref().as_table(), own);
            if !reader.is_readable() {
                let message = format!("a table is wanted, not {}", kind(item.get_ref()));
                reader.complain_here(message, format!("begin it with a line [[{path}]]"));
            }
            reader
        };
        items.iter().enumerate().map(reader).collect()
    }

    /// Asks for a key that must be there.
    pub(crate) fn require(&mut self, key: &'a str) {
        let example = self.row(key).map(Key::written_example).unwrap_or_default();
        self.require_as(key, &example);
    }

    /// Asks for a key that must be there; `example` is its value as one would write it, or what may stand for it.
    pub(crate) fn require_as(&mut self, key: &'a str, example: &str) {
        if !self.has(key) {
            self.missing.push((key, example.to_owned()));
        }
    }
}

/// Complains about every key that was not read, and about keys that are missing. A key that is misspelt is not missing
/// too.
impl Drop for TableReader<'_> {
    fn drop(&mut self) {
        let Some(table) = self.table else { return };
        self.known.sort_unstable();
        let mut meant = Vec::new();
        let is_unknown = |key: &&str| !self.known.contains(key);
        for key in self.keys().into_iter().filter(is_unknown) {
            if self.complaints.borrow().are_full() {
                break;
            }
            let Some((name, value)) = table.get_key_value(key) else {
                continue;
            };
            let span = name.span().start..value.span().end.max(name.span().end);
            self.complaints.borrow_mut().mark(&self.key(key), span);
            let near = nearest(key, self.known.iter().copied());
            meant.extend(near);
            let help = match near {
                Some(near) => format!("did you mean \"{near}\"?"),
                None => format!("known here: {}", self.known.join(", ")),
            };
            let what = if value.get_ref().is_table() { "table" } else { "key" };
            self.complain(key, format!("this {what} is not known"), help);
        }
        for (key, example) in self.missing.iter().filter(|(key, _)| !meant.contains(key)) {
            self.complain(key, "is missing", format!("write for example {key} = {example}"));
        }
    }
}

/// The kind of a value in words, with its article.
pub(crate) fn kind(value: &DeValue<'_>) -> &'static str {
    match value {
        DeValue::String(_) => "a text in quotes",
        DeValue::Integer(_) | DeValue::Float(_) => "a bare number",
        DeValue::Boolean(_) => "true or false",
        DeValue::Datetime(_) => "a date",
        DeValue::Array(_) => "a list",
        DeValue::Table(_) => "a table",
    }
}
