//! The cross-section of the bearing at mid-length: shell with the shape of its bore, feeds, journal, the gap exaggerated, rotation, load, attitude angle, and the pressure around.

use std::f64::consts::{FRAC_PI_2, TAU};

use oilwedge_drawing::{
    Anchor, BLACK, BLUE, Colour, Figure, GREY, GRID, INK, Label, Letters, POINT, Pen, Polar, SKY, SMALLEST_LETTERS,
    Stroke, VERMILION, WHITE, least_and_greatest, linear_steps, number,
};
use oilwedge_study::fields::{FILM_THICKNESS, PRESSURE};
use oilwedge_study::quantities::{ATTITUDE_ANGLE, ECCENTRICITY, FILM_THICKNESS_MIN, LOAD, LOAD_ANGLE, Row};

use super::field_map::draw_head;
use super::film::DrawnFilm;
use super::sample::Finder;
use crate::readable::{printed_symbol, printed_unit, readable_unit, readable_unit_of};

/// Radii over the width of the sheet: bore of the shell, thickness of the shell, room of the pressure.
const BORE: f64 = 0.25;
const WALL: f64 = 0.035;
const RELIEF: f64 = 0.14;
/// The gap at no eccentricity over the bore, where it is deepest.
const GAP: f64 = 0.17;
/// A bore that is off its circle by more than this part of the clearance is drawn so.
const SHAPED: f64 = 0.01;
/// Directions [rad] that are one in the picture.
const SAME_DIRECTION: f64 = 0.02;
/// Widest sheet of this picture [mm].
const WIDEST: f64 = 120.0;
/// The shell and the journal.
const SHELL: Colour = Colour([205, 208, 212]);
const JOURNAL: Colour = Colour([236, 238, 240]);
/// Points of the pressure and of the bore around.
const POINTS: usize = 720;

