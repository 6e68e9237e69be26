//! A mesh in rows along the flow with the geometry and the edge lengths of another mesh.

use super::{Blueprint, DrawingError, Rows, Sense, generate_in_rows};
use crate::Mesh;
use crate::size_tree::SizeTree;

/// Places at which edge lengths are looked up, along and across the flow.
const ALONG: usize = 256;
const ACROSS: usize = 64;
/// Area of a triangle of the grid, and of an equilateral one, over the square of its edge.
const HALF_A_CELL: f64 = 0.5;
const EQUILATERAL: f64 = 0.433_012_701_892_219_3;

/// Meshes the geometry `blueprint` of `mesh` in rows along the flow: columns as far apart as the edges of `mesh` are long there (median from end to
/// end), rows likewise (median around), both scaled so that there are as many triangles.
///
/// # Errors
/// As [`generate_in_rows`].
pub fn generate_in_rows_like(blueprint: &Blueprint, mesh: &Mesh, sense: Sense) -> Result<Mesh, Vec<DrawingError>> {
    let sizes = SizeTree::new(mesh);
    let [low, high] = bounds(mesh);
    let width = mesh.period().unwrap_or(high[0] - low[0]);
    let place = |k: usize, number: usize| (k as f64 + 0.5) / number as f64;
    let at = |i: usize, j: usize| {
        sizes.at([
            low[0] + width * place(i, ALONG),
            low[1] + (high[1] - low[1]) * place(j, ACROSS),
        ])
    };
    let table: Vec<Vec<f64>> = (0..ALONG).map(|i| (0..ACROSS).map(|j| at(i, j)).collect()).collect();
    let columns: Vec<f64> = table.iter().map(|sizes| median(sizes.clone())).collect();
    let rows: Vec<f64> = (0..ACROSS)
        .map(|j| median(table.iter().map(|sizes| sizes[j]).collect()))
        .collect();
    let (mut wanted, mut made) = (0.0, 0.0);
    for (column, sizes) in columns.iter().zip(&table) {
        for (row, size) in rows.iter().zip(sizes) {
            wanted += 1.0 / (EQUILATERAL * size * size);
            made += 1.0 / (HALF_A_CELL * column * row);
        }
    }
    let scale = (made / wanted).sqrt();
    let nearest = |values: &[f64], part: f64| {
        let last = values.len() - 1;
        scale * values[((part * values.len() as f64).max(0.0) as usize).min(last)]
    };
    let along = |x: f64| nearest(&columns, ((x - low[0]) / width).rem_euclid(1.0));
    let across = |z: f64| nearest(&rows, (z - low[1]) / (high[1] - low[1]));
    generate_in_rows(
        blueprint,
        &Rows {
            along: &along,
            across: &across,
            sense,
        },
    )
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

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_unstable_by(f64::total_cmp);
    values[values.len() / 2]
}
