//! Legends: samples and names in rows.

use crate::{Anchor, Colour, Figure, Label, Letters, Mark, Pen, SMALLEST_LETTERS, Stroke};

/// Length of a sample, its distance from the name, and that from the next sample [mm].
const SAMPLE: [f64; 3] = [7.0, 1.5, 4.0];

/// An entry of a legend: a curve, an area or a mark.
#[derive(Debug, Clone, PartialEq)]
pub struct LegendEntry {
    /// What it is.
    pub name: Label,
    /// Colour of the entry.
    pub colour: Colour,
    /// Line of the entry, where it has one.
    pub stroke: Option<Stroke>,
    /// Mark of the entry, where it has one.
    pub mark: Option<Mark>,
    /// Whether an area is filled with the colour.
    pub area: Option<Colour>,
}

impl LegendEntry {
    fn width(&self) -> f64 {
        SAMPLE[0] + SAMPLE[1] + self.name.width(letters())
    }
}

fn letters() -> Letters {
    Letters::sized(SMALLEST_LETTERS + 0.5)
}

/// Rows of at most that width.
fn rows(entries: &[LegendEntry], width: f64) -> Vec<Vec<&LegendEntry>> {
    let mut rows: Vec<Vec<&LegendEntry>> = Vec::new();
    let mut left = 0.0;
    for entry in entries {
        let needed = entry.width() + SAMPLE[2];
        match rows.last_mut().filter(|_| needed - SAMPLE[2] <= left) {
            Some(row) => row.push(entry),
            None => {
                rows.push(vec![entry]);
                left = width;
            }
        }
        left -= needed;
    }
    rows
}

/// Height of the legend [mm] at that width.
pub fn legend_height(entries: &[LegendEntry], width: f64) -> f64 {
    letters().line() * rows(entries, width).len() as f64
}

/// Draws the legend from its left top on.
pub fn draw_legend(figure: &mut Figure, entries: &[LegendEntry], [left, top]: [f64; 2], width: f64) {
    let line = letters().line();
    for (k, row) in rows(entries, width).into_iter().enumerate() {
        let y = top + line * (k as f64 + 0.5);
        let mut x = left;
        for entry in row {
            if let Some(colour) = entry.area {
                figure.rectangle([x, y - 1.1, SAMPLE[0], 2.2], colour);
            }
            if let Some(stroke) = entry.stroke {
                figure.line(&[[x, y], [x + SAMPLE[0], y]], Pen::new(1.0, entry.colour).stroked(stroke));
            }
            if let Some(mark) = entry.mark {
                figure.mark([x + 0.5 * SAMPLE[0], y], mark, entry.colour);
            }
            figure.text([x + SAMPLE[0] + SAMPLE[1], y], &entry.name, letters(), Anchor::Left);
            x += entry.width() + SAMPLE[2];
        }
    }
}
