//! The columns that a sweep is asked for: `columns = ["h_min um", "p_max bar"]`.

use std::ops::Range;

use crate::reader::TableReader;

/// Key of the list below `[sweep]`.
pub(super) const KEY: &str = "columns";

/// A column as it is written: a quantity, and the unit in which it is wanted.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct WantedColumn {
    /// Name or symbol of the quantity.
    pub name: String,
    /// Unit; empty where none is written.
    pub unit: String,
    /// Bytes of the scene's text where it is written.
    pub span: Range<usize>,
}

/// Reads the list, if it is written.
pub(super) fn read<'a>(table: &mut TableReader<'a>) -> Option<Vec<WantedColumn>> {
    let texts = table.texts_if_given(KEY)?;
    let column = |(text, span): (&str, Range<usize>)| {
        let (name, unit) = text.trim().split_once(char::is_whitespace).unwrap_or((text.trim(), ""));
        WantedColumn { name: name.to_owned(), unit: unit.trim().to_owned(), span }
    };
    Some(texts.into_iter().map(column).collect())
}
