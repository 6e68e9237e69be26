//! The number of iterations does not grow with the mesh.

use std::sync::Arc;

use oilwedge_mesh::refine;
use oilwedge_reynolds::supply::SupplyRegion;
use oilwedge_reynolds::{Cavitation, FilmProblem, FilmSystem};
use oilwedge_study::compile::compile;
use oilwedge_study::film::Film;
use oilwedge_tests::scenes::{table, variant};

/// Most iterations on the finest mesh.
fn few(study: &Film, least_levels: usize) {
    for (cavitation, most) in [(Cavitation::Reynolds { pressure: 0.0 }, 12), (Cavitation::Jfo { pressure: 0.0 }, 18)] {
        let problem = FilmProblem { cavitation, ..study.problem.clone() };
        let film = problem.solve(&study.system).unwrap_or_else(|reason| panic!("{reason}"));
        let iterations = film.solution.history.len();
        assert!(iterations <= most, "{iterations} at {} unknowns", film.solution.unknown.len());
        assert!(film.solution.levels >= least_levels && film.solution.fallbacks.is_empty());
    }
}

/// The bearing with an axial groove and two holes of scene 10, drawn with some `unknowns`.
fn drawn(unknowns: f64) -> Film {
    let area = std::f64::consts::TAU * 0.0375 * 0.075;
    // Two unknowns a triangle; near rims and the narrowest film there are some more.
    let size = (2.0 * area / (0.433 * unknowns)).sqrt();
    study("10_drawn_liner", |scene| {
        table(scene, "mesh").insert("size".into(), format!("{size} m").into());
    })
}

/// Scene 07, the same bearing with its mesh from a file, refined uniformly so often.
fn imported(times: usize) -> Film {
    let mut study = study("07_grooved_liner", |_| {});
    for _ in 0..times {
        refined(&mut study);
    }
    study
}

fn study(name: &str, edit: impl FnOnce(&mut toml::Table)) -> Film {
    let scene = variant(name, |scene| {
        table(scene, "cavitation").insert("model".into(), "jfo".into());
        edit(scene);
    });
    compile(&scene).and_then(|model| model.film()).unwrap_or_else(|error| panic!("{error}"))
}

fn refined(study: &mut Film) {
    let finer = refine::uniform(study.system.space().mesh()).expect("a mesh that was sound");
    let regions: Vec<SupplyRegion> = (study.system.supply.regions().iter())
        .map(|region| {
            let same = finer.mesh.region(&region.name).expect("refinement keeps groups");
            SupplyRegion { edges: same.edges.clone(), cells: same.cells.clone(), ..region.clone() }
        })
        .collect();
    let system = FilmSystem::new(Arc::new(finer.mesh), 2, regions).expect("refinement keeps the boundary");
    study.system = Arc::new(system.with_coarser(&study.problem, oilwedge_reynolds::levels::LevelLayout::Rows));
}

#[test]
fn on_drawn_meshes() {
    for (unknowns, least_levels) in [(1e3, 1), (1e4, 2), (4e4, 3)] {
        few(&drawn(unknowns), least_levels);
    }
}

#[test]
fn on_an_imported_mesh_and_its_refinements() {
    for times in 0..2 {
        few(&imported(times), 1 + times);
    }
}
