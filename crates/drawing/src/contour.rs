//! Filled contours of quadratic fields on triangles.
//!
//! Above each level the area is one path, painted over that of the level below, so no seam shows between bands. A
//! triangle is divided into small ones; the crossings of a level with their sides are the roots of the quadratic there,
//! not of its linear interpolation. Where two triangles meet, both take the values of their side in the same order, so
//! that their places agree to the last digit.

use std::collections::HashMap;

use crate::outline::{Edges, FinePlace, place};
use crate::patch::{PatchSide, sides};
use crate::{Figure, Levels, Patch, least_and_greatest};

/// Length of the sides of small triangles [mm], and how many there are along the side of a triangle.
const FINE: f64 = 0.6;
const DIVISIONS: [f64; 2] = [2.0, 8.0];

/// A quadratic along a line from its values at the start, in the middle and at the end.
fn along<const N: usize>(nodes: [[f64; N]; 3], s: f64) -> [f64; N] {
    let shapes = [(1.0 - s) * (1.0 - 2.0 * s), 4.0 * s * (1.0 - s), s * (2.0 * s - 1.0)];
    std::array::from_fn(|k| (0..3).map(|i| shapes[i] * nodes[i][k]).sum())
}

/// Where a quadratic with these values at the start, in the middle and at the end is zero between start and end, which
/// have different signs.
fn root([start, middle, end]: [f64; 3]) -> f64 {
    let (a, b) = (2.0 * start - 4.0 * middle + 2.0 * end, 4.0 * middle - 3.0 * start - end);
    let discriminant = (b * b - 4.0 * a * start).max(0.0).sqrt();
    let q = -0.5 * (b + b.signum() * discriminant);
    let candidates = [q / a, start / q];
    let linear = start / (start - end);
    let found = candidates.into_iter().find(|root| (0.0..=1.0).contains(root));
    found.unwrap_or(linear).clamp(0.0, 1.0)
}

/// A patch that runs against the clock, with what its sides share with their neighbours.
struct ContourPatch {
    patch: Patch,
    /// Whether each side runs from its lesser place to its greater.
    forwards: [bool; 3],
    /// Bounds of the values.
    bounds: [f64; 2],
    /// The patch beyond each side.
    beyond: [Option<usize>; 3],
}

impl ContourPatch {
    /// Values and places at the nodes of a side in the order that both its triangles take.
    fn side(&self, side: usize) -> [[f64; 3]; 3] {
        let node = |k: usize| {
            let [x, y] = self.patch.points[k];
            [x, y, self.patch.values[k]]
        };
        let [from, to] = [side, (side + 1) % 3];
        match self.forwards[side] {
            true => [node(from), node(3 + side), node(to)],
            false => [node(to), node(3 + side), node(from)],
        }
    }

    /// Place and value at coordinates `i/n, j/n` of the triangle, as whole numbers.
    fn at(&self, [i, j]: [u32; 2], n: u32) -> [f64; 3] {
        let part = |k: u32| f64::from(k) / f64::from(n);
        let on = |side: usize, s: u32| along(self.side(side), part(if self.forwards[side] { s } else { n - s }));
        match (i, j) {
            (_, 0) => on(0, i),
            _ if i + j == n => on(1, j),
            (0, _) => on(2, n - j),
            _ => {
                let (b, c) = (part(i), part(j));
                let a = 1.0 - b - c;
                let shapes = [
                    a * (2.0 * a - 1.0),
                    b * (2.0 * b - 1.0),
                    c * (2.0 * c - 1.0),
                    4.0 * a * b,
                    4.0 * b * c,
                    4.0 * c * a,
                ];
                let sum = |of: &dyn Fn(usize) -> f64| (0..6).map(|k| shapes[k] * of(k)).sum();
                let Patch { points, values } = &self.patch;
                [sum(&|k| points[k][0]), sum(&|k| points[k][1]), sum(&|k| values[k])]
            }
        }
    }

