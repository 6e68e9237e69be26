//! Files as gmsh writes them (tests/data, made by make.py there): all of one liner of radius 1 and
//! length 2, read in every form that is served, and refused with a way out in the others.

use std::f64::consts::{PI, TAU};
use std::path::PathBuf;

use oilwedge_mesh::{Circle, LinerDomain, Locator, Mesh, Quality, developed, gmsh, rim};

fn data(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(name)
}

fn liner(arc: Option<(f64, f64)>) -> LinerDomain {
    LinerDomain { radius: 1.0, length: 2.0, arc }
}

fn ring(name: &str) -> Mesh {
    developed::read(data(name), &liner(None), 1.0).unwrap_or_else(|error| panic!("{error}"))
}

const HOLE: Circle = Circle { centre: [3.0, 0.2], radius: 0.4 };

fn same(a: &Mesh, b: &Mesh, tolerance: f64) {
    assert_eq!(a.triangles(), b.triangles());
    assert_eq!(a.regions(), b.regions());
    for (p, q) in a.points().iter().zip(b.points()) {
        assert!((p[0] - q[0]).abs().max((p[1] - q[1]).abs()) <= tolerance);
    }
    for edge in 0..a.topology().edges.len() as u32 {
        let (p, q) = (a.bulge(edge), b.bulge(edge));
        assert!((p[0] - q[0]).abs().max((p[1] - q[1]).abs()) <= tolerance.max(1e-15));
    }
}

#[test]
fn text_and_binary_and_any_tags_give_one_mesh() {
    let mesh = ring("plane_ring.msh");
    let quality = Quality::of(&mesh);
    assert_eq!((quality.boundary_loops, quality.unnamed_boundary_edges), (3, 0));
    assert_eq!(mesh.region("oil hole").unwrap().edges.len(), quality.curved_cells);
    for other in ["plane_ring_binary.msh", "plane_ring_shuffled.msh", "plane_ring_sparse.msh"] {
        same(&mesh, &ring(other), 1e-15);
    }
}

#[test]
fn a_round_rim_is_made_of_parabolas_on_the_circle() {
    let (curved, straight) = (ring("plane_ring.msh"), ring("plane_ring_straight.msh"));
    let bent = rim::curve_rim(&straight, "oil hole", &HOLE).unwrap();
    // A parabola over a chord of half angle a holds 2/3 of the rectangle over it.
    let edges = straight.region("oil hole").unwrap().edges.len() as f64;
    let a = PI / edges;
    let polygon = edges * 0.16 * a.sin() * a.cos();
    let parabolas = edges * 4.0 / 3.0 * 0.16 * a.sin() * (1.0 - a.cos());
    let hole = |mesh: &Mesh| 2.0 * TAU - Quality::of(mesh).area;
    assert!((hole(&straight) - polygon).abs() < 1e-12);
    assert!((hole(&bent) - polygon - parabolas).abs() < 1e-12);
    assert!((hole(&curved) - polygon - parabolas).abs() < 1e-12);
    assert!((polygon - PI * 0.16).abs() > 30.0 * (polygon + parabolas - PI * 0.16).abs());
    // gmsh places nodes along a circle to some 1e-9 of its radius.
    same(&rim::curve_rim(&curved, "oil hole", &HOLE).unwrap(), &curved, 1e-8);

    let wrong = Circle { radius: 0.41, ..HOLE };
    let text = rim::curve_rim(&straight, "oil hole", &wrong).unwrap_err().to_string();
    assert!(text.contains("radius 0.400000000") && text.contains("\"oil hole\""), "{text}");
    assert!(rim::curve_rim(&straight, "hole", &HOLE).unwrap_err().to_string().contains("oil hole"));
}

#[test]
fn closed_cylinders_along_each_axis_give_one_ring() {
    for axis in ["x", "y", "z"] {
        let mesh = ring(&format!("cylinder_{axis}.msh"));
        let quality = Quality::of(&mesh);
        assert!((quality.area - 2.0 * TAU).abs() < 1e-12);
        assert_eq!((quality.boundary_loops, quality.curved_cells), (2, 0));
        // The scene's ring counts the angle as the file does.
        let locator = Locator::new(&mesh);
        let file = gmsh::read(data(&format!("cylinder_{axis}.msh"))).unwrap();
        let k = ["x", "y", "z"].iter().position(|a| *a == axis).unwrap();
        let centre = [5.0, -3.0, 7.0];
        for v in 0..mesh.points().len() as u32 {
            let node = file.nodes[file.tags.iter().position(|&tag| tag == mesh.label(v)).unwrap()];
            let away = |d: usize| node[(k + d) % 3] - centre[(k + d) % 3];
            let point = [away(2).atan2(away(1)), away(0)];
            let (triangle, _) = locator.find(point).unwrap();
            assert!(mesh.triangles()[triangle].contains(&v));
        }
    }
}

