//! Round levels of a field, and the colours of the bands between them.

use crate::axis::{linear_steps, multiples};
use crate::{Colour, ColourMap};

/// Values between bands, and the colours of the bands.
#[derive(Debug, Clone, PartialEq)]
pub struct Levels {
    /// Values between bands, rising.
    pub edges: Vec<f64>,
    /// Colours from the lowest band on: one more than edges.
    pub colours: Vec<Colour>,
}

impl Levels {
    /// Round levels within a range, `most` of them at most; of a diverging map the band around zero is white.
    pub fn round([low, high]: [f64; 2], map: ColourMap, most: f64) -> Self {
        let extent = high - low;
        let step = linear_steps(if extent > 0.0 { extent } else { 1.0 }, most);
        let inside = |value: &f64| *value > low + 1e-3 * extent && *value < high - 1e-3 * extent;
        let is_level = |value: &f64| inside(value) && !(map.is_diverging() && value.abs() < 0.5 * step);
        let edges: Vec<f64> = multiples(low, high, step).into_iter().filter(is_level).collect();
        let ends = [&[low][..], &edges, &[high]].concat();
        let middle = |pair: &[f64]| 0.5 * (pair[0] + pair[1]);
        let mut colours: Vec<Colour> = ends
            .windows(2)
            .map(|pair| map.colour((middle(pair) - low) / if extent > 0.0 { extent } else { 1.0 }))
            .collect();
        if !map.is_diverging() {
            colours[0] = map.colour(0.0);
        }
        Self { edges, colours }
    }

    /// `count` bands of equal extent between two values.
    pub fn even([low, high]: [f64; 2], map: ColourMap, count: usize) -> Self {
        let part = |k: usize| k as f64 / count as f64;
        Self {
            edges: (1..count).map(|k| low + (high - low) * part(k)).collect(),
            colours: (0..count).map(|k| map.colour(part(k) + 0.5 / count as f64)).collect(),
        }
    }
}
