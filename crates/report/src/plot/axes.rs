//! A frame with logarithmic axes.

use plotters::style::text_anchor::{HPos, VPos};

use super::PlotError;
use super::canvas::{Canvas, Letters, Pen};
use super::palette::{FINE_GRID, GRID, INK};

/// Least extent of an axis in decades.
const LEAST_EXTENT: f64 = 1.2;
/// Room beyond the outermost points in decades.
const ROOM: f64 = 0.15;
/// Most decades that all have a number.
const MOST_NUMBERS: f64 = 8.0;

/// A logarithmic axis: the exponents of ten of its ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Decades {
    pub(super) low: f64,
    pub(super) high: f64,
}

impl Decades {
    /// The axis on which all positive values find room.
    pub(super) fn holding(values: impl Iterator<Item = f64>) -> Self {
        let exponents = values.filter(|value| *value > 0.0 && value.is_finite()).map(f64::log10);
        let (low, high) = exponents.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
            (low.min(value), high.max(value))
        });
        if low > high {
            return Self { low: -2.0, high: 0.0 };
        }
        let missing = f64::max(LEAST_EXTENT - (high - low), 0.0);
        Self {
            low: low - 0.5 * missing - ROOM,
            high: high + 0.5 * missing + ROOM,
        }
    }

    /// Place of a value from 0 (low end) to 1.
    pub(super) fn place(&self, value: f64) -> f64 {
        (value.log10() - self.low) / (self.high - self.low)
    }

    /// Exponents of the whole decades within.
    fn whole(&self) -> impl Iterator<Item = i32> + use<> {
        self.low.ceil() as i32..=self.high.floor() as i32
    }

    /// Whether the decade has a number: all, or every second or third where there are many.
    fn has_number(&self, exponent: i32) -> bool {
        exponent % ((self.high - self.low) / MOST_NUMBERS).ceil() as i32 == 0
    }
}

/// How the decades of an axis are told.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Numbers {
    /// A power of ten.
    Powers,
    /// A time in seconds.
    Seconds,
}

/// A frame on the sheet [points] and its axes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frame {
    pub(super) left: f64,
    pub(super) top: f64,
    pub(super) width: f64,
    pub(super) height: f64,
    pub(super) x: Decades,
    pub(super) y: Decades,
}

impl Frame {
    /// Where a point of values stands on the sheet.
    pub(super) fn at(&self, x: f64, y: f64) -> [f64; 2] {
        [
            self.left + self.width * self.x.place(x),
            self.top + self.height * (1.0 - self.y.place(y)),
        ]
    }

    /// Grid and numbers; what belongs below the curves.
    pub(super) fn draw_grid(&self, canvas: &Canvas, numbers: Numbers) -> Result<(), PlotError> {
        let (right, bottom) = (self.left + self.width, self.top + self.height);
        let upright = |x: f64, colour| canvas.line(&[[x, self.top], [x, bottom]], Pen(0.75, colour));
        let level = |y: f64, colour| canvas.line(&[[self.left, y], [right, y]], Pen(0.75, colour));
        let within = |axis: &Decades, value: &f64| (0.0..=1.0).contains(&axis.place(*value));
        let between = |axis: Decades| {
            let decades = axis.low.floor() as i32..=axis.high.floor() as i32;
            let all = decades.flat_map(|exponent| (2..10).map(move |digit| f64::from(digit) * 10f64.powi(exponent)));
            all.filter(move |value| within(&axis, value))
        };
        for x in between(self.x) {
            upright(self.at(x, 1.0)[0], FINE_GRID)?;
        }
        // Many decades leave no room for lines between them.
        if self.y.high - self.y.low < MOST_NUMBERS {
            for y in between(self.y) {
                level(self.at(1.0, y)[1], FINE_GRID)?;
            }
        }
        for exponent in self.x.whole() {
            let x = self.at(10f64.powi(exponent), 1.0)[0];
            upright(x, GRID)?;
            if self.x.has_number(exponent) {
                number(canvas, [x, bottom + 9.0], (HPos::Center, VPos::Top), numbers, exponent)?;
            }
        }
        for exponent in self.y.whole() {
            let y = self.at(1.0, 10f64.powi(exponent))[1];
            level(y, GRID)?;
            if self.y.has_number(exponent) {
                number(
                    canvas,
                    [self.left - 9.0, y],
                    (HPos::Right, VPos::Center),
                    Numbers::Powers,
                    exponent,
                )?;
            }
        }
        Ok(())
    }

