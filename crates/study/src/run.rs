//! The run of a scene, to its numbers and fields: what a caller asks, and what it is given.

use std::sync::Arc;
use std::time::Instant;

use oilwedge_bearing::NoEquilibrium;
use oilwedge_bearing::orbit::OrbitEnd;
use oilwedge_fem::linearisation::Route;
use oilwedge_fem::newton;
use oilwedge_mesh::Mesh;
use oilwedge_mesh::quality::least_angle_of;
use oilwedge_scene::Scene;
use oilwedge_scene::wording::percent;

use crate::compile::compile;
use crate::compile_error::CompileError;
use crate::effects::Effects;
use crate::estimate::{Estimated, estimate_errors};
use crate::film::{DEGREE, Film};
use crate::limits::design_criteria;
use crate::model::Model;
use crate::no_answer::NoAnswer;
use crate::orbit::{FollowedCycle, Frame, OrbitFacts, OrbitPath, follow_under};
use crate::picture::{FilmPicture, picture};
use crate::quantities::{Quantity, left_over};
use crate::reasons::Limit;
use crate::refinement::{Tell, answer_telling};
use crate::regime::{Regime, broken_assumptions};
use crate::result::{
    Balances, Counts, DynamicsReport, Geometry, HistoryStep, LevelFacts, LinearRoute, LinearSolverFacts, MeshFacts,
    RESULT_FORMAT, ResultHead, ResultTail, RunResult, SECONDS_KEY, Status, TemperatureAcross, TemperatureReport,
};
use crate::run_options::RunOptions;
use crate::solved::Solved;
use crate::thermal::{cycle_temperature_report, temperature_report, work_of};
use crate::warning::{self, Warning};
use crate::warnings::all_warnings;
use oilwedge_bearing::duty_cycle::DutyCycle;

/// What a run found.
#[derive(Debug)]
pub struct Run {
    /// The numbers; its status shows whether there are any.
    pub result: RunResult,
    /// The fields; `None` where there is no solution to draw.
    pub picture: Option<FilmPicture>,
    /// The path of the journal over the last cycle; `None` where no orbit was followed.
    pub orbit: Option<OrbitPath>,
    /// Films of that cycle as they were asked for.
    pub frames: Vec<Frame>,
    /// The film that was solved, for what is asked of it beside; `None` where there is none, and of orbits.
    pub solved: Option<Solved>,
}

/// Computes the film of a scene. A film that does not exist or is not reached is a result, with its reason.
///
/// # Errors
/// [`CompileError`] where the mesh cannot be read or does not fit the scene.
pub fn run(scene: &Scene, options: &RunOptions) -> Result<Run, CompileError> {
    run_telling(&compile(scene)?, options, None)
}

/// Computes the film of a model as [`run`] does. Each time that a mesh is solved which is not the last, `best` is given
/// what the run answers if it ends before the next one is solved.
///
/// # Errors
/// [`CompileError`] where the mesh cannot be read or does not fit the model.
pub fn run_telling(
    model: &Arc<Model>,
    options: &RunOptions,
    best: Option<&dyn Fn(RunResult)>,
) -> Result<Run, CompileError> {
    let clock = Instant::now();
    if let Some(asked) = model.scope.orbit.as_ref().zip(model.duty.as_ref()) {
        let mut run = on_orbit(model, asked, options)?;
        let before = match (&run.orbit, model.sockets.thermal) {
            (Some(_), Some(_)) => SECONDS_KEY,
            (Some(_), None) => "start",
            (None, _) => "orbit",
        };
        add_total(&mut run.result, before, clock.elapsed().as_secs_f64());
        return Ok(run);
    }
    let told = best.map(|best| {
        |found: (&Solved, Estimated), levels: &[LevelFacts], limit: Option<&Limit>| {
            best(result_of(found, levels, limit, options));
        }
    });
    let answer = answer_telling(model, options, told.as_ref().map(|told| told as Tell))?;
    let mut result = without_outcome(&answer.film, &answer.levels, options);
    let (picture, solved) = match answer.outcome {
        Ok((solved, estimated)) => {
            // As large as the film and its picture together.
            solved.primary.solution.linearisation.free_levels();
            let picture = picture(&solved.film, &solved.primary, estimated.indicator.as_deref(), options.picture);
            report((&solved, estimated), options, &mut result);
            (Some(picture), Some(solved))
        }
        Err(reason) => {
            report_reason(&reason, options, &mut result);
            (None, None)
        }
    };
    if let Some(limit) = answer.limit {
        result.head.end(Status::NotConverged, limit);
    }
    add_total(&mut result, "before", clock.elapsed().as_secs_f64());
    Ok(Run { result, picture, orbit: None, frames: Vec::new(), solved })
}

