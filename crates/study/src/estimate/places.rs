//! Bars of places, by the film in cubic elements: of the greatest pressure, and of the ends of the loaded film.
//!
//! * The greatest pressure is where `grad p = 0`. A field whose gradient is off by g has it `H^-1 g` away, H the second
//!   derivatives of the cubic film; g is the greatest difference of the two gradients in the triangles in which the
//!   greatest pressure may be: where the cubic film comes nearer to it at a node than d, twice its bar and four times
//!   what the highest node is below it. On a flat ridge H is that of a ripple; so the curvature is no greater than
//!   `2 d/r^2`, r how far away the film comes as near; the place is no farther than r.
//! * An end of the film is off by the difference of the two films, half of the triangle in which a free boundary is
//!   found, and where the pressure is only cut off by the difference of the two pressures over the slope.

use oilwedge_fem::Field;
use oilwedge_fem::lagrange;
use oilwedge_fem::mapping::Mapping;
use oilwedge_reynolds::error_bar::Bar;
use oilwedge_reynolds::quantities::extent::EndKind;
use oilwedge_reynolds::{SolvedFilm, Theory};

use super::ExtentEnd;
use crate::film::Film;
use crate::measure::Measured;

/// A film in quadratic and in cubic elements.
pub(super) struct PlacedPair<'a> {
    pub(super) film: &'a Film,
    pub(super) solutions: [&'a SolvedFilm; 2],
    pub(super) measured: [&'a Measured; 2],
}

/// Intervals along an edge of the lattice on which two films are compared.
const LATTICE: u32 = 4;
/// Share of the difference of the gradients that the cubic film is off by.
const OF_GRADIENTS: f64 = 0.5;
/// Weights in d: of the bar of the greatest pressure, and of what the highest node is below it.
const PER_BAR: f64 = 2.0;
const PER_NODE: f64 = 4.0;
/// Share of the triangle in which a free boundary is found.
const OF_TRIANGLE: f64 = 0.5;
/// Step in reference coordinates for second derivatives: gradients of cubics are quadratic, so that differences are
/// exact.
const STEP: f64 = 0.125;

/// Bars [m] of the place of the greatest pressure, around and along the axis; `bar` [Pa] is that of this pressure.
pub(super) fn summit(pair: &PlacedPair, bar: f64) -> [f64; 2] {
    let [quadratic, cubic] = pair.measured.map(|measured| measured.extremes.summit);
    let change = [
        (pair.film.problem.bearing).around(quadratic.position[0], cubic.position[0]).abs(),
        (quadratic.position[1] - cubic.position[1]).abs(),
    ];
    let High { triangles, depth, reach } = high(pair, bar);
    let off = (triangles.into_iter())
        .chain([quadratic.triangle, cubic.triangle])
        .flat_map(|t| lattice().map(move |point| (t, point)))
        .map(|(t, point)| {
            let [(_, a), (_, b)] = fields(pair).map(|field| field.value_and_gradient(t, point));
            [0, 1].map(|d| (a[d] - b[d]).abs())
        })
        .fold([0.0; 2], |most: [f64; 2], off| [0, 1].map(|d| most[d].max(off[d])));
    let ridge = [0, 1].map(|d| match depth > 0.0 {
        true => change[d].max(reach[d].min(OF_GRADIENTS * off[d] * reach[d].powi(2) / (2.0 * depth))),
        false => change[d],
    });
    let [[a, b], [_, c]] = second_derivatives(&fields(pair)[1], cubic.triangle, cubic.point);
    let determinant = a * c - b * b;
    match a < 0.0 && determinant > 0.0 {
        // The pressure is the same all along the axis.
        _ if pair.film.problem.theory == Theory::Long && a < 0.0 => {
            [ridge[0].max(OF_GRADIENTS * off[0] / a.abs()), 0.0]
        }
        true => {
            let shift = [c.abs() * off[0] + b.abs() * off[1], b.abs() * off[0] + a.abs() * off[1]];
            [0, 1].map(|d| ridge[d].max(OF_GRADIENTS * shift[d] / determinant))
        }
        // A kink: the place is in the triangle, or beside it.
        false => [0, 1].map(|d| ridge[d].max(change[d] + width(pair.film, cubic.triangle, d))),
    }
}

/// Places at which the greatest pressure may be.
struct High {
    /// Triangles at whose nodes the cubic film comes as near to its greatest pressure as `depth`.
    triangles: Vec<usize>,
    /// Depth d of the pressure below the greatest one [Pa].
    depth: f64,
    /// How far [m] these nodes are from its place, around and along the axis.
    reach: [f64; 2],
}

/// Places at which the greatest pressure may be, whose bar is `bar` [Pa].
fn high(pair: &PlacedPair, bar: f64) -> High {
    let (space, extremes) = (pair.film.system.cubic().system.space(), pair.measured[1].extremes);
    let pressure = |dof: usize| pair.film.problem.pressure_at(pair.solutions[1].solution.unknown[dof]);
    let highest = (0..space.dofs()).map(pressure).fold(f64::NEG_INFINITY, f64::max);
    let depth = PER_BAR * bar + PER_NODE * (extremes.greatest - highest).max(0.0);
    let (least, top) = (extremes.greatest - depth, extremes.summit.position);
    let nodes = lagrange::nodes(space.degree());
    let (mut triangles, mut reach) = (Vec::new(), [0.0_f64; 2]);
    for t in 0..space.mesh().triangles().len() {
        let dofs = space.element_dofs(t);
        let is_high = |k: &usize| pressure(dofs[*k]) > least;
        let high: Vec<usize> = (0..space.shapes()).filter(is_high).collect();
        if high.is_empty() {
            continue;
        }
        triangles.push(t);
        let mapping = Mapping::of(space.mesh(), t);
        for [x, z] in high.into_iter().map(|k| mapping.at(nodes[k]).position) {
            let away = [pair.film.problem.bearing.around(x, top[0]), z - top[1]];
            reach = [0, 1].map(|d| reach[d].max(away[d].abs()));
        }
    }
    High { triangles, depth, reach }
}

/// Bar [m] of an end of the loaded film.
pub(super) fn film_end(pair: &PlacedPair, end: ExtentEnd) -> Option<Bar> {
    let [quadratic, cubic] = pair.measured.map(|measured| measured.extent.map(|extent| end.of(&extent)));
    let (quadratic, cubic) = (quadratic?, cubic?);
    let (triangle, bearing) = (cubic.triangle, &pair.film.problem.bearing);
    let cut_off = match pair.film.problem.cavitation.kink() {
        Some(_) if cubic.kind == EndKind::Cavity => {
            let off = lattice().map(|point| {
                let [a, b] = fields(pair).map(|field| field.value(triangle, point));
                (a - b).abs()
            });
            let middle = [1.0 / 3.0; 2];
            let slope = fields(pair)[1].value_and_gradient(triangle, middle).1[0].abs();
            let off = off.fold(0.0, f64::max) / slope;
            off.min(width(pair.film, triangle, 0))
        }
        _ => 0.0,
    };
    Some(Bar {
        discretisation: bearing.around(quadratic.x, cubic.x).abs().max(cut_off),
        front: OF_TRIANGLE * quadratic.unsure.max(cubic.unsure),
        ..Bar::default()
    })
}

fn fields<'a>(pair: &PlacedPair<'a>) -> [Field<'a>; 2] {
    let system = &pair.film.system;
    [
        Field { space: system.space(), values: &pair.solutions[0].solution.unknown },
        Field { space: system.cubic().system.space(), values: &pair.solutions[1].solution.unknown },
    ]
}

