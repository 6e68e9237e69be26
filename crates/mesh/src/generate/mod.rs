//! Meshes of a liner as it is drawn: no mesh generator needed.
//!
//! The developed liner is a rectangle with holes and grooves ([`Feature`]), of which those of one name may overlap,
//! others may touch, and a groove may reach an end. Its outlines are cut into edges of the wanted size (`outline`),
//! filled with triangles (`triangulate`), and become a [`crate::RawMesh`] like that of a file: the same groups, round
//! rims on their circles, a ring glued.

mod assemble;
mod drawing;
mod like;
mod meeting;
mod motion;
mod outline;
mod recognise;
mod rows;
mod shape;
mod sheet;
mod size;
mod triangulate;
mod union;

pub use drawing::{Blueprint, DrawingError};
pub use like::generate_in_rows_like;
pub use meeting::{Meeting, meeting};
pub use motion::moved;
pub use rows::{RowLengths, Sense};
pub use shape::{Feature, RoundedRectangle};
pub use size::Grading;

use assemble::raw_mesh;
use drawing::{faults, gaps, placed, seam_place};
use outline::Cutting;
use rows::RowGrid;
use sheet::LinerRectangle;
use size::SizeField;
use triangulate::{FilledDomain, triangulate};
use union::{junctions, parts};

use crate::Mesh;

/// Greatest number of triangles that is made.
const MOST_TRIANGLES: f64 = 4e6;
/// Area of an equilateral triangle over the square of its edge.
const EQUILATERAL_AREA: f64 = 0.433_012_701_892_219_3;

/// Meshes a liner; `size` is the edge length [m] wanted at a point, features refine it further.
///
/// # Errors
/// Every fault of the drawing, or that it cannot be meshed at this size.
pub fn generate(blueprint: &Blueprint, size: &dyn Fn([f64; 2]) -> f64) -> Result<Mesh, Vec<DrawingError>> {
    generate_graded(blueprint, size, Grading::RESOLVED)
}

/// Meshes a liner as [`generate`] does, with a grading towards features of the caller's choice.
///
/// # Errors
/// Every fault of the drawing, or that it cannot be meshed at this size.
pub fn generate_graded(
    blueprint: &Blueprint,
    size: &dyn Fn([f64; 2]) -> f64,
    grading: Grading,
) -> Result<Mesh, Vec<DrawingError>> {
    in_domain(blueprint, size, grading, |domain| {
        check_size(domain, None)?;
        meshed(domain, None)
    })
}

/// About how many triangles [`generate_graded`] makes.
///
/// # Errors
/// Every fault of the drawing.
pub fn triangles_graded(
    blueprint: &Blueprint,
    size: &dyn Fn([f64; 2]) -> f64,
    grading: Grading,
) -> Result<f64, Vec<DrawingError>> {
    in_domain(blueprint, size, grading, |domain| Ok(count(domain, None)?.triangles))
}

fn in_domain<T>(
    blueprint: &Blueprint,
    size: &dyn Fn([f64; 2]) -> f64,
    grading: Grading,
    made: impl FnOnce(&FilledDomain) -> Result<T, Vec<DrawingError>>,
) -> Result<T, Vec<DrawingError>> {
    let blueprint = &checked(blueprint)?;
    let sheet = LinerRectangle::of(&blueprint.liner, seam_place(blueprint));
    let gaps = gaps(blueprint, &sheet);
    let widest = widest(&sheet);
    let size = &|point: [f64; 2]| size(point).min(widest);
    let corners = junctions(&sheet, &parts(&sheet, &blueprint.features));
    let field = SizeField::new(size, grading, sheet.period(), (&blueprint.features, &gaps), &corners);
    made(&FilledDomain { sheet, features: &blueprint.features, size: &field })
}

/// Meshes a liner in rows along the flow, as far apart as `rows` says; features refine it further.
///
/// # Errors
/// Every fault of the drawing, or that it cannot be meshed at this size.
pub fn generate_in_rows(blueprint: &Blueprint, rows: &RowLengths) -> Result<Mesh, Vec<DrawingError>> {
    in_rows(blueprint, rows, |domain, rows| {
        check_size(domain, Some(rows))?;
        let grid = RowGrid::new(&domain.sheet, domain.features, rows, &|point| domain.size.near_features(point));
        meshed(domain, Some(&grid))
    })
}

/// About how many triangles [`generate_in_rows`] makes.
///
/// # Errors
/// Every fault of the drawing.
pub fn triangles_in_rows(blueprint: &Blueprint, rows: &RowLengths) -> Result<f64, Vec<DrawingError>> {
    in_rows(blueprint, rows, |domain, rows| Ok(count(domain, Some(rows))?.triangles))
}

