//! The orbit of a scene by maps of its film, beside the orbit of the film itself.

use std::sync::Arc;
use std::time::Instant;

use oilwedge_bearing::Coordinates;
use oilwedge_bearing::duty_cycle::DutyCycle;
use oilwedge_bearing::mobility::{FilmMap, FiniteMap, MapOrbit, ShortMap, Travel};
use oilwedge_bearing::orbit::Span;
use oilwedge_reynolds::lubricant::PressureLaw;
use oilwedge_reynolds::{Bearing, Gap, JournalState, Theory};
use serde::{Deserialize, Serialize};

use super::OrbitPath;
use super::start::on_mesh_for;
use crate::compile_error::CompileError;
use crate::effects::PressureRule;
use crate::model::Model;
use crate::quantities::cycle_view::Sample;
use crate::quantities::{CycleView, Quantity, over_cycle};

/// Error that a step by a map may make, over the least film: maps cost little.
const TOLERANCE: f64 = 1e-6;
/// A cycle is closed to this part of the clearance, or the last of so many.
const CLOSURE: f64 = 1e-6;
const CYCLES: usize = 4;
/// The map of the finite film reaches so much of the way from the greatest eccentricity of the orbit to the wall.
const ROOM: f64 = 0.5;
/// Orbits are compared at so many crank angles of the cycle.
const COMPARED: u32 = 1440;

/// The orbit by one map.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ByMap {
    /// `short` or `finite`.
    pub map: String,
    /// Greatest distance from the orbit of the film at the same crank angle, over the clearance [1].
    pub distance: f64,
    /// Greatest difference of the least film from that of the film at the same crank angle, over the latter [1].
    pub film_difference: f64,
    /// Films that the map took.
    pub films: usize,
    /// Wall time of the map [s].
    pub map_seconds: f64,
    /// Wall time of the orbit by it [s].
    pub orbit_seconds: f64,
    /// Distance between beginning and end of the last cycle, over the clearance [1].
    pub closure: f64,
    /// Numbers of the cycle that a path alone has: least film and where it is; not in JSON.
    #[serde(skip)]
    pub quantities: Vec<Quantity>,
}

/// Why no map stands for the film of a model; `None`: one does.
pub fn no_map(model: &Model) -> Option<&'static str> {
    let (outline, sockets, scope) = (&model.mesh.outline, &model.sockets, &model.scope);
    let cavity = sockets.cavitation.pressure();
    let is_constant = sockets.pressure_rule == PressureRule::Fixed(PressureLaw::Constant);
    let reasons = [
        (scope.orbit.is_none(), "the scene has no [orbit]"),
        (outline.liner.arc.is_some(), "the bearing is an arc"),
        (outline.film_start.is_some(), "the film has a start (bearing.film_start)"),
        (!outline.feeds.is_empty(), "the bearing has feeds"),
        (sockets.theory == Theory::Long, "the bearing is a long one"),
        (scope.can_tilt, "the journal tilts"),
        (!scope.is_circular, "bore or shaft are no circles"),
        (scope.touches, "the surfaces touch"),
        (scope.is_turbulent, "the film is turbulent"),
        (scope.gives_way, "the liner gives way"),
        (scope.orbit.is_some_and(|orbit| orbit.mass > 0.0), "the rotor has a mass"),
        (!is_constant, "the viscosity depends on the pressure"),
        (!scope.cavitation.drops_pressures(), "the cavitation model is neither guembel nor reynolds"),
        (cavity != Some(model.mesh.bearing.end_pressure), "the cavity has another pressure than the ends"),
    ];
    reasons.into_iter().find_map(|(is_so, reason)| is_so.then_some(reason))
}

/// The orbit of a model by the short-film map and by the map of its own film, beside the `path` of that film.
///
/// # Errors
/// The model does not become a film, or the reason why a map does not exist or leads nowhere.
pub fn by_maps(model: &Arc<Model>, path: &OrbitPath) -> Result<Vec<Result<ByMap, String>>, CompileError> {
    let Some(cycle) = &model.duty else { return Ok(Vec::new()) };
    let beside = Beside { bearing: model.mesh.bearing, cycle, path };
    let short = beside.by("short", &ShortMap, 0, 0.0);
    let clock = Instant::now();
    let greatest = 1.0 - ROOM * (1.0 - path.greatest_eccentricity());
    let film = on_mesh_for(model, &model.oil, greatest)?;
    let finite = FiniteMap::new(&film.problem, &film.system, greatest)
        .map_err(|reason| reason.to_string())
        .and_then(|map| beside.by("finite", &map, map.films, clock.elapsed().as_secs_f64()));
    Ok(vec![short, finite])
}

