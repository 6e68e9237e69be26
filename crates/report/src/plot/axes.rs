//! Linear and logarithmic axes, and the frame that two of them make.

use plotters::style::RGBColor;
use plotters::style::text_anchor::{HPos, VPos};

use super::canvas::{CENTRE, Canvas, Letters, Pen, RIGHT, TOP};
use super::palette::{FINE_GRID, GRID};
use crate::Error;

/// Least extent of a logarithmic axis in decades.
const LEAST_DECADES: f64 = 1.2;
/// Room beyond its outermost points in decades.
const ROOM_DECADES: f64 = 0.15;
/// Most decades that all have a number, and lines between them.
const MOST_NUMBERS: f64 = 8.0;
/// Least number of steps of a linear axis.
const STEPS: f64 = 4.0;
/// Room beyond its outermost values, as a part of their extent.
const ROOM: f64 = 0.05;
/// A linear axis begins at zero where its lesser end is below this part of the other, or round-off on the other side.
const NEAR: f64 = 0.25;
const ROUND_OFF: f64 = 1e-9;
/// Height of numbers, and of the names of axes [points].
const LETTERS: [f64; 2] = [12.0, 13.0];

/// How values are placed and numbered.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Scale {
    /// In proportion, with decimal numbers.
    Linear,
    /// By logarithm, with powers of ten.
    Powers,
    /// By logarithm, with times in seconds.
    Seconds,
}

/// An axis: its ends, of a logarithmic one their exponents of ten.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Axis {
    pub(super) low: f64,
    pub(super) high: f64,
    pub(super) scale: Scale,
}

/// The least and the greatest of finite values; `None` without any.
pub(super) fn bounds(values: impl Iterator<Item = f64>) -> Option<(f64, f64)> {
    let finite = values.filter(|value| value.is_finite());
    finite.fold(None, |bounds, value| {
        let (low, high) = bounds.unwrap_or((value, value));
        Some((f64::min(low, value), f64::max(high, value)))
    })
}

impl Axis {
    /// The linear axis on which all values find room. Zero is its end where all are on one side of it and not far away.
    pub(super) fn linear(values: impl Iterator<Item = f64>) -> Self {
        let scale = Scale::Linear;
        let Some((low, high)) = bounds(values) else {
            let (low, high) = (0.0, 1.0);
            return Self { low, high, scale };
        };
        let extent = match high - low {
            0.0 if low == 0.0 => 1.0,
            0.0 => low.abs(),
            extent => extent,
        };
        let room = ROOM * extent;
        let is_near = |end: f64, other: f64| (-ROUND_OFF..NEAR).contains(&(end / other));
        Self {
            low: if is_near(low, high) { 0.0 } else { low - room },
            high: if is_near(high, low) { 0.0 } else { high + room },
            scale,
        }
    }

    /// The logarithmic axis on which all positive values find room.
    pub(super) fn logarithmic(values: impl Iterator<Item = f64>, scale: Scale) -> Self {
        let (low, high) = bounds(values.map(f64::log10)).unwrap_or((-1.85, -0.15));
        let missing = f64::max(LEAST_DECADES - (high - low), 0.0);
        Self {
            low: low - 0.5 * missing - ROOM_DECADES,
            high: high + 0.5 * missing + ROOM_DECADES,
            scale,
        }
    }

    /// Length of the axis, in its values or in decades.
    pub(super) fn extent(&self) -> f64 {
        self.high - self.low
    }

    /// An axis of another extent about the same middle.
    pub(super) fn widened(&self, extent: f64) -> Self {
        let middle = 0.5 * (self.low + self.high);
        Self {
            low: middle - 0.5 * extent,
            high: middle + 0.5 * extent,
            ..*self
        }
    }

    /// Place of a value from 0 (low end) to 1.
    pub(super) fn place(&self, value: f64) -> f64 {
        let value = match self.scale {
            Scale::Linear => value,
            Scale::Powers | Scale::Seconds => value.log10(),
        };
        (value - self.low) / self.extent()
    }

