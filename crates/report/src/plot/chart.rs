//! Curves and marks over linear axes: several charts on one sheet, with one legend.

use plotters::style::RGBColor;

use super::axes::{Axis, Frame};
use super::canvas::{CENTRE, Canvas, LEFT, Letters, Mark, Pen, sheet};
use crate::Error;

/// Width of a chart and height of its frame [points].
const FRAME: [f64; 2] = [460.0, 300.0];
/// Left of a frame, right of it, above it, below it.
const MARGIN: [f64; 4] = [78.0, 22.0, 40.0, 58.0];
/// Height of a row of the legend, and the width of a letter there.
const LEGEND: [f64; 2] = [24.0, 7.4];
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
    /// What it is; empty: not in the legend. Series of one name share an entry.
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

/// Colours that the colour-blind can distinguish, after M. Okabe and K. Ito, Color Universal Design (2008).
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
/// [`Error::Format`].
pub fn charts_to_svg(charts: &[Chart], columns: usize) -> Result<String, Error> {
    let columns = columns.clamp(1, charts.len().max(1));
    let cell = [FRAME[0] + MARGIN[0] + MARGIN[1], FRAME[1] + MARGIN[2] + MARGIN[3]];
    let width = cell[0] * columns as f64;
    let legend = legend(charts, width - MARGIN[0] - MARGIN[1]);
    let below = cell[1] * charts.len().div_ceil(columns) as f64;
    let size = [width, below + LEGEND[0] * legend.len() as f64 + 8.0];
    sheet(size, |canvas| {
        for (k, chart) in charts.iter().enumerate() {
            let corner = [cell[0] * (k % columns) as f64, cell[1] * (k / columns) as f64];
            draw(canvas, chart, [corner[0] + MARGIN[0], corner[1] + MARGIN[2]])?;
        }
        for (row, entries) in legend.iter().enumerate() {
            let y = below + LEGEND[0] * (row as f64 + 0.5);
            let mut x = MARGIN[0];
            for (series, width) in entries {
                sample(canvas, series, [x, y])?;
                canvas.text([x + 38.0, y], &series.name, Letters::new(12.0, LEFT))?;
                x += width;
            }
        }
        Ok(())
    })
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

fn sample(canvas: &Canvas, series: &Series, [x, y]: [f64; 2]) -> Result<(), Error> {
    let points = match series.style {
        Style::Line | Style::Dashes | Style::Word => vec![[x, y], [x + 30.0, y]],
        Style::Discs | Style::Rings => vec![[x + 15.0, y]],
    };
    strokes(canvas, series, &points)
}

/// A series whose points are those of the sheet.
fn strokes(canvas: &Canvas, series: &Series, points: &[[f64; 2]]) -> Result<(), Error> {
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
        Style::Word => {
            let letters = Letters::new(12.0, CENTRE).coloured(colour);
            points
                .iter()
                .try_for_each(|&point| canvas.text(point, &series.name, letters))
        }
    }
}

fn draw(canvas: &Canvas, chart: &Chart, [left, top]: [f64; 2]) -> Result<(), Error> {
    canvas.text([left, top - 18.0], &chart.title, Letters::new(13.5, LEFT).bold())?;
    let [mut x, mut y] = [0, 1].map(|axis| {
        let values = chart.series.iter().flat_map(|series| &series.points);
        Axis::linear(values.map(|point| point[axis]))
    });
    let [width, height] = FRAME;
    if chart.is_drawing {
        // One length both ways, the drawing in the middle.
        let scale = f64::max(x.extent() / width, y.extent() / height);
        (x, y) = (x.widened(scale * width), y.widened(scale * height));
    }
    let frame = Frame {
        left,
        top,
        width,
        height,
        x,
        y,
    };
    if !chart.is_drawing {
        frame.draw_grid(canvas)?;
    }
    for series in &chart.series {
        let points: Vec<_> = series.points.iter().map(|point| frame.at(*point)).collect();
        strokes(canvas, series, &points)?;
    }
    match chart.is_drawing {
        true => Ok(()),
        false => frame.draw_frame(canvas, &chart.x, &chart.y),
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
}
