//! Mesh files of hard cases: rows of needles, sizes that jump, and liners that lie turned or far away in space.

use std::f64::consts::TAU;
use std::fmt::Write;
use std::path::Path;

use oilwedge_mesh::{Mesh, RawMesh, gmsh};
use oilwedge_scene::Scene;
use oilwedge_study::compile::compile;

use crate::family::{MeshRecipe, Rows};

/// Writes the mesh file of a scene that describes its liner.
///
/// # Errors
/// Why there is no such mesh, in words.
pub(crate) fn write(recipe: &MeshRecipe, scene: &Scene, path: &Path) -> Result<(), String> {
    let mesh = match &recipe.rows {
        Some(rows) => in_rows(rows, scene)?,
        None => compile(scene).and_then(|model| model.first_mesh()).map_err(|error| error.to_string())?.mesh,
    };
    let unit = match recipe.unit.as_str() {
        "m" => 1.0,
        "um" => 1e-6,
        "mm" => 1e-3,
        "km" => 1e3,
        other => return Err(format!("no mesh is made in {other}; write m, um, mm or km")),
    };
    let radius = scene.bearing.radius();
    let text = placed(&gmsh::to_text(&mesh), |[x, z]| {
        let point = match recipe.cylinder {
            true => [radius * (x / radius).cos(), radius * (x / radius).sin(), z],
            false => [x, z, 0.0],
        };
        let shifted = [0, 1, 2].map(|k| point[k] + recipe.shift[k]);
        turned(shifted, recipe.turn).map(|length| length / unit)
    });
    std::fs::write(path, text).map_err(|error| format!("{}: {error}", path.display()))
}

/// The point turned about x, then y, then z by angles [deg].
fn turned(point: [f64; 3], turns: [f64; 3]) -> [f64; 3] {
    (0..3).fold(point, |mut point, axis| {
        let (sin, cos) = turns[axis].to_radians().sin_cos();
        let [i, j] = [(axis + 1) % 3, (axis + 2) % 3];
        [point[i], point[j]] = [cos * point[i] - sin * point[j], sin * point[i] + cos * point[j]];
        point
    })
}

/// The text of a plane mesh with its nodes elsewhere.
fn placed(text: &str, place: impl Fn([f64; 2]) -> [f64; 3]) -> String {
    let mut in_nodes = false;
    text.lines().fold(String::with_capacity(2 * text.len()), |mut all, line| {
        in_nodes = (in_nodes || line == "$Nodes") && line != "$EndNodes";
        let numbers: Vec<f64> = line.split(' ').filter_map(|word| word.parse().ok()).collect();
        // Writing to a String cannot fail.
        let _ = match numbers[..] {
            [x, z, 0.0] if in_nodes => {
                let [x, y, z] = place([x, z]);
                writeln!(all, "{x} {y} {z}")
            }
            _ => writeln!(all, "{line}"),
        };
        all
    })
}

/// Columns around and rows along the liner of a scene, each rectangle cut into two triangles.
fn in_rows(rows: &Rows, scene: &Scene) -> Result<Mesh, String> {
    let (radius, half) = (scene.bearing.radius(), 0.5 * scene.bearing.length);
    let (from, to) = scene.bearing.arc.map_or((0.0, TAU), |arc| (arc.from, arc.to));
    let ring = scene.bearing.arc.is_none();
    let columns = if ring { rows.around } else { rows.around + 1 };
    let x = |k: u32| radius * (from + (to - from) * graded(k, rows.around, rows.jump));
    let z = |j: u32| half * (2.0 * graded(j, rows.along, rows.jump) - 1.0);
    let node = |k: u32, j: u32| (k % columns) * (rows.along + 1) + j;
    let mut raw = RawMesh { period: ring.then_some(TAU * radius), ..RawMesh::default() };
    for k in 0..columns {
        raw.points.extend((0..=rows.along).map(|j| [x(k), z(j)]));
    }
    for k in 0..rows.around {
        for j in 0..rows.along {
            let [a, b, c, d] = [node(k, j), node(k + 1, j), node(k + 1, j + 1), node(k, j + 1)];
            raw.triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    let along = |j: u32| (0..rows.around).map(|k| [node(k, j), node(k + 1, j)]).collect();
    raw.curves.push(("end_low".to_owned(), along(0)));
    raw.curves.push(("end_high".to_owned(), along(rows.along)));
    if !ring {
        let across = |k: u32| (0..rows.along).map(|j| [node(k, j), node(k, j + 1)]).collect();
        raw.curves.push(("arc_from".to_owned(), across(0)));
        raw.curves.push(("arc_to".to_owned(), across(rows.around)));
    }
    Mesh::build(raw).map_err(|defects| defects.iter().map(|defect| format!("{defect}; ")).collect())
}

/// Place [0 to 1] of line `k` of `n`, whose distances shrink geometrically to the middle by the factor `jump`.
fn graded(k: u32, n: u32, jump: f64) -> f64 {
    let half = f64::from(n) / 2.0;
    let sum = |count: f64| match jump > 1.0 {
        true => 1.0 - jump.powf(-count / half),
        false => count / half,
    };
    let whole = sum(half);
    let k = f64::from(k);
    match k <= half {
        true => 0.5 * sum(k) / whole,
        false => 1.0 - 0.5 * sum(f64::from(n) - k) / whole,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_shrink_to_the_middle() {
        assert_eq!([0, 2, 4].map(|k| graded(k, 4, 1.0)), [0.0, 0.5, 1.0]);
        let widths: Vec<f64> = (0..10).map(|k| graded(k + 1, 10, 1e3) - graded(k, 10, 1e3)).collect();
        let ratio = widths[0] / widths[4];
        assert!((ratio - 1e3f64.powf(0.8)).abs() < 1e-9 * ratio, "{widths:?}");
        assert!((widths.iter().sum::<f64>() - 1.0).abs() < 1e-14);
    }

    #[test]
    fn a_quarter_turn_about_z_takes_x_to_y() {
        let [x, y, z] = turned([1.0, 0.0, 2.0], [0.0, 0.0, 90.0]);
        assert!(x.abs() < 1e-15 && (y - 1.0).abs() < 1e-15 && z == 2.0);
    }

    #[test]
    fn only_nodes_move() {
        let text = "$Entities\n1 2 0\n$EndEntities\n$Nodes\n1 2 1 2\n2 1 0 2\n1\n2\n0.5 0.25 0\n1 2 0\n$EndNodes\n$Elements\n1 2 0\n";
        let moved = placed(text, |[x, z]| [x + 1.0, z, 7.0]);
        assert!(moved.contains("1.5 0.25 7\n2 2 7\n$EndNodes"), "{moved}");
        assert_eq!(moved.matches("1 2 0\n").count(), 2);
    }
}
