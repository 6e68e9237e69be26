//! Rows along the flow: nodes on straight lines z = constant, from column to column.
//!
//! Oil that is carried through a cavity moves along these lines. A triangle with an edge on one carries it along that
//! edge alone, so that nothing spreads across the flow. Columns and rows bound the cells of a grid. Near features,
//! where smaller edges are wanted, cells are halved again and again, so that there are rows nearly up to the rims; only
//! between the last of them and a rim the triangles are free.

use std::collections::{BTreeSet, HashMap};

use super::outline::cut;
use super::shape::{Feature, OutlinePiece};
use super::sheet::LinerRectangle;
use super::size::Grading;
use super::triangulate::{FilledDomain, Triangles};

/// Stops that differ by less than this part of half of the length are one.
const SAME: f64 = 1e-9;
/// Cells between two stops, at least: what leaves a groove over a narrow land is resolved.
const FEWEST: f64 = 3.0;
/// The edge of a feature is a row of its own if no other row lies within this part of the spacing.
const OWN_ROW: f64 = 0.5;
/// Cells are halved while their edges are longer than those wanted by this factor.
const TOO_LONG: f64 = 1.4;
/// Nodes of the grid keep this part of the edge of a cell away from outlines.
const APART: f64 = 0.55;
/// A cell longer than this many times its width that has a node amid a long side is halved there: the triangle would be
/// obtuse.
const LONG: f64 = 1.8;
/// Cells are halved no more often than this in each direction.
const DEEPEST: u32 = 20;
/// Places between two columns or rows.
const UNITS: i64 = 1 << DEEPEST;

/// Edge lengths of a mesh in rows.
pub struct RowLengths<'a> {
    /// Distance [m] of the columns at x.
    pub along: &'a dyn Fn(f64) -> f64,
    /// Distance [m] of the rows at z.
    pub across: &'a dyn Fn(f64) -> f64,
    /// Sense of the flow along x: films of either sense are mirror images.
    pub sense: Sense,
    /// How cells shrink towards features.
    pub grading: Grading,
}

/// Sense of a flow along x.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sense {
    /// The flow goes towards greater x.
    Forwards,
    /// The flow goes towards lesser x.
    Backwards,
}

impl Sense {
    /// The sense of the flow that a surface moving along x at this speed, of any unit, drags along.
    pub fn of(speed: f64) -> Self {
        match speed < 0.0 {
            true => Self::Backwards,
            false => Self::Forwards,
        }
    }
}

impl RowLengths<'_> {
    /// The shorter edge of the grid [m] at a point.
    pub(super) fn size(&self, [x, z]: [f64; 2]) -> f64 {
        (self.along)(x).min((self.across)(z))
    }
}

/// Places of nodes: columns and rows times [`UNITS`].
type NodePlace = [i64; 2];

/// Columns and rows of a sheet, its edges among them, and the nodes of their cells and of what these are halved to.
#[derive(Debug)]
pub(super) struct RowGrid {
    columns: Vec<f64>,
    rows: Vec<f64>,
    nodes: BTreeSet<NodePlace>,
    sense: Sense,
}

impl RowGrid {
    /// The grid of a sheet; `wanted` is the edge length [m] that features want at a point.
    pub(super) fn new(
        sheet: &LinerRectangle,
        features: &[Feature],
        rows: &RowLengths,
        wanted: &dyn Fn([f64; 2]) -> f64,
    ) -> Self {
        let half = 0.5 * sheet.length;
        let mut grid = Self {
            columns: filled(&[sheet.start, sheet.end()], 0, rows.along),
            rows: filled(&stops(half, features, rows), 1, rows.across),
            nodes: BTreeSet::new(),
            sense: rows.sense,
        };
        let mut cells = grid.halved(wanted);
        while grid.halve_long_cells(&mut cells, sheet.ring) {}
        grid
    }

    /// Places along `axis` of the nodes whose other coordinate is `level` [m], ascending. The two sides of a ring have
    /// the same nodes.
    pub(super) fn on_line(&self, axis: usize, level: f64) -> Vec<f64> {
        let positions = self.nodes.iter().map(|&place| self.position(place));
        let mut places: Vec<f64> =
            positions.filter(|position| position[1 - axis] == level).map(|position| position[axis]).collect();
        places.sort_unstable_by(f64::total_cmp);
        places
    }

