use super::*;

const RADIUS: f64 = 2.0;
const LENGTH: f64 = 3.0;

fn liner(arc: Option<(f64, f64)>) -> LinerDomain {
    LinerDomain { radius: RADIUS, length: LENGTH, arc }
}

/// `columns` times 4 rectangles over `x` in `[x0, x0 + width]`, all boundary curves named; the two
/// edges are nodes of their own.
fn plane(columns: u32, x0: f64, width: f64) -> MshFile {
    let vertex = |i: u32, j: u32| 5 * i + j;
    let nodes = (0..=columns).flat_map(|i| {
        (0..5).map(move |j| [x0 + width * f64::from(i) / f64::from(columns), LENGTH * f64::from(j) / 4.0, 0.0])
    });
    let nodes: Vec<_> = nodes.collect();
    let cells = (0..columns).flat_map(|i| (0..4).map(move |j| (i, j)));
    let triangles: Vec<[u32; 3]> = cells
        .flat_map(|(i, j)| {
            let (a, b, c, d) = (vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
            [[a, b, c], [a, c, d]]
        })
        .collect();
    let along = |j: u32| (0..columns).map(|i| [vertex(i, j), vertex(i + 1, j)]).collect();
    let up = |i: u32| (0..4).map(|j| [vertex(i, j), vertex(i, j + 1)]).collect();
    MshFile {
        tags: (1..=nodes.len() as u64).collect(),
        nodes,
        surfaces: vec![("film".to_owned(), (0..triangles.len() as u32).collect())],
        triangles,
        curves: vec![
            ("end_low".to_owned(), along(0)),
            ("end_high".to_owned(), along(4)),
            ("left".to_owned(), up(0)),
            ("right".to_owned(), up(columns)),
        ],
        ..MshFile::default()
    }
}

fn named(mut file: MshFile, left: &str, right: &str) -> MshFile {
    file.curves[2].0 = left.to_owned();
    file.curves[3].0 = right.to_owned();
    file
}

/// Rolls a plane file onto the cylinder along y about the origin.
fn rolled(mut file: MshFile) -> MshFile {
    for node in &mut file.nodes {
        let phi = node[0] / RADIUS;
        *node = [RADIUS * phi.sin(), node[1], RADIUS * phi.cos()];
    }
    file
}

fn area(mesh: &Mesh) -> f64 {
    crate::Quality::of(mesh).area
}

#[test]
fn an_unrolled_ring_is_glued_wherever_its_seam_is() {
    for x0 in [0.0, -5.0, 100.0] {
        let file = named(plane(12, x0, TAU * RADIUS), "seam_low", "seam_high");
        let mesh = Mesh::build(unroll(&file, &liner(None), 1.0).unwrap()).unwrap();
        assert_eq!(mesh.points().len(), 60);
        assert!((area(&mesh) - TAU * RADIUS * LENGTH).abs() < 1e-12 * 100.0);
        let seams = ["seam_low", "seam_high"].map(|name| mesh.region(name).unwrap().edges.clone());
        assert_eq!(seams[0], seams[1]);
        assert_eq!(seams[0].len(), 4);
        assert!(mesh.points().iter().all(|p| p[0] >= x0 && p[0] < x0 + TAU * RADIUS && p[1].abs() <= 1.5));
    }
}

#[test]
fn a_slit_cylinder_is_glued_and_without_seam_groups_refused() {
    let file = rolled(plane(12, 1.0, TAU * RADIUS));
    let raw = unroll(&file, &liner(None), 1.0).unwrap();
    let defects = Mesh::build(raw).unwrap_err();
    assert!(defects.iter().any(|d| matches!(d, crate::Defect::CoincidentNodes { .. })));
    let mesh = Mesh::build(unroll(&named(file, "seam_low", "seam_high"), &liner(None), 1.0).unwrap()).unwrap();
    assert_eq!(mesh.points().len(), 60);
}

#[test]
fn arcs_are_found_on_plane_and_cylinder() {
    for (from, to) in [(0.5, 2.0), (-3.0, 2.9), (6.0, 7.0), (1.0, 1.0 + TAU)] {
        let width = RADIUS * (to - from);
        for turns in [-1.0, 0.0, 2.0] {
            let x0 = RADIUS * (from + turns * TAU);
            let file = named(plane(12, x0, width), "arc_from", "arc_to");
            for file in [file.clone(), rolled(file)] {
                let raw = unroll(&file, &liner(Some((from, to))), 1.0).unwrap();
                let xs = || raw.points.iter().map(|p| p[0]);
                assert!((xs().fold(f64::INFINITY, f64::min) - RADIUS * from).abs() < 1e-12);
                assert!((xs().fold(f64::NEG_INFINITY, f64::max) - RADIUS * to).abs() < 1e-12);
                let mesh = Mesh::build(raw).unwrap();
                assert!((area(&mesh) - width * LENGTH).abs() < 1e-11);
                assert_eq!(mesh.period(), None);
            }
        }
    }
}

#[test]
fn a_shifted_arc_is_told_by_how_much() {
    let file = named(plane(12, 1.0, 3.0), "arc_from", "arc_to");
    let arc = liner(Some((0.75, 2.25)));
    let Error::Shifted { shift, unit: "m", .. } = unroll(&file, &arc, 1.0).unwrap_err() else {
        panic!("not shifted");
    };
    assert!((shift - 0.5).abs() < 1e-12);
    let Error::Shifted { shift, unit: "deg", .. } = unroll(&rolled(file), &arc, 1.0).unwrap_err() else {
        panic!("not shifted");
    };
    assert!((shift - 0.25f64.to_degrees()).abs() < 1e-9);
}

#[test]
fn sizes_must_be_those_of_the_scene() {
    let refused = |file: &MshFile, arc, unit| unroll(file, &liner(arc), unit).unwrap_err().to_string();
    let arc = named(plane(12, 1.0, 3.0), "arc_from", "arc_to");
    assert!(refused(&arc, Some((0.5, 2.1)), 1.0).contains("the length of the arc"));
    assert!(refused(&rolled(arc.clone()), Some((0.5, 2.1)), 1.0).contains("the angle of the arc"));
    let mut millimetres = rolled(arc.clone());
    millimetres.nodes.iter_mut().flatten().for_each(|x| *x *= 1e3);
    assert!(refused(&millimetres, Some((0.5, 2.0)), 1.0).contains("unit = \"mm\""));
    assert!(refused(&arc, Some((0.5, 2.0)), 1.1).contains("the length (bearing.length) is 3.3"));
    let ring = named(plane(12, 1.0, 12.5), "seam_low", "seam_high");
    assert!(refused(&ring, None, 1.0).contains("the circumference (pi times bearing.diameter) is 12.5"));
    assert!(refused(&rolled(arc.clone()), Some((0.5, 2.0)), 1e-3).contains("unit = \"m\""));
    assert!(refused(&arc, Some((0.5, f64::NAN)), 1.0).contains("the arc"));
    assert!(refused(&arc, Some((0.5, 2.0)), 0.0).contains("the unit"));
}

#[test]
fn all_missing_groups_are_named_at_once() {
    let mut file = plane(12, 0.0, TAU * RADIUS);
    file.surfaces[0].0 = "oil".to_owned();
    file.curves[0].0 = "low end".to_owned();
    let text = unroll(&file, &liner(None), 1.0).unwrap_err().to_string();
    for name in ["\"film\"", "\"end_low\"", "\"seam_low\"", "\"seam_high\"", "surface \"oil\"", "curve \"low end\""] {
        assert!(text.contains(name), "{text}");
    }
    assert!(!text.contains("lacks curve \"end_high\""));
}

#[test]
fn a_half_shell_is_no_ring() {
    let shell = rolled(named(plane(12, 0.0, 0.5 * TAU * RADIUS), "arc_from", "arc_to"));
    let error = unroll(&shell, &liner(None), 1.0).unwrap_err();
    assert!(matches!(error, Error::OpenRing { from, .. } if from == 180.0), "{error}");
    // A groove through the full length leaves the film open too, with a name at its edges.
    let grooved = rolled(named(plane(12, 0.0, 0.9 * TAU * RADIUS), "groove", "groove"));
    assert!(Mesh::build(unroll(&grooved, &liner(None), 1.0).unwrap()).is_ok());
}

#[test]
fn a_seam_that_does_not_fit_is_named_by_nodes() {
    let mut file = named(plane(12, 0.0, TAU * RADIUS), "seam_low", "seam_high");
    file.nodes[62][1] += 0.01;
    let text = unroll(&file, &liner(None), 1.0).unwrap_err().to_string();
    assert!(text.contains("node 3 of \"seam_low\"") && text.contains("node 63 at"), "{text}");
}

#[test]
fn a_seam_of_many_nodes_at_one_place_is_refused_soon() {
    // To compare each with each would be ten thousand million comparisons.
    let mut file = named(plane(12, 0.0, TAU * RADIUS), "seam_low", "seam_high");
    for (curve, x) in [(2, 0.0), (3, TAU * RADIUS)] {
        for _ in 0..100_000 {
            let node = file.nodes.len() as u32;
            file.tags.push(u64::from(node) + 1);
            file.nodes.push([x, 1.0, 0.0]);
            file.triangles.push([node, 0, 1]);
            file.curves[curve].1.push([node, node]);
        }
    }
    let started = std::time::Instant::now();
    let error = unroll(&file, &liner(None), 1.0).unwrap_err();
    assert!(matches!(error, Error::Seam { count: 198_000, .. }), "{error}");
    println!("{:?}", started.elapsed());
}

#[test]
fn swapped_ends_are_refused() {
    let mut file = named(plane(12, 0.0, TAU * RADIUS), "seam_low", "seam_high");
    file.curves.swap(0, 1);
    file.curves[0].0 = "end_low".to_owned();
    file.curves[1].0 = "end_high".to_owned();
    assert!(matches!(unroll(&file, &liner(None), 1.0), Err(Error::Misplaced { group: "end_low", .. })));
}

#[test]
fn mid_nodes_on_chords_are_straight_and_others_bulge() {
    let mut file = rolled(named(plane(12, 0.3, TAU * RADIUS), "seam_low", "seam_high"));
    let mut mid_nodes = Vec::new();
    for triangle in file.triangles.clone() {
        mid_nodes.push([0, 1, 2].map(|k| {
            let [a, b] = [triangle[k], triangle[(k + 1) % 3]].map(|v| file.nodes[v as usize]);
            file.nodes.push(std::array::from_fn(|d| 0.5 * (a[d] + b[d])));
            (file.nodes.len() - 1) as u32
        }));
    }
    file.tags = (1..=file.nodes.len() as u64).collect();
    file.mid_nodes = Some(mid_nodes.clone());
    assert!(unroll(&file, &liner(None), 1.0).unwrap().bulges.is_empty());
    let moved = mid_nodes[7][1];
    file.nodes[moved as usize][1] += 0.01;
    let raw = unroll(&file, &liner(None), 1.0).unwrap();
    assert_eq!(raw.bulges.len(), 1);
    let (7, 1, [x, z]) = raw.bulges[0] else {
        panic!("{:?}", raw.bulges);
    };
    assert!(x.abs() < 1e-15 && (z - 0.01).abs() < 1e-15);
}

#[test]
fn a_mesh_alone_shows_its_liner() {
    let data = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data");
    for (name, loops) in [("plane_ring.msh", 3), ("cylinder_x.msh", 2), ("half_x.msh", 1)] {
        let mesh = read_alone(data.join(name)).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(crate::Quality::of(&mesh).boundary_loops, loops, "{name}");
    }
}

/// Glued, the two corners on the seam of one element around the ring are one node.
#[test]
fn one_element_around_a_ring_is_told_to_be_three() {
    for columns in [1, 2] {
        let file = named(plane(columns, 0.0, TAU * RADIUS), "seam_low", "seam_high");
        let raw = unroll(&file, &liner(None), 1.0);
        let told = match raw.map(crate::Mesh::build) {
            Err(error) => error.to_string(),
            Ok(mesh) => crate::Error::from(mesh.unwrap_err()).to_string(),
        };
        assert!(told.contains("degrees of the ring; use at least three elements around it"), "{told}");
    }
}