/// The cross-section; `None` without a position of the journal.
pub(super) fn section_figure(film: &DrawnFilm, width: f64) -> Option<Figure> {
    let width = width.min(WIDEST);
    let [eccentricity, towards] = film.position()?;
    let numbers = numbers(film);
    let description = format!(
        "{}: the bearing seen along its axis, the gap exaggerated, and the pressure at mid-length. {}.",
        film.title,
        numbers.text()
    );
    let mut figure = Figure::new([width, 0.0], &format!("{}: cross-section", film.title), &description);
    let top = draw_head(&mut figure, &film.title, &numbers, width);
    let shape = Shape::of(film, BORE * width);
    let outer = BORE * width + WALL * width;
    let half = outer + RELIEF * width + 7.0;
    let centre = [0.5 * width, top + half];
    let axes = Polar {
        centre,
        base: outer,
        scale: 1.0,
    };
    draw_angles(&mut figure, axes, RELIEF * width);
    draw_pressure(&mut figure, film, axes, RELIEF * width);
    draw_shell(&mut figure, film, axes, (&shape, outer));
    let journal = axes.point(towards, eccentricity * shape.gap);
    let radius = shape.circle - shape.gap;
    figure.disc(journal, radius, JOURNAL, Pen::new(0.8, INK));
    draw_motion(
        &mut figure,
        film,
        Polar {
            centre: journal,
            ..axes
        },
        radius,
    );
    // The line of centres, from the liner's through the journal's.
    figure.line(
        &[centre, axes.point(towards, shape.at(towards))],
        Pen::new(0.7, INK).stroked(Stroke::Dashed),
    );
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
    let times = shape.gap / shape.circle * film.radius / film.clearance;
    let mut notes = vec![format!(
        "outside the shell: pressure at mid-length; gap drawn {} times too wide",
        (times / 5.0).round() * 5.0
    )];
    notes.extend(elsewhere.map(|angle| {
        format!(
            "dotted in the shell: thinnest film, at {:.1}\u{b0}",
            angle.to_degrees().rem_euclid(360.0)
        )
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

/// An angle [rad] between -pi and pi.
fn wrapped(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}

/// The bore at mid-length as it is drawn.
struct Shape {
    /// Radius of the circle of the bearing's diameter [mm].
    circle: f64,
    /// The clearance [mm].
    gap: f64,
    /// Radius of the bore [mm] at even steps from the liner's first angle [rad] on; none of a circle.
    radii: Vec<f64>,
    from: f64,
    step: f64,
}

impl Shape {
    /// The bore whose deepest place is drawn at a distance [mm] from the middle: what the film is thicker than between circles.
    fn of(film: &DrawnFilm, deepest: f64) -> Self {
        let [from, to] = film.liner.angles();
        let step = (to - from) / POINTS as f64;
        let angles: Vec<f64> = (0..=POINTS).map(|k| from + step * k as f64).collect();
        let depths = depths(film, &angles).unwrap_or_default();
        let off = depths.iter().map(|depth| depth.abs()).fold(0.0, f64::max);
        let depths = if off > SHAPED { depths } else { Vec::new() };
        let most = depths.iter().copied().fold(0.0, f64::max);
        let gap = GAP * deepest / (1.0 + most);
        let circle = deepest - most * gap;
        Self {
            circle,
            gap,
            radii: depths.into_iter().map(|depth| circle + gap * depth).collect(),
            from,
            step,
        }
    }

    /// Radius of the bore [mm] at an angle [rad].
    fn at(&self, angle: f64) -> f64 {
        let steps = (angle - self.from).rem_euclid(TAU) / self.step;
        let last = self.radii.len().saturating_sub(1);
        let k = (steps as usize).min(last.saturating_sub(1));
        match self.radii.get(k..k + 2) {
            Some(&[a, b]) => a + (steps - k as f64).min(1.0) * (b - a),
            _ => self.circle,
        }
    }

    /// The bore between two angles [rad], at a distance [mm] from it.
    fn arc(&self, axes: Polar, [from, to]: [f64; 2], inwards: f64) -> Vec<[f64; 2]> {
        match self.radii.is_empty() {
            true => axes.arc(self.circle - inwards, from, to),
            false => {
                let count = ((to - from).abs() / self.step).ceil().max(1.0) as usize;
                let angle = |k: usize| from + (to - from) * k as f64 / count as f64;
                (0..=count)
                    .map(|k| axes.point(angle(k), self.at(angle(k)) - inwards))
                    .collect()
            }
        }
    }
}

/// How much deeper than its circle the bore is at angles [rad] at mid-length, over the clearance; straight between the ends of holes, grooves and pockets. `None` without a film at mid-length.
fn depths(film: &DrawnFilm, angles: &[f64]) -> Option<Vec<f64>> {
    let [eccentricity, towards] = film.position()?;
    let points: Vec<[f64; 2]> = angles.iter().map(|angle| [angle * film.radius, 0.0]).collect();
    let values = Finder::new(film).values(&FILM_THICKNESS, &points)?;
    let extents: Vec<[f64; 2]> = film.rims().map(|(_, pieces)| extent(pieces, film.radius)).collect();
    let is_cut = |angle: f64| {
        (extents.iter()).any(|[low, high]| (angle - low + SLACK).rem_euclid(TAU) <= high - low + 2.0 * SLACK)
    };
    let known: Vec<(usize, f64)> = (angles.iter().zip(values).enumerate())
        .filter(|(_, (angle, value))| value.is_finite() && !is_cut(**angle))
        .map(|(k, (angle, value))| (k, value / film.clearance - 1.0 + eccentricity * (angle - towards).cos()))
        .collect();
    let (first, last) = (known.first()?, known.last()?);
    let at = |k: usize| {
        let next = known.partition_point(|(at, _)| *at < k);
        let before = next.checked_sub(1).map_or(first, |before| &known[before]);
        let after = known.get(next).unwrap_or(last);
        let length = after.0.saturating_sub(before.0).max(1) as f64;
        let part = (k.saturating_sub(before.0)) as f64 / length;
        before.1 + part.clamp(0.0, 1.0) * (after.1 - before.1)
    };
    Some((0..angles.len()).map(at).collect())
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
    let angles: Vec<f64> = (0..=POINTS)
        .map(|k| from + (to - from) * k as f64 / POINTS as f64)
        .collect();
    let points: Vec<[f64; 2]> = angles.iter().map(|angle| [angle * film.radius, 0.0]).collect();
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
    let tension = if low < -1e-3 * high {
        -low / (high - low) * room
    } else {
        0.0
    };
    let axes = Polar {
        base: axes.base + tension,
        scale: (room - tension) / (high / size).max(1e-300),
        ..axes
    };
    let step = linear_steps(high / size, 3.0);
    let count = (high / size / step + 1e-9).floor() as usize;
    for k in 1..=count {
        figure.line(
            &axes.arc(axes.base + axes.scale * step * k as f64, from, to),
            Pen::new(0.4, GRID),
        );
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
        let near = angles
            .iter()
            .zip(&values)
            .filter(|(other, _)| (*other - angle).abs() < 0.35);
        near.map(|(_, value)| if value.is_finite() { value.abs() } else { 0.0 })
            .fold(0.0, f64::max)
    };
    let candidates = angles
        .iter()
        .step_by(12)
        .copied()
        .filter(|angle| angle - from > 0.2 && to - angle > 0.2);
    let along = candidates
        .min_by(|a, b| is_quiet(*a).total_cmp(&is_quiet(*b)))
        .unwrap_or(from);
    let letters = Letters::sized(SMALLEST_LETTERS).coloured(GREY).with_halo();
    for k in 1..=count {
        let value = step * k as f64;
        let unit = if k == count {
            format!(" {}", printed_unit(unit))
        } else {
            String::new()
        };
        let label = number(value, step).and(Label::plain(&unit));
        figure.text(
            axes.point(along, axes.base + axes.scale * value),
            &label,
            letters,
            Anchor::Centre,
        );
    }
}

/// Shell and feeds.
fn draw_shell(figure: &mut Figure, film: &DrawnFilm, axes: Polar, (shape, outer): (&Shape, f64)) {
    let ends = film.liner.angles();
    // Between the bore, a distance inwards, and a circle.
    let sector = |[from, to]: [f64; 2], (inwards, outer): (f64, f64)| -> Vec<[f64; 2]> {
        let back = shape.arc(axes, [to, from], inwards);
        axes.arc(outer, from, to).into_iter().chain(back).collect()
    };
    match film.is_ring {
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
        let feed = sector(extent(pieces, film.radius), (0.15, deepest + 0.7 * (outer - deepest)));
        figure.polygon(&feed, SKY);
    }
}

/// Angles around, outside of all else.
fn draw_angles(figure: &mut Figure, axes: Polar, room: f64) {
    let letters = Letters::sized(SMALLEST_LETTERS);
    for quarter in 0..4 {
        let angle = f64::from(quarter) * FRAC_PI_2;
        let end = axes.base + room;
        figure.line(
            &[axes.point(angle, axes.base), axes.point(angle, end)],
            Pen::new(0.4, GRID),
        );
        let label = Label::plain(&format!("{}\u{b0}", 90 * quarter));
        let half = 0.5
            * if quarter % 2 == 0 {
                label.width(letters)
            } else {
                letters.capital()
            };
        figure.text(axes.point(angle, end + 2.0 + half), &label, letters, Anchor::Centre);
    }
}

/// Angles [rad] that are one.
const SLACK: f64 = 1e-6;

/// The angles [rad] that a rim covers, from the lesser on to the greater: all but the widest gap between its pieces.
fn extent(pieces: &[[[f64; 2]; 2]], radius: f64) -> [f64; 2] {
    let mut covered: Vec<[f64; 2]> = (pieces.iter())
        .map(|piece| {
            let [low, high] = least_and_greatest(piece.iter().map(|point| point[0] / radius));
            let from = low.rem_euclid(TAU);
            [from, from + high - low]
        })
        .collect();
    covered.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let Some(first) = covered.first().copied() else {
        return [0.0; 2];
    };
    // The first piece comes again after a turn.
    let again = [first[0] + TAU, first[1] + TAU];
    let (mut end, mut widest, mut found) = (first[1], SLACK, [first[0], first[0] + TAU]);
    for [from, to] in covered.into_iter().skip(1).chain([again]) {
        if from - end > widest {
            widest = from - end;
            found = [from, end + TAU];
        }
        end = end.max(to);
    }
    found
}

/// Rotation, load and attitude angle about the journal's centre.
fn draw_motion(figure: &mut Figure, film: &DrawnFilm, axes: Polar, radius: f64) {
    let letters = Letters::default();
    let load = film.quantity(&LOAD_ANGLE).map(f64::to_radians);
    let attitude = film.quantity(&ATTITUDE_ANGLE).map(f64::to_radians);
    let towards = film.position().map_or(0.0, |[_, angle]| angle);
    if film.speed != 0.0 {
        // Across from the load, where nothing else is drawn.
        let middle = load.map_or(towards, |load| load + 0.5 * attitude.unwrap_or(0.0)) + TAU / 2.0;
        let half = 0.6 * film.speed.signum();
        let arc = axes.arc(0.62 * radius, middle - half, middle + half);
        figure.line(&arc, Pen::new(1.0, INK));
        if let [.., from, tip] = arc.as_slice() {
            let back = [2.0 * from[0] - tip[0], 2.0 * from[1] - tip[1]];
            figure.arrow_head(back, *tip, 2.0, INK);
        }
        figure.text(
            axes.point(middle, 0.62 * radius - 3.0),
            &Label::marked("*\u{3c9}*"),
            letters,
            Anchor::Centre,
        );
    }
    let Some(load) = load else { return };
    let tip = axes.point(load, 0.82 * radius);
    figure.line(
        &[axes.centre, axes.point(load, 0.78 * radius)],
        Pen::new(1.6, VERMILION),
    );
    figure.arrow_head(axes.centre, tip, 2.6, VERMILION);
    let turn = attitude.unwrap_or(0.0);
    // The letter of the load on the side away from the attitude angle.
    let aside = if turn >= 0.0 { -1.0 } else { 1.0 };
    let clear = 2.2 * letters.capital() / (0.66 * radius);
    let coloured = letters.coloured(VERMILION).with_halo();
    figure.text(
        axes.point(load + aside * clear, 0.66 * radius),
        &Label::marked("*W*"),
        coloured,
        Anchor::Centre,
    );
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
        let at = if room > 2.0 * needed {
            load + 0.5 * turn
        } else {
            load + turn + turn.signum() * needed / distance
        };
        figure.text(
            axes.point(at, distance + 2.2),
            &label,
            letters.with_halo(),
            Anchor::Centre,
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The rim of a groove between two angles [deg], 3 mm wide, by pieces of so many degrees, in any turn and order.
    fn groove(from: f64, to: f64, step: f64) -> Vec<[[f64; 2]; 2]> {
        let (radius, count) = (0.027, ((to - from) / step).ceil());
        let x = |k: f64| radius * (from + (to - from) * k / count).to_radians();
        let mut pieces = vec![
            [[x(0.0), -1.5e-3], [x(0.0), 1.5e-3]],
            [[x(count), -1.5e-3], [x(count), 1.5e-3]],
        ];
        for k in 0..count as u32 {
            let ends = [f64::from(k), f64::from(k + 1)].map(x);
            let turn = TAU * radius * f64::from(k % 3);
            pieces.push(ends.map(|x| [x + turn, 1.5e-3]));
            pieces.insert(0, ends.map(|x| [x - turn, -1.5e-3]));
        }
        pieces
    }

    #[test]
    fn a_groove_covers_its_angles_and_no_more() {
        for (from, to) in [
            (0.0, 170.0),
            (0.0, 180.0),
            (10.0, 190.0),
            (0.0, 181.0),
            (180.0, 360.0),
            (-15.0, 15.0),
            (300.0, 655.0),
            (90.0, 91.0),
        ] {
            for step in [2.0, 17.0] {
                let [low, high] = extent(&groove(from, to, step), 0.027).map(f64::to_degrees);
                assert!((high - low - (to - from)).abs() < 1e-6, "{from} {to}: {low} {high}");
                assert!(wrapped((low - from).to_radians()).abs() < 1e-6, "{from} {to}: {low}");
            }
        }
        let [low, high] = extent(&groove(0.0, 360.0, 10.0), 0.027);
        assert!((high - low - TAU).abs() < 1e-9);
    }
}
