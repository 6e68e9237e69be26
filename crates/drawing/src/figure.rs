//! The sheet: lines, areas, marks and labels, with a title and a description.

use svg::node::element::{ClipPath, Element, Group, Rectangle};
use svg::node::{Blob, Node};

use crate::path::{End, PathData, length};
use crate::text::Weight;
use crate::{Colour, Label, Letters, POINT, WHITE};

/// Typefaces, the first that the viewer has.
const TYPEFACES: &str = "Noto Sans, Helvetica, Arial, sans-serif";

/// How a line is stroked.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stroke {
    /// Without gaps.
    Solid,
    /// In dashes.
    Dashed,
    /// In dots.
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
        Self {
            width,
            colour,
            stroke: Stroke::Solid,
        }
    }

    /// With another stroke.
    #[must_use]
    pub fn stroked(self, stroke: Stroke) -> Self {
        Self { stroke, ..self }
    }
}

/// Which part of a label stands at its place, its capitals' middle at the height of the place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Anchor {
    /// Its left end.
    Left,
    /// Its middle.
    Centre,
    /// Its right end.
    Right,
    /// Its middle, read from below.
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

/// A sheet that is drawn on.
#[derive(Debug)]
pub struct Figure {
    size: [f64; 2],
    title: String,
    description: String,
    /// The innermost group is drawn on.
    groups: Vec<Vec<Box<dyn Node>>>,
    clips: usize,
}

impl Figure {
    /// An empty white sheet of that width and height [mm], with a title and a description for those who cannot see it.
    pub fn new(size: [f64; 2], title: &str, description: &str) -> Self {
        Self {
            size,
            title: title.to_owned(),
            description: description.to_owned(),
            groups: vec![Vec::new()],
            clips: 0,
        }
    }

    /// Width and height [mm].
    pub fn size(&self) -> [f64; 2] {
        self.size
    }

    /// Cuts the sheet off at this height [mm], or makes it longer.
    pub fn set_height(&mut self, height: f64) {
        self.size[1] = height;
    }

    /// Tells the names within this sheet from those of others on the same page.
    fn key(&self) -> u32 {
        let letters = self.title.bytes().chain(self.description.bytes());
        letters.fold(0x811c_9dc5, |key, letter| {
            (key ^ u32::from(letter)).wrapping_mul(0x0100_0193)
        })
    }

    fn push(&mut self, node: impl Into<Box<dyn Node>>) {
        if let Some(group) = self.groups.last_mut() {
            group.push(node.into());
        }
    }

    /// Draws only what falls into a rectangle `left, top, width, height`.
    pub fn clipped(&mut self, rectangle: [f64; 4], draw: impl FnOnce(&mut Self)) {
        self.clips += 1;
        let name = format!("clip-{:08x}-{}", self.key(), self.clips);
        let [x, y, width, height] = rectangle.map(length);
        let area = Rectangle::new()
            .set("x", x)
            .set("y", y)
            .set("width", width)
            .set("height", height);
        self.push(ClipPath::new().set("id", name.clone()).add(area));
        self.groups.push(Vec::new());
        draw(self);
        let mut group = Group::new().set("clip-path", format!("url(#{name})"));
        for node in self.groups.pop().unwrap_or_default() {
            group.append(node);
        }
        self.push(group);
    }

    /// Several lines with one pen.
    pub fn lines<L: IntoIterator<Item = [f64; 2]>>(&mut self, lines: impl IntoIterator<Item = L>, pen: Pen) {
        let mut path = PathData::default();
        lines.into_iter().for_each(|line| path.add(line, End::Open));
        self.stroke(path, pen);
    }

    /// A line through points.
    pub fn line(&mut self, points: &[[f64; 2]], pen: Pen) {
        self.lines([points.iter().copied()], pen);
    }

    /// A closed line through points.
    pub fn outline(&mut self, points: &[[f64; 2]], pen: Pen) {
        let mut path = PathData::default();
        path.add(points.iter().copied(), End::Closed);
        self.stroke(path, pen);
    }

    fn stroke(&mut self, path: PathData, pen: Pen) {
        let width = POINT * pen.width;
        let mut element = Element::new("path");
        element.assign("d", path.into_text());
        element.assign("fill", "none");
        element.assign("stroke", pen.colour.hex());
        element.assign("stroke-width", length(width));
        element.assign("stroke-linejoin", "round");
        match pen.stroke {
            Stroke::Solid => {}
            Stroke::Dashed => element.assign("stroke-dasharray", format!("{} {}", length(1.5), length(1.0))),
            Stroke::Dotted => {
                element.assign("stroke-linecap", "round");
                element.assign("stroke-dasharray", format!("0 {}", length(2.2 * width.max(0.25))));
            }
        }
        self.push(element);
    }

    /// An area within closed lines; a line that runs the other way round is the rim of a hole.
    pub fn area<L: IntoIterator<Item = [f64; 2]>>(&mut self, rims: impl IntoIterator<Item = L>, colour: Colour) {
        let mut path = PathData::default();
        rims.into_iter().for_each(|rim| path.add(rim, End::Closed));
        let text = path.into_text();
        if !text.is_empty() {
            let mut element = Element::new("path");
            element.assign("d", text);
            element.assign("fill", colour.hex());
            self.push(element);
        }
    }

