//! The shaft over a cycle of its throws: all films at once, or each orbit under what statics gives it.

use std::time::Instant;

use oilwedge_bearing::coordinates::Vector;
use oilwedge_bearing::duty_cycle::{DutyCycle, ForceAxes, LoadPoint, Turning};
use oilwedge_bearing::orbit::{Journals, NoOrbit, NoOrbitAt, OrbitEnd, OrbitOptions, Orbits, PathStep};
use oilwedge_bearing::shaft::{Engine, Films};
use oilwedge_scene::{ShaftScene, Statics};

use super::balances::balances;
use super::compile::{Compiled, CompiledBearing, compile_shaft};
use super::deflection::ShaftDeflection;
use super::error::ShaftError;
use super::result::{BearingPath, BearingReport, ShaftRun, found_with_shaft};
use super::temperatures::{BearingNumbers, NoShaftAnswer, Temperatures};
use crate::estimate::estimate_errors;
use crate::orbit::{
    BALANCED, CycleFacts, FollowedCycle, GREATEST, USUAL, add_temperature, compared, follow_under, judge, measured,
    motion, suits,
};
use crate::reasons::{Cause, Limit};
use crate::result::Status;
use crate::run_options::RunOptions;
use crate::solved::Errors;
use crate::warnings::all_warnings;

/// The journals on the next coarser meshes, or on their own where there are none: tolerance and cycles.
const ROUGH: f64 = 2e-2;
const ROUGH_CYCLES: usize = 2;

/// Follows the journals of a shaft.
///
/// # Errors
/// The scenes do not become a shaft on films.
pub(super) fn followed(scene: &ShaftScene, engine: &Engine, options: &RunOptions) -> Result<ShaftRun, ShaftError> {
    match scene.crankshaft.statics {
        Statics::Cut => cut(scene, engine, options),
        Statics::Elastic => elastic(scene, engine, options),
    }
}

/// Each bearing alone, under what statics gives it.
fn cut(scene: &ShaftScene, engine: &Engine, options: &RunOptions) -> Result<ShaftRun, ShaftError> {
    let clock = Instant::now();
    let compiled = compile_shaft(scene, USUAL)?;
    let mains: Vec<f64> = compiled.bearings.iter().map(|bearing| bearing.at).collect();
    let mut run = ShaftRun::of(scene, options.bars);
    for (bearing, cycle) in compiled.bearings.iter().zip(engine.on_mains(&mains, &compiled.throws)) {
        let own = &bearing.film.model;
        let orbit = own.scope.orbit.unwrap_or_else(oilwedge_scene::OrbitTable::usual);
        let outcome = follow_under(own, (&orbit, &cycle), options);
        let (_, outcome) = outcome.map_err(|source| ShaftError::Film { path: bearing.path.clone(), source })?;
        match outcome {
            Ok(followed) => {
                let cycles = &followed.facts.cycles;
                run.result.films += cycles.iter().map(|cycle| cycle.films).sum::<usize>();
                let last = cycles.last().map_or(0.0, |cycle| cycle.closure);
                ended(&mut run, followed.end, (cycles.len(), last), options);
                add(&mut run, bearing, cycle, followed, &[], options);
            }
            Err(reason) => {
                let told = format!("bearing {}: {reason}", bearing.name);
                run.result.head.end(Status::without(&reason), told);
                run.result.bearings.clear();
                run.paths.clear();
                return Ok(run);
            }
        }
    }
    run.result.tail.took("orbits", clock.elapsed().as_secs_f64());
    Ok(run)
}

