//! Tables by crank angle in files: `angle [deg], Fx [kN], Fy [kN]` and one row a line.
//!
//! The first line that is not empty and does not begin with `#` is the header: names, each with its unit in brackets,
//! in any order. Angles grow, in steps of any length, over one period; the last row may repeat the first one a period
//! later, or be left out.

pub(crate) mod columns;
pub(crate) mod error;

use std::io::Read;
use std::path::Path;

use crate::unit::Dimension;
use crate::wording::degrees;
use columns::{ColumnPlaces, TableColumn};
pub use error::TableError;
use error::TableFault;

/// The largest table that is read [bytes].
const LIMIT: u64 = 1 << 24;
/// A row that repeats the first one may differ from it by this part of the greatest value.
const SAME: f64 = 1e-6;
/// A table need not close to more than this part of a period.
const CLOSED: f64 = 1e-9;
/// The step from the last row to the first one may be so many times the longest one before.
const LONGEST_GAP: f64 = 1.5;
/// Fewest rows of a period.
const LEAST_ROWS: usize = 4;

/// A row of a table of loads.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LoadRow {
    /// Crank angle [rad].
    pub angle: f64,
    /// Force [N].
    pub force: [f64; 2],
    /// Moment [N m]; zero where the table has none.
    pub moment: [f64; 2],
}

/// Reads a table of loads with a period [rad]: `angle`, `Fx`, `Fy` and, if both are there, `Mx`, `My`. A last row that
/// repeats the first is left out.
///
/// # Errors
/// [`TableError`]: the file cannot be read, or is no table of one period.
pub fn read_loads(path: &Path, period: f64) -> Result<Vec<LoadRow>, TableError> {
    loads(&read_text(path)?, period).map_err(|fault| fault.in_file(path))
}

/// Reads a table of pressures with a period [rad]: pairs of angle [rad] and pressure [Pa], from the columns `angle` and
/// `p`.
///
/// # Errors
/// As [`read_loads`].
pub fn read_pressures(path: &Path, period: f64) -> Result<Vec<[f64; 2]>, TableError> {
    pressures(&read_text(path)?, period).map_err(|fault| fault.in_file(path))
}

const ANGLE: TableColumn = TableColumn::needed("angle", Dimension::Angle);

fn loads(text: &str, period: f64) -> Result<Vec<LoadRow>, TableFault> {
    const COLUMNS: [TableColumn; 5] = [
        ANGLE,
        TableColumn::needed("Fx", Dimension::Force),
        TableColumn::needed("Fy", Dimension::Force),
        TableColumn::optional("Mx", Dimension::Torque),
        TableColumn::optional("My", Dimension::Torque),
    ];
    let rows = one_period(ColumnPlaces::read(text, &COLUMNS)?, period)?;
    let load = |row: &TableRow<5>| {
        let [angle, f_x, f_y, m_x, m_y] = row.values;
        LoadRow { angle, force: [f_x, f_y], moment: [m_x, m_y] }
    };
    Ok(rows.iter().map(load).collect())
}

fn pressures(text: &str, period: f64) -> Result<Vec<[f64; 2]>, TableFault> {
    const COLUMNS: [TableColumn; 2] = [ANGLE, TableColumn::needed("p", Dimension::Pressure)];
    let rows = one_period(ColumnPlaces::read(text, &COLUMNS)?, period)?;
    Ok(rows.iter().map(|row| row.values).collect())
}

/// A row in SI, the angle first, and its line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct TableRow<const N: usize> {
    pub(crate) line: usize,
    pub(crate) values: [f64; N],
}

impl<const N: usize> TableRow<N> {
    fn angle(&self) -> f64 {
        self.values[0]
    }
}

