//! A smooth function on an interval by Chebyshev polynomials on pieces of equal length.
//!
//! **Source.** Clenshaw, Math. Tables Aids Comput. 9 (1955) 118 (the sum); Mason, Handscomb, Chebyshev Polynomials (2003), ch. 6 (interpolation at their zeros).

use std::f64::consts::PI;

/// Polynomials of each piece.
const TERMS: usize = 12;

/// A function, and its derivative, on an interval.
#[derive(Debug, Clone)]
pub(crate) struct Piecewise {
    from: f64,
    length: f64,
    pieces: Vec<[f64; TERMS]>,
}

impl Piecewise {
    /// Interpolates `function` on this many `pieces` from `from` to `to`.
    pub(crate) fn new(from: f64, to: f64, pieces: usize, function: impl Fn(f64) -> f64) -> Self {
        let length = (to - from) / pieces as f64;
        let angle = |k: usize| PI * (k as f64 + 0.5) / TERMS as f64;
        let expansion = |piece: usize| {
            let middle = from + length * (piece as f64 + 0.5);
            let values: [f64; TERMS] = std::array::from_fn(|k| function(middle + 0.5 * length * angle(k).cos()));
            std::array::from_fn(|term| {
                let sum: f64 = (0..TERMS).map(|k| values[k] * (term as f64 * angle(k)).cos()).sum();
                sum * if term == 0 { 1.0 } else { 2.0 } / TERMS as f64
            })
        };
        Self {
            from,
            length,
            pieces: (0..pieces).map(expansion).collect(),
        }
    }

    /// Value and derivative at a point; of one outside of the interval those of the polynomial at its edge.
    pub(crate) fn at(&self, x: f64) -> [f64; 2] {
        let place = (x - self.from) / self.length;
        let piece = (place.max(0.0) as usize).min(self.pieces.len() - 1);
        let t = 2.0 * (place - piece as f64) - 1.0;
        // Clenshaw's recurrence, and its derivative.
        let (mut b, mut before) = ([0.0, 0.0], [0.0, 0.0]);
        for &coefficient in self.pieces[piece][1..].iter().rev() {
            let next = [
                2.0 * t * b[0] - before[0] + coefficient,
                2.0 * (b[0] + t * b[1]) - before[1],
            ];
            (before, b) = (b, next);
        }
        let value = self.pieces[piece][0] + t * b[0] - before[0];
        let slope = b[0] + t * b[1] - before[1];
        [value, slope * 2.0 / self.length]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sine_and_its_derivative() {
        let sine = Piecewise::new(-1.0, 4.0, 10, f64::sin);
        for k in 0..=500 {
            let x = -1.0 + 0.01 * f64::from(k);
            let [value, slope] = sine.at(x);
            assert!(
                (value - x.sin()).abs() < 1e-14 && (slope - x.cos()).abs() < 1e-12,
                "{x}"
            );
        }
    }
}
