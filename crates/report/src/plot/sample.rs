//! Values of a field on lines across the liner.

use std::f64::consts::TAU;

use oilwedge_study::fields::{Interpolation, field};

use super::film::DrawnFilm;
use super::liner::Nodes;

/// Columns along the circumference in which triangles are looked up.
const COLUMNS: usize = 256;
/// How far outside of a triangle a point may be that belongs to it [1].
const SLACK: f64 = 1e-6;

/// Finds the triangle of a point.
pub(super) struct Finder<'a> {
    film: &'a DrawnFilm,
    columns: Vec<Vec<u32>>,
}

impl<'a> Finder<'a> {
    pub(super) fn new(film: &'a DrawnFilm) -> Self {
        let mut columns = vec![Vec::new(); COLUMNS];
        let period = TAU * film.radius;
        for (cell, nodes) in (0..).zip(&film.cells) {
            let low = nodes.iter().map(|node| node[0]).fold(f64::INFINITY, f64::min);
            let high = nodes.iter().map(|node| node[0]).fold(f64::NEG_INFINITY, f64::max);
            let column = |x: f64| (x / period * COLUMNS as f64).floor() as i64;
            for k in column(low)..=column(high) {
                columns[k.rem_euclid(COLUMNS as i64) as usize].push(cell);
            }
        }
        Self { film, columns }
    }

    /// The triangle of a point [m] and its coordinates there.
    fn find(&self, [x, z]: [f64; 2]) -> Option<(usize, [f64; 3])> {
        let period = TAU * self.film.radius;
        let column = ((x / period).rem_euclid(1.0) * COLUMNS as f64) as usize;
        let candidates = self.columns.get(column.min(COLUMNS - 1))?;
        candidates.iter().find_map(|&cell| {
            let nodes = &self.film.cells[cell as usize];
            let beside = x - period * ((x - nodes[0][0]) / period).round();
            let parts = coordinates(nodes, [beside, z]);
            parts
                .iter()
                .all(|part| *part >= -SLACK)
                .then_some((cell as usize, parts))
        })
    }

    /// Values of a field at points [m]; NaN where there is no film.
    pub(super) fn values(&self, name: &str, points: &[[f64; 2]]) -> Option<Vec<f64>> {
        let values = self.film.values(name)?;
        let is_linear = field(name).is_some_and(|row| row.interpolation == Interpolation::Linear);
        let value = |(cell, parts): (usize, [f64; 3])| match is_linear {
            true => on_parts(&values[cell], parts),
            false => shapes(parts)
                .iter()
                .zip(values[cell])
                .map(|(shape, value)| shape * value)
                .sum(),
        };
        Some(
            points
                .iter()
                .map(|point| self.find(*point).map_or(f64::NAN, value))
                .collect(),
        )
    }
}

fn shapes([a, b, c]: [f64; 3]) -> [f64; 6] {
    [
        a * (2.0 * a - 1.0),
        b * (2.0 * b - 1.0),
        c * (2.0 * c - 1.0),
        4.0 * a * b,
        4.0 * b * c,
        4.0 * c * a,
    ]
}

/// Linear on the four parts of a triangle.
fn on_parts(values: &[f64; 6], parts: [f64; 3]) -> f64 {
    let corner = (0..3).find(|k| parts[*k] >= 0.5);
    let (weights, nodes) = match corner {
        Some(k) => (
            [2.0 * parts[k] - 1.0, 2.0 * parts[(k + 1) % 3], 2.0 * parts[(k + 2) % 3]],
            [k, 3 + k, 3 + (k + 2) % 3],
        ),
        // The middle part: weights of the sides across from the corners.
        None => (parts.map(|part| 1.0 - 2.0 * part), [4, 5, 3]),
    };
    (0..3).map(|i| weights[i] * values[nodes[i]]).sum()
}

/// Coordinates of a point in a triangle with curved sides: those of its corners, corrected by two steps of Newton's method.
fn coordinates(nodes: &Nodes, point: [f64; 2]) -> [f64; 3] {
    let [a, b, c] = [nodes[0], nodes[1], nodes[2]];
    let (u, v) = ([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]);
    let determinant = u[0] * v[1] - u[1] * v[0];
    let (mut s, mut t) = (0.0, 0.0);
    for _ in 0..3 {
        let shapes = shapes([1.0 - s - t, s, t]);
        let at = [0, 1].map(|d| (0..6).map(|k| shapes[k] * nodes[k][d]).sum::<f64>());
        let off = [point[0] - at[0], point[1] - at[1]];
        s += (off[0] * v[1] - off[1] * v[0]) / determinant;
        t += (u[0] * off[1] - u[1] * off[0]) / determinant;
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
            assert!(
                (on_parts(&values, parts) - wanted).abs() < 1e-12,
                "{parts:?}: {}",
                on_parts(&values, parts)
            );
        }
    }

    #[test]
    fn coordinates_follow_curved_sides() {
        let nodes = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.5, -0.05], [0.5, 0.5], [0.0, 0.5]];
        let parts = [0.3, 0.5, 0.2];
        let at = [0, 1].map(|d| {
            shapes(parts)
                .iter()
                .zip(nodes)
                .map(|(shape, node)| shape * node[d])
                .sum::<f64>()
        });
        let found = coordinates(&nodes, at);
        assert!((0..3).all(|k| (found[k] - parts[k]).abs() < 5e-3), "{found:?}");
    }
}
