//! Round holes: puts the rim of a region on its circle in the developed surface.
//!
//! A mesh knows the rim of a hole by its nodes only. Where the scene tells the circle, vertices and
//! mid-side nodes of the rim are moved onto it, and the boundary is good to third order.

use crate::developed::shorter_way;
use crate::topology::NO_TRIANGLE;
use crate::{Circle, Error, Mesh, Region};

/// Largest distance of a rim vertex from the circle, as a fraction of its radius.
const CLOSE: f64 = 1e-3;

/// The mesh with the rim of region `region` on `circle` (`centre = [x, z]`, all in m).
///
/// The rim of a curve group is the curve; that of a surface group the edges between its triangles
/// and the others. A rim vertex where another part of the boundary begins stays where it is.
///
/// # Errors
/// There is no such region; a rim vertex lies more than 1e-3 radii off the circle; triangles fold
/// over when their edges bend.
pub fn curve_rim(mesh: &Mesh, region: &str, circle: &Circle) -> Result<Mesh, Error> {
    let rim = mesh.region(region).map_or(Vec::new(), |region| rim_edges(mesh, region));
    if rim.is_empty() {
        return Err(Error::NoRegion {
            region: region.to_owned(),
            present: mesh.regions().iter().map(|region| region.name.clone()).collect(),
        });
    }
    // From the centre to a point, the shorter way around.
    let from_centre = |[x, z]: [f64; 2]| {
        let along = x - circle.centre[0];
        let along = mesh.period().map_or(along, |period| shorter_way(along, period));
        [along, z - circle.centre[1]]
    };
    let edge_ends = |edge: u32| mesh.topology().edges[edge as usize];
    let mut vertices: Vec<u32> = rim.iter().flat_map(|&edge| edge_ends(edge)).collect();
    vertices.sort_unstable();
    vertices.dedup();
    let arms = vertices.iter().map(|&v| from_centre(mesh.points()[v as usize]));
    let off = |arm: [f64; 2]| (arm[0].hypot(arm[1]) - circle.radius).abs();
    let distance = arms.clone().map(off).max_by(f64::total_cmp).unwrap_or(0.0);
    if distance.is_nan() || distance > CLOSE * circle.radius {
        return Err(Error::OffCircle {
            region: region.to_owned(),
            centre: circle.centre,
            radius: circle.radius,
            distance,
            found: describe(Circle::fit(arms), circle.centre),
        });
    }

    let onto = |arm: [f64; 2]| {
        let scale = circle.radius / arm[0].hypot(arm[1]);
        [arm[0] * scale, arm[1] * scale]
    };
    let mut raw = mesh.to_raw();
    let fixed = other_boundary(mesh, &rim);
    for &v in &vertices {
        if !fixed[v as usize] {
            let point = mesh.points()[v as usize];
            let (arm, target) = (from_centre(point), onto(from_centre(point)));
            raw.points[v as usize] = [point[0] + target[0] - arm[0], point[1] + target[1] - arm[1]];
        }
    }
    raw.bulges.retain(|&(t, k, _)| {
        rim.binary_search(&mesh.topology().triangle_edges[t as usize][k as usize])
            .is_err()
    });
    for &edge in &rim {
        let [a, b] = edge_ends(edge).map(|v| from_centre(raw.points[v as usize]));
        let middle = [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])];
        let target = onto(middle);
        let t = mesh.topology().edge_triangles[edge as usize][0];
        let k = mesh.local_edge(t as usize, edge) as u8;
        raw.bulges.push((t, k, [target[0] - middle[0], target[1] - middle[1]]));
    }
    Ok(Mesh::build(raw)?)
}

/// Edges of the curve of a region, or else around its triangles; ascending.
fn rim_edges(mesh: &Mesh, region: &Region) -> Vec<u32> {
    if !region.edges.is_empty() {
        return region.edges.clone();
    }
    let inside = |t: u32| region.cells.binary_search(&t).is_ok();
    let sides = mesh.topology().edge_triangles.iter();
    let parts = sides.map(|&[a, b]| b != NO_TRIANGLE && inside(a) != inside(b));
    (0..)
        .zip(parts)
        .filter(|(_, parts)| *parts)
        .map(|(edge, _)| edge)
        .collect()
}

/// Marks the vertices of boundary edges that are not in `rim` (ascending).
fn other_boundary(mesh: &Mesh, rim: &[u32]) -> Vec<bool> {
    let mut marked = vec![false; mesh.points().len()];
    for (edge, ends) in (0..).zip(&mesh.topology().edges) {
        if mesh.topology().is_boundary(edge) && rim.binary_search(&edge).is_err() {
            ends.iter().for_each(|&v| marked[v as usize] = true);
        }
    }
    marked
}

/// The circle through the nodes, which was found about `origin`, in words.
fn describe(found: Option<Circle>, origin: [f64; 2]) -> String {
    match found {
        Some(Circle { centre: [x, z], radius }) => format!(
            "through its nodes goes the circle x = {:.9} m, z = {:.9} m, radius {radius:.9} m",
            origin[0] + x,
            origin[1] + z
        ),
        None => "its nodes lie on no circle".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::RawMesh;
    use crate::quality::triangle_area;

    /// A ring of 6 by 3 unit squares, the film starting at `x = start`; the two triangles of the
    /// square from (1, 1) to (2, 2) are the region "pad".
    fn ring(start: f64) -> Mesh {
        let point = |v: u32| [start + (f64::from(v % 6) - start).rem_euclid(6.0), f64::from(v / 6)];
        let mut triangles = Vec::new();
        for (i, j) in (0..6).flat_map(|i| (0..3).map(move |j| (i, j))) {
            let (a, b) = (i + 6 * j, (i + 1) % 6 + 6 * j);
            triangles.extend([[a, b, b + 6], [a, b + 6, a + 6]]);
        }
        Mesh::build(RawMesh {
            points: (0..24).map(point).collect(),
            triangles,
            surfaces: vec![("pad".to_owned(), vec![8, 9])],
            period: Some(6.0),
            ..RawMesh::default()
        })
        .unwrap()
    }

    #[test]
    fn a_meshed_pad_becomes_round_also_across_the_seam() {
        // Through the corners of the pad, but for a little.
        let circle = Circle {
            centre: [1.5, 1.5],
            radius: 0.5f64.sqrt() * (1.0 + 5e-4),
        };
        for start in [0.0, 1.5, 2.5] {
            let mesh = curve_rim(&ring(start), "pad", &circle).unwrap();
            let cells = &mesh.region("pad").unwrap().cells;
            let area: f64 = cells.iter().map(|&t| triangle_area(&mesh, t as usize)).sum();
            // A square and four parabolas.
            let height = 1.0 - 0.5f64.sqrt();
            let expected = circle.radius.powi(2) * (2.0 + 4.0 * 2.0 / 3.0 * 2.0f64.sqrt() * height);
            assert!((area - expected).abs() < 1e-13);
            let film: f64 = (0..36).map(|t| triangle_area(&mesh, t)).sum();
            assert!((film - 18.0).abs() < 1e-13);
        }
        let wide = Circle { radius: 0.8, ..circle };
        let text = curve_rim(&ring(0.0), "pad", &wide).unwrap_err().to_string();
        assert!(
            text.contains("x = 1.500000000 m, z = 1.500000000 m, radius 0.707106781 m"),
            "{text}"
        );
    }
}
