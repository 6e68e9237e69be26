//! Files made to cost time, memory or a terminal full of text: refused by a short message.

use std::fmt::Write;

use oilwedge_mesh::{Defect, Error, Mesh, RawMesh, developed, gmsh};

/// A file of one triangle with these sections for names, entities and elements.
fn file(names: &str, entities: &str, elements: &str) -> String {
    format!(
        "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n{names}$Entities\n{entities}\n$EndEntities\n\
         $Nodes\n1 3 1 3\n2 1 0 3\n1\n2\n3\n0 0 0\n1 0 0\n0 1 0\n$EndNodes\n\
         $Elements\n{elements}\n$EndElements\n"
    )
}

const SURFACE: &str = "0 0 1 0\n1 0 0 0 1 1 0 1 1 0";
const TRIANGLE: &str = "1 1 1 1\n2 1 2 1\n1 1 2 3";

/// What is said of a file; never much.
fn told(text: impl AsRef<[u8]>) -> String {
    let error = gmsh::parse(text.as_ref()).and_then(|file| developed::alone(&file));
    let told = error.expect_err("no liner").to_string();
    assert!(told.len() < 2000, "{} bytes are told", told.len());
    told
}

#[test]
fn an_element_is_in_few_groups() {
    // Every line in every group: the square of the file's size.
    let tags = "7 ".repeat(100_000);
    let entities = format!("0 0 1 0\n1 0 0 0 1 1 0 100000 {tags}0");
    assert!(told(file("", &entities, TRIANGLE)).contains("100000 physical groups of one entity, more than 8"));
    // The same group twice is one group.
    let twice = file("", "0 0 1 0\n1 0 0 0 1 1 0 3 7 7 -7 0", TRIANGLE);
    let read = gmsh::parse(twice.as_bytes()).expect("a mesh");
    assert_eq!(read.surfaces, [("surface 7".to_owned(), vec![0])]);
}

#[test]
fn names_are_short() {
    let names = |name: &str| format!("$PhysicalNames\n1\n2 1 \"{name}\"\n$EndPhysicalNames\n");
    let good = file(&names(&"\u{e4}".repeat(127)), SURFACE, TRIANGLE);
    assert!(gmsh::parse(good.as_bytes()).is_ok());
    let long = "x".repeat(1_000_000);
    let words = ["begins with \"xxxxxxxxxxxxxxxxxxxx\"", "more than 127 letters"];
    for word in words {
        assert!(told(file(&names(&long), SURFACE, TRIANGLE)).contains(word));
    }
    let broken = names(&long).replace('"', "");
    assert!(told(file(&broken, SURFACE, TRIANGLE)).contains("is not: dimension, tag and quoted name"));
    let section = format!("${long}\n$End{long}\n");
    assert!(told(file(&section, SURFACE, TRIANGLE)).contains("the name of this section is too long"));
    let unclosed = [b"$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$".to_vec(), vec![0xff; 100], b"\n".to_vec()].concat();
    assert!(told(unclosed).contains("follows"));
    assert!(told(format!("$MeshFormat\n{long} 0 8\n$EndMeshFormat\n")).contains("the gmsh format xxx"));
    assert!(told(format!("${long}")).contains("not a gmsh mesh file"));
}

#[test]
fn of_many_groups_some_are_told() {
    let (mut names, mut entities) = (String::new(), String::new());
    let mut elements = String::new();
    for tag in 1..=1000 {
        let _ = writeln!(names, "2 {tag} \"group number {tag}\"");
        let _ = writeln!(entities, "{tag} 0 0 0 1 1 0 1 {tag} 0");
        let _ = writeln!(elements, "2 {tag} 2 1\n{tag} 1 2 3");
    }
    let names = format!("$PhysicalNames\n1000\n{names}$EndPhysicalNames\n");
    let text = file(&names, &format!("0 0 1000 0\n{entities}"), &format!("1000 1000 1 1000\n{elements}"));
    assert!(told(text).contains("surface \"group number 20\" and 980 more"));
}

#[test]
fn defects_are_counted_to_a_thousand() {
    let mut raw = RawMesh {
        points: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]],
        triangles: vec![[0, 0, 1]; 100_000],
        ..RawMesh::default()
    };
    // The two vertices are crowded too.
    assert_eq!(Mesh::build(raw.clone()).unwrap_err().len(), 1002);
    raw.triangles = vec![[0, 1, 2]];
    raw.curves = vec![("x".repeat(100), vec![[1, 1]; 100_000])];
    let defects = Mesh::build(raw.clone()).unwrap_err();
    assert_eq!(defects.len(), 1000);
    assert!(Error::from(defects).to_string().ends_with("and 992 more at least"));
    raw.points = vec![[f64::NAN, 0.0]; 100_000];
    assert_eq!(Mesh::build(raw).unwrap_err().len(), 1000);
}

#[test]
fn a_vertex_of_a_thousand_triangles_is_refused() {
    // Edges are sought one after the other at a vertex: this would take the square of the number of triangles.
    let fan = |count: u32| {
        let angle = |k: u32| std::f64::consts::TAU * f64::from(k) / f64::from(count);
        let rim = (0..count).map(|k| [angle(k).cos(), angle(k).sin()]);
        RawMesh {
            points: std::iter::once([0.0, 0.0]).chain(rim).collect(),
            triangles: (0..count).map(|k| [0, 1 + k, 1 + (k + 1) % count]).collect(),
            ..RawMesh::default()
        }
    };
    assert!(Mesh::build(fan(1000)).is_ok());
    let defects = Mesh::build(fan(200_000)).unwrap_err();
    assert!(matches!(defects[..], [Defect::CrowdedNode { node: 1, triangles: 200_000, .. }]));
    assert!(defects[0].to_string().contains("200000 triangles share node 1, more than 1000"));
}

#[test]
fn a_large_file_that_is_no_mesh_is_not_read() {
    let folder = std::env::temp_dir().join(format!("oilwedge-sparse-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    let path = folder.join("sparse.msh");
    let sparse = std::fs::File::create(&path).and_then(|file| file.set_len(1 << 40));
    // A file system without holes in files has no room for this.
    if sparse.is_ok() {
        let told = gmsh::read(&path).expect_err("no mesh").to_string();
        assert!(told.contains("sparse.msh") && told.contains("not a gmsh mesh file"), "{told}");
        std::fs::write(&path, "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n").expect("a file");
        let grown = std::fs::OpenOptions::new().write(true).open(&path);
        grown.and_then(|file| file.set_len(1 << 50)).unwrap_or_default();
        let told = gmsh::read(&path).expect_err("no mesh").to_string();
        assert!(told.contains("sparse.msh"), "{told}");
    }
    std::fs::remove_dir_all(&folder).expect("the folder goes");
}
