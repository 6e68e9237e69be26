//! The adaptive mesh on the unrolled liner, coloured by where the error comes from.

use super::axes::{bounds, power_of_ten};
use super::canvas::{CENTRE, Canvas, LEFT, Letters, Pen, RIGHT, TOP};
use super::palette::{EDGE, INK, of_share};
use crate::Error;
use oilwedge_campaign::convergence::{ConvergenceReport, MarkedMesh};
use oilwedge_mesh::Mesh;
use plotters::style::RGBColor;

/// Decades that the colours span at most.
const MOST_DECADES: f64 = 5.0;
/// Room for what stands left, right, above and below the mesh [points].
const MARGINS: [f64; 4] = [74.0, 96.0, 34.0, 50.0];
/// Greatest height of the mesh [points].
const HIGHEST: f64 = 380.0;
/// Where nothing is known of the error.
const UNKNOWN: RGBColor = RGBColor(225, 236, 242);

/// Where the mesh stands on the sheet.
struct Place {
    left: f64,
    top: f64,
    scale: f64,
    low: [f64; 2],
    high: [f64; 2],
}

impl Place {
    /// Within a rectangle of that width [points], as high as it takes.
    fn of(mesh: &Mesh, left: f64, top: f64, width: f64) -> Self {
        let extents = [0, 1].map(|d| bounds(mesh.points().iter().map(|point| point[d])).unwrap_or((0.0, 1.0)));
        let (low, mut high) = (extents.map(|it| it.0), extents.map(|it| it.1));
        if let Some(period) = mesh.period() {
            high[0] = low[0] + period;
        }
        let width = width - MARGINS[0] - MARGINS[1];
        let scale = f64::min(width / (high[0] - low[0]), HIGHEST / (high[1] - low[1]));
        Self {
            left: left + MARGINS[0] + 0.5 * (width - scale * (high[0] - low[0])),
            top: top + MARGINS[2],
            scale,
            low,
            high,
        }
    }

    fn at(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [
            self.left + self.scale * (x - self.low[0]),
            self.top + self.scale * (self.high[1] - y),
        ]
    }

    fn corner(&self) -> [f64; 2] {
        self.at([self.high[0], self.low[1]])
    }
}

/// Height of the panel [points] at that width.
pub(super) fn height(marked: &MarkedMesh, width: f64) -> f64 {
    Place::of(&marked.mesh, 0.0, 0.0, width).corner()[1] + MARGINS[3]
}

/// Draws the mesh with its axes and the key of its colours.
pub(super) fn draw(
    canvas: &Canvas,
    marked: &MarkedMesh,
    report: &ConvergenceReport,
    [left, top, width]: [f64; 3],
) -> Result<(), Error> {
    let place = Place::of(&marked.mesh, left, top, width);
    let mesh = &marked.mesh;
    let colours = marked
        .indicator
        .as_deref()
        .and_then(|indicator| Colours::of(indicator, report));
    let what = match &colours {
        Some(_) => format!(
            "colour: contribution of each to the relative error of the {}",
            report.goal.name
        ),
        None => "where the error comes from is not estimated".to_owned(),
    };
    let title = format!(
        "Adaptive mesh, level {}: {} triangles; {what}",
        marked.level,
        mesh.triangles().len()
    );
    canvas.text([place.left, top + 12.0], &title, Letters::new(13.0, LEFT))?;
    for t in 0..mesh.triangles().len() {
        let colour = colours.as_ref().map_or(UNKNOWN, |colours| colours.of_triangle(t));
        for part in parts(mesh, &mesh.corners(t), place.high[0]) {
            let corners: Vec<_> = part.into_iter().map(|corner| place.at(corner)).collect();
            if corners.len() > 2 {
                canvas.polygon(&corners, colour)?;
            }
        }
    }
    // The finer the mesh, the finer its lines.
    let pen = Pen((16.0 / (mesh.triangles().len() as f64).sqrt()).clamp(0.25, 0.8), EDGE);
    for edge in 0..mesh.topology().edges.len() as u32 {
        let [a, b, middle] = mesh.edge_nodes(edge);
        let straight = mesh.bulge(edge) == [0.0; 2];
        let line = if straight { vec![a, b] } else { vec![a, middle, b] };
        for part in parts(mesh, &line, place.high[0]) {
            let points: Vec<_> = part.into_iter().map(|point| place.at(point)).collect();
            if points.len() > 1 {
                canvas.line(&points, pen)?;
            }
        }
    }
    draw_axes(canvas, &place, marked.radius)?;
    match colours {
        Some(colours) => colours.draw_key(canvas, &place),
        None => Ok(()),
    }
}

