//! Refined meshes keep the geometry, the regions and the fields of the first.

use std::collections::HashSet;
use std::f64::consts::{PI, TAU};
use std::path::PathBuf;
use std::sync::Arc;

use oilwedge_fem::mapping::Mapping;
use oilwedge_fem::{Field, Space, transfer};
use oilwedge_mesh::refine::{self, Refined};
use oilwedge_mesh::topology::NO_TRIANGLE;
use oilwedge_mesh::{Circle, Defect, Locator, Mesh, Quality, RawMesh, developed, quality, rim};
use oilwedge_tests::{RADIUS, ring};
use proptest::prelude::*;

/// Radius and length of the liners in meshes/ [m].
const BORE: f64 = 0.0375;
const LENGTH: f64 = 0.075;

fn read(name: &str) -> Mesh {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../meshes").join(name);
    developed::read_alone(path).unwrap_or_else(|error| panic!("{error}"))
}

/// A hole of the liners in meshes/, from its angle [deg], `z` and diameter [mm].
fn hole(degrees: f64, z: f64, diameter: f64) -> Circle {
    Circle { centre: [BORE * degrees.to_radians(), 1e-3 * z], radius: 0.5e-3 * diameter }
}

/// A mesh, its name, the exact area [m2] of its film, and its holes.
struct Case {
    name: &'static str,
    mesh: Mesh,
    area: f64,
    holes: Vec<(&'static str, Circle)>,
}

fn cases() -> Vec<Case> {
    let feed = ("feed_hole", hole(130.0, 0.0, 17.0));
    let holes_of_groove = vec![("hole_a", hole(30.0, 15.0, 10.0)), ("hole_b", hole(240.0, -12.0, 8.0))];
    let groove = BORE * 20f64.to_radians() * 0.75 * LENGTH;
    let case = |name, mesh, outline: f64, holes: Vec<(&'static str, Circle)>| Case {
        name,
        mesh,
        area: outline - holes.iter().map(|(_, circle)| PI * circle.radius.powi(2)).sum::<f64>(),
        holes,
    };
    let full = TAU * BORE * LENGTH;
    let plain = TAU * RADIUS * 0.1;
    vec![
        case("plain ring", ring(12, 4, 0.1, 0.0), plain, vec![]),
        case("ring from 100 degrees", ring(13, 3, 0.1, 1.745), plain, vec![]),
        case("flexpde_shell.msh", read("flexpde_shell.msh"), 0.5 * full, vec![feed]),
        case("flexpde_ring.msh", read("flexpde_ring.msh"), full, vec![feed]),
        case("grooved_liner.msh", read("grooved_liner.msh"), full - groove, holes_of_groove),
    ]
}

/// Distance [m] of two positions, on a ring modulo the period.
fn distance(a: [f64; 2], b: [f64; 2], period: Option<f64>) -> f64 {
    let along = a[0] - b[0];
    let along = period.map_or(along, |period| along - period * (along / period).round());
    along.hypot(a[1] - b[1])
}

/// Greatest distance of a node of a rim from its circle, in radii.
fn off_circles(mesh: &Mesh) -> f64 {
    let off =
        |circle: &Circle, node: [f64; 2]| (distance(node, circle.centre, mesh.period()) / circle.radius - 1.0).abs();
    let rims = mesh.circles().iter();
    rims.flat_map(|(circle, edges)| {
        edges.iter().flat_map(move |&edge| mesh.edge_nodes(edge).map(|node| off(circle, node)))
    })
    .fold(0.0, f64::max)
}

/// Length [m] of the chords of a region.
fn chords(mesh: &Mesh, region: &str) -> f64 {
    let edges = mesh.region(region).unwrap().edges.iter();
    edges.map(|&edge| mesh.edge_nodes(edge)).map(|[a, b, _]| distance(a, b, None)).sum()
}

/// What holds after every refinement, however it was marked.
fn check(name: &str, coarse: &Mesh, refined: &Refined) {
    let fine = &refined.mesh;
    let (before, after) = (Quality::of(coarse), Quality::of(fine));
    assert_eq!(before.boundary_loops, after.boundary_loops, "{name}");
    assert_eq!(before.unnamed_boundary_edges == 0, after.unnamed_boundary_edges == 0, "{name}");
    assert!(off_circles(fine) < 1e-12, "{name}: {:e} radii off", off_circles(fine));
    assert_eq!(coarse.circles().len(), fine.circles().len());
    let start = |mesh: &Mesh| mesh.points().iter().map(|point| point[0]).fold(f64::INFINITY, f64::min);
    if let Some(period) = coarse.period() {
        assert!(fine.points().iter().all(|point| point[0] < start(coarse) + period));
        assert_eq!(start(coarse), start(fine), "{name}");
    }
    // Regions are as long and as wide as they were.
    for region in coarse.regions() {
        let round = region.edges.first().is_some_and(|&edge| coarse.circle(edge).is_some());
        if !region.edges.is_empty() && !round {
            let (before, after) = (chords(coarse, &region.name), chords(fine, &region.name));
            assert!((before - after).abs() < 1e-13 * before, "{name}: {}", region.name);
        }
        let inherited = refined.lineage.iter().filter(|child| region.cells.binary_search(&child.parent).is_ok());
        assert_eq!(fine.region(&region.name).unwrap().cells.len(), inherited.count());
    }
    // Children fill their parents, turn the right way, and lie where they say.
    assert_eq!(refined.lineage.len(), fine.triangles().len());
    let mut filled = vec![0.0; coarse.triangles().len()];
    let scale = coarse.points().iter().flatten().fold(0.0, |scale: f64, x| scale.max(x.abs()));
    for (t, child) in refined.lineage.iter().enumerate() {
        assert!(quality::triangle_area(fine, t) > 0.0);
        let [a, b, c] = child.corners;
        filled[child.parent as usize] += (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        let mapping = Mapping::of(coarse, child.parent as usize);
        for (corner, vertex) in child.corners.into_iter().zip(fine.corners(t)) {
            let off = distance(mapping.at(corner).position, vertex, coarse.period());
            assert!(off < 1e-14 * scale, "{name}: a corner is {off:e} m off");
        }
    }
    assert!(filled.iter().all(|&filled| filled == 1.0));
    check_transfer(name, coarse, refined);
}

/// Random numbers in [0, 1), always the same.
fn random(count: usize, seed: u64) -> Vec<f64> {
    let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
    let next = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    std::iter::repeat_with(next).take(count).collect()
}

/// Fields are the same functions on both meshes.
fn check_transfer(name: &str, coarse: &Mesh, refined: &Refined) {
    let (coarse, fine) = (Arc::new(coarse.clone()), Arc::new(refined.mesh.clone()));
    // Rings have no other quadratic function than one of z.
    let along = if coarse.period().is_some() { 0.0 } else { 1.0 };
    let size = coarse.points().iter().flatten().fold(0.0, |size: f64, x| size.max(x.abs()));
    let quadratic = |[x, z]: [f64; 2]| {
        let (x, z) = (along * x / size, z / size);
        0.3 + x - 2.0 * z + x * x - 0.7 * x * z + 0.4 * z * z
    };
    for degree in 1..=3 {
        let (from, to) = (Space::new(coarse.clone(), degree), Space::new(fine.clone(), degree));
        if degree >= 2 {
            let values = from.interpolate(quadratic);
            let field = Field { space: &from, values: &values };
            let carried = transfer(&field, &to, &refined.lineage);
            let positions = to.positions();
            let parents = refined.lineage.iter().map(|child| child.parent as usize);
            for (t, _) in parents.enumerate().filter(|&(_, parent)| !coarse.is_curved(parent)) {
                for &dof in &to.element_dofs(t)[..to.shapes()] {
                    let error = carried[dof] - quadratic(positions[dof]);
                    assert!(error.abs() < 1e-13, "{name}: {error:e} in degree {degree}");
                }
            }
        }
        let values = random(from.dofs(), degree as u64);
        let field = Field { space: &from, values: &values };
        let carried = transfer(&field, &to, &refined.lineage);
        let carried = Field { space: &to, values: &carried };
        for (t, child) in refined.lineage.iter().enumerate() {
            let [s, r] = [0, 1].map(|k| random(2, t as u64)[k]);
            let at = [s * (1.0 - r), s * r];
            let [a, b, c] = child.corners;
            let in_parent = [0, 1].map(|d| a[d] + at[0] * (b[d] - a[d]) + at[1] * (c[d] - a[d]));
            let error = carried.value(t, at) - field.value(child.parent as usize, in_parent);
            assert!(error.abs() < 1e-13, "{name}: {error:e} inside triangle {t}");
        }
        // Also where the surface says, not the lineage.
        let (here, there) = (Locator::new(&coarse), Locator::new(&fine));
        let mut met = 0;
        for place in random(400, 7).chunks(2) {
            let [x, z] = [place[0] * TAU * BORE, (place[1] - 0.5) * LENGTH];
            let (Some((parent, at)), Some((t, in_child))) = (here.find([x, z]), there.find([x, z])) else {
                continue;
            };
            if !coarse.is_curved(parent) {
                met += 1;
                let error = carried.value(t, in_child) - field.value(parent, at);
                assert!(error.abs() < 1e-10, "{name}: {error:e} at {x}, {z}");
            }
        }
        assert!(met > 50, "{name}: {met} points met the film");
    }
}

#[test]
fn uniform_refinement_keeps_the_geometry() {
    for case in cases() {
        let known = case.mesh.circles();
        assert_eq!(known.len(), case.holes.len(), "{}", case.name);
        // Once with the circles found in the file, once with those told.
        let told = case
            .holes
            .iter()
            .fold(case.mesh.clone(), |mesh, (region, circle)| rim::curve_rim(&mesh, region, circle).unwrap());
        assert_eq!(told.circles().len(), case.holes.len());
        for mut mesh in [case.mesh.clone(), told] {
            let mut errors = Vec::new();
            for _ in 0..2 {
                let refined = refine::uniform(&mesh).unwrap();
                check(case.name, &mesh, &refined);
                assert_eq!(refined.mesh.triangles().len(), 4 * mesh.triangles().len());
                let boundary =
                    |mesh: &Mesh| mesh.topology().edge_triangles.iter().filter(|t| t[1] == NO_TRIANGLE).count();
                assert_eq!(boundary(&refined.mesh), 2 * boundary(&mesh));
                errors.push(Quality::of(&mesh).area - case.area);
                mesh = refined.mesh;
            }
            errors.push(Quality::of(&mesh).area - case.area);
            if case.holes.is_empty() {
                assert!(errors.iter().all(|error| error.abs() < 1e-13 * case.area));
            } else {
                // Parabolas through three points of an arc leave a fourth-order error.
                for pair in errors.windows(2) {
                    assert!((pair[0] / pair[1] - 16.0).abs() < 0.1, "{}: {errors:?}", case.name);
                }
            }
        }
    }
}

/// Refines six times where `near` says, of the corners of a triangle, and compares the least angles.
fn refine_six_times(name: &str, mut mesh: Mesh, near: impl Fn([[f64; 2]; 3]) -> bool) {
    let first = Quality::of(&mesh).least_angle;
    for _ in 0..6 {
        let marked: Vec<bool> = (0..mesh.triangles().len()).map(|t| near(mesh.corners(t))).collect();
        assert!(marked.contains(&true), "{name}");
        let refined = refine::local(&mesh, &marked).unwrap();
        check(name, &mesh, &refined);
        let mut children = vec![0; marked.len()];
        refined.lineage.iter().for_each(|child| children[child.parent as usize] += 1);
        assert!(marked.iter().zip(&children).all(|(marked, &count)| !marked || count == 4));
        mesh = refined.mesh;
        let least = Quality::of(&mesh).least_angle;
        assert!(least > 0.5 * first, "{name}: from {first} to {least} degrees");
    }
}

#[test]
fn local_refinement_at_points_and_lines() {
    for case in cases() {
        let x = case.mesh.points()[0][0];
        // At a vertex of the outline or of a rim; the first ring is met at its seam.
        let boundary =
            (0..case.mesh.topology().edges.len() as u32).filter(|&edge| case.mesh.topology().is_boundary(edge));
        let vertices: HashSet<u32> = boundary.flat_map(|edge| case.mesh.topology().edges[edge as usize]).collect();
        let places = [vertices.iter().min().copied(), vertices.iter().max().copied()];
        for v in places.into_iter().flatten() {
            let place = case.mesh.points()[v as usize];
            let at = |corners: [[f64; 2]; 3]| {
                corners.iter().any(|&corner| distance(corner, place, case.mesh.period()) < 1e-12)
            };
            refine_six_times(&format!("{} at {place:?}", case.name), case.mesh.clone(), at);
        }
        let across = |corners: [[f64; 2]; 3]| {
            let side = |corner: [f64; 2]| corner[0] + 0.3 * corner[1] - x - 0.01234 > 0.0;
            corners.iter().any(|&corner| side(corner)) && corners.iter().any(|&corner| !side(corner))
        };
        refine_six_times(&format!("{} along a line", case.name), case.mesh.clone(), across);
        for (region, circle) in &case.holes {
            let on_rim = |corners: [[f64; 2]; 3]| {
                let off = |corner| (distance(corner, circle.centre, case.mesh.period()) - circle.radius).abs();
                corners.into_iter().filter(|&corner| off(corner) < 1e-9).count() == 2
            };
            refine_six_times(&format!("{} along {region}", case.name), case.mesh.clone(), on_rim);
        }
    }
}

#[test]
fn the_rim_of_a_meshed_hole_is_refined_from_both_sides() {
    let mut mesh = read("flexpde_shell_meshed_hole.msh");
    let circle = hole(130.0, 0.0, 17.0);
    assert_eq!(mesh.circles().len(), 1);
    let feed = |mesh: &Mesh| -> f64 {
        let cells = &mesh.region("feed_hole").unwrap().cells;
        cells.iter().map(|&t| quality::triangle_area(mesh, t as usize)).sum()
    };
    let film = Quality::of(&mesh).area;
    let mut errors = vec![feed(&mesh) - PI * circle.radius.powi(2)];
    for _ in 0..2 {
        let refined = refine::uniform(&mesh).unwrap();
        check("meshed hole", &mesh, &refined);
        mesh = refined.mesh;
        errors.push(feed(&mesh) - PI * circle.radius.powi(2));
        assert!((Quality::of(&mesh).area - film).abs() < 1e-13 * film);
    }
    assert!(errors.windows(2).all(|pair| (pair[0] / pair[1] - 16.0).abs() < 0.1), "{errors:?}");
    let [x, z] = mesh.circles()[0].0.centre;
    assert!(circle.distance([x, z]) + circle.radius < 1e-14);
}

/// A round hole by six edges in a hexagon: twelve triangles, which bulge into the film.
fn nut(outer: f64) -> Mesh {
    let corner =
        |k: u32, radius: f64| [radius * (f64::from(k) * PI / 3.0).cos(), radius * (f64::from(k) * PI / 3.0).sin()];
    let points = (0..6).map(|k| corner(k, 1.0)).chain((0..6).map(|k| corner(k, outer)));
    let raw = RawMesh {
        points: points.collect(),
        triangles: (0..6).flat_map(|k| [[k, k + 6, (k + 1) % 6], [(k + 1) % 6, k + 6, (k + 1) % 6 + 6]]).collect(),
        curves: vec![("hole".to_owned(), (0..6).map(|k| [k, (k + 1) % 6]).collect())],
        ..RawMesh::default()
    };
    let circle = Circle { centre: [0.0; 2], radius: 1.0 };
    rim::curve_rim(&Mesh::build(raw).unwrap(), "hole", &circle).unwrap()
}

#[test]
fn a_coarse_rim_bears_any_marks_or_is_refused() {
    for outer in [2.0, 2.2, 3.0] {
        let first = nut(outer);
        for marks in 0..1u32 << 12 {
            let marked: Vec<bool> = (0..12).map(|t| marks >> t & 1 == 1).collect();
            let refined = refine::local(&first, &marked).unwrap_or_else(|defects| panic!("{outer}: {defects:?}"));
            assert!(off_circles(&refined.mesh) < 1e-14);
        }
    }
    // The first mesh only just holds; straight edges inside its triangles would cut the rim.
    let defects = refine::uniform(&nut(1.95)).unwrap_err();
    assert!(defects.iter().all(|defect| matches!(defect, Defect::Inverted { .. })));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 12, failure_persistence: None, ..ProptestConfig::default() })]
    #[test]
    fn random_marks_keep_everything(which in 0usize..5, seed in 1u64..1_000_000, share in 0.001f64..0.3) {
        let case = cases().swap_remove(which);
        let mut mesh = case.mesh;
        let first = Quality::of(&mesh).least_angle;
        for round in 0..3 {
            let marked: Vec<bool> = random(mesh.triangles().len(), seed + round).iter().map(|&x| x < share).collect();
            let refined = refine::local(&mesh, &marked).unwrap();
            check(case.name, &mesh, &refined);
            mesh = refined.mesh;
        }
        prop_assert!(Quality::of(&mesh).least_angle > 0.5 * first);
    }
}
