//! The pages that are made of scenes are up to date, and meshes made here are as good as others.

use oilwedge_full::crate_arrows::DRAWING;
use oilwedge_full::docs_images::{IMAGES, images};
use oilwedge_full::{cavitation_page, crankshafts_page, flexpde_page, mesh_page};
use oilwedge_tests::program::repository;

#[test]
fn own_meshes_are_no_worse_than_those_of_gmsh() {
    // Error at equal unknowns: 0.9 of gmsh's on the shell, 1.24 on the liner with a groove.
    let limits = [1.2, 1.25];
    for (((_, scene, converged), sizes), limit) in mesh_page::CASES.iter().zip(mesh_page::SIZES).zip(limits) {
        let merit = mesh_page::error_and_merit(&mesh_page::given(scene), *converged).1;
        let (_, own) = mesh_page::error_and_merit(&mesh_page::own(scene, sizes[0]), *converged);
        assert!(own < limit * merit, "{scene}: {}", own / merit);
    }
    // The study's size, 1245 nodes, with the hole cut out: at equal unknowns no worse.
    let (_, _, converged) = mesh_page::CASES[0];
    let (_, merit) = mesh_page::error_and_merit(&mesh_page::given("08_flexpde_study_size"), converged);
    let own = mesh_page::own("02_flexpde_shell", 8.0);
    assert!(own.study.system.space().dofs() < 1300);
    assert!(mesh_page::error_and_merit(&own, converged).1 < merit);
}

#[track_caller]
fn up_to_date(name: &str, page: fn(&str) -> String) {
    let path = oilwedge_tests::program::repository().join("docs").join(name);
    let written = std::fs::read_to_string(path).expect("page");
    assert!(written == page(&written), "run: cargo run --release -p oilwedge-full -- validation");
}

#[test]
fn the_page_of_meshes_is_up_to_date() {
    up_to_date("howto/mesh.md", mesh_page::page);
}

#[test]
fn the_page_of_the_flexpde_study_is_up_to_date() {
    up_to_date("validation/flexpde_study.md", flexpde_page::page);
}

#[test]
fn the_page_of_cavitation_is_up_to_date() {
    up_to_date("theory/cavitation.md", cavitation_page::page);
}

/// The tables of the page that take seconds are up to date; its orbits are tested by `shaft/cycle.rs`.
#[test]
fn the_page_of_crankshafts_is_up_to_date() {
    up_to_date("validation/crankshafts.md", crankshafts_page::at_rest);
}

/// All but the places on the sheet, which other machines may round otherwise.
fn words(svg: &str) -> String {
    svg.split(" d=\"")
        .enumerate()
        .map(|(k, part)| if k == 0 { part } else { part.split_once('"').map_or("", |(_, rest)| rest) })
        .collect()
}

#[test]
fn the_images_of_the_documentation_are_up_to_date() {
    let folder = repository().join("docs/images");
    for (file, svg) in images() {
        let written = std::fs::read_to_string(folder.join(&file)).unwrap_or_default();
        assert!(words(&written) == words(&svg), "{file}: run cargo run --release -p oilwedge-full -- validation");
    }
    let files = std::fs::read_dir(&folder).expect("docs/images").map(|entry| entry.expect("an entry").path());
    let drawing = repository().join(DRAWING);
    let files = files.filter(|path| path.is_file() && *path != drawing).count();
    assert_eq!(files, IMAGES.len(), "an image that no scene gives");
}
