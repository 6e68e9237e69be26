//! Friction and the heat carried off against the temperature of the film, and where they cross.

use plotters::style::RGBColor;
use plotters::style::text_anchor::{HPos, VPos};

use super::axes::plain;
use super::canvas::{Canvas, Letters, Mark, Pen, in_points};
use super::palette::{GREY, GRID, INK};
use super::{PlotError, shortened};
use crate::report::{HeatPoint, HeatReport};

/// The sheet [points].
const SIZE: [f64; 2] = [760.0, 500.0];
/// Left, top, width and height of the frame [points].
const FRAME: [f64; 4] = [78.0, 84.0, 652.0, 352.0];
/// Colours of the palette of M. Okabe and K. Ito, Color Universal Design (2008).
const FRICTION: RGBColor = RGBColor(213, 94, 0);
const CARRIED: RGBColor = RGBColor(0, 114, 178);
/// About so many numbers at an axis.
const NUMBERS: f64 = 7.0;

/// An even axis.
#[derive(Debug, Clone, Copy)]
struct Axis {
    low: f64,
    high: f64,
}

impl Axis {
    fn place(self, value: f64) -> f64 {
        (value - self.low) / (self.high - self.low)
    }

    /// Round numbers on it: steps of 1, 2 or 5 times a power of ten.
    fn numbers(self) -> Vec<f64> {
        let rough = (self.high - self.low) / NUMBERS;
        let power = 10f64.powf(rough.log10().floor());
        let step = [1.0, 2.0, 5.0, 10.0]
            .map(|digit| digit * power)
            .into_iter()
            .find(|step| *step >= rough);
        let step = step.unwrap_or(10.0 * power);
        let first = (self.low / step).ceil() as i64;
        let last = (self.high / step).floor() as i64;
        (first..=last).map(|number| number as f64 * step).collect()
    }
}

/// One of the powers of a point.
type Power = fn(&HeatPoint) -> f64;

fn carried(point: &HeatPoint) -> f64 {
    point.heat_carried + point.heat_housing
}

/// The picture of a balance of heat as SVG; `found` is the temperature found [degrees C] and the power there [W].
///
/// # Errors
/// [`PlotError::Drawing`].
pub fn heat_to_svg(title: &str, report: &HeatReport, found: Option<[f64; 2]>) -> Result<String, PlotError> {
    let temperatures = report.curve.iter().map(|point| point.temperature);
    let (low, high) = temperatures.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), t| {
        (low.min(t), high.max(t))
    });
    let (low, high) = if low < high {
        (low, high)
    } else {
        (report.inlet_temperature, report.inlet_temperature + 20.0)
    };
    let greatest = report
        .curve
        .iter()
        .map(|point| point.friction_power.max(carried(point)))
        .fold(0.0, f64::max);
    let least = report.curve.iter().map(carried).fold(0.0, f64::min);
    let x = Axis { low, high };
    let y = Axis {
        low: 1.05 * least,
        high: if greatest > 0.0 { 1.05 * greatest } else { 1.0 },
    };
    let at = |t: f64, power: f64| {
        let [left, top, width, height] = FRAME;
        [left + width * x.place(t), top + height * (1.0 - y.place(power))]
    };
    let mut text = String::new();
    let canvas = Canvas::new(&mut text, SIZE)?;
    let bold = Letters {
        bold: true,
        ..plain(17.0, (HPos::Left, VPos::Center))
    };
    canvas.text([FRAME[0], 28.0], &shortened(title), bold)?;
    frame(&canvas, x, y, &at)?;
    let curve = |value: Power| -> Vec<[f64; 2]> {
        report
            .curve
            .iter()
            .map(|point| at(point.temperature, value(point)))
            .collect()
    };
    let entries: [(&str, RGBColor, Mark, Power); 2] = [
        ("friction", FRICTION, Mark::Disc, |point| point.friction_power),
        ("heat carried off", CARRIED, Mark::Square, carried),
    ];
    for (place, (name, colour, mark, value)) in (0..).zip(entries) {
        let points = curve(value);
        if points.len() > 1 {
            canvas.line(&points, Pen(2.0, colour))?;
        }
        for point in points {
            canvas.mark(point, mark, colour, true)?;
        }
        let left = FRAME[0] + 170.0 * f64::from(place);
        canvas.line(&[[left, 58.0], [left + 26.0, 58.0]], Pen(2.0, colour))?;
        canvas.mark([left + 13.0, 58.0], mark, colour, true)?;
        canvas.text([left + 34.0, 58.0], name, plain(13.0, (HPos::Left, VPos::Center)))?;
    }
    if let Some([temperature, power]) = found.filter(|[t, _]| (low..=high).contains(t)) {
        let [left, top] = at(temperature, power);
        let bottom = FRAME[1] + FRAME[3];
        canvas.dashed(&[[left, top], [left, bottom]], [5.0, 3.5], Pen(1.2, INK))?;
        canvas.mark([left, top], Mark::Diamond, INK, false)?;
        let told = format!("{temperature:.1} C, {power:.0} W");
        canvas.text(
            [left + 9.0, bottom - 12.0],
            &told,
            plain(13.0, (HPos::Left, VPos::Center)),
        )?;
    }
    canvas.finish()?;
    Ok(in_points(&text, SIZE))
}

