//! The films along an orbit: solved once more at the places and velocities of its steps, measured, and judged as films
//! at given positions are.

use oilwedge_bearing::coordinates::{Vector, moved, unit};
use oilwedge_bearing::deflection::{displaced, hastened};
use oilwedge_bearing::orbit::{Instant, Motion, PathStep, Span};
use oilwedge_bearing::{InitialGuess, Stiffness, ThermalFlows};
use oilwedge_reynolds::quantities::heat_network::NodeNetwork;
use oilwedge_reynolds::quantities::load::load;
use oilwedge_reynolds::quantities::power::Power;
use oilwedge_reynolds::solve::Neighbour;
use oilwedge_reynolds::{JournalChange, NoFilm, SolvedFilm};
use rayon::prelude::*;

use crate::estimate::estimate_errors;
use crate::film::Film;
use crate::isothermal::isothermal;
use crate::measure::measure;
use crate::no_answer::NoAnswer;
use crate::quantities::cycle_view::Sample;
use crate::quantities::{Bar, PRESSURE_MAX, Quantity, View, measured};
use crate::run_options::RunOptions;
use crate::solved::{Errors, SolveOptions, Solved};
use crate::thermal;
use crate::thermal::flows::thermal_flows;

/// Films that are solved one after the other, each started from the one before; groups of them run side by side.
const GROUP: usize = 8;
/// The journal is moved by this part of the least gap, and its velocity changed by as much of the drag's, to see what a
/// number depends on.
const SMALL: f64 = 1e-4;
/// Films that are solved between steps to find the greatest pressure.
const PEAKS: usize = 3;
/// Tolerance to which they carry the load.
pub(super) const TOLERANCE: f64 = 1e-4;

/// A film on the orbit, and what the error of the orbit needs of it.
pub(super) struct Sampled {
    pub(super) sample: Sample,
    /// What errors need; none where they are not estimated.
    pub(super) tangents: Option<FilmTangents>,
    /// Powers of the film [W].
    pub(super) power: Power,
    /// Oil that enters less oil that leaves, over the oil that passes [1].
    pub(super) imbalance: f64,
    /// What heats and what cools it; none without a balance of heat.
    pub(super) flows: Option<ThermalFlows>,
    /// The film as a network of heat; none without temperatures across it.
    pub(super) network: Option<NodeNetwork>,
}

/// How a film answers to a journal elsewhere.
pub(super) struct FilmTangents {
    /// `K`, that of the support included [N/m].
    pub(super) stiffness: Stiffness,
    /// `C` [N s/m].
    pub(super) damping: Stiffness,
    /// Force of the film whose numbers are reported, less that by which the orbit was followed [N].
    pub(super) defect: Vector,
    /// Change of each number for each coordinate [1/m].
    pub(super) by_offset: Vec<Vector>,
    /// Change of each number for the rate of each coordinate [s/m].
    pub(super) by_rate: Vec<Vector>,
}

/// The films of the steps.
///
/// # Errors
/// [`NoAnswer`]: a film that the orbit had is not found again.
pub(super) fn samples(
    film: &Film,
    motion: &Motion,
    steps: &[PathStep],
    options: &RunOptions,
) -> Result<Vec<Sampled>, NoAnswer> {
    let groups: Result<Vec<Vec<Sampled>>, NoAnswer> = (steps.par_chunks(GROUP))
        .map(|group| {
            let mut before: Option<SolvedFilm> = None;
            let mut sampled = Vec::with_capacity(group.len());
            for step in group {
                let near = before.as_ref().map_or(Neighbour::None, Neighbour::Start);
                let instant = motion.film_at(step, near)?;
                let (one, solved) = sample(film, motion, instant, options.errors())?;
                sampled.push(one);
                before = Some(solved);
            }
            Ok(sampled)
        })
        .collect();
    Ok(groups?.into_iter().flatten().collect())
}

