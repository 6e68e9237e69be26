//! Numbers as a document prints them: tables whose cells keep their digits, compared to half a unit of the last one.

use crate::program::repository;

/// A row of a printed table; its columns are told by the name before a bracket or by the whole heading.
#[derive(Debug, Clone)]
pub struct Row {
    cells: Vec<(String, String)>,
}

/// The rows of a table under `tests/data`.
///
/// # Panics
/// If there is none of that name.
pub fn rows(path: &str) -> Vec<Row> {
    let path = repository().join("tests/data").join(path);
    let mut reader = csv::Reader::from_path(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let headings: Vec<String> = reader.headers().expect("headings").iter().map(str::to_owned).collect();
    let records = reader.records().map(|record| record.expect("as many cells as headings"));
    records
        .map(|record| Row { cells: headings.iter().cloned().zip(record.iter().map(str::to_owned)).collect() })
        .collect()
}

impl Row {
    /// The row of headings and what is printed under them.
    pub fn new(cells: &[(&str, &str)]) -> Self {
        let owned = |&(heading, text): &(&str, &str)| (heading.to_owned(), text.to_owned());
        Self { cells: cells.iter().map(owned).collect() }
    }

    /// The headings.
    pub fn columns(&self) -> impl Iterator<Item = &str> {
        self.cells.iter().map(|(heading, _)| heading.as_str())
    }

    /// What is printed.
    ///
    /// # Panics
    /// If there is no such column.
    pub fn text(&self, column: &str) -> &str {
        let named = |heading: &str| heading == column || heading.split('[').next() == Some(column);
        let cell = self.cells.iter().find(|(heading, _)| named(heading));
        &cell.unwrap_or_else(|| panic!("no column {column} in {self:?}")).1
    }

    /// The number that is printed.
    ///
    /// # Panics
    /// If it is none.
    pub fn number(&self, column: &str) -> f64 {
        let text = self.text(column);
        text.parse().unwrap_or_else(|_| panic!("{column} is no number: {text}"))
    }

    /// True if the value, rounded to as many digits, is what is printed.
    pub fn prints(&self, column: &str, value: f64) -> bool {
        let printed = self.number(column);
        (value - printed).abs() <= half_a_unit(self.text(column)) + 1e-13 * printed.abs()
    }

    /// Asks that.
    ///
    /// # Panics
    /// If it is not.
    #[track_caller]
    pub fn assert_prints(&self, column: &str, value: f64) {
        assert!(self.prints(column, value), "{column}: {value} in {self:?}");
    }

    /// Asks for the digits that are printed, rounded or just cut off.
    ///
    /// # Panics
    /// If they are others.
    #[track_caller]
    pub fn assert_cuts_or_prints(&self, column: &str, value: f64) {
        let beyond = value - self.number(column);
        let cut = (0.0..2.0 * half_a_unit(self.text(column))).contains(&beyond);
        assert!(cut || self.prints(column, value), "{column}: {value} in {self:?}");
    }
}

/// Half a unit of the last digit; a zero without decimals is asked to 1e-9.
fn half_a_unit(text: &str) -> f64 {
    let (digits, power) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let power: i32 = power.parse().unwrap_or_else(|_| panic!("no power of ten in {text}"));
    match digits.split_once('.') {
        None if digits == "0" => 1e-9,
        None => 0.5 * 10f64.powi(power),
        Some((_, decimals)) => 0.5 * 10f64.powi(power - decimals.len() as i32),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_are_counted() {
        let row = Row::new(&[("a[-]", "1.20"), ("b", "3.4E-02"), ("c", "7"), ("d", "0")]);
        assert!(row.prints("a", 1.2049) && !row.prints("a[-]", 1.2051));
        assert!(row.prints("b", 0.03449) && !row.prints("b", 0.03451));
        assert!(row.prints("c", 7.4) && !row.prints("c", 7.6));
        assert!(row.prints("d", 0.0) && !row.prints("d", 0.1));
        row.assert_cuts_or_prints("a", 1.2099);
    }
}