    /// The step of a linear axis: one, two or five times a power of ten.
    fn step(&self) -> f64 {
        let most = self.extent() / STEPS;
        let decade = 10f64.powf(most.log10().floor());
        let steps = [5.0, 2.0].map(|digit| digit * decade);
        steps.into_iter().find(|step| *step <= most).unwrap_or(decade)
    }

    /// The values with a line of the grid, and the exponents of ten of a logarithmic axis.
    fn ticks(&self) -> Vec<(f64, i32)> {
        match self.scale {
            Scale::Linear => {
                let step = self.step();
                let first = (self.low / step - 1e-9).ceil() as i64;
                let last = (self.high / step + 1e-9).floor() as i64;
                (first..=last).map(|k| (step * k as f64, 0)).collect()
            }
            Scale::Powers | Scale::Seconds => {
                let decades = self.low.ceil() as i32..=self.high.floor() as i32;
                decades.map(|exponent| (10f64.powi(exponent), exponent)).collect()
            }
        }
    }

    /// The values of lines between decades.
    fn between(&self) -> Vec<f64> {
        if self.scale == Scale::Linear || self.extent() >= MOST_NUMBERS {
            return Vec::new();
        }
        let decades = self.low.floor() as i32..=self.high.floor() as i32;
        let all = decades.flat_map(|exponent| (2..10).map(move |digit| f64::from(digit) * 10f64.powi(exponent)));
        all.filter(|value| (0.0..=1.0).contains(&self.place(*value))).collect()
    }

    /// Writes the number of a tick; of many decades every second or third has one.
    fn number(&self, canvas: &Canvas, at: [f64; 2], anchor: (HPos, VPos), tick: (f64, i32)) -> Result<(), Error> {
        let (value, exponent) = tick;
        let write = |text: &str| canvas.text(at, text, Letters::new(LETTERS[0], anchor));
        match self.scale {
            Scale::Linear => {
                // As many decimals as the step has.
                let decimals = (-self.step().log10().floor()).clamp(0.0, 12.0) as usize;
                write(&format!("{value:.decimals$}"))
            }
            _ if exponent % (self.extent() / MOST_NUMBERS).ceil() as i32 != 0 => Ok(()),
            Scale::Seconds => write(&seconds(exponent)),
            Scale::Powers => power_of_ten(canvas, at, anchor, exponent),
        }
    }
}

/// A frame on the sheet [points] and its axes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frame {
    pub(super) left: f64,
    pub(super) top: f64,
    pub(super) width: f64,
    pub(super) height: f64,
    pub(super) x: Axis,
    pub(super) y: Axis,
}

impl Frame {
    /// Where a point of values stands on the sheet.
    pub(super) fn at(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [
            self.left + self.width * self.x.place(x),
            self.top + self.height * (1.0 - self.y.place(y)),
        ]
    }

    /// Right end and bottom.
    pub(super) fn corner(&self) -> [f64; 2] {
        [self.left + self.width, self.top + self.height]
    }

    /// Grid and numbers, which belong below the curves.
    pub(super) fn draw_grid(&self, canvas: &Canvas) -> Result<(), Error> {
        let [right, bottom] = self.corner();
        let across = |value: f64| self.left + self.width * self.x.place(value);
        let upwards = |value: f64| self.top + self.height * (1.0 - self.y.place(value));
        let pen = |colour: RGBColor| Pen(0.75, colour);
        for x in self.x.between().into_iter().map(across) {
            canvas.line(&[[x, self.top], [x, bottom]], pen(FINE_GRID))?;
        }
        for y in self.y.between().into_iter().map(upwards) {
            canvas.line(&[[self.left, y], [right, y]], pen(FINE_GRID))?;
        }
        for tick in self.x.ticks() {
            let x = across(tick.0);
            canvas.line(&[[x, self.top], [x, bottom]], pen(GRID))?;
            self.x.number(canvas, [x, bottom + 7.0], TOP, tick)?;
        }
        for tick in self.y.ticks() {
            let y = upwards(tick.0);
            canvas.line(&[[self.left, y], [right, y]], pen(GRID))?;
            self.y.number(canvas, [self.left - 8.0, y], RIGHT, tick)?;
        }
        Ok(())
    }

