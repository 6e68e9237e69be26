//! Figures 2 to 14 of the document, drawn anew: the right short bearing in lines, its real length in dashes, what is
//! printed in marks.

use std::f64::consts::PI;

use oilwedge_drawing::{
    BLUE, Chart, ChartKind, Colour, GREEN, INK, Label, Mark, Note, ORANGE, PAGE_WIDTH, SKY, Series, Stroke, VERMILION,
    charts_figure,
};

use crate::short_bearing_page::Study;
use oilwedge_tests::printed::rows;
use oilwedge_tests::short_crankshaft::{SPEEDS, SQUEEZES, Scales, film_at, right, right_pressure};

/// Colours of the speeds.
const COLOURS: [Colour; 5] = [BLUE, SKY, GREEN, ORANGE, VERMILION];
const GREY: Colour = Colour([150, 150, 150]);
/// The document's dimensionless pressures, loads and flows are four times too small, for its width is half of the right
/// one.
const LOST: f64 = 4.0;
/// Steps of a curve.
const STEPS: u32 = 180;

/// All sheets: name of the file and SVG.
pub fn sheets(study: &Study) -> Vec<(&'static str, String)> {
    let both = |chart: fn(f64, &Study) -> Chart| SQUEEZES.map(|squeeze| chart(squeeze, study));
    let sheets: [(&str, Vec<Chart>); 6] = [
        ("fig02_03_pressure_around", both(around).into()),
        ("fig04_05_greatest_pressure", both(greatest).into()),
        ("fig06_07_pressure_along", both(along).into()),
        ("fig08_09_10_load", vec![overload(study), load(study), attitude(study)]),
        ("fig11_12_direction", both(direction).into()),
        ("fig13_14_flow_power", vec![flow(study), power(study)]),
    ];
    sheets
        .into_iter()
        .map(|(name, charts)| (name, charts_figure("The short bearing", &charts, 2, PAGE_WIDTH).to_svg()))
        .collect()
}

/// How a series is drawn.
#[derive(Clone, Copy)]
enum Style {
    Line,
    Dashes,
    Discs,
    Rings,
}

fn series(name: &str, style: Style, colour: Colour, points: Vec<[f64; 2]>) -> Series {
    match style {
        Style::Line => Series::line(name, colour, points),
        Style::Dashes => Series::line(name, colour, points).stroked(Stroke::Dashed),
        Style::Discs => Series::marks(name, colour, Mark::Disc, points),
        Style::Rings => Series::marks(name, colour, Mark::Ring, points),
    }
}

/// The figures by number, its case first.
fn title(figures: [usize; 2], what: &str, squeeze: f64) -> String {
    let figure = figures[usize::from(squeeze > 0.0)];
    format!("Figure {figure}. {what}, E = {squeeze}")
}

/// Figures 2 and 3.
fn around(squeeze: f64, study: &Study) -> Chart {
    let mut curves = Vec::new();
    let mut dashes = Vec::new();
    let mut marks = Vec::new();
    let table = if squeeze > 0.0 { "table2" } else { "table1" };
    for (speed, colour) in SPEEDS.into_iter().zip(COLOURS) {
        let film = film_at(squeeze, speed);
        let from = film.loaded_from();
        let angles = (0..=STEPS).map(|k| from + PI * f64::from(k) / f64::from(STEPS));
        let points = angles.map(|phi| [phi.to_degrees(), right_pressure(&film, phi, 0.0)]);
        curves.push(series(&format!("right, n = {speed}/min"), Style::Line, colour, points.collect()));
        if speed == SPEEDS[4] {
            let finite = &study.of(squeeze, speed)[1];
            let angles = (0..=STEPS).map(|k| from + PI * f64::from(k) / f64::from(STEPS));
            let points = angles.map(|phi| [phi.to_degrees(), finite.pressure(phi, 0.0)]);
            dashes.push(series("finite length (Reynolds), n = 3200/min", Style::Dashes, colour, points.collect()));
        }
        let printed = rows(&format!("source000/{table}.csv"));
        let own = printed.iter().filter(|row| row.number("n") == speed);
        let points = own.map(|row| [row.number("phi[deg]"), LOST * row.number("Pi")]).collect();
        let name = if speed == SPEEDS[4] { "printed, times 4" } else { "" };
        marks.push(series(name, Style::Rings, colour, points));
    }
    let title = title([2, 3], "Pressure around the film at mid-width", squeeze);
    Chart {
        series: [curves, dashes, marks].concat(),
        ..Chart::new(&title, Label::marked("*φ* from the narrowest film, deg"), Label::marked("*Π*(*φ*, 0)"))
    }
}

