//! The orbit of the journal: its path in the circle of the clearance, and what the film does over the crank angle.

use std::f64::consts::TAU;

use oilwedge_drawing::{
    BLACK, BLUE, Chart, ChartKind, Colour, Figure, GREEN, GREY, GRID, Label, Mark, Note, Series, Stroke, VERMILION,
    charts_figure, number,
};

use super::load::{ForcePlane, polar};
use crate::orbit_course::OrbitCourse;
use oilwedge_study::quantities::{FILM_THICKNESS_MIN, FRICTION_POWER, LOAD_X, LOAD_Y, PRESSURE_MAX, Row};

/// Crank angles that are marked on the path [deg].
const MARKED: f64 = 60.0;
/// Rings of the circle of the clearance.
const RINGS: [f64; 4] = [0.25, 0.5, 0.75, 1.0];
/// What is drawn over the crank angle: axes, units, and colours.
const OVER_ANGLE: [(&Row, &str, f64, Colour); 3] = [
    (&FILM_THICKNESS_MIN, "least film thickness, um", 1e6, BLUE),
    (&PRESSURE_MAX, "greatest pressure, MPa", 1e-6, VERMILION),
    (&FRICTION_POWER, "power that turns the journal, W", 1.0, GREEN),
];

/// The pictures of an orbit by name; `title` is that of the scene.
pub fn orbit_figures(title: &str, course: &OrbitCourse, width: f64) -> Vec<(String, Figure)> {
    let circle = [circle("", course, MARKED)];
    let mut figures = vec![("orbit".to_owned(), charts_figure(&format!("Orbit: {title}"), &circle, 1, width))];
    figures.extend(film_over_cycle(title, course, width));
    figures
}

/// The picture of what the film does over the crank angle, with its name.
pub(crate) fn film_over_cycle(title: &str, course: &OrbitCourse, width: f64) -> Vec<(String, Figure)> {
    let charts = over_angle(&[("", course)]);
    let figure = charts_figure(&format!("Film over the cycle: {title}"), &charts, 1, width);
    vec![("orbit_by_angle".to_owned(), figure)]
}

/// The path, and as a polar diagram what the film carries, each a picture with its name.
pub(crate) fn path_and_load(title: &str, course: &OrbitCourse, width: f64) -> Vec<(String, Figure)> {
    let kilonewtons = |angles: Vec<f64>| -> Vec<[f64; 2]> {
        let forces = course.vectors([&LOAD_X, &LOAD_Y], angles.into_iter());
        forces.into_iter().map(|force| force.map(|part| 1e-3 * part)).collect()
    };
    let tip = kilonewtons(course.even_angles().collect());
    let marks: Vec<f64> = course.marked_angles(MARKED).collect();
    let marks: Vec<_> = marks.iter().copied().zip(kilonewtons(marks.clone())).collect();
    let sheet = ForcePlane::around(&tip);
    let name = format!("crank angle, each {MARKED} deg");
    let has_load = !tip.is_empty();
    let load = has_load.then(|| polar("", tip, &marks, (&name, &sheet)));
    let path = Some(("orbit", "Path of the journal", circle("", course, MARKED)));
    let load = load.map(|load| ("orbit_load", "Load that the film carries, kN", load));
    let figure = |(file, what, chart): (&str, &str, Chart)| {
        let figure = charts_figure(&format!("{what}: {title}"), &[chart], 1, width);
        (file.to_owned(), figure)
    };
    path.into_iter().chain(load).map(figure).collect()
}

/// The pictures of two orbits side by side, each with the title of its scene.
pub fn orbits_beside(courses: [(&str, &OrbitCourse); 2], width: f64) -> Vec<(String, Figure)> {
    let circles = courses.map(|(title, course)| circle(title, course, MARKED));
    vec![
        ("orbits".to_owned(), charts_figure("Two orbits", &circles, 2, width)),
        ("orbits_by_angle".to_owned(), charts_figure("Two films over the cycle", &over_angle(&courses), 1, width)),
    ]
}

/// The path of the journal's centre in the circle of the clearance, with marks each so many degrees of the crank.
pub(super) fn circle(title: &str, course: &OrbitCourse, step: f64) -> Chart {
    let mut chart = Chart::new(title, Label::default(), Label::default());
    chart.kind = ChartKind::Drawing;
    let point = |radius: f64, turn: f64| [radius * (TAU * turn).cos(), radius * (TAU * turn).sin()];
    for radius in RINGS {
        let ring = (0..=360).map(|k| point(radius, f64::from(k) / 360.0)).collect();
        let colour = if radius == 1.0 { BLACK } else { GRID };
        chart.series.push(Series::line("", colour, ring));
        chart.notes.push(Note { at: point(radius, -0.09), label: number(radius, 0.25), colour: GREY });
    }
    for (turn, name) in [(0.0, "*x*"), (0.25, "*y*")] {
        chart.series.push(Series::line("", GRID, vec![point(1.0, turn + 0.5), point(1.0, turn)]));
        chart.notes.push(Note { at: point(1.06, turn), label: Label::marked(name), colour: GREY });
    }
    chart.series.push(Series::line("", VERMILION, course.path()));
    let marks: Vec<f64> = course.marked_angles(step).collect();
    let points = course.places(marks.iter().copied());
    for (mark, at) in marks.into_iter().zip(&points) {
        chart.notes.push(Note { at: at.map(|part| 0.93 * part), label: number(mark, 1.0), colour: BLACK });
    }
    let name = format!("crank angle, each {step} deg; eccentricity over the clearance");
    chart.series.push(Series::marks(&name, VERMILION, Mark::Disc, points));
    chart
}

/// The numbers of films over the crank angle, a chart for each that they have; of two orbits the second is dashed.
fn over_angle(courses: &[(&str, &OrbitCourse)]) -> Vec<Chart> {
    let chart = |(row, name, unit, colour): (&Row, &str, f64, Colour)| {
        let mut chart = Chart::new("", Label::plain("crank angle, deg"), Label::plain(name));
        for (number, (title, course)) in courses.iter().enumerate() {
            let points = course.curve(row).into_iter().map(|[angle, value]| [angle, unit * value]);
            let line = Series::line(title, if number == 0 { colour } else { BLACK }, points.collect());
            chart.series.push(match number {
                0 => line,
                _ => line.stroked(Stroke::Dashed),
            });
        }
        chart
    };
    let is_known =
        |(row, ..): &(&Row, &str, f64, Colour)| courses.iter().any(|(_, course)| !course.curve(row).is_empty());
    OVER_ANGLE.into_iter().filter(is_known).map(chart).collect()
}
