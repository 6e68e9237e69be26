//! Axes: ends, round ticks and their numbers.

use crate::Label;

/// How values are placed and numbered.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scale {
    /// Linear, with decimal numbers.
    Linear,
    /// Linear, with angles in degrees.
    Degrees,
    /// Logarithmic, with powers of ten.
    Powers,
    /// Logarithmic, with times in seconds.
    Seconds,
}

/// Least extent of a logarithmic axis in decades.
const LEAST_DECADES: f64 = 1.2;
/// Room beyond its outermost points in decades.
const ROOM_DECADES: f64 = 0.15;
/// Most decades between which lines are drawn.
const MOST_DECADES: f64 = 8.0;
/// Room beyond the outermost values, as a part of their extent.
const ROOM: f64 = 0.05;
/// A linear axis begins at zero where its lesser end is below this part of the other, or hardly on the other side.
const NEAR: f64 = 0.25;
const ROUND_OFF: f64 = 1e-9;
const UNDERSHOOT: f64 = 2e-3;
/// Leading digits of round steps, and steps of angles [deg].
const DIGITS: [f64; 4] = [1.0, 2.0, 2.5, 5.0];
const DEGREES: [f64; 9] = [1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 45.0, 60.0, 90.0];

/// Least and greatest of values, which may be no number; of none `[inf, -inf]`.
pub fn least_and_greatest(values: impl IntoIterator<Item = f64>) -> [f64; 2] {
    let ends = [f64::INFINITY, f64::NEG_INFINITY];
    (values.into_iter()).fold(ends, |[low, high], value| [low.min(value), high.max(value)])
}

/// An axis: its ends (of a logarithmic one their exponents of ten) and its name.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// The low end.
    pub low: f64,
    /// The high end.
    pub high: f64,
    /// How values are placed.
    pub scale: Scale,
    /// What the values are, with their unit.
    pub name: Label,
    /// What stands at the values 0, 1, 2 ... instead of round numbers; none: those.
    pub rows: Vec<Label>,
}

/// The least and the greatest of finite values.
fn bounds(values: impl Iterator<Item = f64>) -> Option<[f64; 2]> {
    let finite = values.filter(|value| value.is_finite());
    finite.fold(None, |bounds, value| {
        let [low, high] = bounds.unwrap_or([value, value]);
        Some([f64::min(low, value), f64::max(high, value)])
    })
}

impl Axis {
    /// A linear axis from `low` to `high`.
    pub fn between(low: f64, high: f64, scale: Scale, name: Label) -> Self {
        Self { low, high, scale, name, rows: Vec::new() }
    }

    /// An axis with a row for each of these names, the first one lowest.
    pub fn of_rows(rows: &[Label]) -> Self {
        let high = rows.len() as f64 - 0.5;
        Self { rows: rows.to_vec(), ..Self::between(-0.5, high, Scale::Linear, Label::default()) }
    }

    /// The axis on which all values find room; a logarithmic one takes the positive values.
    pub fn around(values: impl Iterator<Item = f64>, scale: Scale, name: Label) -> Self {
        let [low, high] = match scale {
            Scale::Linear => linear(bounds(values)),
            Scale::Degrees => bounds(values).filter(|[low, high]| low < high).unwrap_or([0.0, 360.0]),
            Scale::Powers | Scale::Seconds => {
                let [low, high] = bounds(values.map(f64::log10)).unwrap_or([-1.85, -0.15]);
                let missing = f64::max(LEAST_DECADES - (high - low), 0.0);
                [low - 0.5 * missing - ROOM_DECADES, high + 0.5 * missing + ROOM_DECADES]
            }
        };
        Self::between(low, high, scale, name)
    }

    /// Length of the axis, in its values or in decades.
    pub fn extent(&self) -> f64 {
        self.high - self.low
    }

    /// An axis of another extent about the same middle.
    #[must_use]
    pub fn widened(self, extent: f64) -> Self {
        let middle = 0.5 * (self.low + self.high);
        Self { low: middle - 0.5 * extent, high: middle + 0.5 * extent, ..self }
    }

    /// Place of a value from 0 (low end) to 1.
    pub fn place(&self, value: f64) -> f64 {
        let value = match self.scale {
            Scale::Linear | Scale::Degrees => value,
            Scale::Powers | Scale::Seconds => value.log10(),
        };
        (value - self.low) / self.extent()
    }