    /// The nodes inside the film of `domain`, which leave room for the outlines.
    pub(super) fn inner_nodes(&self, domain: &FilledDomain) -> Vec<[f64; 2]> {
        let last = [self.columns.len() - 1, self.rows.len() - 1].map(|last| last as i64 * UNITS);
        let inside = |place: &&NodePlace| (0..2).all(|k| place[k] > 0 && place[k] < last[k]);
        let positions = self.nodes.iter().filter(inside).map(|&place| self.position(place));
        positions.filter(|&point| domain.margin(point) > APART * domain.size.at(point)).collect()
    }

    /// Cuts neighbouring cells along the one and the other diagonal: which one a Delaunay triangulation takes is left
    /// to rounding. Faces of cells around the nodes lie straight across the flow then, and what crosses slanted ones
    /// does not add up along a row. Films of either sense are mirror images.
    pub(super) fn turn_diagonals(&self, filled: &mut Triangles) {
        let Triangles { points, triangles } = filled;
        let key = |point: [f64; 2]| point.map(f64::to_bits);
        let places: HashMap<[u64; 2], NodePlace> =
            (self.nodes.iter()).map(|&place| (key(self.position(place)), place)).collect();
        // An odd number of columns has no middle between two of them.
        let is_odd = self.columns.len().is_multiple_of(2);
        let first = i64::from(is_odd && self.sense == Sense::Backwards);
        let mut by_longest: HashMap<[u32; 2], (usize, usize)> = HashMap::new();
        for t in 0..triangles.len() {
            let Some(k) = right_angle(triangles[t].map(|v| points[v as usize])) else {
                continue;
            };
            let [corner, a, b] = [0, 1, 2].map(|i| triangles[t][(k + i) % 3]);
            let Some((other, m)) = by_longest.insert([a.min(b), a.max(b)], (t, k)) else {
                continue;
            };
            let opposite = triangles[other][m];
            let at = [corner, a, opposite, b].map(|v| places.get(&key(points[v as usize])));
            let [Some(p), Some(q), Some(r), Some(s)] = at else {
                continue;
            };
            let is_rectangle = (0..2).all(|d| p[d] + r[d] == q[d] + s[d]);
            if is_rectangle {
                let number = |d: usize| p[d].min(r[d]) / (p[d] - r[d]).abs();
                let rises = (number(0) + number(1) + first) % 2 == 0;
                if rises != ((s[0] - q[0]) * (s[1] - q[1]) > 0) {
                    triangles[t] = [corner, a, opposite];
                    triangles[other] = [opposite, b, corner];
                }
            }
        }
    }

    fn position(&self, place: NodePlace) -> [f64; 2] {
        let on = |places: &[f64], place: i64| {
            let (cell, part) = ((place / UNITS) as usize, (place % UNITS) as f64 / UNITS as f64);
            match places.get(cell + 1) {
                Some(next) if part > 0.0 => places[cell] + part * (next - places[cell]),
                _ => places[cell],
            }
        };
        [on(&self.columns, place[0]), on(&self.rows, place[1])]
    }

    /// Cells whose edges are as short as wanted; their corners become nodes.
    fn halved(&mut self, wanted: &dyn Fn([f64; 2]) -> f64) -> Vec<[NodePlace; 2]> {
        let mut cells: Vec<[NodePlace; 2]> = Vec::new();
        let mut tasks: Vec<[NodePlace; 2]> = Vec::new();
        for i in 0..self.columns.len() as i64 - 1 {
            for j in 0..self.rows.len() as i64 - 1 {
                tasks.push([[i * UNITS, j * UNITS], [(i + 1) * UNITS, (j + 1) * UNITS]]);
            }
        }
        while let Some(cell) = tasks.pop() {
            let corners = cell.map(|place| self.position(place));
            let wanted = wanted([0, 1].map(|k| 0.5 * (corners[0][k] + corners[1][k])));
            let is_long = |k: usize| cell[1][k] - cell[0][k] > 1 && corners[1][k] - corners[0][k] > TOO_LONG * wanted;
            match (is_long(0), is_long(1)) {
                (false, false) => {
                    self.nodes.extend(corners_of(cell));
                    cells.push(cell);
                }
                (along, across) => tasks.extend(halves(vec![cell], [along, across])),
            }
        }
        cells
    }