/// Adds films where the pressure is greatest between steps.
///
/// # Errors
/// [`NoAnswer`]: there is no film there.
pub(super) fn refine_peak(
    film: &Film,
    motion: &Motion,
    steps: &mut Vec<PathStep>,
    samples: &mut Vec<Sampled>,
    options: &RunOptions,
) -> Result<(), NoAnswer> {
    for _ in 0..PEAKS {
        let Some(time) = peak(samples) else { return Ok(()) };
        let next = steps.partition_point(|step| step.time < time);
        if next == 0 || next >= steps.len() {
            return Ok(());
        }
        let span = Span::between(&steps[next - 1], &steps[next]);
        let instant = (motion.between(&steps[next - 1], &span, time, TOLERANCE)).map_err(NoAnswer::Orbit)?;
        let step = PathStep { until_next: steps[next - 1].until_next, ..PathStep::of(&instant, 0.0) };
        let (one, _) = sample(film, motion, instant, options.errors())?;
        steps.insert(next, step);
        samples.insert(next, one);
    }
    Ok(())
}

/// Time [s] at which the parabola through the greatest pressure and its neighbours is greatest; none at the ends of the
/// cycle, or near a film.
fn peak(samples: &[Sampled]) -> Option<f64> {
    const NEAR: f64 = 0.02;
    let pressure = |sampled: &Sampled| sampled.sample.value(&PRESSURE_MAX);
    let best = (1..samples.len().checked_sub(1)?).max_by(|&a, &b| {
        let [a, b] = [a, b].map(|k| pressure(&samples[k]).unwrap_or(f64::NEG_INFINITY));
        a.total_cmp(&b)
    })?;
    let [before, here, after] = [best - 1, best, best + 1].map(|k| &samples[k]);
    let [p_0, p_1, p_2] = [pressure(before)?, pressure(here)?, pressure(after)?];
    let [back, on] = [before, after].map(|other| other.sample.time - here.sample.time);
    let [rise, fall] = [(p_0 - p_1) / back, (p_2 - p_1) / on];
    let bend = (fall - rise) / (on - back);
    let way = 0.5 * (back - rise / bend);
    let is_near = way.abs() < NEAR * (on - back);
    (bend < 0.0 && way > back && way < on && !is_near).then_some(here.sample.time + way)
}

/// The film at a time of the orbit, with its reference.
///
/// # Errors
/// [`NoAnswer`]: there is none.
pub(super) fn solved_at(
    film: &Film,
    motion: &Motion,
    from: Option<(&PathStep, Span)>,
    time: f64,
    errors: Errors,
) -> Result<Solved, NoAnswer> {
    let Some((step, span)) = from else {
        let film = film.with_journal(motion.journal(time, [0.0; 4], [0.0; 4]));
        let options = SolveOptions { errors, ..SolveOptions::default() };
        return isothermal(&film, &options);
    };
    let instant = (motion.between(step, &span, time, TOLERANCE)).map_err(NoAnswer::Orbit)?;
    let guess = match instant.oil {
        Some(_) => InitialGuess::Near(Neighbour::Start(&instant.film)),
        None => InitialGuess::default(),
    };
    let options = SolveOptions { errors, guess, ..SolveOptions::default() };
    isothermal(&film.at_instant(&instant), &options)
}

