//! The structurally different paths of a run, one function each. What a function needs is made before it is timed.

use std::sync::Arc;

use oilwedge_bearing::{Equilibrium, SearchOptions, find};
use oilwedge_fem::{Analysis, Assembler, Constraints, Factorization, Matrix, Space};
use oilwedge_mesh::Mesh;
use oilwedge_reynolds::SolvedFilm;
use oilwedge_reynolds::quantities::load::load;
use oilwedge_scene::Scene;
use oilwedge_study::compile::compile;
use oilwedge_study::film::Film;
use oilwedge_study::measure::{Measured, measure};
use oilwedge_study::{Run, RunOptions, run};

use super::floor::Sizes;

/// Degree of the elements.
const DEGREE: usize = 2;

/// **Read, mesh.** The mesh of a scene: read from its file, or drawn.
///
/// # Panics
/// If there is none.
pub fn mesh(scene: &Scene) -> Mesh {
    compile(scene).and_then(|model| model.first_mesh()).unwrap_or_else(|error| panic!("{error}")).mesh
}

/// **Number.** Unknowns, pattern of the matrix, and where each element adds to it.
pub fn number(mesh: &Arc<Mesh>) -> Assembler {
    Assembler::new(Space::new(Arc::clone(mesh), DEGREE))
}

/// **Order and analyse.** The elimination order and the pattern of the factor.
///
/// # Panics
/// If it does not fit in memory.
pub fn analyse(assembler: &Assembler) -> Arc<Analysis> {
    let analysis = Analysis::new(assembler.space(), Arc::clone(assembler.pattern()));
    Arc::new(analysis.expect("it fits in memory"))
}

/// Matrix, right-hand side and given pressures of a film.
pub struct Linear {
    /// The matrix.
    pub matrix: Matrix,
    /// The residual at rest.
    pub residual: Vec<f64>,
    /// Given pressures.
    pub constraints: Constraints,
}

impl Linear {
    /// Room for the linear system of a study.
    pub fn of(study: &Film) -> Self {
        Self {
            matrix: Matrix::zero(Arc::clone(study.system.assembler.pattern())),
            residual: Vec::new(),
            constraints: study.system.supply.constraints(|p| study.problem.unknown_at(p)),
        }
    }
}

/// **Assemble.** Matrix and right-hand side of the film at rest.
pub fn assemble(study: &Film, linear: &mut Linear) {
    let at_rest = vec![0.0; study.system.space().dofs()];
    let law = study.problem.law();
    linear.residual = (study.system.assembler).tangent_and_residual(&law, &at_rest, &mut linear.matrix);
}

/// **Factorise.**
///
/// # Panics
/// If the matrix is not positive definite.
pub fn factorise(analysis: &Arc<Analysis>, linear: &Linear) -> Factorization {
    let factor = analysis.factorise(&linear.matrix, &linear.constraints.fixed);
    factor.expect("the matrix is positive definite")
}

/// **Solve.** Back-substitution with the factor.
///
/// # Panics
/// If the solution is not finite.
pub fn substitute(factor: &Factorization, linear: &Linear) -> Vec<f64> {
    let mut x = linear.residual.clone();
    factor.solve(&mut x).expect("a finite solution");
    x
}

/// A scene, ready to be solved: read or drawn, numbered.
///
/// # Panics
/// If it does not fit together.
pub fn study(scene: &Scene) -> Film {
    compile(scene).and_then(|model| model.film()).unwrap_or_else(|error| panic!("{error}"))
}

/// **Film, cavitation.** The film of a study from nothing, by the way that the program chooses, the films on coarser
/// meshes among it.
///
/// # Panics
/// If there is none.
pub fn film(study: &Film) -> SolvedFilm {
    (study.problem.solve(&study.system)).unwrap_or_else(|reason| panic!("{reason}"))
}

/// **Equilibrium.** The position that carries the load of a study.
///
/// # Panics
/// If there is none.
pub fn equilibrium(study: &Film) -> Equilibrium {
    let load = study.load().expect("a load");
    let options = SearchOptions { centre_velocity: study.model.sockets.centre_velocity, ..SearchOptions::default() };
    find(&study.problem, &study.system, load, &options).unwrap_or_else(|reason| panic!("{reason}"))
}

/// **File to load.** Everything from the mesh to the load [N], but for start and output of the program.
pub fn file_to_load(scene: &Scene) -> f64 {
    let study = study(scene);
    let film = film(&study);
    load(&film).magnitude()
}

/// **Measure.** Everything that is reported of a film.
pub fn measured(film: &SolvedFilm) -> Measured {
    measure(film)
}

/// **The run of a scene**, all but its output, with error bars or without.
///
/// # Panics
/// If it cannot be run.
pub fn whole_run(scene: &Scene, bars: bool) -> Run {
    let options = RunOptions { bars, ..RunOptions::default() };
    run(scene, &options).unwrap_or_else(|error| panic!("{error}"))
}

/// The sizes on which the floors of a scene depend.
pub fn sizes(scene: &Scene) -> Sizes {
    let file = scene.mesh.path().and_then(|path| std::fs::metadata(path).ok());
    let assembler = number(&Arc::new(mesh(scene)));
    Sizes::of(&assembler, &analyse(&assembler), file.map_or(0, |file| file.len()))
}
