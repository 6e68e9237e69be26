//! Lines of rupture and reformation without the steps of the triangles.
//!
//! A set of nodes shows the edge of a cavity to within a triangle, so a line through its triangles runs in steps. The
//! line that is drawn is the smoothest one whose points stay in the box of their triangle about the points of the set.
//! **Equation.** With the points P_k of a line, their number k as parameter, and u_k what each is moved by, each
//! coordinate minimises
//! ```text
//! Sum w_k u_k^2 + lambda Sum (second difference of P + u)^2,      |u_k| <= s_k
//! ```
//! s_k is the extent of the triangle. The weight w_k grows until the bound holds. Ends on an end of the bearing slide
//! along it; ends on a rim stay. **Source.** Whittaker's smoothing (1923), with bounds by reweighting. **Range.**
//! Pictures; no quantity is measured on these lines. **Verified by** the tests below and `tests/tests/pictures.rs`.

use std::collections::HashMap;
use std::f64::consts::TAU;

/// A piece of a line on the unrolled liner `(R phi, z)` [m].
pub(crate) type LineSegment = [[f64; 2]; 2];

/// Ends that are closer than this part of the radius are one.
const CLOSE: f64 = 1e-9;
/// Weight of the second differences: waves shorter than some 26 pieces, `2 pi` times its fourth root, are steps of
/// triangles where the bound allows it.
const SMOOTH: f64 = 300.0;
/// Factor by which the weight of a point grows that is moved too far, and how often.
const HEAVIER: f64 = 4.0;
const ROUNDS: usize = 24;
/// Weight of a coordinate that stays.
const FIXED: f64 = 1e12;
/// Points by which a closed line goes on beyond both of its ends.
const OVERLAP: usize = 64;

/// A piece of the edge of a cavity.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct CavityPiece {
    /// Piece of the line on the unrolled liner [m].
    pub(crate) piece: LineSegment,
    /// Normal of the piece towards the cavity, as long as the piece.
    pub(crate) normal: [f64; 2],
    /// Extents of its triangle [m].
    pub(crate) extent: [f64; 2],
}

/// Numbers of the places where pieces meet.
pub(crate) fn place(point: [f64; 2], radius: f64) -> [i64; 2] {
    // The two sides of the seam of a ring are one.
    let turn = (point[0] / radius).rem_euclid(TAU);
    [turn * radius, point[1]].map(|part| (part / (CLOSE * radius)).round() as i64)
}

/// The pieces moved so that the lines which they form are smooth. `half_length` [m] is that of the bearing.
pub(crate) fn smoothed(mut pieces: Vec<CavityPiece>, radius: f64, half_length: f64) -> Vec<CavityPiece> {
    for chain in chains(&pieces, radius) {
        let moved = CavityPath::of(&chain, &pieces, half_length).moved();
        for (k, &(number, is_forward)) in chain.links.iter().enumerate() {
            let piece = &mut pieces[number];
            let ends = if is_forward { [k, k + 1] } else { [k + 1, k] };
            let before = piece.piece;
            for (end, at) in piece.piece.iter_mut().zip(ends) {
                (0..2).for_each(|d| end[d] += moved[at][d]);
            }
            piece.normal = normal(piece.piece, side(before, piece.normal));
        }
    }
    pieces
}

/// The side of a piece to which its normal points.
fn side([from, to]: LineSegment, normal: [f64; 2]) -> f64 {
    ((to[0] - from[0]) * normal[1] - (to[1] - from[1]) * normal[0]).signum()
}

fn normal([from, to]: LineSegment, side: f64) -> [f64; 2] {
    [side * (from[1] - to[1]), side * (to[0] - from[0])]
}

/// Pieces one behind the other.
struct Chain {
    /// The number of each, and whether it is passed from its first end to its second.
    links: Vec<(usize, bool)>,
    is_closed: bool,
}

/// The lines that pieces form: from end to end, or closed.
fn chains(pieces: &[CavityPiece], radius: f64) -> Vec<Chain> {
    let ends: Vec<[[i64; 2]; 2]> = (pieces.iter()).map(|it| it.piece.map(|point| place(point, radius))).collect();
    let mut at: HashMap<[i64; 2], Vec<usize>> = HashMap::new();
    for (k, ends) in ends.iter().enumerate() {
        ends.iter().for_each(|end| at.entry(*end).or_default().push(k));
    }
    let mut is_passed = vec![false; pieces.len()];
    let mut walk = |start: usize, is_forward: bool| {
        let mut chain = Vec::new();
        let mut next = Some((start, is_forward));
        while let Some((k, is_forward)) = next.filter(|(k, _)| !is_passed[*k]) {
            is_passed[k] = true;
            chain.push((k, is_forward));
            let end = ends[k][usize::from(is_forward)];
            next = match at[&end].as_slice() {
                &[a, b] => {
                    let other = if a == k { b } else { a };
                    Some((other, ends[other][0] == end))
                }
                _ => None,
            };
        }
        chain
    };
    let mut chains = Vec::new();
    for (k, own) in ends.iter().enumerate() {
        for is_forward in [true, false] {
            if at[&own[usize::from(!is_forward)]].len() != 2 {
                chains.push((walk(k, is_forward), false));
            }
        }
    }
    // What is left has two pieces at each point.
    (0..pieces.len()).for_each(|k| chains.push((walk(k, true), true)));
    let chains = chains.into_iter().filter(|(links, _)| !links.is_empty());
    chains.map(|(links, is_closed)| Chain { links, is_closed }).collect()
}

