//! The shaft at rest under loads that do not change: all films at once, or each under what statics gives it.

use std::time::Instant as Clock;

use oilwedge_bearing::Work;
use oilwedge_bearing::coordinates::{Vector, length, moved};
use oilwedge_bearing::orbit::Instant;
use oilwedge_bearing::shaft::{Films, NoBalance, NoFilmAt, ShaftEquilibrium};
use oilwedge_reynolds::quantities::load::{Resultant, load};
use oilwedge_scene::ShaftScene;
use rayon::prelude::*;

use super::compile::{Compiled, CompiledBearing, compile_shaft};
use super::deflection::ShaftDeflection;
use super::error::ShaftError;
use super::result::{BearingReport, ShaftBalances, ShaftResult, ShaftRun};
use super::temperatures::{BearingNumbers, NoShaftAnswer, Temperatures};
use crate::estimate::{Displacement, Estimated, estimate_errors};
use crate::isothermal::isothermal;
use crate::measure::measure;
use crate::no_answer::NoAnswer;
use crate::orbit::{GREATEST, USUAL, suits};
use crate::quantities::{self, View};
use crate::reasons::Cause;
use crate::result::Status;
use crate::run_options::RunOptions;
use crate::solved::{Errors, SolveOptions, Solved, TemperatureFound};
use crate::thermal::flows::{thermal_flows, thermal_flows_of};
use crate::warnings::all_warnings;

/// Meshes are drawn anew for the films that were found at most so many times.
const MESHES: usize = 3;
/// Greatest difference of loads and of what the films that are reported carry, over the loads.
const BALANCED: f64 = 1e-9;
/// Heat that a film leaves over at the temperature found, as a part of its power.
const TEMPERATURE_FOUND: f64 = 1e-8;
/// Most balances of the shaft until that difference is met.
const MOST_BALANCES: usize = 20;

/// Solves the films of a shaft at rest.
///
/// # Errors
/// The scenes do not become a shaft on films.
pub(super) fn solved(scene: &ShaftScene, options: &RunOptions) -> Result<ShaftRun, ShaftError> {
    let clock = Clock::now();
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
        let (_, least) = compiled.films().thinnest(balance.instants.iter().map(Instant::under_wall));
        let greatest = (1.0 - least).clamp(0.0, GREATEST);
        if suits(eccentricity, greatest) || !compiled.bearings.iter().any(is_graded) {
            break found;
        }
        (eccentricity, meshes) = (greatest, meshes + 1);
        compiled = compiled.meshed_for(eccentricity)?;
    };
    let mut temperatures = Temperatures::of(&compiled);
    let found = found.map_err(|reason| without(&reason, &compiled, options.cause()));
    let found = found.and_then(|found| at_temperatures(&compiled, &mut temperatures, found, options));
    result.tail.took("balance", clock.elapsed().as_secs_f64());
    let clock = Clock::now();
    let compiled = temperatures.applied(&compiled);
    let outcome = found.and_then(|balance| report((&compiled, &temperatures), balance, options, result));
    if let Err((status, reason)) = outcome {
        result.head.end(status, reason);
    }
    result.tail.took("measure", clock.elapsed().as_secs_f64());
    Ok(run)
}

/// The balance at the temperatures that balance the heat of all films, from one that was found at other temperatures.
fn at_temperatures(
    compiled: &Compiled,
    temperatures: &mut Temperatures,
    found: ShaftEquilibrium,
    options: &RunOptions,
) -> Result<ShaftEquilibrium, NoShaftAnswer> {
    if temperatures.are_given() {
        return Ok(found);
    }
    let deadline = options.deadline();
    let asked = compiled.steady_load();
    let none = vec![[0.0; 4]; asked.len()];
    let mut balance = found;
    let mut films = balance.films;
    let mut balanced = |at: &Compiled, near: &ShaftEquilibrium| {
        let next = at.films().rebalanced(&asked, 0.0, near, &none);
        let next = next.map_err(|reason| without(&reason, at, options.cause()))?;
        films += next.films;
        Ok::<_, NoShaftAnswer>(next)
    };
    let is_over = || deadline.is_over();
    temperatures.balance(compiled, TEMPERATURE_FOUND, is_over, |at| {
        balance = balanced(at, &balance)?;
        Ok(shown(at, &balance))
    })?;
    if options.bars {
        temperatures.show_slopes(compiled, |at| Ok(shown(at, &balanced(at, &balance)?)));
    }
    Ok(ShaftEquilibrium { films, ..balance })
}

