//! A field on the unrolled liner: filled contours, rims, the edges of the cavity and the thinnest film; and the mesh
//! alone.

use oilwedge_drawing::{
    Anchor, Axis, BLACK, BLUE, Colour, ColourMap, Figure, GREY, INK, Label, LegendEntry, Letters, Levels, Mark, Pen,
    PlotFrame, SMALLEST_LETTERS, Scale, Stroke, VERMILION, WHITE, draw_bands, draw_colour_bar, draw_legend, draw_mesh,
    joined, least_and_greatest, legend_height,
};
use oilwedge_study::fields::{ERROR_INDICATOR, FILM_FRACTION, FILM_THICKNESS, PRESSURE, VISCOSITY, field};

use super::error_map::{Decades, MOST_DECADES};
use super::film::DrawnFilm;
use super::liner::LinerWindow;
use super::sample::Finder;
use crate::readable::{axis_label, readable_unit_of};

/// Margin around the sheet, and room for the bar of colours [mm].
const MARGIN: f64 = 1.0;
const BAR: f64 = 17.0;
/// Most bands of a map.
const BANDS: f64 = 20.0;
/// A field has both signs where its lesser extreme is more than this part of the other.
const BOTH_SIGNS: f64 = 1e-3;
/// Places along the axis at which a film is compared, and the ratio of the thickest to the thinnest up to which it is
/// one line.
const ALONG: u32 = 40;
const EVEN: f64 = 1.01;
/// Sides of triangles.
const SIDES: Colour = Colour([90, 98, 106]);

/// The least and the greatest of values at nodes.
fn range(values: &[[f64; 6]]) -> [f64; 2] {
    least_and_greatest(values.iter().flatten().copied().filter(|value| value.is_finite()))
}

/// True where a field is the same everywhere, as far as can be seen.
pub(super) fn is_constant(values: &[[f64; 6]]) -> bool {
    let [low, high] = range(values);
    high - low <= 1e-6 * low.abs().max(high.abs())
}

/// How a field is coloured.
pub(crate) struct FieldColours {
    pub(crate) map: ColourMap,
    /// The range that the colours span.
    pub(crate) range: [f64; 2],
}

impl FieldColours {
    /// The colours of a field with that range.
    pub(crate) fn of(name: &str, [low, high]: [f64; 2]) -> Self {
        let most = low.abs().max(high.abs());
        let (map, [low, high]) = if low < -BOTH_SIGNS * most && high > BOTH_SIGNS * most {
            (ColourMap::Vik, [-most, most])
        } else if name == FILM_THICKNESS.name {
            (ColourMap::Davos, [low, high])
        } else if name == FILM_FRACTION.name {
            (ColourMap::Devon, if low < 0.5 { [0.0, 1.0] } else { [low, high] })
        } else if name == VISCOSITY.name {
            (ColourMap::Acton, [low, high])
        } else if name == ERROR_INDICATOR.name {
            (ColourMap::Lajolla, [high * 10f64.powf(-MOST_DECADES), high])
        } else if name != PRESSURE.name {
            (ColourMap::Batlow, [low, high])
        } else if low.abs() < high.abs() {
            (ColourMap::Batlow, [0.0, high])
        } else {
            (ColourMap::Batlow, [low, 0.0])
        };
        let high = if high > low { high } else { low + 1.0 };
        Self { map, range: [low, high] }
    }
}

/// The head of a sheet: title and a line below it; returns where it ends [mm].
pub(super) fn draw_head(figure: &mut Figure, title: &str, subtitle: &Label, width: f64) -> f64 {
    let (bold, small) = (Letters::default().bold(), Letters::default());
    let y = MARGIN + 0.5 * bold.line();
    figure.text([MARGIN, y], &Label::fitted(title, bold, width - 2.0 * MARGIN), bold, Anchor::Left);
    figure.text([MARGIN, y + small.line()], subtitle, small, Anchor::Left);
    y + 1.5 * small.line() + 1.0
}

