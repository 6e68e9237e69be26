//! From a scene to its numbers and fields: what a caller asks, and what it is given.

use std::path::{Path, PathBuf};
use std::time::Instant;

use oilwedge_bearing::{Interrupt, NoEquilibrium, Patience};
use oilwedge_fem::linearisation::Route;
use oilwedge_fem::newton;
use oilwedge_mesh::quality::least_angle_of;
use oilwedge_mesh::{Mesh, Quality, developed, gmsh};
use oilwedge_reynolds::error_bar::UNRESOLVED;

use crate::analysis::{NoAnswer, Solved};
use crate::bars::Judged;
use crate::compile::{CompileError, Study, compile};
use crate::doubts::warnings_beside_bars;
use crate::folder::replace;
use crate::liner_mesh::liner_mesh;
use crate::measure::warnings;
use crate::picture::picture;
use crate::plot::PlotError;
use crate::refinement::{Answer, answer, at_first};
use crate::regime::Regime;
use crate::report::{
    Balances, CHECK_FORMAT, CheckReport, Cost, Counts, HistoryStep, LinearSolver, MeshFacts, RESULT_FORMAT,
    RegionFacts, ReportError, RunResult, Status,
};
use crate::results::WriteError;
use crate::scene::Scene;
use crate::sketch::{sketch, words};
use crate::thermal::{heat_report, left_over};
use crate::vtu::{FilmPicture, PictureError};

/// Degree of the unknown of a film [1].
pub(crate) const DEGREE: usize = 2;
/// What stands for a file name where the liner described is meshed.
const DRAWN: &str = "made of the liner described";
/// What stands there where finer meshes may follow.
const FIRST_DRAWN: &str = "made of the liner described, the first towards the tolerance";
/// Angles below this [deg] are worth a warning.
const SHARP: f64 = 15.0;

/// How a scene is run.
#[derive(Debug, Clone, Copy)]
pub struct RunOptions {
    /// Draw the film on the developed surface (x = R phi, y = z) instead of on the cylinder.
    pub unrolled: bool,
    /// Estimate error bars. Without them a tolerance that the scene does not give itself is dropped.
    pub bars: bool,
    /// The refinement towards a tolerance and the search for a position under a load end after this time [s], infinite for none.
    pub max_seconds: f64,
    /// No mesh of that refinement after the first has more unknowns.
    pub max_unknowns: usize,
    /// Ends them as well.
    pub interrupt: Interrupt,
}

impl RunOptions {
    /// How long a run that begins now may search.
    pub(crate) fn patience(&self) -> Patience {
        Patience::of(self.max_seconds, self.interrupt)
    }
}

impl Default for RunOptions {
    fn default() -> Self {
        Self {
            unrolled: false,
            bars: true,
            max_seconds: 60.0,
            max_unknowns: 1_000_000,
            interrupt: Interrupt::default(),
        }
    }
}

/// What a run found.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// The numbers; its status tells whether there are any.
    pub result: RunResult,
    /// The fields; `None` where there is no solution to draw.
    pub picture: Option<FilmPicture>,
}

