//! The page `docs/howto/mesh.md`: gmsh's meshes and ours side by side.

use oilwedge_mesh::Quality;

use crate::tables::{replace, row};
use oilwedge_tests::scenes::{Solved, solve, table, variant};

/// A film on a mesh of gmsh, and the load [N] to which it converges (`size` 0.35 mm and 0.5 mm, 4e5 nodes).
pub const CASES: [(&str, &str, f64); 2] = [
    ("hole-fed shell", "02_flexpde_shell", 11509.8283),
    ("liner with groove and holes", "07_grooved_liner", 32928.1158),
];

/// Sizes [mm] of our meshes, the coarser about as large as the mesh of gmsh.
pub const SIZES: [[f64; 2]; 2] = [[2.9, 2.0], [6.0, 4.0]];

/// The film of a shipped scene on a mesh of its geometry made here.
///
/// # Panics
/// If it has no solution.
pub fn own(scene: &str, size: f64) -> Solved {
    let scene = variant(scene, |scene| {
        table(scene, "mesh").insert("size".into(), format!("{size} mm").into());
    });
    solve(&scene).unwrap_or_else(|reason| panic!("{reason}"))
}

/// The film of a shipped scene on its mesh of gmsh.
///
/// # Panics
/// If it has no solution.
pub fn given(scene: &str) -> Solved {
    solve(&variant(scene, |_| ())).unwrap_or_else(|reason| panic!("{scene}: {reason}"))
}

/// Relative error of the load, and that times the square of the number of nodes.
pub fn error_and_merit(solved: &Solved, converged: f64) -> (f64, f64) {
    let error = (solved.quantity("load") / converged - 1.0).abs();
    let nodes = solved.study.system.space().dofs() as f64;
    (error, error * nodes * nodes)
}

/// The page with its table computed anew.
pub fn page(page: &str) -> String {
    let mut rows = vec![row(["film", "mesh", "nodes", "least angle [deg]", "load [N]", "error", "merit"])];
    for ((title, scene, converged), sizes) in CASES.iter().zip(SIZES) {
        let gmsh = given(scene);
        let merit = error_and_merit(&gmsh, *converged).1;
        let mut line = |mesh: String, solved: &Solved| {
            let quality = Quality::of(solved.study.system.space().mesh());
            let (error, own_merit) = error_and_merit(solved, *converged);
            rows.push(vec![
                (*title).to_owned(),
                mesh,
                quality.quadratic_nodes.to_string(),
                format!("{:.0}", quality.least_angle),
                format!("{:.2}", solved.quantity("load")),
                format!("{error:.1e}"),
                format!("{:.1}", own_merit / merit),
            ]);
        };
        line("gmsh".to_owned(), &gmsh);
        for size in sizes {
            line(format!("made here, size = \"{size} mm\""), &own(scene, size));
        }
    }
    replace(page, "meshes", &rows)
}
