//! From a scene to its numbers and fields: what a caller asks, and what it is given.

use std::time::Instant;

use oilwedge_bearing::{Deadline, Interrupt, NoEquilibrium};
use oilwedge_fem::linearisation::Route;
use oilwedge_fem::newton;
use oilwedge_mesh::Mesh;
use oilwedge_mesh::quality::least_angle_of;
use oilwedge_reynolds::error_bar::UNRESOLVED;
use oilwedge_scene::Scene;

use crate::analysis::{NoAnswer, Solved};
use crate::compile::{CompileError, Study};
use crate::estimate::Estimated;
use crate::picture::{FilmPicture, picture};
use crate::refinement::{Answer, answer};
use crate::regime::Regime;
use crate::result::{Balances, Counts, HistoryStep, LinearSolver, MeshFacts, RESULT_FORMAT, RunResult, Status};
use crate::thermal::{heat_report, left_over};
use crate::warnings::{warnings, warnings_beside_bars};

/// Degree of the unknown of a film [1].
pub const DEGREE: usize = 2;
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
    pub fn deadline(&self) -> Deadline {
        Deadline::after(self.max_seconds, self.interrupt)
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

/// Computes the film of a scene. A film that does not exist or is not reached is a result, with its reason.
///
/// # Errors
/// [`CompileError`] where the mesh cannot be read or does not fit the scene.
pub fn run(scene: &Scene, options: &RunOptions) -> Result<Run, CompileError> {
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
fn report(study: &Study, solved: &Solved, judged: Estimated, result: &mut RunResult) {
    let film = &solved.film;
    result.quantities = judged.quantities;
    let bare: Vec<&str> = (result.quantities.iter())
        .filter(|quantity| quantity.bar.is_none())
        .map(|quantity| &*quantity.name)
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

/// Facts about a mesh.
pub fn facts(mesh: &Mesh) -> MeshFacts {
    MeshFacts {
        cells: mesh.triangles().len(),
        nodes: mesh.quadratic_nodes(),
        order: DEGREE,
        min_angle_deg: least_angle_of(mesh),
    }
}
