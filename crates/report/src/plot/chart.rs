//! Curves and marks over linear axes: several charts on one sheet, with one legend.

use plotters::style::RGBColor;
use plotters::style::text_anchor::{HPos, VPos};

use super::PlotError;
use super::axes::plain;
use super::canvas::{Canvas, Letters, Mark, Pen, in_points};
use super::palette::{GRID, INK};

/// Width of a chart and height of its frame [points].
const FRAME: [f64; 2] = [460.0, 300.0];
/// Left of a frame, right of it, above it, below it.
const MARGIN: [f64; 4] = [78.0, 22.0, 40.0, 58.0];
/// Height of a row of the legend, and the width of a letter there.
const LEGEND: [f64; 2] = [24.0, 7.4];
/// Least number of steps of an axis.
const STEPS: f64 = 4.0;
/// Room beyond the outermost values, as a part of their extent.
const ROOM: f64 = 0.05;
/// The axis begins at zero where its lesser end is below this part of the other, or rounding on the other side.
const NEAR: f64 = 0.25;
const ROUNDING: f64 = 1e-9;

/// How a series is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Style {
    /// A line through its points.
    Line,
    /// Dashes through its points.
    Dashes,
    /// A full mark at each.
    Discs,
    /// A hollow mark at each.
    Rings,
    /// A word at each: the name of the series, which no legend repeats.
    Word,
}

/// Points that belong together.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// What it is; empty: the legend does not tell. Series of one name share an entry.
    pub name: String,
    /// How it is drawn.
    pub style: Style,
    /// Red, green, blue.
    pub colour: [u8; 3],
    /// Its points, x and y. A line breaks where one is no number.
    pub points: Vec<[f64; 2]>,
}

/// Series over two axes.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Chart {
    /// What is shown.
    pub title: String,
    /// Name of the axis across.
    pub x: String,
    /// Name of the axis upwards.
    pub y: String,
    /// A drawing rather than curves: no axes, and equal lengths both ways.
    pub is_drawing: bool,
    /// What is drawn, the uppermost last.
    pub series: Vec<Series>,
}

/// Colours that the colour-blind can tell apart, after M. Okabe and K. Ito, Color Universal Design (2008).
pub const COLOURS: [[u8; 3]; 6] = [
    [0, 114, 178],
    [86, 180, 233],
    [0, 158, 115],
    [230, 159, 0],
    [213, 94, 0],
    [38, 38, 38],
];

/// Charts beside and below each other as SVG, `columns` in a row.
///
/// # Errors
/// [`PlotError::Drawing`].
pub fn charts_to_svg(charts: &[Chart], columns: usize) -> Result<String, PlotError> {
    let columns = columns.clamp(1, charts.len().max(1));
    let cell = [FRAME[0] + MARGIN[0] + MARGIN[1], FRAME[1] + MARGIN[2] + MARGIN[3]];
    let width = cell[0] * columns as f64;
    let legend = legend(charts, width - MARGIN[0] - MARGIN[1]);
    let below = cell[1] * charts.len().div_ceil(columns) as f64;
    let size = [width, below + LEGEND[0] * legend.len() as f64 + 8.0];
    let mut text = String::new();
    let canvas = Canvas::new(&mut text, size)?;
    for (k, chart) in charts.iter().enumerate() {
        let corner = [cell[0] * (k % columns) as f64, cell[1] * (k / columns) as f64];
        draw(&canvas, chart, [corner[0] + MARGIN[0], corner[1] + MARGIN[2]])?;
    }
    for (row, entries) in legend.iter().enumerate() {
        let y = below + LEGEND[0] * (row as f64 + 0.5);
        let mut x = MARGIN[0];
        for (series, width) in entries {
            sample(&canvas, series, [x, y])?;
            canvas.text([x + 38.0, y], &series.name, plain(12.0, (HPos::Left, VPos::Center)))?;
            x += width;
        }
    }
    canvas.finish()?;
    Ok(in_points(&text, size))
}

/// The first series of each name in rows of at most that width, each with the width of its entry.
fn legend(charts: &[Chart], width: f64) -> Vec<Vec<(&Series, f64)>> {
    let mut rows: Vec<Vec<(&Series, f64)>> = Vec::new();
    let mut names: Vec<&str> = vec![""];
    let mut left = 0.0;
    for series in charts.iter().flat_map(|chart| &chart.series) {
        if names.contains(&series.name.as_str()) || series.style == Style::Word {
            continue;
        }
        names.push(&series.name);
        let needed = 56.0 + LEGEND[1] * series.name.chars().count() as f64;
        match rows.last_mut().filter(|_| needed <= left) {
            Some(row) => row.push((series, needed)),
            None => {
                rows.push(vec![(series, needed)]);
                left = width;
            }
        }
        left -= needed;
    }
    rows
}

