//! The mesh of an orbit, and where the journal begins.

use std::sync::Arc;

use oilwedge_bearing::coordinates::Vector;
use oilwedge_bearing::duty_cycle::DutyCycle;
use oilwedge_bearing::mobility::{ShortMap, Travel};
use oilwedge_bearing::orbit::{Motion, Orbit, OrbitObserver, OrbitOptions};
use oilwedge_reynolds::Gap;

use super::{motion, no_map};
use crate::compile_error::CompileError;
use crate::film::Film;
use crate::model::Model;
use crate::observer::Watch;
use crate::oil::Oil;
use crate::position::{FilmState, Position};

/// The first mesh is that for an orbit with this greatest eccentricity; where the orbit on its coarser mesh leads
/// elsewhere, another one is drawn if its edges differ by this factor.
pub(crate) const USUAL: f64 = 0.93;
const ELSEWHERE: f64 = 1.3;
/// Greatest eccentricity for which a mesh is drawn.
pub(crate) const GREATEST: f64 = 0.998;
/// An orbit on a coarser mesh: tolerance and cycles.
const ROUGH: f64 = 2e-2;
const ROUGH_CYCLES: usize = 2;
/// Eccentricity towards the load at which the first orbit begins.
const FIRST: f64 = 0.3;

/// The film of an orbit on a mesh that resolves it, and the offsets [m] at which it begins.
///
/// # Errors
/// The model does not become a film.
pub(super) fn prepared(
    model: &Arc<Model>,
    oil: &Oil,
    (orbit, cycle): (&oilwedge_scene::OrbitTable, &DutyCycle),
    watch: Watch,
) -> Result<(Film, Vector), CompileError> {
    let film = on_mesh_for(model, oil, USUAL)?;
    let rough = rough(&film, (orbit, cycle), watch);
    let clearance = film.problem.bearing.clearance;
    let given = orbit.start.map(|[eccentricity, angle]| {
        let offset = eccentricity * clearance;
        [offset * angle.cos(), offset * angle.sin(), 0.0, 0.0]
    });
    let Some((rough, greatest)) = rough else {
        return Ok((film, given.unwrap_or(first(cycle, clearance))));
    };
    let begin = given.or_else(|| Some(rough.steps.first()?.at)).unwrap_or(first(cycle, clearance));
    let film = match suits(USUAL, greatest) || !model.mesh.is_graded() {
        true => film,
        false => on_mesh_for(model, oil, greatest)?,
    };
    Ok((film, begin))
}

/// Whether a mesh drawn for one greatest eccentricity suits another one.
pub(crate) fn suits(drawn: f64, greatest: f64) -> bool {
    let ratio = ((1.0 - drawn) / (1.0 - greatest)).sqrt();
    ratio < ELSEWHERE && ratio > 1.0 / ELSEWHERE
}

/// The film of an orbit on its first mesh.
///
/// # Errors
/// The model does not become a film.
pub fn film_of_orbit(model: &Arc<Model>) -> Result<Film, CompileError> {
    on_mesh_for(model, &model.oil, USUAL)
}

/// A film whose mesh is fine enough all around for an eccentricity.
///
/// # Errors
/// The model does not become a film.
pub(crate) fn on_mesh_for(model: &Arc<Model>, oil: &Oil, eccentricity: f64) -> Result<Film, CompileError> {
    let position = Position { eccentricity, min_film_angle: 0.0, tilt: model.tilt };
    model.film_near(model.mesh.longest, &FilmState { position, oil: oil.clone() })
}

/// An orbit on the next coarser mesh, and its greatest eccentricity at an end; `None` where there is none.
fn rough(film: &Film, (model, cycle): (&oilwedge_scene::OrbitTable, &DutyCycle), watch: Watch) -> Option<(Orbit, f64)> {
    let fine = motion(film, model, cycle);
    let coarser = film.system.coarser.as_ref()?;
    let problem = coarser.problem(&film.problem);
    let motion = Motion { problem: &problem, system: &coarser.system, gap: Gap::of(&problem, &coarser.system), ..fine };
    // Where a map leads to the orbit one cycle is enough.
    let by_map = no_map(&film.model).is_none().then(|| by_short_map(film, cycle)).flatten();
    let options = OrbitOptions {
        tolerance: ROUGH,
        closure: model.closure,
        cycles: if by_map.is_some() { 1 } else { ROUGH_CYCLES },
        deadline: watch.deadline,
        observer: watch.observer.map(|observer| observer as &dyn OrbitObserver),
    };
    if let Some(observer) = watch.observer {
        observer.turns_to("the orbit on a coarser mesh");
    }
    let bearing = &film.problem.bearing;
    let begin = by_map.unwrap_or(first(cycle, bearing.clearance));
    let orbit = motion.orbit(begin, &options).ok()?;
    let gaps = orbit.steps.iter().map(|step| {
        let journal = motion.coordinates().placed(&film.problem.journal, step.at);
        motion.gap.least(&journal)
    });
    let greatest = 1.0 - gaps.fold(f64::INFINITY, f64::min) / bearing.clearance;
    Some((orbit, greatest.clamp(0.0, GREATEST)))
}

/// Where the orbit by the short-film map begins [m]; `None` where it leads nowhere.
fn by_short_map(film: &Film, cycle: &DutyCycle) -> Option<Vector> {
    let bearing = film.problem.bearing;
    let travel = Travel { map: &ShortMap, bearing, viscosity: film.problem.lubricant.viscosity, cycle };
    let [x, y, ..] = first(cycle, bearing.clearance);
    let orbit = travel.orbit([x, y], ROUGH, ROUGH, ROUGH_CYCLES)?;
    Some(orbit.steps.last()?.at)
}

/// A place towards the first load [m].
fn first(cycle: &DutyCycle, clearance: f64) -> Vector {
    let [x, y] = cycle.at(0.0).force;
    let force = x.hypot(y).max(f64::MIN_POSITIVE);
    [FIRST * clearance * x / force, FIRST * clearance * y / force, 0.0, 0.0]
}
