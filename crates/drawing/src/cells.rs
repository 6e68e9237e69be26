//! Grids of coloured cells with a word each.

use crate::{Anchor, Colour, Figure, GREY, Label, Letters, SMALLEST_LETTERS};

/// Height of a cell [mm].
pub const CELL_HEIGHT: f64 = 5.0;
/// Gap between cells [mm].
const GAP: f64 = 0.3;
/// Room above the cells, below them, and right of them [mm].
const ABOVE: f64 = 9.5;
const BELOW: f64 = 10.0;
const RIGHT: f64 = 1.5;

/// A cell: its colour and its word.
#[derive(Debug, Clone, PartialEq)]
pub struct ColouredCell {
    /// Colour of the cell.
    pub fill: Colour,
    /// Word in the cell, left out where it does not fit.
    pub word: Label,
}

/// Cells in rows.
#[derive(Debug, Clone, PartialEq)]
pub struct CellGrid {
    /// What is shown.
    pub title: Label,
    /// What the colours mean, in words.
    pub legend: Label,
    /// What the columns are.
    pub x: Label,
    /// A word for each column.
    pub columns: Vec<Label>,
    /// What the rows are.
    pub y: Label,
    /// A word for each row, from below.
    pub rows: Vec<Label>,
    /// Rows of cells, from below.
    pub cells: Vec<Vec<ColouredCell>>,
}

impl CellGrid {
    /// Height of the grid [mm].
    pub fn height(&self) -> f64 {
        ABOVE + CELL_HEIGHT * self.rows.len() as f64 + BELOW
    }

    /// Draws the grid into that width [mm] from its left top on; returns the rectangle of the cells.
    pub fn draw(&self, figure: &mut Figure, [left, top]: [f64; 2], width: f64) -> [f64; 4] {
        let small = Letters::sized(SMALLEST_LETTERS);
        let usual = Letters::default();
        let words = self.rows.iter().map(|word| word.width(small)).fold(0.0, f64::max);
        let beside = usual.line() + words + 2.0;
        let x = left + beside;
        let size = [(width - beside - RIGHT) / self.columns.len().max(1) as f64, CELL_HEIGHT];
        let inner = [x, top + ABOVE, width - beside - RIGHT, CELL_HEIGHT * self.rows.len() as f64];
        let bottom = inner[1] + inner[3];
        figure.text([x, top + 2.0], &self.title, usual.bold(), Anchor::Left);
        figure.text([x, top + 6.3], &self.legend, small.coloured(GREY), Anchor::Left);
        // Words of columns that do not fit beside each other are left out evenly.
        let widest = self.columns.iter().map(|word| word.width(small)).fold(0.0, f64::max);
        let every = ((widest + 1.0) / size[0]).ceil().max(1.0) as usize;
        for (k, word) in self.columns.iter().enumerate().filter(|(k, _)| k % every == 0) {
            figure.text([x + size[0] * (k as f64 + 0.5), bottom + 2.2], word, small, Anchor::Centre);
        }
        figure.text([x + 0.5 * inner[2], bottom + 6.5], &self.x, usual, Anchor::Centre);
        figure.text([left + 0.5 * usual.line(), inner[1] + 0.5 * inner[3]], &self.y, usual, Anchor::Upright);
        for (j, (word, cells)) in self.rows.iter().zip(&self.cells).enumerate() {
            let high = bottom - size[1] * (j as f64 + 1.0);
            let middle = high + 0.5 * (size[1] - GAP);
            figure.text([x - 1.2, middle], word, small, Anchor::Right);
            for (k, cell) in cells.iter().enumerate() {
                let at = x + size[0] * k as f64;
                figure.rectangle([at, high, size[0] - GAP, size[1] - GAP], cell.fill);
                if cell.word.width(small) < size[0] - GAP {
                    let letters = small.coloured(cell.fill.ink());
                    figure.text([at + 0.5 * (size[0] - GAP), middle], &cell.word, letters, Anchor::Centre);
                }
            }
        }
        inner
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{BLUE, WHITE};

    #[test]
    fn every_cell_is_drawn_with_its_word() {
        let cell = |fill: Colour, word: &str| ColouredCell { fill, word: word.into() };
        let grid = CellGrid {
            title: "A grid".into(),
            legend: "what colours mean".into(),
            x: "eccentricity".into(),
            columns: vec!["0.1".into(), "0.9".into()],
            y: "slenderness".into(),
            rows: vec!["1".into(), "2".into()],
            cells: vec![vec![cell(WHITE, "7"), cell(BLUE, "limit")], vec![cell(WHITE, "23"), cell(BLUE, "?")]],
        };
        let mut figure = Figure::new([85.0, grid.height()], "t", "d");
        grid.draw(&mut figure, [0.0, 0.0], 85.0);
        let svg = figure.to_svg();
        for word in ["A grid", "eccentricity", "slenderness", "\n7\n", "\nlimit\n", "\n23\n", "\n?\n"] {
            assert!(svg.contains(word), "no {word:?} in {svg}");
        }
        assert!(figure.to_png().is_ok());
    }
}
