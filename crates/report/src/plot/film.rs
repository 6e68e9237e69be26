//! A solved film as it is drawn: the numbers of `result.json` and the fields and lines of its picture, on the unrolled
//! liner.

use std::f64::consts::TAU;

use oilwedge_study::fields::{CONTACT_PRESSURE, FieldRow, Interpolation, PRESSURE, field};
use oilwedge_study::film_lines::{REFORMATION, RIM, RUPTURE};
use oilwedge_study::picture::{FieldValues, FilmPicture, PictureField};
use oilwedge_study::quantities::{
    CYCLE_FILM_THICKNESS_MIN_ANGLE, ECCENTRICITY, FILM_THICKNESS_MIN_ANGLE, FILM_THICKNESS_MIN_Z, MIN_FILM_ANGLE, Row,
};
use oilwedge_study::result::{Geometry, RunResult};

use super::liner::{LinerWindow, TriangleNodes};
use crate::Error;

/// Nodes on the cylinder are as far from its axis as this part of the radius allows.
const OFF: f64 = 1e-6;

/// A film with the numbers of its run.
#[derive(Debug)]
pub struct DrawnFilm {
    /// Everything that the run found.
    pub(super) result: RunResult,
    /// Whether the points of its picture are on the cylinder; otherwise they are unrolled.
    is_cylinder: bool,
    pub(super) liner: LinerWindow,
    pub(super) cells: Vec<TriangleNodes>,
    /// Fields by name: values at the nodes of each triangle, SI.
    pub(super) fields: Vec<(String, Vec<[f64; 6]>)>,
    /// Lines by name: pieces on the unrolled liner [m].
    pub(super) lines: Vec<(String, Vec<[[f64; 2]; 2]>)>,
}

impl DrawnFilm {
    /// A film from the numbers of a run and its picture, on the cylinder or unrolled.
    ///
    /// # Errors
    /// [`Error::Format`]: the numbers have no shape of the bearing, as those of older versions of the program.
    pub fn new(result: RunResult, picture: &FilmPicture) -> Result<Self, Error> {
        let Geometry { radius, arc, film_start, .. } = result.geometry;
        if radius <= 0.0 {
            return Err(Error::format("picture")("result.json has no geometry; solve the scene again"));
        }
        let unroll = Unrolled::of(picture, radius);
        let cells: Vec<TriangleNodes> = picture.cells.iter().map(|cell| unroll.cell(cell)).collect();
        let angles = match arc {
            Some(ends) => ends.map(f64::to_radians),
            None => {
                let offset = result.quantity(&MIN_FILM_ANGLE).map_or(180.0, |it| it.value);
                let from = film_start.unwrap_or(offset - 180.0).rem_euclid(360.0);
                [from.to_radians(), from.to_radians() + TAU]
            }
        };
        let on_nodes =
            |values: &Vec<f64>| picture.cells.iter().map(|cell| cell.map(|node| values[node as usize])).collect();
        let nodal = drawn_fields(&picture.point_data).map(|(row, values)| (row.name.to_owned(), on_nodes(values)));
        let on_cells = |values: &Vec<f64>| values.iter().map(|value| [*value; 6]).collect();
        let constant = drawn_fields(&picture.cell_data).map(|(row, values)| (row.name.to_owned(), on_cells(values)));
        let unrolled = |pieces: &Vec<[[f64; 3]; 2]>| pieces.iter().map(|piece| unroll.piece(piece)).collect();
        Ok(Self {
            is_cylinder: unroll.is_cylinder,
            liner: LinerWindow::between(&cells, radius, angles),
            fields: nodal.chain(constant).collect(),
            lines: picture.lines.iter().map(|(name, pieces)| (name.clone(), unrolled(pieces))).collect(),
            cells,
            result,
        })
    }

    pub(crate) fn radius(&self) -> f64 {
        self.result.geometry.radius
    }