/// The result of a model that is `solved` on the last of some meshes, with the limit that ends it, if one does; what
/// takes a search is left out.
fn result_of(
    (solved, estimated): (&Solved, Estimated),
    levels: &[LevelFacts],
    limit: Option<&Limit>,
    options: &RunOptions,
) -> RunResult {
    let mut result = without_outcome(&solved.film, levels, options);
    report((solved, estimated), &options.limited(Some(0.0)), &mut result);
    if let Some(limit) = limit {
        result.head.end(Status::NotConverged, limit);
    }
    result
}

/// Adds the time of all to the times of a run [s], and names that which no part has: what came `before` them.
fn add_total(result: &mut RunResult, before: &str, total: f64) {
    let named: f64 = result.tail.timing_s.iter().map(|(_, seconds)| seconds).sum();
    let parts = [(before, f64::max(total - named, 0.0)), ("total", total)];
    result.tail.timing_s.extend(parts.map(|(part, seconds)| (part.to_owned(), seconds)));
}

/// Part of the load that turns at half the speed of the journal, above which the film counts as collapsing [1].
const MOST_AT_HALF_SPEED: f64 = 0.5;

/// Follows the journal over cycles.
fn on_orbit(
    model: &Arc<Model>,
    (orbit, duty): (&oilwedge_scene::OrbitTable, &DutyCycle),
    options: &RunOptions,
) -> Result<Run, CompileError> {
    let (film, outcome) = follow_under(model, (orbit, duty), options)?;
    let mut result = without_outcome(&film, &[], options);
    let followed = match outcome {
        Ok(followed) => followed,
        Err(reason) => {
            report_reason(&reason, options, &mut result);
            return Ok(Run { result, picture: None, orbit: None, frames: Vec::new(), solved: None });
        }
    };
    let FollowedCycle { solved, facts, .. } = followed;
    let estimated = estimate_errors(&solved);
    let picture = picture(&solved.film, &solved.primary, estimated.indicator.as_deref(), options.picture);
    let films = facts.cycles.iter().map(|cycle| cycle.films).sum();
    let (half_speed, turns) = (facts.half_speed_share, model.scope.speed != 0.0);
    let limit = match followed.end {
        OrbitEnd::Closed => None,
        OrbitEnd::NotClosed if half_speed > MOST_AT_HALF_SPEED => {
            let reason = if turns { Limit::Collapse } else { Limit::Sinking };
            Some(reason(facts.cycles.len(), closure(&facts), half_speed))
        }
        OrbitEnd::NotClosed if orbit.mass > 0.0 && !contracts(&facts) => {
            Some(Limit::Whirl(facts.cycles.len(), closure(&facts), orbit.mass))
        }
        OrbitEnd::NotClosed => Some(Limit::NotClosed(facts.cycles.len(), closure(&facts))),
        OrbitEnd::Ended => Some(Limit::Orbit(facts.cycles.len(), closure(&facts), options.cause())),
    };
    // Bars of a film that conserves its oil are those of its orbit.
    let of_film = RunOptions { bars: options.bars && solved.reference.is_some(), ..*options };
    report((&solved, estimated), &of_film, &mut result);
    if half_speed > MOST_AT_HALF_SPEED {
        let share = percent(half_speed);
        result.tail.warnings.push(warning::HALF_SPEED.says(match turns {
            true => format!(
                "{share} of the load turns at half the speed of the journal: there the film has no wedge and carries by squeeze alone, and the least film falls from cycle to cycle"
            ),
            false => format!(
                "the journal does not turn, and {share} of the load keeps its direction: the film carries it by squeeze alone, and the least film falls from cycle to cycle"
            ),
        }));
    }
    result.quantities = followed.quantities;
    result.tail.warnings.extend(of_history(&solved, &result.quantities, (options, followed.are_bars_ended)));
    if let Some(found) = &followed.temperature {
        let report = cycle_temperature_report(&solved.film, &found.model, &result.quantities, options);
        result.temperature = report.map(|report| TemperatureReport {
            broken_assumptions: broken_assumptions(&result.tail.warnings),
            ..report
        });
    }
    result.criteria = match &result.temperature {
        Some(report) => report.criteria.clone(),
        None => design_criteria(&solved.film, None, &result.quantities, options.bars),
    };
    let oil = facts.cycles.last().and_then(|cycle| cycle.oil_imbalance);
    result.counts.position_steps = films;
    result.balances.force = followed.residual;
    result.balances.mass = oil.unwrap_or(followed.balances.mass);
    result.balances.energy = followed.balances.energy;
    result.balances.thermal = followed.temperature.map_or(left_over(&result.quantities), |found| found.left_over);
    result.counts.temperature_steps = followed.temperature.map_or(0, |found| found.steps);
    let [integrate, measure] = followed.seconds;
    result.tail.timing_s.retain(|(part, _)| film.seconds.iter().any(|(other, _)| other == part));
    result.tail.took("orbit", integrate);
    result.tail.took("measure", measure);
    result.orbit = Some(facts);
    if let Some(limit) = limit {
        result.head.end(Status::NotConverged, limit);
    }
    Ok(Run { result, picture: Some(picture), orbit: Some(followed.path), frames: followed.frames, solved: None })
}