    /// The frame itself and the names of its axes; what belongs above the curves.
    pub(super) fn draw_frame(&self, canvas: &Canvas, x_name: &str, y_name: &str) -> Result<(), PlotError> {
        let (right, bottom) = (self.left + self.width, self.top + self.height);
        let corners = [
            [self.left, self.top],
            [right, self.top],
            [right, bottom],
            [self.left, bottom],
            [self.left, self.top],
        ];
        canvas.line(&corners, Pen(1.0, INK))?;
        let below = [0.5 * (self.left + right), bottom + 31.0];
        canvas.text(below, x_name, plain(13.0, (HPos::Center, VPos::Top)))?;
        if y_name.is_empty() {
            return Ok(());
        }
        let upright = Letters {
            upright: true,
            ..plain(13.0, (HPos::Center, VPos::Center))
        };
        canvas.text([self.left - 52.0, 0.5 * (self.top + bottom)], y_name, upright)
    }
}

/// Letters in the colour of text.
pub(super) fn plain(size: f64, anchor: (HPos, VPos)) -> Letters {
    Letters {
        size,
        colour: INK,
        anchor,
        bold: false,
        upright: false,
    }
}

/// A power of ten, its exponent raised, or a time.
pub(super) fn number(
    canvas: &Canvas,
    [x, y]: [f64; 2],
    (horizontal, vertical): (HPos, VPos),
    numbers: Numbers,
    exponent: i32,
) -> Result<(), PlotError> {
    const SIZE: f64 = 12.0;
    if numbers == Numbers::Seconds {
        return canvas.text([x, y], &seconds(exponent), plain(SIZE, (horizontal, vertical)));
    }
    let raised = match exponent {
        negative if negative < 0 => format!("\u{2212}{}", -negative),
        other => other.to_string(),
    };
    let width = 5.6 * raised.chars().count() as f64;
    let seam = match horizontal {
        HPos::Right => x - width,
        HPos::Left => x + 15.0,
        HPos::Center => x + 7.5 - 0.5 * width,
    };
    canvas.text([seam, y], "10", plain(SIZE, (HPos::Right, vertical)))?;
    canvas.text(
        [seam + 0.8, y - 5.0],
        &raised,
        plain(0.75 * SIZE, (HPos::Left, vertical)),
    )
}

/// A power of ten of seconds in the unit that people use.
fn seconds(exponent: i32) -> String {
    let (unit, shift) = match exponent {
        0.. => ("s", 0),
        -3..0 => ("ms", 3),
        _ => ("\u{b5}s", 6),
    };
    match exponent + shift {
        digits @ 0..=5 => format!("{} {unit}", 10i64.pow(digits.unsigned_abs())),
        _ => format!("1e{exponent} s"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_hold_their_values_and_have_an_extent() {
        let axis = Decades::holding([1e-3, 1.0, 0.0, f64::NAN].into_iter());
        assert!((axis.low + 3.15).abs() < 1e-12 && (axis.high - 0.15).abs() < 1e-12);
        assert!(axis.place(1e-3) > 0.0 && axis.place(1.0) < 1.0);
        let point = Decades::holding([1.0].into_iter());
        assert!(point.high - point.low > 1.0 && (point.place(1.0) - 0.5).abs() < 1e-12);
        assert!(Decades::holding([].into_iter()).whole().count() > 0);
    }

    #[test]
    fn times_are_told_in_units_of_people() {
        let told = [-6, -5, -3, -1, 0, 2, 9].map(seconds);
        assert_eq!(
            told,
            ["1 \u{b5}s", "10 \u{b5}s", "1 ms", "100 ms", "1 s", "100 s", "1e9 s"]
        );
    }
}