/// Figures 6 and 7.
fn along(squeeze: f64, study: &Study) -> Chart {
    let mut curves = Vec::new();
    let mut dashes = Vec::new();
    let mut marks = Vec::new();
    for (speed, colour) in SPEEDS.into_iter().zip(COLOURS) {
        let film = film_at(squeeze, speed);
        let phi = film.loaded_from() + PI / 2.0;
        let places: Vec<f64> = (0..=40).map(|k| f64::from(k) / 20.0 - 1.0).collect();
        let points = places.iter().map(|&zeta| [zeta, right_pressure(&film, phi, zeta)]);
        curves.push(series(&format!("right, n = {speed}/min"), Style::Line, colour, points.collect()));
        if speed == SPEEDS[4] {
            let finite = &study.of(squeeze, speed)[1];
            let points = places.iter().map(|&zeta| [zeta, finite.pressure(phi, zeta)]).collect();
            dashes.push(series("finite length (Reynolds), n = 3200/min", Style::Dashes, colour, points));
        }
        let printed = rows("source000/table4.csv");
        let own = printed.iter().filter(|row| (row.number("E"), row.number("n")) == (squeeze, speed));
        let half = |row: &oilwedge_tests::printed::Row| {
            [row.number("z[-]") / Scales::printed().width, LOST * row.number("Pi")]
        };
        let points: Vec<_> = own.map(half).flat_map(|[z, p]| [[z, p], [-z, p]]).collect();
        let name = if speed == SPEEDS[4] { "printed, times 4" } else { "" };
        marks.push(series(name, Style::Rings, colour, points));
    }
    let title = title([6, 7], "Pressure along the axis amid the loaded half", squeeze);
    Chart {
        series: [curves, dashes, marks].concat(),
        ..Chart::new(&title, Label::marked("2 *z*/*B*"), Label::marked("*Π*(*φ*_{a}, *z*)"))
    }
}

/// A column of a table over the speed: right, of finite length, and printed, as it is and times what the scales lose.
fn over_speed(squeeze: f64, study: &Study, [table, column]: [&str; 2], lost: &[f64]) -> Vec<Series> {
    let colour = if squeeze > 0.0 { COLOURS[4] } else { COLOURS[0] };
    let steps = (0..=60).map(|k| SPEEDS[0] + (SPEEDS[4] - SPEEDS[0]) * f64::from(k) / 60.0);
    let points = steps.map(|speed| [speed, right(&film_at(squeeze, speed), column)]).collect();
    let mut all = vec![series(&format!("right, E = {squeeze}"), Style::Line, colour, points)];
    let finite = SPEEDS.into_iter().filter_map(|speed| Some([speed, study.of(squeeze, speed)[1].value(column)?]));
    let name = format!("finite length (Reynolds), E = {squeeze}");
    all.push(series(&name, Style::Dashes, colour, finite.collect()));
    let printed = rows(&format!("source000/{table}.csv"));
    for &factor in lost {
        let own = printed.iter().filter(|row| row.number("E") == squeeze);
        let points = own.map(|row| [row.number("n"), factor * row.number(column)]).collect();
        let (name, style) = match factor {
            1.0 => ("printed".to_owned(), Style::Discs),
            factor => (format!("printed, times {factor}"), Style::Rings),
        };
        all.push(series(&format!("{name}, E = {squeeze}"), style, colour, points));
    }
    all
}

fn chart(title: String, y: &str, series: Vec<Series>) -> Chart {
    Chart { series, ..Chart::new(&title, Label::marked("*n*, 1/min"), Label::marked(y)) }
}

fn both(study: &Study, place: [&str; 2], lost: &[f64]) -> Vec<Series> {
    SQUEEZES.map(|squeeze| over_speed(squeeze, study, place, lost)).concat()
}

/// Figures 4 and 5.
fn greatest(squeeze: f64, study: &Study) -> Chart {
    let title = title([4, 5], "Greatest pressure", squeeze);
    chart(title, "max *Π*", over_speed(squeeze, study, ["table3", "maxPi[-]"], &[1.0, LOST]))
}

/// Figure 8.
fn overload(study: &Study) -> Chart {
    let title = "Figure 8. Greatest over mean pressure".to_owned();
    chart(title, "*k* = max *Π* / So", both(study, ["table7", "kP[-]"], &[1.0]))
}

