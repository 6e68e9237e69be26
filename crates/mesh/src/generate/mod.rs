//! Meshes of a liner as it is drawn: no mesh generator needed.
//!
//! The developed liner is a rectangle with holes and grooves ([`Feature`]). Its outlines are cut
//! into edges of the wanted size (`outline`), filled with triangles (`triangulate`), and become a
//! [`RawMesh`] like that of a file: the same groups, round rims on their circles, a ring glued.

mod outline;
mod recognise;
mod shape;
mod size;
mod triangulate;

pub use shape::{Feature, Shape};

use outline::{Edge, Outline, Sheet};
use size::SizeField;
use triangulate::{Domain, Triangles, triangulate};

use crate::developed::Liner;
use crate::{Circle, Defect, Mesh, RawMesh};

/// Lands and features narrower than this part of the radius cannot be meshed.
const THINNEST: f64 = 1e-3;
/// Places around a ring that are tried for its seam.
const SEAM_PLACES: u32 = 360;

/// A liner as it is drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct Blueprint {
    /// Radius, length and arc.
    pub liner: Liner,
    /// Holes and grooves.
    pub features: Vec<Feature>,
    /// Angle [rad] of an axial line that must be a line of edges (film start of a ring).
    pub line: Option<f64>,
}

/// Why a drawing cannot be meshed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DrawingError {
    /// A feature reaches beyond the liner.
    #[error(
        "\"{name}\" reaches {by:.4e} m beyond the liner or to less than {least:.1e} m from its edge; move or shrink it"
    )]
    OffLiner {
        /// Name of the feature.
        name: String,
        /// How far it reaches out (negative: the land that is left) [m].
        by: f64,
        /// Least land that can be meshed [m].
        least: f64,
    },
    /// Two features overlap or leave too little land between them.
    #[error(
        "\"{first}\" and \"{second}\" overlap or leave less than {least:.1e} m of land between them; move or shrink one"
    )]
    Overlap {
        /// Name of a feature.
        first: String,
        /// Name of the other.
        second: String,
        /// Least land that can be meshed [m].
        least: f64,
    },
    /// A feature is too thin.
    #[error("\"{name}\" is {width:.3e} m wide, thinner than can be meshed ({least:.1e} m); widen it")]
    TooThin {
        /// Name of the feature.
        name: String,
        /// Its least width [m].
        width: f64,
        /// Least width that can be meshed [m].
        least: f64,
    },
    /// The straight side between two round corners is too short.
    #[error(
        "\"{name}\" has a straight side of {side:.3e} m between its round corners, shorter than can be meshed ({least:.1e} m); make the corners meet or smaller"
    )]
    ShortSide {
        /// Name of the feature.
        name: String,
        /// Its shortest side [m].
        side: f64,
        /// Shortest side that can be meshed [m].
        least: f64,
    },
    /// A region of a mesh is no shape that can be drawn.
    #[error(
        "the region \"{name}\" of the mesh is neither a circle nor a rectangle along the axes, so it cannot be meshed anew; remove [mesh] size to take the mesh as it is, or give the feed's hole"
    )]
    Unrecognised {
        /// Name of the region.
        name: String,
    },
    /// The triangulation failed, or would be too large.
    #[error("the liner cannot be meshed with triangles of {size:.3e} m: {reason}")]
    Failed {
        /// Size asked for [m].
        size: f64,
        /// Why.
        reason: String,
    },
    /// The mesh has defects.
    #[error("the mesh made of the drawing has defects: {0}")]
    Defective(Defect),
}

/// Greatest number of triangles that is made.
const MOST_TRIANGLES: f64 = 2e7;

