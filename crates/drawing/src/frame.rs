//! The frame that two axes make, and the colour bar of a map.

use crate::{Anchor, Axis, Colour, ColourMap, Figure, GRID, INK, Label, Letters, Pen, Rectangle, SMALLEST_LETTERS};

/// Gap between the frame and numbers, and between those and the name of an axis [mm].
const GAP: f64 = 1.2;
/// Length of a tick [mm].
const TICK: f64 = 0.8;
/// Room of a tick across and upwards [mm].
const ACROSS: f64 = 14.0;
const UPWARDS: f64 = 8.5;
/// Width of a colour bar, and its distance from the frame [mm].
const BAR: [f64; 2] = [3.0, 2.5];
/// Room of a number beside a colour bar [mm].
const BAR_STEP: f64 = 5.0;
/// Lines of a grid within decades.
const FINE: Colour = Colour([241, 241, 241]);

/// Axes around a rectangle of the sheet.
#[derive(Debug, Clone, PartialEq)]
pub struct PlotFrame {
    /// Rectangle that the frame encloses on the sheet [mm].
    pub inner: Rectangle,
    /// The axis across.
    pub x: Axis,
    /// The axis upwards.
    pub y: Axis,
}

/// Letters of numbers beside an axis.
fn numbers() -> Letters {
    Letters::sized(SMALLEST_LETTERS)
}

fn widest(ticks: &[(f64, Label)]) -> f64 {
    ticks.iter().map(|(_, label)| label.width(numbers())).fold(0.0, f64::max)
}

impl PlotFrame {
    /// The frame whose axes, numbers and names fill the rectangle `outer`.
    pub fn within(outer: Rectangle, x: Axis, y: Axis) -> Self {
        let [left, top, width, height] = outer;
        let mut frame = Self { inner: [left, top, width, height], x, y };
        let bottom = frame.bottom_margin();
        frame.inner[3] = height - bottom;
        let beside = frame.left_margin();
        let beyond = 0.5 * frame.last_number();
        frame.inner = [left + beside, top, width - beside - beyond, height - bottom];
        frame
    }

    /// Room left of the frame for numbers and name [mm].
    pub fn left_margin(&self) -> f64 {
        let name = if self.y.name.is_empty() { 0.0 } else { GAP + Letters::default().line() };
        TICK + GAP + widest(&self.y_ticks()) + name
    }

    /// Room below the frame for numbers and name [mm].
    pub fn bottom_margin(&self) -> f64 {
        let name = if self.x.name.is_empty() { 0.0 } else { GAP + Letters::default().line() };
        TICK + GAP + numbers().capital() + name
    }

    fn last_number(&self) -> f64 {
        self.x_ticks().last().map_or(0.0, |(_, label)| label.width(numbers()))
    }

    fn x_ticks(&self) -> Vec<(f64, Label)> {
        // As many as fit beside each other.
        let mut most = (self.inner[2] / ACROSS).max(2.0);
        loop {
            let ticks = self.x.ticks(most);
            let room = self.inner[2] / ticks.len().max(1) as f64;
            if widest(&ticks) + 1.5 < room || most <= 2.0 {
                return ticks;
            }
            most = (most - 1.0).max(2.0);
        }
    }

    fn y_ticks(&self) -> Vec<(f64, Label)> {
        self.y.ticks((self.inner[3] / UPWARDS).max(2.0))
    }

    /// Place on the sheet [mm] of a point of values.
    pub fn at(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [left, top, width, height] = self.inner;
        [left + width * self.x.place(x), top + height * (1.0 - self.y.place(y))]
    }

    /// Lines of the grid, which belong below the curves.
    pub fn draw_grid(&self, figure: &mut Figure) {
        let [left, top, width, height] = self.inner;
        let upright = |value: f64| {
            let x = left + width * self.x.place(value);
            [[x, top], [x, top + height]]
        };
        let level = |value: f64| {
            let y = top + height * (1.0 - self.y.place(value));
            [[left, y], [left + width, y]]
        };
        let fine = self.x.within_decades().into_iter().map(upright);
        let fine: Vec<_> = fine.chain(self.y.within_decades().into_iter().map(level)).collect();
        if !fine.is_empty() {
            figure.lines(fine, Pen::new(0.5, FINE));
        }
        let lines = self.x_ticks().into_iter().map(|(value, _)| upright(value));
        figure.lines(lines.chain(self.y_ticks().into_iter().map(|(value, _)| level(value))), Pen::new(0.5, GRID));
    }

    /// The frame, its ticks, numbers and names, which belong above the curves.
    pub fn draw(&self, figure: &mut Figure) {
        let [left, top, width, height] = self.inner;
        let (bottom, pen) = (top + height, Pen::new(0.5, INK));
        figure.frame(self.inner, pen);
        let mut strokes = Vec::new();
        for (value, label) in self.x_ticks() {
            let x = left + width * self.x.place(value);
            strokes.push([[x, bottom], [x, bottom + TICK]]);
            let y = bottom + TICK + GAP + 0.5 * numbers().capital();
            figure.text([x, y], &label, numbers(), Anchor::Centre);
        }
        for (value, label) in self.y_ticks() {
            let y = top + height * (1.0 - self.y.place(value));
            strokes.push([[left - TICK, y], [left, y]]);
            figure.text([left - TICK - GAP, y], &label, numbers(), Anchor::Right);
        }
        figure.lines(strokes, pen);
        let below = bottom + self.bottom_margin() - 0.5 * Letters::default().line();
        figure.text([left + 0.5 * width, below], &self.x.name, Letters::default(), Anchor::Centre);
        let beside = left - self.left_margin() + 0.5 * Letters::default().line();
        figure.text([beside, top + 0.5 * height], &self.y.name, Letters::default(), Anchor::Upright);
    }
}

/// A bar with the colours of the values of `axis`, at the right of the rectangle `beside`, and its name above it;
/// returns its width [mm].
///
/// `edges` are the values between bands of one colour; without any the colours change evenly.
pub fn draw_colour_bar(figure: &mut Figure, beside: Rectangle, axis: &Axis, map: ColourMap, edges: &[f64]) -> f64 {
    let [left, top, width, height] = beside;
    let x = left + width + BAR[1];
    let places: Vec<f64> = match edges.is_empty() {
        true => (0..=64).map(|k| f64::from(k) / 64.0).collect(),
        false => {
            let inner = edges.iter().map(|edge| axis.place(*edge)).filter(|place| (1e-9..1.0 - 1e-9).contains(place));
            [0.0].into_iter().chain(inner).chain([1.0]).collect()
        }
    };
    for pair in places.windows(2) {
        // Each reaches up to the top, so that no seam shows between it and the next.
        let colour = map.colour(0.5 * (pair[0] + pair[1]));
        figure.rectangle([x, top, BAR[0], height * (1.0 - pair[0])], colour);
    }
    figure.frame([x, top, BAR[0], height], Pen::new(0.5, INK));
    let ticks = axis.ticks((height / BAR_STEP).max(2.0));
    let right = x + BAR[0];
    let place = |value: f64| top + height * (1.0 - axis.place(value));
    figure.lines(
        ticks.iter().map(|(value, _)| [[right, place(*value)], [right + TICK, place(*value)]]),
        Pen::new(0.5, INK),
    );
    for (value, label) in &ticks {
        figure.text([right + TICK + 0.6, place(*value)], label, numbers(), Anchor::Left);
    }
    BAR[1] + BAR[0] + TICK + 0.6 + widest(&ticks)
}
