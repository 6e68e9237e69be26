//! A bearing on several meshes: drawn with several sizes, and refined where its error is.

use std::time::Instant;

use oilwedge_bearing::Deadline;
use oilwedge_fem::marking::doerfler;
use oilwedge_mesh::{Mesh, refine};
use oilwedge_scene::Scene;
use oilwedge_study::analysis::solve;
use oilwedge_study::compile::compile;
use oilwedge_study::compile_error::CompileError;
use oilwedge_study::estimate::{Estimated, estimate_errors};
use oilwedge_study::film::Film;
use oilwedge_study::grading::graded;
use oilwedge_study::liner_mesh::LinerMesh;
use oilwedge_study::solved::{Errors, SolveOptions, Solved};

use super::bearings::Bearing;
use oilwedge_tests::random_bearings::Dice;

/// Share of the indicator that the triangles divided carry.
pub const SHARE: f64 = 0.7;
/// Bounds of the unknowns of meshes drawn.
const UNKNOWNS: [f64; 4] = [150.0, 500.0, 1500.0, 5000.0];

/// How a mesh was made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Drawn with a size, or that of a file.
    Drawn,
    /// Refined where the error of the mesh before was.
    Local,
}

/// A bearing solved on a mesh.
pub struct Solve {
    /// How its mesh was made.
    pub kind: Kind,
    /// The film and its reference film.
    pub solved: Solved,
    /// Numbers and bars of the film.
    pub judged: Estimated,
    /// Unknown pressures.
    pub unknowns: usize,
    /// Seconds of it all.
    pub seconds: f64,
}

impl Solve {
    /// Solves a compiled film.
    ///
    /// # Errors
    /// The reason why there is no film or no position, in words.
    pub fn new(film: &Film, kind: Kind) -> Result<Self, String> {
        let clock = Instant::now();
        let options = SolveOptions { errors: Errors::Estimated, ..SolveOptions::default() };
        let solved = solve(film, &options).map_err(|reason| reason.to_string())?;
        let judged = estimate_errors(&solved);
        Ok(Self { kind, unknowns: film.unknowns(), solved, judged, seconds: clock.elapsed().as_secs_f64() })
    }

    /// The mesh.
    pub fn mesh(&self) -> &Mesh {
        self.solved.film.system.space().mesh()
    }

    /// The scene on another mesh, the journal where it is here.
    ///
    /// # Errors
    /// As [`Self::new`], or the scene does not fit the mesh.
    pub fn on(&self, scene: &Scene, mesh: Mesh) -> Result<Self, String> {
        let film = &self.solved.film;
        let model = compile(scene).map_err(|error| error.to_string())?;
        let state = match film.load() {
            None => model.start(),
            Some(_) => model.state_at(film.position()),
        };
        let film = model.film_on(mesh, &state, 2).map_err(|error| error.to_string())?;
        Self::new(&film, Kind::Local)
    }

    /// The scene on the mesh refined by what its bars tell; everywhere if they tell nothing.
    ///
    /// # Errors
    /// As [`Self::on`], or the mesh cannot be refined.
    pub fn refined(&self, scene: &Scene) -> Result<Self, String> {
        let cells = self.mesh().triangles().len();
        let marked = match &self.judged.indicator {
            Some(indicator) => doerfler(indicator, SHARE),
            None => vec![true; cells],
        };
        let refined = refine::local(self.mesh(), &marked).map_err(|defects| format!("{defects:?}"))?;
        self.on(scene, refined.mesh)
    }
}

/// The scene of a bearing whose mesh has about so many unknowns.
pub fn sized(bearing: &Bearing, wanted: f64) -> Scene {
    if !bearing.is_drawn() {
        return bearing.scene(None);
    }
    let area = |scene: &Scene| {
        let turn = (scene.bearing.arc).map_or(std::f64::consts::TAU, |arc| arc.to - arc.from);
        turn * scene.bearing.radius() * scene.bearing.length
    };
    let first = bearing.scene(None);
    let mut size = (2.0 * area(&first) / (0.433 * wanted)).sqrt();
    for _ in 0..2 {
        let scene = bearing.scene(Some(size));
        let Ok(LinerMesh { mesh, .. }) = compile(&scene).and_then(|model| model.first_mesh()) else {
            break;
        };
        let ratio = 2.0 * mesh.triangles().len() as f64 / wanted;
        size *= ratio.sqrt().clamp(0.3, 3.0);
    }
    bearing.scene(Some(size))
}

/// The film of a scene on a mesh graded for it.
///
/// # Errors
/// The scene does not become a film.
pub fn graded_film(scene: &Scene) -> Result<Film, CompileError> {
    let model = compile(scene)?;
    graded(&model, model.mesh.longest, Deadline::default().into())
}

/// A bearing on all its meshes, coarse first; `Err` tells of meshes without an answer.
pub fn solves(bearing: &Bearing, seed: u64) -> Vec<Result<Solve, String>> {
    let mut dice = Dice::new(seed);
    let compiled = |scene: &Scene| {
        let study = graded_film(scene).map_err(|error| error.to_string())?;
        Solve::new(&study, Kind::Drawn)
    };
    let mut found = Vec::new();
    let mut climb = |scene: &Scene, levels: usize| {
        let mut last = compiled(scene);
        for _ in 0..levels {
            let next = match &last {
                Ok(last) => last.refined(scene),
                Err(_) => break,
            };
            found.push(std::mem::replace(&mut last, next));
        }
        found.push(last);
    };
    if bearing.is_drawn() {
        for (bounds, levels) in UNKNOWNS.windows(2).zip([2, 1, 0]) {
            let wanted = dice.decades(bounds[0].log10(), bounds[1].log10());
            climb(&sized(bearing, wanted), levels);
        }
    } else {
        climb(&bearing.scene(None), 2);
    }
    found
}
