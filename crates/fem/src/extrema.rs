//! Candidates for the place at which the polynomial of one triangle is greatest.
//!
//! A polynomial lies below its greatest Bernstein coefficient; where that does not decide, its stationary points do.
//! Those of a quadratic, and of a cubic along an edge, are roots in closed form. Inside a triangle a cubic is
//! climbed by Newton's method from the best point of a lattice.
//! Verified by the tests of `field`.

use crate::field::evaluate;
use crate::lagrange::{self, MOST_SHAPES};

/// Values at the nodes of a quadratic.
pub type Quadratic = [f64; 6];

/// A lower bound of the quadratic with these nodal values over its triangle.
pub fn lower_bound(nodal: &Quadratic) -> f64 {
    -quadratic_bound(&negative(nodal))
}

/// Reference point of the triangle at which the quadratic with these nodal values is least.
pub fn least_at(nodal: &Quadratic) -> [f64; 2] {
    let negative = negative(nodal);
    let nodes = lagrange::nodes(2).into_iter();
    let (mut best, mut place) = (f64::NEG_INFINITY, [0.0; 2]);
    for point in nodes.chain(quadratic_candidates(&negative)) {
        let value = evaluate(2, &negative, point);
        if value > best {
            (best, place) = (value, point);
        }
    }
    place
}

fn negative(nodal: &Quadratic) -> [f64; MOST_SHAPES] {
    let mut negative = [0.0; MOST_SHAPES];
    (0..6).for_each(|k| negative[k] = -nodal[k]);
    negative
}

/// Most steps of Newton's method.
const STEPS: usize = 8;
/// Intervals of the lattice along an edge.
const LATTICE: u32 = 6;

/// An upper bound of the polynomial with these nodal values over its triangle.
pub(crate) fn bound(degree: usize, nodal: &[f64; MOST_SHAPES]) -> f64 {
    match degree {
        1 => nodal[..3].iter().fold(f64::NEG_INFINITY, |greatest, &u| greatest.max(u)),
        2 => quadratic_bound(nodal),
        _ => cubic_bound(nodal),
    }
}

/// Places, besides the nodes, at which the polynomial may be greatest.
pub(crate) fn candidates(degree: usize, nodal: &[f64; MOST_SHAPES]) -> Vec<[f64; 2]> {
    match degree {
        1 => Vec::new(),
        2 => quadratic_candidates(nodal),
        _ => cubic_candidates(nodal),
    }
}

const CORNERS: [[f64; 2]; 3] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];

fn on_edge(k: usize, s: f64) -> [f64; 2] {
    let (from, to) = (CORNERS[k], CORNERS[(k + 1) % 3]);
    [from[0] + s * (to[0] - from[0]), from[1] + s * (to[1] - from[1])]
}

/// Bernstein coefficients inside an edge with these values at 0, 1/3, 2/3, 1.
fn edge_coefficients([a, first, second, b]: [f64; 4]) -> [f64; 2] {
    [(-5.0 * a + 18.0 * first - 9.0 * second + 2.0 * b) / 6.0, (2.0 * a - 9.0 * first + 18.0 * second - 5.0 * b) / 6.0]
}

fn edge_values(nodal: &[f64; MOST_SHAPES], k: usize) -> [f64; 4] {
    [nodal[k], nodal[3 + 2 * k], nodal[4 + 2 * k], nodal[(k + 1) % 3]]
}

fn cubic_bound(nodal: &[f64; MOST_SHAPES]) -> f64 {
    let edges = [0, 1, 2].map(|k| edge_coefficients(edge_values(nodal, k)));
    let corners: f64 = nodal[..3].iter().sum();
    let inside = (27.0 * nodal[9] - corners - 3.0 * edges.iter().flatten().sum::<f64>()) / 6.0;
    let greatest = edges.iter().flatten().fold(inside, |greatest, &b| greatest.max(b));
    nodal[..3].iter().fold(greatest, |greatest, &b| greatest.max(b))
}

fn cubic_candidates(nodal: &[f64; MOST_SHAPES]) -> Vec<[f64; 2]> {
    let mut candidates = Vec::with_capacity(7);
    for k in 0..3 {
        // Slope of the Bernstein form: d0 (1 - s)^2 + 2 d1 s (1 - s) + d2 s^2 = 0.
        let values = edge_values(nodal, k);
        let [b1, b2] = edge_coefficients(values);
        let [d0, d1, d2] = [b1 - values[0], b2 - b1, values[3] - b2];
        let (square, linear) = (d0 - 2.0 * d1 + d2, d1 - d0);
        let root = (linear * linear - square * d0).sqrt();
        for s in [(-linear + root) / square, (-linear - root) / square] {
            if s > 0.0 && s < 1.0 {
                candidates.push(on_edge(k, s));
            }
        }
    }
    candidates.extend(climbed(nodal));
    candidates
}