/// All films at once.
fn elastic(scene: &ShaftScene, engine: &Engine, options: &RunOptions) -> Result<ShaftRun, ShaftError> {
    let clock = Instant::now();
    let model = scene.orbit.unwrap_or_else(oilwedge_scene::OrbitTable::usual);
    let mut compiled = compile_shaft(scene, USUAL)?;
    let mut run = ShaftRun::of(scene, options.bars);
    let march = OrbitOptions {
        tolerance: model.tolerance,
        closure: model.closure,
        cycles: model.cycles,
        deadline: options.deadline(),
        observer: options.observer.map(|observer| observer as &dyn oilwedge_bearing::orbit::OrbitObserver),
    };
    let mut temperatures = Temperatures::of(&compiled);
    let first = compiled.shaft.loads(&engine.loads(0.0), 0.0);
    let mut start = compiled.films().first_places(&first);
    if let Some((end, greatest)) = rough(scene, engine, &compiled, (&start, &march), (&mut temperatures, options)) {
        start = end;
        let is_graded = compiled.bearings.iter().any(|bearing| bearing.film.model.mesh.is_graded());
        if is_graded && !suits(USUAL, greatest) {
            compiled = compiled.meshed_for(greatest)?;
        }
    }
    temperatures.begin_again();
    let found = at_temperatures(scene, engine, (&compiled, &mut temperatures), (&start, &march), options);
    run.result.tail.took("orbits", clock.elapsed().as_secs_f64());
    let compiled = temperatures.applied(&compiled);
    let outcome = found.and_then(|orbit| {
        let clock = Instant::now();
        let found = (&orbit, &*start, &march);
        let outcome = report(scene, engine, (&compiled, &temperatures), found, options, &mut run);
        run.result.tail.took("measure", clock.elapsed().as_secs_f64());
        outcome?;
        let last = orbit.cycles.last().map_or(0.0, |cycle| cycle.closure);
        ended(&mut run, orbit.end, (orbit.cycles.len(), last), options);
        Ok(())
    });
    if let Err((status, reason)) = outcome {
        run.result.head.end(status, reason);
        run.result.bearings.clear();
        run.paths.clear();
    }
    Ok(run)
}

/// The orbits of all journals from some places [m] on, at the temperatures that balance the heat of their films.
fn at_temperatures(
    scene: &ShaftScene,
    engine: &Engine,
    (compiled, temperatures): (&Compiled, &mut Temperatures),
    (start, march): (&[Vector], &OrbitOptions),
    options: &RunOptions,
) -> Result<Orbits, NoShaftAnswer> {
    let followed = |at: &Compiled, begin: MotionStart| {
        let found = orbits(scene, engine, at, &at.films(), (begin, march));
        found.map_err(|reason| (status(&reason), told(&reason, at, options.cause())))
    };
    if temperatures.are_given() {
        return followed(compiled, MotionStart::At(start));
    }
    let numbers_alone = RunOptions { bars: false, frames: 0, observer: None, ..*options };
    let shown = |at: &Compiled, orbits: &Orbits| {
        let found = measured_all(scene, at, orbits, &numbers_alone)?;
        Ok(found
            .into_iter()
            .map(|(followed, _)| (followed.flows, followed.quantities))
            .collect::<Vec<BearingNumbers>>())
    };
    if let Some(observer) = options.observer {
        observer.turns_to("the shaft at temperatures of its films, one set after the other");
    }
    let mut last: Option<Orbits> = None;
    temperatures.balance(
        compiled,
        BALANCED * march.tolerance,
        || march.deadline.is_over(),
        |at| {
            let orbits = followed(at, MotionStart::after(last.as_ref(), start))?;
            let shown = shown(at, &orbits)?;
            last = Some(orbits);
            Ok(shown)
        },
    )?;
    if options.bars {
        temperatures.show_slopes(compiled, |at| shown(at, &followed(at, MotionStart::after(last.as_ref(), start))?));
    }
    match last {
        Some(orbits) => Ok(orbits),
        None => followed(&temperatures.applied(compiled), MotionStart::At(start)),
    }
}