    /// The frame itself and the names of its axes, which belong above the curves.
    pub(super) fn draw_frame(&self, canvas: &Canvas, x_name: &str, y_name: &str) -> Result<(), Error> {
        let [right, bottom] = self.corner();
        canvas.frame([self.left, self.top], [right, bottom])?;
        let below = [0.5 * (self.left + right), bottom + 28.0];
        canvas.text(below, x_name, Letters::new(LETTERS[1], TOP))?;
        let beside = [self.left - 58.0, 0.5 * (self.top + bottom)];
        canvas.text(beside, y_name, Letters::new(LETTERS[1], CENTRE).upright())
    }
}

/// A power of ten, its exponent raised.
pub(super) fn power_of_ten(
    canvas: &Canvas,
    [x, y]: [f64; 2],
    anchor: (HPos, VPos),
    exponent: i32,
) -> Result<(), Error> {
    let raised = exponent.to_string().replace('-', "\u{2212}");
    let width = 5.6 * raised.chars().count() as f64;
    let (horizontal, vertical) = anchor;
    let seam = match horizontal {
        HPos::Right => x - width,
        HPos::Left => x + 15.0,
        HPos::Center => x + 7.5 - 0.5 * width,
    };
    canvas.text([seam, y], "10", Letters::new(LETTERS[0], (HPos::Right, vertical)))?;
    let small = Letters::new(0.75 * LETTERS[0], (HPos::Left, vertical));
    canvas.text([seam + 0.8, y - 5.0], &raised, small)
}

/// A power of ten of seconds in the usual unit.
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
    fn logarithmic_axes_hold_their_values_and_have_an_extent() {
        let axis = Axis::logarithmic([1e-3, 1.0, 0.0, f64::NAN].into_iter(), Scale::Powers);
        assert!((axis.low + 3.15).abs() < 1e-12 && (axis.high - 0.15).abs() < 1e-12);
        assert!(axis.place(1e-3) > 0.0 && axis.place(1.0) < 1.0);
        let point = Axis::logarithmic([1.0].into_iter(), Scale::Powers);
        assert!(point.extent() > 1.0 && (point.place(1.0) - 0.5).abs() < 1e-12);
        assert!(!Axis::logarithmic([].into_iter(), Scale::Seconds).ticks().is_empty());
    }

    #[test]
    fn linear_axes_are_divided_into_round_steps() {
        let values = |axis: &Axis| axis.ticks().into_iter().map(|(value, _)| value).collect::<Vec<_>>();
        let axis = Axis::linear([600.0, -1e-9, 3200.0].into_iter());
        assert_eq!(axis.low, 0.0);
        assert!((axis.high - 3360.0).abs() < 1e-6);
        assert_eq!(values(&axis), [0.0, 500.0, 1000.0, 1500.0, 2000.0, 2500.0, 3000.0]);
        let narrow = Axis::linear([4.6, 4.8].into_iter());
        assert!(narrow.low > 4.5 && values(&narrow).len() >= 4);
        for constant in [0.0, 3.0, -2.0] {
            let axis = Axis::linear([constant].into_iter());
            assert!(axis.extent() > 0.0 && (0.0..=1.0).contains(&axis.place(constant)));
        }
        assert!(Axis::linear([].into_iter()).extent() > 0.0);
        let wide = axis.widened(10_000.0);
        assert!((wide.extent() - 10_000.0).abs() < 1e-9 && (wide.place(1680.0) - 0.5).abs() < 1e-12);
    }

    #[test]
    fn times_have_their_usual_units() {
        let names = [-6, -5, -3, -1, 0, 2, 9].map(seconds);
        let wanted = ["1 \u{b5}s", "10 \u{b5}s", "1 ms", "100 ms", "1 s", "100 s", "1e9 s"];
        assert_eq!(names, wanted);
    }
}