/// The rows of one period; a last one that repeats the first is left out.
fn one_period<const N: usize>(mut rows: Vec<TableRow<N>>, period: f64) -> Result<Vec<TableRow<N>>, TableFault> {
    growing(&rows)?;
    let [Some(first), Some(last)] = [rows.first().copied(), rows.last().copied()] else {
        return Err(few(0));
    };
    let beyond = |row: &TableRow<N>| (row.angle() - first.angle()) / period - 1.0;
    if let Some(row) = rows.iter().find(|row| beyond(row) > CLOSED) {
        let [angle, from, period] = [row.angle(), first.angle(), period].map(degrees);
        return Err(TableFault::at(
            row.line,
            format!("the angle {angle} is more than load.period = {period} beyond the first one, {from}"),
            "correct load.period, or leave out the rows of the next period",
        ));
    }
    if beyond(&last).abs() <= CLOSED {
        closed(&rows, &first, &last)?;
        rows.pop();
    }
    if rows.len() < LEAST_ROWS {
        return Err(few(rows.len()));
    }
    covering(&rows, period)?;
    Ok(rows)
}

fn few(rows: usize) -> TableFault {
    TableFault::of_all(
        format!("has {rows} rows of numbers in a period, and a load over a cycle needs {LEAST_ROWS} or more"),
        "write a header as angle [deg], Fx [kN], Fy [kN], and a row for each angle below it",
    )
}

/// Angles grow.
fn growing<const N: usize>(rows: &[TableRow<N>]) -> Result<(), TableFault> {
    match rows.array_windows().find(|[before, row]| row.angle() <= before.angle()) {
        None => Ok(()),
        Some([before, row]) => {
            let [before, angle] = [before.angle(), row.angle()].map(degrees);
            Err(TableFault::at(
                row.line,
                format!("the angle {angle} is not beyond that of the row before, {before}"),
                "sort the rows by angle, and give each angle once",
            ))
        }
    }
}

/// A last row that stands a period after the first is the same.
fn closed<const N: usize>(rows: &[TableRow<N>], first: &TableRow<N>, last: &TableRow<N>) -> Result<(), TableFault> {
    for k in 1..N {
        let greatest = rows.iter().map(|row| row.values[k].abs()).fold(0.0, f64::max);
        let off = (last.values[k] - first.values[k]).abs();
        if off > SAME * greatest {
            let message = format!(
                "the row stands a period after that of line {}, but differs from it by {:.1e} of the greatest value",
                first.line,
                off / greatest
            );
            let help = "a period ends as it begins: correct the values, or leave this row out";
            return Err(TableFault::at(last.line, message, help));
        }
    }
    Ok(())
}

/// The step from the last row to the first one of the next period is not much longer than others.
fn covering<const N: usize>(rows: &[TableRow<N>], period: f64) -> Result<(), TableFault> {
    let steps = rows.array_windows().map(|[a, b]| b.angle() - a.angle());
    let longest = steps.fold(0.0, f64::max);
    let [Some(first), Some(last)] = [rows.first(), rows.last()] else {
        return Err(few(0));
    };
    let gap = first.angle() + period - last.angle();
    if gap <= LONGEST_GAP * longest {
        return Ok(());
    }
    let [angle, gap, longest, period] = [last.angle(), gap, longest, period].map(degrees);
    Err(TableFault::at(
        last.line,
        format!(
            "the table ends at {angle}, {gap} before it begins again with load.period = {period}, and its longest step is {longest}"
        ),
        "add the missing rows, or correct load.period",
    ))
}

/// The text of the file of a table.
///
/// # Errors
/// It is no plain file, too large for a table, no UTF-8, or cannot be read.
pub fn read_text(path: &Path) -> Result<String, TableError> {
    const HELP: &str = "give the path of a table, counted from the folder of the scene";
    let fail = |message: String| TableFault::of_all(message, HELP).in_file(path);
    let unreadable = |error: std::io::Error| fail(format!("it cannot be read: {error}"));
    let file = std::fs::File::open(path).map_err(unreadable)?;
    if !file.metadata().map_err(unreadable)?.is_file() {
        return Err(fail("it is not a plain file".to_owned()));
    }
    let mut bytes = Vec::new();
    file.take(LIMIT + 1).read_to_end(&mut bytes).map_err(unreadable)?;
    if bytes.len() as u64 > LIMIT {
        return Err(fail(format!("it is larger than {LIMIT} bytes, so it is no table of one period")));
    }
    String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        TableFault::of_all(format!("it is not UTF-8 text (first wrong byte: {at})"), "save it as UTF-8").in_file(path)
    })
}

#[cfg(test)]
mod tests;
