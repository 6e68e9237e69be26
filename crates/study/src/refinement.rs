//! Solve, estimate, mark, refine: from mesh to mesh until every bar is as small as the scene asks.
//!
//! A smooth film is refined everywhere: a mesh drawn here is drawn anew, as fine as the law of the bar,
//! `bar ~ unknowns^-s`, says that it must be; that of a file is divided. Where the error comes from the edge of a cavity
//! the triangles are divided that carry most of it.
//!
//! Source: Doerfler, SIAM J. Numer. Anal. 33 (1996) 1106; s measured, `docs/theory/error_estimation.md`.

use std::time::Instant;

use oilwedge_bearing::Deadline;

use crate::analysis::{NoAnswer, Solved, graded, solve};
use crate::checks::targets;
use crate::compile::{CompileError, Study};
use crate::effects::Sockets;
use crate::estimate::{Estimated, estimate_errors};
use crate::measure::possible_load;
use crate::quantities::{ECCENTRICITY, Quantity, Unit};
use crate::result::{LevelFacts, Refinement};
use crate::run::RunOptions;
use oilwedge_scene::{Scene, Target};

mod next;

use next::Next;
pub use next::at_first;

/// A mesh is drawn for bars this much smaller than asked for,
const SAFETY: f64 = 0.7;
/// with at least and at most this many times the unknowns of the one before.
const GROWTH: [f64; 2] = [1.4, 16.0];
/// A mesh that was drawn finer and has not this many times the unknowns is bound by its features.
const BOUND: f64 = 1.25;
/// Local division that leaves this part of a bar did not serve it.
const STUCK: f64 = 0.8;
/// Growth where no bar can be trusted yet.
const UNRESOLVED_GROWTH: f64 = 3.0;
/// Seconds of a level grow like this power of the unknowns at most.
const TIME_EXPONENT: f64 = 1.2;
/// Tolerances of what is less than this part of what it could be count against that part: loads against those that the pressures
/// could carry, the eccentricity against the clearance.
const LEAST: f64 = 1e-3;
/// Heat left over beyond this part of the friction is no balance.
const UNBALANCED: f64 = 1e-6;
/// Most meshes.
const MOST_LEVELS: usize = 30;

/// A scene answered.
pub struct Answer {
    /// The scene on the last mesh.
    pub study: Study,
    /// The film there, or why there is none.
    pub outcome: Result<(Solved, Estimated), NoAnswer>,
    /// The meshes on the way to a tolerance.
    pub levels: Vec<LevelFacts>,
    /// Why a tolerance is not met or a load not balanced: a limit, or an interrupt.
    pub limit: Option<String>,
}

/// Answers a scene, on meshes as fine as its tolerance asks for if errors are estimated.
///
/// # Errors
/// The scene does not become a film.
pub fn answer(scene: &Scene, options: &RunOptions) -> Result<Answer, CompileError> {
    let warmed = crate::thermal::warmed(scene, options.deadline())?;
    let scene = warmed.as_ref().unwrap_or(scene);
    let Some(targets) = targets(scene).filter(|_| options.bars) else {
        let deadline = options.deadline();
        let mut study = graded(scene, deadline)?;
        let outcome = solved(&mut study, options.bars, deadline);
        let limit = outcome.as_ref().ok().and_then(|(solved, _)| ended(solved, options));
        return Ok(Answer {
            study,
            outcome,
            levels: Vec::new(),
            limit,
        });
    };
    towards(scene, &targets, options)
}

/// Why a position under a load, or a temperature, is only that which the search had reached, if so.
pub fn ended(solved: &Solved, options: &RunOptions) -> Option<String> {
    if let Some(found) = solved
        .heat
        .as_ref()
        .filter(|found| !found.is_ended && found.left_over() > UNBALANCED)
    {
        return Some(format!(
            "not converged: the film jumps as its temperature changes, and friction and heat carried off still differ by {:.1e} of the friction; give another mesh ([mesh] size)",
            found.left_over()
        ));
    }
    let of_heat = solved.heat.as_ref().filter(|found| found.is_ended);
    let of_position = solved.balance.filter(|balance| balance.is_ended);
    let reached = match (of_heat, of_position) {
        (Some(found), _) => format!(
            "the temperature was ended where friction and heat carried off differ by {:.1e} of the friction",
            found.left_over()
        ),
        (None, Some(balance)) => format!(
            "the position was ended where force and load differ by {:.1e} of the load",
            balance.residual
        ),
        (None, None) => return None,
    };
    let (what, way_out) = match options.interrupt.is_asked() {
        true => ("interrupted", ""),
        false => ("limit", "; give --max-seconds a higher limit"),
    };
    Some(format!("{what}: the search for {reached}{way_out}"))
}

fn solved(study: &mut Study, bars: bool, deadline: Deadline) -> Result<(Solved, Estimated), NoAnswer> {
    let solved = solve(study, bars, deadline)?;
    let judged = estimate_errors(study, &solved);
    Ok((solved, judged))
}

