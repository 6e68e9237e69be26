//! Fills the outlines with triangles: Delaunay refinement by circumcentres, then smoothing.
//!
//! Outlines keep their edges (both sides of a seam must stay alike), so a circumcentre that comes
//! too near to one is left out. Rounds of insertion until no triangle is too large or too sharp;
//! then each inner point moves to the mean of the centroids around it, weighted so that the wanted
//! sizes stay, and all is triangulated again (Chew 1993; Du, Faber, Gunzburger 1999).

use spade::{ConstrainedDelaunayTriangulation, Point2, PositionInTriangulation, Triangulation};

use super::outline::Outline;
use super::shape::Feature;
use super::sheet::LinerRectangle;
use super::size::SizeField;
use crate::numbering::hilbert_order;
use crate::raw::doubled_area;

type Cdt = ConstrainedDelaunayTriangulation<Point2<f64>>;

/// Circumradius of an equilateral triangle over its edge.
const EQUILATERAL: f64 = 0.577_350_269_189_625_8;
/// Triangles whose circumradius exceeds that of the wanted one by this factor are too large.
const TOO_LARGE: f64 = 1.35;
/// Triangles with a smaller angle [deg] are too sharp.
const TOO_SHARP: f64 = 29.0;
/// New points keep this part of the wanted size away from outlines and from each other.
const APART: f64 = 0.55;
/// Triangles with a smaller angle [deg] are opened after smoothing.
const OPENED: f64 = 36.0;
/// Least angle [deg] that is good enough.
const GOOD: f64 = 32.0;
/// One bad triangle in so many is left to smoothing.
const FEW: usize = 1000;
/// Rounds of insertion, of smoothing, of opening.
const ROUNDS: usize = 40;
const SMOOTHINGS: usize = 3;
const OPENINGS: usize = 4;

/// Points and triangles of the sheet without its cut-outs.
pub(super) struct Triangles {
    pub(super) points: Vec<[f64; 2]>,
    pub(super) triangles: Vec<[u32; 3]>,
}

/// What is filled.
pub(super) struct FilledDomain<'a> {
    pub(super) sheet: LinerRectangle,
    pub(super) features: &'a [Feature],
    pub(super) size: &'a SizeField<'a>,
}

impl FilledDomain<'_> {
    /// Distance [m] from all outlines, negative outside of the film.
    pub(super) fn margin(&self, point: [f64; 2]) -> f64 {
        let mut margin = self.sheet.margin(point);
        if self.sheet.ring {
            // Not too near to the seam either: its points are fixed.
            margin = margin.min((point[0] - self.sheet.start).abs()).min((self.sheet.end() - point[0]).abs());
        }
        for (index, feature) in self.features.iter().enumerate() {
            let others = self.features[index + 1..].iter().filter(|other| other.name == feature.name);
            let distance = |feature: &Feature| feature.shape.distance(point, self.sheet.period());
            // Of a union once, with all its features.
            let is_first = self.features[..index].iter().all(|other| other.name != feature.name);
            let distance = others.map(distance).fold(distance(feature), f64::min);
            if is_first {
                margin = margin.min(if feature.meshed { distance.abs() } else { distance });
            }
        }
        margin
    }

    fn is_film(&self, point: [f64; 2]) -> bool {
        let removed = |feature: &Feature| !feature.meshed && feature.shape.distance(point, self.sheet.period()) < 0.0;
        !self.features.iter().any(removed)
    }
}

/// The points of a triangulation that belong to a grid.
#[derive(Debug, Clone, Copy)]
struct GridPoints {
    /// Points on rims; all other points before `end` are the grid's.
    rims: [usize; 2],
    /// The first point that may move.
    end: usize,
}

impl GridPoints {
    fn new(outline: &Outline, nodes: &[[f64; 2]]) -> Self {
        let end = outline.points.len() + nodes.len();
        let rims = match nodes.is_empty() {
            true => [0, end],
            false => [outline.first_on_rim, outline.points.len()],
        };
        Self { rims, end }
    }

    /// True of a triangle of the grid: it stays as it is.
    fn holds(&self, vertices: [u32; 3]) -> bool {
        let of_grid = |v: usize| v < self.end && !(self.rims[0]..self.rims[1]).contains(&v);
        vertices.iter().all(|&v| of_grid(v as usize))
    }
}

fn centroid(corners: [[f64; 2]; 3]) -> [f64; 2] {
    [0, 1].map(|d| (corners[0][d] + corners[1][d] + corners[2][d]) / 3.0)
}

