//! Lagrange shape functions of degree 1, 2 and 3 on the reference triangle.
//!
//! ```text
//!   P1         P2         P3
//!   2          2          2
//!   |\         |\         |\
//!   | \        5 4        7 6        corners; edges 01, 12, 20, along the edge;
//!   |  \       |  \       8 9 5      interior
//!   0---1      0-3-1      0-3-4-1
//! ```
//! With the barycentric coordinates `l_0 = 1 - xi - eta`, `l_1 = xi`, `l_2 = eta`.
//! Verified by `values_are_one_at_their_node` and `gradients_match_differences`.

/// Most shape functions of an element here (P3).
pub const MOST_SHAPES: usize = 10;

/// Gradients of `l_0, l_1, l_2` in `(xi, eta)`.
pub const BARYCENTRIC_GRADIENTS: [[f64; 2]; 3] = [[-1.0, -1.0], [1.0, 0.0], [0.0, 1.0]];

/// Number of shape functions of a triangle of that degree.
pub const fn shapes(degree: usize) -> usize {
    (degree + 1) * (degree + 2) / 2
}

/// Barycentric coordinates of `(xi, eta)`.
pub fn barycentric([xi, eta]: [f64; 2]) -> [f64; 3] {
    [1.0 - xi - eta, xi, eta]
}

/// Reference coordinates of the nodes of an element of degree 1, 2 or 3.
pub fn nodes(degree: usize) -> Vec<[f64; 2]> {
    let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    let mut nodes = corners.to_vec();
    for k in 0..3 {
        let (a, b) = (corners[k], corners[(k + 1) % 3]);
        for m in 1..degree {
            let s = m as f64 / degree as f64;
            nodes.push([a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])]);
        }
    }
    if degree == 3 {
        nodes.push([1.0 / 3.0, 1.0 / 3.0]);
    }
    nodes
}

/// Values of the shape functions at `(xi, eta)`; `out` has [`shapes`]`(degree)` entries.
pub fn values(degree: usize, point: [f64; 2], out: &mut [f64]) {
    let l = barycentric(point);
    match degree {
        1 => out.copy_from_slice(&l),
        2 => {
            for k in 0..3 {
                out[k] = l[k] * (2.0 * l[k] - 1.0);
                out[3 + k] = 4.0 * l[k] * l[(k + 1) % 3];
            }
        }
        _ => {
            for k in 0..3 {
                let (a, b) = (l[k], l[(k + 1) % 3]);
                out[k] = 0.5 * a * (3.0 * a - 1.0) * (3.0 * a - 2.0);
                out[3 + 2 * k] = 4.5 * a * b * (3.0 * a - 1.0);
                out[4 + 2 * k] = 4.5 * a * b * (3.0 * b - 1.0);
            }
            out[9] = 27.0 * l[0] * l[1] * l[2];
        }
    }
}

/// Values of the shape functions at several points; entries past [`shapes`]`(degree)` are zero.
pub fn tabulated(degree: usize, points: &[[f64; 2]]) -> Vec<[f64; MOST_SHAPES]> {
    let at = |&point: &[f64; 2]| {
        let mut out = [0.0; MOST_SHAPES];
        values(degree, point, &mut out[..shapes(degree)]);
        out
    };
    points.iter().map(at).collect()
}

/// Gradients in `(xi, eta)` of the shape functions at `(xi, eta)`.
pub fn gradients(degree: usize, point: [f64; 2], out: &mut [[f64; 2]]) {
    let l = barycentric(point);
    let g = &BARYCENTRIC_GRADIENTS;
    match degree {
        1 => out.copy_from_slice(g),
        2 => {
            for k in 0..3 {
                let n = (k + 1) % 3;
                for d in 0..2 {
                    out[k][d] = (4.0 * l[k] - 1.0) * g[k][d];
                    out[3 + k][d] = 4.0 * (l[k] * g[n][d] + l[n] * g[k][d]);
                }
            }
        }
        _ => {
            for k in 0..3 {
                let n = (k + 1) % 3;
                let (a, b) = (l[k], l[n]);
                for d in 0..2 {
                    let (ga, gb) = (g[k][d], g[n][d]);
                    out[k][d] = 0.5 * (27.0 * a * a - 18.0 * a + 2.0) * ga;
                    out[3 + 2 * k][d] = 4.5 * (b * (6.0 * a - 1.0) * ga + a * (3.0 * a - 1.0) * gb);
                    out[4 + 2 * k][d] = 4.5 * (a * (6.0 * b - 1.0) * gb + b * (3.0 * b - 1.0) * ga);
                }
            }
            for d in 0..2 {
                out[9][d] = 27.0 * (g[0][d] * l[1] * l[2] + g[1][d] * l[2] * l[0] + g[2][d] * l[0] * l[1]);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_one_at_their_node() {
        for degree in 1..=3 {
            let nodes = nodes(degree);
            assert_eq!(nodes.len(), shapes(degree));
            let mut out = vec![0.0; nodes.len()];
            for (i, &node) in nodes.iter().enumerate() {
                values(degree, node, &mut out);
                for (j, &value) in out.iter().enumerate() {
                    let expected = if i == j { 1.0 } else { 0.0 };
                    assert!((value - expected).abs() < 1e-14, "P{degree} shape {j} at node {i}: {value}");
                }
            }
        }
    }

    #[test]
    fn gradients_match_differences() {
        let (point, step) = ([0.23, 0.41], 1e-6);
        for degree in 1..=3 {
            let n = shapes(degree);
            let (mut plus, mut minus, mut exact) = (vec![0.0; n], vec![0.0; n], vec![[0.0; 2]; n]);
            gradients(degree, point, &mut exact);
            for d in 0..2 {
                let mut shifted = point;
                shifted[d] += step;
                values(degree, shifted, &mut plus);
                shifted[d] -= 2.0 * step;
                values(degree, shifted, &mut minus);
                for i in 0..n {
                    assert!((exact[i][d] - (plus[i] - minus[i]) / (2.0 * step)).abs() < 1e-8);
                }
            }
        }
    }
}
