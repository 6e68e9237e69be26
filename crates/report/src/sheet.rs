//! Tables for people. A [`Sheet`] says once what a table holds, in which units and with which digits; the terminal, the
//! page and files show it, each with its own letters.

use comfy_table::{CellAlignment, ContentArrangement, Table, presets};
use oilwedge_scene::sweep::AxisValue;
use oilwedge_scene::wording::printable;
use serde::{Serialize, Serializer};

use crate::digits::{bar, quantity_value, significant, unresolved};
use crate::readable::{printed_unit, with_minus};

/// Digits of numbers in tables.
pub(crate) const DIGITS: usize = 4;
/// Digits of the value of a quantity without a bar, where all of them are wanted.
const ALL_DIGITS: usize = 6;
/// Whole numbers below this are counts, and are written out.
const WHOLE: f64 = 1e9;
/// Style of a cell whose words, numbers and units among them, stay in one line.
pub(crate) const WHOLE_LINE: &str = "whole";
/// Stands where there is no number.
const NONE: &str = "-";

/// A cell of plain letters: what it shows, and the number in SI behind it.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Cell {
    /// What the cell shows, in plain letters.
    pub text: String,
    /// The number in SI.
    pub value: Option<f64>,
    /// Whether the cell is one of a column of numbers.
    pub is_number: bool,
    /// Class of its style on the page: `good`, `bad`, `open`, or `whole` where its words stay in one line; empty as the
    /// text around it.
    pub kind: &'static str,
}

/// A table with a title and notes below it.
#[derive(Debug, Clone, Default, Serialize)]
pub struct Sheet {
    /// What the table shows; empty where none is needed.
    #[serde(serialize_with = "sentence")]
    pub title: String,
    /// Headings of the columns.
    #[serde(serialize_with = "true_letters")]
    pub header: Vec<String>,
    /// Rows of cells.
    pub rows: Vec<Vec<Cell>>,
    /// Sentences below the table.
    pub notes: Vec<String>,
    /// Columns that the terminal does not show.
    #[serde(skip)]
    pub page_only: Vec<usize>,
}

impl Sheet {
    /// A sheet without notes.
    pub fn new<const N: usize>(title: &str, header: [&str; N], rows: Vec<Vec<Cell>>) -> Self {
        Self { title: title.to_owned(), header: header.map(str::to_owned).to_vec(), rows, ..Self::default() }
    }

    /// The sheet, if there is anything in it.
    pub fn if_any(self) -> Option<Self> {
        (!self.rows.is_empty() || !self.notes.is_empty()).then_some(self)
    }

    /// The sheet as the terminal shows it, as wide as the terminal at most: title, table, notes. Columns with numbers
    /// are aligned to the right.
    pub fn terminal(&self) -> String {
        let mut parts: Vec<String> = (!self.title.is_empty()).then(|| printable(&self.title)).into_iter().collect();
        if !self.rows.is_empty() {
            let columns: Vec<_> = (0..self.header.len()).filter(|column| !self.page_only.contains(column)).collect();
            let mut table = Table::new();
            table.load_style(presets::UTF8_FULL_CONDENSED).set_content_arrangement(ContentArrangement::Dynamic);
            if let Some((_, width)) = console::Term::stdout().size_checked() {
                table.set_width(width);
            }
            table.set_header(columns.iter().map(|&column| printable(&self.header[column])));
            table.add_rows(self.rows.iter().map(|row| columns.iter().map(|&column| printable(&row[column].text))));
            for (place, &column) in columns.iter().enumerate() {
                if let (true, Some(shown)) =
                    (self.rows.iter().any(|row| row[column].is_number), table.column_mut(place))
                {
                    shown.set_cell_alignment(CellAlignment::Right);
                }
            }
            parts.push(table.to_string());
        }
        parts.extend(self.notes.iter().map(|note| printable(note)));
        parts.join("\n")
    }

    /// The sheet as a table in Markdown, its notes in paragraphs.
    pub fn markdown(&self) -> String {
        let row = |cells: Vec<String>| format!("| {} |\n", cells.join(" | "));
        let plain = |text: &str| printable(text).replace('|', "/");
        let mut text = row(self.header.iter().map(|name| plain(name)).collect());
        text += &format!("|{}\n", "---|".repeat(self.header.len()));
        text.extend(self.rows.iter().map(|cells| row(cells.iter().map(|cell| plain(&cell.text)).collect())));
        text.extend(self.notes.iter().map(|note| format!("\n{}\n", printable(note))));
        text
    }
}

/// The cell as the page has it, with true minus signs, powers of ten and letters of units.
impl Serialize for Cell {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(Serialize)]
        struct OnPage<'a> {
            text: String,
            si: String,
            is_number: bool,
            kind: &'a str,
        }
        let text = match self.is_number || self.kind == WHOLE_LINE || self.text == NONE {
            true => typeset(&self.text),
            false => self.text.clone(),
        };
        let si = self.value.map_or(String::new(), |value| format!("{value}"));
        OnPage { text, si, is_number: self.is_number, kind: self.kind }.serialize(serializer)
    }
}

