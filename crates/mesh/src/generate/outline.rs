//! The outlines of a liner cut into edges: ends, seam or edges of the arc, features.

use std::collections::HashMap;

use super::rows::RowGrid;
use super::shape::{Feature, OutlinePiece};
use super::sheet::{LinerRectangle, on_sheet};
use super::size::SizeField;
use super::union::{OutlinePart, parts};
use crate::Circle;

/// An arc has at least this many edges a turn.
const EDGES_A_TURN: f64 = 16.0;
/// Points nearer than this part of the circumference are one.
const SAME: f64 = 1e-10;

/// A point on an edge of the sheet, moved in: its distance from the middle times this.
const INSIDE: f64 = 1.0 - 1e-6;

/// Points and edges that the triangulation must have.
#[derive(Debug, Default)]
pub(super) struct Outline {
    /// Points `(x, z)` [m].
    pub(super) points: Vec<[f64; 2]>,
    /// Edges between them.
    pub(super) edges: Vec<Edge>,
    /// The first point on the rim of a feature that is not a line of the grid.
    pub(super) first_on_rim: usize,
    /// Points of the left and the right side of the seam of a ring, in pairs.
    pub(super) seam: Vec<[u32; 2]>,
}

/// One edge of an outline.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Edge {
    pub(super) ends: [u32; 2],
    /// Name of the curve region that it belongs to.
    pub(super) group: Option<String>,
    /// The circle that it lies on.
    pub(super) circle: Option<Circle>,
}

/// Collects points, those at one place only once.
struct Collector {
    outline: Outline,
    cell: f64,
    known: HashMap<(i64, i64), u32>,
}

impl Collector {
    fn point(&mut self, point: [f64; 2]) -> u32 {
        let key = point.map(|x| (x / self.cell).round() as i64);
        for dx in -1..=1 {
            for dz in -1..=1 {
                if let Some(&known) = self.known.get(&(key[0] + dx, key[1] + dz)) {
                    return known;
                }
            }
        }
        let number = self.outline.points.len() as u32;
        self.outline.points.push(point);
        self.known.insert((key[0], key[1]), number);
        number
    }

    fn chain(&mut self, points: &[[f64; 2]], group: Option<&str>, circle: Option<Circle>) {
        let numbers: Vec<u32> = points.iter().map(|&point| self.point(point)).collect();
        for pair in numbers.windows(2) {
            if pair[0] != pair[1] {
                let group = group.map(str::to_owned);
                self.outline.edges.push(Edge { ends: [pair[0], pair[1]], group, circle });
            }
        }
    }
}

/// Edge lengths along outlines.
pub(super) struct Cutting<'a> {
    pub(super) size: &'a SizeField<'a>,
    /// The grid whose rows and columns end at the outlines, if there is one.
    pub(super) grid: Option<&'a RowGrid>,
}

impl Cutting<'_> {
    /// Points along a line around the bearing.
    fn around(&self, line: &OutlinePiece) -> Vec<[f64; 2]> {
        let places = self.grid.map(|grid| grid.on_line(0, line.at(0.0)[1]));
        self.line(line, 0, places)
    }

    /// Points along a line from end to end.
    fn axial(&self, line: &OutlinePiece) -> Vec<[f64; 2]> {
        let places = self.grid.map(|grid| grid.on_line(1, line.at(0.0)[0]));
        self.line(line, 1, places)
    }

    /// Points along a line: of the wanted distance, or the nodes of the grid.
    fn line(&self, line: &OutlinePiece, axis: usize, places: Option<Vec<f64>>) -> Vec<[f64; 2]> {
        let Some(places) = places else {
            return cut(line, &|point| self.size.at(point));
        };
        let (from, to) = (line.at(0.0), line.at(1.0));
        let room = |point: [f64; 2]| 0.3 * self.size.at(point);
        let on_line = |place: f64| {
            let mut point = from;
            point[axis] = place;
            point
        };
        let inside = (places.into_iter().map(on_line))
            .filter(|&point| point[axis] - from[axis] > room(point) && to[axis] - point[axis] > room(point));
        [from].into_iter().chain(inside).chain([to]).collect()
    }
}

/// Cuts all outlines into edges of the wanted size.
pub(super) fn outline(sheet: &LinerRectangle, features: &[Feature], cutting: &Cutting) -> Outline {
    let mut collector = Collector {
        outline: Outline::default(),
        cell: SAME * sheet.width.max(sheet.length) * 10.0,
        known: HashMap::new(),
    };
    let pieces = parts(sheet, features);
    sides(&mut collector, sheet, features, &pieces, cutting);
    for (z, group) in [(-0.5 * sheet.length, "end_low"), (0.5 * sheet.length, "end_high")] {
        for line in free(sheet, features, &pieces, [[sheet.start, z], [sheet.end(), z]]) {
            collector.chain(&cutting.around(&line), Some(group), None);
        }
    }
    // Lines all around are lines of a grid; rims come last.
    let (all_around, rims): (Vec<_>, Vec<_>) =
        (pieces.iter()).partition(|(index, _)| features[*index].shape.is_full_turn() && cutting.grid.is_some());
    for (index, piece) in &all_around {
        let feature = &features[*index];
        let group = (!feature.meshed).then_some(feature.name.as_str());
        collector.chain(&cutting.around(piece), group, None);
    }
    collector.outline.first_on_rim = collector.outline.points.len();
    for (index, piece) in &rims {
        let feature = &features[*index];
        let circle = match piece {
            OutlinePiece::Arc(circle, ..) => Some(*circle),
            OutlinePiece::Line(..) => None,
        };
        let group = (!feature.meshed).then_some(feature.name.as_str());
        collector.chain(&cut(piece, &|point| cutting.size.at(point)), group, circle);
    }
    collector.outline
}

