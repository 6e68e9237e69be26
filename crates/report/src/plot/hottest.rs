//! Temperatures of a film through its hottest place: of bush, oil and journal around the liner, of the bush as a polar
//! diagram, and across the film.

use oilwedge_drawing::{
    BLACK, BLUE, Chart, ChartKind, Colour, GREEN, GREY, GRID, Label, Mark, Note, ORANGE, Scale, Series, VERMILION,
    least_and_greatest, linear_steps, number,
};
use oilwedge_study::fields::{BUSH_TEMPERATURE, FieldRow, GREATEST_TEMPERATURE, JOURNAL_TEMPERATURE, TEMPERATURE};

use super::field_map::peak;
use super::film::DrawnFilm;
use super::sample::Finder;

/// Points of the curve across the film.
const ACROSS: usize = 60;
/// Rings of the polar diagram, at most.
const RINGS: f64 = 4.0;
/// Where the temperatures of the rings stand [deg].
const RING_LABELS: f64 = -30.0;
/// Radius of the circle of the lowest ring, over the length of the axis between the lowest and the highest one.
const HUB: f64 = 0.8;
/// Points of a ring, and every which angle is named [deg].
const RING_POINTS: u32 = 360;
const NAMED: usize = 45;

/// The charts; none of a film that has one temperature.
pub(super) fn temperature_charts(film: &DrawnFilm, finder: &Finder, angles: &[f64]) -> Vec<Chart> {
    let Some([_, z]) = film.values(GREATEST_TEMPERATURE.name).and_then(|values| peak(&film.cells, values)) else {
        return Vec::new();
    };
    let points: Vec<[f64; 2]> = angles.iter().map(|angle| [angle * film.radius(), z]).collect();
    let around = |row: &FieldRow| -> Option<Vec<[f64; 2]>> {
        let values = finder.values(row, &points)?;
        Some(angles.iter().zip(values).map(|(angle, value)| [angle.to_degrees(), value]).collect())
    };
    // Without the sign of a zero.
    let place = format!("at z = {:.1} mm", (1e4 * z).round() / 10.0 + 0.0);
    let mut chart =
        Chart::new(&format!("Temperature around the liner {place}"), Label::plain("angle on the liner"), celsius());
    chart.x.1 = Scale::Degrees;
    let rows = [
        ("bush", &BUSH_TEMPERATURE, VERMILION),
        ("oil, mean across the film", &TEMPERATURE, ORANGE),
        ("journal", &JOURNAL_TEMPERATURE, BLUE),
    ];
    let line = |(name, row, colour): (&str, &FieldRow, Colour)| Some(Series::line(name, colour, around(row)?));
    chart.series = rows.into_iter().filter_map(line).collect();
    let bush =
        around(&BUSH_TEMPERATURE).map(|curve| polar(&format!("Temperature of the bush, \u{b0}C, {place}"), &curve));
    [Some(chart), across(film), bush].into_iter().flatten().collect()
}

fn celsius() -> Label {
    Label::plain("temperature, \u{b0}C")
}

/// The temperature across the film where it is hottest.
fn across(film: &DrawnFilm) -> Option<Chart> {
    let found = film.result.temperature_across.as_ref()?;
    let curve = (0..=ACROSS).map(|k| k as f64 / ACROSS as f64).map(|eta| Some([eta, found.at(eta)?]));
    let points = found.eta.iter().zip(&found.temperature).map(|(eta, t)| [*eta, *t]).collect();
    let title = format!("Across the film where it is hottest, {:.1}\u{b0}", found.angle);
    let mut chart = Chart::new(&title, Label::marked("from bush to journal *y*/*h*"), celsius());
    chart.series = vec![
        Series::line("", GREEN, curve.collect::<Option<_>>()?),
        Series::marks("points across the film", GREEN, Mark::Disc, points),
    ];
    Some(chart)
}

/// Temperatures over angles [deg], as lengths from a circle outwards.
fn polar(title: &str, curve: &[[f64; 2]]) -> Chart {
    let [least, greatest] = least_and_greatest(curve.iter().map(|point| point[1]).filter(|t| t.is_finite()));
    let step = linear_steps(f64::max(greatest - least, f64::EPSILON * greatest.abs()), RINGS);
    let (low, high) = ((least / step).floor(), (greatest / step).ceil());
    let hub = HUB * step * (high - low).max(1.0);
    let point = |degrees: f64, t: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        [cos, sin].map(|part| (hub + t - step * low) * part)
    };
    let mut chart = Chart::new(title, Label::default(), Label::default());
    chart.kind = ChartKind::Drawing;
    for k in 0..=(high - low) as u32 {
        let t = step * (low + f64::from(k));
        let ring = (0..=RING_POINTS).map(|k| point(f64::from(k), t)).collect();
        let colour = if k == 0 { BLACK } else { GRID };
        chart.series.push(Series::line("", colour, ring));
        chart.notes.push(Note { at: point(RING_LABELS, t), label: number(t, step), colour: GREY });
    }
    for degrees in (0..360).step_by(NAMED).map(|degrees| degrees as f64) {
        let (from, to) = (point(degrees, step * low), point(degrees, step * high));
        chart.series.push(Series::line("", GRID, vec![from, to]));
        let label = Label::plain(&format!("{degrees}\u{b0}"));
        chart.notes.push(Note { at: point(degrees, step * high + 0.15 * hub), label, colour: GREY });
    }
    chart.series.push(Series::line("bush", VERMILION, curve.iter().map(|[degrees, t]| point(*degrees, *t)).collect()));
    chart
}