/// Why a scene was not run. That a scene has no solution is no error: it is a [`crate::report::Status`].
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The mesh is unreadable, defective, or not that of the scene.
    #[error(transparent)]
    Compile(#[from] CompileError),
    /// The result holds what must not be written.
    #[error(transparent)]
    Report(#[from] ReportError),
    /// The picture does not fit together.
    #[error(transparent)]
    Picture(#[from] PictureError),
    /// The results cannot be written.
    #[error(transparent)]
    Write(#[from] WriteError),
    /// The number whose convergence was asked for is zero.
    #[error(
        "the {goal} of this film is zero, so it has no relative error and nothing converges; give an eccentricity, a feed or a load that is not zero"
    )]
    NothingToConverge {
        /// Name of the quantity.
        goal: String,
    },
    /// The plots cannot be drawn.
    #[error(transparent)]
    Plot(#[from] PlotError),
    /// A sweep has no cases.
    #[error("the sweep has no cases; give each axis below [sweep] a value at least")]
    NoCases,
    /// The folder of a sweep holds another one.
    #[error(
        "{} holds a sweep {why}; choose another folder with --out, or replace it with --fresh",
        folder.display()
    )]
    OtherSweep {
        /// The folder.
        folder: PathBuf,
        /// What is other about it.
        why: &'static str,
    },
    /// Another run writes the sweep in the folder.
    #[error(
        "{} holds a sweep that {} is still writing; wait until it ends, end it, or choose another folder with --out",
        folder.display(),
        process.map_or("another run".to_owned(), |process| format!("process {process}"))
    )]
    BusySweep {
        /// The folder.
        folder: PathBuf,
        /// The process that writes it, where the folder tells.
        process: Option<u64>,
    },
    /// A sweep was asked to end before it had.
    #[error(
        "interrupted: {done} of {cases} cases are in {}; the same command goes on from there",
        table.display()
    )]
    Interrupted {
        /// Cases in the table.
        done: usize,
        /// All cases.
        cases: usize,
        /// The table.
        table: PathBuf,
    },
    /// What an earlier run of a sweep wrote cannot be read.
    #[error("cannot read {}: {source}; choose another folder with --out, or replace it with --fresh", path.display())]
    Earlier {
        /// The file.
        path: PathBuf,
        /// What the system says.
        source: std::io::Error,
    },
    /// Threads cannot be started.
    #[error("cannot start the threads of a sweep: {0}; give fewer with --threads")]
    Threads(String),
}

/// Computes the film of a scene. A film that does not exist or is not reached is a result, with its reason.
///
/// # Errors
/// [`Error::Compile`] where the mesh cannot be read or does not fit the scene.
pub fn run(scene: &Scene, options: &RunOptions) -> Result<Run, Error> {
    let start = Instant::now();
    let Answer {
        mut study,
        outcome,
        levels,
        limit,
    } = answer(scene, options)?;
    let mut result = RunResult {
        format: RESULT_FORMAT.to_owned(),
        title: scene.title.clone(),
        version: env!("CARGO_PKG_VERSION").to_owned(),
        scene_sha256: scene.sha256.clone(),
        mesh_sha256: study.mesh_sha256.clone(),
        status: Status::Converged,
        reason: None,
        effects: study.effects.clone(),
        mesh: facts(study.system.space().mesh()),
        quantities: Vec::new(),
        bars: options.bars,
        levels,
        balances: Balances::default(),
        regime: None,
        heat: None,
        history: Vec::new(),
        counts: Counts::default(),
        linear_solver: None,
        timing_s: (study.seconds.iter())
            .map(|&(part, seconds)| (part.to_owned(), seconds))
            .collect(),
        warnings: Vec::new(),
        cost: None,
        standard: None,
        theories: None,
    };
    let picture = match outcome {
        Ok((solved, judged)) => {
            let indicator = judged.indicator.clone();
            let regime = Regime::of(scene, &study, &judged.measured);
            let broken = regime.warnings(scene, &judged.measured);
            report(&study, &solved, judged, &mut result);
            let clock = Instant::now();
            result.heat = heat_report(&mut study, &solved, &result.quantities, options);
            result.timing_s.extend(
                solved
                    .heat
                    .as_ref()
                    .map(|found| ("heat".to_owned(), found.seconds + clock.elapsed().as_secs_f64())),
            );
            result.regime = Some(regime);
            result.warnings.extend(broken);
            if limit.is_some() {
                result.status = Status::NotConverged;
                result.reason = limit;
            }
            Some(picture(&study, &solved.film, indicator.as_deref(), options.unrolled))
        }
        Err(reason) => {
            match &reason {
                NoAnswer::Film(film) | NoAnswer::Equilibrium(NoEquilibrium::Film(film)) => {
                    result.history = history(film.history());
                }
                NoAnswer::Equilibrium(reason) => {
                    let step = |(step, &residual): (usize, &f64)| HistoryStep {
                        step,
                        residual,
                        active: 0,
                    };
                    result.history = (1..).zip(reason.history()).map(step).collect();
                    result.counts.position_steps = reason.history().len();
                }
                NoAnswer::Heat(_) => {}
            }
            result.status = reason.status();
            result.reason = Some(reason.to_string());
            None
        }
    };
    result
        .timing_s
        .push(("total".to_owned(), start.elapsed().as_secs_f64()));
    Ok(Run { result, picture })
}