/// Where the motion of all journals begins.
#[derive(Clone, Copy)]
enum MotionStart<'a> {
    /// At places [m].
    At(&'a [Vector]),
    /// At the end of other orbits.
    After(&'a Orbits),
}

impl<'a> MotionStart<'a> {
    /// After other orbits or, where there are none, at places [m].
    fn after(orbits: Option<&'a Orbits>, start: &'a [Vector]) -> Self {
        orbits.map_or(Self::At(start), Self::After)
    }
}

/// The orbits of all journals on these films of a shaft.
fn orbits(
    scene: &ShaftScene,
    engine: &Engine,
    compiled: &Compiled,
    films: &Films,
    (begin, march): (MotionStart, &OrbitOptions),
) -> Result<Orbits, NoOrbitAt> {
    let loads = |angle: f64| compiled.shaft.loads(&engine.loads(angle), angle);
    let drive = films.drive(&loads, [scene.crankshaft.period, scene.crankshaft.speed]);
    let motions = films.motions();
    let journals = Journals { motions: &motions, shaft: Some(drive) };
    match begin {
        MotionStart::At(start) => journals.orbits(start, march),
        MotionStart::After(Orbits { steps, .. }) => journals.orbits_after(steps.last().map_or(&[], |step| step), march),
    }
}

/// Where journals that are followed roughly end a cycle [m], and their greatest eccentricity at an end [1], with the
/// temperatures of their films found as roughly; `None` where there is none.
fn rough(
    scene: &ShaftScene,
    engine: &Engine,
    compiled: &Compiled,
    (start, march): (&[Vector], &OrbitOptions),
    (temperatures, options): (&mut Temperatures, &RunOptions),
) -> Option<(Vec<Vector>, f64)> {
    let films = compiled.films();
    let coarser = compiled.with_films(|_, bearing| bearing.film.on_coarser());
    let march = OrbitOptions { tolerance: ROUGH, cycles: ROUGH_CYCLES, observer: None, ..*march };
    let orbit = at_temperatures(
        scene,
        engine,
        (&coarser, temperatures),
        (start, &march),
        &RunOptions { bars: false, ..*options },
    )
    .ok()?;
    let end = places(orbit.steps.last()?);
    let gaps = orbit.steps.iter().map(|step| films.thinnest(step.iter().map(PathStep::under_wall)).1);
    let greatest = 1.0 - gaps.fold(f64::INFINITY, f64::min);
    Some((end, greatest.clamp(0.0, GREATEST)))
}

/// Fills in the numbers of all bearings.
fn report(
    scene: &ShaftScene,
    engine: &Engine,
    (compiled, temperatures): (&Compiled, &Temperatures),
    (orbit, start, march): (&Orbits, &[Vector], &OrbitOptions),
    options: &RunOptions,
    run: &mut ShaftRun,
) -> Result<(), NoShaftAnswer> {
    let films = compiled.films();
    // What films that conserve their oil are off by depends on what they have held all along.
    let by_comparison = compiled.bearings.iter().any(|bearing| bearing.film.problem.cavitation.conserves_oil());
    let of_films = RunOptions { bars: options.bars && !by_comparison, ..*options };
    let mut found = measured_all(scene, compiled, orbit, &of_films)?;
    if by_comparison && options.errors() == Errors::Estimated {
        let on_vertices = compiled.on_vertices();
        let numbers_alone = RunOptions { bars: false, frames: 0, observer: None, ..*options };
        let compared = compared(march, |march| {
            let orbits =
                orbits(scene, engine, &on_vertices, &on_vertices.films(), (MotionStart::At(start), march)).ok()?;
            let is_complete = orbits.end != OrbitEnd::Ended;
            is_complete.then(|| measured_all(scene, &on_vertices, &orbits, &numbers_alone).ok()).flatten()
        });
        for (number, (followed, _)) in found.iter_mut().enumerate() {
            let [alike, wider] = compared
                .each_ref()
                .map(|all| all.as_ref().map(|all: &Vec<(FollowedCycle, DutyCycle)>| &all[number].0.quantities[..]));
            judge(alike.zip(wider), &mut followed.quantities);
            followed.are_bars_ended = alike.is_none() && options.deadline().is_over();
        }
    }
    let mut left_over: f64 = 0.0;
    for (number, (bearing, (mut followed, cycle))) in compiled.bearings.iter().zip(found).enumerate() {
        if let Some((search, flows)) = temperatures.of_bearing(number).zip(followed.flows) {
            add_temperature(search, flows, options.bars, &mut followed);
            left_over = left_over.max(followed.temperature.map_or(0.0, |found| found.left_over));
        }
        followed.quantities = found_with_shaft(followed.quantities);
        let yields = |step: &Vec<PathStep>| {
            let carried: Vec<Vector> = step.iter().map(|step| step.excess).collect();
            films.joined(&[], 0.0).yields(&carried)[number]
        };
        let shells: Vec<Vector> = orbit.steps.iter().map(yields).collect();
        add(run, bearing, cycle, followed, &shells, options);
    }
    run.result.films = orbit.cycles.iter().map(|cycle| cycle.films).sum();
    run.result.balances = balances(engine, compiled, orbit).map_err(|reason| {
        (Status::NoSolution, format!("bearing {}: {reason}", compiled.bearings[reason.bearing].name))
    })?;
    run.result.balances.thermal = left_over;
    run.result.deflection = ShaftDeflection::of_cycle(compiled, engine, orbit);
    run.result.cycles = orbit
        .cycles
        .iter()
        .map(|cycle| CycleFacts { oil_closure: None, oil_imbalance: None, ..CycleFacts::of(cycle) })
        .collect();
    Ok(())
}

/// Each bearing along its orbit, with the load that its film carries.
///
/// # Errors
/// Status and reason of a bearing whose films are not found again.
fn measured_all(
    scene: &ShaftScene,
    compiled: &Compiled,
    orbits: &Orbits,
    options: &RunOptions,
) -> Result<Vec<(FollowedCycle, DutyCycle)>, NoShaftAnswer> {
    let of_bearing = |(number, bearing): (usize, &CompiledBearing)| {
        let cycle = own_load(scene, bearing, &orbits.steps, number);
        let cycle = cycle.map_err(|reason| (Status::NotConverged, format!("bearing {}: {reason}", bearing.name)))?;
        let orbit = bearing.film.model.scope.orbit.unwrap_or_else(oilwedge_scene::OrbitTable::usual);
        let motion = motion(&bearing.film, &orbit, &cycle);
        let followed = measured(&bearing.film, &motion, &orbit, orbits.of(number), options)
            .map_err(|reason| (Status::without(&reason), format!("bearing {}: {reason}", bearing.name)))?;
        Ok((followed, cycle))
    };
    compiled.bearings.iter().enumerate().map(of_bearing).collect()
}

/// Places of all journals [m].
fn places(step: &[PathStep]) -> Vec<Vector> {
    step.iter().map(|step| step.at).collect()
}

/// The load that the film of a bearing carries over the cycle, by a curve through its steps.
fn own_load(
    scene: &ShaftScene,
    bearing: &CompiledBearing,
    steps: &[Vec<PathStep>],
    number: usize,
) -> Result<DutyCycle, oilwedge_bearing::duty_cycle::NoSpline> {
    let speed = scene.crankshaft.speed;
    let arm = bearing.coordinates().arm;
    let point = |step: &Vec<PathStep>| {
        let PathStep { time, excess: [x, y, z_x, z_y], .. } = step[number];
        LoadPoint { angle: speed * time, force: [x, y], moment: [arm * z_x, arm * z_y] }
    };
    // The last step is the first one of the next cycle.
    let points: Vec<LoadPoint> = steps[..steps.len().saturating_sub(1)].iter().map(point).collect();
    DutyCycle::of_table(&points, scene.crankshaft.period, ForceAxes::Shell, Turning { speed, rod: None })
}

/// Adds the report of a bearing, its path, and the warnings about its thinnest film.
fn add(
    run: &mut ShaftRun,
    bearing: &CompiledBearing,
    load: DutyCycle,
    followed: FollowedCycle,
    shells: &[Vector],
    options: &RunOptions,
) {
    let estimated = estimate_errors(&followed.solved);
    let warnings = all_warnings(&bearing.film.oil, &followed.solved, &estimated, options.errors());
    let arm = bearing.coordinates().arm;
    let tilts = followed.path.spans.iter().map(|span| {
        let [_, _, x, y] = span.places[0];
        x.hypot(y) / arm
    });
    let shell = shells.iter().fold([0.0f64; 2], |[offset, tilt], [x, y, z_x, z_y]| {
        [offset.max(x.hypot(*y)), tilt.max(z_x.hypot(*z_y) / arm)]
    });
    let report = BearingReport {
        tilt_max: tilts.fold(0.0, f64::max),
        shell,
        energy: followed.balances.energy,
        ..BearingReport::of(bearing, followed.quantities, options.bars)
    };
    run.result.add(report, warnings);
    run.paths.push(BearingPath { name: bearing.name.clone(), load, path: followed.path });
}

/// Says how cycles ended that are not closed, with their number and the closure of the last one.
fn ended(run: &mut ShaftRun, end: OrbitEnd, (cycles, closure): (usize, f64), options: &RunOptions) {
    let limit = match end {
        OrbitEnd::Closed => return,
        OrbitEnd::NotClosed => Limit::NotClosed(cycles, closure),
        OrbitEnd::Ended => Limit::Orbit(cycles, closure, options.cause()),
    };
    run.result.head.end(Status::NotConverged, limit);
}

fn status(at: &NoOrbitAt) -> Status {
    match at.reason.is_unreached() {
        true => Status::NotConverged,
        false => Status::NoSolution,
    }
}

/// Why the journals cannot be followed, with the name of the bearing that is meant, and the way out.
fn told(NoOrbitAt { bearing, reason }: &NoOrbitAt, compiled: &Compiled, cause: Cause) -> String {
    let name = compiled.bearings.get(*bearing).map_or("", |bearing| &bearing.name);
    match reason {
        NoOrbit::SqueezedOutOnShaft { .. } => format!(
            "bearing {name}: {reason}; give its scene a finer mesh ([mesh] size), for a coarse one carries less where the film is thin; else lower the loads, raise speed or viscosity, or give a stiffer shaft \
             where its slope takes the film"
        ),
        NoOrbit::Stuck { .. } => format!(
            "bearing {name}: {reason}; lower the loads, or give the bearing more length or its shell less stiffness"
        ),
        NoOrbit::Ended { .. } => cause.ends(&reason.to_string()),
        _ => format!("bearing {name}: {reason}"),
    }
}
