//! What is timed is what it says: the films of the page, the sizes from which floors are told, the gate.

use oilwedge_mesh::{Quality, gmsh};
use oilwedge_tests::performance::films::{Films, Kind, scene};
use oilwedge_tests::performance::floor::Sizes;
use oilwedge_tests::performance::{gate, phases};
use oilwedge_tests::program::repository;

/// The file that stands for one of gmsh holds the mesh that was drawn, in another order.
#[test]
fn the_binary_file_is_the_ring() {
    let films = Films::new();
    let ring = scene(&films.ring(Kind::Linear, 5000));
    let mesh = phases::mesh(&ring);
    let quality = Quality::of(&mesh);
    assert!(
        (0.9..1.1).contains(&(quality.quadratic_nodes as f64 / 5000.0)),
        "{quality:?}"
    );
    assert_eq!(quality.unnamed_boundary_edges, 0);
    assert!(quality.least_angle > 25.0, "{quality:?}");
    // Through the text that the program writes, and back.
    let text = films.folder().join("text.msh");
    gmsh::write(&mesh, &text).expect("a file");
    let path = films.folder().join("text.toml");
    let scene_text = std::fs::read_to_string(films.ring(Kind::Linear, 5000)).expect("our scene");
    std::fs::write(&path, scene_text.replace("5000.msh", "text.msh")).expect("a scene");
    let [binary, text] = [ring, scene(&path)].map(|scene| phases::file_to_load(&scene));
    assert!((binary / text - 1.0).abs() < 1e-9, "{binary} N, {text} N");
}

/// Benches tell floors before there is a mesh: from the sizes to be expected of one.
#[test]
fn expected_sizes_are_those_of_a_ring() {
    let films = Films::new();
    for unknowns in [10_000, 40_000] {
        let ring = scene(&films.ring(Kind::Linear, unknowns));
        let file = std::fs::metadata(films.folder().join(format!("{unknowns}.msh"))).expect("the mesh");
        let mesh = phases::mesh(&ring).into();
        let assembler = phases::number(&mesh);
        let is = Sizes::of(&assembler, &phases::analyse(&assembler), file.len());
        let told = Sizes::expected(is.rows);
        let near = |a: f64, b: f64, within: f64| assert!((a / b - 1.0).abs() < within, "{is:?}\n{told:?}");
        near(told.entries, is.entries, 0.02);
        for k in 0..3 {
            near(told.mesh[k], is.mesh[k], 0.05);
        }
        near(told.file, is.file, 0.05);
        near(told.factor, is.factor, 0.15);
        near(told.factor_flops, is.factor_flops, 0.3);
    }
}

/// The page holds a count to compare with.
#[test]
fn the_gate_has_its_count() {
    let page = std::fs::read_to_string(repository().join("docs/performance.md")).expect("the page");
    let count = gate::recorded(&page).expect("a count");
    assert!((1e6..1e9).contains(&count), "{count}");
}