fn history(steps: &[newton::HistoryStep]) -> Vec<HistoryStep> {
    (1..)
        .zip(steps)
        .map(|(step, entry)| HistoryStep {
            step,
            residual: entry.residual,
            active: entry.active,
        })
        .collect()
}

/// Fills in what a solved film tells.
fn report(study: &Study, solved: &Solved, judged: Judged, result: &mut RunResult) {
    let film = &solved.film;
    result.quantities = judged.quantities;
    let bare: Vec<&str> = (result.quantities.iter())
        .filter(|quantity| quantity.error.is_none())
        .map(|quantity| quantity.name.as_str())
        .collect();
    result.warnings = match bare.is_empty() {
        true => warnings_beside_bars(study, &judged.measured),
        false => warnings(study, &judged.measured),
    };
    if judged.spread > UNRESOLVED {
        result.warnings.push(format!(
            "the triangles do not follow the flow and spread oil across it, by which numbers may be off by {:.0} %: there are no error bars, and a finer mesh of such triangles is no better; mesh the film in rows along the flow (under [mesh] remove layout = \"file\" or give size, or bring a file whose triangles have an edge along the flow)",
            100.0 * judged.spread
        ));
    } else if result.bars && !bare.is_empty() && !solved.is_ended() {
        let told = "this mesh does not resolve the film well enough for an error bar of";
        let way_out = "give a finer one ([mesh] size or tolerance)";
        result.warnings.push(format!("{told} {}; {way_out}", bare.join(", ")));
    }
    result.balances.mass = judged.measured.flows.imbalance;
    result.balances.power = judged.measured.power.imbalance;
    result.history = history(&film.history);
    result.counts = Counts {
        linear_solves: film.history.len(),
        factorisations: film.history.len(),
        nonlinear_iterations: film.history.len(),
        levels: film.levels,
        bars: match &solved.reference {
            None => 0,
            Some(second) => second.film().history.len(),
        },
        position_steps: solved.balance.map_or(0, |balance| balance.steps),
    };
    result.linear_solver = Some(LinearSolver {
        route: match film.linearisation.route() {
            Route::Direct => "direct",
            Route::Multigrid => "multigrid",
            Route::Switched => "switched",
        },
        steps: film.linearisation.steps(),
    });
    result.balances.heat = left_over(&result.quantities);
    result.balances.force = solved.balance.map_or(0.0, |balance| balance.residual);
    let mut parts = vec![
        ("assemble", film.seconds.assemble),
        ("factorise", film.seconds.factorise),
        ("solve", film.seconds.solve),
        ("measure", judged.seconds),
    ];
    if result.bars {
        parts.push(("bars", solved.judging));
    }
    parts.extend(solved.balance.map(|balance| ("search", balance.seconds)));
    let parts = parts.into_iter().map(|(part, seconds)| (part.to_owned(), seconds));
    result.timing_s.extend(parts);
}

/// Reads the mesh of a scene and tells what would be computed.
///
/// # Errors
/// [`Error::Compile`] where the mesh cannot be read or does not fit the scene.
pub fn check_scene(scene: &Scene) -> Result<CheckReport, Error> {
    let study = compile(&at_first(scene))?;
    let mesh = study.system.space().mesh();
    let drawn = if scene.tolerance.is_some() { FIRST_DRAWN } else { DRAWN };
    let name = scene.mesh.path().unwrap_or(Path::new(drawn));
    let mut report = check_report(name, mesh);
    let pockets: Vec<_> = study.pockets.iter().filter_map(|name| mesh.region(name)).collect();
    report.sketch = sketch(mesh, &study.system.supply, &pockets, scene.bearing.radius());
    report.liner = words(scene);
    report.tolerance = (scene.tolerance.iter())
        .flat_map(|tolerance| &tolerance.targets)
        .map(|target| (target.quantity.clone(), target.relative))
        .collect();
    report.title = Some(scene.title.clone());
    report.sweep = (scene.sweep.iter())
        .flat_map(|plan| &plan.axes)
        .map(|axis| (axis.heading(), axis.values.len()))
        .collect();
    report.effects = Some(study.effects.clone());
    report.warnings.extend(crate::doubts::laid_anew(&study));
    report.warnings.extend(crate::doubts::flips(&study));
    let free = |dof: &usize| study.system.supply.owner(*dof).is_none();
    report.cost = Some(Cost {
        unknowns: (0..study.system.space().dofs()).filter(free).count(),
        factor_entries: study.system.analysis().map_err(CompileError::from)?.factor_entries(),
    });
    Ok(report)
}