/// The two sides of the sheet: edges of an arc, or a seam with the same points on both sides.
fn sides(
    collector: &mut Collector,
    sheet: &LinerRectangle,
    features: &[Feature],
    pieces: &[OutlinePart],
    cutting: &Cutting,
) {
    let (low, high) = (-0.5 * sheet.length, 0.5 * sheet.length);
    if !sheet.ring {
        for (x, group) in [(sheet.start, "arc_from"), (sheet.end(), "arc_to")] {
            for line in free(sheet, features, pieces, [[x, low], [x, high]]) {
                collector.chain(&cutting.axial(&line), Some(group), None);
            }
        }
        return;
    }
    for line in free(sheet, features, pieces, [[sheet.start, low], [sheet.start, high]]) {
        let left = cutting.axial(&line);
        let right: Vec<[f64; 2]> = left.iter().map(|point| [sheet.end(), point[1]]).collect();
        collector.chain(&left, None, None);
        collector.chain(&right, None, None);
        for (l, r) in left.iter().zip(&right) {
            let twins = [collector.point(*l), collector.point(*r)];
            collector.outline.seam.push(twins);
        }
    }
    collector.outline.seam.sort_unstable();
    collector.outline.seam.dedup();
}

/// A side of the sheet along an axis, cut where outlines meet it, without what runs through a cut-out.
fn free(
    sheet: &LinerRectangle,
    features: &[Feature],
    pieces: &[OutlinePart],
    [from, to]: [[f64; 2]; 2],
) -> Vec<OutlinePiece> {
    let near = SAME * sheet.width;
    let axis = usize::from(from[0] == to[0]);
    let is_on = |point: &[f64; 2], line: f64| (point[1 - axis] - line).abs() < near;
    // Both sides of a seam are cut alike.
    let twin = if sheet.ring && axis == 1 { sheet.end() } else { from[1 - axis] };
    let mut places: Vec<f64> = (pieces.iter())
        .flat_map(|(_, piece)| [piece.at(0.0), piece.at(1.0)])
        .filter(|point| is_on(point, from[1 - axis]) || is_on(point, twin))
        .map(|point| point[axis])
        .chain([from[axis], to[axis]])
        .collect();
    places.sort_unstable_by(f64::total_cmp);
    places.dedup_by(|a, b| (*a - *b).abs() < near);
    let at = |place: f64| {
        let mut point = from;
        point[axis] = place;
        point
    };
    let removed = |[x, z]: [f64; 2]| {
        // Not on the edge itself, to which a groove may reach.
        let middle = sheet.start + 0.5 * sheet.width;
        let x = if sheet.ring { x } else { middle + (x - middle) * INSIDE };
        let point = [x, z * INSIDE];
        let holds = |feature: &Feature| !feature.meshed && feature.shape.distance(point, sheet.period()) < 0.0;
        features.iter().any(holds)
    };
    let between = places.windows(2).filter(|pair| !removed(at(0.5 * (pair[0] + pair[1]))));
    between.map(|pair| OutlinePiece::Line(at(pair[0]), at(pair[1]))).collect()
}

/// Points along a piece whose distances follow the wanted size, both ends included.
pub(super) fn cut(piece: &OutlinePiece, size: &dyn Fn([f64; 2]) -> f64) -> Vec<[f64; 2]> {
    let least = match piece {
        OutlinePiece::Line(..) => 1.0,
        OutlinePiece::Arc(_, from, to) => ((to - from) / (std::f64::consts::TAU / EDGES_A_TURN) - 1e-9).ceil().max(1.0),
    };
    let count = counted(piece, size);
    let samples = count.len() - 1;
    let edges = count[samples].round().max(least);
    let scale = count[samples] / edges;
    let mut sample = 0;
    let mut points = vec![piece.at(0.0)];
    for k in 1..edges as usize {
        let wanted = k as f64 * scale;
        while count[sample + 1] < wanted {
            sample += 1;
        }
        let inside = (wanted - count[sample]) / (count[sample + 1] - count[sample]);
        points.push(piece.at((sample as f64 + inside) / samples as f64));
    }
    points.push(piece.at(1.0));
    points
}

/// Edges of the wanted size up to each of a number of samples along a piece: the integral of ds / size.
fn counted(piece: &OutlinePiece, size: &dyn Fn([f64; 2]) -> f64) -> Vec<f64> {
    const MOST: usize = 1 << 20;
    let length = piece.length();
    let mut samples = 64usize;
    loop {
        let mut count = vec![0.0];
        for k in 0..samples {
            let s = (k as f64 + 0.5) / samples as f64;
            count.push(count[k] + length / samples as f64 / size(piece.at(s)));
        }
        let edges = count[samples].round();
        if edges * 8.0 <= samples as f64 || samples == MOST {
            return count;
        }
        samples = ((16.0 * edges) as usize).min(MOST);
    }
}

/// Edges along the rim of a feature.
pub(super) fn edges_along(sheet: &LinerRectangle, feature: &Feature, size: &SizeField) -> f64 {
    let pieces = on_sheet(sheet, feature);
    pieces.iter().filter_map(|piece| counted(piece, &|point| size.at(point)).last().copied()).sum()
}
