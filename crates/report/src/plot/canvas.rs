//! A sheet of vector graphics, in points of the screen.
//!
//! plotters writes whole numbers; eight of its units are one point, so that small triangles keep their shape.

use plotters::drawing::{DrawingArea, DrawingAreaErrorKind, IntoDrawingArea};
use plotters::element::{Circle, DashedPathElement, PathElement, Polygon, Text};
use plotters::prelude::SVGBackend;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color, FontFamily, FontStyle, FontTransform, IntoFont, RGBColor, ShapeStyle, TextStyle};

use super::PlotError;

/// Units of plotters in a point.
const UNITS: f64 = 8.0;
/// plotters writes sizes of letters in its own measure.
const LETTERS: f64 = 1.24;
/// Typefaces, the first that the viewer has.
const TYPEFACES: &str = "Noto Sans, Helvetica, Arial, sans-serif";

/// Width of a line in points and its colour.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pen(pub(super) f64, pub(super) RGBColor);

/// How a text is set.
#[derive(Clone, Copy)]
pub(super) struct Letters {
    /// Height in points.
    pub(super) size: f64,
    pub(super) colour: RGBColor,
    /// Which part of the text stands at its place.
    pub(super) anchor: (HPos, VPos),
    pub(super) bold: bool,
    /// Read from below.
    pub(super) upright: bool,
}

/// What marks a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Mark {
    Disc,
    Square,
    Triangle,
    Diamond,
}

/// The sheet.
pub(super) struct Canvas<'a> {
    area: DrawingArea<SVGBackend<'a>, plotters::coord::Shift>,
}

fn units([x, y]: [f64; 2]) -> (i32, i32) {
    ((UNITS * x).round() as i32, (UNITS * y).round() as i32)
}

fn style(Pen(width, colour): Pen) -> ShapeStyle {
    colour.stroke_width((UNITS * width).round().max(1.0) as u32)
}

impl<'a> Canvas<'a> {
    /// A white sheet of so many points, written to `text`.
    pub(super) fn new(text: &'a mut String, [width, height]: [f64; 2]) -> Result<Self, PlotError> {
        let (width, height) = units([width, height]);
        let area = SVGBackend::with_string(text, (width as u32, height as u32)).into_drawing_area();
        area.fill(&plotters::style::WHITE).map_err(refused)?;
        Ok(Self { area })
    }

    /// Ends the text.
    pub(super) fn finish(self) -> Result<(), PlotError> {
        self.area.present().map_err(refused)
    }

    /// A line through points.
    pub(super) fn line(&self, points: &[[f64; 2]], pen: Pen) -> Result<(), PlotError> {
        let points: Vec<_> = points.iter().copied().map(units).collect();
        self.area.draw(&PathElement::new(points, style(pen))).map_err(refused)
    }

    /// A line of dashes, which are `dash` points long and `gap` points apart.
    pub(super) fn dashed(&self, points: &[[f64; 2]], [dash, gap]: [f64; 2], pen: Pen) -> Result<(), PlotError> {
        let points: Vec<_> = points.iter().copied().map(units).collect();
        let [dash, gap] = [dash, gap].map(|length| (UNITS * length) as u32);
        let path = DashedPathElement::new(points, dash, gap, style(pen));
        self.area.draw(&path).map_err(refused)
    }

    /// A filled polygon.
    pub(super) fn polygon(&self, corners: &[[f64; 2]], colour: RGBColor) -> Result<(), PlotError> {
        let corners: Vec<_> = corners.iter().copied().map(units).collect();
        self.area.draw(&Polygon::new(corners, colour.filled())).map_err(refused)
    }

    /// A mark at a point, full or hollow.
    pub(super) fn mark(&self, [x, y]: [f64; 2], mark: Mark, colour: RGBColor, full: bool) -> Result<(), PlotError> {
        let white = plotters::style::WHITE;
        let fill = if full { colour } else { white };
        let around = |corners: &[[f64; 2]]| -> Vec<[f64; 2]> {
            corners.iter().map(|corner| [x + corner[0], y + corner[1]]).collect()
        };
        let corners = match mark {
            Mark::Disc => {
                let disc = |radius: f64, colour: RGBColor| {
                    let radius = (UNITS * radius).round() as i32;
                    let disc = Circle::new(units([x, y]), radius, colour.filled());
                    self.area.draw(&disc).map_err(refused)
                };
                disc(4.2, white)?;
                disc(3.4, colour)?;
                return if full { Ok(()) } else { disc(2.2, white) };
            }
            Mark::Square => around(&[[-3.2, -3.2], [3.2, -3.2], [3.2, 3.2], [-3.2, 3.2]]),
            Mark::Triangle => around(&[[0.0, -4.4], [4.1, 2.9], [-4.1, 2.9]]),
            Mark::Diamond => around(&[[0.0, -4.4], [4.4, 0.0], [0.0, 4.4], [-4.4, 0.0]]),
        };
        self.polygon(&corners, fill)?;
        let outline: Vec<_> = corners.iter().chain(&corners[..2]).copied().collect();
        self.line(
            &outline,
            Pen(if full { 0.6 } else { 1.3 }, if full { white } else { colour }),
        )
    }

    /// A text. Control characters, which no text of this kind may have, are left out.
    pub(super) fn text(&self, at: [f64; 2], text: &str, letters: Letters) -> Result<(), PlotError> {
        let Letters {
            size,
            colour,
            anchor: (horizontal, vertical),
            bold,
            upright,
        } = letters;
        let text: String = text.chars().filter(|letter| !letter.is_control()).collect();
        let weight = if bold { FontStyle::Bold } else { FontStyle::Normal };
        let turn = if upright {
            FontTransform::Rotate270
        } else {
            FontTransform::None
        };
        let font = (FontFamily::Name(TYPEFACES), UNITS * LETTERS * size, weight)
            .into_font()
            .transform(turn);
        let style = TextStyle::from(font).color(&colour).pos(Pos::new(horizontal, vertical));
        self.area.draw(&Text::new(text, units(at), style)).map_err(refused)
    }
}

/// The text of a finished sheet with its size told in points.
pub(super) fn in_points(text: &str, size: [f64; 2]) -> String {
    let (width, height) = units(size);
    let told = format!("width=\"{width}\" height=\"{height}\"");
    let wanted = format!("width=\"{}\" height=\"{}\"", size[0], size[1]);
    text.replacen(&told, &wanted, 1)
}

fn refused<E: std::error::Error + Send + Sync>(error: DrawingAreaErrorKind<E>) -> PlotError {
    PlotError::Drawing(error.to_string())
}
