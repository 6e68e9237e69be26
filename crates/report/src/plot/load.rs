//! The load over a cycle: over the crank angle, and as polar diagrams in each frame that is known.

use std::f64::consts::TAU;

use oilwedge_drawing::{
    BLACK, BLUE, Chart, ChartKind, Figure, GREEN, GREY, GRID, Label, Mark, Note, Series, Stroke, VERMILION,
    charts_figure, least_and_greatest, linear_steps, number,
};
use oilwedge_study::duty::{DutyCycle, ForceAxes};

/// Curves have a point for each degree of the crank angle.
const POINTS_OF_A_TURN: f64 = 360.0;
/// Crank angles that are marked in a polar diagram [deg].
const MARKED: f64 = 60.0;
/// Steps of the rings in the longer side of a polar diagram, at most.
const RINGS: f64 = 8.0;
/// Where the value of a ring may stand [turns], the first that is on the sheet.
const RING_LABELS: [f64; 6] = [-0.09, 0.09, 0.41, 0.59, -0.02, 0.48];
/// Parts of the longer side: room around the curve, from a mark to its label, and between labels.
const EDGE: f64 = 0.06;
const LABEL: f64 = 0.035;
const ROOM: f64 = 0.035;
/// Forces from here on are shown in kilonewtons [N].
const KILO: f64 = 1e3;

/// The pictures of a load by name; `title` is that of the scene.
pub fn load_figures(title: &str, cycle: &DutyCycle, width: f64) -> Vec<(String, Figure)> {
    let drawn = DrawnLoad::of(cycle);
    let polar = drawn.frames().into_iter().map(|(frame, name)| drawn.polar(frame, name));
    let polar: Vec<_> = polar.collect();
    let by_angle = drawn.by_angle();
    let name = |what: &str| format!("{what}: {title}");
    vec![
        ("load_by_angle".to_owned(), charts_figure(&name("Load over a cycle"), &by_angle, 1, width)),
        ("load_polar".to_owned(), charts_figure(&name("Polar load diagram"), &polar, 1, width)),
    ]
}

/// A load and the unit in which it is drawn.
struct DrawnLoad<'a> {
    cycle: &'a DutyCycle,
    /// The unit and its size [N].
    unit: (&'static str, f64),
}

impl<'a> DrawnLoad<'a> {
    fn of(cycle: &'a DutyCycle) -> Self {
        let [x, y] = cycle.summary().peak.1;
        let peak = x.hypot(y);
        let unit = if peak < KILO { ("N", 1.0) } else { ("kN", KILO) };
        Self { cycle, unit }
    }

    /// The frames in which the load is known, with a word for their x axis; all of them where the shell is in a rod,
    /// else that of the shell alone.
    fn frames(&self) -> Vec<(ForceAxes, &'static str)> {
        let rod = self.cycle.turning().and_then(|turning| turning.rod);
        match rod {
            Some(_) => vec![
                (ForceAxes::Shell, "shell: x along the rod"),
                (ForceAxes::Cylinder, "cylinder: x to the cylinder"),
                (ForceAxes::Pin, "pin: x along the throw"),
            ],
            None => vec![(ForceAxes::Shell, "shell")],
        }
    }

    /// Crank angles [rad] of the points of curves, the end of the period included.
    fn angles(&self) -> impl Iterator<Item = f64> + use<> {
        let period = self.cycle.period();
        let steps = (POINTS_OF_A_TURN * period / TAU).ceil() as u32;
        (0..=steps).map(move |k| period * f64::from(k) / f64::from(steps))
    }

    fn force(&self, frame: ForceAxes, angle: f64) -> [f64; 2] {
        let force = self.cycle.at(angle).force;
        let force = match self.cycle.turning() {
            Some(turning) => turning.from_shell(force, frame, angle),
            None => force,
        };
        force.map(|part| part / self.unit.1)
    }

    fn by_angle(&self) -> Vec<Chart> {
        let angle = || Label::plain("crank angle, deg");
        let curve = |value: &dyn Fn(f64) -> f64| -> Vec<[f64; 2]> {
            self.angles().map(|angle| [angle.to_degrees(), value(angle)]).collect()
        };
        let part = |k: usize| curve(&|angle| self.force(ForceAxes::Shell, angle)[k]);
        let magnitude = curve(&|angle| {
            let [x, y] = self.force(ForceAxes::Shell, angle);
            x.hypot(y)
        });
        let mut force =
            Chart::new("", angle(), Label::plain(&format!("force on the journal, shell's frame, {}", self.unit.0)));
        force.series = vec![
            Series::line("x", BLUE, part(0)),
            Series::line("y", GREEN, part(1)),
            Series::line("magnitude", VERMILION, magnitude).stroked(Stroke::Dashed),
        ];
        let mut charts = vec![force];
        let [least, greatest] = self.cycle.summary().speeds;
        if greatest > least {
            let mut speed = Chart::new("", angle(), "speed against the shell, rad/s".into());
            speed.series = vec![Series::line("", BLACK, curve(&|angle| self.cycle.at(angle).speed))];
            charts.push(speed);
        }
        charts
    }

