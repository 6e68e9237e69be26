//! The number of iterations does not grow with the mesh.

use oilwedge_full::cavitation_counts::{count, drawn, imported};
use oilwedge_reynolds::Cavitation;
use oilwedge_study::film::Film;

/// Most iterations on the finest mesh.
fn few(study: &Film, least_levels: usize) {
    for (cavitation, most) in [
        (Cavitation::Reynolds { pressure: 0.0 }, 12),
        (Cavitation::Jfo { pressure: 0.0 }, 18),
    ] {
        let row = count(study, cavitation);
        assert!(
            row.iterations <= most,
            "{} at {} unknowns",
            row.iterations,
            row.unknowns
        );
        assert!(row.levels >= least_levels && row.fallbacks == 0);
    }
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
