//! Quadratic fields on triangles of the sheet, and the sides that two of them share.

use crate::outline::{FinePlace, place};

/// A quadratic field on a triangle: three corners, then the middles of the sides 01, 12, 20.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Patch {
    /// Nodes on the sheet [mm].
    pub points: [[f64; 2]; 6],
    /// Values there.
    pub values: [f64; 6],
}

/// A side by its places, the lesser end first.
pub(crate) type PatchSide = [FinePlace; 3];

/// The sides 01, 12, 20, and whether each runs from its lesser place to its greater.
pub(crate) fn sides(patch: &Patch) -> [(PatchSide, bool); 3] {
    [0, 1, 2].map(|side| {
        let [a, b, middle] = [side, (side + 1) % 3, 3 + side].map(|k| place(patch.points[k]));
        if a <= b { ([a, b, middle], true) } else { ([b, a, middle], false) }
    })
}

/// A grid of `n` by `n` squares of two triangles each on the sheet, with the values of a function.
#[cfg(test)]
pub(crate) fn grid(n: u32, size: f64, f: impl Fn([f64; 2]) -> f64) -> Vec<Patch> {
    let h = size / f64::from(n);
    let mut patches = Vec::new();
    for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (f64::from(i), f64::from(j)))) {
        for corners in [[[i, j], [i + 1.0, j], [i + 1.0, j + 1.0]], [[i, j], [i, j + 1.0], [i + 1.0, j + 1.0]]] {
            let middle = |k: usize| [0, 1].map(|d| 0.5 * (corners[k][d] + corners[(k + 1) % 3][d]));
            let nodes = [corners[0], corners[1], corners[2], middle(0), middle(1), middle(2)];
            let points = nodes.map(|point| point.map(|part: f64| h * part));
            patches.push(Patch { points, values: points.map(&f) });
        }
    }
    patches
}