/// A line or a triangle of a ring, the part beyond the cut laid out at the other side: convex pieces.
fn parts(mesh: &Mesh, points: &[[f64; 2]], cut: f64) -> Vec<Vec<[f64; 2]>> {
    let Some(period) = mesh.period() else {
        return vec![points.to_vec()];
    };
    let beyond = |point: &[f64; 2]| point[0] > cut + 1e-9 * period;
    if !points.iter().any(beyond) {
        return vec![points.to_vec()];
    }
    let closed = points.len() > 2;
    let (mut near, mut far) = (Vec::new(), Vec::new());
    for (k, &a) in points.iter().enumerate() {
        let side = if beyond(&a) { &mut far } else { &mut near };
        side.push(a);
        let next = match points.get(k + 1) {
            None if closed => points.first(),
            next => next,
        };
        if let Some(b) = next.filter(|b| beyond(b) != beyond(&a)) {
            let part = (cut - a[0]) / (b[0] - a[0]);
            let crossing = [cut, a[1] + part * (b[1] - a[1])];
            near.push(crossing);
            far.push(crossing);
        }
    }
    vec![near, far.into_iter().map(|[x, y]| [x - period, y]).collect()]
}

/// A frame, angles along the circumference and places along the axis.
fn draw_axes(canvas: &Canvas, place: &Place, radius: f64) -> Result<(), Error> {
    let [right, bottom] = place.corner();
    let [left, top] = [place.left, place.top];
    canvas.frame([left, top], [right, bottom])?;
    let degrees = |x: f64| (x / radius).to_degrees();
    let step = round_step(
        (degrees(place.high[0]) - degrees(place.low[0])) / 9.0,
        &[1.0, 2.0, 3.0, 4.5, 9.0],
    );
    for angle in multiples(degrees(place.low[0]), degrees(place.high[0]), step) {
        let x = place.at([angle.to_radians() * radius, 0.0])[0];
        canvas.line(&[[x, bottom], [x, bottom + 4.0]], Pen(1.0, INK))?;
        let number = format!("{angle:.0}\u{b0}");
        canvas.text([x, bottom + 8.0], &number, Letters::new(12.0, TOP))?;
    }
    let below = [0.5 * (left + right), bottom + 27.0];
    canvas.text(below, "angle on the liner", Letters::new(13.0, TOP))?;
    let length = 1e3 * (place.high[1] - place.low[1]);
    let apart = f64::max(4.0, length / ((bottom - top) / 30.0));
    let step = round_step(f64::min(apart, 0.5 * length), &[1.0, 2.0, 5.0]);
    for z in multiples(1e3 * place.low[1], 1e3 * place.high[1], step) {
        let y = place.at([0.0, 1e-3 * z])[1];
        canvas.line(&[[left - 4.0, y], [left, y]], Pen(1.0, INK))?;
        let number = format!("{z}").replace('-', "\u{2212}");
        canvas.text([left - 9.0, y], &number, Letters::new(12.0, RIGHT))?;
    }
    let beside = [left - 52.0, 0.5 * (top + bottom)];
    canvas.text(beside, "axis [mm]", Letters::new(13.0, CENTRE).upright())
}

/// The least of the round numbers `digits` times a power of ten that is not below `wanted`.
fn round_step(wanted: f64, digits: &[f64]) -> f64 {
    let power = 10f64.powf(wanted.log10().floor());
    let steps = digits.iter().map(|digit| digit * power);
    let found = steps.clone().find(|step| *step >= wanted * (1.0 - 1e-9));
    found.unwrap_or(10.0 * digits.first().copied().unwrap_or(1.0) * power)
}

/// Multiples of a step from low to high, both included.
fn multiples(low: f64, high: f64, step: f64) -> impl Iterator<Item = f64> {
    let slack = 1e-6 * step;
    let (first, last) = (
        ((low - slack) / step).ceil() as i64,
        ((high + slack) / step).floor() as i64,
    );
    (first..=last).map(move |k| {
        let value = k as f64 * step;
        // Steps have few digits; their multiples shall have as few.
        (value * 1e6).round() * 1e-6
    })
}

