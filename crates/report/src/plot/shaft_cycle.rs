//! All bearings of a crankshaft over a cycle: loads and paths side by side, films over the crank angle in one chart,
//! and two shafts beside each other.

use oilwedge_drawing::{BLACK, Chart, Figure, Label, SERIES, Series, Stroke, charts_figure};
use oilwedge_study::quantities::{
    CONTACT_SHARE, FILM_THICKNESS_MIN, FRICTION_POWER, LOAD_X, LOAD_Y, PRESSURE_MAX, Row, SIDE_FLOW, TILT_X, TILT_Y,
};
use oilwedge_study::shaft::Variant;

use super::load::{ForcePlane, polar};
use super::orbit::circle;
use super::shaft::shaft_figure;
use super::shaft_line::shaft_line;
use crate::orbit_course::OrbitCourse;
use crate::shaft_view::{ShaftView, ShaftViews};

/// Crank angles that are marked in small diagrams [deg].
const MARKED: f64 = 120.0;
/// Small diagrams in a row.
const COLUMNS: usize = 3;
const LOAD: [&Row; 2] = [&LOAD_X, &LOAD_Y];
const TILT: [&Row; 2] = [&TILT_X, &TILT_Y];

/// A number of a journal over the crank angle: points, in the unit of the axis.
type Over = dyn Fn(&OrbitCourse) -> Vec<[f64; 2]>;

/// The pictures of a shaft by name, and of those beside it.
pub fn shaft_figures(views: &ShaftViews, width: f64) -> Vec<(String, Figure)> {
    let own = &views.own;
    let mut figures: Vec<(String, Figure)> = Vec::new();
    figures.extend(shaft_figure(own, width).map(|figure| (SHAFT.to_owned(), figure)));
    figures.extend(shaft_line(own, width).map(|figure| (BENT.to_owned(), figure)));
    if own.courses.is_empty() {
        return figures;
    }
    let name = |what: &str| format!("{what}: {}", own.result.head.title);
    let mut add = |file: &str, what: &str, charts: &[Chart], columns: usize| {
        figures.push((file.to_owned(), charts_figure(&name(what), charts, columns, width)));
    };
    add("shaft_loads", "What the films carry, kN", &loads(own), COLUMNS);
    let circles: Vec<_> = own.journals().map(|(bearing, course)| circle(bearing, course, MARKED)).collect();
    add("shaft_orbits", "Paths of the journals", &circles, COLUMNS);
    add("shaft_films", "Least film over the cycle", &[over(own, LEAST_FILM)], 1);
    add("shaft_by_angle", "Films over the cycle", &by_angle(own), 2);
    for (variant, other) in views.beside.iter().filter(|(_, other)| !other.courses.is_empty()) {
        for (file, what, number) in
            [("loads", "Load on each bearing", MAGNITUDE), ("films", "Least film of each bearing", LEAST_FILM)]
        {
            let charts = compared(own, (*variant, other), number);
            add(&format!("{}_{file}", variant.name()), what, &charts, 2);
        }
    }
    figures
}

/// Name of the picture of the shaft itself.
pub const SHAFT: &str = "shaft";
/// Name of the picture of the bent shaft.
pub const BENT: &str = "shaft_bent";

const LEAST_FILM: (&str, &Over) =
    ("least film thickness, um", &|course| scaled(course.curve(&FILM_THICKNESS_MIN), 1e6));
const MAGNITUDE: (&str, &Over) = ("load, kN", &|course| scaled(magnitude(course, LOAD), 1e-3));

/// The load of each bearing as a polar diagram, all to one scale.
fn loads(view: &ShaftView) -> Vec<Chart> {
    let kilonewtons = |course: &OrbitCourse, angles: Vec<f64>| -> Vec<[f64; 2]> {
        let forces = course.vectors(LOAD, angles.into_iter());
        forces.into_iter().map(|force| force.map(|part| 1e-3 * part)).collect()
    };
    let tips: Vec<_> = view.journals().map(|(_, course)| kilonewtons(course, course.even_angles().collect())).collect();
    let sheet = ForcePlane::around(&tips.concat());
    let name = format!("crank angle, each {MARKED} deg");
    let chart = |((bearing, course), tip): ((&str, &OrbitCourse), Vec<[f64; 2]>)| {
        let marks: Vec<f64> = course.marked_angles(MARKED).collect();
        let places = kilonewtons(course, marks.clone());
        let marks: Vec<_> = marks.into_iter().zip(places).collect();
        polar(bearing, tip, &marks, (&name, &sheet))
    };
    view.journals().zip(tips).map(chart).collect()
}

/// One number of all journals.
fn over(view: &ShaftView, (name, number): (&str, &Over)) -> Chart {
    let mut chart = Chart::new("", Label::plain("crank angle, deg"), Label::plain(name));
    for (place, (bearing, course)) in view.journals().enumerate() {
        let line = Series::line(bearing, SERIES[place % SERIES.len()], number(course));
        // Colours come again after some bearings.
        let stroke = if place < SERIES.len() { Stroke::Solid } else { Stroke::Dashed };
        chart.series.push(line.stroked(stroke));
    }
    chart
}

/// Tilt, pressure, contact, power and oil of all journals; contact where surfaces touch.
fn by_angle(view: &ShaftView) -> Vec<Chart> {
    let numbers: [(&str, &Over); 5] = [
        ("tilt, mrad", &|course| scaled(magnitude(course, TILT), 1e3)),
        ("greatest pressure, MPa", &|course| scaled(course.curve(&PRESSURE_MAX), 1e-6)),
        ("share of contact in the load", &|course| course.curve(&CONTACT_SHARE)),
        ("power that turns the journal, W", &|course| course.curve(&FRICTION_POWER)),
        ("oil that leaves at the ends, ml/s", &|course| scaled(course.curve(&SIDE_FLOW), 1e6)),
    ];
    let charts = numbers.into_iter().map(|number| over(view, number));
    charts.filter(|chart| chart.series.iter().any(|series| !series.points.is_empty())).collect()
}

/// One number of each journal on both shafts, all charts over one axis.
fn compared(own: &ShaftView, (variant, other): (Variant, &ShaftView), (name, number): (&str, &Over)) -> Vec<Chart> {
    let pairs = own.journals().zip(other.journals()).enumerate();
    let charts = pairs.map(|(place, ((bearing, course), (_, beside)))| {
        let mut chart = Chart::new(bearing, Label::plain("crank angle, deg"), Label::plain(name));
        let dashed = Series::line(variant.words(), BLACK, number(beside)).stroked(Stroke::Dashed);
        let colour = SERIES[place % SERIES.len()];
        chart.series = vec![Series::line("", colour, number(course)), dashed];
        chart
    });
    charts.collect()
}

fn scaled(points: Vec<[f64; 2]>, unit: f64) -> Vec<[f64; 2]> {
    points.into_iter().map(|[angle, value]| [angle, unit * value]).collect()
}

/// The magnitude of a vector over the crank angle.
fn magnitude(course: &OrbitCourse, components: [&Row; 2]) -> Vec<[f64; 2]> {
    let vectors = course.vectors(components, course.even_angles());
    course.even_angles().zip(vectors).map(|(angle, [x, y])| [angle, x.hypot(y)]).collect()
}
