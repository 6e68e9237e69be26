//! Round holes: puts the rim of a region on its circle in the developed surface.
//!
//! A file knows the rim of a hole by its nodes only. Where the scene gives the circle, vertices and
//! mid-side nodes of the rim are moved onto it, and the boundary is good to third order. Where it does
//! not, the mid-side nodes show the circle. Either way the mesh remembers it, so that rims stay
//! round when they are refined.

use std::collections::BTreeMap;

use crate::developed::shorter_way;
use crate::topology::NO_TRIANGLE;
use crate::{Circle, Error, Mesh, RawMesh, Region};

/// Largest distance of a rim vertex from the circle, as a fraction of its radius.
const CLOSE: f64 = 1e-3;
/// Curved edges are on a circle if their nodes are within this fraction of its radius ...
const ROUND: f64 = 1e-9;
/// ... and of their bulges: nearly straight edges would lie on many circles.
const BULGING: f64 = 1e-3;

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
    let from_centre = |point: [f64; 2]| between(circle.centre, point, mesh.period());
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

    let mut raw = mesh.to_raw();
    let fixed = other_boundary(mesh, &rim);
    for &v in &vertices {
        if !fixed[v as usize] {
            let point = &mut raw.points[v as usize];
            let shift = shift_onto(circle, *point, mesh.period());
            *point = [point[0] + shift[0], point[1] + shift[1]];
        }
    }
    raw.bulges.retain(|&(t, k, _)| rim.binary_search(&mesh.topology().triangle_edges[t as usize][k as usize]).is_err());
    for &edge in &rim {
        let [a, b] = edge_ends(edge).map(|v| raw.points[v as usize]);
        let t = mesh.topology().edge_triangles[edge as usize][0];
        let k = mesh.local_edge(t as usize, edge) as u8;
        raw.bulges.push((t, k, chord_bulge(circle, a, b, mesh.period())));
    }
    for (_, edges) in &mut raw.circles {
        edges.retain(|&[a, b]| {
            let edge = mesh.topology().edge_between(a, b);
            edge.is_none_or(|edge| rim.binary_search(&edge).is_err())
        });
    }
    raw.circles.retain(|(_, edges)| !edges.is_empty());
    raw.circles.push((*circle, rim.iter().map(|&edge| edge_ends(edge)).collect()));
    Ok(Mesh::build(raw)?)
}

/// Records in `raw` the circles on which its curved edges lie and that it does not have yet: wherever
/// two or more curved edges hang together and their vertices and mid-side nodes are on one circle to
/// 1e-9 of its radius. Nothing is moved.
pub fn recognise(raw: &mut RawMesh) {
    let known = raw.circles.iter().flat_map(|(_, edges)| edges);
    let known: Vec<[u32; 2]> = known.map(|&[a, b]| [a.min(b), a.max(b)]).collect();
    // Each edge once, with its bulge; a map in order, so that circles do not depend on hashes.
    let mut curved: BTreeMap<[u32; 2], [f64; 2]> = BTreeMap::new();
    for &(t, k, bulge) in &raw.bulges {
        let triangle = raw.triangles[t as usize];
        let (a, b) = (triangle[usize::from(k)], triangle[(usize::from(k) + 1) % 3]);
        curved.insert([a.min(b), a.max(b)], bulge);
    }
    known.iter().for_each(|edge| {
        curved.remove(edge);
    });
    let mut at_vertex: BTreeMap<u32, Vec<[u32; 2]>> = BTreeMap::new();
    for &edge in curved.keys() {
        edge.iter().for_each(|&v| at_vertex.entry(v).or_default().push(edge));
    }
    while let Some(seed) = curved.first_entry().map(|entry| *entry.key()) {
        let mut chain = Vec::new();
        let mut stack = vec![seed];
        while let Some(edge) = stack.pop() {
            if let Some(bulge) = curved.remove(&edge) {
                chain.push((edge, bulge));
                stack.extend(edge.iter().filter_map(|v| at_vertex.get(v)).flatten());
            }
        }
        if let Some(circle) = circle_through(raw, &chain) {
            let edges = chain.into_iter().map(|(edge, _)| edge).collect();
            raw.circles.push((circle, edges));
        }
    }
}

/// The circle through all nodes of a chain of curved edges with their bulges, if there is one.
fn circle_through(raw: &RawMesh, chain: &[([u32; 2], [f64; 2])]) -> Option<Circle> {
    let origin = raw.points[chain.first()?.0[0] as usize];
    let nodes = chain.iter().flat_map(|&(ends, bulge)| {
        let [a, b] = ends.map(|v| raw.points[v as usize]);
        let (from, along) = (between(origin, a, raw.period), between(a, b, raw.period));
        let middle = [0, 1].map(|d| from[d] + 0.5 * along[d] + bulge[d]);
        [from, [from[0] + along[0], from[1] + along[1]], middle]
    });
    let circle = Circle::fit(nodes.clone()).filter(|_| chain.len() > 1)?;
    let bulges = chain.iter().map(|(_, bulge)| bulge[0].hypot(bulge[1]));
    let allowed = bulges.fold(ROUND * circle.radius, |least, bulge| least.min(BULGING * bulge));
    let centre = [origin[0] + circle.centre[0], origin[1] + circle.centre[1]];
    let mut off = nodes.map(|node| circle.distance(node).abs());
    off.all(|off| off <= allowed).then_some(Circle { centre, ..circle })
}

