//! The cross-section of the bearing at mid-length: shell with the shape of its bore, feeds, journal, the gap
//! exaggerated, rotation, load, attitude angle, and the pressure around.

use std::f64::consts::{FRAC_PI_2, TAU};

use oilwedge_drawing::{
    Anchor, BLACK, BLUE, Colour, Figure, GREY, GRID, INK, Label, Letters, POINT, Pen, Polar, SKY, SMALLEST_LETTERS,
    Stroke, VERMILION, WHITE, linear_steps, number,
};
use oilwedge_study::fields::PRESSURE;
use oilwedge_study::quantities::{ATTITUDE_ANGLE, ECCENTRICITY, FILM_THICKNESS_MIN, LOAD, LOAD_ANGLE, Row};

use super::bore::{DrawnBore, extent, wrapped};
use super::field_map::draw_head;
use super::film::DrawnFilm;
use super::sample::Finder;
use crate::readable::{printed_symbol, printed_unit, readable_unit, readable_unit_of};

/// Radii over the width of the sheet: bore of the shell, thickness of the shell, room of the pressure.
const BORE: f64 = 0.25;
const WALL: f64 = 0.035;
const RELIEF: f64 = 0.14;
/// Directions [rad] that are one in the picture.
const SAME_DIRECTION: f64 = 0.02;
/// Widest sheet of this picture [mm].
const WIDEST: f64 = 120.0;
/// The shell and the journal.
const SHELL: Colour = Colour([205, 208, 212]);
const JOURNAL: Colour = Colour([236, 238, 240]);
/// Points of the pressure around.
const POINTS: usize = 720;

/// The cross-section; `None` without a position of the journal.
pub(super) fn section_figure(film: &DrawnFilm, width: f64) -> Option<Figure> {
    let width = width.min(WIDEST);
    let [eccentricity, towards] = film.position()?;
    let numbers = numbers(film);
    let description = format!(
        "{}: the bearing seen along its axis, the gap exaggerated, and the pressure at mid-length. {}.",
        film.result.head.title,
        numbers.text()
    );
    let mut figure = Figure::new([width, 0.0], &format!("{}: cross-section", film.result.head.title), &description);
    let top = draw_head(&mut figure, &film.result.head.title, &numbers, width);
    let shape = DrawnBore::of(film, BORE * width);
    let outer = BORE * width + WALL * width;
    let half = outer + RELIEF * width + 7.0;
    let centre = [0.5 * width, top + half];
    let axes = Polar { centre, base: outer, scale: 1.0 };
    draw_angles(&mut figure, axes, RELIEF * width);
    draw_pressure(&mut figure, film, axes, RELIEF * width);
    draw_shell(&mut figure, film, axes, (&shape, outer));
    let journal = axes.point(towards, eccentricity * shape.gap);
    let radius = shape.circle - shape.gap;
    figure.disc(journal, radius, JOURNAL, Pen::new(0.8, INK));
    draw_motion(&mut figure, film, Polar { centre: journal, ..axes }, radius);
    // The line of centres, from the liner's through the journal's.
    figure.line(&[centre, axes.point(towards, shape.at(towards))], Pen::new(0.7, INK).stroked(Stroke::Dashed));
    let elsewhere = film.thinnest().map(|(angle, _)| angle);
    let elsewhere = elsewhere.filter(|angle| wrapped(angle - towards).abs() > SAME_DIRECTION);
    if let Some(angle) = elsewhere {
        let across = [axes.point(angle, shape.at(angle)), axes.point(angle, outer)];
        figure.line(&across, Pen::new(1.2, BLACK).stroked(Stroke::Dotted));
    }
    let dot = |figure: &mut Figure, at: [f64; 2], colour: Colour| figure.disc(at, 0.55, colour, Pen::new(0.5, WHITE));
    dot(&mut figure, centre, BLACK);
    dot(&mut figure, journal, VERMILION);
    let letters = Letters::sized(SMALLEST_LETTERS).coloured(GREY);
    let times = shape.gap / shape.circle * film.radius() / film.result.geometry.clearance;
    let mut notes = vec![format!(
        "outside the shell: pressure at mid-length; gap drawn {} times too wide",
        (times / 5.0).round() * 5.0
    )];
    notes.extend(elsewhere.map(|angle| {
        format!("dotted in the shell: thinnest film, at {:.1}\u{b0}", angle.to_degrees().rem_euclid(360.0))
    }));
    let bottom = top + 2.0 * half;
    for (line, note) in (0..).zip(&notes) {
        figure.text(
            [1.0, bottom + (0.5 + f64::from(line)) * letters.line()],
            &Label::plain(note),
            letters,
            Anchor::Left,
        );
    }
    figure.set_height(bottom + notes.len() as f64 * letters.line() + 1.0);
    Some(figure)
}

