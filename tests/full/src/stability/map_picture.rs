//! The picture of the map: what became of each case of a grid, by colour and a word.

use oilwedge_drawing::{CellGrid, Colour, ColourMap, ColouredCell, Figure, Label, PAGE_WIDTH};

/// What became of one case.
#[derive(Debug, Clone, PartialEq)]
pub enum Outcome {
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
    pub cells: Vec<Vec<Outcome>>,
}

/// Iterations of the darkest cells.
const MANY: f64 = 24.0;
/// Cells without an answer: sand.
const SAND: Colour = Colour([232, 205, 164]);
/// Cells without an explanation.
const UNKNOWN: Colour = Colour([110, 110, 110]);
/// Gap between maps [mm].
const GAP: f64 = 3.0;

/// Maps one below the other.
pub fn cells_figure(maps: &[CellMap]) -> Figure {
    let grids: Vec<CellGrid> = maps.iter().map(grid).collect();
    let height: f64 = grids.iter().map(|grid| grid.height() + GAP).sum();
    let titles: Vec<&str> = maps.iter().map(|map| map.title.as_str()).collect();
    let mut figure = Figure::new([PAGE_WIDTH, height], "Where the solver is stable", &titles.join("; "));
    let mut top = 0.0;
    for grid in &grids {
        grid.draw(&mut figure, [0.0, top], PAGE_WIDTH);
        top += grid.height() + GAP;
    }
    figure
}

fn grid(map: &CellMap) -> CellGrid {
    let labels = |words: &[String]| words.iter().map(|word| Label::plain(word)).collect();
    CellGrid {
        title: Label::plain(&map.title),
        legend: Label::plain(
            "colour and number: nonlinear iterations; sand: no film, as its limit says; grey: unexplained",
        ),
        x: Label::plain(&map.x),
        columns: labels(&map.columns),
        y: Label::plain(&map.y),
        rows: labels(&map.rows),
        cells: map.cells.iter().map(|row| row.iter().map(painted).collect()).collect(),
    }
}

/// Colour of a cell and its word.
fn painted(cell: &Outcome) -> ColouredCell {
    let (fill, word) = match cell {
        Outcome::Answer(iterations) => {
            let share = *iterations as f64 / MANY;
            (ColourMap::Devon.colour(0.06 + 0.94 * share), iterations.to_string())
        }
        Outcome::Absent(word) => (SAND, word.clone()),
        Outcome::Unexplained(word) => (UNKNOWN, word.clone()),
    };
    ColouredCell { fill, word: Label::plain(&word) }
}
