//! The orbit of the journal: compiled from a scene, followed until it repeats, and measured.
//!
//! | file | what |
//! |---|---|
//! | `orbit/start.rs` | the mesh, and where the journal begins: from an orbit on a coarser mesh |
//! | `orbit/frame.rs` | films at even crank angles, to be drawn |
//! | `orbit/temperature.rs` | the temperature at which the mean flow carries off the mean power |
//! | `orbit/temperatures.rs` | the temperatures across the films that balance the mean heat |
//! | `orbit/price.rs` | the processor time that it will take, estimated |
//! | `orbit/sample.rs` | the films along the orbit, measured, with their error bars at that place and velocity |
//! | `orbit/balances.rs` | oil and energy over the cycle |
//! | `orbit/by_map.rs` | the same by maps of the film |
//! | `orbit/drift.rs` | what the errors of mesh and steps do to the orbit |
//! | `orbit/comparison.rs` | error bars of films that conserve their oil, by orbits on the vertices alone |
//!
//! **Source.** `docs/theory/orbits.md`.

mod balances;
mod by_map;
mod comparison;
mod drift;
mod frame;
mod price;
mod sample;
mod start;
mod temperature;
mod temperatures;

use std::sync::Arc;

use oilwedge_bearing::coordinates::Vector;
use oilwedge_bearing::orbit::{Cycle, Motion, Orbit, OrbitEnd, OrbitOptions, PathStep, Span, TiltSupport};
use oilwedge_bearing::{Deadline, ThermalFlows};
use oilwedge_reynolds::film_thickness::Deflection;
use oilwedge_reynolds::quantities::heat_network::NodeNetwork;
use serde::{Deserialize, Serialize};

use balances::CycleBalances;
pub use by_map::{ByMap, by_maps, no_map};
pub(crate) use comparison::{compared, judge};
pub use frame::Frame;
pub use price::expected_seconds;
pub use start::film_of_orbit;
pub(crate) use start::{GREATEST, USUAL, on_mesh_for, suits};
use temperature::CycleTemperature;
pub(crate) use temperature::{BALANCED, add_temperature};

use crate::compile_error::CompileError;
use crate::film::Film;
use crate::model::Model;
use crate::no_answer::NoAnswer;
use crate::observer::Watch;
use crate::quantities::cycle_view::{Sample, WallOnPath};
use crate::quantities::{CycleView, Quantity, over_cycle};
use crate::run_options::RunOptions;
use crate::solved::{Errors, Solved};
use oilwedge_bearing::duty_cycle::DutyCycle;

/// Place at which an orbit ends its search, as results have it.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct OrbitFacts {
    /// Crank angle of a cycle [deg].
    pub period_deg: f64,
    /// Local error that a step might make [1].
    pub tolerance: f64,
    /// Whether the last two cycles agree.
    pub closed: bool,
    /// Complete cycles of earlier runs that were continued.
    pub earlier_cycles: usize,
    /// The cycles.
    pub cycles: Vec<CycleFacts>,
    /// Where the last cycle ended, over the clearance [1]: offset, and slopes times half of the bearing's length where
    /// the tilt is free.
    pub end: [f64; 4],
    /// Part of the load that turns at half the speed of the journal, over its mean magnitude [1].
    pub half_speed_share: f64,
}

/// One cycle, as results have it.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct CycleFacts {
    /// Distance between beginning and end, over the clearance [1]; on a shaft the greatest of all journals.
    pub closure: f64,
    /// Steps made.
    pub steps: usize,
    /// Steps tried in vain.
    pub rejected: usize,
    /// Films solved.
    pub films: usize,
    /// Oil that lies elsewhere at the end of the cycle, over all oil in the film [1]; of films that conserve their oil.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub oil_closure: Option<f64>,
    /// Oil that is lost or made over the cycle, of the oil that passes or is held [1]; of films that conserve their
    /// oil.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub oil_imbalance: Option<f64>,
}

