//! One step in time: its stages, and the estimate of its error.

use std::sync::Arc;

use oilwedge_reynolds::CentreVelocity;

use super::journals::Journals;
use super::motion::Instant;
use super::oil::StoredOil;
use super::scheme::Scheme;
use super::stage::{NoStage, Stage, StageHistory, StageTolerance, of_journal};
use super::wall::{WallPath, WallStages};
use crate::coordinates::{Vector, moved};
use crate::deflection::{WallResidual, contact_points};
use crate::newton::Damping;
use crate::search::Trial;
use crate::shaft::joined::all_moved;
use crate::stiffness::Stiffness;
use crate::together::JournalResponse;

/// Accuracy of the linear systems of the damped error.
const FOLLOWED: f64 = 1e-3;

/// A step that was made.
#[derive(Debug)]
pub(super) struct Made {
    /// End of the step.
    pub(super) end: Vec<Instant>,
    /// The accelerations of rotors with mass there [m/s2].
    pub(super) accelerations: Vec<Vector>,
    /// Estimates of the local errors of the offsets [m], as films and shaft damp them.
    pub(super) errors: Vec<Vector>,
    /// How far the path passes the places of the first stage, over the least gaps there [1].
    pub(super) off_path: f64,
}

/// Where a step begins.
#[derive(Clone, Copy)]
pub(super) struct StepStart<'a> {
    /// The journals there.
    pub(super) instants: &'a [Instant],
    /// The accelerations of rotors with mass [m/s2].
    pub(super) accelerations: &'a [Vector],
    /// The paths before; none at the beginning.
    pub(super) before: Option<&'a [WallPath]>,
}

/// What the first stage of a step has found.
struct FirstStage {
    time: f64,
    places: Vec<Vector>,
    /// Least gaps [m].
    gaps: Vec<f64>,
}

/// What the stages of a step have found of one journal.
pub(super) struct Course {
    start: Vector,
    velocity: Vector,
    rates: Vec<Vector>,
    accelerations: Vec<Vector>,
    oils: Vec<Arc<StoredOil>>,
    walls: Option<WallStages>,
}

impl Course {
    pub(super) fn from(start: &Instant, acceleration: Vector) -> Self {
        Self {
            start: start.at,
            velocity: start.velocity,
            rates: vec![start.velocity],
            accelerations: vec![acceleration],
            oils: start.oil.iter().cloned().collect(),
            walls: WallStages::from(start),
        }
    }

    /// What it leaves to stage number `stage` of a step of the length `dt` [s], which ends at a `time` [s] on the way.
    pub(super) fn known(
        &self,
        (scheme, stage): (&Scheme, usize),
        dt: f64,
        (way, time): (Option<&WallPath>, f64),
    ) -> StageHistory {
        let so_far = |first: Vector, rates: &[Vector]| combined(first, dt, &scheme.coefficients[stage][..stage], rates);
        StageHistory {
            offset: so_far(self.start, &self.rates),
            rate: so_far(self.velocity, &self.accelerations),
            before: self.oils.first().map(|oil| oil.before(scheme, stage, dt, &self.oils)),
            wall: (self.walls.as_ref()).map(|walls| walls.stage((scheme, stage), dt, (way, time))),
        }
    }

    /// Adds a stage that was found.
    pub(super) fn add(&mut self, known: &StageHistory, per_time: f64, found: &Instant) {
        self.rates.push(found.velocity);
        self.accelerations.push([0, 1, 2, 3].map(|k| (found.velocity[k] - known.rate[k]) * per_time));
        self.oils.extend(found.oil.clone());
        if let Some(walls) = &mut self.walls {
            walls.add(found);
        }
    }
}