/// The map of a field; `None` where the film has none of that name.
pub(super) fn field_figure(film: &DrawnFilm, name: &str, width: f64) -> Option<Figure> {
    let (cells, values) = film.pieces(name)?;
    let row = field(name);
    let about = row.map_or((name, "", ""), |row| (row.label, row.symbol, row.unit));
    let extremes = range(&values);
    let most = extremes[0].abs().max(extremes[1].abs());
    let (unit, size) = readable_unit_of(most, about.2);
    let label = Label::marked(&capitalised(&axis_label(about.0, about.1, unit)));
    let description = format!(
        "{}: {} on the unrolled liner, from {:.4} to {:.4} {unit}.",
        film.result.head.title,
        row.map_or(name, |row| row.what),
        extremes[0] / size,
        extremes[1] / size
    );
    let mut figure = Figure::new([width, 0.0], &format!("{}: {}", film.result.head.title, about.0), &description);
    let top = draw_head(&mut figure, &film.result.head.title, &label, width);
    let frame = film.liner.frame([MARGIN, top, width - 2.0 * MARGIN - BAR, 0.0]);
    if name == ERROR_INDICATOR.name {
        let contributions: Vec<f64> = values.iter().map(|values| values[0]).collect();
        let decades = Decades::of(&contributions, 1.0)?;
        let patches = film.liner.patches(&frame, &cells, |k| [decades.exponents[k]; 6]);
        film.liner.within(&mut figure, &frame, |figure| draw_bands(figure, &patches, &decades.levels));
        draw_colour_bar(&mut figure, frame.inner, &decades.axis, ColourMap::Lajolla, &decades.edges());
    } else {
        let FieldColours { map, range: [low, high] } = FieldColours::of(name, extremes.map(|value| value / size));
        let mut levels = Levels::round([low, high], map, BANDS);
        // Quadratics dip below the least value of the model between nodes.
        if let Some(floor) = film.floor(name) {
            let below = levels.edges.iter().filter(|edge| **edge <= floor / size).count();
            levels.edges.drain(..below);
            levels.colours.drain(..below);
        }
        let patches = film.liner.patches(&frame, &cells, |k| values[k].map(|value| value / size));
        film.liner.within(&mut figure, &frame, |figure| draw_bands(figure, &patches, &levels));
        let axis = Axis::between(low, high, Scale::Linear, Label::default());
        draw_colour_bar(&mut figure, frame.inner, &axis, map, &levels.edges);
    }
    let peak = (name == PRESSURE.name).then(|| peak(&cells, &values)).flatten();
    let entries = draw_lines(&mut figure, film, &frame, peak);
    frame.draw(&mut figure);
    finish(&mut figure, &film.liner, &frame, &entries);
    Some(figure)
}

/// The mesh alone.
pub(super) fn mesh_figure(film: &DrawnFilm, width: f64) -> Figure {
    let words = format!("Mesh of {} triangles", film.cells.len());
    let mut figure = Figure::new([width, 0.0], &format!("{}: mesh", film.result.head.title), &words);
    let top = draw_head(&mut figure, &film.result.head.title, &Label::plain(&words), width);
    let frame = film.liner.frame([MARGIN, top, width - 2.0 * MARGIN - 3.0, 0.0]);
    let patches = film.liner.patches(&frame, &film.cells, |_| [0.0; 6]);
    let pen = Pen::new((16.0 / (film.cells.len() as f64).sqrt()).clamp(0.1, 0.5), SIDES);
    film.liner.within(&mut figure, &frame, |figure| draw_mesh(figure, &patches, pen));
    let entries = draw_lines(&mut figure, film, &frame, None);
    frame.draw(&mut figure);
    finish(&mut figure, &film.liner, &frame, &entries);
    figure
}

/// The legend below the frame, and the height of the sheet.
fn finish(figure: &mut Figure, liner: &LinerWindow, frame: &PlotFrame, entries: &[LegendEntry]) {
    let width = figure.size()[0] - 2.0 * MARGIN;
    let mut y = frame.inner[1] + frame.inner[3] + frame.bottom_margin() + 1.0;
    let stretch = liner.stretch(frame);
    if stretch > 1.001 {
        let letters = Letters::sized(SMALLEST_LETTERS).coloured(GREY);
        let note = Label::plain(&format!("not to scale: the axis is drawn {stretch:.2} times too long"));
        figure.text([MARGIN, y + 0.5 * letters.line()], &note, letters, Anchor::Left);
        y += letters.line();
    }
    draw_legend(figure, entries, [MARGIN, y], width);
    figure.set_height(y + legend_height(entries, width) + MARGIN);
}