/// Unknown pressures of a study.
pub fn unknowns(study: &Study) -> usize {
    let system = &study.system;
    (0..system.space().dofs())
        .filter(|&dof| system.supply.owner(dof).is_none())
        .count()
}

fn towards(scene: &Scene, targets: &[Target], options: &RunOptions) -> Result<Answer, CompileError> {
    let clock = Instant::now();
    let deadline = options.deadline();
    let mut next = Next::first(scene);
    let mut levels: Vec<LevelFacts> = Vec::new();
    let mut best: Option<Best> = None;
    let mut is_laid_anew = false;
    loop {
        let start = Instant::now();
        let (refinement, mut study) = match (next.study(scene, deadline), best.take()) {
            (Ok(made), before) => {
                best = before;
                made
            }
            (Err(reason), Some(best)) => return Ok(last_resort(best, levels, &reason)),
            (Err(reason), None) => return Err(reason),
        };
        // What a mesh was made of is known of those divided from it too.
        is_laid_anew |= study.is_laid_anew;
        study.is_laid_anew = is_laid_anew;
        let outcome = solved(&mut study, true, deadline);
        if let Err(reason) = &outcome
            && reason.is_near_limit()
            && may_divide(&study, deadline, options)
            && let Some(finer) = Next::divided(scene, &study)
        {
            // A finer mesh tells whether there is a film.
            next = finer;
            continue;
        }
        let (solved, judged) = match (outcome, best.take()) {
            // A load balanced on the mesh before is better than one that is not balanced on this one.
            (Ok((solved, _)), Some(best)) if solved.is_ended() => {
                let limit = stopped(&levels, clock.elapsed().as_secs_f64(), best.worst, options);
                return Ok(best.answer(levels, limit));
            }
            (Ok(found), before) => {
                best = before;
                found
            }
            // The numbers of the mesh before are still good.
            (Err(reason), Some(best)) if reason.is_unreached() => return Ok(last_resort(best, levels, &reason)),
            (Err(reason), before) => {
                // The first mesh is coarse; what it cannot answer one as fine as usual may.
                if let (Some(finer), None) = (next.finer_first(scene), before) {
                    next = finer;
                    continue;
                }
                return Ok(Answer {
                    study,
                    outcome: Err(reason),
                    levels,
                    limit: None,
                });
            }
        };
        let size = unknowns(&study);
        levels.push(LevelFacts {
            unknowns: size,
            cells: study.system.space().mesh().triangles().len(),
            refinement,
            errors: (targets.iter())
                .filter_map(|target| {
                    let quantity = judged
                        .quantities
                        .iter()
                        .find(|quantity| quantity.name == target.quantity)?;
                    Some((target.quantity.clone(), quantity.error()?))
                })
                .collect(),
            seconds: start.elapsed().as_secs_f64(),
        });
        let (worst, name) = worst(
            &judged.quantities,
            targets,
            possible_load(&study.problem, &judged.measured),
        );
        let bound =
            matches!(&levels[..], [.., before, last] if (last.unknowns as f64) < BOUND * before.unknowns as f64);
        let stuck = is_stuck(&levels, name);
        let limit_of_search = ended(&solved, options);
        let finer = match worst <= 1.0 {
            _ if limit_of_search.is_some() => Err(limit_of_search),
            true => Err(None),
            false => {
                let left = options.max_seconds - clock.elapsed().as_secs_f64();
                let growth = within(growth(scene, worst), levels.last(), left, options.max_unknowns);
                Next::refined(scene, &next, &study, &judged, growth, [bound, stuck])
                    .map_err(Some)
                    .and_then(|next| {
                        let growth = next.growth(&study).unwrap_or(growth);
                        match limit(&levels, clock.elapsed().as_secs_f64(), growth, worst, options) {
                            None => Ok(next),
                            limit => Err(limit),
                        }
                    })
            }
        };
        next = match (finer, best.take()) {
            (Ok(finer), _) => {
                best = Some(Best {
                    study,
                    solved,
                    judged,
                    worst,
                });
                finer
            }
            // A mesh that resolves less than the one before, as may happen at the edge of a cavity.
            (Err(Some(limit)), Some(before)) if before.worst < worst => {
                let limit = format!("{limit}; told is the mesh before: {}", away(before.worst));
                return Ok(before.answer(levels, limit));
            }
            (Err(limit), _) => {
                return Ok(Answer {
                    study,
                    outcome: Ok((solved, judged)),
                    levels,
                    limit,
                });
            }
        };
    }
}

/// A film on the way to a tolerance.
struct Best {
    study: Study,
    solved: Solved,
    judged: Estimated,
    /// Its greatest bar over what it may be.
    worst: f64,
}

impl Best {
    /// It is the answer, for a limit.
    fn answer(self, levels: Vec<LevelFacts>, limit: String) -> Answer {
        Answer {
            study: self.study,
            outcome: Ok((self.solved, self.judged)),
            levels,
            limit: Some(limit),
        }
    }
}