fn in_rows<T>(
    blueprint: &Blueprint,
    rows: &RowLengths,
    made: impl FnOnce(&FilledDomain, &RowLengths) -> Result<T, Vec<DrawingError>>,
) -> Result<T, Vec<DrawingError>> {
    let blueprint = &checked(blueprint)?;
    let sheet = LinerRectangle::of(&blueprint.liner, seam_place(blueprint));
    let gaps = gaps(blueprint, &sheet);
    let widest = widest(&sheet);
    let along = |x: f64| (rows.along)(x).min(widest);
    let across = |z: f64| (rows.across)(z).min(widest);
    let rows = RowLengths { along: &along, across: &across, sense: rows.sense, grading: rows.grading };
    let size = |point: [f64; 2]| rows.size(point);
    // Grooves all around have rows along their edges, which have no corner: triangles become smaller towards all else.
    let (others, gaps): (Vec<Feature>, Vec<f64>) =
        (blueprint.features.iter().cloned().zip(gaps)).filter(|(feature, _)| !feature.shape.is_full_turn()).unzip();
    let corners = junctions(&sheet, &parts(&sheet, &blueprint.features));
    let field = SizeField::new(&size, rows.grading, sheet.period(), (&others, &gaps), &corners);
    made(&FilledDomain { sheet, features: &blueprint.features, size: &field }, &rows)
}

/// The drawing with its features on the sheet, if nothing is wrong with it.
fn checked(blueprint: &Blueprint) -> Result<Blueprint, Vec<DrawingError>> {
    let blueprint = placed(blueprint);
    let faults = faults(&blueprint);
    match faults.is_empty() {
        true => Ok(blueprint),
        false => Err(faults),
    }
}

/// Longest edges [m]: two at least across the liner, and four along a short arc.
fn widest(sheet: &LinerRectangle) -> f64 {
    (0.5 * sheet.length).min(0.25 * sheet.width)
}

/// The mesh of a domain, with the nodes of a grid, if there is one.
fn meshed(domain: &FilledDomain, grid: Option<&RowGrid>) -> Result<Mesh, Vec<DrawingError>> {
    let cutting = Cutting { size: domain.size, grid };
    let outline = outline::outline(&domain.sheet, domain.features, &cutting);
    let nodes = grid.map(|grid| grid.inner_nodes(domain)).unwrap_or_default();
    let mut filled = triangulate(domain, &outline, &nodes).ok_or_else(|| {
        let size = domain.size.at([domain.sheet.start, 0.0]);
        vec![DrawingError::Failed { size, reason: "outlines cross; choose a smaller size".to_owned() }]
    })?;
    if let Some(grid) = grid {
        grid.turn_diagonals(&mut filled);
    }
    let raw = raw_mesh(domain, &outline, filled);
    Mesh::build(raw).map_err(|defects| defects.into_iter().map(DrawingError::Defective).collect())
}

/// The mesh that the wanted sizes make.
struct Count {
    triangles: f64,
    /// The least size [m].
    least: f64,
}

/// Counts the triangles that the wanted sizes make, which must be sizes.
fn count(domain: &FilledDomain, rows: Option<&RowLengths>) -> Result<Count, Vec<DrawingError>> {
    const ALONG: u32 = 256;
    const ACROSS: u32 = 32;
    let FilledDomain { sheet, features, size: field } = domain;
    let (mut triangles, mut least) = (0.0, f64::INFINITY);
    for k in 0..ALONG * ACROSS {
        let x = sheet.start + sheet.width * (f64::from(k / ACROSS) + 0.5) / f64::from(ALONG);
        let z = sheet.length * ((f64::from(k % ACROSS) + 0.5) / f64::from(ACROSS) - 0.5);
        let size = field.at([x, z]);
        if !(size > 0.0 && size.is_finite()) {
            let reason = "the size must be above zero".to_owned();
            return Err(vec![DrawingError::Failed { size, reason }]);
        }
        least = size.min(least);
        // Quotients: the squares of short lengths are zero.
        // Two triangles a cell of the grid; an equilateral one has this part of the square of its edge.
        let (edges, area) = match rows {
            Some(rows) if field.near_features([x, z]) > size => ([(rows.along)(x), (rows.across)(z)], 0.5),
            _ => ([size, size], EQUILATERAL_AREA),
        };
        triangles += (sheet.width / edges[0]) * (sheet.length / edges[1]) / (area * f64::from(ALONG * ACROSS));
    }
    // Those around a rim may be too few in number of rows to be met above: the integral of dA / (area of a triangle)
    // beside an edge.
    for feature in features.iter().filter(|feature| rows.is_none() || !feature.shape.is_full_turn()) {
        let sides = if feature.meshed { 2.0 } else { 1.0 };
        triangles += sides * outline::edges_along(sheet, feature, field) / (EQUILATERAL_AREA * field.grading.growth);
    }
    Ok(Count { triangles, least })
}