    /// Where the level crosses the line between two points of the grid of `n` divisions.
    fn crossing(&self, ends: [[u32; 2]; 2], n: u32, level: f64) -> FinePlace {
        let [from, to] = ends.map(|[i, j]| [2 * i, 2 * j]);
        let middle = [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2];
        let mut nodes = [from, middle, to].map(|at| self.at(at, 2 * n));
        // In the same order from both sides.
        if place([nodes[0][0], nodes[0][1]]) > place([nodes[2][0], nodes[2][1]]) {
            nodes.reverse();
        }
        let [x, y, _] = along(nodes, root(nodes.map(|node| node[2] - level)));
        place([x, y])
    }

    /// Adds the edges of what is above the level.
    fn add_above(&self, level: f64, n: u32, edges: &mut Edges) {
        let node = |at: [u32; 2]| {
            let [x, y, value] = self.at(at, n);
            (at, place([x, y]), value >= level)
        };
        let grid: Vec<Vec<_>> = (0..=n).map(|i| (0..=n - i).map(|j| node([i, j])).collect()).collect();
        let mut add = |corners: [[u32; 2]; 3]| {
            let corners = corners.map(|[i, j]| grid[i as usize][j as usize]);
            let mut polygon = Vec::with_capacity(4);
            for k in 0..3 {
                let ((at, place, is_above), (next, _, is_next_above)) = (corners[k], corners[(k + 1) % 3]);
                if is_above {
                    polygon.push(place);
                }
                if is_above != is_next_above {
                    polygon.push(self.crossing([at, next], n, level));
                }
            }
            edges.add_polygon(&polygon);
        };
        for i in 0..n {
            for j in 0..n - i {
                add([[i, j], [i + 1, j], [i, j + 1]]);
                if i + j + 2 <= n {
                    add([[i + 1, j], [i + 1, j + 1], [i, j + 1]]);
                }
            }
        }
    }

    /// Adds a whole side.
    fn add_side(&self, side: usize, n: u32, edges: &mut Edges) {
        let nodes = self.side(side);
        let point = |k: u32| {
            let [x, y, _] = along(nodes, f64::from(k) / f64::from(n));
            place([x, y])
        };
        for k in 0..n {
            match self.forwards[side] {
                true => edges.add(point(k), point(k + 1)),
                false => edges.add(point(n - k), point(n - k - 1)),
            }
        }
    }
}

fn cells(patches: &[Patch]) -> Vec<ContourPatch> {
    let mut of_side: HashMap<PatchSide, [Option<usize>; 2]> = HashMap::new();
    let mut cells = Vec::with_capacity(patches.len());
    for patch in patches {
        let [a, b, c] = [0, 1, 2].map(|k| patch.points[k]);
        let turns = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        let order = if turns < 0.0 { [0, 2, 1, 5, 4, 3] } else { [0, 1, 2, 3, 4, 5] };
        let patch = Patch { points: order.map(|k| patch.points[k]), values: order.map(|k| patch.values[k]) };
        let sides = sides(&patch);
        for (side, _) in sides {
            let places = of_side.entry(side).or_default();
            let free = places.iter_mut().find(|place| place.is_none());
            if let Some(free) = free {
                *free = Some(cells.len());
            }
        }
        // Values of Bezier's triangle enclose those of the quadratic.
        let v = patch.values;
        let controls = (0..3).map(|k| 2.0 * v[3 + k] - 0.5 * (v[k] + v[(k + 1) % 3]));
        let bounds = least_and_greatest(v[..3].iter().copied().chain(controls));
        cells.push(ContourPatch {
            patch,
            forwards: sides.map(|(_, is_forwards)| is_forwards),
            bounds,
            beyond: [None; 3],
        });
    }
    for k in 0..cells.len() {
        let sides = sides(&cells[k].patch);
        cells[k].beyond = sides.map(|(side, _)| of_side[&side].into_iter().flatten().find(|other| *other != k));
    }
    cells
}

/// Divisions of a side, so that the longest has small parts.
fn divisions(cells: &[ContourPatch]) -> u32 {
    let length = |cell: &ContourPatch, k: usize| {
        let (a, b) = (cell.patch.points[k], cell.patch.points[(k + 1) % 3]);
        (b[0] - a[0]).hypot(b[1] - a[1])
    };
    let longest = cells.iter().flat_map(|cell| (0..3).map(|k| length(cell, k))).fold(0.0, f64::max);
    (longest / FINE).ceil().clamp(DIVISIONS[0], DIVISIONS[1]) as u32
}

