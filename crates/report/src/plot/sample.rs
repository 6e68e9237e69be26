//! Values of a field on lines across the liner.

use oilwedge_drawing::least_and_greatest;
use oilwedge_study::fields::{FieldRow, Interpolation};

use super::film::DrawnFilm;
use super::liner::TriangleNodes;

/// How far outside of a triangle a point may be that belongs to it [1].
const SLACK: f64 = 1e-6;
/// Triangles for each box of the grid in which they are looked up, and most boxes each way.
const IN_A_BOX: f64 = 2.0;
const MOST_BOXES: f64 = 1024.0;

/// Steps of Newton's method for coordinates, and the step after which they are exact.
const STEPS: usize = 6;
const EXACT: f64 = 1e-12;

/// A point in a triangle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct InTriangle {
    /// The triangle.
    pub(crate) cell: usize,
    /// Coordinates of the point in the triangle.
    parts: [f64; 3],
}

/// Finds the triangle of a point by boxes of equal size.
pub(crate) struct Finder<'a> {
    film: &'a DrawnFilm,
    /// Length of the circumference, lower end of the axis and its length [m].
    period: f64,
    low: f64,
    height: f64,
    /// Boxes around and along the axis.
    count: [usize; 2],
    boxes: Vec<Vec<u32>>,
    /// Least values of fields by name.
    floors: Vec<(&'a str, f64)>,
}

impl<'a> Finder<'a> {
    pub(crate) fn new(film: &'a DrawnFilm) -> Self {
        let period = film.circumference();
        let [low, high] = least_and_greatest(film.cells.iter().flatten().map(|node| node[1]));
        let height = (high - low).max(f64::MIN_POSITIVE);
        let side = (IN_A_BOX * period * height / film.cells.len().max(1) as f64).sqrt();
        let count = [period, height].map(|length| (length / side).ceil().clamp(1.0, MOST_BOXES) as usize);
        let mut finder = Self {
            film,
            period,
            low,
            height,
            count,
            boxes: vec![Vec::new(); count[0] * count[1]],
            floors: (film.field_names()).filter_map(|name| Some((name, film.floor(name)?))).collect(),
        };
        for (cell, nodes) in (0..).zip(&film.cells) {
            let around = least_and_greatest(nodes.iter().map(|node| node[0]));
            let along = least_and_greatest(nodes.iter().map(|node| node[1]));
            // Points may be a little outside.
            let [wide, tall] = [around, along].map(|[low, high]| SLACK * (high - low));
            for column in finder.column(around[0] - wide)..=finder.column(around[1] + wide) {
                for row in finder.row(along[0] - tall)..=finder.row(along[1] + tall) {
                    let place = finder.place(column, row);
                    finder.boxes[place].push(cell);
                }
            }
        }
        finder
    }

    fn column(&self, x: f64) -> i64 {
        (x / self.period * self.count[0] as f64).floor() as i64
    }

    fn row(&self, z: f64) -> usize {
        let row = (z - self.low) / self.height * self.count[1] as f64;
        (row.max(0.0) as usize).min(self.count[1] - 1)
    }

    fn place(&self, column: i64, row: usize) -> usize {
        column.rem_euclid(self.count[0] as i64) as usize * self.count[1] + row
    }

    /// The triangle of a point [m] and its coordinates there.
    pub(crate) fn find(&self, [x, z]: [f64; 2]) -> Option<InTriangle> {
        let candidates = &self.boxes[self.place(self.column(x), self.row(z))];
        candidates.iter().find_map(|&cell| {
            let nodes = &self.film.cells[cell as usize];
            let beside = x - self.period * ((x - nodes[0][0]) / self.period).round();
            let parts = coordinates(nodes, [beside, z]);
            let cell = cell as usize;
            (parts.iter().all(|part| *part >= -SLACK)).then_some(InTriangle { cell, parts })
        })
    }

    /// The value of a field in a triangle; `None` where the film has no such field.
    pub(crate) fn value(&self, row: &FieldRow, InTriangle { cell, parts }: InTriangle) -> Option<f64> {
        let values = self.film.values(row.name)?[cell];
        let value: f64 = match row.interpolation {
            Interpolation::Linear => on_parts(&values, parts),
            _ => shapes(parts).iter().zip(values).map(|(shape, value)| shape * value).sum(),
        };
        let floor = self.floors.iter().find(|(name, _)| *name == row.name);
        Some(floor.map_or(value, |(_, floor)| value.max(*floor)))
    }

