//! Maps of cells: what became of each case of a grid, by colour and a word.

use plotters::style::{RGBColor, WHITE};

use super::canvas::{CENTRE, Canvas, LEFT, Letters, RIGHT, sheet};
use super::palette::{GREY, INK, of_share};
use crate::Error;

/// What became of one case.
#[derive(Debug, Clone, PartialEq)]
pub enum Cell {
    /// An answer, after so many iterations.
    Answer(usize),
    /// There is none, as expected; a word or number that gives the reason.
    Absent(String),
    /// An end that has no explanation.
    Unexplained(String),
}

/// A grid of cells.
#[derive(Debug, Clone, PartialEq)]
pub struct CellMap {
    /// What is shown.
    pub title: String,
    /// What the columns are.
    pub x: String,
    /// A word for each column.
    pub columns: Vec<String>,
    /// What the rows are.
    pub y: String,
    /// A word for each row, from below.
    pub rows: Vec<String>,
    /// Rows of cells, from below.
    pub cells: Vec<Vec<Cell>>,
}

/// Width and height of a cell [points].
const CELL: [f64; 2] = [54.0, 26.0];
/// Between cells [points].
const GAP: f64 = 1.0;
/// Left of the cells, above them, below them.
const MARGIN: [f64; 3] = [110.0, 62.0, 74.0];
/// Iterations of the darkest cells.
const MANY: f64 = 24.0;
/// Cells without an answer: sand.
const SAND: RGBColor = RGBColor(232, 205, 164);
/// Cells without an explanation.
const UNKNOWN: RGBColor = RGBColor(128, 128, 128);

/// Maps one below the other as SVG.
///
/// # Errors
/// [`Error::Format`].
pub fn cells_to_svg(maps: &[CellMap]) -> Result<String, Error> {
    let height = |map: &CellMap| MARGIN[1] + CELL[1] * map.rows.len() as f64 + MARGIN[2];
    let columns = maps.iter().map(|map| map.columns.len()).max().unwrap_or(0);
    let size = [
        MARGIN[0] + CELL[0] * columns as f64 + 30.0,
        maps.iter().map(height).sum::<f64>(),
    ];
    sheet(size, |canvas| {
        let mut top = 0.0;
        for map in maps {
            draw(canvas, map, top)?;
            top += height(map);
        }
        Ok(())
    })
}

fn draw(canvas: &Canvas, map: &CellMap, top: f64) -> Result<(), Error> {
    let left = MARGIN[0];
    let bottom = top + MARGIN[1] + CELL[1] * map.rows.len() as f64;
    let small = Letters::new(11.0, CENTRE);
    canvas.text([left, top + 24.0], &map.title, Letters::new(15.0, LEFT).bold())?;
    let legend = "colour and number: nonlinear iterations; sand: no film, as its limit says; grey: unexplained";
    canvas.text([left, top + 45.0], legend, Letters::new(11.0, LEFT).coloured(GREY))?;
    for (k, word) in map.columns.iter().enumerate() {
        canvas.text([left + CELL[0] * (k as f64 + 0.5), bottom + 13.0], word, small)?;
    }
    let across = left + 0.5 * CELL[0] * map.columns.len() as f64;
    canvas.text([across, bottom + 36.0], &map.x, Letters::new(12.0, CENTRE))?;
    let middle = 0.5 * (top + MARGIN[1] + bottom);
    canvas.text([22.0, middle], &map.y, Letters::new(12.0, CENTRE).upright())?;
    for (j, (word, cells)) in map.rows.iter().zip(&map.cells).enumerate() {
        let low = bottom - CELL[1] * j as f64;
        canvas.text([left - 8.0, low - 0.5 * CELL[1]], word, Letters::new(11.0, RIGHT))?;
        for (k, cell) in cells.iter().enumerate() {
            let [x, y] = [left + CELL[0] * k as f64, low - CELL[1]];
            let (colour, word, ink) = shown(cell);
            canvas.rectangle([x, y], [x + CELL[0] - GAP, low - GAP], colour)?;
            canvas.text([x + 0.5 * CELL[0], y + 0.5 * CELL[1]], &word, small.coloured(ink))?;
        }
    }
    Ok(())
}

/// Colour of a cell, its word and the colour of that.
fn shown(cell: &Cell) -> (RGBColor, String, RGBColor) {
    match cell {
        Cell::Answer(iterations) => {
            let share = *iterations as f64 / MANY;
            let ink = if share > 0.45 { WHITE } else { INK };
            (of_share(0.08 + 0.92 * share), iterations.to_string(), ink)
        }
        Cell::Absent(word) => (SAND, word.clone(), INK),
        Cell::Unexplained(word) => (UNKNOWN, word.clone(), WHITE),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_cell_is_drawn_with_its_word() {
        let map = CellMap {
            title: "A map".into(),
            x: "eccentricity".into(),
            columns: vec!["0.1".into(), "0.9".into()],
            y: "slenderness".into(),
            rows: vec!["1".into(), "2".into()],
            cells: vec![
                vec![Cell::Answer(7), Cell::Absent("limit".into())],
                vec![Cell::Answer(23), Cell::Unexplained("?".into())],
            ],
        };
        let svg = cells_to_svg(&[map.clone(), map]).expect("a drawing");
        for word in [
            "A map",
            "eccentricity",
            "slenderness",
            "\n7\n",
            "\nlimit\n",
            "\n23\n",
            "\n?\n",
        ] {
            assert!(svg.contains(word), "no {word:?} in {svg}");
        }
        assert!(crate::plot::to_png(&svg).is_ok());
    }
}
