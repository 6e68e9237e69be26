//! Meshes made Delaunay by edge flips: jittered, stretched, sheared, with holes and grooves.

use std::f64::consts::{PI, TAU};

use oilwedge_mesh::developed::LinerDomain;
use oilwedge_mesh::flip::{Flipped, to_delaunay};
use oilwedge_mesh::generate::{Blueprint, Feature, RoundedRectangle, generate};
use oilwedge_mesh::quality::triangle_area;
use oilwedge_mesh::{Mesh, RawMesh, refine};

use crate::random::Random;

/// A ring of `n` columns and `m` rows of jittered cells of height one and width `aspect`: a pocket that
/// lies across the seam, and a film.
fn jittered(n: u32, m: u32, aspect: f64, random: &mut Random) -> Mesh {
    let vertex = |i: u32, j: u32| i % n + n * j;
    let (mut points, mut triangles) = (Vec::new(), Vec::new());
    let (mut pocket, mut film, mut low, mut high) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    for (j, i) in (0..=m).flat_map(|j| (0..n).map(move |i| (j, i))) {
        let free = if j % m == 0 { 0.0 } else { 1.0 };
        let x = f64::from(i) + random.between(-0.24, 0.24);
        points.push([aspect * x, f64::from(j) + free * random.between(-0.24, 0.24)]);
    }
    for (j, i) in (0..m).flat_map(|j| (0..n).map(move |i| (j, i))) {
        let (a, b, c, d) = (vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
        let halves = [[[a, b, c], [a, c, d]], [[a, b, d], [b, c, d]]][usize::from(random.unit() < 0.5)];
        let in_pocket = (m / 4..m / 2).contains(&j) && (i < n / 6 || i >= n - n / 8);
        let surface = if in_pocket { &mut pocket } else { &mut film };
        surface.extend([triangles.len() as u32, triangles.len() as u32 + 1]);
        triangles.extend(halves);
    }
    for i in 0..n {
        low.push([vertex(i, 0), vertex(i + 1, 0)]);
        high.push([vertex(i, m), vertex(i + 1, m)]);
    }
    Mesh::build(RawMesh {
        points,
        triangles,
        curves: vec![("end_low".to_owned(), low), ("end_high".to_owned(), high)],
        surfaces: vec![("film".to_owned(), film), ("pocket".to_owned(), pocket)],
        period: Some(aspect * f64::from(n)),
        ..RawMesh::default()
    })
    .unwrap()
}

/// A ring with a round hole and a pocket, or an arc without.
fn generated(size: f64, arc: bool) -> Mesh {
    let feature = |name: &str, x: f64, half: [f64; 2], corner: f64, meshed: bool| Feature {
        name: name.to_owned(),
        shape: RoundedRectangle { centre: [x, 0.1], half, corner },
        meshed,
    };
    let features = vec![
        feature("hole", 2.0, [0.3, 0.3], 0.3, false),
        feature("pocket", 4.0, [0.5, 0.4], 0.1, true),
        feature("groove", 5.5, [0.2, 0.6], 0.0, false),
    ];
    let liner = LinerDomain { radius: 1.0, length: 2.0, arc: arc.then_some((0.5, 3.5)) };
    let blueprint = Blueprint { liner, features: if arc { Vec::new() } else { features }, line: None };
    generate(&blueprint, &|_| size).unwrap()
}

/// Edges that must not flip.
fn fixed(mesh: &Mesh) -> Vec<bool> {
    let topology = mesh.topology();
    let names = |t: u32| -> Vec<&str> {
        let regions = mesh.regions().iter();
        let own = regions.filter(|region| region.cells.binary_search(&t).is_ok());
        own.map(|region| region.name.as_str()).collect()
    };
    (0..topology.edges.len() as u32)
        .map(|edge| {
            let [t, u] = topology.edge_triangles[edge as usize];
            let named = mesh.regions().iter().any(|region| region.edges.binary_search(&edge).is_ok());
            let bent = mesh.circle(edge).is_some() || mesh.bulge(edge) != [0.0; 2];
            topology.is_boundary(edge) || named || bent || names(t) != names(u)
        })
        .collect()
}

/// The angle of triangle `t` that faces an edge [rad].
fn facing(mesh: &Mesh, t: usize, edge: u32) -> f64 {
    let (corners, k) = (mesh.corners(t), mesh.local_edge(t, edge));
    let [a, b, c] = [0, 1, 2].map(|step| corners[(k + step) % 3]);
    let (u, v) = ([a[0] - c[0], a[1] - c[1]], [b[0] - c[0], b[1] - c[1]]);
    (u[0] * v[1] - u[1] * v[0]).atan2(u[0] * v[0] + u[1] * v[1])
}

/// Edges that may flip, whose facing angles add up to more than pi: of straight and of curved triangles.
fn wrong_edges(mesh: &Mesh) -> [usize; 2] {
    let fixed = fixed(mesh);
    let mut wrong = [0; 2];
    for (edge, sides) in (0u32..).zip(&mesh.topology().edge_triangles) {
        if !fixed[edge as usize] {
            let sum: f64 = sides.iter().map(|&t| facing(mesh, t as usize, edge)).sum();
            let curved = sides.iter().any(|&t| mesh.is_curved(t as usize));
            wrong[usize::from(curved)] += usize::from(sum > PI + 2e-10);
        }
    }
    wrong
}

fn surface_area(mesh: &Mesh, cells: &[u32]) -> f64 {
    cells.iter().map(|&t| triangle_area(mesh, t as usize)).sum()
}

/// Ends of edges, ascending.
fn pairs(mesh: &Mesh, edges: impl Iterator<Item = u32>) -> Vec<[u32; 2]> {
    let mut pairs: Vec<_> = edges.map(|edge| mesh.topology().edges[edge as usize]).collect();
    pairs.sort_unstable();
    pairs
}

/// Flips `mesh`, checks what must be so afterwards, and returns it and the wrong edges left at curved triangles.
fn check(mesh: &Mesh) -> (Flipped, usize) {
    let before = wrong_edges(mesh);
    let flipped = to_delaunay(mesh, &[]).unwrap_or_else(|| panic!("nothing to flip: {before:?}"));
    let after = &flipped.mesh;
    let [straight, curved] = wrong_edges(after);
    assert_eq!(straight, 0, "of {before:?}");
    assert!(flipped.flips < 5 * mesh.topology().edges.len(), "{} flips", flipped.flips);
    assert!(to_delaunay(after, &[]).is_none());
    // Nothing but inner edges has changed.
    assert_eq!(after.points(), mesh.points());
    assert_eq!(after.period(), mesh.period());
    assert_eq!(after.triangles().len(), mesh.triangles().len());
    let boundary = |mesh: &Mesh| {
        let edges = 0..mesh.topology().edges.len() as u32;
        pairs(mesh, edges.filter(|&edge| mesh.topology().is_boundary(edge)))
    };
    assert_eq!(boundary(after), boundary(mesh));
    for v in 0..mesh.points().len() as u32 {
        assert_eq!(after.label(v), mesh.label(v));
    }
    for region in mesh.regions() {
        let other = after.region(&region.name).unwrap();
        assert_eq!(pairs(after, other.edges.iter().copied()), pairs(mesh, region.edges.iter().copied()));
        assert_eq!(other.cells.len(), region.cells.len());
        let (a, b) = (surface_area(after, &other.cells), surface_area(mesh, &region.cells));
        assert!((a - b).abs() <= 1e-12 * b, "{}: {a} {b}", region.name);
        for (t, parent) in (0u32..).zip(&flipped.parents) {
            let (new, old) = (other.cells.binary_search(&t), region.cells.binary_search(parent));
            assert_eq!(new.is_ok(), old.is_ok());
        }
    }
    assert_eq!(after.circles().len(), mesh.circles().len());
    for ((circle, edges), (other, others)) in mesh.circles().iter().zip(after.circles()) {
        assert_eq!(circle, other);
        assert_eq!(pairs(mesh, edges.iter().copied()), pairs(after, others.iter().copied()));
        for &edge in others {
            let [_, _, [x, z]] = after.edge_nodes(edge);
            let along = x - circle.centre[0];
            let along = mesh.period().map_or(along, |period| along - period * (along / period).round());
            assert!((along.hypot(z - circle.centre[1]) / circle.radius - 1.0).abs() < 1e-9);
        }
    }
    (flipped, curved)
}

/// Moves vertices on no fixed edge, each less than half of the least height around it in all.
fn shaken(mesh: &Mesh, random: &mut Random, by: f64) -> Mesh {
    let fixed = fixed(mesh);
    let mut reach = vec![f64::INFINITY; mesh.points().len()];
    for (t, triangle) in mesh.triangles().iter().enumerate() {
        let corners = mesh.corners(t);
        let longest = (0..3).map(|k| {
            let (a, b) = (corners[k], corners[(k + 1) % 3]);
            (b[0] - a[0]).hypot(b[1] - a[1])
        });
        let height = 2.0 * triangle_area(mesh, t) / longest.fold(0.0, f64::max);
        for &v in triangle {
            reach[v as usize] = reach[v as usize].min(by * height);
        }
    }
    for (edge, ends) in mesh.topology().edges.iter().enumerate() {
        if fixed[edge] {
            ends.iter().for_each(|&v| reach[v as usize] = 0.0);
        }
    }
    let mut raw = mesh.to_raw();
    for (point, reach) in raw.points.iter_mut().zip(reach) {
        let (sin, cos) = random.between(0.0, TAU).sin_cos();
        *point = [point[0] + reach * cos, point[1] + reach * sin];
    }
    Mesh::build(raw).unwrap()
}

/// The mesh with every place moved around the ring in proportion to its height.
fn sheared(mesh: &Mesh, by: f64) -> Mesh {
    let mut raw = mesh.to_raw();
    let period = raw.period.unwrap();
    for point in &mut raw.points {
        point[0] = (point[0] + by * point[1]).rem_euclid(period);
    }
    Mesh::build(raw).unwrap()
}

#[test]
fn jittered_stretched_rings() {
    let mut random = Random(1);
    for (aspect, n, m) in [(5.0, 24, 40), (1.0 / 3.0, 90, 12), (1.0, 7, 5), (5.0, 12, 200)] {
        for _ in 0..20 {
            let mesh = jittered(n, m, aspect, &mut random);
            let (flipped, curved) = check(&mesh);
            assert!(curved == 0 && flipped.flips > 0);
        }
    }
}

#[test]
fn shaken_liners_with_curved_rims() {
    let mut random = Random(2);
    let (mut flips, mut left) = (0, 0);
    for round in 0..40 {
        let size = random.between(0.05, 0.4);
        let mut mesh = generated(size, round % 4 == 3);
        for _ in 0..3 {
            mesh = shaken(&mesh, &mut random, 0.45);
        }
        let marked: Vec<bool> = mesh.triangles().iter().map(|_| random.unit() < 0.2).collect();
        let mesh = refine::local(&mesh, &marked).unwrap().mesh;
        let (flipped, curved) = check(&mesh);
        flips += flipped.flips;
        left += curved;
    }
    assert!(left * 100 <= flips, "{left} of {flips}");
}

#[test]
fn a_delaunay_mesh_is_left_alone() {
    for arc in [false, true] {
        let mesh = generated(0.2, arc);
        let mesh = to_delaunay(&mesh, &[]).map_or(mesh, |flipped| flipped.mesh);
        assert!(to_delaunay(&mesh, &[]).is_none());
    }
    // Squares: all diagonals are as good.
    let mut random = Random(3);
    let mut raw = jittered(16, 9, 1.0, &mut random).to_raw();
    for point in &mut raw.points {
        *point = [(point[0].round() + 16.0) % 16.0 * 0.1, point[1].round() * 0.1];
    }
    raw.period = Some(1.6);
    let squares = Mesh::build(raw).unwrap();
    assert!(to_delaunay(&squares, &[]).is_none());
    // Nor do they flip for ever when rounding tells them apart.
    let there = check(&sheared(&squares, 1.7)).0;
    check(&sheared(&there.mesh, -1.7));
}

#[test]
fn a_sheared_mesh_finds_back() {
    let by_labels = |mesh: &Mesh| {
        let mut all: Vec<[u64; 3]> = mesh.triangles().iter().map(|t| t.map(|v| mesh.label(v))).collect();
        all.iter_mut().for_each(|triangle| triangle.sort_unstable());
        all.sort_unstable();
        all
    };
    let mut random = Random(4);
    for _ in 0..10 {
        let mesh = jittered(40, 20, 1.0, &mut random);
        let mut raw = mesh.to_raw();
        raw.surfaces.clear();
        let mesh = to_delaunay(&Mesh::build(raw).unwrap(), &[]).unwrap().mesh;
        let there = check(&sheared(&mesh, 1.7)).0;
        assert!(there.flips > 500);
        let back = check(&sheared(&there.mesh, -1.7)).0.mesh;
        assert_eq!(by_labels(&back), by_labels(&mesh));
    }
}

#[test]
fn a_flip_that_would_fold_a_curved_triangle_is_left() {
    // The edge between the first two vertices flips, unless the new triangle below it has too deep a rim; that
    // between the second and the fifth flips anyway.
    for (depth, flips) in [(0.0, 2), (0.05, 2), (0.35, 1)] {
        let mesh = Mesh::build(RawMesh {
            points: vec![[1.0, 0.0], [0.5, 3.0], [-1.0, 0.0], [1.2, 0.5], [-4.0, 4.0], [-1.6, 4.0]],
            triangles: vec![[0, 1, 2], [1, 0, 3], [2, 1, 4], [4, 1, 5]],
            bulges: vec![(0, 2, [0.0, depth])],
            ..RawMesh::default()
        })
        .unwrap();
        let flipped = to_delaunay(&mesh, &[]).unwrap();
        assert_eq!(flipped.flips, flips, "{depth}");
        let area = |mesh: &Mesh| surface_area(mesh, &[0, 1, 2, 3]);
        assert!((area(&flipped.mesh) - area(&mesh)).abs() < 1e-14);
    }
}

#[test]
fn kept_edges_stay() {
    let mesh = jittered(24, 40, 5.0, &mut Random(5));
    let all: Vec<u32> = (0..mesh.topology().edges.len() as u32).collect();
    assert!(to_delaunay(&mesh, &all).is_none());
    let kept: Vec<u32> = all.into_iter().step_by(7).collect();
    let flipped = to_delaunay(&mesh, &kept).unwrap().mesh;
    for edge in kept {
        let [a, b] = mesh.topology().edges[edge as usize];
        assert!(flipped.topology().edge_between(a, b).is_some());
    }
}
