//! The shaft at rest under loads that do not change: all films at once, or each under what statics gives it.

use std::time::Instant;

use oilwedge_bearing::coordinates::Vector;
use oilwedge_bearing::shaft::{Balance, NoBalance};
use oilwedge_reynolds::quantities::load::load;
use oilwedge_scene::ShaftScene;
use rayon::prelude::*;

use super::compile::{Bearing, Compiled, compile_shaft};
use super::error::ShaftError;
use super::result::{BearingReport, ShaftBalances, ShaftResult, ShaftRun, found_with_shaft};
use crate::estimate::estimate_errors;
use crate::isothermal::isothermal;
use crate::no_answer::NoAnswer;
use crate::orbit::{GREATEST, USUAL, suits};
use crate::reasons::Cause;
use crate::result::Status;
use crate::run_options::RunOptions;
use crate::solved::SolveOptions;
use crate::warning::Warning;
use crate::warnings::all_warnings;

/// Meshes are drawn anew for the films that were found at most so many times.
const MESHES: usize = 3;

/// Solves the films of a shaft at rest.
///
/// # Errors
/// The scenes do not become a shaft on films.
pub(super) fn solved(scene: &ShaftScene, options: &RunOptions) -> Result<ShaftRun, ShaftError> {
    let clock = Instant::now();
    let deadline = options.deadline();
    let mut run = ShaftRun::of(scene, options.bars);
    let result = &mut run.result;
    let mut eccentricity = USUAL;
    let mut compiled = compile_shaft(scene, eccentricity)?;
    let mut meshes = 1;
    let found = loop {
        let asked = compiled.steady_load();
        let found = compiled.films().balance(&asked, 0.0, deadline);
        let (Ok(balance), true) = (&found, meshes < MESHES) else {
            break found;
        };
        let at: Vec<Vector> = balance.instants.iter().map(|here| here.at).collect();
        let greatest = (1.0 - compiled.films().thinnest(&at).1).clamp(0.0, GREATEST);
        if suits(eccentricity, greatest) || !compiled.bearings.iter().any(is_graded) {
            break found;
        }
        (eccentricity, meshes) = (greatest, meshes + 1);
        compiled = compile_shaft(scene, eccentricity)?;
    };
    result
        .timing_s
        .push(("balance".to_owned(), clock.elapsed().as_secs_f64()));
    match found {
        Ok(balance) => {
            let clock = Instant::now();
            let outcome = report(&compiled, &balance, options, result);
            if let Err(reason) = outcome {
                (result.status, result.reason) = (Status::without(&reason), Some(reason.to_string()));
            }
            result
                .timing_s
                .push(("measure".to_owned(), clock.elapsed().as_secs_f64()));
        }
        Err(reason) => {
            result.status = match &reason {
                NoBalance::Film(at) if at.reason.is_unreached() => Status::NotConverged,
                NoBalance::Film(_) => Status::NoSolution,
                NoBalance::Stuck { .. } | NoBalance::Ended => Status::NotConverged,
            };
            result.reason = Some(told(&reason, &compiled, options.cause()));
        }
    }
    Ok(run)
}

fn is_graded(bearing: &Bearing) -> bool {
    bearing.film.scene.mesh.is_graded()
}

/// Fills in the numbers of a balance.
fn report(
    compiled: &Compiled,
    balance: &Balance,
    options: &RunOptions,
    result: &mut ShaftResult,
) -> Result<(), NoAnswer> {
    let films = compiled.films();
    let measure = |(number, bearing): (usize, &Bearing)| {
        let here = &balance.instants[number];
        let film = bearing.film.with_journal(here.problem.journal);
        let solve = SolveOptions {
            errors: options.errors(),
            ..SolveOptions::default()
        };
        let solved = isothermal(&film, &solve)?;
        let estimated = estimate_errors(&solved);
        let warnings = all_warnings(&film.scene, &solved, &estimated, options.errors());
        let of_film = &films.films[number];
        let arm = of_film.coordinates.arm;
        let shell = [0, 1, 2, 3].map(|k| of_film.compliance[k] * here.excess[k]);
        let [tilt_x, tilt_y] = film.problem.journal.tilt;
        let report = BearingReport {
            shell: [shell[0].hypot(shell[1]), shell[2].hypot(shell[3]) / arm],
            tilt_max: tilt_x.hypot(tilt_y),
            ..BearingReport::of(bearing, found_with_shaft(estimated.quantities))
        };
        Ok((report, warnings))
    };
    let measured: Result<Vec<(BearingReport, Vec<Warning>)>, NoAnswer> =
        compiled.bearings.par_iter().enumerate().map(measure).collect();
    for (report, warnings) in measured? {
        let named = warnings
            .into_iter()
            .map(|warning| warning.of(&BearingReport::part(&report.name)));
        result.warnings.extend(named);
        result.bearings.push(report);
    }
    result.films = balance.films;
    result.balances = balances(compiled, balance);
    Ok(())
}

/// The balances of the whole shaft, by the loads as they are given and the forces of the films.
fn balances(compiled: &Compiled, balance: &Balance) -> ShaftBalances {
    let (mut force, mut moment, mut scale, mut arm_scale) = ([0.0; 2], [0.0; 2], 0.0, 0.0);
    for load in &compiled.loads {
        let z = compiled.loaded_at[load.place];
        let size = load.force[0].hypot(load.force[1]);
        (scale, arm_scale) = (scale + size, arm_scale + z.abs() * size);
        for k in 0..2 {
            force[k] += load.force[k];
            moment[k] += z * load.force[k];
        }
    }
    for (here, bearing) in balance.instants.iter().zip(&compiled.bearings) {
        let carried = load(&here.problem, &bearing.film.system, &here.film).total.resultant();
        for k in 0..2 {
            force[k] -= carried.force[k];
            moment[k] -= bearing.at * carried.force[k];
            if bearing.coordinates().order == 4 {
                moment[k] -= carried.moment[k];
            }
        }
    }
    let over = |[x, y]: [f64; 2], scale: f64| if scale > 0.0 { x.hypot(y) / scale } else { 0.0 };
    ShaftBalances {
        force: over(force, scale),
        moment: over(moment, arm_scale),
        journals: balance.residual,
        power: 0.0,
    }
}

/// Why there is no balance, with the name of the bearing that is meant, and the way out.
fn told(reason: &NoBalance, compiled: &Compiled, cause: Cause) -> String {
    let name = |bearing: usize| compiled.bearings.get(bearing).map_or("", |bearing| &bearing.name);
    match reason {
        NoBalance::Film(at) => format!("bearing {}: {}", name(at.bearing), at.reason),
        NoBalance::Stuck { bearing, .. } => format!(
            "{reason}, in bearing {}; lower the loads, give that bearing more length, or what holds its shell more stiffness",
            name(*bearing)
        ),
        NoBalance::Ended => cause.ends(&reason.to_string()),
    }
}