/// Outlines of where the field is at or above the level.
fn above(cells: &[ContourPatch], level: f64, n: u32) -> Vec<Vec<[f64; 2]>> {
    let is_above = |cell: &ContourPatch| cell.bounds[0] >= level;
    let mut edges = Edges::default();
    for cell in cells {
        if is_above(cell) {
            for side in 0..3 {
                let joins = cell.beyond[side].is_some_and(|other| is_above(&cells[other]));
                if !joins {
                    cell.add_side(side, n, &mut edges);
                }
            }
        } else if cell.bounds[1] >= level {
            cell.add_above(level, n, &mut edges);
        }
    }
    edges.into_outlines()
}

/// Paints bands of colours between levels of a field.
pub fn draw_bands(figure: &mut Figure, patches: &[Patch], levels: &Levels) {
    let cells = cells(patches);
    let n = divisions(&cells);
    let bands = [f64::NEG_INFINITY].into_iter().chain(levels.edges.iter().copied());
    for (level, colour) in bands.zip(&levels.colours) {
        figure.area(above(&cells, level, n), *colour);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ColourMap;
    use crate::patch::grid;

    fn area(outlines: &[Vec<[f64; 2]>]) -> f64 {
        let of = |line: &Vec<[f64; 2]>| {
            let next = line.iter().cycle().skip(1);
            0.5 * line.iter().zip(next).map(|(a, b)| a[0] * b[1] - a[1] * b[0]).sum::<f64>()
        };
        outlines.iter().map(of).sum()
    }

    #[test]
    fn a_circle_of_a_quadratic_is_round_on_coarse_triangles() {
        // Linear interpolation on these triangles would be off by some percent.
        let square = |[x, y]: [f64; 2]| 100.0 - (x - 10.0).powi(2) - (y - 10.0).powi(2);
        let patches = grid(3, 20.0, square);
        let cells = cells(&patches);
        for radius in [2.0f64, 5.0, 9.5] {
            let outlines = above(&cells, 100.0 - radius.powi(2), divisions(&cells));
            assert_eq!(outlines.len(), 1, "radius {radius}");
            let exact = std::f64::consts::PI * radius.powi(2);
            assert!((area(&outlines) / exact - 1.0).abs() < 0.012, "{radius}: {}", area(&outlines) / exact);
            for point in &outlines[0] {
                let off = (point[0] - 10.0).hypot(point[1] - 10.0) - radius;
                assert!(off.abs() < 2e-3, "{radius}: {off}");
            }
        }
    }

    #[test]
    fn whole_and_empty_levels_and_steps_between_triangles() {
        let patches = grid(4, 10.0, |[x, _]| x);
        let cells_of = cells(&patches);
        assert!((area(&above(&cells_of, -1.0, 2)) - 100.0).abs() < 1e-9);
        assert!(above(&cells_of, 10.5, 2).is_empty());
        assert!((area(&above(&cells_of, 3.3, 4)) - 67.0).abs() < 0.2);
        // Constant on each triangle: a quarter of the square is above.
        let mut steps = grid(2, 10.0, |_| 0.0);
        steps[0].values = [1.0; 6];
        steps[1].values = [1.0; 6];
        let outlines = above(&cells(&steps), 0.5, 2);
        assert!((area(&outlines) - 25.0).abs() < 1e-9 && outlines.len() == 1);
    }

    #[test]
    fn bands_are_one_path_each_and_small() {
        let patches = grid(40, 80.0, |[x, y]| (x / 9.0).sin() * (y / 13.0).cos());
        let levels = Levels::round([-1.0, 1.0], ColourMap::Vik, 20.0);
        assert_eq!(levels.colours.len(), levels.edges.len() + 1);
        assert!(levels.edges.iter().all(|edge| edge.abs() > 0.05));
        let mut figure = Figure::new([80.0, 80.0], "t", "d");
        draw_bands(&mut figure, &patches, &levels);
        let svg = figure.to_svg();
        assert_eq!(svg.matches("<path").count(), levels.colours.len());
        assert!(svg.len() < 60_000, "{}", svg.len());
        assert!(svg.contains("#ffffff") && figure.to_png().is_ok());
    }
}
