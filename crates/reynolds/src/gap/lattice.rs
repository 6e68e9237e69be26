//! Places in a triangle that is searched.

use oilwedge_fem::lagrange;

/// Points of a triangle, a quarter of its sides apart.
pub(super) const LATTICE: [[f64; 2]; 15] = [
    [0.0, 0.0],
    [0.25, 0.0],
    [0.5, 0.0],
    [0.75, 0.0],
    [1.0, 0.0],
    [0.0, 0.25],
    [0.25, 0.25],
    [0.5, 0.25],
    [0.75, 0.25],
    [0.0, 0.5],
    [0.25, 0.5],
    [0.5, 0.5],
    [0.0, 0.75],
    [0.25, 0.75],
    [0.0, 1.0],
];
pub(super) const SPACING: f64 = 0.25;
/// Lattice points that are the nodes of a quadratic, in their order.
pub(super) const NODES: [usize; 6] = [0, 4, 14, 2, 11, 9];

/// The reference point in a triangle of these corners that is at `(xi, eta)` of it.
pub(super) fn within(corners: &[[f64; 2]; 3], at: [f64; 2]) -> [f64; 2] {
    let parts = lagrange::barycentric(at);
    [0, 1].map(|d| (0..3).map(|k| parts[k] * corners[k][d]).sum())
}

/// The part of the line at the axial position `z` [m] that lies in a triangle.
pub(super) fn crossing(corners: [[f64; 2]; 3], z: f64) -> Option<[f64; 2]> {
    let side = |k: usize| {
        let ([a, low], [b, high]) = (corners[k], corners[(k + 1) % 3]);
        let part = (z - low) / (high - low);
        match (low == z, (0.0..=1.0).contains(&part)) {
            (true, _) => Some(a),
            (false, true) => Some(a + part * (b - a)),
            (false, false) => None,
        }
    };
    let places = (0..3).filter_map(side);
    places.fold(None, |part: Option<[f64; 2]>, x| match part {
        None => Some([x, x]),
        Some([from, to]) => Some([from.min(x), to.max(x)]),
    })
}