/// Vector [m] from one point to another, on a ring the shorter way around.
fn between(from: [f64; 2], to: [f64; 2], period: Option<f64>) -> [f64; 2] {
    let along = to[0] - from[0];
    let along = period.map_or(along, |period| shorter_way(along, period));
    [along, to[1] - from[1]]
}

/// Vector [m] that takes a point to the nearest point of the circle.
pub(crate) fn shift_onto(circle: &Circle, point: [f64; 2], period: Option<f64>) -> [f64; 2] {
    let arm = between(circle.centre, point, period);
    let scale = circle.radius / arm[0].hypot(arm[1]);
    [arm[0] * scale - arm[0], arm[1] * scale - arm[1]]
}

/// Bulge [m] that puts the mid-side node of the edge from `a` to `b` on the circle.
pub(crate) fn chord_bulge(circle: &Circle, a: [f64; 2], b: [f64; 2], period: Option<f64>) -> [f64; 2] {
    let along = between(a, b, period);
    shift_onto(circle, [a[0] + 0.5 * along[0], a[1] + 0.5 * along[1]], period)
}

/// Edges of the curve of a region, or else around its triangles; ascending.
fn rim_edges(mesh: &Mesh, region: &Region) -> Vec<u32> {
    if !region.edges.is_empty() {
        return region.edges.clone();
    }
    let inside = |t: u32| region.cells.binary_search(&t).is_ok();
    let sides = mesh.topology().edge_triangles.iter();
    let parts = sides.map(|&[a, b]| b != NO_TRIANGLE && inside(a) != inside(b));
    (0..).zip(parts).filter(|(_, parts)| *parts).map(|(edge, _)| edge).collect()
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

    /// Drops the circles that a mesh knows.
    fn forget(mesh: &Mesh) -> RawMesh {
        RawMesh { circles: Vec::new(), ..mesh.to_raw() }
    }

    #[test]
    fn circles_are_remembered_and_recognised() {
        let circle = Circle { centre: [1.5, 1.5], radius: 0.5f64.sqrt() };
        for start in [0.0, 1.5, 2.5] {
            let mesh = curve_rim(&ring(start), "pad", &circle).unwrap();
            let again = Mesh::build(mesh.to_raw()).unwrap();
            assert_eq!(again.circles(), mesh.circles());
            assert_eq!(curve_rim(&mesh, "pad", &circle).unwrap().circles(), mesh.circles());
            let mut raw = forget(&mesh);
            recognise(&mut raw);
            recognise(&mut raw);
            let found = Mesh::build(raw).unwrap();
            let [(known, edges)] = found.circles() else {
                panic!("{:?}", found.circles());
            };
            assert_eq!(edges, &mesh.circles()[0].1);
            assert_eq!(found.circle(edges[2]), Some(known));
            assert!((known.radius - circle.radius).abs() < 1e-14);
            let off = between(circle.centre, known.centre, Some(6.0));
            assert!(off[0].hypot(off[1]) < 1e-14);
        }
    }

    #[test]
    fn what_is_not_round_is_not_recognised() {
        let circle = Circle { centre: [1.5, 1.5], radius: 0.5f64.sqrt() };
        let round = curve_rim(&ring(0.0), "pad", &circle).unwrap();
        let mut bent = forget(&round);
        let edge = |&(t, k, _): &(u32, u8, [f64; 2])| round.topology().triangle_edges[t as usize][usize::from(k)];
        let first = edge(&bent.bulges[0]);
        bent.bulges.iter_mut().filter(|bulge| edge(bulge) == first).for_each(|bulge| bulge.2[0] += 1e-6);
        let mut lone = forget(&round);
        lone.bulges.retain(|bulge| edge(bulge) == first);
        // Almost straight: no circle is meant.
        let mut noisy = forget(&ring(0.0));
        noisy.bulges = (0..36).map(|t| (t, 0, [1e-8, 3e-8])).collect();
        for mut raw in [bent, lone, noisy] {
            recognise(&mut raw);
            assert!(raw.circles.is_empty());
        }
    }

    #[test]
    fn a_meshed_pad_becomes_round_also_across_the_seam() {
        // Through the corners of the pad, but for a little.
        let circle = Circle { centre: [1.5, 1.5], radius: 0.5f64.sqrt() * (1.0 + 5e-4) };
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
        assert!(text.contains("x = 1.500000000 m, z = 1.500000000 m, radius 0.707106781 m"), "{text}");
    }
}