/// The path of the journal over its last cycle.
#[derive(Debug, Clone, PartialEq)]
pub struct OrbitPath {
    /// Crank angle [deg] of each film.
    pub crank_angles: Vec<f64>,
    /// Time of each film [s].
    pub times: Vec<f64>,
    /// Offset of the journal over the clearance [1].
    pub offsets: Vec<[f64; 2]>,
    /// What was measured on each film.
    pub quantities: Vec<Vec<Quantity>>,
    /// The path from film to film: offsets [m].
    pub spans: Vec<Span>,
    /// Radial clearance [m].
    pub clearance: f64,
    /// Viscosity of the oil at the temperature of the films, without pressure [Pa s].
    pub viscosity: f64,
}

impl OrbitPath {
    /// Offsets of the journal [m] at a crank angle [deg]; none outside of the cycle.
    pub fn place(&self, crank_angle: f64) -> Option<[f64; 4]> {
        let next = self.crank_angles.partition_point(|angle| *angle <= crank_angle);
        let [from, to] = [next.checked_sub(1)?, next].map(|k| Some((*self.crank_angles.get(k)?, *self.times.get(k)?)));
        let ((angle, time), (next_angle, next_time)) = (from?, to?);
        let part = (crank_angle - angle) / (next_angle - angle);
        Some(self.spans.get(next - 1)?.at(time + part * (next_time - time)))
    }
}

/// An orbit followed and measured.
pub(crate) struct FollowedCycle {
    /// The film where it is thinnest.
    pub(crate) solved: Solved,
    /// The numbers of the cycle.
    pub(crate) quantities: Vec<Quantity>,
    /// The cycles.
    pub(crate) facts: OrbitFacts,
    /// The last cycle.
    pub(crate) path: OrbitPath,
    /// Films of the cycle, drawn.
    pub(crate) frames: Vec<Frame>,
    /// Greatest residual of the equation of motion, over the peak of the load [1].
    pub(crate) residual: f64,
    /// Oil and energy over the cycle.
    pub(crate) balances: CycleBalances,
    /// Mean of what heats and what cools the films; none without a balance of heat.
    pub(crate) flows: Option<ThermalFlows>,
    /// Mean of the films as networks of heat; none without temperatures across them.
    pub(crate) network: Option<NodeNetwork>,
    /// How the temperature was found; none where it is given.
    pub(crate) temperature: Option<CycleTemperature>,
    /// Whether the deadline has ended an orbit by which the bars of a film that conserves its oil are found.
    pub(crate) are_bars_ended: bool,
    /// The step at which the last cycle ended.
    pub(crate) last: Option<PathStep>,
    /// How it ended.
    pub(crate) end: OrbitEnd,
    /// Seconds of the integration, and of measuring.
    pub(crate) seconds: [f64; 2],
}

/// Follows the orbit of a model's journal under a load.
///
/// # Errors
/// The model does not become a film.
pub(crate) fn follow_under(
    model: &Arc<Model>,
    (orbit, cycle): (&oilwedge_scene::OrbitTable, &DutyCycle),
    options: &RunOptions,
) -> Result<(Film, Result<FollowedCycle, NoAnswer>), CompileError> {
    let watch = options.watch();
    let deadline = watch.deadline;
    if let Some(thermal) = model.sockets.thermal {
        return temperature::balanced((model, orbit, cycle), thermal, watch, options);
    }
    if let Some(heat) = &model.sockets.heat_field {
        return temperatures::balanced((model, orbit, cycle), heat, watch, options);
    }
    let (film, begin) = start::prepared(model, &model.oil, (orbit, cycle), watch)?;
    if let Some(observer) = options.observer {
        observer.expects(film.unknowns(), expected_seconds(&film));
        observer.turns_to("the orbit");
    }
    let clearance = film.problem.bearing.clearance;
    let begin = options.earlier.map_or(begin, |earlier| earlier.end.map(|part| clearance * part));
    let outcome = followed(&film, (orbit, cycle), (OrbitStart::At(begin), deadline), options);
    Ok((film, outcome))
}

