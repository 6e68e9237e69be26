//! A crankshaft to scale: from the side, and along its axis, where the angles of its throws are seen.

use std::f64::consts::TAU;

use oilwedge_drawing::{
    Anchor, Colour, Figure, GREY, GRID, INK, Label, Letters, Mark, PURPLE, Pen, Polar, SMALLEST_LETTERS, Stroke,
    linear_steps, number,
};
use oilwedge_scene::{CrankshaftTable, ShaftPiece, ThrowShape};
use oilwedge_study::shaft::BearingReport;

use crate::shaft_view::ShaftView;

/// Margin around the drawing, and gap between both views [mm].
const MARGIN: f64 = 3.0;
const BETWEEN: f64 = 14.0;
/// Thickness of a shell over the radius of its journal.
const SHELL: f64 = 0.22;
/// Distance of the mark of a counterweight from the axis, over the radius of the crank.
const WEIGHT: f64 = 0.8;
/// Ticks along the axis, at most.
const TICKS: f64 = 8.0;
/// Throws whose angles differ by less are one behind the other [rad].
const ONE: f64 = 1e-6;
const STEEL: Colour = Colour([226, 229, 233]);
const WEB: Colour = Colour([203, 208, 214]);
const WALL: Colour = Colour([120, 150, 180]);

/// A throw as it is drawn.
#[derive(Debug, Clone, Copy)]
struct DrawnThrow {
    shape: ThrowShape,
    /// Axial position at which the first web of the throw begins [m].
    from: f64,
    /// Angle of the throw in the axes of the shaft, with the first throw that fires at 0 towards x [rad].
    angle: f64,
}

impl DrawnThrow {
    /// Extents of the webs [m].
    fn webs(&self) -> [[f64; 2]; 2] {
        let ThrowShape { web_thickness, pin_length, .. } = self.shape;
        let second = self.from + web_thickness + pin_length;
        [[self.from, self.from + web_thickness], [second, second + web_thickness]]
    }
}

/// A shaft and the places of its drawing.
struct DrawnShaft<'a> {
    shaft: &'a CrankshaftTable,
    radius: f64,
    throws: Vec<DrawnThrow>,
    /// Greatest radius of a straight piece [m].
    journal: f64,
    /// Millimetres on the sheet to a metre of the shaft.
    scale: f64,
    /// Where z = 0 and the axis are on the sheet [mm].
    origin: [f64; 2],
}

/// The drawing of a shaft; `None` where its scene cannot be read.
pub(super) fn shaft_figure(view: &ShaftView, width: f64) -> Option<Figure> {
    let scene = view.scene()?;
    let shaft = &scene.crankshaft;
    let radius = scene.crank.as_ref().map_or(0.0, |crank| crank.radius);
    let throws = throws(shaft);
    let diameters = shaft.pieces.iter().filter_map(|piece| match piece {
        ShaftPiece::Straight { diameter, .. } => Some(*diameter),
        ShaftPiece::Throw { .. } => None,
    });
    let journal = 0.5 * diameters.fold(0.0, f64::max);
    let swept = shaft.throw.map_or(0.0, |throw| radius + 0.5 * throw.pin_diameter);
    let half = f64::max(swept, (1.0 + SHELL) * journal);
    let room = width - 2.0 * MARGIN - BETWEEN;
    let [from, to] = extent(shaft, view.bearings());
    let scale = room / (to - from + 2.0 * half);
    let letters = Letters::sized(SMALLEST_LETTERS);
    let top = MARGIN + Letters::default().line() + 1.5 * letters.line();
    let drawn =
        DrawnShaft { shaft, radius, throws, journal, scale, origin: [MARGIN - scale * from, top + scale * half] };
    let title = format!("{}: the shaft", view.result.head.title);
    let description = "the shaft to scale from the side, with its bearings, and along its axis, with its throws";
    let mut figure = Figure::new([width, 0.0], &title, description);
    let head = Letters::default().bold();
    let title = Label::fitted(&title, head, width - 2.0 * MARGIN);
    figure.text([MARGIN, MARGIN + 0.3 * head.line()], &title, head, Anchor::Left);
    drawn.side(&mut figure, view.bearings(), top - 0.6 * letters.line());
    let below = drawn.origin[1] + scale * half;
    drawn.axis(&mut figure, below + 1.0);
    drawn.along(&mut figure, [width - MARGIN - scale * half, drawn.origin[1]]);
    if !shaft.counterweights.is_empty() {
        let note = "diamonds: counterweights, by their angle alone";
        let place = [width - MARGIN, below + 1.0 + 3.2 * letters.line()];
        figure.text(place, &Label::plain(note), letters.coloured(GREY), Anchor::Right);
    }
    figure.set_height(below + 1.0 + 4.0 * letters.line());
    Some(figure)
}

