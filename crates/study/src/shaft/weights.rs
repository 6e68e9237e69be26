//! Counterweights of a crankshaft: how to move them between the webs that have one, so that the least film of all
//! bearings is greatest, and the force and the moment of the whole shaft stay.
//!
//! The search asks for orbits by the maps of the films, where the shaft is cut at its bearings. That shaft is not the
//! one of the scene, which decides: the counterweights are moved the whole way to those that the search has found, or
//! half of it and so on, until the films of the scene fare better, and stay where no part of the way serves them.

use oilwedge_bearing::duty_cycle::DutyCycle;
use oilwedge_bearing::mobility::{FiniteMap, Travel};
use oilwedge_bearing::orbit::Span;
use oilwedge_bearing::shaft::Engine;
use oilwedge_bearing::shaft::counterweights::{changes, neutral};
use oilwedge_scene::{Counterweight, ShaftScene};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::compile::{Compiled, compile_shaft, engine};
use super::error::ShaftError;
use crate::minimax::greatest_least;
use crate::orbit::no_map;

/// Maps reach to this eccentricity.
const GREATEST: f64 = 0.99;
/// Orbits by maps: error of a step over the least film, closure over the clearance, cycles.
const TOLERANCE: f64 = 1e-4;
const CLOSURE: f64 = 1e-3;
const CYCLES: usize = 3;
/// Least films are looked for at so many places of a step.
const PLACES: u32 = 6;
/// Parts of a cycle whose least films are told apart: the least of each changes smoothly, that of all has corners.
const WINDOWS: usize = 24;
/// Each vector of changes may reach this far, over the mean counterweight.
const REACH: f64 = 3.0;

/// What the search has found.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct CounterweightReport {
    /// The webs with a counterweight.
    pub webs: Vec<WebReport>,
    /// Part of the way [1] to the counterweights that serve the shaft best where it is cut: the first of 1, 1/2, 1/4,
    /// 1/8 on which the shaft of the scene fares better; 0 where it does on none, and its counterweights stay.
    pub part: f64,
    /// Least film of all bearings by maps of the films, the shaft cut at its bearings: before, and the whole way [m].
    pub film_by_maps: [f64; 2],
    /// Least film of all bearings on the films of the scene: before and after [m]; `null` where the films after were
    /// not found.
    pub film: Option<[f64; 2]>,
    /// How far the force of the whole shaft has changed, over the sum of all counterweights [1].
    pub force_change: f64,
    /// How far its moment has changed, over that sum times the length of the shaft [1].
    pub moment_change: f64,
    /// Shafts that were asked for.
    pub asked: usize,
}

/// One web: mass times radius [kg m] of its counterweight, and its angle against the throw [deg].
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct WebReport {
    /// Number of its throw, from 1.
    pub throw: usize,
    /// Number of the web on the throw, 1 or 2.
    pub web: usize,
    /// Mass times radius before and after [kg m].
    pub moment: [f64; 2],
    /// Angle before and after [deg].
    pub angle_deg: [f64; 2],
}

/// Why counterweights cannot be sought.
#[derive(Debug, thiserror::Error)]
pub enum NoWeights {
    /// The scenes do not become a shaft on films.
    #[error(transparent)]
    Shaft(#[from] ShaftError),
    /// The loads do not change.
    #[error("the scene has no [crank], so counterweights have no effect; leave this out, or give [crank]")]
    AtRest,
    /// The counterweights that may change are too few.
    #[error(
        "counterweights on {0} webs leave no choice where force and moment of the shaft stay; give [[crankshaft.counterweight]] on three webs or more, be their mass zero"
    )]
    TooFew(usize),
    /// A film has no map.
    #[error("no map stands for the film of bearing {bearing}, since {reason}; give it a simpler scene for the search")]
    NoMap {
        /// Name of the bearing.
        bearing: String,
        /// The cause, in words.
        reason: String,
    },
    /// The orbits by maps lead nowhere.
    #[error("the orbits by maps of the films lead nowhere with the counterweights of the scene; lower the loads")]
    NoOrbit,
}

/// A shaft whose counterweights may move.
pub(super) struct Movable {
    engine: Engine,
    /// The shaft cut at its bearings.
    compiled: Compiled,
    /// The webs that have a counterweight, each once.
    webs: Vec<(usize, usize)>,
    /// Changes of them that keep force and moment of the shaft.
    basis: Vec<Vec<f64>>,
}