/// Grid, numbers and names.
fn frame(canvas: &Canvas, x: Axis, y: Axis, at: &dyn Fn(f64, f64) -> [f64; 2]) -> Result<(), PlotError> {
    let [left, top, width, height] = FRAME;
    let (right, bottom) = (left + width, top + height);
    for number in x.numbers() {
        let place = at(number, 0.0)[0];
        canvas.line(&[[place, top], [place, bottom]], Pen(0.75, GRID))?;
        canvas.text(
            [place, bottom + 9.0],
            &format!("{number}"),
            plain(12.0, (HPos::Center, VPos::Top)),
        )?;
    }
    for number in y.numbers() {
        let place = at(x.low, number)[1];
        canvas.line(&[[left, place], [right, place]], Pen(0.75, GRID))?;
        canvas.text(
            [left - 9.0, place],
            &format!("{number}"),
            plain(12.0, (HPos::Right, VPos::Center)),
        )?;
    }
    let around = [[left, top], [right, top], [right, bottom], [left, bottom], [left, top]];
    canvas.line(&around, Pen(1.0, INK))?;
    let name = Letters {
        colour: GREY,
        ..plain(13.0, (HPos::Center, VPos::Center))
    };
    canvas.text(
        [0.5 * (left + right), bottom + 42.0],
        "mean temperature of the film [C]",
        name,
    )?;
    let upright = Letters { upright: true, ..name };
    canvas.text([18.0, 0.5 * (top + bottom)], "power [W]", upright)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::to_png;

    fn report(points: &[(f64, f64, f64)]) -> HeatReport {
        let point = |&(temperature, friction_power, heat_carried): &(f64, f64, f64)| HeatPoint {
            temperature,
            viscosity: 0.01,
            friction_power,
            heat_carried,
            heat_housing: 1.0,
            eccentricity: 0.5,
        };
        HeatReport {
            inlet_temperature: 75.0,
            curve: points.iter().map(point).collect(),
            ..HeatReport::default()
        }
    }

    #[test]
    fn the_picture_tells_both_curves_and_where_they_cross() {
        let report = report(&[(75.0, 400.0, -3.0), (82.0, 330.0, 329.0), (90.0, 280.0, 700.0)]);
        let svg = heat_to_svg("A <bearing>", &report, Some([82.0, 330.0])).expect("a drawing");
        for words in [
            "A &lt;bearing&gt;",
            "friction",
            "heat carried off",
            "82.0 C, 330 W",
            "power [W]",
            ">80<",
            ">600<",
        ] {
            assert!(
                svg.contains(words) || svg.contains(&words.replace(['<', '>'], "\n")),
                "no {words}"
            );
        }
        assert!(to_png(&svg).is_ok());
    }

    #[test]
    fn few_points_are_drawn_too() {
        for points in [&[][..], &[(80.0, 0.0, 0.0)]] {
            assert!(heat_to_svg("a", &report(points), None).is_ok());
        }
        let axis = Axis { low: 0.3, high: 71.0 };
        assert_eq!(axis.numbers(), [20.0, 40.0, 60.0]);
    }
}