/// What the quadratic films of a balance show.
fn shown(at: &Compiled, balance: &ShaftEquilibrium) -> Vec<BearingNumbers> {
    let of_film = |(bearing, here): (&CompiledBearing, &Instant)| {
        let film = bearing.film.with_journal(here.film.problem.journal);
        let measured = measure(&here.film);
        let flows = film.model.sockets.thermal.map(|model| thermal_flows(&model, &film, &measured));
        (flows, quantities::measured(&View::new(&film, &here.film.problem, &measured)))
    };
    at.bearings.iter().zip(&balance.instants).map(of_film).collect()
}

/// Why there is no answer.
fn without(reason: &NoBalance, compiled: &Compiled, cause: Cause) -> NoShaftAnswer {
    let status = match reason {
        NoBalance::Film(at) if !at.reason.is_unreached() => Status::NoSolution,
        NoBalance::Film(_) | NoBalance::Stuck { .. } | NoBalance::Ended => Status::NotConverged,
    };
    (status, told(reason, compiled, cause))
}

fn is_graded(bearing: &CompiledBearing) -> bool {
    bearing.film.model.mesh.is_graded()
}

/// The films of a balance, solved with those by which errors are estimated.
struct Reported {
    /// The balance of the films that are reported.
    balance: ShaftEquilibrium,
    /// The films.
    solved: Vec<Solved>,
    /// What they carry [N].
    carried: Vec<Resultant>,
    /// What they carry more than the films of the balance [N].
    more: Vec<Vector>,
}

/// The films that are reported, and their balance: the more accurate films carry somewhat else than those by which the
/// balance was `found`, so that the shaft is balanced again, until what they carry balances its loads.
fn reported(
    compiled: &Compiled,
    films: &Films,
    found: ShaftEquilibrium,
    options: &RunOptions,
) -> Result<Reported, NoShaftAnswer> {
    let asked = compiled.steady_load();
    let size = asked.iter().map(|&load| length(load)).sum::<f64>();
    let mut balance = found;
    let mut more = vec![[0.0; 4]; films.films.len()];
    let mut left = f64::INFINITY;
    for _ in 0..MOST_BALANCES {
        let solve = |(bearing, here): (&CompiledBearing, &Instant)| {
            let solve = SolveOptions { errors: options.errors(), ..SolveOptions::default() };
            isothermal(&bearing.film.with_journal(here.film.problem.journal), &solve)
        };
        let at: Vec<(&CompiledBearing, &Instant)> = compiled.bearings.iter().zip(&balance.instants).collect();
        let solved: Result<Vec<Solved>, NoAnswer> = at.into_par_iter().map(solve).collect();
        let solved = solved.map_err(|reason| (Status::without(&reason), reason.to_string()))?;
        let carried: Vec<Resultant> = solved.iter().map(|solved| load(solved.reported()).total.resultant()).collect();
        left = 0.0;
        for (((film, here), carried), more) in films.films.iter().zip(&balance.instants).zip(&carried).zip(&mut more) {
            let before = *more;
            if options.errors() == Errors::Estimated {
                *more = moved(film.coordinates.forces(carried), -1.0, here.excess);
            }
            left += length(moved(*more, -1.0, before));
        }
        if left <= BALANCED * size {
            return Ok(Reported { balance, solved, carried, more });
        }
        let next = films.rebalanced(&asked, 0.0, &balance, &more);
        balance = next.map_err(|reason| without(&reason, compiled, options.cause()))?;
    }
    let (bearing, gap) = films.thinnest(balance.instants.iter().map(Instant::under_wall));
    let residual = left / size;
    Err(without(&NoBalance::Stuck { residual, bearing, gap }, compiled, options.cause()))
}