impl Movable {
    /// The shaft of a scene, before any film is solved.
    ///
    /// # Errors
    /// [`NoWeights`]: why they cannot be sought.
    pub(super) fn of(scene: &ShaftScene) -> Result<Self, NoWeights> {
        let engine = engine(scene)?.ok_or(NoWeights::AtRest)?;
        let compiled = compile_shaft(&scene.cut(), GREATEST)?;
        let webs = webs(scene);
        let place = |&(throw, web): &(usize, usize)| compiled.throws[throw][2 * web];
        let basis = neutral(&webs.iter().map(place).collect::<Vec<_>>());
        if basis.is_empty() {
            return Err(NoWeights::TooFew(webs.len()));
        }
        let without = compiled.bearings.iter().find_map(|bearing| Some((bearing, no_map(&bearing.film.model)?)));
        if let Some((bearing, reason)) = without {
            return Err(NoWeights::NoMap { bearing: bearing.name.clone(), reason: reason.to_owned() });
        }
        Ok(Self { engine, compiled, webs, basis })
    }
}

/// The scene with the best counterweights, and what they are.
///
/// # Errors
/// [`NoWeights`]: why they cannot be sought.
pub fn best_counterweights(scene: &ShaftScene) -> Result<(ShaftScene, CounterweightReport), NoWeights> {
    let Movable { engine, compiled, webs, basis } = Movable::of(scene)?;
    let maps = maps(&compiled)?;
    let films = |free: &[f64]| least_films(&moved(&engine, &webs, &changes(&basis, free)), &compiled, &maps);
    let sum: f64 = scene.crankshaft.counterweights.iter().map(|weight| weight.moment).sum();
    let radius = scene.crank.as_ref().map_or(0.0, |crank| crank.radius);
    let usual = scene.crank.as_ref().and_then(|crank| crank.drive.as_ref()).map_or(0.0, |drive| drive.rotating_mass);
    let mean = if sum > 0.0 { sum / webs.len() as f64 } else { radius * usual };
    let start = vec![0.0; 2 * basis.len()];
    let before = films(&start).ok_or(NoWeights::NoOrbit)?.into_iter().fold(f64::INFINITY, f64::min);
    let best = greatest_least(&films, &start, REACH * mean, before).ok_or(NoWeights::NoOrbit)?;
    let after = moved(&engine, &webs, &changes(&basis, &best.at));
    let [was, is] = [&engine, &after].map(|engine| engine.out_of_balance(&compiled.throws));
    let changed = [0, 1].map(|k: usize| (is[k][0] - was[k][0]).hypot(is[k][1] - was[k][1]));
    let scale = mean * webs.len() as f64;
    let changed_scene = with_weights(scene, &webs, &changes(&basis, &best.at), &engine);
    let report = CounterweightReport {
        webs: reports(scene, &changed_scene, &webs),
        part: 1.0,
        film_by_maps: [before, best.value],
        film: None,
        force_change: changed[0] / scale,
        moment_change: changed[1] / (scale * scene.crankshaft.length()),
        asked: best.asked,
    };
    Ok((changed_scene, report))
}

/// The scene with its counterweights moved a part of the way to those of another one, which has them on the same webs,
/// and what `found` says of that.
pub(super) fn part_of_way(
    [from, to]: [&ShaftScene; 2],
    part: f64,
    found: &CounterweightReport,
) -> (ShaftScene, CounterweightReport) {
    let weight = |&(throw, web): &(usize, usize)| {
        let [[x, y], [to_x, to_y]] = [from, to].map(|scene| sum(scene, throw, web));
        let [x, y] = [x + part * (to_x - x), y + part * (to_y - y)];
        Counterweight { throw, web, moment: x.hypot(y), angle: y.atan2(x) }
    };
    let webs = webs(from);
    let moved = from.with_counterweights(webs.iter().map(weight).collect());
    let report = CounterweightReport {
        webs: reports(from, &moved, &webs),
        part,
        force_change: part * found.force_change,
        moment_change: part * found.moment_change,
        ..found.clone()
    };
    (moved, report)
}

/// The webs that have a counterweight, each once.
fn webs(scene: &ShaftScene) -> Vec<(usize, usize)> {
    let mut webs: Vec<_> = scene.crankshaft.counterweights.iter().map(|weight| (weight.throw, weight.web)).collect();
    webs.sort_unstable();
    webs.dedup();
    webs
}

/// The engine with these changes [kg m] on webs.
fn moved(engine: &Engine, webs: &[(usize, usize)], changes: &[[f64; 2]]) -> Engine {
    let mut changed = engine.clone();
    for (&(throw, web), change) in webs.iter().zip(changes) {
        let unbalance = &mut changed.unbalances[throw][web];
        *unbalance = [unbalance[0] + change[0], unbalance[1] + change[1]];
    }
    changed
}