fn sample(canvas: &Canvas, series: &Series, [x, y]: [f64; 2]) -> Result<(), PlotError> {
    let points = match series.style {
        Style::Line | Style::Dashes | Style::Word => vec![[x, y], [x + 30.0, y]],
        Style::Discs | Style::Rings => vec![[x + 15.0, y]],
    };
    strokes(canvas, series, &points)
}

/// A series whose points are those of the sheet.
fn strokes(canvas: &Canvas, series: &Series, points: &[[f64; 2]]) -> Result<(), PlotError> {
    let [r, g, b] = series.colour;
    let colour = RGBColor(r, g, b);
    match series.style {
        Style::Line | Style::Dashes => {
            let pieces = points.split(|point| !(point[0].is_finite() && point[1].is_finite()));
            for piece in pieces.filter(|piece| piece.len() > 1) {
                match series.style {
                    Style::Line => canvas.line(piece, Pen(1.8, colour))?,
                    _ => canvas.dashed(piece, [6.0, 4.0], Pen(1.5, colour))?,
                }
            }
            Ok(())
        }
        Style::Discs | Style::Rings => points
            .iter()
            .try_for_each(|&point| canvas.mark(point, Mark::Disc, colour, series.style == Style::Discs)),
        Style::Word => points.iter().try_for_each(|&point| {
            let letters = Letters {
                colour,
                ..plain(12.0, (HPos::Center, VPos::Center))
            };
            canvas.text(point, &series.name, letters)
        }),
    }
}

fn draw(canvas: &Canvas, chart: &Chart, [left, top]: [f64; 2]) -> Result<(), PlotError> {
    let bold = Letters {
        bold: true,
        ..plain(13.5, (HPos::Left, VPos::Center))
    };
    canvas.text([left, top - 18.0], &chart.title, bold)?;
    let [mut x, mut y] = [0, 1].map(|axis| {
        let values = chart.series.iter().flat_map(|series| &series.points);
        Linear::holding(values.map(|point| point[axis]))
    });
    if chart.is_drawing {
        // One length both ways, the drawing in the middle.
        let scale = f64::max(x.extent() / FRAME[0], y.extent() / FRAME[1]);
        x = x.widened(scale * FRAME[0]);
        y = y.widened(scale * FRAME[1]);
    }
    let at = |point: &[f64; 2]| {
        [
            left + FRAME[0] * x.place(point[0]),
            top + FRAME[1] * (1.0 - y.place(point[1])),
        ]
    };
    let (right, bottom) = (left + FRAME[0], top + FRAME[1]);
    if !chart.is_drawing {
        for value in x.numbers() {
            let place = at(&[value, y.low])[0];
            canvas.line(&[[place, top], [place, bottom]], Pen(0.75, GRID))?;
            canvas.text(
                [place, bottom + 7.0],
                &x.told(value),
                plain(12.0, (HPos::Center, VPos::Top)),
            )?;
        }
        for value in y.numbers() {
            let place = at(&[x.low, value])[1];
            canvas.line(&[[left, place], [right, place]], Pen(0.75, GRID))?;
            canvas.text(
                [left - 8.0, place],
                &y.told(value),
                plain(12.0, (HPos::Right, VPos::Center)),
            )?;
        }
    }
    for series in &chart.series {
        let points: Vec<_> = series.points.iter().map(at).collect();
        strokes(canvas, series, &points)?;
    }
    if chart.is_drawing {
        return Ok(());
    }
    let corners = [[left, top], [right, top], [right, bottom], [left, bottom], [left, top]];
    canvas.line(&corners, Pen(1.0, INK))?;
    canvas.text(
        [0.5 * (left + right), bottom + 28.0],
        &chart.x,
        plain(13.0, (HPos::Center, VPos::Top)),
    )?;
    let upright = Letters {
        upright: true,
        ..plain(13.0, (HPos::Center, VPos::Center))
    };
    canvas.text([left - 58.0, 0.5 * (top + bottom)], &chart.y, upright)
}

/// A linear axis.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Linear {
    low: f64,
    high: f64,
}

