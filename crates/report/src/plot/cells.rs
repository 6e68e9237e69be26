//! Maps of cells: what became of each case of a grid, by colour and a word.

use plotters::style::RGBColor;
use plotters::style::text_anchor::{HPos, VPos};

use super::PlotError;
use super::axes::plain;
use super::canvas::{Canvas, Letters, in_points};
use super::palette::{GREY, INK, of_share};

/// What became of one case.
#[derive(Debug, Clone, PartialEq)]
pub enum Cell {
    /// An answer, after so many iterations.
    Answer(usize),
    /// There is none, as was known; a word or number that tells why.
    Absent(String),
    /// Something that nobody explained.
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
/// Left of the cells, above them, below them.
const MARGIN: [f64; 3] = [110.0, 62.0, 74.0];
/// Iterations of the darkest cells.
const MANY: f64 = 24.0;
/// Cells without an answer: sand.
const SAND: RGBColor = RGBColor(232, 205, 164);
/// What nobody explained.
const UNKNOWN: RGBColor = RGBColor(128, 128, 128);

/// Maps one below the other as SVG.
///
/// # Errors
/// [`PlotError::Drawing`].
pub fn cells_to_svg(maps: &[CellMap]) -> Result<String, PlotError> {
    let height = |map: &CellMap| MARGIN[1] + CELL[1] * map.rows.len() as f64 + MARGIN[2];
    let columns = maps.iter().map(|map| map.columns.len()).max().unwrap_or(0);
    let size = [
        MARGIN[0] + CELL[0] * columns as f64 + 30.0,
        maps.iter().map(height).sum::<f64>(),
    ];
    let mut text = String::new();
    let canvas = Canvas::new(&mut text, size)?;
    let mut top = 0.0;
    for map in maps {
        draw(&canvas, map, top)?;
        top += height(map);
    }
    canvas.finish()?;
    Ok(in_points(&text, size))
}

fn draw(canvas: &Canvas, map: &CellMap, top: f64) -> Result<(), PlotError> {
    let left = MARGIN[0];
    let bottom = top + MARGIN[1] + CELL[1] * map.rows.len() as f64;
    let middle = |k: usize| left + CELL[0] * (k as f64 + 0.5);
    let bold = Letters {
        bold: true,
        ..plain(15.0, (HPos::Left, VPos::Center))
    };
    canvas.text([left, top + 24.0], &map.title, bold)?;
    let legend = "colour and number: nonlinear iterations; sand: no film, as its limit says; grey: unexplained";
    let lesser = Letters {
        colour: GREY,
        ..plain(11.0, (HPos::Left, VPos::Center))
    };
    canvas.text([left, top + 45.0], legend, lesser)?;
    for (k, word) in map.columns.iter().enumerate() {
        canvas.text(
            [middle(k), bottom + 13.0],
            word,
            plain(11.0, (HPos::Center, VPos::Center)),
        )?;
    }
    let across = left + 0.5 * CELL[0] * map.columns.len() as f64;
    canvas.text(
        [across, bottom + 36.0],
        &map.x,
        plain(12.0, (HPos::Center, VPos::Center)),
    )?;
    let upright = Letters {
        upright: true,
        ..plain(12.0, (HPos::Center, VPos::Center))
    };
    canvas.text([22.0, 0.5 * (top + MARGIN[1] + bottom)], &map.y, upright)?;
    for (j, (word, cells)) in map.rows.iter().zip(&map.cells).enumerate() {
        let low = bottom - CELL[1] * j as f64;
        let centre = low - 0.5 * CELL[1];
        canvas.text([left - 8.0, centre], word, plain(11.0, (HPos::Right, VPos::Center)))?;
        for (k, cell) in cells.iter().enumerate() {
            one(canvas, cell, [left + CELL[0] * k as f64, low - CELL[1]])?;
        }
    }
    Ok(())
}

fn one(canvas: &Canvas, cell: &Cell, [x, y]: [f64; 2]) -> Result<(), PlotError> {
    let (colour, word, ink) = match cell {
        Cell::Answer(iterations) => {
            let share = *iterations as f64 / MANY;
            let ink = if share > 0.45 { plotters::style::WHITE } else { INK };
            (of_share(0.08 + 0.92 * share), iterations.to_string(), ink)
        }
        Cell::Absent(word) => (SAND, word.clone(), INK),
        Cell::Unexplained(word) => (UNKNOWN, word.clone(), plotters::style::WHITE),
    };
    const GAP: f64 = 1.0;
    let [right, low] = [x + CELL[0] - GAP, y + CELL[1] - GAP];
    canvas.polygon(&[[x, y], [right, y], [right, low], [x, low]], colour)?;
    let letters = Letters {
        colour: ink,
        ..plain(11.0, (HPos::Center, VPos::Center))
    };
    canvas.text([x + 0.5 * CELL[0], y + 0.5 * CELL[1]], &word, letters)
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