/// The stationary point of a cubic near the best point of a lattice, if it lies inside.
fn climbed(nodal: &[f64; MOST_SHAPES]) -> Option<[f64; 2]> {
    let step = 1.0 / f64::from(LATTICE);
    let lattice = (1..LATTICE).flat_map(|i| (1..LATTICE - i).map(move |j| [step * f64::from(i), step * f64::from(j)]));
    let mut point = lattice.max_by(|&a, &b| evaluate(3, nodal, a).total_cmp(&evaluate(3, nodal, b)))?;
    for _ in 0..STEPS {
        let slope = gradient(nodal, point);
        // The gradient of a cubic is quadratic: central differences give its slope exactly.
        let h = 0.125;
        let along = [0, 1].map(|d| {
            let shifted = |by: f64| {
                let mut at = point;
                at[d] += by;
                gradient(nodal, at)
            };
            let (plus, minus) = (shifted(h), shifted(-h));
            [0, 1].map(|k| (plus[k] - minus[k]) / (2.0 * h))
        });
        let determinant = along[0][0] * along[1][1] - along[0][1] * along[1][0];
        point[0] -= (slope[0] * along[1][1] - slope[1] * along[1][0]) / determinant;
        point[1] -= (slope[1] * along[0][0] - slope[0] * along[0][1]) / determinant;
    }
    (point[0] > 0.0 && point[1] > 0.0 && point[0] + point[1] < 1.0).then_some(point)
}

fn gradient(nodal: &[f64; MOST_SHAPES], point: [f64; 2]) -> [f64; 2] {
    let mut shapes = [[0.0; 2]; MOST_SHAPES];
    lagrange::gradients(3, point, &mut shapes);
    let mut gradient = [0.0; 2];
    for (value, shape) in nodal.iter().zip(&shapes) {
        gradient[0] += value * shape[0];
        gradient[1] += value * shape[1];
    }
    gradient
}

/// An upper bound of a quadratic over its triangle: the greatest Bernstein coefficient.
fn quadratic_bound(nodal: &[f64; MOST_SHAPES]) -> f64 {
    (0..3)
        .map(|k| nodal[k].max(2.0 * nodal[3 + k] - 0.5 * (nodal[k] + nodal[(k + 1) % 3])))
        .fold(f64::NEG_INFINITY, f64::max)
}

/// Where a quadratic may have its maximum besides the nodes: its stationary points on the edges
/// and inside the triangle.
fn quadratic_candidates(nodal: &[f64; MOST_SHAPES]) -> Vec<[f64; 2]> {
    let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    let mut candidates = Vec::with_capacity(4);
    for k in 0..3 {
        // On the edge u(s) = u_a + (4 u_m - 3 u_a - u_b) s + 2 (u_a + u_b - 2 u_m) s^2.
        let (a, b, m) = (nodal[k], nodal[(k + 1) % 3], nodal[3 + k]);
        let s = (4.0 * m - 3.0 * a - b) / (-4.0 * (a + b - 2.0 * m));
        if s > 0.0 && s < 1.0 {
            let (from, to) = (corners[k], corners[(k + 1) % 3]);
            candidates.push([from[0] + s * (to[0] - from[0]), from[1] + s * (to[1] - from[1])]);
        }
    }
    // Inside, grad u = g + H (xi, eta) = 0 with the constant Hessian H.
    let [u0, u1, u2, u01, u12, u20] = [nodal[0], nodal[1], nodal[2], nodal[3], nodal[4], nodal[5]];
    let g = [4.0 * u01 - 3.0 * u0 - u1, 4.0 * u20 - 3.0 * u0 - u2];
    let h = [4.0 * (u0 + u1 - 2.0 * u01), 4.0 * (u0 + u12 - u01 - u20), 4.0 * (u0 + u2 - 2.0 * u20)];
    let determinant = h[0] * h[2] - h[1] * h[1];
    let inside = [(-g[0] * h[2] + g[1] * h[1]) / determinant, (-g[1] * h[0] + g[0] * h[1]) / determinant];
    if inside[0] > 0.0 && inside[1] > 0.0 && inside[0] + inside[1] < 1.0 {
        candidates.push(inside);
    }
    candidates
}
