//! `orbit.csv`: the path of the journal over the last cycle, a row for each film.

use oilwedge_study::column::Column;
use oilwedge_study::orbit::OrbitPath;
use oilwedge_study::quantities::Quantity;

use crate::Error;
use crate::sweep::to_csv;

/// The table: crank angle, time, place of the journal, then all numbers of the film with their bars, if any.
///
/// # Errors
/// A number is not finite.
pub fn orbit_table(path: &OrbitPath) -> Result<Vec<u8>, Error> {
    let first = path.quantities.first().map_or(&[][..], Vec::as_slice);
    let columns: Vec<Column> = (first.iter()).map(|quantity| Column::of(quantity.name.clone(), quantity.row)).collect();
    let has_bars = first.iter().any(|quantity| quantity.bar.is_some());
    let mut headings: Vec<String> =
        ["crank angle [deg]", "time [s]", "e_x/c [1]", "e_y/c [1]"].map(str::to_owned).into();
    for column in &columns {
        headings.push(column.heading());
        headings.extend(has_bars.then(|| column.error_heading()));
    }
    let mut rows = vec![headings];
    for (number, quantities) in path.quantities.iter().enumerate() {
        let [x, y] = path.offsets[number];
        let mut row = Vec::new();
        for value in [path.crank_angles[number], path.times[number], x, y] {
            row.push(exact(value)?);
        }
        for column in &columns {
            let found = quantities.iter().find(|quantity| quantity.name == column.quantity);
            let text = |value: Option<f64>| value.map_or(Ok(String::new()), exact);
            row.push(text(found.map(|quantity| quantity.value))?);
            if has_bars {
                row.push(text(found.and_then(Quantity::error))?);
            }
        }
        rows.push(row);
    }
    Ok(to_csv(&rows))
}

/// A number with all its digits.
///
/// # Errors
/// It is not finite.
pub(crate) fn exact(value: f64) -> Result<String, Error> {
    match value.is_finite() {
        true => Ok(format!("{value:?}")),
        false => Err(Error::NotFinite { name: "orbit".to_owned(), value }),
    }
}