/// Where an orbit begins.
#[derive(Debug, Clone, Copy)]
enum OrbitStart<'a> {
    /// At offsets [m].
    At(Vector),
    /// At the end of another one, which this is the last step of.
    After(&'a PathStep),
}

/// Orbits of one journal on one film after the other, by which a balance of heat is found: each begins where the one
/// before has closed.
struct OrbitSeries<'a> {
    /// Film of the first orbit, by which the others differ in temperature.
    film: Film,
    orbit: oilwedge_scene::OrbitTable,
    cycle: &'a DutyCycle,
    watch: Watch,
    /// Options of the orbits that only lead to the balance.
    options: RunOptions,
    /// Offsets at which the first orbit begins [m].
    begin: Vector,
    /// Last step of the orbit before; `None` before the first one.
    last: Option<PathStep>,
}

impl OrbitSeries<'_> {
    /// The next orbit, on a film like that of the series.
    ///
    /// # Errors
    /// [`NoAnswer`]: the film has no orbit.
    fn followed(&self, film: &Film, options: &RunOptions) -> Result<FollowedCycle, NoAnswer> {
        let begin = self.last.as_ref().map_or(OrbitStart::At(self.begin), OrbitStart::After);
        followed(film, (&self.orbit, self.cycle), (begin, self.watch.deadline), options)
    }
}

/// Follows the orbit of a film until a deadline, and measures it.
fn followed(
    film: &Film,
    (model, cycle): (&oilwedge_scene::OrbitTable, &DutyCycle),
    (begin, deadline): (OrbitStart, Deadline),
    options: &RunOptions,
) -> Result<FollowedCycle, NoAnswer> {
    let clock = std::time::Instant::now();
    let motion = motion(film, model, cycle);
    let orbit_options = OrbitOptions {
        tolerance: model.tolerance,
        closure: model.closure,
        cycles: model.cycles,
        deadline,
        observer: options.observer.map(|observer| observer as &dyn oilwedge_bearing::orbit::OrbitObserver),
    };
    let orbit = match begin {
        OrbitStart::At(begin) => motion.orbit(begin, &orbit_options),
        OrbitStart::After(step) => motion.orbit_after(step, &orbit_options),
    };
    let orbit = orbit.map_err(NoAnswer::Orbit)?;
    let last = orbit.steps.last().cloned();
    let begin = orbit.steps.first().map_or([0.0; 4], |step| step.at);
    if let Some(observer) = options.observer.filter(|_| options.bars) {
        observer.turns_to("the error bars of the orbit");
    }
    let integrating = clock.elapsed().as_secs_f64();
    // What a film that conserves its oil is off by depends on what it has held all along, not on its place alone.
    let by_comparison = film.problem.cavitation.conserves_oil();
    let of_films = RunOptions { bars: options.bars && !by_comparison, ..*options };
    let mut followed = measured(film, &motion, model, orbit, &of_films)?;
    if by_comparison && options.errors() == Errors::Estimated {
        followed.are_bars_ended =
            comparison::compare(&motion, (film, model), (begin, orbit_options), options, &mut followed.quantities);
    }
    Ok(FollowedCycle { last, seconds: [integrating, clock.elapsed().as_secs_f64() - integrating], ..followed })
}

/// The equation of motion of the journal on a film.
pub(crate) fn motion<'a>(film: &'a Film, model: &oilwedge_scene::OrbitTable, cycle: &'a DutyCycle) -> Motion<'a> {
    Motion {
        problem: &film.problem,
        system: &film.system,
        gap: film.gap(),
        cycle,
        support: (film.model.sockets.tilting)
            .map(|tilting| TiltSupport { stiffness: tilting.stiffness, slope: tilting.support }),
        mass: model.mass,
    }
}

