//! The load over a cycle: over the crank angle, and as polar diagrams in each frame that is known.

use std::f64::consts::TAU;

use oilwedge_drawing::{
    BLACK, BLUE, Chart, Figure, GREEN, GREY, GRID, Kind, Label, Mark, Note, Series, VERMILION, charts_figure,
    linear_steps, number,
};
use oilwedge_study::duty::{DutyCycle, Frame};

/// Curves have a point for each degree of the crank angle.
const POINTS_OF_A_TURN: f64 = 360.0;
/// Crank angles that are marked in a polar diagram [deg].
const MARKED: f64 = 60.0;
/// Most rings of a polar diagram.
const RINGS: f64 = 4.0;
/// Forces from here on are shown in kilonewtons [N].
const KILO: f64 = 1e3;

/// The pictures of a load by name; `title` is that of the scene.
pub fn load_figures(title: &str, cycle: &DutyCycle, width: f64) -> Vec<(String, Figure)> {
    let drawn = Drawn::of(cycle);
    let polar = drawn.frames().into_iter().map(|(frame, name)| drawn.polar(frame, name));
    let polar: Vec<_> = polar.collect();
    let by_angle = drawn.by_angle();
    let name = |what: &str| format!("{what}: {title}");
    let columns = polar.len();
    vec![
        (
            "load".to_owned(),
            charts_figure(&name("Load over a cycle"), &by_angle, 1, width),
        ),
        (
            "load_polar".to_owned(),
            charts_figure(&name("Polar load diagram"), &polar, columns, width),
        ),
    ]
}

/// A load and the unit in which it is drawn.
struct Drawn<'a> {
    cycle: &'a DutyCycle,
    /// Greatest force in that unit.
    peak: f64,
    /// The unit and its size [N].
    unit: (&'static str, f64),
}

impl<'a> Drawn<'a> {
    fn of(cycle: &'a DutyCycle) -> Self {
        let [x, y] = cycle.summary().peak.1;
        let peak = x.hypot(y);
        let unit = if peak < KILO { ("N", 1.0) } else { ("kN", KILO) };
        Self {
            cycle,
            peak: peak / unit.1,
            unit,
        }
    }

    /// The frames in which the load is known, with a word for their x axis; all of them where the shell is in a rod, else that of the shell alone.
    fn frames(&self) -> Vec<(Frame, &'static str)> {
        let rod = self.cycle.turning().and_then(|turning| turning.rod);
        match rod {
            Some(_) => vec![
                (Frame::Shell, "shell: x along the rod"),
                (Frame::Cylinder, "x to the cylinder"),
                (Frame::Pin, "pin: x along the throw"),
            ],
            None => vec![(Frame::Shell, "shell")],
        }
    }

    /// Crank angles [rad] of the points of curves, the end of the period included.
    fn angles(&self) -> impl Iterator<Item = f64> + use<> {
        let period = self.cycle.period();
        let steps = (POINTS_OF_A_TURN * period / TAU).ceil() as u32;
        (0..=steps).map(move |k| period * f64::from(k) / f64::from(steps))
    }

    fn force(&self, frame: Frame, angle: f64) -> [f64; 2] {
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
        let part = |k: usize| curve(&|angle| self.force(Frame::Shell, angle)[k]);
        let magnitude = curve(&|angle| {
            let [x, y] = self.force(Frame::Shell, angle);
            x.hypot(y)
        });
        let mut force = Chart::new(
            "",
            angle(),
            Label::plain(&format!("force on the journal, shell's frame, {}", self.unit.0)),
        );
        force.series = vec![
            Series::line("x", BLUE, part(0)),
            Series::line("y", GREEN, part(1)),
            Series::line("magnitude", VERMILION, magnitude),
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

    /// Where the tip of the force goes, with rings and crank angles.
    fn polar(&self, frame: Frame, title: &str) -> Chart {
        let mut chart = Chart::new(&format!("{title}, {}", self.unit.0), Label::default(), Label::default());
        chart.kind = Kind::Drawing;
        let step = linear_steps(f64::max(self.peak, f64::MIN_POSITIVE), RINGS);
        let count = (self.peak / step).ceil().clamp(1.0, 2.0 * RINGS) as u32;
        let around = |radius: f64, angle: f64| [radius * angle.cos(), radius * angle.sin()];
        let circle = |radius: f64| (0..=180).map(|k| around(radius, TAU * f64::from(k) / 180.0)).collect();
        let end = step * f64::from(count);
        for k in 1..=count {
            let radius = step * f64::from(k);
            chart.series.push(Series::line("", GRID, circle(radius)));
            chart.notes.push(Note {
                at: around(radius, -0.15 * TAU),
                label: number(radius, step),
                colour: GREY,
            });
        }
        for (axis, name) in ["*x*", "*y*"].into_iter().enumerate() {
            let point = |length: f64| if axis == 0 { [length, 0.0] } else { [0.0, length] };
            chart.series.push(Series::line("", GRID, vec![point(-end), point(end)]));
            chart.notes.push(Note {
                at: point(1.08 * end),
                label: Label::marked(name),
                colour: GREY,
            });
        }
        let tip = self.angles().map(|angle| self.force(frame, angle)).collect();
        chart.series.push(Series::line("", VERMILION, tip));
        let marks = (0..).map(|k| MARKED * f64::from(k));
        let marks: Vec<f64> = marks
            .take_while(|mark| mark.to_radians() < self.cycle.period() - 1e-9)
            .collect();
        let points = marks.iter().map(|mark| self.force(frame, mark.to_radians())).collect();
        chart.series.push(Series::marks(
            "every 60 deg of the crank angle",
            VERMILION,
            Mark::Disc,
            points,
        ));
        for mark in marks {
            let [x, y] = self.force(frame, mark.to_radians());
            let length = f64::max(x.hypot(y), 1e-9 * end);
            let beyond = 1.0 + 0.07 * end / length;
            chart.notes.push(Note {
                at: [beyond * x, beyond * y],
                label: number(mark, 1.0),
                colour: BLACK,
            });
        }
        chart
    }
}
