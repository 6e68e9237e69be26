//! The film as the script of the page has it: angles, heights and values as whole numbers of 32 bits, and how they are
//! shown.
//!
//! An angle is a part of a turn, so that a ring has no seam. A field is a part of its range: 24 bits are as fine as the
//! numbers of a picture need to be, and finer than single precision where the range is small against the values.

use std::f64::consts::TAU;

use oilwedge_drawing::{joined, least_and_greatest};
use oilwedge_study::fields::{ERROR_INDICATOR, FIELDS, FieldRow, Interpolation};
use oilwedge_study::picture::FilmPicture;
use oilwedge_study::quantities::{ECCENTRICITY, MIN_FILM_ANGLE};
use rayon::prelude::*;
use serde::Serialize;

use super::packing::{Packed, Prediction, packed, triangles};
use crate::plot::{DrawnFilm, FieldColours, drawn_fields};
use crate::readable::printed_unit;
use crate::readable::{printed_symbol, readable_unit_of};

/// Steps of a turn, of the length, and of the range of a field.
const TURN: f64 = 4_294_967_296.0;
const LENGTH_STEPS: f64 = 4_294_967_295.0;
const RANGE_STEPS: f64 = 16_777_215.0;
/// Circumference of the sheet on which lines are joined [mm].
const SHEET: f64 = 5000.0;

/// A film, its fields, and where it is.
#[derive(Debug, Serialize)]
pub(super) struct FilmData {
    /// Radius [m].
    radius: f64,
    /// Ends of the axis [m].
    axis: [f64; 2],
    /// Angles between which the liner is shown [rad].
    angles: [f64; 2],
    is_ring: bool,
    eccentricity: f64,
    /// [rad].
    min_film_angle: f64,
    /// Sign of the rotation against the clock; zero at rest.
    turns: f64,
    nodes: usize,
    triangles: Packed,
    angle: Packed,
    height: Packed,
    fields: Vec<FieldData>,
    lines: Vec<LinerLine>,
}

/// A field.
#[derive(Debug, Serialize)]
struct FieldData {
    name: String,
    label: String,
    symbol: String,
    unit: String,
    /// Size of the unit in SI.
    size: f64,
    interpolation: &'static str,
    /// Least and greatest value, SI.
    range: [f64; 2],
    /// Least value that the model allows, SI, where quadratics dip below it.
    floor: Option<f64>,
    /// Range of its colours, SI.
    colours: [f64; 2],
    is_logarithmic: bool,
    /// Colours at equal steps, hexadecimal.
    map: String,
    values: Packed,
}

/// A line on the liner: paths of angles [rad] and heights [m] in turn.
#[derive(Debug, Serialize)]
struct LinerLine {
    kind: &'static str,
    paths: Vec<Vec<f64>>,
}

impl FilmData {
    /// The data of a film as it is drawn.
    pub(super) fn of(film: &DrawnFilm, picture: &FilmPicture) -> Self {
        let prediction = Prediction::of(&picture.cells, picture.points.len());
        let radius = film.radius();
        let places = film.places(picture);
        let ends = least_and_greatest(places.iter().map(|place| place[1]));
        let turn = |place: &[f64; 2]| ((place[0] / (TAU * radius)).rem_euclid(1.0) * TURN).round() as u64 as u32;
        let step = |place: &[f64; 2]| part(place[1], ends, LENGTH_STEPS);
        let coded = |values: Vec<u32>| packed(&prediction.differences(&values));
        let nodal = drawn_fields(&picture.point_data).map(|(row, values)| (row, values, true));
        let constant = drawn_fields(&picture.cell_data).map(|(row, values)| (row, values, false));
        let all: Vec<_> = nodal.chain(constant).collect();
        let fields = all.into_par_iter().map(|(row, values, is_nodal)| {
            let range = least_and_greatest(values.iter().copied());
            let values = match is_nodal {
                true => coded(values.iter().map(|value| part(*value, range, RANGE_STEPS)).collect()),
                false => {
                    let bits: Vec<u32> = values.iter().map(|value| (*value as f32).to_bits()).collect();
                    packed(&bits)
                }
            };
            FieldData::of(row, (range, film.floor(row.name)), values)
        });
        let mut fields: Vec<FieldData> = fields.collect();
        fields.sort_by_key(|it| FIELDS.iter().position(|row| row.name == it.name));
        let position = film.position().unwrap_or_default();
        Self {
            radius,
            axis: ends,
            angles: film.angles(),
            is_ring: film.result().geometry.arc.is_none(),
            eccentricity: film.quantity(&ECCENTRICITY).unwrap_or_default(),
            min_film_angle: film.quantity(&MIN_FILM_ANGLE).map_or(position[1], f64::to_radians),
            turns: if film.result().geometry.speed == 0.0 { 0.0 } else { film.result().geometry.speed.signum() },
            nodes: picture.points.len(),
            triangles: packed(&triangles(&picture.cells)),
            angle: coded(places.iter().map(turn).collect()),
            height: coded(places.iter().map(step).collect()),
            fields,
            lines: lines(film),
        }
    }

    /// Names and labels of the fields.
    pub(super) fn choices(&self) -> impl Iterator<Item = (&str, &str)> {
        self.fields.iter().map(|field| (field.name.as_str(), field.label.as_str()))
    }
}

impl FieldData {
    fn of(row: &FieldRow, (range, floor): ([f64; 2], Option<f64>), values: Packed) -> Self {
        let (unit, size) = readable_unit_of(range[0].abs().max(range[1].abs()), row.unit);
        let colours = FieldColours::of(row.name, range);
        Self {
            name: row.name.to_owned(),
            label: row.label.to_owned(),
            symbol: printed_symbol(row.symbol).replace('*', ""),
            unit: printed_unit(unit),
            size,
            interpolation: match row.interpolation {
                Interpolation::Linear => "linear",
                Interpolation::Constant => "constant",
                Interpolation::Quadratic => "quadratic",
            },
            range,
            floor,
            colours: colours.range,
            is_logarithmic: row.name == ERROR_INDICATOR.name,
            map: colours.map.to_hex(),
            values,
        }
    }
}

/// The step of a value in its range.
fn part(value: f64, [low, high]: [f64; 2], steps: f64) -> u32 {
    match high > low {
        true => ((value - low) / (high - low) * steps).round() as u32,
        false => 0,
    }
}

fn lines(film: &DrawnFilm) -> Vec<LinerLine> {
    // Pieces are joined on a sheet of that circumference, to the places of a drawing.
    let scale = SHEET / (TAU * film.radius());
    let on_liner = |[x, z]: &[f64; 2]| [x / SHEET * TAU, z / scale].map(|part| (part * 1e7).round() / 1e7);
    let paths = |pieces: &[[[f64; 2]; 2]]| -> Vec<Vec<f64>> {
        let pieces: Vec<[[f64; 2]; 2]> =
            pieces.iter().map(|piece| piece.map(|point| point.map(|part| scale * part))).collect();
        let lines = joined(&pieces);
        lines.iter().map(|line| line.iter().flat_map(on_liner).collect()).collect()
    };
    let [rupture, reformation] = film.cavity_edges();
    let rims: Vec<[[f64; 2]; 2]> = film.rims().flat_map(|(_, rim)| rim.iter().copied()).collect();
    let lines = [("rupture", rupture), ("reformation", reformation), ("rim", &rims[..])];
    let lines = lines.into_iter().filter(|(_, line)| !line.is_empty());
    lines.map(|(kind, line)| LinerLine { kind, paths: paths(line) }).collect()
}
