//! Columns of quantities in tables of CSV, each followed by that of its error where there are bars.

use oilwedge_study::column::Column;
use oilwedge_study::quantities::Quantity;

use crate::Error;

/// The columns of these quantities in their own units, each once.
pub(crate) fn columns_of<'a>(quantities: impl Iterator<Item = &'a Quantity>) -> Vec<Column> {
    let mut columns: Vec<Column> = Vec::new();
    for quantity in quantities {
        if columns.iter().all(|column| column.quantity != quantity.name) {
            columns.push(Column::of(quantity.name.clone(), quantity.row));
        }
    }
    columns
}

/// The headings of columns.
pub(crate) fn headings(columns: &[Column], bars: bool) -> impl Iterator<Item = String> {
    columns.iter().flat_map(move |column| [Some(column.heading()), bars.then(|| column.error_heading())]).flatten()
}

/// The cells of a row of quantities, empty where there is none or no error; `place` is the row in words.
///
/// # Errors
/// A number is not finite.
pub(crate) fn cells(
    columns: &[Column],
    bars: bool,
    quantities: &[Quantity],
    place: &str,
) -> Result<Vec<String>, Error> {
    let numbers = columns.iter().flat_map(|column| {
        let found = quantities.iter().find(|quantity| quantity.name == column.quantity);
        let error = found.and_then(Quantity::error).map(|error| column.error(error));
        let numbers = [Some(found.map(|found| column.value(found.value))), bars.then_some(error)];
        numbers.into_iter().flatten().map(move |number| (column, number))
    });
    let cell = |(column, number): (&Column, Option<f64>)| match number {
        Some(number) => exact(number, &format!("{place}, {}", column.quantity)),
        None => Ok(String::new()),
    };
    numbers.map(cell).collect()
}

/// A number with all its digits.
///
/// # Errors
/// It is not finite.
pub(crate) fn exact(value: f64, name: &str) -> Result<String, Error> {
    match value.is_finite() {
        true => Ok(format!("{value:?}")),
        false => Err(Error::NotFinite { name: name.to_owned(), value }),
    }
}