    /// Angles [rad] between which the liner is drawn.
    pub(crate) fn angles(&self) -> [f64; 2] {
        self.liner.angles()
    }

    /// Nodes of the triangles on the unrolled liner [m], continuous within each.
    pub(crate) fn cells(&self) -> &[TriangleNodes] {
        &self.cells
    }

    /// Everything that the run found.
    pub(crate) fn result(&self) -> &RunResult {
        &self.result
    }

    /// Length of the circumference [m].
    pub(crate) fn circumference(&self) -> f64 {
        TAU * self.radius()
    }

    /// Places of the nodes of its picture on the unrolled liner [m], each on some turn.
    pub(crate) fn places(&self, picture: &FilmPicture) -> Vec<[f64; 2]> {
        let mut places = vec![[0.0; 2]; picture.points.len()];
        for (cell, nodes) in picture.cells.iter().zip(&self.cells) {
            for (node, place) in cell.iter().zip(nodes) {
                places[*node as usize] = *place;
            }
        }
        places
    }

    /// The middle of the shorter way between two places [m].
    pub(crate) fn between(&self, from: [f64; 2], to: [f64; 2]) -> [f64; 2] {
        let period = self.circumference();
        let x = to[0] - period * ((to[0] - from[0]) / period).round();
        [0.5 * (from[0] + x), 0.5 * (from[1] + to[1])]
    }

    /// The point of its picture at a place [m].
    pub(crate) fn point(&self, [x, z]: [f64; 2]) -> [f64; 3] {
        let (sin, cos) = (x / self.radius()).sin_cos();
        match self.is_cylinder {
            true => [self.radius() * cos, self.radius() * sin, z],
            false => [x, z, 0.0],
        }
    }

    /// Values of a quantity of the catalogue.
    pub(crate) fn quantity(&self, row: &Row) -> Option<f64> {
        self.result.quantity(row).map(|it| it.value)
    }

    /// Eccentricity [1] and angle [rad] of the journal's offset.
    pub(crate) fn position(&self) -> Option<[f64; 2]> {
        Some([self.quantity(&ECCENTRICITY)?, self.quantity(&MIN_FILM_ANGLE)?.to_radians()])
    }

    /// Angle [rad] at which the film is thinnest and, where it is so at one place along the axis alone, that place [m].
    pub(super) fn thinnest(&self) -> Option<(f64, Option<f64>)> {
        // The film of an orbit is that in which it is thinnest over the cycle.
        let rows = [&FILM_THICKNESS_MIN_ANGLE, &CYCLE_FILM_THICKNESS_MIN_ANGLE];
        let angle = rows.into_iter().find_map(|row| self.quantity(row))?.to_radians();
        Some((angle, self.quantity(&FILM_THICKNESS_MIN_Z)))
    }

    /// The least value that the model lets a field have, below which quadratics between its nodes may dip: the pressure
    /// of a cavity, that of its nodes, and no contact.
    pub(crate) fn floor(&self, name: &str) -> Option<f64> {
        let has_cavity = self.cavity_edges().iter().any(|pieces| !pieces.is_empty());
        match name {
            name if name == CONTACT_PRESSURE.name => Some(0.0),
            name if name == PRESSURE.name && has_cavity => {
                let values = self.values(name)?.iter().flatten().copied();
                Some(values.fold(f64::INFINITY, f64::min))
            }
            _ => None,
        }
    }

    /// Names of the fields of the film.
    pub fn field_names(&self) -> impl Iterator<Item = &str> {
        self.fields.iter().map(|(name, _)| name.as_str())
    }

    pub(super) fn values(&self, name: &str) -> Option<&[[f64; 6]]> {
        let (_, values) = self.fields.iter().find(|(other, _)| other == name)?;
        Some(values)
    }

    /// Pieces of the lines of that name.
    pub(super) fn line(&self, name: &str) -> &[[[f64; 2]; 2]] {
        self.lines.iter().find(|(other, _)| other == name).map_or(&[], |(_, pieces)| pieces)
    }