/// The main numbers in one line.
fn numbers(film: &DrawnFilm) -> Label {
    let mut label = Label::default();
    for row in [&LOAD, &ECCENTRICITY, &ATTITUDE_ANGLE, &FILM_THICKNESS_MIN] {
        let Some(value) = film.quantity(row) else { continue };
        if !label.is_empty() {
            label = label.and(Label::plain(", "));
        }
        label = label.and(Label::marked(&equation(row, value)));
    }
    label
}

fn equation(row: &Row, value: f64) -> String {
    let (unit, size) = readable_unit(value, row.unit);
    let unit = printed_unit(unit);
    let space = if unit.is_empty() || unit == "\u{b0}" { "" } else { " " };
    let value = value / size;
    let decimals = (2.0 - value.abs().max(1e-3).log10().floor()).clamp(0.0, 3.0) as usize;
    format!("{} = {value:.decimals$}{space}{unit}", printed_symbol(row.symbol)).replace('-', "\u{2212}")
}

/// The pressure at mid-length outside the shell, on rings of round values.
fn draw_pressure(figure: &mut Figure, film: &DrawnFilm, axes: Polar, room: f64) {
    let [from, to] = film.liner.angles();
    let angles: Vec<f64> = (0..=POINTS).map(|k| from + (to - from) * k as f64 / POINTS as f64).collect();
    let points: Vec<[f64; 2]> = angles.iter().map(|angle| [angle * film.radius(), 0.0]).collect();
    let Some(values) = Finder::new(film).values(&PRESSURE, &points) else {
        return;
    };
    let finite = || values.iter().copied().filter(|value| value.is_finite());
    let (low, high) = (finite().fold(0.0, f64::min), finite().fold(0.0, f64::max));
    if high - low <= 0.0 {
        return;
    }
    let (unit, size) = readable_unit_of(high.max(-low), PRESSURE.unit);
    // Tension is drawn inwards from the circle of zero.
    let tension = if low < -1e-3 * high { -low / (high - low) * room } else { 0.0 };
    let axes = Polar { base: axes.base + tension, scale: (room - tension) / (high / size).max(1e-300), ..axes };
    let step = linear_steps(high / size, 3.0);
    let count = (high / size / step + 1e-9).floor() as usize;
    for k in 1..=count {
        figure.line(&axes.arc(axes.base + axes.scale * step * k as f64, from, to), Pen::new(0.4, GRID));
    }
    let runs = angles.iter().zip(&values).collect::<Vec<_>>();
    for run in runs.split(|(_, value)| !value.is_finite()).filter(|run| run.len() > 1) {
        let curve: Vec<[f64; 2]> = run.iter().map(|(angle, value)| [**angle, **value / size]).collect();
        axes.draw_curve(figure, &curve, SKY.towards(WHITE, 0.65), Pen::new(1.0, BLUE));
    }
    if tension > 0.0 {
        figure.line(&axes.arc(axes.base, from, to), Pen::new(0.4, INK));
    }
    // Numbers where there is least pressure along the whole ring.
    let is_quiet = |angle: f64| {
        let near = angles.iter().zip(&values).filter(|(other, _)| (*other - angle).abs() < 0.35);
        near.map(|(_, value)| if value.is_finite() { value.abs() } else { 0.0 }).fold(0.0, f64::max)
    };
    let candidates = angles.iter().step_by(12).copied().filter(|angle| angle - from > 0.2 && to - angle > 0.2);
    let along = candidates.min_by(|a, b| is_quiet(*a).total_cmp(&is_quiet(*b))).unwrap_or(from);
    let letters = Letters::sized(SMALLEST_LETTERS).coloured(GREY).with_halo();
    for k in 1..=count {
        let value = step * k as f64;
        let unit = if k == count { format!(" {}", printed_unit(unit)) } else { String::new() };
        let label = number(value, step).and(Label::plain(&unit));
        figure.text(axes.point(along, axes.base + axes.scale * value), &label, letters, Anchor::Centre);
    }
}

