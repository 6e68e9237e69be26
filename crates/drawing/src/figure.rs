//! The sheet: lines, areas, marks and labels, with a title and a description.

use crate::path::{End, Polylines};
use crate::{Colour, Label, Letters, POINT, WHITE};

/// A rectangle on the sheet: left, top, width, height [mm].
pub type Rectangle = [f64; 4];

/// How a line is stroked.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stroke {
    /// A line without gaps.
    Solid,
    /// A line of dashes.
    Dashed,
    /// A line of dots.
    Dotted,
}

/// A line's width [points], colour and stroke.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pen {
    /// Width [points].
    pub width: f64,
    /// Colour.
    pub colour: Colour,
    /// Stroke.
    pub stroke: Stroke,
}

impl Pen {
    /// A solid line.
    pub fn new(width: f64, colour: Colour) -> Self {
        Self { width, colour, stroke: Stroke::Solid }
    }

    /// The pen with another stroke.
    #[must_use]
    pub fn stroked(self, stroke: Stroke) -> Self {
        Self { stroke, ..self }
    }

    /// Width [mm].
    pub(crate) fn breadth(self) -> f64 {
        POINT * self.width
    }

    /// Lengths of a stroke and of the gap behind it [mm]; strokes of no length are round dots.
    pub(crate) fn dashes(self) -> Option<[f64; 2]> {
        match self.stroke {
            Stroke::Solid => None,
            Stroke::Dashed => Some([1.5, 1.0]),
            Stroke::Dotted => Some([0.0, 2.2 * self.breadth().max(0.25)]),
        }
    }
}

/// Which part of a label stands at its place, its capitals' middle at the height of the place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Anchor {
    /// The left end of the label.
    Left,
    /// The middle of the label.
    Centre,
    /// The right end of the label.
    Right,
    /// The middle of a label that is read from below.
    Upright,
}

/// What marks a point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mark {
    /// A full disc.
    Disc,
    /// A hollow disc.
    Ring,
    /// A full square.
    Square,
    /// A full triangle.
    Triangle,
    /// A hollow diamond.
    Diamond,
    /// A cross.
    Cross,
}

/// What a sheet is made of; SVG and PNG are drawn of the same list.
#[derive(Debug)]
pub(crate) enum Primitive {
    /// Lines.
    Lines(Polylines, Pen),
    /// The area within closed lines, by their winding number.
    Area(Polylines, Colour),
    /// A disc: centre and radius [mm], colour and rim.
    Disc([f64; 2], f64, Colour, Pen),
    /// A label at its place [mm].
    Text([f64; 2], Label, Letters, Anchor),
    /// What falls into a rectangle of others.
    Clipped(Rectangle, Vec<Primitive>),
}

/// A sheet that is drawn on.
#[derive(Debug)]
pub struct Figure {
    pub(crate) size: [f64; 2],
    pub(crate) title: String,
    pub(crate) description: String,
    /// The uppermost last.
    pub(crate) primitives: Vec<Primitive>,
}

impl Figure {
    /// An empty white sheet of that width and height [mm], with a title and a description for those who cannot see it.
    pub fn new(size: [f64; 2], title: &str, description: &str) -> Self {
        Self { size, title: title.to_owned(), description: description.to_owned(), primitives: Vec::new() }
    }

    /// Width and height [mm].
    pub fn size(&self) -> [f64; 2] {
        self.size
    }

    /// Cuts the sheet off at this height [mm], or makes it longer.
    pub fn set_height(&mut self, height: f64) {
        self.size[1] = height;
    }

    /// Draws only what falls into a rectangle.
    pub fn clipped(&mut self, rectangle: Rectangle, draw: impl FnOnce(&mut Self)) {
        let below = std::mem::take(&mut self.primitives);
        draw(self);
        let within = std::mem::replace(&mut self.primitives, below);
        self.primitives.push(Primitive::Clipped(rectangle, within));
    }

    /// Several lines with one pen.
    pub fn lines<L: IntoIterator<Item = [f64; 2]>>(&mut self, lines: impl IntoIterator<Item = L>, pen: Pen) {
        let lines = Polylines::new(lines, End::Open);
        self.primitives.push(Primitive::Lines(lines, pen));
    }

