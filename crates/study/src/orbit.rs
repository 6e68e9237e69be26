//! The orbit of the journal: compiled from a scene, followed until it repeats, and measured.
//!
//! | file | what |
//! |---|---|
//! | `orbit/start.rs` | the mesh, and where the journal begins: from an orbit on a coarser mesh |
//! | `orbit/sample.rs` | the films along the orbit, measured, with their error bars at that place and velocity |
//! | `orbit/drift.rs` | what the errors of mesh and steps do to the orbit |
//! | `orbit/comparison.rs` | error bars of films that conserve their oil, by orbits on the vertices alone |
//!
//! **Source.** `docs/theory/orbits.md`.

mod comparison;
mod drift;
mod sample;
mod start;

use oilwedge_bearing::duty_cycle::PeriodicSpline;
use oilwedge_bearing::orbit::{Cycle, Motion, Orbit, OrbitEnd, OrbitOptions, Span, TiltSupport};
use oilwedge_scene::Scene;
use serde::Serialize;

use crate::compile_error::CompileError;
use crate::duty::DutyCycle;
use crate::film::Film;
use crate::no_answer::NoAnswer;
use crate::quantities::cycle_view::Sample;
use crate::quantities::{CycleView, Quantity, Row, over_cycle};
use crate::run_options::RunOptions;
use crate::solved::{Errors, Solved};

/// Where an orbit ends its search, as results have it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct OrbitFacts {
    /// Crank angle of a cycle [deg].
    pub period_deg: f64,
    /// Local error that a step might make [1].
    pub tolerance: f64,
    /// Whether the last two cycles agree.
    pub closed: bool,
    /// The cycles.
    pub cycles: Vec<CycleFacts>,
}

/// One cycle, as results have it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct CycleFacts {
    /// Distance between beginning and end, over the clearance [1].
    pub closure: f64,
    /// Steps made.
    pub steps: usize,
    /// Steps tried in vain.
    pub rejected: usize,
    /// Films solved.
    pub films: usize,
    /// Of films that conserve their oil: oil that lies elsewhere at the end, over all oil in the film [1].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub oil_closure: Option<f64>,
    /// Of films that conserve their oil: what is lost or made over the cycle, of the oil that passes or is held [1].
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
}