/// Triangulates `domain` inside `outline` with the `nodes` of a grid, which stay; none if an outline crosses itself.
pub(super) fn triangulate(domain: &FilledDomain, outline: &Outline, nodes: &[[f64; 2]]) -> Option<Triangles> {
    let edges: Vec<[usize; 2]> = outline.edges.iter().map(|edge| edge.ends.map(|end| end as usize)).collect();
    let given: Vec<[f64; 2]> = outline.points.iter().chain(nodes).copied().collect();
    let grid = GridPoints::new(outline, nodes);
    let mut cdt = load(&given, &edges)?;
    for _ in 0..ROUNDS {
        let fresh = candidates(domain, &cdt, grid);
        // Smoothing mends the last few.
        if fresh.len() * FEW <= cdt.num_vertices() || insert(domain, &mut cdt, fresh) == 0 {
            break;
        }
    }
    let fixed = given.len();
    let mut points = positions(&cdt);
    for _ in 0..SMOOTHINGS {
        smooth(domain, &cdt, fixed, &mut points);
        cdt = load(&points, &edges)?;
    }
    let mut best = (least_angle(domain, &cdt, grid), cdt);
    for _ in 0..OPENINGS {
        if best.0 > GOOD {
            break;
        }
        open_angles(domain, &best.1, grid, &mut points);
        let opened = load(&points, &edges)?;
        let angle = least_angle(domain, &opened, grid);
        if angle <= best.0 {
            break;
        }
        best = (angle, opened);
    }
    Some(Triangles {
        points: positions(&best.1),
        triangles: film(domain, &best.1).map(|(numbers, _)| numbers).collect(),
    })
}

/// The constrained triangulation of points in their order; none if two coincide or edges cross.
fn load(points: &[[f64; 2]], edges: &[[usize; 2]]) -> Option<Cdt> {
    let vertices = points.iter().map(|p| Point2::new(p[0], p[1])).collect();
    let mut crossed = false;
    let cdt = Cdt::try_bulk_load_cdt(vertices, edges.to_vec(), |_| crossed = true).ok()?;
    (!crossed && cdt.num_vertices() == points.len()).then_some(cdt)
}

fn positions(cdt: &Cdt) -> Vec<[f64; 2]> {
    cdt.vertices().map(|v| [v.position().x, v.position().y]).collect()
}

/// Triangles of the film: their vertices and corners.
fn film<'a>(domain: &'a FilledDomain, cdt: &'a Cdt) -> impl Iterator<Item = ([u32; 3], [[f64; 2]; 3])> + 'a {
    cdt.inner_faces().filter_map(|face| {
        let vertices = face.vertices();
        let corners = vertices.map(|v| [v.position().x, v.position().y]);
        let centre = centroid(corners);
        domain.is_film(centre).then(|| (vertices.map(|v| v.fix().index() as u32), corners))
    })
}

/// Circumcentres of triangles that are too large or too sharp, in the order of the Hilbert curve.
fn candidates(domain: &FilledDomain, cdt: &Cdt, grid: GridPoints) -> Vec<[f64; 2]> {
    let cosine = TOO_SHARP.to_radians().cos();
    let mut centres = Vec::new();
    for (vertices, corners) in film(domain, cdt) {
        if grid.holds(vertices) {
            continue;
        }
        let (centre, radius) = circumcircle(corners);
        if domain.margin(centre) <= 0.0 {
            continue;
        }
        let wanted = domain.size.at(centre);
        let large = radius > TOO_LARGE * EQUILATERAL * wanted;
        let sharp = || greatest_cosine(corners) > cosine && shortest_edge(corners) > 0.5 * wanted;
        if large || sharp() {
            centres.push(centre);
        }
    }
    hilbert_order(&centres).into_iter().map(|k| centres[k as usize]).collect()
}

/// Inserts the points that keep their distance; returns how many.
fn insert(domain: &FilledDomain, cdt: &mut Cdt, points: Vec<[f64; 2]>) -> usize {
    let mut inserted = 0;
    let mut hint = None;
    for point in points {
        let apart = APART * domain.size.at(point);
        if domain.margin(point) < apart {
            continue;
        }
        let target = Point2::new(point[0], point[1]);
        let position = match hint {
            Some(hint) => cdt.locate_with_hint(target, hint),
            None => cdt.locate(target),
        };
        let PositionInTriangulation::OnFace(face) = position else {
            continue;
        };
        let vertices = cdt.face(face).vertices();
        let near = |p: Point2<f64>| (p.x - point[0]).hypot(p.y - point[1]) < apart;
        hint = Some(vertices[0].fix());
        if vertices.iter().any(|v| near(v.position())) {
            continue;
        }
        if let Ok(vertex) = cdt.insert_with_hint(target, vertices[0].fix()) {
            hint = Some(vertex);
            inserted += 1;
        }
    }
    inserted
}

/// Moves each inner point to the weighted mean of the centroids of its triangles.
fn smooth(domain: &FilledDomain, cdt: &Cdt, fixed: usize, points: &mut [[f64; 2]]) {
    let mut sums = vec![[0.0; 3]; points.len()];
    for (numbers, corners) in film(domain, cdt) {
        let centre = centroid(corners);
        // Density of a size field: triangles weigh by how many wanted ones they hold, once more by size.
        let weight = doubled_area(corners) / domain.size.at(centre).powi(3);
        for number in numbers {
            let sum = &mut sums[number as usize];
            *sum = [sum[0] + weight * centre[0], sum[1] + weight * centre[1], sum[2] + weight];
        }
    }
    for (point, sum) in points.iter_mut().zip(sums).skip(fixed) {
        let moved = [sum[0] / sum[2], sum[1] / sum[2]];
        if sum[2] > 0.0 && domain.margin(moved) > 0.0 {
            *point = moved;
        }
    }
}

