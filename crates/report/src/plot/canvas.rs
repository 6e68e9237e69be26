//! A sheet of vector graphics, in points of the screen.
//!
//! plotters writes whole numbers; eight of its units are one point, so that small triangles keep their shape.

use plotters::drawing::{DrawingArea, DrawingAreaErrorKind, IntoDrawingArea};
use plotters::element::{Circle, DashedPathElement, PathElement, Polygon, Text};
use plotters::prelude::SVGBackend;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color, FontFamily, FontStyle, FontTransform, IntoFont, RGBColor, ShapeStyle, TextStyle, WHITE};

use super::palette::INK;
use crate::Error;

/// Units of plotters in a point.
const UNITS: f64 = 8.0;
/// plotters writes sizes of letters in its own measure.
const LETTERS: f64 = 1.24;
/// Typefaces, the first that the viewer has.
const TYPEFACES: &str = "Noto Sans, Helvetica, Arial, sans-serif";

/// Width of a line in points and its colour.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pen(pub(super) f64, pub(super) RGBColor);

/// Which part of a text stands at its place: its left end, its right end, its middle, or the middle of its top.
pub(super) const LEFT: (HPos, VPos) = (HPos::Left, VPos::Center);
pub(super) const RIGHT: (HPos, VPos) = (HPos::Right, VPos::Center);
pub(super) const CENTRE: (HPos, VPos) = (HPos::Center, VPos::Center);
pub(super) const TOP: (HPos, VPos) = (HPos::Center, VPos::Top);

/// How a text is set.
#[derive(Clone, Copy)]
pub(super) struct Letters {
    size: f64,
    colour: RGBColor,
    anchor: (HPos, VPos),
    weight: FontStyle,
    upright: bool,
}

impl Letters {
    /// Letters of this height in points, by the part of the text that stands at its place.
    pub(super) fn new(size: f64, anchor: (HPos, VPos)) -> Self {
        Self {
            size,
            colour: INK,
            anchor,
            weight: FontStyle::Normal,
            upright: false,
        }
    }

    /// In this colour.
    pub(super) fn coloured(self, colour: RGBColor) -> Self {
        Self { colour, ..self }
    }

    /// In bold type.
    pub(super) fn bold(self) -> Self {
        let weight = FontStyle::Bold;
        Self { weight, ..self }
    }

    /// Read from below.
    pub(super) fn upright(self) -> Self {
        Self { upright: true, ..self }
    }
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

/// Draws on a white sheet of so many points; the text of the SVG.
pub(super) fn sheet(size: [f64; 2], draw: impl FnOnce(&Canvas) -> Result<(), Error>) -> Result<String, Error> {
    let mut text = String::new();
    let (width, height) = units(size);
    let area = SVGBackend::with_string(&mut text, (width as u32, height as u32)).into_drawing_area();
    area.fill(&WHITE).map_err(refused)?;
    let canvas = Canvas { area };
    draw(&canvas)?;
    canvas.area.present().map_err(refused)?;
    drop(canvas);
    // plotters gives the size in its units.
    let written = format!("width=\"{width}\" height=\"{height}\"");
    Ok(text.replacen(&written, &format!("width=\"{}\" height=\"{}\"", size[0], size[1]), 1))
}

/// The corners of a rectangle from its left top to its right bottom.
fn corners([left, top]: [f64; 2], [right, bottom]: [f64; 2]) -> [[f64; 2]; 5] {
    [[left, top], [right, top], [right, bottom], [left, bottom], [left, top]]
}

impl Canvas<'_> {
    /// The outline of a rectangle from its left top to its right bottom.
    pub(super) fn frame(&self, from: [f64; 2], to: [f64; 2]) -> Result<(), Error> {
        self.line(&corners(from, to), Pen(1.0, INK))
    }

    /// A filled rectangle from its left top to its right bottom.
    pub(super) fn rectangle(&self, from: [f64; 2], to: [f64; 2], colour: RGBColor) -> Result<(), Error> {
        self.polygon(&corners(from, to)[..4], colour)
    }

    /// A line through points.
    pub(super) fn line(&self, points: &[[f64; 2]], pen: Pen) -> Result<(), Error> {
        let points: Vec<_> = points.iter().copied().map(units).collect();
        self.area.draw(&PathElement::new(points, style(pen))).map_err(refused)
    }

    /// A line of dashes, which are `dash` points long and `gap` points apart.
    pub(super) fn dashed(&self, points: &[[f64; 2]], [dash, gap]: [f64; 2], pen: Pen) -> Result<(), Error> {
        let points: Vec<_> = points.iter().copied().map(units).collect();
        let [dash, gap] = [dash, gap].map(|length| (UNITS * length) as u32);
        let path = DashedPathElement::new(points, dash, gap, style(pen));
        self.area.draw(&path).map_err(refused)
    }

    /// A filled polygon.
    pub(super) fn polygon(&self, corners: &[[f64; 2]], colour: RGBColor) -> Result<(), Error> {
        let corners: Vec<_> = corners.iter().copied().map(units).collect();
        self.area.draw(&Polygon::new(corners, colour.filled())).map_err(refused)
    }

    /// A mark at a point, full or hollow.
    pub(super) fn mark(&self, [x, y]: [f64; 2], mark: Mark, colour: RGBColor, full: bool) -> Result<(), Error> {
        let fill = if full { colour } else { WHITE };
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
                disc(4.2, WHITE)?;
                disc(3.4, colour)?;
                return if full { Ok(()) } else { disc(2.2, WHITE) };
            }
            Mark::Square => around(&[[-3.2, -3.2], [3.2, -3.2], [3.2, 3.2], [-3.2, 3.2]]),
            Mark::Triangle => around(&[[0.0, -4.4], [4.1, 2.9], [-4.1, 2.9]]),
            Mark::Diamond => around(&[[0.0, -4.4], [4.4, 0.0], [0.0, 4.4], [-4.4, 0.0]]),
        };
        self.polygon(&corners, fill)?;
        let outline: Vec<_> = corners.iter().chain(&corners[..2]).copied().collect();
        let pen = if full { Pen(0.6, WHITE) } else { Pen(1.3, colour) };
        self.line(&outline, pen)
    }

    /// A text. Control characters, which no text of this kind may have, are left out.
    pub(super) fn text(&self, at: [f64; 2], text: &str, letters: Letters) -> Result<(), Error> {
        let (horizontal, vertical) = letters.anchor;
        let text: String = text.chars().filter(|letter| !letter.is_control()).collect();
        let font = (
            FontFamily::Name(TYPEFACES),
            UNITS * LETTERS * letters.size,
            letters.weight,
        )
            .into_font();
        let turn = if letters.upright {
            FontTransform::Rotate270
        } else {
            FontTransform::None
        };
        let style = TextStyle::from(font.transform(turn));
        let style = style.color(&letters.colour).pos(Pos::new(horizontal, vertical));
        self.area.draw(&Text::new(text, units(at), style)).map_err(refused)
    }
}

fn refused<E: std::error::Error + Send + Sync>(error: DrawingAreaErrorKind<E>) -> Error {
    Error::format("drawing")(error)
}
