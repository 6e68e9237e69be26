//! Polar axes: angles against the clock from the right, lengths from a circle outwards.

use crate::{Anchor, Colour, Figure, GREY, Label, Letters, Pen, SMALLEST_LETTERS};

/// Polar axes around a circle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Polar {
    /// The centre [mm].
    pub centre: [f64; 2],
    /// The circle from which values count [mm].
    pub base: f64,
    /// Length of a unit of the value [mm].
    pub scale: f64,
}

impl Polar {
    /// The point at an angle [rad] and a distance from the centre [mm].
    pub fn point(&self, angle: f64, distance: f64) -> [f64; 2] {
        [self.centre[0] + distance * angle.cos(), self.centre[1] - distance * angle.sin()]
    }

    /// Points of an arc at a distance from the centre [mm], from one angle [rad] to another.
    pub fn arc(&self, distance: f64, from: f64, to: f64) -> Vec<[f64; 2]> {
        let steps = ((to - from).abs() / 0.04).ceil().clamp(2.0, 400.0) as u32;
        (0..=steps).map(|k| self.point(from + (to - from) * f64::from(k) / f64::from(steps), distance)).collect()
    }

    /// A curve of angles [rad] and values above the circle, filled down to it.
    pub fn draw_curve(&self, figure: &mut Figure, curve: &[[f64; 2]], fill: Colour, pen: Pen) {
        let outer: Vec<_> =
            curve.iter().map(|[angle, value]| self.point(*angle, self.base + self.scale * value)).collect();
        let base = curve.iter().rev().map(|[angle, _]| self.point(*angle, self.base));
        figure.area([outer.iter().copied().chain(base).collect::<Vec<_>>()], fill);
        figure.line(&outer, pen);
    }

    /// Arcs at values, with their labels at the end `to` [rad].
    pub fn draw_rings(&self, figure: &mut Figure, rings: &[(f64, Label)], [from, to]: [f64; 2], colour: Colour) {
        let letters = Letters::sized(SMALLEST_LETTERS).coloured(GREY).with_halo();
        for (value, label) in rings {
            let distance = self.base + self.scale * value;
            figure.line(&self.arc(distance, from, to), Pen::new(0.4, colour));
            figure.text(self.point(to, distance), label, letters, Anchor::Centre);
        }
    }
}
