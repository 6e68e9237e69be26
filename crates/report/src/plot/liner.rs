//! The unrolled liner on the sheet: to scale, the angle to the right and the axis upwards.

use oilwedge_drawing::{Axis, Figure, Label, Patch, PlotFrame, Rectangle, Scale};

/// Greatest and least height of a map [mm].
const HIGHEST: f64 = 150.0;
const LOWEST: f64 = 12.0;

/// Nodes of a quadratic triangle on the unrolled liner [m], continuous across the seam of a ring.
pub(crate) type TriangleNodes = [[f64; 2]; 6];

/// The part of the plane that is shown.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct LinerWindow {
    radius: f64,
    low: [f64; 2],
    high: [f64; 2],
    /// Length of the circumference of a ring.
    period: Option<f64>,
}

impl LinerWindow {
    /// The liner of radius R [m] that triangles cover. A ring, whose circumference is `period`, is cut at `cut` [m] or
    /// where its triangles begin.
    pub(super) fn of(cells: &[TriangleNodes], radius: f64, period: Option<f64>, cut: Option<f64>) -> Self {
        let points = || cells.iter().flatten();
        let end = |d: usize, of: fn(f64, f64) -> f64, start: f64| points().map(|point| point[d]).fold(start, of);
        let mut low = [0, 1].map(|d| end(d, f64::min, f64::INFINITY));
        let mut high = [0, 1].map(|d| end(d, f64::max, f64::NEG_INFINITY));
        if let Some(period) = period {
            low[0] = cut.unwrap_or(low[0]);
            high[0] = low[0] + period;
        }
        if cells.is_empty() {
            (low, high) = ([0.0; 2], [radius; 2]);
        }
        Self { radius, low, high, period }
    }

    /// The liner of radius R [m] between two angles `from` and `to` [rad], where triangles may be any number of turns
    /// away; cut off at both ends.
    pub(super) fn between(cells: &[TriangleNodes], radius: f64, [from, to]: [f64; 2]) -> Self {
        let period = Some(std::f64::consts::TAU * radius);
        let whole = Self::of(cells, radius, period, Some(radius * from));
        let high = [radius * to, whole.high[1]];
        Self { high, ..whole }
    }

    /// Angles [rad] at which the liner begins and ends.
    pub(super) fn angles(&self) -> [f64; 2] {
        [self.low[0] / self.radius, self.high[0] / self.radius]
    }

    /// The frame of the map within a rectangle whose height is not limited, to scale. A needle or a washer, which would
    /// be too high or too low for a sheet, is narrower or stretched.
    pub(super) fn frame(&self, [left, top, width, _]: Rectangle) -> PlotFrame {
        let degrees = |x: f64| (x / self.radius).to_degrees();
        let x = Axis::between(
            degrees(self.low[0]),
            degrees(self.high[0]),
            Scale::Degrees,
            Label::plain("angle on the liner"),
        );
        let name = Label::marked("axis *z*, mm");
        let y = Axis::between(1e3 * self.low[1], 1e3 * self.high[1], Scale::Linear, name);
        let mut frame = PlotFrame::within([left, top, width, 60.0], x, y);
        let ratio = (self.high[1] - self.low[1]) / (self.high[0] - self.low[0]);
        let wanted = frame.inner[2] * ratio;
        frame.inner[3] = wanted.clamp(LOWEST, HIGHEST);
        if wanted > HIGHEST {
            frame.inner[2] = f64::max(HIGHEST / ratio, LOWEST);
        }
        frame
    }

    /// How many times the axis is longer in the frame than to scale; one unless the liner is too low.
    pub(super) fn stretch(&self, frame: &PlotFrame) -> f64 {
        let [across, upwards] = [0, 1].map(|d| frame.inner[2 + d] / (self.high[d] - self.low[d]));
        upwards / across
    }

    /// Place on the sheet of a point of the liner [m].
    pub(super) fn at(&self, frame: &PlotFrame, [x, z]: [f64; 2]) -> [f64; 2] {
        frame.at([(x / self.radius).to_degrees(), 1e3 * z])
    }