/// Meshes a liner; `size` is the edge length [m] wanted at a point, features refine it further.
///
/// # Errors
/// Every fault of the drawing, or that it cannot be meshed at this size.
pub fn generate(blueprint: &Blueprint, size: &dyn Fn([f64; 2]) -> f64) -> Result<Mesh, Vec<DrawingError>> {
    let blueprint = &placed(blueprint);
    let faults = faults(blueprint);
    if !faults.is_empty() {
        return Err(faults);
    }
    let start = seam_place(blueprint);
    let sheet = Sheet::of(&blueprint.liner, start);
    check_size(&sheet, size).map_err(|fault| vec![fault])?;
    let gaps = gaps(blueprint, &sheet);
    let field = SizeField::new(size, sheet.period(), &blueprint.features, &gaps);
    let outline = outline::outline(&sheet, &blueprint.features, &field);
    let domain = Domain {
        sheet,
        features: &blueprint.features,
        size: &field,
    };
    let triangles = triangulate(&domain, &outline).ok_or_else(|| {
        let size = size([sheet.start, 0.0]);
        vec![DrawingError::Failed {
            size,
            reason: "outlines cross; choose a smaller size".to_owned(),
        }]
    })?;
    let raw = raw_mesh(&domain, &outline, triangles);
    Mesh::build(raw).map_err(|defects| defects.into_iter().map(DrawingError::Defective).collect())
}

fn check_size(sheet: &Sheet, size: &dyn Fn([f64; 2]) -> f64) -> Result<(), DrawingError> {
    const SAMPLES: u32 = 256;
    let mut triangles = 0.0;
    for k in 0..SAMPLES {
        let x = sheet.start + sheet.width * (f64::from(k) + 0.5) / f64::from(SAMPLES);
        let size = size([x, 0.0]);
        if !(size > 0.0 && size.is_finite()) {
            let reason = "the size must be above zero".to_owned();
            return Err(DrawingError::Failed { size, reason });
        }
        triangles += sheet.width * sheet.length / f64::from(SAMPLES) / (0.433 * size * size);
        if triangles > MOST_TRIANGLES {
            let reason = format!("that makes more than {MOST_TRIANGLES:.0e} triangles; choose a larger size");
            return Err(DrawingError::Failed { size, reason });
        }
    }
    Ok(())
}

/// The same drawing with each feature on the turn of the liner: an angle may be given as 350 or as -10 degrees.
fn placed(blueprint: &Blueprint) -> Blueprint {
    let mut placed = blueprint.clone();
    let turn = blueprint.liner.circumference();
    let sheet = Sheet::of(&blueprint.liner, 0.0);
    let middle = sheet.start + 0.5 * sheet.width;
    for feature in &mut placed.features {
        let x = &mut feature.shape.centre[0];
        *x += turn * ((middle - *x) / turn).round();
    }
    placed
}

/// Everything that is wrong with the drawing.
fn faults(blueprint: &Blueprint) -> Vec<DrawingError> {
    let sheet = Sheet::of(&blueprint.liner, 0.0);
    let least = THINNEST * blueprint.liner.radius;
    let mut faults = Vec::new();
    for (index, feature) in blueprint.features.iter().enumerate() {
        let name = &feature.name;
        let width = 2.0 * feature.shape.half[0].min(feature.shape.half[1]);
        if width < least {
            faults.push(DrawingError::TooThin {
                name: name.clone(),
                width,
                least,
            });
            continue;
        }
        let shortest = feature.shape.shortest_side();
        if shortest < least {
            faults.push(DrawingError::ShortSide {
                name: name.clone(),
                side: shortest,
                least,
            });
        }
        let land = land(&sheet, feature);
        if land < least {
            faults.push(DrawingError::OffLiner {
                name: name.clone(),
                by: -land,
                least,
            });
        }
        for other in &blueprint.features[index + 1..] {
            if distance_between(&sheet, feature, other) < least {
                let (first, second) = (name.clone(), other.name.clone());
                faults.push(DrawingError::Overlap { first, second, least });
            }
        }
    }
    faults
}

/// Points along the outline of a feature, on its own turn of the ring.
fn outline_points(sheet: &Sheet, feature: &Feature) -> Vec<[f64; 2]> {
    const A_PIECE: u32 = 64;
    let pieces = feature.shape.outline(sheet.start, sheet.width);
    pieces
        .iter()
        .flat_map(|piece| (0..A_PIECE).map(|k| piece.at(f64::from(k) / f64::from(A_PIECE))))
        .collect()
}

/// Least land [m] between a feature and the edge of the liner; negative where it reaches out.
fn land(sheet: &Sheet, feature: &Feature) -> f64 {
    let shape = &feature.shape;
    let ends = 0.5 * sheet.length - shape.centre[1].abs() - shape.half[1];
    let [x, half] = [shape.centre[0], shape.half[0]];
    let around = match (sheet.ring, shape.is_full_turn()) {
        (true, true) => f64::INFINITY,
        (true, false) => sheet.width - 2.0 * half,
        (false, true) => -sheet.width,
        (false, false) => (x - half - sheet.start).min(sheet.end() - x - half),
    };
    ends.min(around)
}