    /// A polygon.
    pub fn polygon(&mut self, corners: &[[f64; 2]], colour: Colour) {
        self.area([corners.iter().copied()], colour);
    }

    /// A rectangle `left, top, width, height`.
    pub fn rectangle(&mut self, [left, top, width, height]: [f64; 4], colour: Colour) {
        let (right, bottom) = (left + width, top + height);
        self.polygon(&[[left, top], [right, top], [right, bottom], [left, bottom]], colour);
    }

    /// The outline of a rectangle `left, top, width, height`.
    pub fn frame(&mut self, [left, top, width, height]: [f64; 4], pen: Pen) {
        let (right, bottom) = (left + width, top + height);
        self.outline(&[[left, top], [right, top], [right, bottom], [left, bottom]], pen);
    }

    /// A disc with a rim.
    pub fn disc(&mut self, [x, y]: [f64; 2], radius: f64, fill: Colour, rim: Pen) {
        let mut element = Element::new("circle");
        element.assign("cx", length(x));
        element.assign("cy", length(y));
        element.assign("r", length(radius));
        element.assign("fill", fill.hex());
        element.assign("stroke", rim.colour.hex());
        element.assign("stroke-width", length(POINT * rim.width));
        self.push(element);
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
    pub fn text(&mut self, [x, y]: [f64; 2], label: &Label, letters: Letters, anchor: Anchor) {
        if label.is_empty() {
            return;
        }
        let drop = 0.5 * letters.capital();
        let mut element = Element::new("text");
        match anchor {
            Anchor::Upright => element.assign(
                "transform",
                format!("translate({} {})rotate(-90)", length(x + drop), length(y)),
            ),
            _ => {
                element.assign("x", length(x));
                element.assign("y", length(y + drop));
            }
        }
        match anchor {
            Anchor::Left => {}
            Anchor::Centre | Anchor::Upright => element.assign("text-anchor", "middle"),
            Anchor::Right => element.assign("text-anchor", "end"),
        }
        element.assign("font-size", length(POINT * letters.size));
        element.assign("fill", letters.colour.hex());
        if letters.weight == Weight::Bold {
            element.assign("font-weight", "bold");
        }
        if letters.halo > 0.0 {
            let mut halo = element.clone();
            halo.assign("stroke", WHITE.hex());
            halo.assign("stroke-width", length(letters.halo));
            halo.assign("stroke-linejoin", "round");
            halo.append(Blob::new(label.to_svg(letters)));
            halo.assign("aria-hidden", "true");
            self.push(halo);
        }
        element.append(Blob::new(label.to_svg(letters)));
        self.push(element);
    }

    /// The sheet as SVG.
    pub fn to_svg(&self) -> String {
        let [width, height] = self.size.map(length);
        let texts = [("title", &self.title), ("desc", &self.description)].map(|(name, text)| {
            let mut element = Element::new(name);
            element.append(Blob::new(Label::plain(text).to_svg(Letters::default())));
            element
        });
        let mut document = svg::Document::new()
            .set("width", format!("{width}mm"))
            .set("height", format!("{height}mm"))
            .set("viewBox", format!("0 0 {width} {height}"))
            .set("font-family", TYPEFACES)
            .set("role", "img");
        for element in texts {
            document.append(element);
        }
        let sheet = Rectangle::new()
            .set("width", width.clone())
            .set("height", height.clone())
            .set("fill", WHITE.hex());
        document.append(sheet);
        for node in self.groups.iter().flatten() {
            document.append(node.clone());
        }
        document.to_string() + "\n"
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::INK;

    #[test]
    fn a_sheet_states_its_size_title_and_description() {
        let draw = || {
            let mut figure = Figure::new([85.0, 40.5], "A <title>", "what \"it\" & that show");
            figure.clipped([1.0, 1.0, 10.0, 10.0], |figure| {
                figure.line(&[[0.0, 0.0], [20.0, 20.0]], Pen::new(0.5, INK))
            });
            for mark in [
                Mark::Disc,
                Mark::Ring,
                Mark::Square,
                Mark::Triangle,
                Mark::Diamond,
                Mark::Cross,
            ] {
                figure.mark([5.0, 5.0], mark, INK);
            }
            figure.text(
                [3.0, 3.0],
                &"a".into(),
                Letters::default().with_halo().bold(),
                Anchor::Upright,
            );
            figure.to_svg()
        };
        let svg = draw();
        for part in [
            "width=\"85mm\"",
            "height=\"40.5mm\"",
            "viewBox=\"0 0 85 40.5\"",
            "A &lt;title&gt;",
            "what \"it\" &amp; that show",
            "clip-path=\"url(#clip-",
            "role=\"img\"",
        ] {
            assert!(svg.contains(part), "no {part} in\n{svg}");
        }
        assert_eq!(svg, draw());
        assert!(crate::to_png(&svg).is_ok());
    }
}
