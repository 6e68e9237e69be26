//! # Where a line of constant x or z cuts a triangle
//!
//! **Equation.** `a + s (b - a)` with `s = (x - x_a)/(x_b - x_a)` on each side that the line crosses.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | x | m | `at` |
//! | s | 1 | `part` |
//!
//! **Source.** Definition. **Range.** Sides taken straight. **Verified by** `tests/tests/friction.rs` (flows through
//! lines) and `tests/full/tests/film_places.rs`.

const REFERENCE: [[f64; 2]; 3] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];

/// The two points, in reference coordinates, at which the line on which coordinate `axis` is `at` [m] cuts the sides of
/// a triangle taken straight; `None` where it passes by. Of two triangles with a side on the line one is cut.
pub(super) fn cut(corners: &[[f64; 2]; 3], axis: usize, at: f64) -> Option<[[f64; 2]; 2]> {
    let cuts = (0..3).filter_map(|k| {
        let (a, b) = (k, (k + 1) % 3);
        let (from, to) = (corners[a][axis], corners[b][axis]);
        let part = (at - from) / (to - from);
        ((from < at) != (to < at)).then(|| between(&REFERENCE[a], &REFERENCE[b], part))
    });
    let cuts: Vec<[f64; 2]> = cuts.collect();
    cuts.try_into().ok()
}

/// The point at this part of the way from one to another.
pub(super) fn between(from: &[f64; 2], to: &[f64; 2], part: f64) -> [f64; 2] {
    [0, 1].map(|d| from[d] + part * (to[d] - from[d]))
}
