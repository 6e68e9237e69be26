//! `orbit.csv`: the path of the journal over the last cycle, a row for each film.

use oilwedge_study::orbit::OrbitPath;

use crate::Error;
use crate::number_columns::{self, cells, columns_of, exact};
use crate::sweep::to_csv;

/// The table: crank angle, time, place of the journal, then all numbers of the film with their bars, if any.
///
/// # Errors
/// A number is not finite.
pub fn orbit_table(path: &OrbitPath) -> Result<Vec<u8>, Error> {
    let first = path.quantities.first().map_or(&[][..], Vec::as_slice);
    let columns = columns_of(first.iter());
    let has_bars = first.iter().any(|quantity| quantity.bar.is_some());
    let mut headings: Vec<String> =
        ["crank angle [deg]", "time [s]", "e_x/c [1]", "e_y/c [1]"].map(str::to_owned).into();
    headings.extend(number_columns::headings(&columns, has_bars));
    let mut rows = vec![headings];
    for (number, quantities) in path.quantities.iter().enumerate() {
        let [x, y] = path.offsets[number];
        let place = [path.crank_angles[number], path.times[number], x, y];
        let mut row = place.into_iter().map(|value| exact(value, "orbit")).collect::<Result<Vec<_>, _>>()?;
        row.extend(cells(&columns, has_bars, quantities, "orbit")?);
        rows.push(row);
    }
    Ok(to_csv(&rows))
}