    /// A line through points.
    pub fn line(&mut self, points: &[[f64; 2]], pen: Pen) {
        self.lines([points.iter().copied()], pen);
    }

    /// A closed line through points.
    pub fn outline(&mut self, points: &[[f64; 2]], pen: Pen) {
        let outline = Polylines::new([points.iter().copied()], End::Closed);
        self.primitives.push(Primitive::Lines(outline, pen));
    }

    /// An area within closed lines; a line that runs the other way round is the rim of a hole.
    pub fn area<L: IntoIterator<Item = [f64; 2]>>(&mut self, rims: impl IntoIterator<Item = L>, colour: Colour) {
        let rims = Polylines::new(rims, End::Closed);
        if !rims.lines.is_empty() {
            self.primitives.push(Primitive::Area(rims, colour));
        }
    }

    /// A polygon.
    pub fn polygon(&mut self, corners: &[[f64; 2]], colour: Colour) {
        self.area([corners.iter().copied()], colour);
    }

    /// A rectangle.
    pub fn rectangle(&mut self, [left, top, width, height]: Rectangle, colour: Colour) {
        let (right, bottom) = (left + width, top + height);
        self.polygon(&[[left, top], [right, top], [right, bottom], [left, bottom]], colour);
    }

    /// The outline of a rectangle.
    pub fn frame(&mut self, [left, top, width, height]: Rectangle, pen: Pen) {
        let (right, bottom) = (left + width, top + height);
        self.outline(&[[left, top], [right, top], [right, bottom], [left, bottom]], pen);
    }

    /// A disc with a rim.
    pub fn disc(&mut self, centre: [f64; 2], radius: f64, fill: Colour, rim: Pen) {
        self.primitives.push(Primitive::Disc(centre, radius, fill, rim));
    }

    /// A mark with a white rim.
    pub fn mark(&mut self, [x, y]: [f64; 2], mark: Mark, colour: Colour) {
        let around = |corners: &[[f64; 2]]| -> Vec<[f64; 2]> {
            corners.iter().map(|corner| [x + corner[0], y + corner[1]]).collect()
        };
        match mark {
            Mark::Disc => self.disc([x, y], 0.95, colour, Pen::new(0.6, WHITE)),
            Mark::Ring => self.disc([x, y], 0.85, WHITE, Pen::new(1.0, colour)),
            Mark::Square | Mark::Triangle => {
                let corners = match mark {
                    Mark::Square => around(&[[-0.85, -0.85], [0.85, -0.85], [0.85, 0.85], [-0.85, 0.85]]),
                    _ => around(&[[0.0, -1.2], [1.1, 0.75], [-1.1, 0.75]]),
                };
                self.outline(&corners, Pen::new(1.2, WHITE));
                self.polygon(&corners, colour);
            }
            Mark::Diamond => {
                let corners = around(&[[0.0, -1.15], [1.15, 0.0], [0.0, 1.15], [-1.15, 0.0]]);
                self.polygon(&corners, WHITE);
                self.outline(&corners, Pen::new(1.0, colour));
            }
            Mark::Cross => {
                let strokes = [around(&[[-1.1, -1.1], [1.1, 1.1]]), around(&[[-1.1, 1.1], [1.1, -1.1]])];
                self.lines(strokes.clone(), Pen::new(2.6, WHITE));
                self.lines(strokes, Pen::new(1.2, colour));
            }
        }
    }

    /// The head of an arrow that ends at `tip` and comes from the direction of `from`.
    pub fn arrow_head(&mut self, from: [f64; 2], tip: [f64; 2], size: f64, colour: Colour) {
        let (dx, dy) = (tip[0] - from[0], tip[1] - from[1]);
        let norm = dx.hypot(dy).max(1e-9);
        let (ux, uy) = (dx / norm * size, dy / norm * size);
        let wing = |side: f64| [tip[0] - ux - side * 0.4 * uy, tip[1] - uy + side * 0.4 * ux];
        self.polygon(&[tip, wing(1.0), wing(-1.0)], colour);
    }

    /// A label.
    pub fn text(&mut self, at: [f64; 2], label: &Label, letters: Letters, anchor: Anchor) {
        if !label.is_empty() {
            self.primitives.push(Primitive::Text(at, label.clone(), letters, anchor));
        }
    }
}