/// Where the drawing begins and ends along the axis [m]: bearings may stand out at the ends of the shaft.
fn extent(shaft: &CrankshaftTable, bearings: &[BearingReport]) -> [f64; 2] {
    let ends = bearings.iter().map(|bearing| {
        let half = 0.5 * bearing.geometry.length;
        [bearing.at - half, bearing.at + half]
    });
    ends.fold([0.0, shaft.length()], |[from, to], [low, high]| [from.min(low), to.max(high)])
}

fn throws(shaft: &CrankshaftTable) -> Vec<DrawnThrow> {
    let mut from = 0.0;
    let mut throws = Vec::new();
    for piece in &shaft.pieces {
        if let (ShaftPiece::Throw { fires_at }, Some(shape)) = (piece, shaft.throw) {
            throws.push(DrawnThrow { shape, from, angle: -fires_at });
        }
        from += shaft.length_of(piece);
    }
    throws
}

impl DrawnShaft<'_> {
    /// A place by z and x, with x upwards.
    fn at(&self, [z, x]: [f64; 2]) -> [f64; 2] {
        [self.origin[0] + self.scale * z, self.origin[1] - self.scale * x]
    }

    /// A box from z to z and from x to x.
    fn draw_box(&self, figure: &mut Figure, [from, to]: [f64; 2], [low, high]: [f64; 2], fill: Colour) {
        let [left, top] = self.at([from, high]);
        let rectangle = [left, top, self.scale * (to - from), self.scale * (high - low)];
        figure.rectangle(rectangle, fill);
        figure.frame(rectangle, Pen::new(0.5, INK));
    }

    /// The shaft from the side, x upwards, with the names of the bearings on a line.
    fn side(&self, figure: &mut Figure, bearings: &[BearingReport], line: f64) {
        for throw in &self.throws {
            let middle = self.radius * throw.angle.cos();
            let pin = 0.5 * throw.shape.pin_diameter;
            let [first, second] = throw.webs();
            self.draw_box(figure, [first[1], second[0]], [middle - pin, middle + pin], STEEL);
            let ends = [f64::min(-self.journal, middle - pin), f64::max(self.journal, middle + pin)];
            for web in [first, second] {
                self.draw_box(figure, web, ends, WEB);
            }
        }
        let mut from = 0.0;
        for piece in &self.shaft.pieces {
            let to = from + self.shaft.length_of(piece);
            if let ShaftPiece::Straight { diameter, .. } = piece {
                self.draw_box(figure, [from, to], [-0.5 * diameter, 0.5 * diameter], STEEL);
            }
            from = to;
        }
        self.draw_bearings(figure, bearings, line);
        for (throw, web, angle) in self.weights() {
            let [from, to] = throw.webs()[web];
            let place = [0.5 * (from + to), WEIGHT * self.radius * angle.cos()];
            figure.mark(self.at(place), Mark::Diamond, PURPLE);
        }
        let ends = [[-0.01 * self.shaft.length(), 0.0], [1.01 * self.shaft.length(), 0.0]];
        let pen = Pen::new(0.4, GREY).stroked(Stroke::Dashed);
        figure.line(&ends.map(|end| self.at(end)), pen);
    }

    fn draw_bearings(&self, figure: &mut Figure, bearings: &[BearingReport], line: f64) {
        let letters = Letters::sized(SMALLEST_LETTERS);
        let apart = bearings.windows(2).map(|pair| pair[1].at - pair[0].at);
        let room = self.scale * apart.fold(self.shaft.length(), f64::min) - 1.0;
        for bearing in bearings {
            let (z, radius, half) = (bearing.at, bearing.geometry.radius, 0.5 * bearing.geometry.length);
            for side in [-1.0, 1.0] {
                let ends = [side * radius, side * (1.0 + SHELL) * radius];
                let ends = [f64::min(ends[0], ends[1]), f64::max(ends[0], ends[1])];
                self.draw_box(figure, [z - half, z + half], ends, WALL);
            }
            let name = Label::fitted(&bearing.name, letters, room);
            let [x, _] = self.at([z, 0.0]);
            figure.text([x, line], &name, letters.bold(), Anchor::Centre);
        }
    }

    /// The counterweights: throw, web, and angle in the axes of the shaft.
    fn weights(&self) -> impl Iterator<Item = (&DrawnThrow, usize, f64)> {
        let weights = self.shaft.counterweights.iter().filter(|weight| weight.moment > 0.0);
        weights.filter_map(|weight| {
            let throw = self.throws.get(weight.throw)?;
            Some((throw, weight.web, throw.angle + weight.angle))
        })
    }

    /// Lengths along the axis, and the numbers of the throws.
    fn axis(&self, figure: &mut Figure, top: f64) {
        let letters = Letters::sized(SMALLEST_LETTERS);
        let length = self.shaft.length();
        let [left, _] = self.at([0.0, 0.0]);
        let [right, _] = self.at([length, 0.0]);
        let names = top + 0.5 * letters.line();
        for (number, throw) in (1..).zip(&self.throws) {
            let [first, second] = throw.webs();
            let [x, _] = self.at([0.5 * (first[0] + second[1]), 0.0]);
            let degrees = (-throw.angle).to_degrees();
            let room = self.scale * (second[1] - first[0]) + 4.0;
            let name = Label::fitted(&format!("throw {number}: {degrees:.0}\u{b0}"), letters, room);
            figure.text([x, names], &name, letters.coloured(GREY), Anchor::Centre);
        }
        let line = names + 0.8 * letters.line();
        figure.line(&[[left, line], [right, line]], Pen::new(0.5, INK));
        let step = linear_steps(1e3 * length, TICKS);
        let ticks = (0..).map(|k| step * f64::from(k)).take_while(|tick| *tick <= 1e3 * length);
        for tick in ticks {
            let [x, _] = self.at([1e-3 * tick, 0.0]);
            figure.line(&[[x, line], [x, line + 1.0]], Pen::new(0.5, INK));
            figure.text([x, line + 0.9 * letters.line()], &number(tick, step), letters, Anchor::Centre);
        }
        let name = Label::marked("*z*, mm, *x* upwards; throws by the crank angle at which they fire");
        figure.text([left, line + 1.9 * letters.line()], &name, letters, Anchor::Left);
    }

    /// The shaft along its axis at the crank angle 0, x to the right as in polar diagrams.
    fn along(&self, figure: &mut Figure, centre: [f64; 2]) {
        let letters = Letters::sized(SMALLEST_LETTERS).with_halo();
        let axes = Polar { centre, base: 0.0, scale: self.scale };
        let pin = self.shaft.throw.map_or(0.0, |throw| 0.5 * throw.pin_diameter);
        let reach = self.scale * f64::max(self.radius + pin, (1.0 + SHELL) * self.journal);
        for (turn, name) in [(0.0, "*x*"), (0.25, "*y*")] {
            let angle = TAU * turn;
            let ends = [axes.point(angle + TAU / 2.0, reach), axes.point(angle, reach)];
            figure.line(&ends, Pen::new(0.4, GRID));
            figure.text(axes.point(angle, reach + 2.0), &Label::marked(name), letters.coloured(GREY), Anchor::Centre);
        }
        for throw in &self.throws {
            let pin = self.scale * 0.5 * throw.shape.pin_diameter;
            let at = axes.point(throw.angle, self.scale * self.radius);
            figure.line(&[centre, at], Pen::new(4.0, WEB));
            figure.disc(at, pin, STEEL, Pen::new(0.6, INK));
        }
        figure.disc(centre, self.scale * self.journal, STEEL, Pen::new(0.6, INK));
        for (_, _, angle) in self.weights() {
            figure.mark(axes.point(angle, WEIGHT * self.scale * self.radius), Mark::Diamond, PURPLE);
        }
        for (names, angle) in self.groups() {
            // Beyond the middle of the pin, where no counterweight is marked.
            let place = axes.point(angle, self.scale * (self.radius + 0.4 * pin));
            figure.text(place, &Label::plain(&names.join(", ")), letters.bold(), Anchor::Centre);
        }
        let turning = 0.55 * self.scale * self.journal;
        let arc = axes.arc(turning, 0.2, 0.75 * TAU);
        figure.line(&arc, Pen::new(0.6, INK));
        if let [.., before, tip] = arc.as_slice() {
            figure.arrow_head(*before, *tip, 1.6, INK);
        }
    }

    /// The numbers of throws at each angle.
    fn groups(&self) -> Vec<(Vec<String>, f64)> {
        let mut groups: Vec<(Vec<String>, f64)> = Vec::new();
        for (number, throw) in (1..).zip(&self.throws) {
            let apart = |angle: f64| 1.0 - (angle - throw.angle).cos();
            match groups.iter_mut().find(|(_, angle)| apart(*angle) < ONE) {
                Some((names, _)) => names.push(format!("{number}")),
                None => groups.push((vec![format!("{number}")], throw.angle)),
            }
        }
        groups
    }
}
