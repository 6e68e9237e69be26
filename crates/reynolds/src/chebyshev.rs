//! A smooth function on an interval by its interpolation at Chebyshev points on short pieces of equal length.
//!
//! **Source.** Mason, Handscomb, Chebyshev Polynomials (2003), ch. 2 (as powers) and 6 (interpolation at their zeros).

use std::f64::consts::PI;

/// Coefficients of each piece.
const TERMS: usize = 8;

/// A function, and its derivative, on an interval.
#[derive(Debug, Clone)]
pub(crate) struct Piecewise {
    from: f64,
    length: f64,
    /// Coefficients of the powers of the coordinate t of each piece, which runs from -1 to 1.
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
            powers(std::array::from_fn(|term| {
                let sum: f64 = (0..TERMS).map(|k| values[k] * (term as f64 * angle(k)).cos()).sum();
                sum * if term == 0 { 1.0 } else { 2.0 } / TERMS as f64
            }))
        };
        Self { from, length, pieces: (0..pieces).map(expansion).collect() }
    }

    /// Value and derivative at a point; of one outside of the interval those of the polynomial at its edge.
    pub(crate) fn at(&self, x: f64) -> [f64; 2] {
        let place = (x - self.from) / self.length;
        let piece = (place.max(0.0) as usize).min(self.pieces.len() - 1);
        let t = 2.0 * (place - piece as f64) - 1.0;
        let (mut value, mut slope) = (0.0, 0.0);
        for &coefficient in self.pieces[piece].iter().rev() {
            slope = slope * t + value;
            value = value * t + coefficient;
        }
        [value, slope * 2.0 / self.length]
    }
}

/// The coefficients of the powers of t in a sum of Chebyshev polynomials: `T_(k+1) = 2 t T_k - T_(k-1)`.
fn powers(coefficients: [f64; TERMS]) -> [f64; TERMS] {
    let (mut sum, mut before, mut polynomial) = ([0.0; TERMS], [0.0; TERMS], [0.0; TERMS]);
    polynomial[0] = 1.0;
    for (term, coefficient) in coefficients.into_iter().enumerate() {
        (0..TERMS).for_each(|power| sum[power] += coefficient * polynomial[power]);
        let factor = if term == 0 { 1.0 } else { 2.0 };
        let risen = |power: usize| if power == 0 { 0.0 } else { polynomial[power - 1] };
        let next = std::array::from_fn(|power| factor * risen(power) - before[power]);
        (before, polynomial) = (polynomial, next);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sine_and_its_derivative() {
        let sine = Piecewise::new(-1.0, 4.0, 80, f64::sin);
        for k in 0..=500 {
            let x = -1.0 + 0.01 * f64::from(k);
            let [value, slope] = sine.at(x);
            assert!((value - x.sin()).abs() < 1e-14 && (slope - x.cos()).abs() < 1e-11, "{x}");
        }
    }
}