/// The mesh before is the answer where the next has none.
fn last_resort(best: Best, levels: Vec<LevelFacts>, reason: &dyn std::fmt::Display) -> Answer {
    let limit = format!("limit: the bars are wider than asked for, and the next mesh has no answer: {reason}");
    best.answer(levels, limit)
}

/// True where dividing triangles locally, for the load, hardly narrowed the bar of this name.
fn is_stuck(levels: &[LevelFacts], name: &str) -> bool {
    let error = |level: &LevelFacts| Some(level.errors.iter().find(|(other, _)| other == name)?.1);
    match levels {
        [.., before, last] if last.refinement == Refinement::Local => error(before)
            .zip(error(last))
            .is_some_and(|(before, last)| last > STUCK * before),
        _ => false,
    }
}

/// The greatest bar over what it may be, and of which quantity; infinite where one is missing. A quantity that this film does not
/// have is met. `possible` is the load [N] that its pressures could carry.
fn worst<'a>(quantities: &[Quantity], targets: &'a [Target], possible: f64) -> (f64, &'a str) {
    let ratio = |target: &Target| {
        let Some(quantity) = quantities.iter().find(|quantity| quantity.name == target.quantity) else {
            return 0.0;
        };
        let size = match quantity.row.unit {
            Unit::Degree => 1f64.to_degrees(),
            Unit::Newton => quantity.value.abs().max(LEAST * possible),
            _ if quantity.row == &ECCENTRICITY => quantity.value.abs().max(LEAST),
            _ => quantity.value.abs(),
        };
        let Some(error) = quantity.error() else {
            return f64::INFINITY;
        };
        match error {
            0.0 => 0.0,
            _ => error / (target.relative * size),
        }
    };
    (targets.iter())
        .map(|target| (ratio(target), target.quantity.as_str()))
        .fold((0.0, ""), |worst, next| if next.0 > worst.0 { next } else { worst })
}

/// How many times the unknowns the next mesh needs.
fn growth(scene: &Scene, worst: f64) -> f64 {
    let [least, most] = GROWTH;
    match worst.is_finite() {
        true => (worst / SAFETY)
            .powf(1.0 / Sockets::of(scene).cavitation.convergence_order())
            .clamp(least, most),
        false => UNRESOLVED_GROWTH,
    }
}

/// The growth, or less where that would be too long for the time left [s] or too large: a smaller step is better than none.
fn within(growth: f64, last: Option<&LevelFacts>, left: f64, max_unknowns: usize) -> f64 {
    let Some(last) = last else {
        return growth;
    };
    let in_time = (left / last.seconds).max(0.0).powf(1.0 / TIME_EXPONENT);
    let in_size = max_unknowns as f64 / last.unknowns as f64;
    let fits = (SAFETY * in_time).min(in_size);
    match fits >= GROWTH[0] {
        true => growth.min(fits),
        false => growth,
    }
}

/// How far the tolerance is.
fn away(worst: f64) -> String {
    match worst.is_finite() {
        true => format!(
            "the bars are {} times as wide as asked for",
            oilwedge_scene::wording::factor(worst)
        ),
        false => "the mesh does not resolve the film yet".to_owned(),
    }
}

/// Why the mesh after the last of `levels` was not finished.
fn stopped(levels: &[LevelFacts], elapsed: f64, worst: f64, options: &RunOptions) -> String {
    let unknowns = levels.last().map_or(0, |level| level.unknowns);
    let away = format!("{} on {unknowns} unknowns", away(worst));
    match options.interrupt.is_asked() {
        true => format!("interrupted: {away}"),
        false => format!(
            "limit: {away}, and the next mesh was not finished after {elapsed:.1} s; give --max-seconds a higher limit, or a wider tolerance"
        ),
    }
}

/// Why there must not be another mesh, if so.
fn limit(levels: &[LevelFacts], elapsed: f64, growth: f64, worst: f64, options: &RunOptions) -> Option<String> {
    let last = levels.last()?;
    let wanted = growth * last.unknowns as f64;
    let away = away(worst);
    if options.interrupt.is_asked() {
        return Some(stopped(levels, elapsed, worst, options));
    }
    let seconds = last.seconds * growth.powf(TIME_EXPONENT);
    if wanted > options.max_unknowns as f64 {
        return Some(format!(
            "limit: {away} on {} unknowns, and the next mesh would need some {wanted:.0}, more than {}; give --max-unknowns a higher limit, or a wider tolerance",
            last.unknowns, options.max_unknowns
        ));
    }
    if elapsed + seconds > options.max_seconds {
        return Some(format!(
            "limit: {away} after {elapsed:.1} s, and the next mesh would take some {seconds:.1} s, beyond {:.1} s in all; give --max-seconds a higher limit, or a wider tolerance",
            options.max_seconds
        ));
    }
    (levels.len() >= MOST_LEVELS).then(|| format!("limit: {away} after {MOST_LEVELS} meshes; give a wider tolerance"))
}

/// Whether the mesh of a study may be divided uniformly within the limits of a run.
fn may_divide(study: &Study, deadline: Deadline, options: &RunOptions) -> bool {
    !deadline.is_over() && 4 * unknowns(study) <= options.max_unknowns
}
