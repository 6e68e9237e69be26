//! Errors of stiffness and damping, as parts that are independent of each other: what a number is off by that follows
//! from all coefficients is the root of the sum of the squares of what each part changes it by.
//!
//! Where the edge of a cavity runs through triangles, each of them is a part, whose entries belong together; so is what
//! two films differ by. Elsewhere each entry is a part of its own: the difference of one entry may be small by chance,
//! so that the greatest difference of all entries, each over the geometric mean of the greatest entries of its row and
//! its column, counts for every one.

use oilwedge_bearing::Coefficients;
use oilwedge_bearing::dynamics::Square;

/// Errors of all coefficients.
#[derive(Debug, Clone, PartialEq)]
pub struct CoefficientErrors {
    parts: Vec<Coefficients>,
}

impl CoefficientErrors {
    /// What a `film` and another one differ by, each entry by itself: what `part` makes of the greatest difference over
    /// the sizes of entries [1].
    pub(super) fn entry_by_entry(film: &Coefficients, other: &Coefficients, part: impl Fn(f64) -> f64) -> Self {
        let differences = [(&film.stiffness, &other.stiffness), (&film.damping, &other.damping)]
            .map(|(of, other)| bars(of, part(greatest_difference(of, other))));
        Self { parts: single(differences, film.order) }
    }

    /// The errors with a part of the size of each entry of a `film`.
    pub(super) fn and_share(mut self, film: &Coefficients, share: f64) -> Self {
        if share > 0.0 {
            let bars = [&film.stiffness, &film.damping].map(|of| bars(of, share));
            self.parts.extend(single(bars, film.order));
        }
        self
    }

    /// The errors of these parts, each times a factor.
    pub(super) fn of_parts(parts: impl IntoIterator<Item = (f64, Coefficients)>) -> Self {
        let scaled = |(factor, part): (f64, Coefficients)| part.scaled(factor);
        Self { parts: parts.into_iter().map(scaled).collect() }
    }

    /// Half widths of the bars of what follows from the coefficients: `change` is what it changes by with each part,
    /// none where the part takes it away.
    pub fn bar(&self, change: impl Fn(&Coefficients) -> Option<f64>) -> Option<f64> {
        let squares = self.parts.iter().map(|part| Some(change(part)?.powi(2)));
        Some(squares.sum::<Option<f64>>()?.sqrt())
    }
}

/// Parts of one entry each.
fn single([stiffness, damping]: [Square; 2], order: usize) -> Vec<Coefficients> {
    let places = (0..order).flat_map(|row| (0..order).map(move |column| (row, column)));
    let part = |(row, column): (usize, usize)| {
        let mut parts = [Coefficients { order, ..Coefficients::default() }; 2];
        parts[0].stiffness[row][column] = stiffness[row][column];
        parts[1].damping[row][column] = damping[row][column];
        parts
    };
    places.flat_map(part).collect()
}

/// The geometric mean of the greatest entries of row and column; of a block that vanishes by symmetry only the size of
/// its neighbours is known.
fn size(of: &Square, i: usize, j: usize) -> f64 {
    let greatest = |entries: [f64; 2]| entries.into_iter().fold(0.0, |most: f64, entry| most.max(entry.abs()));
    // Offsets and slopes have units of their own.
    let (rows, columns) = (i - i % 2, j - j % 2);
    if rows != columns {
        return (size(of, i, i) * size(of, j, j)).sqrt();
    }
    let row = greatest([0, 1].map(|column| of[i][columns + column]));
    let column = greatest([0, 1].map(|row| of[rows + row][j]));
    (row * column).sqrt()
}

fn bars(of: &Square, part: f64) -> Square {
    [0, 1, 2, 3].map(|i| [0, 1, 2, 3].map(|j| part * size(of, i, j)))
}

/// The greatest difference of two matrices over the sizes of entries [1].
fn greatest_difference(of: &Square, other: &Square) -> f64 {
    let places = (0..4).flat_map(|i| (0..4).map(move |j| (i, j)));
    let parts = places.map(|(i, j)| match size(of, i, j) {
        size if size > 0.0 => (of[i][j] - other[i][j]).abs() / size,
        _ => 0.0,
    });
    parts.fold(0.0, f64::max)
}