    /// Round values on the axis, `most` steps at most, and their numbers.
    pub fn ticks(&self, most: f64) -> Vec<(f64, Label)> {
        if !self.rows.is_empty() {
            return (0..).map(f64::from).zip(self.rows.iter().cloned()).collect();
        }
        match self.scale {
            Scale::Linear => {
                let step = linear_steps(self.extent(), most);
                let values = multiples(self.low, self.high, step);
                values.into_iter().map(|value| (value, number(value, step))).collect()
            }
            Scale::Degrees => {
                let wanted = self.extent() / most;
                let step = DEGREES.into_iter().find(|step| *step >= wanted * (1.0 - ROUND_OFF)).unwrap_or(180.0);
                let values = multiples(self.low, self.high, step).into_iter();
                // A full turn from 0 ends at 360; on a longer way a turn begins there at 0.
                let last = self.high - ROUND_OFF * self.extent();
                values.map(|value| (value, angle(value, value >= last))).collect()
            }
            Scale::Powers | Scale::Seconds => {
                let every = (self.extent() / most).ceil().max(1.0) as i32;
                let exponents = self.low.ceil() as i32..=self.high.floor() as i32;
                let exponents = exponents.filter(|exponent| exponent % every == 0);
                exponents.map(|exponent| (10f64.powi(exponent), self.power(exponent))).collect()
            }
        }
    }

    fn power(&self, exponent: i32) -> Label {
        match self.scale {
            Scale::Seconds => Label::plain(&seconds(exponent)),
            _ => Label::marked(&power_of_ten(exponent)),
        }
    }

    /// The values of lines between decades.
    pub(crate) fn within_decades(&self) -> Vec<f64> {
        if !matches!(self.scale, Scale::Powers | Scale::Seconds) || self.extent() >= MOST_DECADES {
            return Vec::new();
        }
        let decades = self.low.floor() as i32..=self.high.floor() as i32;
        let all = decades.flat_map(|exponent| (2..10).map(move |digit| f64::from(digit) * 10f64.powi(exponent)));
        all.filter(|value| (0.0..=1.0).contains(&self.place(*value))).collect()
    }
}

/// Ends with some room; zero is an end where all values are on one side of it and not far away.
fn linear(bounds: Option<[f64; 2]>) -> [f64; 2] {
    let Some([low, high]) = bounds else { return [0.0, 1.0] };
    let extent = match high - low {
        0.0 if low == 0.0 => 1.0,
        0.0 => low.abs(),
        extent => extent,
    };
    let room = ROOM * extent;
    let is_near = |end: f64, other: f64| (-UNDERSHOOT..NEAR).contains(&(end / other));
    [if is_near(low, high) { 0.0 } else { low - room }, if is_near(high, low) { 0.0 } else { high + room }]
}

/// The least round step (1, 2, 2.5 or 5 times a power of ten) with which `extent` has `most` steps at most.
pub fn linear_steps(extent: f64, most: f64) -> f64 {
    let wanted = extent / most;
    let decade = 10f64.powf(wanted.log10().floor());
    let steps = DIGITS.into_iter().chain([10.0]).map(|digit| digit * decade);
    steps.into_iter().find(|step| *step >= wanted * (1.0 - ROUND_OFF)).unwrap_or(10.0 * decade)
}

/// Multiples of a step between two values, both included.
pub(crate) fn multiples(low: f64, high: f64, step: f64) -> Vec<f64> {
    let slack = 1e-6;
    let (first, last) = ((low / step - slack).ceil() as i64, (high / step + slack).floor() as i64);
    (first..=last).map(|k| k as f64 * step).collect()
}

/// A value with as many decimals as its step has, a true minus, and a power of ten where it is very large or small.
pub fn number(value: f64, step: f64) -> Label {
    let exponent = step.abs().log10().floor();
    if !(-4.0..5.0).contains(&exponent) {
        let power = value.abs().log10().floor();
        if value == 0.0 || !power.is_finite() {
            return Label::plain("0");
        }
        let decimals = (power - exponent).clamp(0.0, 3.0) as usize;
        let mantissa = with_minus(&format!("{:.decimals$}", value / 10f64.powf(power)));
        return Label::plain(&format!("{mantissa}\u{b7}")).and(Label::marked(&power_of_ten(power as i32)));
    }
    let is_fine = (step / 10f64.powf(exponent) - 2.5).abs() < 0.01;
    let decimals = (-exponent + if is_fine { 1.0 } else { 0.0 }).clamp(0.0, 12.0) as usize;
    let text = format!("{value:.decimals$}");
    Label::plain(&with_minus(if text.trim_start_matches('-').chars().all(|c| c == '0' || c == '.') {
        text.trim_start_matches('-')
    } else {
        &text
    }))
}