/// Place at which a field is greatest among its nodes.
pub(super) fn peak(cells: &[[[f64; 2]; 6]], values: &[[f64; 6]]) -> Option<[f64; 2]> {
    let nodes = cells.iter().zip(values).flat_map(|(nodes, values)| nodes.iter().zip(values));
    let finite = nodes.filter(|(_, value)| value.is_finite());
    finite.max_by(|a, b| a.1.total_cmp(b.1)).map(|(node, _)| *node)
}

/// Where the film is thinnest [m] around and, where it is not as thin all along the axis, along it; `None` too where
/// that place along the axis is not known.
fn thinnest(film: &DrawnFilm) -> Option<(f64, Option<f64>)> {
    let (angle, z) = film.thinnest()?;
    let x = angle * film.radius();
    let [low, high] = least_and_greatest(film.cells.iter().flatten().map(|node| node[1]));
    let along = (0..=ALONG).map(|k| [x, low + (high - low) * f64::from(k) / f64::from(ALONG)]);
    let film_along = Finder::new(film).values(&FILM_THICKNESS, &along.collect::<Vec<_>>())?;
    let [least, most] = least_and_greatest(film_along.into_iter().filter(|value| value.is_finite()));
    match most <= EVEN * least {
        true => Some((x, None)),
        false => z.map(|z| (x, Some(z))),
    }
}

/// Rims, edges of the cavity, the thinnest film and the peak, if it is to be marked; returns their legend.
fn draw_lines(figure: &mut Figure, film: &DrawnFilm, frame: &PlotFrame, peak: Option<[f64; 2]>) -> Vec<LegendEntry> {
    let mut entries = Vec::new();
    let mut say = |name: &str, colour: Colour, stroke: Option<Stroke>, mark: Option<Mark>| {
        entries.push(LegendEntry { name: Label::plain(name), colour, stroke, mark, area: None });
    };
    let placed = |pieces: &[[[f64; 2]; 2]]| {
        let pieces: Vec<[[f64; 2]; 2]> = pieces
            .iter()
            .flat_map(|piece| film.liner.lines(frame, piece))
            .filter_map(|line| <[[f64; 2]; 2]>::try_from(line).ok())
            .collect();
        joined(&pieces)
    };
    film.liner.within(figure, frame, |figure| {
        let mut has_rims = false;
        for (_, pieces) in film.rims() {
            figure.lines(placed(pieces), Pen::new(0.8, INK));
            has_rims = true;
        }
        if has_rims {
            say("hole or groove", INK, Some(Stroke::Solid), None);
        }
        let edges = [("film breaks", VERMILION, Stroke::Solid), ("film forms again", BLUE, Stroke::Dashed)];
        for ((name, colour, stroke), pieces) in edges.into_iter().zip(film.cavity_edges()) {
            if !pieces.is_empty() {
                let lines = placed(pieces);
                figure.lines(lines.clone(), Pen::new(2.0, WHITE));
                figure.lines(lines, Pen::new(1.0, colour).stroked(stroke));
                say(name, colour, Some(stroke), None);
            }
        }
        let [low, high] = [frame.y.low, frame.y.high];
        if let Some((x, z)) = thinnest(film) {
            let shifts = film.liner.shifts(x, x);
            for shift in &shifts {
                if let Some(z) = z {
                    figure.mark(film.liner.at(frame, [x + shift, z]), Mark::Square, BLACK);
                    continue;
                }
                let across = ((x + shift) / film.radius()).to_degrees();
                let line = [frame.at([across, low]), frame.at([across, high])];
                figure.line(&line, Pen::new(1.6, WHITE));
                figure.line(&line, Pen::new(1.0, BLACK).stroked(Stroke::Dotted));
            }
            if !shifts.is_empty() {
                match z {
                    Some(_) => say("thinnest film", BLACK, None, Some(Mark::Square)),
                    None => say("thinnest film", BLACK, Some(Stroke::Dotted), None),
                }
            }
        }
        if let Some(peak) = peak {
            for shift in film.liner.shifts(peak[0], peak[0]) {
                figure.mark(film.liner.at(frame, [peak[0] + shift, peak[1]]), Mark::Cross, BLACK);
            }
            say("greatest pressure", BLACK, None, Some(Mark::Cross));
        }
    });
    entries
}

/// The text with a capital at its beginning.
fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}