    /// Rims of feeds and pockets by name.
    pub(crate) fn rims(&self) -> impl Iterator<Item = (&str, &[[[f64; 2]; 2]])> {
        self.lines.iter().filter_map(|(name, pieces)| Some((name.strip_prefix(RIM)?, pieces.as_slice())))
    }

    /// The lines at which the film breaks, and those at which it forms again.
    pub(crate) fn cavity_edges(&self) -> [&[[[f64; 2]; 2]]; 2] {
        [RUPTURE, REFORMATION].map(|name| self.line(name))
    }

    /// Triangles with the values of a field between which it is a quadratic: a field that is linear on the parts of
    /// triangles has four for each.
    pub(super) fn pieces(&self, name: &str) -> Option<(Vec<TriangleNodes>, Vec<[f64; 6]>)> {
        let values = self.values(name)?;
        if field(name).map(|row| row.interpolation) != Some(Interpolation::Linear) {
            return Some((self.cells.clone(), values.to_vec()));
        }
        let parts = |cell: (&TriangleNodes, &[f64; 6])| {
            PARTS.map(|part| (straight(part.map(|k| cell.0[k])), linear(part.map(|k| cell.1[k]))))
        };
        Some(self.cells.iter().zip(values).flat_map(parts).unzip())
    }
}

/// Parts of a triangle by its nodes.
const PARTS: [[usize; 3]; 4] = [[0, 3, 5], [3, 1, 4], [5, 4, 2], [3, 4, 5]];

fn straight([a, b, c]: [[f64; 2]; 3]) -> TriangleNodes {
    let middle = |a: [f64; 2], b: [f64; 2]| [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])];
    [a, b, c, middle(a, b), middle(b, c), middle(c, a)]
}

fn linear([a, b, c]: [f64; 3]) -> [f64; 6] {
    [a, b, c, 0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a)]
}

/// Points of a picture on the unrolled liner.
struct Unrolled<'a> {
    points: &'a [[f64; 3]],
    radius: f64,
    is_cylinder: bool,
}

impl<'a> Unrolled<'a> {
    fn of(picture: &'a FilmPicture, radius: f64) -> Self {
        let is_on = |point: &[f64; 3]| (point[0].hypot(point[1]) - radius).abs() < OFF * radius;
        Self { points: &picture.points, radius, is_cylinder: picture.points.iter().all(is_on) }
    }

    fn at(&self, point: [f64; 3]) -> [f64; 2] {
        match self.is_cylinder {
            true => [self.radius * point[1].atan2(point[0]), point[2]],
            false => [point[0], point[1]],
        }
    }

    /// The turn of a point in which it is next to another one.
    fn beside(&self, [x, z]: [f64; 2], other: [f64; 2]) -> [f64; 2] {
        let period = TAU * self.radius;
        match self.is_cylinder {
            true => [x - period * ((x - other[0]) / period).round(), z],
            false => [x, z],
        }
    }

    fn cell(&self, cell: &[u32; 6]) -> TriangleNodes {
        let nodes = cell.map(|node| self.at(self.points[node as usize]));
        nodes.map(|node| self.beside(node, nodes[0]))
    }

    fn piece(&self, piece: &[[f64; 3]; 2]) -> [[f64; 2]; 2] {
        let [from, to] = piece.map(|point| self.at(point));
        [from, self.beside(to, from)]
    }
}

/// The fields that are drawn: those of the list of fields, of one number each.
pub(crate) fn drawn_fields(fields: &[PictureField]) -> impl Iterator<Item = (&'static FieldRow, &Vec<f64>)> {
    fields.iter().filter_map(|it| match &it.values {
        FieldValues::Scalars(values) => Some((field(&it.name)?, values)),
        FieldValues::Vectors(_) | FieldValues::Rows(..) => None,
    })
}