/// Moves inner points of sharp triangles, one after the other, to where the least angle around them is greatest.
fn open_angles(domain: &FilledDomain, cdt: &Cdt, grid: GridPoints, points: &mut [[f64; 2]]) {
    let cosine = OPENED.to_radians().cos();
    let triangles: Vec<[u32; 3]> = film(domain, cdt).map(|(numbers, _)| numbers).collect();
    let around = VertexStars::new(&triangles, points.len());
    let corners = |triangle: [u32; 3], points: &[[f64; 2]]| triangle.map(|v| points[v as usize]);
    let mut sharp: Vec<u32> = (triangles.iter())
        .filter(|triangle| greatest_cosine(corners(**triangle, points)) > cosine)
        .flatten()
        .copied()
        .filter(|&v| v as usize >= grid.end)
        .collect();
    sharp.sort_unstable();
    sharp.dedup();
    for &vertex in sharp.iter().cycle().take(3 * sharp.len()) {
        let own = around.triangles(vertex);
        let worst = |points: &[[f64; 2]]| {
            let cosine = |&t: &u32| {
                let corners = corners(triangles[t as usize], points);
                if doubled_area(corners) > 0.0 { greatest_cosine(corners) } else { f64::INFINITY }
            };
            own.iter().map(cosine).fold(-1.0, f64::max)
        };
        let mut step = 0.25 * domain.size.at(points[vertex as usize]);
        let mut least = worst(points);
        for _ in 0..12 {
            let place = points[vertex as usize];
            let better = (0..8).find(|&k| {
                let (sin, cos) = (std::f64::consts::FRAC_PI_4 * f64::from(k)).sin_cos();
                points[vertex as usize] = [place[0] + step * cos, place[1] + step * sin];
                let tried = worst(points);
                let improved = tried < least;
                if improved {
                    least = tried;
                }
                improved
            });
            if better.is_none() {
                points[vertex as usize] = place;
                step *= 0.5;
            }
        }
    }
}

/// Triangles around each vertex.
struct VertexStars {
    start: Vec<u32>,
    list: Vec<u32>,
}

impl VertexStars {
    fn new(triangles: &[[u32; 3]], vertices: usize) -> Self {
        let mut start = vec![0u32; vertices + 1];
        for &v in triangles.iter().flatten() {
            start[v as usize + 1] += 1;
        }
        for v in 0..vertices {
            start[v + 1] += start[v];
        }
        let mut next = start.clone();
        let mut list = vec![0u32; 3 * triangles.len()];
        for (t, triangle) in (0u32..).zip(triangles) {
            for &v in triangle {
                list[next[v as usize] as usize] = t;
                next[v as usize] += 1;
            }
        }
        Self { start, list }
    }

    fn triangles(&self, vertex: u32) -> &[u32] {
        &self.list[self.start[vertex as usize] as usize..self.start[vertex as usize + 1] as usize]
    }
}

/// Least angle [deg] of the film's triangles, without those of the grid.
fn least_angle(domain: &FilledDomain, cdt: &Cdt, grid: GridPoints) -> f64 {
    let cosine = film(domain, cdt)
        .filter(|(vertices, _)| !grid.holds(*vertices))
        .map(|(_, corners)| greatest_cosine(corners))
        .fold(-1.0, f64::max);
    cosine.clamp(-1.0, 1.0).acos().to_degrees()
}

fn edge_squares(corners: [[f64; 2]; 3]) -> [f64; 3] {
    std::array::from_fn(|k| {
        let (a, b) = (corners[k], corners[(k + 1) % 3]);
        (b[0] - a[0]).powi(2) + (b[1] - a[1]).powi(2)
    })
}

fn shortest_edge(corners: [[f64; 2]; 3]) -> f64 {
    let [a, b, c] = edge_squares(corners);
    a.min(b).min(c).sqrt()
}

/// Cosine of the least angle, which faces the shortest edge.
fn greatest_cosine(corners: [[f64; 2]; 3]) -> f64 {
    let mut squares = edge_squares(corners);
    squares.sort_unstable_by(f64::total_cmp);
    let [a, b, c] = squares;
    (b + c - a) / (2.0 * (b * c).sqrt())
}

fn circumcircle([a, b, c]: [[f64; 2]; 3]) -> ([f64; 2], f64) {
    let (u, v) = ([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]);
    let (uu, vv) = (u[0] * u[0] + u[1] * u[1], v[0] * v[0] + v[1] * v[1]);
    let doubled = 2.0 * (u[0] * v[1] - u[1] * v[0]);
    let offset = [(v[1] * uu - u[1] * vv) / doubled, (u[0] * vv - v[0] * uu) / doubled];
    ([a[0] + offset[0], a[1] + offset[1]], offset[0].hypot(offset[1]))
}
