//! Bars of stiffness and damping: what two films of one bearing differ by.
//!
//! The tangent of a film converges irregularly where triangles change sides at the edge of its cavity, so that the difference of one entry may be small by chance.
//! The greatest difference of all entries, each over the geometric mean of the greatest entries of its row and its column, counts for every one.

use oilwedge_bearing::Coefficients;
use oilwedge_bearing::dynamics::Square;

/// Half widths of the bars of all coefficients.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CoefficientBars {
    /// Of the stiffness, in its units.
    pub stiffness: Square,
    /// Of the damping, in its units.
    pub damping: Square,
}

impl CoefficientBars {
    /// Of a film, by `per_difference` of its difference from another one, but at least the part `least` of each entry's size.
    pub(super) fn of(film: &Coefficients, other: &Coefficients, per_difference: f64, least: f64) -> Self {
        Self {
            stiffness: bars(&film.stiffness, &other.stiffness, per_difference, least),
            damping: bars(&film.damping, &other.damping, per_difference, least),
        }
    }
}

fn bars(of: &Square, other: &Square, per_difference: f64, least: f64) -> Square {
    // Offsets and slopes have units of their own.
    let greatest = |entries: [f64; 2]| entries.into_iter().fold(0.0, |most: f64, entry| most.max(entry.abs()));
    let size = |i: usize, j: usize| {
        let (rows, columns) = (i - i % 2, j - j % 2);
        let row = greatest([0, 1].map(|column| of[i][columns + column]));
        let column = greatest([0, 1].map(|row| of[rows + row][j]));
        (row * column).sqrt()
    };
    let mut bars = [[0.0; 4]; 4];
    let mut part: f64 = 0.0;
    for (i, row) in bars.iter_mut().enumerate() {
        for (j, bar) in row.iter_mut().enumerate() {
            *bar = size(i, j);
            if *bar > 0.0 && i / 2 == j / 2 {
                part = part.max((of[i][j] - other[i][j]).abs() / *bar);
            }
        }
    }
    // Of a block that vanishes by symmetry only the size of its neighbours is known.
    for (i, row) in bars.iter_mut().enumerate() {
        for (j, bar) in row.iter_mut().enumerate() {
            if i / 2 != j / 2 {
                *bar = (size(i, i) * size(j, j)).sqrt();
                part = part.max(if *bar > 0.0 {
                    (of[i][j] - other[i][j]).abs() / *bar
                } else {
                    0.0
                });
            }
        }
    }
    let part = (per_difference * part).max(least);
    bars.map(|row| row.map(|size| part * size))
}
