//! What is timed is what it says: the films of the page, and the sizes from which floors are told.

use oilwedge_full::performance::films::{Films, Kind, scene};
use oilwedge_full::performance::floor::Path;
use oilwedge_full::performance::phases;
use oilwedge_mesh::{Quality, gmsh};

/// The file that stands for one of gmsh holds the mesh that was drawn, in another order.
#[test]
fn the_binary_file_is_the_ring() {
    let films = Films::new();
    let ring = scene(&films.ring(Kind::Linear, 5000));
    let mesh = phases::mesh(&ring);
    let quality = Quality::of(&mesh);
    assert!((0.9..1.1).contains(&(quality.quadratic_nodes as f64 / 5000.0)), "{quality:?}");
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

/// Floors are those of what is there: sizes of a mesh whose numbers are known by heart, and their bytes.
#[test]
fn sizes_are_those_of_a_ring() {
    let films = Films::new();
    let sizes = phases::sizes(&scene(&films.ring(Kind::Linear, 10_000)));
    let [vertices, edges, triangles] = sizes.mesh;
    // Euler: a ring with a hole has the characteristic -1.
    assert_eq!(vertices - edges + triangles, -1.0);
    assert_eq!(sizes.rows, vertices + edges);
    // A vertex meets itself, its neighbours, their edges and the opposite ones; an edge inside nine nodes.
    assert!((11.0..11.6).contains(&(sizes.entries / sizes.rows)), "{sizes:?}");
    // The factor holds the lower half of the matrix and its fill; Cauchy and Schwarz bound its operations.
    assert!(sizes.factor > 0.5 * (sizes.entries + sizes.rows));
    assert!(sizes.factor_flops > sizes.factor * sizes.factor / sizes.rows);
    let [bytes, operations] = sizes.work(Path::Substitute);
    assert_eq!([bytes, operations], [16.0 * sizes.factor + 32.0 * sizes.rows, 4.0 * sizes.factor]);
    let whole = sizes.work(Path::FileToLoad)[0];
    let parts: f64 = [Path::Read, Path::Number, Path::Assemble].map(|path| sizes.work(path)[0]).iter().sum();
    assert_eq!(whole, parts + 12.0 * sizes.entries);
}
