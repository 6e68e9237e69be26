//! A mesh in rows along the flow with the geometry and the edge lengths of another mesh.

use super::{Blueprint, DrawingError, Grading, RowLengths, Sense, generate_in_rows};
use crate::raw::doubled_area;
use crate::{Locator, Mesh};

/// Places at which triangles are looked up, along and across the flow.
const ALONG: usize = 256;
const ACROSS: usize = 64;
/// Area of a triangle of the grid over that of its cell.
const HALF_A_CELL: f64 = 0.5;

/// Meshes the geometry `blueprint` of `mesh` in rows along the flow: columns as far apart as the triangles of `mesh`
/// are long there (median from end to end), rows as far as they are wide (median around), both scaled so that there are
/// as many triangles, and then by `ratio`.
///
/// # Errors
/// As [`generate_in_rows`].
pub fn generate_in_rows_like(
    blueprint: &Blueprint,
    mesh: &Mesh,
    ratio: f64,
    sense: Sense,
) -> Result<Mesh, Vec<DrawingError>> {
    let locator = Locator::new(mesh);
    let [low, high] = bounds(mesh);
    let width = mesh.period().unwrap_or(high[0] - low[0]);
    let place = |k: usize, number: usize| (k as f64 + 0.5) / number as f64;
    let at = |column: usize, row: usize| -> Option<MeshSample> {
        let x = low[0] + width * place(column, ALONG);
        let z = low[1] + (high[1] - low[1]) * place(row, ACROSS);
        let (t, _) = locator.find([x, z])?;
        let corners = mesh.corners(t);
        Some(MeshSample { at: [column, row], extent: extent(corners), area: 0.5 * doubled_area(corners) })
    };
    let in_column = |column: usize| (0..ACROSS).filter_map(move |row| at(column, row));
    let samples: Vec<MeshSample> = (0..ALONG).flat_map(in_column).collect();
    let columns = medians(&samples, 0, ALONG);
    let rows = medians(&samples, 1, ACROSS);
    let (mut wanted, mut made) = (0.0, 0.0);
    for sample in &samples {
        wanted += 1.0 / sample.area;
        made += 1.0 / (HALF_A_CELL * columns[sample.at[0]] * rows[sample.at[1]]);
    }
    let scale = ratio * (made / wanted).sqrt();
    let nearest = |values: &[f64], part: f64| {
        let last = values.len() - 1;
        scale * values[((part * values.len() as f64).max(0.0) as usize).min(last)]
    };
    let along = |x: f64| nearest(&columns, ((x - low[0]) / width).rem_euclid(1.0));
    let across = |z: f64| nearest(&rows, (z - low[1]) / (high[1] - low[1]));
    generate_in_rows(blueprint, &RowLengths { along: &along, across: &across, sense, grading: Grading::RESOLVED })
}

fn bounds(mesh: &Mesh) -> [[f64; 2]; 2] {
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for point in mesh.points() {
        for k in 0..2 {
            low[k] = low[k].min(point[k]);
            high[k] = high[k].max(point[k]);
        }
    }
    [low, high]
}

/// A triangle of the mesh at one place.
struct MeshSample {
    /// Column and row of the place.
    at: [usize; 2],
    /// Length along the flow and width across it [m].
    extent: [f64; 2],
    /// Area [m2].
    area: f64,
}

fn extent(corners: [[f64; 2]; 3]) -> [f64; 2] {
    [0, 1].map(|k| {
        let places = corners.map(|corner| corner[k]);
        places.iter().fold(f64::NEG_INFINITY, |high, &x| high.max(x))
            - places.iter().fold(f64::INFINITY, |low, &x| low.min(x))
    })
}

/// The median extent along an axis of the triangles on each of `number` lines across it; infinite where there are none.
fn medians(samples: &[MeshSample], axis: usize, number: usize) -> Vec<f64> {
    let mut extents = vec![Vec::new(); number];
    for sample in samples {
        extents[sample.at[axis]].push(sample.extent[axis]);
    }
    let median = |mut values: Vec<f64>| {
        values.sort_unstable_by(f64::total_cmp);
        values.get(values.len() / 2).copied().unwrap_or(f64::INFINITY)
    };
    extents.into_iter().map(median).collect()
}