/// One film, measured; and solved, for the next one to start from.
fn sample(film: &Film, motion: &Motion, instant: Instant, errors: Errors) -> Result<(Sampled, SolvedFilm), NoAnswer> {
    let time = instant.time;
    let tangents = match errors {
        Errors::Estimated => Some(motion.slow_tangents(&instant)?),
        Errors::Omitted => None,
    };
    let here = film.at_instant(&instant);
    let guess = InitialGuess::Near(Neighbour::Start(&instant.film));
    let options = SolveOptions { errors, guess, ..SolveOptions::default() };
    let solved = isothermal(&here, &options)?;
    let estimated = estimate_errors(&solved);
    // The film by which the orbit was followed.
    let followed = here.solved_by(solved.primary.solution);
    let quantities = match errors {
        Errors::Estimated => with_forces_of_path(&here, &followed, estimated.quantities),
        Errors::Omitted => estimated.quantities,
    };
    let flows = (film.model.sockets.thermal.as_ref()).map(|model| thermal_flows(model, &here, &estimated.measured));
    let network = film.model.sockets.heat_field.as_ref().map(|model| model.surroundings.network(&followed));
    let network = network.transpose().map_err(|reason| thermal::field::none(reason.into()))?;
    let (power, imbalance) = (estimated.measured.power, estimated.measured.flows.imbalance);
    let tangents = match tangents {
        None => None,
        Some([stiffness, damping]) => {
            let carried = estimated.measured.load.total.resultant();
            let [x, y, z_x, z_y] = motion.coordinates().forces(&carried);
            let quadratic = motion.coordinates().forces(&load(&followed).total.resultant());
            let [by_offset, by_rate] = sensitivities(motion, &here, &followed, &quantities)?;
            Some(FilmTangents {
                stiffness,
                damping,
                defect: moved([x, y, z_x, z_y], -1.0, quadratic),
                by_offset,
                by_rate,
            })
        }
    };
    let sample = Sample { time, journal: here.problem.journal, quantities, drift: Vec::new() };
    let sampled = Sampled { sample, tangents, power, imbalance, flows, network };
    Ok((sampled, followed))
}

/// The quantities of a film with what it carries replaced by the forces of the film by which the orbit was followed:
/// these balance the load. Their bars are those of the path.
fn with_forces_of_path(film: &Film, followed: &SolvedFilm, mut quantities: Vec<Quantity>) -> Vec<Quantity> {
    let of_path = measure(followed);
    let of_path = measured(&View::new(film, &film.problem, &of_path));
    for quantity in quantities.iter_mut().filter(|quantity| quantity.row.error.is_of_load()) {
        let Some(balanced) = of_path.iter().find(|other| other.name == quantity.name) else {
            continue;
        };
        quantity.value = balanced.value;
        quantity.set_bar(quantity.bar.map(|_| Bar::default()));
    }
    quantities
}

/// How a film moves with its journal, as place or as rate.
type Moved = fn(&SolvedFilm, &JournalChange) -> Result<SolvedFilm, NoFilm>;

/// Change of each number for each coordinate of the journal, and for its rate.
fn sensitivities(
    motion: &Motion,
    film: &Film,
    followed: &SolvedFilm,
    quantities: &[Quantity],
) -> Result<[Vec<Vector>; 2], NoAnswer> {
    let values = |solved: &SolvedFilm| measured(&View::new(film, &solved.problem, &measure(solved)));
    let base = values(followed);
    let journal = film.problem.journal;
    let bearing = &film.problem.bearing;
    let gap = SMALL * motion.gap.least(&journal);
    let rate = SMALL * journal.speed.abs().max(motion.cycle.angular_speed()) * bearing.clearance;
    let coordinates = motion.coordinates();
    let column = |k: usize, size: f64, moved: Moved| -> Result<Vec<f64>, NoAnswer> {
        let along = unit(k).map(|part| size * part);
        let change = coordinates.change(&journal, &oilwedge_reynolds::CentreVelocity::default(), along);
        let there = values(&moved(followed, &change)?);
        let value = |list: &[Quantity], name: &str| list.iter().find(|it| it.name == name).map(|it| it.value);
        let per = |quantity: &Quantity| {
            let name = &*quantity.name;
            let change = value(&there, name)
                .zip(value(&base, name))
                .map_or(0.0, |(there, here)| quantity.row.difference(there, here));
            change / size
        };
        Ok(quantities.iter().map(per).collect())
    };
    let all = |size: f64, moved: Moved| -> Result<Vec<Vector>, NoAnswer> {
        let mut vectors = vec![[0.0; 4]; quantities.len()];
        for k in 0..coordinates.order {
            for (vector, part) in vectors.iter_mut().zip(column(k, size, moved)?) {
                vector[k] = part;
            }
        }
        Ok(vectors)
    };
    Ok([all(gap, displaced)?, all(rate, hastened)?])
}