/// The wanted sizes must make no more triangles than a machine can hold.
fn check_size(domain: &FilledDomain, rows: Option<&RowLengths>) -> Result<(), Vec<DrawingError>> {
    let Count { triangles, least } = count(domain, rows)?;
    if triangles <= MOST_TRIANGLES {
        return Ok(());
    }
    let reason = format!(
        "that makes some {triangles:.0e} of them, more than {MOST_TRIANGLES:.0e}; choose a larger size ([mesh] size), a wider liner or wider lands"
    );
    Err(vec![DrawingError::Failed { size: least, reason }])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Quality;
    use crate::developed::LinerDomain;
    use std::f64::consts::{PI, TAU};

    pub(super) fn ring(features: Vec<Feature>) -> Blueprint {
        let liner = LinerDomain { radius: 0.0375, length: 0.075, arc: None };
        Blueprint { liner, features, line: None }
    }

    fn hole(name: &str, angle: f64, z: f64, radius: f64) -> Feature {
        let shape = RoundedRectangle::disc([0.0375 * angle.to_radians(), z], radius);
        Feature { name: name.to_owned(), shape, meshed: false }
    }

    #[test]
    fn plain_ring_and_ring_with_features() {
        let groove = RoundedRectangle { centre: [0.0375 * 5.2, 0.0], half: [0.006, 0.028], corner: 0.0 };
        let groove = Feature { name: "groove".into(), shape: groove, meshed: false };
        let turn = RoundedRectangle { centre: [0.0, 0.02], half: [f64::INFINITY, 0.003], corner: 0.0 };
        let turn = Feature { name: "turn".into(), shape: turn, meshed: true };
        let cases = [
            vec![],
            vec![hole("a", 130.0, 0.0, 0.0085)],
            vec![hole("a", 30.0, 0.015, 0.005), hole("b", 240.0, -0.012, 0.004), groove],
            vec![turn, hole("a", 130.0, -0.01, 0.0085)],
        ];
        for features in cases {
            let removed: f64 = features.iter().filter(|f| !f.meshed).map(|f| f.shape.area(1.0)).sum();
            let names: Vec<String> = features.iter().map(|f| f.name.clone()).collect();
            let started = std::time::Instant::now();
            let mesh = generate(&ring(features), &|_| 0.004).unwrap();
            let quality = Quality::of(&mesh);
            println!(
                "{names:?} {} nodes {:.1} deg median {:.1} {:?}",
                quality.quadratic_nodes,
                quality.least_angle,
                quality.median_angle,
                started.elapsed()
            );
            assert!(quality.least_angle > 25.0);
            let area = 2.0 * PI * 0.0375 * 0.075 - removed;
            assert!((quality.area / area - 1.0).abs() < 1e-6);
            for name in names {
                assert!(mesh.region(&name).is_some());
            }
            assert_eq!(quality.unnamed_boundary_edges, 0);
        }
    }

    #[test]
    fn the_drawing_of_a_mesh_is_found_again() {
        let groove = RoundedRectangle { centre: [0.0375 * 5.7, 0.0], half: [0.006, 0.028], corner: 0.0 };
        let band = RoundedRectangle { centre: [0.0, 0.02], half: [f64::INFINITY, 0.003], corner: 0.0 };
        let meshed = |name: &str, shape| Feature { name: name.into(), shape, meshed: true };
        let drawings = [
            vec![hole("a", 2.0, 0.015, 0.005), meshed("groove", groove)],
            vec![meshed("band", band), hole("a", 130.0, -0.01, 0.0085)],
        ];
        for features in drawings {
            let mesh = generate(&ring(features.clone()), &|_| 0.004).unwrap();
            let names: Vec<&str> = features.iter().map(|feature| feature.name.as_str()).collect();
            let found = Blueprint::of_mesh(&mesh, ring(Vec::new()).liner, &names).unwrap();
            for (found, drawn) in found.features.iter().zip(&features) {
                assert_eq!(found.meshed, drawn.meshed);
                let turn = Some(TAU * 0.0375);
                for (point, distance) in [([0.01, 0.01], None), ([0.23, 0.0], None), (drawn.shape.centre, Some(()))] {
                    let (a, b) = (found.shape.distance(point, turn), drawn.shape.distance(point, turn));
                    assert!((a - b).abs() < 1e-12, "{} {distance:?}: {a} {b}", drawn.name);
                }
            }
            assert!(Blueprint::of_mesh(&mesh, ring(Vec::new()).liner, &["film"]).is_err());
        }
    }

    #[test]
    fn faults_of_the_drawing_are_named_at_once() {
        let features = vec![
            hole("a", 130.0, 0.03, 0.0085),
            hole("b", 240.0, 0.0, 0.0085),
            hole("c", 250.0, 0.0, 0.0085),
            hole("d", 10.0, 0.0, 1e-6),
        ];
        let faults = generate(&ring(features), &|_| 0.004).unwrap_err();
        assert_eq!(faults.len(), 3, "{faults:?}");
    }

    #[test]
    fn too_many_triangles_are_counted_of_the_smallest_liner_too() {
        // The squares of these lengths are zero.
        let mut small = ring(Vec::new());
        (small.liner.radius, small.liner.length) = (1e-170, 2e-170);
        let faults = generate(&small, &|_| 1e-178).unwrap_err();
        let [DrawingError::Failed { size, reason }] = &faults[..] else {
            panic!("{faults:?}");
        };
        assert_eq!(*size, 1e-178);
        assert!(reason.contains("that makes some 3e17 of them"), "{reason}");
    }
}