fn lattice() -> impl Iterator<Item = [f64; 2]> {
    let part = |i: u32| f64::from(i) / f64::from(LATTICE);
    (0..=LATTICE).flat_map(move |i| (0..=LATTICE - i).map(move |j| [part(i), part(j)]))
}

/// Second derivatives [Pa/m2] of a field in a triangle.
fn second_derivatives(field: &Field, t: usize, point: [f64; 2]) -> [[f64; 2]; 2] {
    let along = [0, 1].map(|k| {
        let at = |step: f64| {
            let mut shifted = point;
            shifted[k] += step;
            field.value_and_gradient(t, shifted).1
        };
        let (plus, minus) = (at(STEP), at(-STEP));
        [0, 1].map(|d| (plus[d] - minus[d]) / (2.0 * STEP))
    });
    let place = Mapping::of(field.space.mesh(), t).at(point);
    [0, 1].map(|d| place.gradient([along[0][d], along[1][d]]))
}

/// Extent [m] of a triangle along x or z.
fn width(film: &Film, t: usize, axis: usize) -> f64 {
    let places = film.system.space().mesh().corners(t).map(|corner| corner[axis]);
    let most = places.iter().fold(f64::NEG_INFINITY, |most, &place| most.max(place));
    most - places.iter().fold(f64::INFINITY, |least, &place| least.min(place))
}