/// Reads a mesh file by itself, its lengths in metres; the liner is the one its nodes lie on.
///
/// # Errors
/// [`Error::Compile`] where the mesh cannot be read or is defective.
pub fn check_mesh(path: &Path) -> Result<CheckReport, Error> {
    let mesh = developed::read_alone(path).map_err(CompileError::from)?;
    Ok(check_report(path, &mesh))
}

/// Meshes or reads the liner of a scene.
///
/// # Errors
/// [`Error::Compile`] where the mesh cannot be read or made.
pub fn mesh_scene(scene: &Scene) -> Result<Mesh, Error> {
    Ok(liner_mesh(scene, scene.start())?.mesh)
}

/// Writes a mesh as a gmsh 4.1 file, whole or not at all. Through a link the file is replaced that it leads to; what is no plain file
/// (`/dev/stdout`) is written into.
///
/// # Errors
/// [`Error::Compile`] where the file cannot be written.
pub fn write_mesh(mesh: &Mesh, path: &Path) -> Result<(), Error> {
    let text = gmsh::to_text(mesh);
    let failed = |source| {
        let error = oilwedge_mesh::Error::Io {
            action: "write",
            path: path.to_owned(),
            error: source,
        };
        Error::from(CompileError::from(error))
    };
    let place = path.canonicalize().unwrap_or_else(|_| path.to_owned());
    let folder = match place.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    };
    let (true, Some(name)) = (place.is_file() || !place.exists(), place.file_name()) else {
        return std::fs::write(path, text).map_err(failed);
    };
    if !folder.is_dir() {
        return Err(failed(std::io::ErrorKind::NotFound.into()));
    }
    match replace(folder, &[(name, Some(text.as_bytes()))]) {
        Err(WriteError::System { source, .. }) => Err(failed(source)),
        other => Ok(other?),
    }
}

fn check_report(path: &Path, mesh: &Mesh) -> CheckReport {
    let quality = Quality::of(mesh);
    let mut warnings = Vec::new();
    if quality.least_angle < SHARP {
        warnings.push(format!(
            "the least angle is {:.1} deg; triangles below {SHARP} deg cost accuracy",
            quality.least_angle
        ));
    }
    if quality.unnamed_boundary_edges > 0 {
        warnings.push(format!(
            "{} boundary edges belong to no named curve; a film needs a condition there",
            quality.unnamed_boundary_edges
        ));
    }
    let parts = |name: &str, kind: &str, parts: usize| {
        (parts > 0).then(|| RegionFacts {
            name: name.to_owned(),
            kind: kind.to_owned(),
            parts,
        })
    };
    CheckReport {
        format: CHECK_FORMAT.to_owned(),
        title: None,
        mesh_file: path.display().to_string(),
        effects: None,
        mesh: facts(mesh),
        regions: (mesh.regions().iter())
            .flat_map(|region| {
                let curve = parts(&region.name, "curve", region.edges.len());
                let surface = parts(&region.name, "surface", region.cells.len());
                [curve, surface].into_iter().flatten()
            })
            .collect(),
        quality,
        tolerance: Vec::new(),
        sweep: Vec::new(),
        liner: Vec::new(),
        sketch: String::new(),
        cost: None,
        warnings,
    }
}

fn facts(mesh: &Mesh) -> MeshFacts {
    MeshFacts {
        cells: mesh.triangles().len(),
        nodes: mesh.quadratic_nodes(),
        order: DEGREE,
        min_angle_deg: least_angle_of(mesh),
    }
}