fn with_minus(text: &str) -> String {
    text.replace('-', "\u{2212}")
}

/// An angle within the turn from 0 to 360 degrees; 360 itself at the end of an axis only.
fn angle(degrees: f64, is_last: bool) -> Label {
    let turn = if degrees == 360.0 && is_last { degrees } else { degrees.rem_euclid(360.0) };
    Label::plain(&format!("{}\u{b0}", (turn * 1e6).round() * 1e-6))
}

fn power_of_ten(exponent: i32) -> String {
    match exponent {
        0 => "1".to_owned(),
        1 => "10".to_owned(),
        _ => format!("10^{{{}}}", with_minus(&exponent.to_string())),
    }
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

    fn axis(values: &[f64], scale: Scale) -> Axis {
        Axis::around(values.iter().copied(), scale, Label::default())
    }

    fn texts(axis: &Axis, most: f64) -> Vec<String> {
        axis.ticks(most).iter().map(|(_, label)| label.text()).collect()
    }

    #[test]
    fn logarithmic_axes_hold_their_values_and_have_an_extent() {
        let wide = axis(&[1e-3, 1.0, 0.0, f64::NAN], Scale::Powers);
        assert!((wide.low + 3.15).abs() < 1e-12 && (wide.high - 0.15).abs() < 1e-12);
        assert!(wide.place(1e-3) > 0.0 && wide.place(1.0) < 1.0);
        assert_eq!(texts(&wide, 8.0), ["10\u{2212}3", "10\u{2212}2", "10\u{2212}1", "1"]);
        let point = axis(&[1.0], Scale::Powers);
        assert!(point.extent() > 1.0 && (point.place(1.0) - 0.5).abs() < 1e-12);
        assert!(!axis(&[], Scale::Seconds).ticks(8.0).is_empty());
        assert_eq!([-6, -1, 0, 9].map(seconds), ["1 \u{b5}s", "100 ms", "1 s", "1e9 s"]);
    }

    #[test]
    fn linear_axes_are_divided_into_round_steps() {
        let speeds = axis(&[600.0, -1e-9, 3200.0], Scale::Linear);
        assert_eq!(speeds.low, 0.0);
        assert_eq!(texts(&speeds, 7.0), ["0", "500", "1000", "1500", "2000", "2500", "3000"]);
        assert_eq!(texts(&axis(&[-0.584, 2.7], Scale::Linear), 6.0), ["0", "1", "2"]);
        assert_eq!([linear_steps(10.0, 5.0), linear_steps(0.9, 4.0), linear_steps(7.0, 4.0)], [2.0, 0.25, 2.0]);
        for constant in [0.0, 3.0, -2.0] {
            let axis = axis(&[constant], Scale::Linear);
            assert!(axis.extent() > 0.0 && (0.0..=1.0).contains(&axis.place(constant)));
        }
        assert!(axis(&[], Scale::Linear).extent() > 0.0);
        assert!((speeds.widened(1e4).extent() - 1e4).abs() < 1e-9);
    }

    #[test]
    fn numbers_have_true_minus_signs_and_no_negative_zero() {
        assert_eq!(number(-0.5, 0.25).text(), "\u{2212}0.50");
        assert_eq!(number(-1e-18, 0.5).text(), "0.0");
        assert_eq!(number(2.5e-7, 5e-8).text(), "2.5\u{b7}10\u{2212}7");
        assert_eq!(number(0.0, 1e7).text(), "0");
    }

    #[test]
    fn angles_stay_within_a_turn() {
        let ring = Axis::between(300.0, 660.0, Scale::Degrees, Label::default());
        assert_eq!(
            texts(&ring, 6.0),
            ["300\u{b0}", "0\u{b0}", "60\u{b0}", "120\u{b0}", "180\u{b0}", "240\u{b0}", "300\u{b0}"]
        );
    }
}