    /// Values of a field at points [m]; NaN where there is no film; `None` where the film has no such field.
    pub(super) fn values(&self, row: &FieldRow, points: &[[f64; 2]]) -> Option<Vec<f64>> {
        self.film.values(row.name)?;
        let value = |point: &[f64; 2]| self.value(row, self.find(*point)?);
        Some(points.iter().map(|point| value(point).unwrap_or(f64::NAN)).collect())
    }
}

/// Values of a field at points of the unrolled liner [m], by the quadratic of the triangle at each, nowhere below what
/// the model allows; NaN where there is no film. `None` where the film has no such field.
pub fn sampled(film: &DrawnFilm, row: &FieldRow, points: &[[f64; 2]]) -> Option<Vec<f64>> {
    Finder::new(film).values(row, points)
}

fn shapes([a, b, c]: [f64; 3]) -> [f64; 6] {
    [a * (2.0 * a - 1.0), b * (2.0 * b - 1.0), c * (2.0 * c - 1.0), 4.0 * a * b, 4.0 * b * c, 4.0 * c * a]
}

/// Linear on the four parts of a triangle.
fn on_parts(values: &[f64; 6], parts: [f64; 3]) -> f64 {
    let corner = (0..3).find(|k| parts[*k] >= 0.5);
    let (weights, nodes) = match corner {
        Some(k) => {
            ([2.0 * parts[k] - 1.0, 2.0 * parts[(k + 1) % 3], 2.0 * parts[(k + 2) % 3]], [k, 3 + k, 3 + (k + 2) % 3])
        }
        // The middle part: weights of the sides across from the corners.
        None => (parts.map(|part| 1.0 - 2.0 * part), [4, 5, 3]),
    };
    (0..3).map(|i| weights[i] * values[nodes[i]]).sum()
}

/// Coordinates of a point in a triangle with curved sides, by Newton's method; a straight one takes one step.
fn coordinates(nodes: &TriangleNodes, point: [f64; 2]) -> [f64; 3] {
    let (mut s, mut t) = (0.0, 0.0);
    for _ in 0..STEPS {
        let a = 1.0 - s - t;
        let sum = |shapes: [f64; 6]| [0, 1].map(|d| (0..6).map(|k| shapes[k] * nodes[k][d]).sum::<f64>());
        let at = sum(shapes([a, s, t]));
        let u = sum([1.0 - 4.0 * a, 4.0 * s - 1.0, 0.0, 4.0 * (a - s), 4.0 * t, -4.0 * t]);
        let v = sum([1.0 - 4.0 * a, 0.0, 4.0 * t - 1.0, -4.0 * s, 4.0 * s, 4.0 * (a - t)]);
        let off = [point[0] - at[0], point[1] - at[1]];
        let determinant = u[0] * v[1] - u[1] * v[0];
        let step = [(off[0] * v[1] - off[1] * v[0]) / determinant, (u[0] * off[1] - u[1] * off[0]) / determinant];
        s += step[0];
        t += step[1];
        if step[0].abs().max(step[1].abs()) < EXACT {
            break;
        }
    }
    [1.0 - s - t, s, t]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn linear_parts_meet_their_nodes() {
        let values = [1.0, 2.0, 3.0, 10.0, 20.0, 30.0];
        let nodes = [
            ([1.0, 0.0, 0.0], 1.0),
            ([0.0, 1.0, 0.0], 2.0),
            ([0.5, 0.5, 0.0], 10.0),
            ([0.0, 0.5, 0.5], 20.0),
            ([0.5, 0.0, 0.5], 30.0),
            ([1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0], 20.0),
            ([0.75, 0.25, 0.0], 5.5),
        ];
        for (parts, wanted) in nodes {
            assert!((on_parts(&values, parts) - wanted).abs() < 1e-12, "{parts:?}: {}", on_parts(&values, parts));
        }
    }

    #[test]
    fn coordinates_follow_curved_sides() {
        let nodes = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.5, -0.05], [0.5, 0.5], [0.0, 0.5]];
        let parts = [0.3, 0.5, 0.2];
        let at = [0, 1].map(|d| shapes(parts).iter().zip(nodes).map(|(shape, node)| shape * node[d]).sum::<f64>());
        let found = coordinates(&nodes, at);
        assert!((0..3).all(|k| (found[k] - parts[k]).abs() < 1e-12), "{found:?}");
    }
}