/// Fills in the numbers of a balance.
fn report(
    (compiled, temperatures): (&Compiled, &Temperatures),
    found: ShaftEquilibrium,
    options: &RunOptions,
    result: &mut ShaftResult,
) -> Result<(), NoShaftAnswer> {
    let films = compiled.films();
    let Reported { balance, mut solved, carried, more } = reported(compiled, &films, found, options)?;
    for (number, solved) in solved.iter_mut().enumerate() {
        let Some((search, model)) = temperatures.of_bearing(number).zip(solved.film.model.sockets.thermal) else {
            continue;
        };
        let flows = thermal_flows_of(&model, solved.reported());
        solved.temperature = Some(TemperatureFound {
            balanced: search.balanced(flows),
            is_ended: false,
            slopes: search.slopes(),
            positions: 0,
            work: Work::default(),
            seconds: 0.0,
        });
    }
    let estimated: Vec<Estimated> = solved.par_iter().map(estimate_errors).collect();
    let displacements = displacements(&films, &balance, &estimated);
    let displacements = displacements.map_err(|reason| without(&NoBalance::Film(reason), compiled, options.cause()))?;
    let at: Vec<Vector> = balance.instants.iter().map(|here| here.at).collect();
    let balanced = balance.instants.iter().zip(&more);
    let forces: Vec<Vector> = balanced.map(|(here, more)| moved(here.excess, 1.0, *more)).collect();
    let shells = films.joined(&[], 0.0).yields(&forces);
    let measure = |number: usize| {
        let (bearing, solved, of_film) = (&compiled.bearings[number], &solved[number], &films.films[number]);
        (number, bearing, solved, of_film)
    };
    let parts = (0..compiled.bearings.len()).map(measure).zip(estimated);
    for ((number, bearing, solved, of_film), estimated) in parts {
        let errors = displacements.as_ref().map(|all| &all[number][..]);
        let estimated = match options.errors() {
            Errors::Estimated => estimated.displaced(solved, of_film.coordinates, errors),
            Errors::Omitted => estimated,
        };
        let warnings = all_warnings(&solved.film.oil, solved, &estimated, options.errors());
        let shell = shells[number];
        let [tilt_x, tilt_y] = solved.film.problem.journal.tilt;
        let report = BearingReport {
            shell: [shell[0].hypot(shell[1]), shell[2].hypot(shell[3]) / of_film.coordinates.arm],
            tilt_max: tilt_x.hypot(tilt_y),
            ..BearingReport::of(bearing, estimated.quantities, options.bars)
        };
        result.add(BearingReport { tilt_max_error: report.tilt_error(), ..report }, warnings);
    }
    result.films = balance.films;
    let gaps = films.gaps(balance.instants.iter().map(Instant::under_wall));
    result.deflection = ShaftDeflection::at_rest(compiled, (&at, &forces), &gaps);
    let thermal = solved.iter().filter_map(|solved| solved.temperature.as_ref()).map(TemperatureFound::left_over);
    let thermal = thermal.fold(0.0, f64::max);
    result.balances = ShaftBalances { thermal, ..balances(compiled, &balance, &carried) };
    Ok(())
}

/// What the errors of all films do to each of them, by bearing; none where a film has no bar.
fn displacements(
    films: &Films,
    balance: &ShaftEquilibrium,
    estimated: &[Estimated],
) -> Result<Option<Vec<Vec<Displacement>>>, NoFilmAt> {
    let of_film = |(number, estimated): (usize, &Estimated)| {
        let coordinates = films.films[number].coordinates;
        let errors = estimated.carried.as_ref()?.iter().take(coordinates.order);
        let force = |(direction, bar): &(Vector, f64)| (number, direction.map(|part| bar * part));
        Some(errors.map(force).collect::<Vec<_>>())
    };
    let Some(errors) = estimated.iter().enumerate().map(of_film).collect::<Option<Vec<_>>>() else {
        return Ok(None);
    };
    let errors: Vec<(usize, Vector)> = errors.into_iter().flatten().collect();
    let moves = films.moved_by(&balance.instants, 0.0, &errors)?;
    let seen = |number: usize| {
        let both = errors.iter().zip(&moves);
        let seen = both.map(|((bearing, force), moves)| Displacement {
            by: moves[number],
            carries: if *bearing == number { *force } else { [0.0; 4] },
        });
        seen.collect()
    };
    Ok(Some((0..films.films.len()).map(seen).collect()))
}

/// The balances of the whole shaft, by the loads as they are given and what the films carry.
fn balances(compiled: &Compiled, balance: &ShaftEquilibrium, carried: &[Resultant]) -> ShaftBalances {
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
    for (carried, bearing) in carried.iter().zip(&compiled.bearings) {
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
        ..ShaftBalances::default()
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