impl Journals<'_> {
    /// A step of the length `dt` [s].
    pub(super) fn step(
        &self,
        from: StepStart,
        dt: f64,
        accuracy: StageTolerance,
        films: &mut usize,
    ) -> Result<Made, NoStage> {
        let scheme = self.scheme();
        let per_time = 1.0 / (scheme.diagonal * dt);
        let begun = from.instants[0].time;
        let journals = from.instants.iter().zip(from.accelerations);
        let mut courses: Vec<Course> =
            journals.map(|(start, acceleration)| Course::from(start, *acceleration)).collect();
        let mut latest: Option<Vec<Instant>> = None;
        let mut first: Option<FirstStage> = None;
        let mut ways: Option<Vec<WallPath>> = from.before.map(<[WallPath]>::to_vec);
        let mut last: Option<Stage> = None;
        for stage in 1..scheme.stages() {
            let time = begun + dt * scheme.nodes[stage];
            let way = |number: usize| ways.as_ref().map(|ways| &ways[number]);
            let journals = courses.iter().enumerate();
            let known = journals.map(|(number, course)| course.known((scheme, stage), dt, (way(number), time)));
            let known = Stage { time, per_time, journals: known.collect() };
            let guess = |(number, start): (usize, &Instant)| match way(number) {
                Some(way) => way.span.at(time),
                None => combined(start.at, dt * scheme.nodes[stage], &[1.0], &[start.velocity]),
            };
            let guesses: Vec<Vector> = from.instants.iter().enumerate().map(guess).collect();
            let is_nearer = |latest: &&Vec<Instant>| (latest[0].time - time).abs() < (begun - time).abs();
            let near = latest.as_ref().filter(is_nearer).map_or(from.instants, |latest| latest);
            let is_last = stage + 1 == scheme.stages();
            let balanced = if is_last { accuracy.balanced.min(self.balanced_at_steps()) } else { accuracy.balanced };
            let accuracy = StageTolerance { balanced, ..accuracy };
            let found = self.stage(&known, &guesses, (near, Damping::None), accuracy, films)?;
            for ((course, known), found) in courses.iter_mut().zip(&known.journals).zip(&found) {
                course.add(known, per_time, found);
            }
            first.get_or_insert_with(|| FirstStage {
                time,
                places: found.iter().map(|found| found.at).collect(),
                gaps: self.gaps(found.iter().map(Instant::under_wall)),
            });
            if latest.as_ref().is_none_or(|latest| latest[0].time < time) {
                ways = Some(ways_between(from.instants, &found));
            }
            (latest, last) = (Some(found), Some(known));
        }
        // The last stage is the end of the step.
        let ((end, last), first) = latest.zip(last).zip(first).ok_or(NoStage::Diverged)?;
        let errors = self.damped(&end, &last, &courses, (scheme, dt))?;
        let path = ways_between(from.instants, &end);
        let off = path.iter().zip(&first.places).map(|(way, place)| moved(way.span.at(first.time), -1.0, *place));
        let off_path = Self::greatest_part(off, &first.gaps);
        let accelerations = courses.iter().filter_map(|course| course.accelerations.last().copied()).collect();
        Ok(Made { end, accelerations, errors, off_path })
    }

    /// `(m/(gamma dt)^2 + C/(gamma dt) + K)^-1 (m/(gamma dt) + C)/(gamma dt)` times the errors of all journals: what
    /// stiffness leaves of them. The error of a wall pushes the film as its rate in the stage does.
    fn damped(
        &self,
        end: &[Instant],
        stage: &Stage,
        courses: &[Course],
        (scheme, dt): (&Scheme, f64),
    ) -> Result<Vec<Vector>, NoStage> {
        // Forces are relative to nothing here.
        let searches = self.searches(stage, StageTolerance::of(1.0, 1.0));
        let per_time = stage.per_time;
        let (mut forces, mut responses) = (Vec::new(), Vec::new());
        for (number, (search, here)) in searches.iter().zip(end).enumerate() {
            let course = &courses[number];
            let error = combined([0.0; 4], dt, &scheme.error_weights(), &course.rates);
            let of_wall = course.walls.as_ref().map_or_else(Vec::new, |walls| walls.error(scheme, dt));
            let answer = || {
                let left = contact_points(&here.film.problem, search.system);
                let left = WallResidual::of(&here.film, left);
                let trial = Trial::of(here.film.clone(), Default::default());
                let tangents = search.tangents(&trial, &trial.film, &left, (FOLLOWED, 0.0))?;
                let along =
                    search.coordinates.change(&here.film.problem.journal, &CentreVelocity::default(), error).as_rate();
                let (by_film, bent) = tangents.pushed(&along, &of_wall)?;
                let masses = self.motions[number].masses();
                let force: Vector = [0, 1, 2, 3].map(|k| per_time * (by_film[k] + masses[k] * per_time * error[k]));
                let bent: Vec<f64> = bent.iter().map(|bent| -per_time * bent).collect();
                match self.shaft {
                    None => Ok((tangents.solve(force, Some(&bent))?.place, None)),
                    Some(_) => Ok((force, Some(JournalResponse::of(&tangents, search.coordinates.order, &bent)?))),
                }
            };
            let (force, response) = of_journal(number, answer())?;
            forces.push(force);
            responses.extend(response);
        }
        let Some(drive) = &self.shaft else {
            return Ok(forces);
        };
        let balance = drive.balance(stage.time);
        let slopes: Vec<Stiffness> = responses.iter().map(|response| response.stiffness).collect();
        let closing: Vec<Vector> = responses.iter().map(|response| response.carried).collect();
        let wanted = balance.by_films(&all_moved(&forces, -1.0, &closing));
        balance.solve(&slopes, &wanted).ok_or(NoStage::Diverged)
    }
}

/// The ways of all journals from one time to another.
pub(super) fn ways_between(from: &[Instant], to: &[Instant]) -> Vec<WallPath> {
    from.iter().zip(to).map(|(from, to)| WallPath::between(from, to)).collect()
}

/// `first + dt sum_j weight_j rate_j`.
fn combined(first: Vector, dt: f64, weights: &[f64], rates: &[Vector]) -> Vector {
    let sum = |k: usize| weights.iter().zip(rates).map(|(weight, rate)| weight * rate[k]).sum::<f64>();
    [0, 1, 2, 3].map(|k| first[k] + dt * sum(k))
}