/// Numbers and units of a text with their true letters.
pub(crate) fn typeset(text: &str) -> String {
    if text == NONE {
        return "\u{2013}".to_owned();
    }
    let token = |token: &str| {
        let number = token.trim_start_matches(['(', '+']).trim_end_matches(')');
        match (number.parse::<f64>(), token.contains(|letter: char| letter.is_ascii_digit())) {
            (Ok(_), _) => token.replacen(number, &with_minus(number.to_owned()), 1),
            (Err(_), true) if token != "m3/s" && token != "kg/m3" => token.to_owned(),
            _ => printed_unit(token),
        }
    };
    text.split(' ').map(token).collect::<Vec<_>>().join(" ")
}

/// A title of the page begins with a capital.
fn sentence<S: Serializer>(title: &str, serializer: S) -> Result<S::Ok, S::Error> {
    let mut letters = title.chars();
    let first = letters.next().map(|letter| letter.to_uppercase().to_string());
    serializer.serialize_str(&(first.unwrap_or_default() + letters.as_str()))
}

/// Headings of the page have units with their true letters.
fn true_letters<S: Serializer>(header: &[String], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(header.iter().map(|heading| typeset(heading)))
}

/// A text.
pub fn text(text: impl Into<String>) -> Cell {
    Cell { text: text.into(), ..Cell::default() }
}

/// A text in a column of numbers.
pub fn numeral(text: impl Into<String>) -> Cell {
    Cell { is_number: true, ..self::text(text) }
}

/// Where there is no number.
pub fn none() -> Cell {
    numeral(NONE)
}

/// A number in its own unit.
pub fn number(value: f64) -> Cell {
    sized(value, 1.0, "")
}

/// A number in a unit of that size.
pub(crate) fn sized(value: f64, size: f64, unit: &str) -> Cell {
    let shown = match size == 1.0 && value.fract() == 0.0 && value.abs() < WHOLE {
        true => format!("{}", value + 0.0),
        false => without_zeros(significant(value / size, DIGITS)),
    };
    number_as(value, format!("{shown} {unit}").trim_end())
}

/// A number that is shown as this text.
pub fn number_as(value: f64, text: impl Into<String>) -> Cell {
    Cell { value: Some(value), ..numeral(text) }
}

/// A value with the digits of its bar, and the bar if there is one, in a unit of this size.
pub(crate) fn with_bar(value: f64, error: Option<f64>, size: f64) -> String {
    let error = error.map(|error| error / size);
    let bar = error.filter(|error| *error > 0.0).map(|error| format!(" \u{b1} {}", bar(error)));
    quantity_value(value / size, error, DIGITS) + &bar.unwrap_or_default()
}

/// The bar of a value in a unit of this size: its digits, or why there are none.
pub(crate) fn bar_in_words(error: Option<f64>, is_asked_for: bool, size: f64) -> String {
    match error {
        Some(0.0) => "exact".to_owned(),
        Some(error) => bar(error / size),
        None if is_asked_for => "not resolved".to_owned(),
        None => "not estimated".to_owned(),
    }
}

/// The value of a quantity in a unit of this size: the digits of its bar, or few where that is not resolved.
pub(crate) fn value_in_words(value: f64, error: Option<f64>, is_asked_for: bool, size: f64) -> String {
    match error {
        None if is_asked_for => unresolved(value / size),
        error => quantity_value(value / size, error.map(|error| error / size), ALL_DIGITS),
    }
}

/// A decimal number without zeros at its end.
pub(crate) fn without_zeros(number: String) -> String {
    let (mantissa, exponent) = number.split_at(number.find('e').unwrap_or(number.len()));
    match mantissa.contains('.') {
        true => mantissa.trim_end_matches('0').trim_end_matches('.').to_owned() + exponent,
        false => number,
    }
}

/// A count.
pub fn count(count: usize) -> Cell {
    number(count as f64)
}

/// A number, or a dash where there is none.
pub(crate) fn optional(value: Option<f64>) -> Cell {
    value.map_or_else(none, number)
}

/// A value of an axis.
pub(crate) fn of_axis(value: &AxisValue) -> Cell {
    match value {
        AxisValue::Number(value) => number(*value),
        AxisValue::Word(word) => text(word.as_str()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_page_has_true_letters_and_the_terminal_plain_ones() {
        let sheet = Sheet::new("a title", ["name", "mu, mN.m"], vec![vec![text("a-b"), sized(-2.5e-6, 1e-6, "um")]]);
        assert!(sheet.terminal().starts_with("a title\n") && sheet.terminal().contains("-2.5 um"));
        let page = serde_json::to_value(&sheet).expect("a page");
        assert_eq!((&page["title"], &page["header"][1]), (&"A title".into(), &"mu, mN\u{b7}m".into()));
        assert_eq!(page["rows"][0][0]["text"], "a-b");
        assert_eq!(page["rows"][0][1]["text"], "\u{2212}2.5 \u{b5}m");
        assert_eq!(typeset("12.5 (-4.36 \u{b1} 2e-5 %)"), "12.5 (\u{2212}4.36 \u{b1} 2\u{b7}10\u{207b}\u{2075} %)");
        assert_eq!([typeset("-"), typeset("within bars")], ["\u{2013}", "within bars"]);
    }
}
