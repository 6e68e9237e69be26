//! Profiles around the liner and along its axis, both through the greatest pressure; and the temperatures through the
//! hottest place.

use oilwedge_drawing::{
    BLUE, Chart, Figure, GREEN, Label, Scale, Series, VERMILION, charts_figure, least_and_greatest,
};
use oilwedge_study::fields::{FILM_FRACTION, FILM_THICKNESS, FieldRow, PRESSURE};

use super::field_map::peak;
use super::film::DrawnFilm;
use super::hottest::temperature_charts;
use super::sample::Finder;
use crate::readable::{axis_label, readable_unit_of};

/// Points of a profile around and along.
const AROUND: usize = 720;
const ALONG: usize = 200;

/// Line along which a profile runs.
#[derive(Debug, Clone, Copy)]
enum Line {
    Around,
    Along,
}

/// The profiles; `None` without a pressure.
pub(super) fn profiles_figure(film: &DrawnFilm, width: f64) -> Option<Figure> {
    let pressures = film.values(PRESSURE.name)?;
    let [x, z] = peak(&film.cells, pressures)?;
    let finder = Finder::new(film);
    let [from, to] = film.liner.angles();
    let [low, high] = least_and_greatest(film.cells.iter().flatten().map(|node| node[1]));
    let steps =
        |count: usize, from: f64, to: f64| (0..=count).map(move |k| from + (to - from) * k as f64 / count as f64);
    let angles: Vec<f64> = steps(AROUND, from, to).collect();
    let around: Vec<[f64; 2]> = angles.iter().map(|angle| [angle * film.radius(), z]).collect();
    let places: Vec<f64> = steps(ALONG, low, high).collect();
    let along: Vec<[f64; 2]> = places.iter().map(|place| [x, *place]).collect();
    let chart = |row: &FieldRow, line: Line, colour| {
        let (points, places, scale) = match line {
            Line::Around => {
                (&around, angles.iter().map(|angle| angle.to_degrees()).collect::<Vec<_>>(), Scale::Degrees)
            }
            Line::Along => (&along, places.iter().map(|place| 1e3 * place).collect(), Scale::Linear),
        };
        let values = finder.values(row, points)?;
        let most = values
            .iter()
            .copied()
            .filter(|value| value.is_finite())
            .fold(0.0, |most: f64, value| most.max(value.abs()));
        let (unit, size) = readable_unit_of(most, row.unit);
        let (title, name) = match line {
            Line::Around => (
                // Without the sign of a zero.
                format!("Around the liner at z = {:.1} mm", (1e4 * z).round() / 10.0 + 0.0),
                Label::plain("angle on the liner"),
            ),
            Line::Along => {
                let degrees = (x / film.radius()).to_degrees().rem_euclid(360.0);
                (format!("Along the axis at {degrees:.1}\u{b0}"), Label::marked("axis *z*, mm"))
            }
        };
        let mut chart = Chart::new(&title, name, Label::marked(&axis_label(row.label, row.symbol, unit)));
        chart.x.1 = scale;
        let points = places.into_iter().zip(values).map(|(place, value)| [place, value / size]);
        chart.series = vec![Series::line("", colour, points.collect())];
        Some(chart)
    };
    let charts = [
        chart(&PRESSURE, Line::Around, BLUE),
        chart(&PRESSURE, Line::Along, BLUE),
        chart(&FILM_THICKNESS, Line::Around, VERMILION),
        chart(&FILM_FRACTION, Line::Around, GREEN),
    ];
    let charts: Vec<Chart> = charts.into_iter().flatten().chain(temperature_charts(film, &finder, &angles)).collect();
    let columns = if width > 120.0 { 2 } else { 1 };
    Some(charts_figure(&film.result.head.title, &charts, columns, width))
}