/// Warnings about an orbit whose film conserves its oil.
fn of_history(
    solved: &Solved,
    quantities: &[Quantity],
    (options, are_bars_ended): (&RunOptions, bool),
) -> Vec<Warning> {
    let mut warnings = Vec::new();
    let film = &solved.film;
    if let Some([angle, z]) = film.problem.place_without_supply(&film.system) {
        warnings.push(warning::FROM_START.says(format!(
            "no oil is supplied to the film near {:.0} deg, z = {:.4} m: what it holds there follows from the start of the orbit, at which the film is full",
            angle.to_degrees(),
            z
        )));
    }
    let is_judged = quantities.iter().all(|quantity| quantity.bar.is_some());
    if options.bars && film.problem.storage.is_some() && !is_judged {
        let of_vertices = "the orbit on the vertices of the mesh, by which they are found,";
        warnings.push(warning::NO_BAR.says(match are_bars_ended {
            true => {
                let ended = options.cause().ends(&format!("{of_vertices} was ended"));
                format!("there are no error bars: {ended}")
            }
            false => format!(
                "there are no error bars: {of_vertices} did not come to its end; give a finer mesh ([mesh] size)"
            ),
        }));
    }
    warnings
}

/// Closure of the last cycle, over the clearance.
fn closure(facts: &OrbitFacts) -> f64 {
    facts.cycles.last().map_or(0.0, |cycle| cycle.closure)
}

/// Whether cycles end nearer to where they began than those two before.
fn contracts(facts: &OrbitFacts) -> bool {
    match facts.cycles[..] {
        [.., before, _, last] => last.closure < before.closure,
        _ => true,
    }
}

/// What is known of a run whatever its outcome.
fn without_outcome(film: &Film, levels: &[LevelFacts], options: &RunOptions) -> RunResult {
    let Model { description, effects, .. } = &*film.model;
    RunResult {
        head: ResultHead {
            mesh_sha256: Some(film.origin.sha256.clone()),
            ..ResultHead::of(RESULT_FORMAT, [&description.title, &description.text, &description.sha256])
        },
        effects: Effects::of(effects),
        geometry: Geometry::of(&film.model),
        mesh: facts(film.system.space().mesh()),
        bars: options.bars,
        levels: levels.to_vec(),
        tail: ResultTail {
            timing_s: (film.seconds.iter()).map(|&(part, seconds)| (part.to_owned(), seconds)).collect(),
            warnings: Vec::new(),
        },
        ..RunResult::default()
    }
}

/// Fills in why there is no film.
fn report_reason(reason: &NoAnswer, options: &RunOptions, result: &mut RunResult) {
    match reason {
        NoAnswer::Film(film) | NoAnswer::Equilibrium(NoEquilibrium::Film(film)) => {
            result.history = history(film.history());
        }
        NoAnswer::Equilibrium(reason) => {
            let step = |(step, &residual): (usize, &f64)| HistoryStep { step, residual, active: 0 };
            result.history = (1..).zip(reason.history()).map(step).collect();
            result.counts.position_steps = reason.history().len();
        }
        NoAnswer::Orbit(_) | NoAnswer::Temperature(_) | NoAnswer::NotBegun { .. } => {}
    }
    result.head.end(Status::without(reason), reason.told(options.cause()));
}