/// Figure 9.
fn load(study: &Study) -> Chart {
    let title = "Figure 9. Load number".to_owned();
    chart(title, "So", both(study, ["table7", "So[-]"], &[1.0, LOST]))
}

/// Figure 10.
fn attitude(study: &Study) -> Chart {
    let title = "Figure 10. Angle from the load to the line of centres".to_owned();
    chart(title, "*θ*, deg", both(study, ["table7", "theta[deg]"], &[1.0]))
}

/// Figure 13.
fn flow(study: &Study) -> Chart {
    let title = "Figure 13. Flow out of both ends".to_owned();
    chart(title, "q", both(study, ["table8", "q[-]"], &[1.0, LOST]))
}

/// Figure 14.
fn power(study: &Study) -> Chart {
    let title = "Figure 14. Power that becomes heat".to_owned();
    chart(title, "kN", both(study, ["table8", "kN[-]"], &[1.0]))
}

/// Figures 11 and 12: the force on the journal. The narrowest film is below, the journal turns against the clock.
fn direction(squeeze: f64, study: &Study) -> Chart {
    let circle = |[x, y]: [f64; 2], radius: f64| -> Vec<[f64; 2]> {
        let angles = (0..=72).map(|k| f64::from(5 * k).to_radians());
        angles.map(|phi| [x + radius * phi.cos(), y + radius * phi.sin()]).collect()
    };
    let centre = [0.0, -0.16];
    // At an angle from the line of centres, against the rotation.
    let along = |angle: f64, radius: f64| {
        let (sin, cos) = (-PI / 2.0 - angle).sin_cos();
        [centre[0] + radius * cos, centre[1] + radius * sin]
    };
    let mut all = vec![
        series("", Style::Line, GREY, circle([0.0, 0.0], 1.0)),
        series("", Style::Line, GREY, circle(centre, 0.8)),
        series("", Style::Dashes, INK, vec![[0.0, 1.1], [0.0, -1.1]]),
        series("", Style::Line, GREY, (-5..=5).map(|k| along(PI + f64::from(6 * k).to_radians(), 0.62)).collect()),
        series("", Style::Line, GREY, head(along(PI - 0.52, 0.62), 7.0 * PI / 6.0)),
    ];
    let force = |speed: f64| right(&film_at(squeeze, speed), "R[N]");
    for (speed, colour) in SPEEDS.into_iter().zip(COLOURS) {
        let angle = right(&film_at(squeeze, speed), "theta[rad]");
        let length = 0.75 * force(speed) / force(SPEEDS[4]);
        let tip = along(angle, length);
        all.push(series(&format!("right, n = {speed}/min"), Style::Line, colour, vec![centre, tip]));
        all.push(series("", Style::Line, colour, head(tip, -PI / 2.0 - angle)));
    }
    let angle = right(&film_at(squeeze, SPEEDS[4]), "theta[rad]");
    let finite = study.of(squeeze, SPEEDS[4])[1].value("theta[rad]").unwrap_or(angle);
    let name = "finite length (Reynolds), n = 3200/min";
    all.push(series(name, Style::Dashes, COLOURS[4], vec![along(finite, 0.0), along(finite, 0.96)]));
    for row in rows("source000/table7.csv").iter().filter(|row| row.number("E") == squeeze) {
        let place = SPEEDS.iter().position(|speed| *speed == row.number("n")).unwrap_or(0);
        let theta = row.number("theta[rad]");
        let name = if place == 4 { "printed, outside" } else { "" };
        let tick = vec![along(theta, 1.0), along(theta, 1.16)];
        all.push(series(name, Style::Line, COLOURS[place], tick));
    }
    let title = title([11, 12], "The force on the journal", squeeze);
    Chart {
        kind: ChartKind::Drawing,
        series: all,
        notes: vec![Note { at: [0.42, 1.08], label: Label::plain("line of centres"), colour: INK }],
        ..Chart::new(&title, Label::default(), Label::default())
    }
}

/// The head of an arrow that ends there.
fn head([x, y]: [f64; 2], direction: f64) -> Vec<[f64; 2]> {
    let wing = |turn: f64| {
        let (sin, cos) = (direction + turn).sin_cos();
        [x - 0.07 * cos, y - 0.07 * sin]
    };
    vec![wing(0.4), [x, y], wing(-0.4)]
}