/// The points of a chain.
struct CavityPath {
    /// Continuous across the seam [m].
    points: Vec<[f64; 2]>,
    /// How far each may be moved [m]; zero where a coordinate stays.
    bounds: Vec<[f64; 2]>,
    is_closed: bool,
}

impl CavityPath {
    fn of(chain: &Chain, pieces: &[CavityPiece], half_length: f64) -> Self {
        let links = &chain.links;
        let directed = |&(k, is_forward): &(usize, bool)| {
            let [a, b] = pieces[k].piece;
            if is_forward { [a, b] } else { [b, a] }
        };
        let mut points = vec![directed(&links[0])[0]];
        let mut at = points[0];
        for link in links {
            let [from, to] = directed(link);
            at = [0, 1].map(|d| at[d] + to[d] - from[d]);
            points.push(at);
        }
        let last = links.len();
        let extent = |k: usize| pieces[links[k].0].extent;
        let bound = |k: usize| {
            let [before, after] = [extent(k.saturating_sub(1)), extent(k.min(last - 1))];
            [0, 1].map(|d| before[d].min(after[d]))
        };
        let mut bounds: Vec<[f64; 2]> = (0..=last).map(bound).collect();
        if !chain.is_closed {
            for k in [0, last] {
                let slides = (points[k][1].abs() - half_length).abs() < CLOSE * half_length;
                bounds[k] = [if slides { bounds[k][0] } else { 0.0 }, 0.0];
            }
        }
        Self { points, bounds, is_closed: chain.is_closed }
    }

    /// What each point is moved by [m].
    fn moved(&self) -> Vec<[f64; 2]> {
        let n = self.points.len();
        if n < 4 {
            return vec![[0.0; 2]; n];
        }
        let parts = [0, 1].map(|d| self.moved_along(d));
        (0..n).map(|k| [parts[0][k], parts[1][k]]).collect()
    }

    fn moved_along(&self, d: usize) -> Vec<f64> {
        let n = self.points.len();
        // A closed line is followed on beyond its ends, the last of which is its first point.
        let (beyond, around) = match self.is_closed {
            true => (OVERLAP as isize, n - 1),
            false => (0, n),
        };
        let rise = if self.is_closed { self.points[n - 1][d] - self.points[0][d] } else { 0.0 };
        let numbers = -beyond..n as isize + beyond;
        let index = |k: isize| k.rem_euclid(around as isize) as usize;
        let turn = |k: isize| k.div_euclid(around as isize) as f64;
        let places: Vec<f64> = (numbers.clone()).map(|k| self.points[index(k)][d] + rise * turn(k)).collect();
        let bounds: Vec<f64> = numbers.map(|k| self.bounds[index(k)][d]).collect();
        let mut weights: Vec<f64> = bounds.iter().map(|bound| if *bound > 0.0 { 1.0 } else { FIXED }).collect();
        let mut found = vec![0.0; places.len()];
        for _ in 0..ROUNDS {
            found = smoothest(&places, &weights);
            let mut is_bounded = true;
            for ((moved, bound), weight) in found.iter().zip(&bounds).zip(&mut weights) {
                if moved.abs() > *bound && *weight < FIXED {
                    *weight *= HEAVIER;
                    is_bounded = false;
                }
            }
            if is_bounded {
                break;
            }
        }
        let from = beyond as usize;
        let mut own: Vec<f64> = (from..from + n).map(|k| found[k].clamp(-bounds[k], bounds[k])).collect();
        if self.is_closed {
            own[n - 1] = own[0];
        }
        own
    }
}

/// What moves places by least squares with these weights and second differences times [`SMOOTH`]: a symmetric system
/// with five diagonals, by `L D L^T`.
fn smoothest(places: &[f64], weights: &[f64]) -> Vec<f64> {
    let n = places.len();
    // Diagonal and the two beside it, and the right side.
    let (mut diagonal, mut next, mut second) = (weights.to_vec(), vec![0.0; n], vec![0.0; n]);
    let mut right = vec![0.0; n];
    for k in 1..n - 1 {
        let bend = places[k - 1] - 2.0 * places[k] + places[k + 1];
        let parts = [1.0, -2.0, 1.0];
        for i in 0..3 {
            right[k - 1 + i] -= SMOOTH * parts[i] * bend;
            diagonal[k - 1 + i] += SMOOTH * parts[i] * parts[i];
        }
        next[k - 1] += SMOOTH * parts[0] * parts[1];
        next[k] += SMOOTH * parts[1] * parts[2];
        second[k - 1] += SMOOTH * parts[0] * parts[2];
    }
    // Columns of L below the diagonal stand where the two diagonals stood.
    for k in 0..n {
        let pivot = diagonal[k];
        if k + 1 < n {
            let below = next[k] / pivot;
            diagonal[k + 1] -= below * next[k];
            right[k + 1] -= below * right[k];
            if k + 2 < n {
                next[k + 1] -= below * second[k];
            }
            next[k] = below;
        }
        if k + 2 < n {
            let below = second[k] / pivot;
            diagonal[k + 2] -= below * second[k];
            right[k + 2] -= below * right[k];
            second[k] = below;
        }
    }
    for k in (0..n).rev() {
        right[k] /= diagonal[k];
        if k + 1 < n {
            right[k] -= next[k] * right[k + 1];
        }
        if k + 2 < n {
            right[k] -= second[k] * right[k + 2];
        }
    }
    right
}