/// The map of the film of each bearing; bearings of one scene share it.
fn maps(compiled: &Compiled) -> Result<Vec<(usize, FiniteMap)>, NoWeights> {
    let mut maps: Vec<(usize, FiniteMap)> = Vec::new();
    for (number, bearing) in compiled.bearings.iter().enumerate() {
        let first = compiled.bearings.iter().position(|other| other.path == bearing.path);
        if first != Some(number) {
            continue;
        }
        let map = FiniteMap::new(&bearing.film.problem, &bearing.film.system, GREATEST);
        let map = map.map_err(|reason| NoWeights::NoMap { bearing: bearing.name.clone(), reason: reason.to_string() });
        maps.push((number, map?));
    }
    Ok(maps)
}

/// Least film of each bearing [m] in each part of the cycle, by maps; `None` where an orbit leads nowhere.
fn least_films(engine: &Engine, compiled: &Compiled, maps: &[(usize, FiniteMap)]) -> Option<Vec<f64>> {
    let mains: Vec<f64> = compiled.bearings.iter().map(|bearing| bearing.at).collect();
    let cycles: Vec<DutyCycle> = engine.on_mains(&mains, &compiled.throws);
    let least = |(bearing, cycle): (&super::CompiledBearing, &DutyCycle)| {
        let first = compiled.bearings.iter().position(|other| other.path == bearing.path)?;
        let (_, map) = maps.iter().find(|(number, _)| *number == first)?;
        let travel = Travel {
            map,
            bearing: bearing.film.problem.bearing,
            viscosity: bearing.film.problem.lubricant.viscosity,
            cycle,
        };
        let orbit = travel.orbit([0.0; 2], TOLERANCE, CLOSURE, CYCLES)?;
        let mut films = vec![travel.bearing.clearance; WINDOWS];
        let [first, last] = [orbit.steps.first()?, orbit.steps.last()?].map(|step| step.time);
        for span in orbit.steps.windows(2).map(|pair| Span::between(&pair[0], &pair[1])) {
            for k in 0..PLACES {
                let part = f64::from(k) / f64::from(PLACES);
                let time = span.times[0] + part * (span.times[1] - span.times[0]);
                let [x, y, ..] = span.at(time);
                let window = (WINDOWS as f64 * (time - first) / (last - first)) as usize;
                let film = &mut films[window.min(WINDOWS - 1)];
                *film = film.min(travel.bearing.clearance - x.hypot(y));
            }
        }
        Some(films)
    };
    let films: Option<Vec<Vec<f64>>> = compiled.bearings.par_iter().zip(&cycles).map(least).collect();
    Some(films?.concat())
}

/// The scene with one counterweight on each of these webs: those that it had, and the changes [kg m] in the axes of the
/// shaft.
fn with_weights(scene: &ShaftScene, webs: &[(usize, usize)], changes: &[[f64; 2]], engine: &Engine) -> ShaftScene {
    let weight = |(&(throw, web), change): (&(usize, usize), &[f64; 2])| {
        let [x, y] = sum(scene, throw, web);
        // The change in the axes of the throw.
        let (sin, cos) = engine.lies_at(throw).sin_cos();
        let [x, y] = [x + cos * change[0] + sin * change[1], y - sin * change[0] + cos * change[1]];
        Counterweight { throw, web, moment: x.hypot(y), angle: y.atan2(x) }
    };
    scene.with_counterweights(webs.iter().zip(changes).map(weight).collect())
}

/// The counterweights of a web together [kg m], in the axes of its throw.
fn sum(scene: &ShaftScene, throw: usize, web: usize) -> [f64; 2] {
    let weights = scene.crankshaft.counterweights.iter();
    let own = weights.filter(|weight| (weight.throw, weight.web) == (throw, web));
    own.fold([0.0; 2], |[x, y], weight| {
        let (sin, cos) = weight.angle.sin_cos();
        [x + weight.moment * cos, y + weight.moment * sin]
    })
}

fn reports(before: &ShaftScene, after: &ShaftScene, webs: &[(usize, usize)]) -> Vec<WebReport> {
    let report = |&(throw, web): &(usize, usize)| {
        let both = [before, after].map(|scene| sum(scene, throw, web));
        WebReport {
            throw: throw + 1,
            web: web + 1,
            moment: both.map(|[x, y]| x.hypot(y)),
            angle_deg: both.map(|[x, y]| y.atan2(x).to_degrees().rem_euclid(360.0)),
        }
    };
    webs.iter().map(report).collect()
}