/// Distance [m] between the outlines of two features; negative where they overlap.
fn distance_between(sheet: &Sheet, a: &Feature, b: &Feature) -> f64 {
    let to = |from: &Feature, to: &Feature| {
        outline_points(sheet, from)
            .into_iter()
            .map(|point| to.shape.distance(point, sheet.period()))
            .fold(f64::INFINITY, f64::min)
    };
    to(a, b).min(to(b, a))
}

/// Free land [m] around each feature.
fn gaps(blueprint: &Blueprint, sheet: &Sheet) -> Vec<f64> {
    let features = &blueprint.features;
    (features.iter().enumerate())
        .map(|(index, feature)| {
            let others = features.iter().enumerate().filter(|(other, _)| *other != index);
            let nearest = others.map(|(_, other)| distance_between(sheet, feature, other));
            nearest.fold(land(sheet, feature), f64::min)
        })
        .collect()
}

/// Where a ring is cut [m]: at its line if it has one, else where no feature is near, else through the
/// middle of features rather than along their edges.
fn seam_place(blueprint: &Blueprint) -> f64 {
    let radius = blueprint.liner.radius;
    if let Some(angle) = blueprint.line {
        return radius * angle;
    }
    let turn = blueprint.liner.circumference();
    let clearance = |x: f64| {
        (blueprint.features.iter())
            .filter(|feature| !feature.shape.is_full_turn())
            .map(|feature| {
                let along = crate::developed::shorter_way(x - feature.shape.centre[0], turn).abs();
                (along - feature.shape.half[0]).abs() / feature.shape.half[0].min(0.1 * turn)
            })
            .fold(f64::INFINITY, f64::min)
    };
    let places = (0..SEAM_PLACES).map(|k| turn * f64::from(k) / f64::from(SEAM_PLACES));
    let crossed = |x: f64| {
        let inside = |feature: &&Feature| {
            let along = crate::developed::shorter_way(x - feature.shape.centre[0], turn).abs();
            along < feature.shape.half[0] && !feature.shape.is_full_turn()
        };
        blueprint.features.iter().filter(inside).count()
    };
    // Fewest crossings, then the greatest clearance (capped: beyond two sizes it does not matter).
    let rank = |x: f64| (crossed(x), -clearance(x).min(1.0));
    let best = places.min_by(|&a, &b| {
        let (a, b) = (rank(a), rank(b));
        a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
    });
    best.unwrap_or(0.0)
}

/// Triangles and outlines as a mesh file would list them, the seam glued.
fn raw_mesh(domain: &Domain, outline: &Outline, filled: Triangles) -> RawMesh {
    let Triangles { points, mut triangles } = filled;
    let mut glued: Vec<u32> = (0..points.len() as u32).collect();
    for &[left, right] in &outline.seam {
        glued[right as usize] = left;
    }
    let cells_of = |feature: &Feature| -> Vec<u32> {
        let inside = |triangle: &[u32; 3]| {
            let centre = [0, 1].map(|d| triangle.iter().map(|&v| points[v as usize][d]).sum::<f64>() / 3.0);
            feature.shape.distance(centre, domain.sheet.period()) < 0.0
        };
        (0u32..)
            .zip(&triangles)
            .filter(|(_, triangle)| inside(triangle))
            .map(|(t, _)| t)
            .collect()
    };
    let mut surfaces: Vec<(String, Vec<u32>)> = (domain.features.iter())
        .filter(|feature| feature.meshed)
        .map(|feature| (feature.name.clone(), cells_of(feature)))
        .collect();
    surfaces.push(("film".to_owned(), film_cells(&surfaces, triangles.len())));
    let bulges = bulges(&points, &triangles, outline);
    for vertex in triangles.iter_mut().flatten() {
        *vertex = glued[*vertex as usize];
    }
    let mut curves: Vec<(String, Vec<[u32; 2]>)> = Vec::new();
    for Edge { ends, group, .. } in &outline.edges {
        if let Some(group) = group {
            let ends = ends.map(|end| glued[end as usize]);
            match curves.iter_mut().find(|(name, _)| name == group) {
                Some((_, edges)) => edges.push(ends),
                None => curves.push((group.clone(), vec![ends])),
            }
        }
    }
    let mut circles: Vec<(Circle, Vec<[u32; 2]>)> = Vec::new();
    for Edge { ends, circle, .. } in &outline.edges {
        if let Some(circle) = circle {
            let ends = ends.map(|end| glued[end as usize]);
            match circles.iter_mut().find(|(known, _)| known == circle) {
                Some((_, edges)) => edges.push(ends),
                None => circles.push((*circle, vec![ends])),
            }
        }
    }
    RawMesh {
        circles,
        points,
        labels: Vec::new(),
        triangles,
        bulges,
        curves,
        surfaces,
        period: domain.sheet.period(),
    }
}

