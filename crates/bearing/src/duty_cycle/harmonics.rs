//! A load given by its harmonics: `F(theta) = sum over k of a_k cos(k theta) + b_k sin(k theta)`.

/// One order of a load, in the axes of its frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Harmonic {
    /// Order k: cycles in a turn of the crank; 0 is a constant, and 1/2 belongs to a cycle of two turns.
    pub order: f64,
    /// Amplitude a of the cosine: force x, y [N], moment x, y [N m].
    pub cos: [f64; 4],
    /// Amplitude b of the sine: force x, y [N], moment x, y [N m].
    pub sin: [f64; 4],
}

/// Force [N] and moment [N m] at a crank angle [rad].
pub(super) fn sum(harmonics: &[Harmonic], angle: f64) -> [f64; 4] {
    harmonics.iter().fold([0.0; 4], |sum, harmonic| {
        let (sin, cos) = (harmonic.order * angle).sin_cos();
        [0, 1, 2, 3].map(|k| sum[k] + cos * harmonic.cos[k] + sin * harmonic.sin[k])
    })
}
