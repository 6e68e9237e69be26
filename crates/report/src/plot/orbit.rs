//! The orbit of the journal: its path in the circle of the clearance, and what the film does over the crank angle.

use std::f64::consts::TAU;

use oilwedge_drawing::{
    BLACK, BLUE, Chart, Colour, Figure, GREEN, GREY, GRID, Kind, Label, Mark, Note, Series, VERMILION, charts_figure,
    number,
};
use oilwedge_study::orbit::OrbitPath;
use oilwedge_study::quantities::{FILM_THICKNESS_MIN, FRICTION_POWER, PRESSURE_MAX, Row};

/// Crank angles that are marked on the path [deg].
const MARKED: f64 = 60.0;
/// Points of the path between two films.
const POINTS: u32 = 12;
/// Rings of the circle of the clearance.
const RINGS: [f64; 4] = [0.25, 0.5, 0.75, 1.0];

/// The pictures of an orbit by name; `title` is that of the scene.
pub fn orbit_figures(title: &str, path: &OrbitPath, width: f64) -> Vec<(String, Figure)> {
    let charts = [
        over_cycle(path, &FILM_THICKNESS_MIN, 1e6, "least film thickness, um", BLUE),
        over_cycle(path, &PRESSURE_MAX, 1e-6, "greatest pressure, MPa", VERMILION),
        over_cycle(path, &FRICTION_POWER, 1.0, "power that turns the journal, W", GREEN),
    ];
    vec![
        (
            "orbit".to_owned(),
            charts_figure(&format!("Orbit: {title}"), &[circle(path)], 1, width),
        ),
        (
            "orbit_by_angle".to_owned(),
            charts_figure(&format!("Film over the cycle: {title}"), &charts, 1, width),
        ),
    ]
}

/// The path of the journal's centre in the circle of the clearance.
fn circle(path: &OrbitPath) -> Chart {
    let mut chart = Chart::new("", Label::default(), Label::default());
    chart.kind = Kind::Drawing;
    let point = |radius: f64, turn: f64| [radius * (TAU * turn).cos(), radius * (TAU * turn).sin()];
    for radius in RINGS {
        let ring = (0..=360).map(|k| point(radius, f64::from(k) / 360.0)).collect();
        let colour = if radius == 1.0 { BLACK } else { GRID };
        chart.series.push(Series::line("", colour, ring));
        chart.notes.push(Note {
            at: point(radius, -0.09),
            label: number(radius, 0.25),
            colour: GREY,
        });
    }
    for (turn, name) in [(0.0, "*x*"), (0.25, "*y*")] {
        chart
            .series
            .push(Series::line("", GRID, vec![point(1.0, turn + 0.5), point(1.0, turn)]));
        chart.notes.push(Note {
            at: point(1.06, turn),
            label: Label::marked(name),
            colour: GREY,
        });
    }
    let times = path.spans.iter().flat_map(|span| {
        let [from, to] = span.times;
        (0..POINTS).map(move |k| (span, from + (to - from) * f64::from(k) / f64::from(POINTS)))
    });
    let offset = |[x, y, ..]: [f64; 4]| [x / path.clearance, y / path.clearance];
    let mut curve: Vec<[f64; 2]> = times.map(|(span, time)| offset(span.at(time))).collect();
    curve.extend(path.offsets.last());
    chart.series.push(Series::line("", VERMILION, curve));
    let period = path.crank_angles.last().copied().unwrap_or(0.0);
    let marks = (0..)
        .map(|k| MARKED * f64::from(k))
        .take_while(|mark| *mark < period - 1e-9);
    let mut points = Vec::new();
    for mark in marks {
        let Some(at) = path.place(mark) else { continue };
        let at = offset(at);
        points.push(at);
        chart.notes.push(Note {
            at: [0.93 * at[0], 0.93 * at[1]],
            label: number(mark, 1.0),
            colour: BLACK,
        });
    }
    let name = "crank angle, each 60 deg; eccentricity over the clearance";
    chart.series.push(Series::marks(name, VERMILION, Mark::Disc, points));
    chart
}

/// A number over the crank angle.
fn over_cycle(path: &OrbitPath, row: &Row, unit: f64, name: &str, colour: Colour) -> Chart {
    let mut chart = Chart::new("", Label::plain("crank angle, deg"), Label::plain(name));
    let points = path.curve(row).into_iter().map(|[angle, value]| [angle, unit * value]);
    chart.series = vec![Series::line("", colour, points.collect())];
    chart
}