impl OrbitPath {
    /// Greatest eccentricity on the path between films [1].
    fn greatest_eccentricity(&self) -> f64 {
        let end = self.crank_angles.last().copied().unwrap_or(0.0);
        let places = (0..COMPARED).filter_map(|k| self.place(end * f64::from(k) / f64::from(COMPARED)));
        places.map(|[x, y, ..]| x.hypot(y) / self.clearance).fold(0.0, f64::max)
    }
}

/// What orbits by maps have in common.
struct Beside<'a> {
    bearing: Bearing,
    cycle: &'a DutyCycle,
    path: &'a OrbitPath,
}

impl Beside<'_> {
    fn by(&self, name: &'static str, map: &dyn FilmMap, films: usize, seconds: f64) -> Result<ByMap, String> {
        let clock = Instant::now();
        let travel = Travel { map, bearing: self.bearing, viscosity: self.path.viscosity, cycle: self.cycle };
        let begin = self.path.place(0.0).unwrap_or_default();
        let orbit = travel
            .orbit([begin[0], begin[1]], TOLERANCE, CLOSURE, CYCLES)
            .ok_or("no step of the orbit by the map leads on")?;
        let travelling = clock.elapsed().as_secs_f64();
        let found = self.path_of(&orbit);
        let end = found.crank_angles.last().copied().unwrap_or(0.0);
        let (mut distance, mut film_difference) = (0.0_f64, 0.0_f64);
        for k in 0..COMPARED {
            let angle = end * f64::from(k) / f64::from(COMPARED);
            if let (Some(a), Some(b)) = (self.path.place(angle), found.place(angle)) {
                let film = |at: [f64; 4]| self.bearing.clearance - at[0].hypot(at[1]);
                distance = distance.max((a[0] - b[0]).hypot(a[1] - b[1]) / self.bearing.clearance);
                film_difference = film_difference.max((film(b) / film(a) - 1.0).abs());
            }
        }
        Ok(ByMap {
            map: name.to_owned(),
            quantities: self.quantities(&found),
            distance,
            film_difference,
            films,
            map_seconds: seconds,
            orbit_seconds: travelling,
            closure: orbit.closure,
        })
    }

    fn path_of(&self, orbit: &MapOrbit) -> OrbitPath {
        let (clearance, speed) = (self.bearing.clearance, self.cycle.angular_speed());
        OrbitPath {
            crank_angles: orbit.steps.iter().map(|step| (speed * step.time).to_degrees()).collect(),
            times: orbit.steps.iter().map(|step| step.time).collect(),
            offsets: (orbit.steps.iter()).map(|step| [step.at[0] / clearance, step.at[1] / clearance]).collect(),
            quantities: Vec::new(),
            spans: orbit.steps.windows(2).map(|pair| Span::between(&pair[0], &pair[1])).collect(),
            clearance,
            viscosity: self.path.viscosity,
        }
    }

    /// The numbers that follow from a path.
    fn quantities(&self, path: &OrbitPath) -> Vec<Quantity> {
        let samples: Vec<Sample> = (path.times.iter())
            .map(|&time| Sample { time, journal: JournalState::default(), quantities: Vec::new(), drift: Vec::new() })
            .collect();
        let (_, peak) = self.cycle.summary().peak;
        over_cycle(&CycleView {
            samples: &samples,
            path: &path.spans,
            gap: &Gap::circular(self.bearing),
            wall: None,
            coordinates: Coordinates { order: 2, arm: 0.5 * self.bearing.length },
            angular_speed: self.cycle.angular_speed(),
            between: 0.0,
            peak_load: peak[0].hypot(peak[1]),
            deviation_scale: None,
        })
    }
}