#[cfg(test)]
mod tests {
    use super::*;

    const RADIUS: f64 = 0.05;
    const HALF: f64 = 0.02;

    /// The line x = f(z) by steps: upright pieces in rows `step` high, level ones between them, as a set of triangles
    /// has them.
    fn steps(count: u32, step: f64, f: impl Fn(f64) -> f64) -> Vec<CavityPiece> {
        let mut points = Vec::new();
        for k in 0..count {
            let [low, high] = [k, k + 1].map(|k| 2.0 * HALF * f64::from(k) / f64::from(count) - HALF);
            let x = (f(0.5 * (low + high)) / step).round() * step;
            points.extend([[x, low], [x, high]]);
        }
        points.dedup();
        let piece = |pair: &[[f64; 2]; 2]| CavityPiece {
            piece: *pair,
            normal: normal(*pair, -1.0),
            extent: [step, 2.0 * HALF / f64::from(count)],
        };
        let pieces = points.array_windows().map(piece);
        pieces.filter(|it| it.piece[0] != it.piece[1]).collect()
    }

    #[test]
    fn steps_become_a_line_within_a_triangle() {
        let front = |z: f64| 0.1 + 8.0 * z * z + 0.2 * z;
        let stepped = steps(40, 1e-3, front);
        let mut shuffled = stepped.clone();
        shuffled.reverse();
        shuffled.iter_mut().step_by(2).for_each(|it| it.piece.reverse());
        for pieces in [stepped, shuffled] {
            let line = smoothed(pieces.clone(), RADIUS, HALF);
            let off = |it: &CavityPiece| (it.piece[0][0] - front(it.piece[0][1])).abs();
            let worst = |pieces: &[CavityPiece]| pieces.iter().map(off).fold(0.0, f64::max);
            assert!(worst(&line) < 0.5e-3, "{:e}, before {:e}", worst(&line), worst(&pieces));
            for (before, after) in pieces.iter().zip(&line) {
                for (a, b) in before.piece.iter().zip(after.piece) {
                    assert!((a[0] - b[0]).abs() <= 1e-3 + 1e-12 && (a[1] - b[1]).abs() <= 1e-3 + 1e-12);
                }
                // It points to greater x wherever the line goes upwards.
                assert!(after.normal[0] > 0.0, "{after:?}");
            }
        }
    }

    #[test]
    fn ends_slide_along_the_bearing_and_stay_on_rims() {
        let pieces = steps(20, 2e-3, |z| 0.1 + z);
        let line = smoothed(pieces.clone(), RADIUS, HALF);
        let (first, last) = (line[0].piece[0], line[line.len() - 1].piece[1]);
        assert_eq!((first[1], last[1]), (-HALF, HALF));
        let inside = smoothed(pieces.clone(), RADIUS, 2.0 * HALF);
        assert_eq!(inside[0].piece[0], pieces[0].piece[0]);
    }

    #[test]
    fn closed_lines_stay_closed_and_keep_their_size() {
        // A circle of 8 mm by a grid of 1 mm.
        let is_in = |i: i32, j: i32| f64::from(i * i + j * j).sqrt() < 8.0;
        let mut pieces = Vec::new();
        for (i, j) in (-9..9).flat_map(|i| (-9..9).map(move |j| (i, j))) {
            for (di, dj) in [(1, 0), (0, 1)] {
                if is_in(i, j) != is_in(i + di, j + dj) {
                    let middle = [f64::from(2 * i + di), f64::from(2 * j + dj)].map(|x| 0.5e-3 * x);
                    let half = [f64::from(dj), f64::from(di)].map(|x| 0.5e-3 * x);
                    let piece =
                        [[middle[0] - half[0], middle[1] - half[1]], [middle[0] + half[0], middle[1] + half[1]]];
                    let normal = [f64::from(di), f64::from(dj)].map(|x| if is_in(i, j) { x } else { -x });
                    pieces.push(CavityPiece { piece, normal, extent: [1e-3; 2] });
                }
            }
        }
        let line = smoothed(pieces, RADIUS, HALF);
        for it in &line {
            let [a, b] = it.piece;
            let radius = a[0].hypot(a[1]);
            assert!((radius - 7.8e-3).abs() < 0.5e-3, "{radius}");
            assert!(line.iter().filter(|other| other.piece.contains(&b)).count() == 2);
            assert!(it.normal[0] * a[0] + it.normal[1] * a[1] > 0.0);
        }
    }
}