/// Shell and feeds.
fn draw_shell(figure: &mut Figure, film: &DrawnFilm, axes: Polar, (shape, outer): (&DrawnBore, f64)) {
    let ends = film.liner.angles();
    // Between the bore, a distance inwards, and a circle.
    let sector = |[from, to]: [f64; 2], (inwards, outer): (f64, f64)| -> Vec<[f64; 2]> {
        let back = shape.arc(axes, [to, from], inwards);
        axes.arc(outer, from, to).into_iter().chain(back).collect()
    };
    match film.result.geometry.arc.is_none() {
        true => {
            figure.disc(axes.centre, outer, SHELL, Pen::new(0.8, INK));
            match shape.radii.is_empty() {
                true => figure.disc(axes.centre, shape.circle, WHITE, Pen::new(0.8, INK)),
                false => {
                    let bore = shape.arc(axes, ends, 0.0);
                    figure.polygon(&bore, WHITE);
                    figure.outline(&bore, Pen::new(0.8, INK));
                }
            }
        }
        false => {
            let sector = sector(ends, (0.0, outer));
            figure.polygon(&sector, SHELL);
            figure.outline(&sector, Pen::new(0.8, INK));
        }
    }
    let deepest = outer - WALL / (BORE + WALL) * outer;
    for (_, pieces) in film.rims() {
        let feed = sector(extent(pieces, film.radius()), (0.15, deepest + 0.7 * (outer - deepest)));
        figure.polygon(&feed, SKY);
    }
}

/// Angles around, outside of all else.
fn draw_angles(figure: &mut Figure, axes: Polar, room: f64) {
    let letters = Letters::sized(SMALLEST_LETTERS);
    for quarter in 0..4 {
        let angle = f64::from(quarter) * FRAC_PI_2;
        let end = axes.base + room;
        figure.line(&[axes.point(angle, axes.base), axes.point(angle, end)], Pen::new(0.4, GRID));
        let label = Label::plain(&format!("{}\u{b0}", 90 * quarter));
        let half = 0.5 * if quarter % 2 == 0 { label.width(letters) } else { letters.capital() };
        figure.text(axes.point(angle, end + 2.0 + half), &label, letters, Anchor::Centre);
    }
}

/// Rotation, load and attitude angle about the journal's centre.
fn draw_motion(figure: &mut Figure, film: &DrawnFilm, axes: Polar, radius: f64) {
    let letters = Letters::default();
    let load = film.quantity(&LOAD_ANGLE).map(f64::to_radians);
    let attitude = film.quantity(&ATTITUDE_ANGLE).map(f64::to_radians);
    let towards = film.position().map_or(0.0, |[_, angle]| angle);
    if film.result.geometry.speed != 0.0 {
        // Across from the load, where nothing else is drawn.
        let middle = load.map_or(towards, |load| load + 0.5 * attitude.unwrap_or(0.0)) + TAU / 2.0;
        let half = 0.6 * film.result.geometry.speed.signum();
        let arc = axes.arc(0.62 * radius, middle - half, middle + half);
        figure.line(&arc, Pen::new(1.0, INK));
        if let [.., from, tip] = arc.as_slice() {
            let back = [2.0 * from[0] - tip[0], 2.0 * from[1] - tip[1]];
            figure.arrow_head(back, *tip, 2.0, INK);
        }
        figure.text(axes.point(middle, 0.62 * radius - 3.0), &Label::marked("*\u{3c9}*"), letters, Anchor::Centre);
    }
    let Some(load) = load else { return };
    let tip = axes.point(load, 0.82 * radius);
    figure.line(&[axes.centre, axes.point(load, 0.78 * radius)], Pen::new(1.6, VERMILION));
    figure.arrow_head(axes.centre, tip, 2.6, VERMILION);
    let turn = attitude.unwrap_or(0.0);
    // The letter of the load on the side away from the attitude angle.
    let aside = if turn >= 0.0 { -1.0 } else { 1.0 };
    let clear = 2.2 * letters.capital() / (0.66 * radius);
    let coloured = letters.coloured(VERMILION).with_halo();
    figure.text(axes.point(load + aside * clear, 0.66 * radius), &Label::marked("*W*"), coloured, Anchor::Centre);
    if turn.abs() > 1e-3 {
        let distance = 0.42 * radius;
        let arc = axes.arc(distance, load, load + turn);
        figure.line(&arc, Pen::new(0.8, INK));
        if let [.., from, tip] = arc.as_slice() {
            figure.arrow_head(*from, *tip, f64::min(1.6, 0.5 * distance * turn.abs()), INK);
        }
        // Inside the angle where it has room, else behind it.
        let room = distance * turn.abs();
        let label = Label::marked("*\u{3b2}*");
        let needed = label.width(letters) + 6.0 * POINT;
        let at = if room > 2.0 * needed { load + 0.5 * turn } else { load + turn + turn.signum() * needed / distance };
        figure.text(axes.point(at, distance + 2.2), &label, letters.with_halo(), Anchor::Centre);
    }
}
