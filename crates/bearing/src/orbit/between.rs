//! The film between two steps of an orbit.

use oilwedge_reynolds::NoFilm;
use oilwedge_reynolds::solve::Neighbour;

use super::journals::Journals;
use super::motion::{Held, Instant, Motion, Moving};
use super::no_orbit::NoOrbit;
use super::path::{Between, PathStep, Span};
use super::stage::{NoStage, StageTolerance, of_journal};
use super::step::{Course, StepStart};

impl Motion<'_> {
    /// Whether the velocity of the journal between a step and the next is that of the path.
    pub fn moves_by_path(&self, from: &PathStep) -> bool {
        self.mass > 0.0 || from.until_next == Between::Path
    }

    /// The film at a time within a span of the orbit that begins with the step `from`, at the place of the path. The
    /// journal has the velocity at which the film carries the load or, with mass and on a shaft, that of the path. A
    /// film that conserves its oil, or whose wall gives way, is led on from the step.
    ///
    /// # Errors
    /// [`NoOrbit`]: there is no such film.
    pub fn between(&self, from: &PathStep, span: &Span, time: f64, tolerance: f64) -> Result<Instant, NoOrbit> {
        let (at, velocity) = (span.at(time), span.rate(time));
        let accuracy = StageTolerance::of(tolerance, self.peak_load());
        let has_memory = from.history.is_some() || from.wall.is_some();
        let found = match from.until_next {
            Between::Path if has_memory => self.led_along(from, span, time),
            Between::Load if has_memory => self.led_on(from, time, accuracy),
            _ if self.least_gap(at) <= 0.0 => Err(NoStage::Diverged),
            _ if self.moves_by_path(from) => {
                of_journal(0, self.film(Moving { time, at, velocity }, Held::default(), Neighbour::None))
            }
            _ => one(Journals::alone(self).carried((time, &[at]), &[velocity], accuracy)),
        };
        found.map_err(|reason| self.told_between(reason, time, at))
    }

    /// The end of one step from another one.
    fn led_on(&self, from: &PathStep, time: f64, accuracy: StageTolerance) -> Result<Instant, NoStage> {
        let instant = of_journal(0, self.film_at(from, Neighbour::None))?;
        if time <= from.time {
            return Ok(instant);
        }
        let masses = self.masses();
        let acceleration = [0, 1, 2, 3].map(|k| match masses[k] > 0.0 {
            true => -instant.excess[k] / masses[k],
            false => 0.0,
        });
        let (instants, dt) = ([instant], time - from.time);
        let begin = StepStart { instants: &instants, accelerations: &[acceleration], before: None };
        let made = Journals::alone(self).step(begin, dt, accuracy, &mut 0)?;
        Ok(Instant { time, ..one(Ok(made.end))? })
    }

    /// The end of one step from another one, in which the journal follows the path: its film and its wall alone are
    /// led on.
    fn led_along(&self, from: &PathStep, span: &Span, time: f64) -> Result<Instant, NoStage> {
        let begin = of_journal(0, self.film_at(from, Neighbour::None))?;
        let dt = time - from.time;
        if dt <= 0.0 {
            return Ok(begin);
        }
        let scheme = Journals::alone(self).scheme();
        let per_time = 1.0 / (scheme.diagonal * dt);
        let mut course = Course::from(&begin, [0.0; 4]);
        let mut latest = begin;
        for stage in 1..scheme.stages() {
            let time = from.time + dt * scheme.nodes[stage];
            let known = course.known((scheme, stage), dt, (None, time));
            let moving = Moving { time, at: span.at(time), velocity: span.rate(time) };
            let wall = latest.wall().zip(known.wall.as_ref());
            let wall = wall.map(|(wall, (stage, expected))| wall.with(expected.clone()).in_stage(stage.clone()));
            let held = Held { storage: known.before.as_ref().map(|before| &before.storage), wall: wall.as_ref() };
            let found = of_journal(0, self.film(moving, held, Neighbour::Start(&latest.film)))?;
            latest = of_journal(0, known.with_oil(found))?;
            course.add(&known, per_time, &latest);
        }
        Ok(Instant { time, ..latest })
    }

    /// The film of a step: that which was found, where it conserves its oil; else started from a neighbouring one.
    ///
    /// # Errors
    /// [`NoFilm`]: why there is none.
    pub fn film_at(&self, step: &PathStep, near: Neighbour) -> Result<Instant, NoFilm> {
        let wall = step.wall.as_ref();
        let Some(history) = &step.history else {
            return self.film(step.moving(), Held { storage: None, wall }, near);
        };
        let held = Held { storage: Some(&history.before), wall };
        let found = self.film(step.moving(), held, Neighbour::Found(&history.trace))?;
        Ok(Instant { oil: Some(history.oil.clone()), ..found })
    }
}

/// The instant of the only journal.
fn one(found: Result<Vec<Instant>, NoStage>) -> Result<Instant, NoStage> {
    found?.into_iter().next().ok_or(NoStage::Diverged)
}