fn history(steps: &[newton::NewtonStep]) -> Vec<HistoryStep> {
    let step = |(step, entry): (usize, &newton::NewtonStep)| HistoryStep {
        step,
        residual: entry.residual,
        active: entry.active,
    };
    (1..).zip(steps).map(step).collect()
}

/// Fills in the numbers of a solved film.
fn report((solved, estimated): (&Solved, Estimated), options: &RunOptions, result: &mut RunResult) {
    let oil = &solved.film.model.oil;
    result.tail.warnings = all_warnings(oil, solved, &estimated, options.errors());
    result.regime = Some(Regime::of(oil, &solved.film, &estimated.measured));
    result.history = history(&solved.primary.solution.history);
    result.counts = counts(solved);
    result.linear_solver = Some(LinearSolverFacts {
        route: match solved.primary.solution.linearisation.route() {
            Route::Direct => LinearRoute::Direct,
            Route::Multigrid => LinearRoute::Multigrid,
            Route::Switched => LinearRoute::Switched,
        },
        steps: solved.primary.solution.linearisation.steps(),
    });
    result.balances = Balances {
        mass: estimated.measured.flows.imbalance,
        power: estimated.measured.power.imbalance,
        moment: estimated.measured.power.moment_imbalance,
        force: solved.balance.map_or(0.0, |balance| balance.parts[0]),
        tilt: solved.balance.map_or(0.0, |balance| balance.parts[1]),
        deflection: solved.film.problem.deflection().map(|deflection| deflection.closing.residual),
        thermal: left_over(&estimated.quantities),
        energy: None,
    };
    result.dynamics = DynamicsReport::of(&solved.film, &estimated.measured);
    let length = solved.film.problem.bearing.length;
    result.temperature_across = solved.film.heat.as_ref().map(|heat| TemperatureAcross::hottest(heat, length));
    let clock = Instant::now();
    result.temperature = temperature_report(solved, &estimated.quantities, options);
    if let Some(report) = &mut result.temperature {
        report.broken_assumptions = broken_assumptions(&result.tail.warnings);
    }
    result.criteria = match &result.temperature {
        Some(report) => report.criteria.clone(),
        None => design_criteria(&solved.film, None, &estimated.quantities, options.bars),
    };
    let curve = clock.elapsed().as_secs_f64();
    let parts = solved.primary.solution.seconds;
    let parts = [
        Some(("assemble", parts.assemble)),
        Some(("factorise", parts.factorise)),
        Some(("solve", parts.solve)),
        Some(("measure", estimated.seconds)),
        options.bars.then_some(("bars", solved.reference_seconds)),
        solved.balance.map(|balance| ("search", balance.seconds)),
        (solved.temperature.as_ref()).map(|found| (SECONDS_KEY, found.seconds + curve)),
    ];
    let parts = parts.into_iter().flatten();
    result.tail.timing_s.extend(parts.map(|(part, seconds)| (part.to_owned(), seconds)));
    result.of_hill = estimated.of_hill;
    result.quantities = estimated.quantities;
}

fn counts(solved: &Solved) -> Counts {
    let work = solved.temperature.as_ref().map_or_else(|| work_of(solved), |found| found.work);
    let closing = solved.film.problem.deflection().map(|deflection| deflection.closing);
    Counts {
        linear_solves: work.linear_solves,
        factorisations: work.factorisations,
        films: work.films,
        nonlinear_iterations: solved.primary.solution.history.len(),
        levels: solved.primary.solution.levels,
        bars: (solved.reference.as_ref()).map_or(0, |reference| reference.film().solution.history.len()),
        position_steps: match &solved.temperature {
            Some(found) => found.positions,
            None => solved.balance.map_or(0, |balance| balance.steps),
        },
        temperature_steps: match (&solved.film.heat, &solved.temperature) {
            (Some(heat), _) => heat.changes.len(),
            (None, found) => found.as_ref().map_or(0, |found| found.balanced.films),
        },
        deflection_steps: closing.map(|closing| closing.outer),
        deflection_products: closing.map(|closing| closing.inner),
    }
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