impl OrbitPath {
    /// A number over the crank angle [deg] on a smooth curve through its films; nothing where a film has none.
    pub fn curve(&self, row: &Row) -> Vec<[f64; 2]> {
        const POINTS: u32 = 720;
        let Some((end, angles)) = self.crank_angles.split_last() else {
            return Vec::new();
        };
        let value = |quantities: &Vec<Quantity>| Some([quantities.iter().find(|quantity| quantity.row == row)?.value]);
        let values: Option<Vec<[f64; 1]>> = self.quantities[..angles.len()].iter().map(value).collect();
        let spline = values.and_then(|values| PeriodicSpline::new(angles.to_vec(), values, *end).ok());
        let angle = |k: u32| end * f64::from(k) / f64::from(POINTS);
        spline.map_or(Vec::new(), |spline| {
            (0..=POINTS).map(|k| [angle(k), spline.at(angle(k))[0]]).collect()
        })
    }

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
pub(crate) struct Followed {
    /// The film where it is thinnest.
    pub(crate) solved: Solved,
    /// The numbers of the cycle.
    pub(crate) quantities: Vec<Quantity>,
    /// The cycles.
    pub(crate) facts: OrbitFacts,
    /// The last cycle.
    pub(crate) path: OrbitPath,
    /// Greatest residual of the equation of motion, over the peak of the load [1].
    pub(crate) residual: f64,
    /// How it ended.
    pub(crate) end: OrbitEnd,
    /// Seconds of the integration, and of measuring.
    pub(crate) seconds: [f64; 2],
}

/// Follows the orbit of a scene.
///
/// # Errors
/// The scene does not become a film.
pub(crate) fn follow(
    scene: &Scene,
    model: &oilwedge_scene::Orbit,
    options: &RunOptions,
) -> Result<(Film, Result<Followed, NoAnswer>), CompileError> {
    let deadline = options.deadline();
    let cycle = start::load_over_cycle(scene)?;
    let (film, begin) = start::prepared(scene, model, &cycle, deadline)?;
    let clock = std::time::Instant::now();
    let motion = motion(&film, scene, model, &cycle);
    let orbit_options = OrbitOptions {
        tolerance: model.tolerance,
        closure: model.closure,
        cycles: model.cycles,
        deadline,
        observer: options
            .observer
            .map(|observer| observer as &dyn oilwedge_bearing::orbit::OrbitObserver),
    };
    let outcome = motion.orbit(begin, &orbit_options).map_err(NoAnswer::Orbit);
    let integrating = clock.elapsed().as_secs_f64();
    // What such a film is off by depends on what it has held all along, not on its place alone.
    let by_comparison = film.problem.cavitation.conserves_oil();
    let errors = match by_comparison {
        true => Errors::Omitted,
        false => options.errors(),
    };
    let mut followed = outcome.and_then(|orbit| measured(&film, &motion, model, orbit, errors));
    if let Ok(found) = &mut followed
        && by_comparison
        && options.errors() == Errors::Estimated
    {
        comparison::judge(&motion, (&film, model), begin, orbit_options, &mut found.quantities);
    }
    let followed = followed.map(|followed| Followed {
        seconds: [integrating, clock.elapsed().as_secs_f64() - integrating],
        ..followed
    });
    Ok((film, followed))
}

/// The equation of motion of a scene's journal on a film.
fn motion<'a>(film: &'a Film, scene: &Scene, model: &oilwedge_scene::Orbit, cycle: &'a DutyCycle) -> Motion<'a> {
    Motion {
        problem: &film.problem,
        system: &film.system,
        cycle,
        support: scene.tilting().map(|tilting| TiltSupport {
            stiffness: tilting.support.map_or(0.0, |support| support.tilt_stiffness),
            slope: tilting.support.map_or([0.0; 2], |support| support.tilt),
        }),
        mass: model.mass,
    }
}

/// The numbers of an orbit.
fn measured(
    film: &Film,
    motion: &Motion,
    model: &oilwedge_scene::Orbit,
    orbit: Orbit,
    errors: Errors,
) -> Result<Followed, NoAnswer> {
    let Orbit { mut steps, cycles, end } = orbit;
    let mut samples = sample::samples(film, motion, &steps, errors)?;
    sample::refine_peak(film, motion, &mut steps, &mut samples, errors)?;
    drift::carry(&steps, &mut samples, end);
    let path: Vec<Span> = steps.windows(2).map(|pair| Span::between(&pair[0], &pair[1])).collect();
    let (_, peak) = motion.cycle.summary().peak;
    let samples: Vec<Sample> = samples.into_iter().map(|sampled| sampled.sample).collect();
    let view = CycleView {
        samples: &samples,
        path: &path,
        bearing: film.problem.bearing,
        coordinates: motion.coordinates(),
        angular_speed: motion.cycle.angular_speed(),
        peak_load: peak[0].hypot(peak[1]),
    };
    let (_, thinnest_at) = view.thinnest();
    let around = path.iter().position(|span| span.times[1] >= thinnest_at);
    let from = around.or(path.len().checked_sub(1)).map(|k| (&steps[k], path[k]));
    let solved = sample::solved_at(film, motion, from, thinnest_at, errors)?;
    let clearance = film.problem.bearing.clearance;
    Ok(Followed {
        solved,
        quantities: over_cycle(&view),
        facts: OrbitFacts {
            period_deg: motion.cycle.period().to_degrees(),
            tolerance: model.tolerance,
            closed: end == OrbitEnd::Closed,
            cycles: cycles.iter().map(|cycle| facts(cycle, clearance)).collect(),
        },
        path: OrbitPath {
            crank_angles: samples
                .iter()
                .map(|sample| (view.angular_speed * sample.time).to_degrees())
                .collect(),
            times: samples.iter().map(|sample| sample.time).collect(),
            offsets: samples
                .iter()
                .map(|sample| sample.journal.offset.map(|part| part / clearance))
                .collect(),
            quantities: samples.iter().map(Sample::judged).collect(),
            clearance,
            spans: path,
        },
        residual: steps.iter().map(|step| step.residual).fold(0.0, f64::max),
        end,
        seconds: [0.0; 2],
    })
}

fn facts(cycle: &Cycle, clearance: f64) -> CycleFacts {
    CycleFacts {
        closure: cycle.closure / clearance,
        steps: cycle.steps,
        rejected: cycle.rejected,
        films: cycle.films,
        oil_closure: cycle.oil.map(|oil| oil.closure),
        oil_imbalance: cycle.oil.map(|oil| oil.imbalance),
    }
}