/// The colours of triangles, logarithmic in their share.
struct Colours {
    /// Exponents of ten of each share; minus infinity for none.
    exponents: Vec<f64>,
    low: f64,
    high: f64,
}

impl Colours {
    /// Shares relative to the finest answer; `None` where all are zero.
    fn of(indicator: &[f64], report: &ConvergenceReport) -> Option<Self> {
        let value = report.reference.as_ref()?.value.abs();
        let exponents: Vec<f64> = indicator.iter().map(|share| (share / value).abs().log10()).collect();
        let (low, high) = bounds(exponents.iter().copied())?;
        let low = low.max(high - MOST_DECADES).min(high - 1.0);
        Some(Self { exponents, low, high })
    }

    fn of_triangle(&self, t: usize) -> RGBColor {
        let exponent = self.exponents.get(t).copied().unwrap_or(f64::NEG_INFINITY);
        of_share((exponent - self.low) / (self.high - self.low))
    }

    /// A strip of the colours with numbers, at the right of the mesh.
    fn draw_key(&self, canvas: &Canvas, place: &Place) -> Result<(), Error> {
        const STRIPES: usize = 64;
        let [right, bottom] = place.corner();
        let (left, right, top) = (right + 20.0, right + 34.0, place.top);
        let at = |part: f64| bottom - part * (bottom - top);
        for k in 0..STRIPES {
            // Each reaches below the next, so that no seam shows between them.
            let [lower, upper] = [k, (k + 2).min(STRIPES)].map(|k| k as f64 / STRIPES as f64);
            let colour = of_share((k as f64 + 0.5) / STRIPES as f64);
            canvas.rectangle([left, at(upper)], [right, at(lower)], colour)?;
        }
        canvas.frame([left, top], [right, bottom])?;
        for exponent in self.low.ceil() as i32..=self.high.floor() as i32 {
            let y = at((f64::from(exponent) - self.low) / (self.high - self.low));
            canvas.line(&[[right, y], [right + 4.0, y]], Pen(1.0, INK))?;
            power_of_ten(canvas, [right + 8.0, y], LEFT, exponent)?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use oilwedge_mesh::RawMesh;

    #[test]
    fn steps_are_round() {
        assert_eq!(round_step(40.0, &[1.0, 2.0, 3.0, 4.5, 9.0]), 45.0);
        assert_eq!(round_step(7.0, &[1.0, 2.0, 5.0]), 10.0);
        assert_eq!(round_step(0.2, &[1.0, 2.0, 5.0]), 0.2);
        let angles: Vec<f64> = multiples(40.0, 220.0, 45.0).collect();
        assert_eq!(angles, [45.0, 90.0, 135.0, 180.0]);
    }

    #[test]
    fn what_crosses_the_cut_is_drawn_on_both_sides() {
        let ring = Mesh::build(RawMesh {
            points: vec![[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [0.0, 1.0], [1.0, 1.0], [2.0, 1.0]],
            triangles: vec![[0, 1, 4], [0, 4, 3], [1, 2, 5], [1, 5, 4], [2, 0, 3], [2, 3, 5]],
            period: Some(3.0),
            ..RawMesh::default()
        })
        .expect("a ring");
        let area = |corners: &[[f64; 2]]| -> f64 {
            let sides = (0..corners.len()).map(|k| (corners[k], corners[(k + 1) % corners.len()]));
            0.5 * sides.map(|(a, b)| a[0] * b[1] - b[0] * a[1]).sum::<f64>()
        };
        let triangle = [[2.5, 0.0], [3.5, 0.0], [2.5, 1.0]];
        let pieces = parts(&ring, &triangle, 3.0);
        assert_eq!(pieces.len(), 2);
        assert!((area(&pieces[0]) - 0.375).abs() < 1e-15 && (area(&pieces[1]) - 0.125).abs() < 1e-15);
        assert!(pieces[1].iter().all(|point| (0.0..=0.5).contains(&point[0])));
        assert_eq!(parts(&ring, &triangle, 4.0), [triangle.to_vec()]);
        let line = parts(&ring, &[[2.5, 0.0], [3.5, 1.0]], 3.0);
        assert_eq!(line, [vec![[2.5, 0.0], [3.0, 0.5]], vec![[0.0, 0.5], [0.5, 1.0]]]);
    }
}