/// Triangles in none of the surfaces.
fn film_cells(surfaces: &[(String, Vec<u32>)], count: usize) -> Vec<u32> {
    let mut film = vec![true; count];
    for &cell in surfaces.iter().flat_map(|(_, cells)| cells) {
        film[cell as usize] = false;
    }
    (0..count as u32).filter(|&cell| film[cell as usize]).collect()
}

/// Edges on a circle bulge to it.
fn bulges(points: &[[f64; 2]], triangles: &[[u32; 3]], outline: &Outline) -> Vec<(u32, u8, [f64; 2])> {
    let on_circle: std::collections::HashMap<[u32; 2], Circle> = (outline.edges.iter())
        .filter_map(|edge| {
            let [a, b] = edge.ends;
            edge.circle.map(|circle| ([a.min(b), a.max(b)], circle))
        })
        .collect();
    let mut bulges = Vec::new();
    if on_circle.is_empty() {
        return bulges;
    }
    for (t, triangle) in (0u32..).zip(triangles) {
        for k in 0..3 {
            let (a, b) = (triangle[k], triangle[(k + 1) % 3]);
            if let Some(circle) = on_circle.get(&[a.min(b), a.max(b)]) {
                let middle = [0, 1].map(|d| 0.5 * (points[a as usize][d] + points[b as usize][d]));
                let arm = [0, 1].map(|d| middle[d] - circle.centre[d]);
                let stretch = circle.radius / arm[0].hypot(arm[1]) - 1.0;
                bulges.push((t, k as u8, arm.map(|x| x * stretch)));
            }
        }
    }
    bulges
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Quality;
    use std::f64::consts::{PI, TAU};

    pub(super) fn ring(features: Vec<Feature>) -> Blueprint {
        let liner = Liner {
            radius: 0.0375,
            length: 0.075,
            arc: None,
        };
        Blueprint {
            liner,
            features,
            line: None,
        }
    }

    fn hole(name: &str, angle: f64, z: f64, radius: f64) -> Feature {
        let shape = Shape::disc([0.0375 * angle.to_radians(), z], radius);
        Feature {
            name: name.to_owned(),
            shape,
            meshed: false,
        }
    }

    #[test]
    fn plain_ring_and_ring_with_features() {
        let groove = Shape {
            centre: [0.0375 * 5.2, 0.0],
            half: [0.006, 0.028],
            corner: 0.0,
        };
        let groove = Feature {
            name: "groove".into(),
            shape: groove,
            meshed: false,
        };
        let turn = Shape {
            centre: [0.0, 0.02],
            half: [f64::INFINITY, 0.003],
            corner: 0.0,
        };
        let turn = Feature {
            name: "turn".into(),
            shape: turn,
            meshed: true,
        };
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
        let groove = Shape {
            centre: [0.0375 * 5.7, 0.0],
            half: [0.006, 0.028],
            corner: 0.0,
        };
        let band = Shape {
            centre: [0.0, 0.02],
            half: [f64::INFINITY, 0.003],
            corner: 0.0,
        };
        let meshed = |name: &str, shape| Feature {
            name: name.into(),
            shape,
            meshed: true,
        };
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
                for (point, distance) in [
                    ([0.01, 0.01], None),
                    ([0.23, 0.0], None),
                    (drawn.shape.centre, Some(())),
                ] {
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
}