#[test]
fn half_a_cylinder() {
    let arc = (PI / 6.0, 7.0 * PI / 6.0);
    let mesh = developed::read(data("half_x.msh"), &liner(Some(arc)), 1.0).unwrap();
    let quality = Quality::of(&mesh);
    assert!((quality.area - TAU).abs() < 1e-12);
    assert_eq!((quality.boundary_loops, quality.unnamed_boundary_edges), (1, 0));
    let turned = (PI / 6.0 + 0.1, 7.0 * PI / 6.0 + 0.1);
    let text = developed::read(data("half_x.msh"), &liner(Some(turned)), 1.0).unwrap_err().to_string();
    assert!(text.contains("half_x.msh") && text.contains("shift the mesh by 5.7295779"), "{text}");
    let text = developed::read(data("half_x.msh"), &liner(None), 1.0).unwrap_err().to_string();
    assert!(text.contains("open from 210."), "{text}");
}

#[test]
fn other_files_are_refused_with_a_way_out() {
    for (name, way_out) in [
        ("old_1.msh", "$MeshFormat"),
        ("old_2.2.msh", "-format msh41"),
        ("old_4.msh", "Mesh.MshFileVersion = 4.1"),
        ("partitioned.msh", "Unpartition"),
        ("quads.msh", "quadrangles (gmsh type 3)"),
        ("cubic.msh", "Mesh.ElementOrder"),
        ("volume.msh", "gmsh -2"),
        ("make.py", "not a gmsh mesh file"),
        ("absent.msh", "cannot read"),
    ] {
        let text = gmsh::read(data(name)).unwrap_err().to_string();
        assert!(text.contains(way_out) && text.contains(name), "{name}: {text}");
    }
}

/// Editors on Windows put a byte order mark before a text; parametric coordinates are passed over.
#[test]
fn marks_and_parametric_coordinates_are_passed_over() {
    let bytes = std::fs::read(data("plane_ring.msh")).unwrap();
    let marked = [&b"\xef\xbb\xbf"[..], &bytes].concat();
    assert_eq!(gmsh::parse(&marked).unwrap(), gmsh::parse(&bytes).unwrap());
    let wide = gmsh::parse(b"\xff\xfe$\0M\0").unwrap_err().to_string();
    assert!(wide.contains("UTF-16"), "{wide}");
    let file = gmsh::read(data("parametric.msh")).unwrap();
    let corners: Vec<[f64; 3]> = file.nodes[..4].to_vec();
    assert_eq!(corners, [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]]);
    assert!(file.nodes.iter().all(|node| node[2] == 0.0 && node[..2].iter().all(|x| (0.0..=1.0).contains(x))));
}

#[test]
fn what_is_written_reads_back() {
    let circle = Circle { centre: [3.0 + TAU, 0.2], ..HOLE };
    let bent = rim::curve_rim(&ring("plane_ring_straight.msh"), "oil hole", &circle).unwrap();
    for mesh in [ring("plane_ring.msh"), bent, ring("cylinder_y.msh")] {
        let text = gmsh::to_text(&mesh);
        let file = gmsh::parse(text.as_bytes()).unwrap();
        let raw = developed::unroll(&file, &liner(None), 1.0).unwrap();
        let back = Mesh::build(raw).unwrap();
        assert_eq!(back.points(), mesh.points());
        if mesh.region("seam_low").is_some() {
            same(&back, &mesh, 0.0);
        }
        assert_eq!(gmsh::to_text(&back), text);
    }
    let arc = liner(Some((PI / 6.0, 7.0 * PI / 6.0)));
    let mesh = developed::read(data("half_x.msh"), &arc, 1.0).unwrap();
    let file = gmsh::parse(gmsh::to_text(&mesh).as_bytes()).unwrap();
    same(&Mesh::build(developed::unroll(&file, &arc, 1.0).unwrap()).unwrap(), &mesh, 0.0);
}