impl Linear {
    /// The axis on which all values find room. Zero is its end where all are on one side of it and not far away.
    fn holding(values: impl Iterator<Item = f64>) -> Self {
        let (low, high) = values
            .filter(|value| value.is_finite())
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
                (low.min(value), high.max(value))
            });
        if low > high {
            return Self { low: 0.0, high: 1.0 };
        }
        let extent = match high - low {
            0.0 if low == 0.0 => 1.0,
            0.0 => low.abs(),
            extent => extent,
        };
        let room = ROOM * extent;
        let is_near = |end: f64, other: f64| {
            let part = end / other;
            (-ROUNDING..NEAR).contains(&part)
        };
        Self {
            low: if is_near(low, high) { 0.0 } else { low - room },
            high: if is_near(high, low) { 0.0 } else { high + room },
        }
    }

    fn extent(&self) -> f64 {
        self.high - self.low
    }

    /// Of another extent about the same middle.
    fn widened(&self, extent: f64) -> Self {
        let middle = 0.5 * (self.low + self.high);
        Self {
            low: middle - 0.5 * extent,
            high: middle + 0.5 * extent,
        }
    }

    /// Place of a value from 0 (low end) to 1.
    fn place(&self, value: f64) -> f64 {
        (value - self.low) / self.extent()
    }

    /// One, two or five times a power of ten.
    fn step(&self) -> f64 {
        let most = self.extent() / STEPS;
        let decade = 10f64.powf(most.log10().floor());
        [5.0, 2.0]
            .into_iter()
            .map(|digit| digit * decade)
            .find(|step| *step <= most)
            .unwrap_or(decade)
    }

    fn numbers(&self) -> impl Iterator<Item = f64> {
        let step = self.step();
        let first = (self.low / step - 1e-9).ceil() as i64;
        let last = (self.high / step + 1e-9).floor() as i64;
        (first..=last).map(move |k| step * k as f64)
    }

    /// A number with as many decimals as its step has.
    fn told(&self, value: f64) -> String {
        let decimals = (-self.step().log10().floor()).clamp(0.0, 12.0) as usize;
        format!("{value:.decimals$}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::to_png;

    fn series(name: &str, style: Style, points: &[[f64; 2]]) -> Series {
        Series {
            name: name.into(),
            style,
            colour: COLOURS[0],
            points: points.to_vec(),
        }
    }

    #[test]
    fn charts_tell_titles_axes_numbers_and_a_legend() {
        let points = [[1100.0, 0.05], [f64::NAN, 0.0], [1500.0, 0.1], [3200.0, 0.32]];
        let chart = Chart {
            title: "flow & power".into(),
            x: "n [1/min]".into(),
            y: "q".into(),
            is_drawing: false,
            series: vec![
                series("right", Style::Line, &points),
                series("printed", Style::Rings, &points),
            ],
        };
        let circle: Vec<_> = (0..=36)
            .map(|k| f64::from(k).to_radians() * 10.0)
            .map(|phi| [phi.cos(), 3.0 * phi.sin()])
            .collect();
        let drawing = Chart {
            title: "liner".into(),
            is_drawing: true,
            series: vec![
                series("right", Style::Dashes, &circle),
                series("O", Style::Word, &[[0.0, 0.0]]),
                series("", Style::Discs, &[[0.5, 0.0]]),
            ],
            ..Chart::default()
        };
        let svg = charts_to_svg(&[chart, drawing], 2).expect("a drawing");
        for part in [
            "flow &amp; power",
            "n [1/min]",
            "\n3000\n",
            "\n0.30\n",
            "\nprinted\n",
            "\nO\n",
            "liner",
        ] {
            assert!(svg.contains(part), "no {part} in\n{svg}");
        }
        assert_eq!(svg.matches("\nright\n").count(), 1);
        assert!(svg.starts_with("<svg width=\"1120\""));
        assert!(to_png(&svg).is_ok());
        assert!(charts_to_svg(&[], 3).is_ok());
    }

    #[test]
    fn axes_are_divided_into_round_steps() {
        let axis = Linear::holding([600.0, -1e-9, 3200.0].into_iter());
        assert_eq!(axis.low, 0.0);
        assert!((axis.high - 3360.0).abs() < 1e-6);
        assert_eq!(
            axis.numbers().map(|value| axis.told(value)).collect::<Vec<_>>(),
            ["0", "500", "1000", "1500", "2000", "2500", "3000"]
        );
        let narrow = Linear::holding([4.6, 4.8].into_iter());
        assert!(narrow.low > 4.5 && narrow.numbers().count() >= 4);
        assert_eq!(narrow.told(4.65), "4.65");
        for constant in [0.0, 3.0, -2.0] {
            let axis = Linear::holding([constant].into_iter());
            assert!(axis.extent() > 0.0 && (0.0..=1.0).contains(&axis.place(constant)));
        }
        assert!(Linear::holding([].into_iter()).extent() > 0.0);
        let wide = axis.widened(10_000.0);
        assert!((wide.extent() - 10_000.0).abs() < 1e-9 && (wide.place(1680.0) - 0.5).abs() < 1e-12);
    }
}