    /// Where the tip of the force goes, with rings and crank angles, cut to where it goes.
    fn polar(&self, frame: ForceAxes, title: &str) -> Chart {
        let tip: Vec<_> = self.angles().map(|angle| self.force(frame, angle)).collect();
        let sheet = ForcePlane::around(&tip);
        let marks = (0..).map(|k| MARKED * f64::from(k));
        let marks = marks.take_while(|mark| mark.to_radians() < self.cycle.period() - 1e-9);
        let marks: Vec<_> = marks.map(|mark| (mark, self.force(frame, mark.to_radians()))).collect();
        let title = format!("{title}, {}", self.unit.0);
        polar(&title, tip, &marks, ("crank angle, each 60 deg", &sheet))
    }
}

/// A curve of forces on a sheet with rings, and the crank angles [deg] of places on it, with their name.
pub(super) fn polar(
    title: &str,
    tip: Vec<[f64; 2]>,
    marks: &[(f64, [f64; 2])],
    (name, sheet): (&str, &ForcePlane),
) -> Chart {
    let mut chart = Chart::new(title, Label::default(), Label::default());
    chart.kind = ChartKind::Drawing;
    sheet.draw_rings(&mut chart);
    chart.series.push(Series::line("", VERMILION, tip));
    let points = marks.iter().map(|(_, point)| *point).collect();
    chart.series.push(Series::marks(name, VERMILION, Mark::Disc, points));
    for &(mark, [x, y]) in marks {
        let beyond = 1.0 + LABEL * sheet.extent / f64::max(x.hypot(y), 1e-9 * sheet.extent);
        let at = [beyond * x, beyond * y];
        let has_room = |note: &Note| (note.at[0] - at[0]).hypot(note.at[1] - at[1]) > ROOM * sheet.extent;
        if chart.notes.iter().all(has_room) {
            chart.notes.push(Note { at, label: number(mark, 1.0), colour: BLACK });
        }
    }
    chart
}

/// The rectangle of a polar diagram, in the unit of the force.
pub(super) struct ForcePlane {
    low: [f64; 2],
    high: [f64; 2],
    /// The longer side.
    extent: f64,
}

impl ForcePlane {
    /// The frame around a curve and the origin.
    pub(super) fn around(curve: &[[f64; 2]]) -> Self {
        let [x, y] = [0, 1].map(|axis| least_and_greatest(curve.iter().map(|point| point[axis]).chain([0.0])));
        let extent = f64::max(x[1] - x[0], y[1] - y[0]);
        let extent = if extent > 0.0 { extent } else { 1.0 };
        let edge = EDGE * extent;
        Self { low: [x[0] - edge, y[0] - edge], high: [x[1] + edge, y[1] + edge], extent }
    }

    /// The point, or no number where it is outside.
    fn cut(&self, point: [f64; 2]) -> [f64; 2] {
        let is_inside = |axis: usize| (self.low[axis]..=self.high[axis]).contains(&point[axis]);
        if is_inside(0) && is_inside(1) { point } else { [f64::NAN; 2] }
    }

    /// Rings of the same force with their values, and the axes.
    fn draw_rings(&self, chart: &mut Chart) {
        let step = linear_steps(self.extent, RINGS);
        let corner = |axis: usize| f64::max(-self.low[axis], self.high[axis]);
        let count = (corner(0).hypot(corner(1)) / step).ceil().min(4.0 * RINGS) as u32;
        for k in 1..=count {
            let radius = step * f64::from(k);
            let point = |angle: f64| self.cut([radius * angle.cos(), radius * angle.sin()]);
            let ring = (0..=720).map(|k| point(TAU * f64::from(k) / 720.0));
            chart.series.push(Series::line("", GRID, ring.collect()));
            let at = RING_LABELS.into_iter().map(|turn| point(turn * TAU)).find(|at| at[0].is_finite());
            chart.notes.extend(at.map(|at| Note { at, label: number(radius, step), colour: GREY }));
        }
        for (axis, name) in ["*x*", "*y*"].into_iter().enumerate() {
            let point = |value: f64| if axis == 0 { [value, 0.0] } else { [0.0, value] };
            let ends = vec![point(self.low[axis]), point(self.high[axis])];
            chart.series.push(Series::line("", GRID, ends));
            chart.notes.push(Note {
                at: point(self.high[axis] + 0.5 * EDGE * self.extent),
                label: Label::marked(name),
                colour: GREY,
            });
        }
    }
}