    /// The shifts [m] by which something between `from` and `to` [m] along the circumference must be drawn: of a ring
    /// twice where it crosses the cut.
    pub(super) fn shifts(&self, from: f64, to: f64) -> Vec<f64> {
        let Some(period) = self.period else { return vec![0.0] };
        let slack = 1e-9 * period;
        let first = ((self.low[0] - to + slack) / period).ceil() as i64;
        let last = ((self.high[0] - from - slack) / period).floor() as i64;
        (first..=last).map(|turn| turn as f64 * period).collect()
    }

    /// The triangles with their values on the sheet; one that the cut crosses is there on both sides.
    pub(super) fn patches(
        &self,
        frame: &PlotFrame,
        cells: &[TriangleNodes],
        values: impl Fn(usize) -> [f64; 6],
    ) -> Vec<Patch> {
        let mut patches = Vec::with_capacity(cells.len());
        for (k, nodes) in cells.iter().enumerate() {
            let from = nodes.iter().map(|node| node[0]).fold(f64::INFINITY, f64::min);
            let to = nodes.iter().map(|node| node[0]).fold(f64::NEG_INFINITY, f64::max);
            patches.extend(
                self.shifts(from, to).into_iter().map(|shift| Patch {
                    points: nodes.map(|[x, z]| self.at(frame, [x + shift, z])),
                    values: values(k),
                }),
            );
        }
        patches
    }

    /// Draws a line on the liner [m], of a ring on both sides of the cut.
    pub(super) fn lines(&self, frame: &PlotFrame, line: &[[f64; 2]]) -> Vec<Vec<[f64; 2]>> {
        let from = line.iter().map(|point| point[0]).fold(f64::INFINITY, f64::min);
        let to = line.iter().map(|point| point[0]).fold(f64::NEG_INFINITY, f64::max);
        let shifted = |shift: f64| line.iter().map(|[x, z]| self.at(frame, [x + shift, *z])).collect();
        self.shifts(from, to).into_iter().map(shifted).collect()
    }

    /// Draws what belongs into the frame, cut off there.
    pub(super) fn within(&self, figure: &mut Figure, frame: &PlotFrame, draw: impl FnOnce(&mut Figure)) {
        match self.period {
            Some(_) => figure.clipped(frame.inner, draw),
            None => draw(figure),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ring_is_cut_where_it_is_told_and_its_crossing_triangle_is_there_twice() {
        let middle = |a: [f64; 2], b: [f64; 2]| [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])];
        let cell = |x: f64| {
            let [a, b, c] = [[x, 0.0], [x + 1.0, 0.0], [x, 1.0]];
            [a, b, c, middle(a, b), middle(b, c), middle(c, a)]
        };
        let cells: Vec<TriangleNodes> = (0..6).map(|k| cell(f64::from(k))).collect();
        let radius = 6.0 / std::f64::consts::TAU;
        let liner = LinerWindow::of(&cells, radius, Some(6.0), Some(2.5));
        let frame = liner.frame([0.0, 0.0, 170.0, 0.0]);
        let patches = liner.patches(&frame, &cells, |k| [k as f64; 6]);
        assert_eq!(patches.len(), 7);
        assert_eq!(patches.iter().filter(|patch| patch.values[0] == 2.0).count(), 2);
        assert!((frame.inner[3] / frame.inner[2] - 1.0 / 6.0).abs() < 1e-9, "not to scale");
        assert_eq!(liner.shifts(0.2, 0.4), [6.0]);
        let arc = LinerWindow::of(&cells, radius, None, None);
        assert_eq!(arc.patches(&arc.frame([0.0, 0.0, 85.0, 0.0]), &cells, |_| [0.0; 6]).len(), 6);
        assert!((arc.stretch(&arc.frame([0.0, 0.0, 30.0, 0.0])) - 1.0).abs() > 0.1);
    }
}
