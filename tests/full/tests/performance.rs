//! What is timed is what it says: the films of the page, and the sizes from which floors are told.

use oilwedge_full::performance::films::{Films, Kind, scene};
use oilwedge_full::performance::floor::Path;
use oilwedge_full::performance::gate::{Count, compiler, counted, judged, of_profile, recorded, scenes};
use oilwedge_full::performance::phases;
use oilwedge_mesh::{Quality, gmsh};
use oilwedge_tests::left_out::{is_left_out, missing_for_counting};
use oilwedge_tests::program::{oilwedge_command, repository};

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

/// Four scenes cost what the page records for this compiler and its settings, to a hundredth.
#[test]
fn scenes_cost_no_more_instructions_than_recorded() {
    if is_left_out("the gate", &missing_for_counting()) {
        return;
    }
    let page = std::fs::read_to_string(repository().join("docs/performance.md")).expect("a page");
    let (films, program) = (Films::new(), oilwedge_command());
    for (scene, film) in scenes(&films) {
        let Some(before) = recorded(&page, scene) else {
            eprintln!("no count of {scene} is recorded for {}", compiler());
            continue;
        };
        let count = counted(program.get_program().as_ref(), &film).expect("valgrind");
        let (told, is_open) = judged(scene, &count, &before);
        assert!(is_open, "{told}");
    }
}

/// A count is read from a profile, and one that grows is told with the functions that grew.
#[test]
fn functions_that_grew_are_told() {
    let text = "version: 1\ncmd: 1 2\nfn=quick\n0 700\ncfn=slow\ncalls=1 0\n0 300\n0 100\n\nfn=slow\n0 200\n";
    let before = of_profile(text);
    assert_eq!((before.total, &before.functions["quick"], &before.functions["slow"]), (1000.0, &800.0, &200.0));
    let after = of_profile(&text.replace("0 200", "0 230"));
    let (told, is_open) = judged("a scene", &after, &before);
    assert!(!is_open && told.contains("+3.00 %") && told.ends_with("+30 after 200: slow"), "{told}");
    let (told, is_open) = judged("a scene", &Count { total: 1009.0, ..before.clone() }, &before);
    assert!(is_open && !told.contains("slow"), "{told}");
}
