//! A row of the catalogue of keys: what is known of one key of a scene.

use crate::unit::Dimension;

/// What a key holds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum KeyForm<'a> {
    /// A number with a unit, in quotes.
    Quantity(Dimension),
    /// A number without a unit.
    Number,
    /// Numbers without a unit in a list.
    Numbers,
    /// A text.
    Text,
    /// Texts in a list.
    Texts,
    /// One of these words.
    Choice(&'a [&'a str]),
    /// True or false.
    Switch,
    /// A table.
    Table,
    /// A list of tables.
    Tables,
    /// A value of the key that an axis of a sweep names.
    Value,
    /// A list of such values.
    Values,
}

/// One key of a scene.
#[derive(Debug)]
pub struct Key {
    /// Tables and name of the key: `bearing.arc.from`. Keys of a list of tables are written once, `feed.group`; a word
    /// in capitals stands for names that a user chooses.
    pub path: &'static str,
    /// What it may hold: one form, or one of several.
    pub forms: &'static [KeyForm<'static>],
    /// An example of its value, without quotes; empty for tables.
    pub example: &'static str,
    /// What counts where it is not written; `required` where it must be.
    pub absent: &'static str,
    /// Values that are accepted, beside their form.
    pub range: &'static str,
    /// What it is, in a sentence.
    pub what: &'static str,
}

/// The rows of a table: path, forms, example; what counts where the key is absent; range; meaning.
macro_rules! keys {
    ($($path:literal = $($form:expr),+; $example:literal, $absent:literal, $range:literal, $what:literal;)+) => {
        /// The keys of this table.
        pub(crate) static KEYS: &[$crate::keys::Key] = {
            #[allow(unused_imports, reason = "a table need not have keys of all forms")]
            use $crate::{keys::KeyForm::*, unit::Dimension::*};
            &[$($crate::keys::Key {
                path: $path,
                forms: &[$($form),+],
                example: $example,
                absent: $absent,
                range: $range,
                what: $what,
            }),+]
        };
    };
}

impl Key {
    /// The kind of quantity that it holds; `None` where it holds none.
    pub fn dimension(&self) -> Option<Dimension> {
        self.forms.iter().find_map(|form| match form {
            KeyForm::Quantity(dimension) => Some(*dimension),
            _ => None,
        })
    }

    /// Whether it may hold a number without a unit.
    pub(crate) fn is_plain(&self) -> bool {
        self.forms.contains(&KeyForm::Number)
    }

    /// An example of its value as one would write it.
    pub(crate) fn written_example(&self) -> String {
        let is_text = |form: &KeyForm<'_>| matches!(form, KeyForm::Quantity(_) | KeyForm::Text | KeyForm::Choice(_));
        match self.forms.iter().any(is_text) {
            true => format!("\"{}\"", self.example),
            false => self.example.to_owned(),
        }
    }

    /// The table whose key it is, and its name there.
    pub fn table_and_name(&self) -> (&'static str, &'static str) {
        self.path.rsplit_once('.').unwrap_or(("", self.path))
    }

    /// Whether its table is no table without it.
    pub fn is_required(&self) -> bool {
        self.absent == "required"
    }

    /// What it holds in words: `length`, `plain number`, `ratio, or a table`.
    pub fn forms_in_words(&self) -> String {
        let words: Vec<&str> = self.forms.iter().map(|form| form.in_words()).collect();
        words.join(", or a ")
    }

    /// Which values are accepted, in words; those of a choice in quotes.
    pub fn range_in_words(&self) -> String {
        let quoted = |form: &KeyForm<'_>| match form {
            KeyForm::Choice(words) => {
                Some(words.iter().map(|word| format!("`\"{word}\"`")).collect::<Vec<_>>().join(", "))
            }
            _ => None,
        };
        let parts = self.forms.iter().filter_map(quoted).chain(Some(self.range.to_owned()));
        parts.filter(|part| !part.is_empty()).collect::<Vec<_>>().join("; ")
    }
}

impl KeyForm<'_> {
    fn in_words(&self) -> &'static str {
        match self {
            Self::Quantity(dimension) => dimension.name().trim_start_matches("an ").trim_start_matches("a "),
            Self::Number => "plain number",
            Self::Numbers => "list of plain numbers",
            Self::Text => "text",
            Self::Texts => "list of texts",
            Self::Choice(_) => "word",
            Self::Switch => "switch",
            Self::Table => "table",
            Self::Tables => "list of tables",
            Self::Value => "value of the key",
            Self::Values => "list of values of the key",
        }
    }
}
