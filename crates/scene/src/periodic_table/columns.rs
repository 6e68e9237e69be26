//! Header and cells of a table: names with units, and finite numbers.

use super::TableRow;
use super::error::TableFault;
use crate::spelling::nearest;
use crate::unit::{self, Dimension};

/// A column that a table may have.
#[derive(Debug, Clone, Copy)]
pub(crate) struct TableColumn {
    name: &'static str,
    dimension: Dimension,
    presence: Presence,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Presence {
    Needed,
    Optional,
}

impl TableColumn {
    pub(crate) const fn needed(name: &'static str, dimension: Dimension) -> Self {
        Self { name, dimension, presence: Presence::Needed }
    }

    /// A column whose values are zero where it is not there.
    pub(crate) const fn optional(name: &'static str, dimension: Dimension) -> Self {
        Self { presence: Presence::Optional, ..Self::needed(name, dimension) }
    }

    /// The column as it is written in a header.
    fn example(&self) -> String {
        let unit = match self.dimension {
            Dimension::Angle => "deg",
            Dimension::Force => "kN",
            Dimension::Torque => "N.m",
            Dimension::Ratio => "1",
            _ => self.dimension.units().first().map_or("", |(unit, _)| unit),
        };
        format!("{} [{unit}]", self.name)
    }
}

/// What a table is of that has columns beside the wanted ones.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Others {
    /// Wrong: their names are misspelt.
    Refused,
    /// A result with more numbers than are wanted.
    Ignored,
}

/// Where the columns of a table stand, and the size of their units in SI.
#[derive(Debug)]
pub(crate) struct ColumnPlaces<const N: usize> {
    /// Place, size of the unit and kind, by wanted column.
    places: [Option<(usize, f64, Dimension)>; N],
    count: usize,
}

impl<const N: usize> ColumnPlaces<N> {
    /// The rows of a text in SI, which has no other columns; values of optional columns that are not there are zero.
    pub(crate) fn read(text: &str, wanted: &[TableColumn; N]) -> Result<Vec<TableRow<N>>, TableFault> {
        Self::read_beside(text, wanted, Others::Refused)
    }

    /// The rows of a text in SI; values of optional columns that are not there are zero.
    pub(crate) fn read_beside(
        text: &str,
        wanted: &[TableColumn; N],
        others: Others,
    ) -> Result<Vec<TableRow<N>>, TableFault> {
        let mut lines = lines(text);
        let Some((line, header)) = lines.next() else {
            return Err(TableFault::of_all("is empty", write(wanted)));
        };
        let columns = Self::of_header(line, header, (wanted, others))?;
        lines.map(|(line, cells)| columns.row(line, cells)).collect()
    }

    fn of_header(line: usize, header: &str, (wanted, others): (&[TableColumn; N], Others)) -> Result<Self, TableFault> {
        let fail = |message: String| TableFault::at(line, message, write(wanted));
        let cells: Vec<&str> = header.split(',').map(str::trim).collect();
        let mut places = [None; N];
        for (place, cell) in cells.iter().enumerate() {
            let parts = cell.split_once('[');
            let parts = parts.and_then(|(name, rest)| Some((name.trim(), rest.strip_suffix(']')?.trim())));
            let Some((name, unit)) = parts else {
                return Err(fail(format!("\"{cell}\" is not a name with its unit in brackets")));
            };
            let Some(k) = wanted.iter().position(|column| column.name == name) else {
                if others == Others::Ignored {
                    continue;
                }
                let near = nearest(name, wanted.iter().map(|column| column.name));
                let hint = near.map_or(String::new(), |near| format!(", did you mean \"{near}\"?"));
                return Err(fail(format!("the column \"{name}\" is not known{hint}")));
            };
            if places[k].is_some() {
                return Err(fail(format!("the column \"{name}\" stands there twice")));
            }
            let size = match (unit, wanted[k].dimension) {
                ("1", Dimension::Ratio) => 1.0,
                (unit, dimension) => unit::unit_size(unit, dimension)
                    .map_err(|error| fail(format!("the unit of \"{name}\": {error}")))?,
            };
            places[k] = Some((place, size, wanted[k].dimension));
        }
        let missing = (0..N).find(|&k| places[k].is_none() && wanted[k].presence == Presence::Needed);
        match missing {
            Some(k) => Err(fail(format!("there is no column \"{}\"", wanted[k].name))),
            None => Ok(Self { places, count: cells.len() }),
        }
    }

    fn row(&self, line: usize, text: &str) -> Result<TableRow<N>, TableFault> {
        let cells: Vec<&str> = text.split(',').map(str::trim).collect();
        if cells.len() != self.count {
            let message = format!("there are {} cells, and the header has {}", cells.len(), self.count);
            let help = "write decimal points, and commas between the columns only";
            return Err(TableFault::at(line, message, help));
        }
        let mut values = [0.0; N];
        for (value, place) in values.iter_mut().zip(self.places) {
            let Some((place, size, dimension)) = place else {
                continue;
            };
            let number = cells[place].parse::<f64>().map(|number| number * size);
            let Some(number) = number.ok().filter(|number| number.is_finite()) else {
                let message = format!("\"{}\" is not a finite number", cells[place]);
                return Err(TableFault::at(line, message, "write for example 12.5 or 1.25e1, without a unit"));
            };
            if !dimension.holds(number) {
                let ([least, most], (unit, _)) = (dimension.range(), dimension.units()[0]);
                let message = format!("\"{}\" is out of range", cells[place]);
                let help = format!("check the exponent: zero, or {least:.0e} to {most:.0e} {unit}, is wanted");
                return Err(TableFault::at(line, message, help));
            }
            *value = number;
        }
        Ok(TableRow { line, values })
    }
}

/// The lines of a text that are no comments, with their numbers; the first is the header.
fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let text = text.trim_start_matches('\u{feff}');
    let lines = (1..).zip(text.lines().map(str::trim));
    lines.filter(|(_, line)| !line.is_empty() && !line.starts_with('#'))
}

/// Whether the header of a table has a column of this name.
pub(crate) fn has_column(text: &str, name: &str) -> bool {
    let cells = lines(text).next().map_or("", |(_, header)| header).split(',');
    cells.filter_map(|cell| cell.split_once('[')).any(|(found, _)| found.trim() == name)
}

/// How the header is written.
fn write<const N: usize>(wanted: &[TableColumn; N]) -> String {
    let (needed, optional): (Vec<_>, Vec<_>) = wanted.iter().partition(|column| column.presence == Presence::Needed);
    let names =
        |columns: Vec<&TableColumn>| columns.iter().map(|column| column.example()).collect::<Vec<_>>().join(", ");
    let rest = match optional.is_empty() {
        true => String::new(),
        false => format!(" and, if wanted, {}", names(optional)),
    };
    format!("write the header as {}{rest}, with commas between the columns", names(needed))
}