    /// Halves long cells with a node amid a long side, and makes the two sides of a ring alike. True if there were any.
    fn halve_long_cells(&mut self, cells: &mut Vec<[NodePlace; 2]>, is_ring: bool) -> bool {
        let before = self.nodes.len();
        let last = (self.columns.len() - 1) as i64 * UNITS;
        if is_ring {
            let on_sides: Vec<NodePlace> = (self.nodes.iter()).filter(|place| place[0] % last == 0).copied().collect();
            for [side, level] in on_sides {
                self.nodes.insert([last - side, level]);
            }
        }
        let mut whole = Vec::with_capacity(cells.len());
        for cell in std::mem::take(cells) {
            let corners = cell.map(|place| self.position(place));
            let edges = [0, 1].map(|k| corners[1][k] - corners[0][k]);
            let amid = |k: usize| {
                let middle = (cell[0][k] + cell[1][k]) / 2;
                let on = |side: i64| if k == 0 { [middle, side] } else { [side, middle] };
                let sides = [cell[0][1 - k], cell[1][1 - k]];
                edges[k] > LONG * edges[1 - k] && sides.iter().any(|&side| self.nodes.contains(&on(side)))
            };
            let split = [amid(0), amid(1)];
            match split {
                [false, false] => whole.push(cell),
                _ => {
                    let parts = halves(vec![cell], split);
                    self.nodes.extend(parts.iter().flat_map(|&part| corners_of(part)));
                    whole.extend(parts);
                }
            }
        }
        *cells = whole;
        self.nodes.len() > before
    }
}

/// The corner at which one side of a triangle lies along x and the other along z.
fn right_angle(corners: [[f64; 2]; 3]) -> Option<usize> {
    (0..3).find(|&k| {
        let (at, next, previous) = (corners[k], corners[(k + 1) % 3], corners[(k + 2) % 3]);
        (at[0] == next[0] && at[1] == previous[1]) || (at[1] == next[1] && at[0] == previous[0])
    })
}

fn corners_of([low, high]: [NodePlace; 2]) -> [NodePlace; 4] {
    [low, [high[0], low[1]], high, [low[0], high[1]]]
}

/// Cells halved along and across the flow, or not.
fn halves(cells: Vec<[NodePlace; 2]>, split: [bool; 2]) -> Vec<[NodePlace; 2]> {
    (0..2).filter(|&k| split[k]).fold(cells, |cells, k| {
        let halve = |[low, high]: [NodePlace; 2]| {
            let (mut middle_high, mut middle_low) = (high, low);
            let middle = (low[k] + high[k]) / 2;
            (middle_high[k], middle_low[k]) = (middle, middle);
            [[low, middle_high], [middle_low, high]]
        };
        cells.into_iter().flat_map(halve).collect()
    })
}

/// Rows that must be there: the ends and the edges of grooves along the flow.
fn stops(half: f64, features: &[Feature], rows: &RowLengths) -> Vec<f64> {
    let mut stops = vec![-half, half];
    let (all_around, others): (Vec<_>, Vec<_>) =
        (features.iter().filter(|feature| !feature.shape.is_disc())).partition(|feature| feature.shape.is_full_turn());
    let edges = |feature: &&Feature| {
        let (z, half) = (feature.shape.centre[1], feature.shape.half[1]);
        [z - half, z + half]
    };
    stops.extend(all_around.iter().flat_map(edges));
    // With a row amid the length both halves are cut alike.
    for z in others.iter().flat_map(edges).chain([0.0]) {
        let spacing = (rows.across)(z);
        if stops.iter().all(|stop| (stop - z).abs() > OWN_ROW * spacing) {
            stops.push(z);
        }
    }
    stops.sort_unstable_by(f64::total_cmp);
    // Bands that touch an end or each other have an edge in common.
    stops.dedup_by(|a, b| (*a - *b).abs() < SAME * half);
    stops
}

/// Places from stop to stop, as far apart as `spacing` says.
fn filled(stops: &[f64], axis: usize, spacing: &dyn Fn(f64) -> f64) -> Vec<f64> {
    let on_axis = |place: f64| match axis {
        0 => [place, 0.0],
        _ => [0.0, place],
    };
    let mut places = vec![stops[0]];
    for pair in stops.windows(2) {
        let piece = OutlinePiece::Line(on_axis(pair[0]), on_axis(pair[1]));
        let widest = (pair[1] - pair[0]) / FEWEST;
        let points = cut(&piece, &|point| spacing(point[axis]).min(widest));
        places.extend(points[1..].iter().map(|point| point[axis]));
    }
    places
}