/// The numbers of an orbit.
///
/// # Errors
/// [`NoAnswer`]: a film that the orbit had is not found again.
pub(crate) fn measured(
    film: &Film,
    motion: &Motion,
    model: &oilwedge_scene::OrbitTable,
    orbit: Orbit,
    options: &RunOptions,
) -> Result<FollowedCycle, NoAnswer> {
    let Orbit { mut steps, cycles, end } = orbit;
    let mut samples = sample::samples(film, motion, &steps, options)?;
    sample::refine_peak(film, motion, &mut steps, &mut samples, options)?;
    drift::carry(&steps, &mut samples, end);
    let order = motion.coordinates().order;
    drift::add_closure((&cycles, film.problem.bearing.clearance), &mut samples, order);
    let path: Vec<Span> = steps.windows(2).map(|pair| Span::between(&pair[0], &pair[1])).collect();
    let load = motion.cycle.summary();
    let (_, peak) = load.peak;
    let balances = balances::balances(motion, &path, &samples);
    let flows = balances::mean_flows(&samples);
    let network = balances::mean_heat(&samples);
    let samples: Vec<Sample> = samples.into_iter().map(|sampled| sampled.sample).collect();
    let walls: Option<Vec<Deflection>> = steps.iter().map(|step| step.wall.clone()).collect();
    let view = CycleView {
        samples: &samples,
        path: &path,
        gap: &motion.gap,
        wall: walls.map(|walls| WallOnPath { problem: &film.problem, system: &film.system, walls }),
        coordinates: motion.coordinates(),
        angular_speed: motion.cycle.angular_speed(),
        between: 0.0,
        peak_load: peak[0].hypot(peak[1]),
        deviation_scale: film.model.scope.deviation_scale,
    };
    let (_, thinnest_at) = view.thinnest();
    let around = |time: f64| {
        let holds = path.iter().position(|span| span.times[1] >= time);
        let at = holds.or(path.len().checked_sub(1))?;
        Some((&steps[at], path[at]))
    };
    let solved = sample::solved_at(film, motion, around(thinnest_at), thinnest_at, options.errors())?;
    let between = match (options.errors(), around(thinnest_at)) {
        (Errors::Estimated, Some(around)) => drift::between(motion, around, thinnest_at)?,
        _ => 0.0,
    };
    let view = CycleView { between, ..view };
    let period = path.last().map_or(0.0, |span| span.times[1]);
    let frames = frame::frames((film, motion), period, &around, options)?;
    let clearance = film.problem.bearing.clearance;
    Ok(FollowedCycle {
        solved,
        frames,
        quantities: over_cycle(&view),
        facts: OrbitFacts {
            period_deg: motion.cycle.period().to_degrees(),
            tolerance: model.tolerance,
            closed: end == OrbitEnd::Closed,
            earlier_cycles: options.earlier.map_or(0, |earlier| earlier.cycles),
            end: steps.last().map_or([0.0; 4], |step| step.at.map(|part| part / clearance)),
            cycles: cycles.iter().map(CycleFacts::of).collect(),
            half_speed_share: load.half_speed_share,
        },
        path: OrbitPath {
            crank_angles: samples.iter().map(|sample| (view.angular_speed * sample.time).to_degrees()).collect(),
            times: samples.iter().map(|sample| sample.time).collect(),
            offsets: samples.iter().map(|sample| sample.journal.offset.map(|part| part / clearance)).collect(),
            quantities: samples.iter().map(Sample::judged).collect(),
            clearance,
            viscosity: film.problem.lubricant.viscosity,
            spans: path,
        },
        residual: steps.iter().map(|step| step.residual).fold(0.0, f64::max),
        balances,
        flows,
        network,
        temperature: None,
        are_bars_ended: false,
        last: None,
        end,
        seconds: [0.0; 2],
    })
}

impl CycleFacts {
    pub(crate) fn of(cycle: &Cycle) -> Self {
        Self {
            closure: cycle.closure,
            steps: cycle.steps,
            rejected: cycle.rejected,
            films: cycle.films,
            oil_closure: cycle.oil.map(|oil| oil.closure),
            oil_imbalance: cycle.oil.map(|oil| oil.imbalance),
        }
    }
}
