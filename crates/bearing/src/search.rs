//! One position of the journal tried: its film, its force, and the tangent of the force.

use std::borrow::Cow;
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};

use oilwedge_reynolds::contact::Fineness;
use oilwedge_reynolds::lubricant::PressureLaw;
use oilwedge_reynolds::quantities::contact_points::ContactPoints;
use oilwedge_reynolds::quantities::load::Resultant;
use oilwedge_reynolds::{Bearing, CentreVelocity, FilmProblem, FilmSystem, Gap, JournalState, NoFilm, SolvedFilm};

use crate::coordinates::{Coordinates, Vector, length, moved};
use crate::deflection::{CLOSED, WallResidual};
use crate::equilibrium::NEAR;
use crate::estimate::is_film_of_contact;
use crate::time_terms::TimeTerms;
use crate::work::Work;
use crate::{JournalLoad, SearchOptions, ThermalFlows};

/// Part of a deflection that a trial may leave, over the difference of force and load at which the balance is found.
pub(crate) const OF_BALANCE: f64 = 1e-2;
/// From this part on contact need not be integrated as finely as for numbers that are reported.
const OF_CONTACT: f64 = 1e-6;

/// A search for the position that balances a load on one mesh.
pub(crate) struct Search<'a> {
    pub(crate) system: &'a Arc<FilmSystem>,
    pub(crate) load: JournalLoad,
    /// Where the film is least in a wall that is not bent; see [`Self::gap_under`].
    pub(crate) gap: Gap,
    /// What is free under it.
    pub(crate) coordinates: Coordinates,
    pub(crate) options: SearchOptions<'a>,
    /// Residuals are relative to this force [N].
    pub(crate) scale: f64,
    /// Round-off of the film's force is relative to this one [N].
    pub(crate) reference_force: f64,
    /// Rate [1/s] at which motion and given pressures change the film.
    pub(crate) reference_rate: f64,
    /// What its trials have shown, and cost.
    pub(crate) record: Mutex<Record>,
    /// What a stage of a motion adds; none of a journal at rest.
    pub(crate) time: Option<TimeTerms>,
    /// The viscosity law of the film that is found; trials saturate.
    pub(crate) law: PressureLaw,
    /// True of a film whose pressure is nowhere below that from which loads count.
    pub(crate) only_pushes: bool,
}

/// What the trials of a search have shown, and cost.
#[derive(Debug, Default)]
pub(crate) struct Record {
    /// The trial whose force was nearest to the load.
    pub(crate) nearest: Option<Nearest>,
    /// Load less force of each trial, relative to the load.
    pub(crate) tried: Vec<f64>,
    /// How the heat that is left over changes, as far as the steps have shown it.
    pub(crate) row: Option<WarmthRow>,
    /// What they have cost.
    pub(crate) work: Work,
}

/// The distance of a trial from the load, its force [N] and its journal.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Nearest {
    pub(crate) distance: f64,
    pub(crate) force: [f64; 2],
    pub(crate) journal: JournalState,
}

/// How the heat that a film leaves over changes ([`crate::warming`]).
#[derive(Debug, Clone, Copy)]
pub(crate) struct WarmthRow {
    /// With the coordinates [W/m].
    pub(crate) by_place: Vector,
    /// With the temperature [W/K].
    pub(crate) by_temperature: f64,
}

/// A position, its film and its force.
pub(crate) struct Trial {
    pub(crate) film: SolvedFilm,
    /// The film in cubic elements, where the force is that of it.
    pub(crate) cubic: Option<SolvedFilm>,
    /// What the film carries.
    pub(crate) carried: Resultant,
    /// Where surfaces touch, if that was asked.
    pub(crate) contact: Option<Arc<ContactPoints>>,
    /// What it leaves of the balance of its wall, where the wall is not closed at each place.
    pub(crate) left: Option<WallResidual>,
    /// Least film [m], once it was asked for.
    pub(crate) least_film: OnceLock<f64>,
    /// What heats and cools it, once it was asked for.
    pub(crate) warming: OnceLock<ThermalFlows>,
}

impl Trial {
    /// A trial by what is `carried`.
    pub(crate) fn of(film: SolvedFilm, carried: Resultant) -> Self {
        let (least_film, warming) = (OnceLock::new(), OnceLock::new());
        Self { film, cubic: None, carried, contact: None, left: None, least_film, warming }
    }
}

impl<'a> Search<'a> {
    /// A search for `load` on `system`.
    pub(crate) fn new(
        problem: &FilmProblem,
        system: &'a Arc<FilmSystem>,
        load: JournalLoad,
        options: SearchOptions<'a>,
    ) -> Self {
        let gap = Gap::of(&problem.clone().with_wall_at_rest(), system);
        Self::within(gap, problem, system, load, options)
    }

    /// A search for the place in a stage of a motion under a load; residuals are relative to the force `scale` [N].
    pub(crate) fn in_stage(
        problem: &FilmProblem,
        (system, gap): (&'a Arc<FilmSystem>, Gap),
        (load, scale): (JournalLoad, f64),
        time: TimeTerms,
    ) -> Self {
        let search = Self::within(gap, problem, system, load, SearchOptions::default());
        Self { time: Some(time), ..search.relative_to(scale) }
    }

    /// This search with residuals relative to a force `scale` [N].
    pub(crate) fn relative_to(self, scale: f64) -> Self {
        Self { scale, ..self }
    }

    fn within(
        gap: Gap,
        problem: &FilmProblem,
        system: &'a Arc<FilmSystem>,
        load: JournalLoad,
        options: SearchOptions<'a>,
    ) -> Self {
        let reference_force = reference_force(problem, system, options.centre_velocity);
        let Bearing { radius, length, clearance, .. } = problem.bearing;
        let by_rate = problem.lubricant.viscosity * (radius / clearance).powi(2) * 2.0 * radius * length;
        Self {
            system,
            load,
            gap,
            coordinates: Coordinates::of(&load, &problem.bearing),
            options,
            reference_force,
            reference_rate: reference_force / by_rate,
            scale: match load.magnitude() {
                0.0 => reference_force.max(f64::MIN_POSITIVE),
                load => load,
            },
            record: Mutex::default(),
            time: None,
            law: problem.lubricant.pressure_law.clone(),
            only_pushes: only_pushes(problem, system),
        }
    }

    /// A search whose journal stays where the problem has it: its wall and its temperature alone are unknown.
    pub(crate) fn held(problem: &FilmProblem, system: &'a Arc<FilmSystem>, options: SearchOptions<'a>) -> Self {
        let search = Self::new(problem, system, JournalLoad::from([0.0; 2]), options);
        Self { coordinates: Coordinates { order: 0, ..search.coordinates }, ..search }
    }

    /// Where the film is least under the wall of a problem, which a journal may press out further than the clearance.
    pub(crate) fn gap_under(&self, problem: &FilmProblem) -> Cow<'_, Gap> {
        match problem.deflection() {
            None => Cow::Borrowed(&self.gap),
            Some(_) => Cow::Owned(Gap::of(problem, self.system)),
        }
    }

    /// Least film of a trial [m].
    pub(crate) fn least_film(&self, trial: &Trial) -> f64 {
        let least = || self.least_under(&trial.film.problem, &trial.film.problem.journal);
        *trial.least_film.get_or_init(least)
    }

    /// Least film [m] of a journal under the wall of a problem.
    pub(crate) fn least_under(&self, problem: &FilmProblem, journal: &JournalState) -> f64 {
        match problem.deflection() {
            None => self.gap.least(journal),
            Some(_) => Gap::of(problem, self.system).least_of_one(journal),
        }
    }

    /// Whether the journal of a trial is in contact; see [`is_contact`](crate::is_contact).
    pub(crate) fn is_in_contact(&self, trial: &Trial) -> bool {
        is_film_of_contact(self.least_film(trial), trial.film.problem.bearing.clearance)
    }

    /// Part of a deflection that may be left where the load is balanced.
    pub(crate) fn left_at_balance(&self) -> f64 {
        CLOSED.max(OF_BALANCE * self.options.balanced())
    }

    /// The problem with the journal `at` these coordinates.
    pub(crate) fn placed(&self, problem: &FilmProblem, at: Vector) -> FilmProblem {
        if self.coordinates.order == 0 {
            return problem.clone();
        }
        if let Some(time) = &self.time {
            let journal = time.moving(self.coordinates, &problem.journal, at);
            return FilmProblem { journal, ..problem.clone() };
        }
        let angle = match at {
            [0.0, 0.0, ..] => problem.journal.min_film_angle(),
            [x, y, ..] => y.atan2(x),
        };
        let journal = self.coordinates.placed(&problem.journal, at);
        FilmProblem {
            journal: journal.with_centre_velocity(self.options.centre_velocity, angle),
            ..problem.clone().with_contact(Fineness::Reported)
        }
    }

    /// A trial under the viscosity law of its oil. That of a problem which is only tried itself stays.
    ///
    /// # Errors
    /// The law has no pressure for the film.
    pub(crate) fn accepted(&self, trial: Trial) -> Result<Trial, NoFilm> {
        let law = self.law_at(&trial.film.problem);
        match law {
            PressureLaw::Saturating(_) => Ok(trial),
            _ => Ok(Trial { film: trial.film.accepted(&law)?, ..trial }),
        }
    }

    pub(crate) fn recorded(&self, trial: Trial) -> Trial {
        let distance = self.distance(&trial);
        let residual = self.residual(&trial);
        let steps = trial.film.solution.history.len();
        let mut record = self.record();
        record.tried.push(residual);
        record.work += Work { films: 1, factorisations: steps, linear_solves: steps };
        if let Some(observer) = self.options.observer {
            observer.position(record.tried.len(), residual);
        }
        if record.nearest.is_none_or(|nearest| distance < nearest.distance) {
            let (force, journal) = (trial.carried.force, trial.film.problem.journal);
            record.nearest = Some(Nearest { distance, force, journal });
        }
        trial
    }

    /// What its trials have shown, and cost.
    pub(crate) fn record(&self) -> MutexGuard<'_, Record> {
        self.record.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// How finely contact is integrated in a film that may leave this part of a deflection. A stage of a motion, whose
    /// films are compared with those of other stages, is integrated as finely as numbers that are reported.
    pub(crate) fn fineness(&self, part: f64) -> Fineness {
        match part < OF_CONTACT || self.time.is_some() {
            true => Fineness::Reported,
            false => Fineness::Tried,
        }
    }

    /// Adds to what the search has cost.
    pub(crate) fn spend(&self, more: Work) {
        self.record().work += more;
    }

    /// Difference of forces and load over the load.
    pub(crate) fn residual(&self, trial: &Trial) -> f64 {
        length(self.excess(trial)) / self.scale
    }

    /// What the difference is for the forces alone, and for the moments alone.
    pub(crate) fn parts(&self, trial: &Trial) -> [f64; 2] {
        let [x, y, z_x, z_y] = self.excess(trial);
        [x.hypot(y) / self.scale, z_x.hypot(z_y) / self.scale]
    }

    /// Forces of the film less the load [N].
    pub(crate) fn excess(&self, trial: &Trial) -> Vector {
        moved(self.response(trial), -1.0, self.asked())
    }

    /// Forces of the film, of the support against its tilt, and of a mass in a stage [N].
    pub(crate) fn response(&self, trial: &Trial) -> Vector {
        let at = self.coordinates.at(&trial.film.problem.journal);
        let [_, _, tilt_x, tilt_y] = at;
        let per_arm = self.support_stiffness();
        let by_support = [0.0, 0.0, per_arm * tilt_x, per_arm * tilt_y];
        let by_mass = self.time.map_or([0.0; 4], |time| time.inertia(at));
        let film = self.coordinates.forces(&trial.carried);
        [0, 1, 2, 3].map(|k| film[k] + by_support[k] + by_mass[k])
    }

    /// Stiffness [N/m] that acts on each coordinate beside the film: of the support and, in a stage, of a mass.
    pub(crate) fn stiffness_beside(&self) -> Vector {
        let support = self.support_stiffness();
        let by_mass = self.time.map_or([0.0; 4], |time| time.stiffness());
        moved([0.0, 0.0, support, support], 1.0, by_mass)
    }

    /// The load, and what tilts the journal where it is parallel to the bearing [N].
    pub(crate) fn asked(&self) -> Vector {
        self.load.asked(self.coordinates.arm)
    }

    /// Stiffness of the support in the coordinates of the search [N/m].
    pub(crate) fn support_stiffness(&self) -> f64 {
        self.load.support_stiffness(self.coordinates.arm)
    }

    /// How far the force is from the load: by logarithm and angle, so that forces much too large and much too small
    /// count alike; by the residual where that is small.
    pub(crate) fn distance(&self, trial: &Trial) -> f64 {
        let residual = self.residual(trial);
        let (carried, asked) = (trial.carried.force, self.load.force);
        let (force, load) = (carried[0].hypot(carried[1]), self.load.magnitude());
        if residual < NEAR || load == 0.0 {
            return residual;
        }
        if force == 0.0 {
            return f64::MAX;
        }
        let along = carried[0] * asked[0] + carried[1] * asked[1];
        let across = carried[0] * asked[1] - carried[1] * asked[0];
        let [arm_x, arm_y] = self.arms_off(trial);
        (load / force).ln().hypot(across.atan2(along)).hypot(arm_x.hypot(arm_y))
    }

    /// How far the arms of the film, its moment over its force, are from those that the load and, at this tilt, the
    /// support leave to it, in half lengths of the bearing.
    pub(crate) fn arms_off(&self, trial: &Trial) -> [f64; 2] {
        let (film, tilted) = (self.coordinates.forces(&trial.carried), self.response(trial));
        let asked = self.asked();
        let [x, y] = trial.carried.force;
        let (force, load) = (x.hypot(y), self.load.magnitude());
        [2, 3].map(|k| film[k] / force - (asked[k] - (tilted[k] - film[k])) / load)
    }
}

/// Whether no pressure of a film or of its supply is below that from which loads count.
fn only_pushes(problem: &FilmProblem, system: &FilmSystem) -> bool {
    let least = problem.bearing.end_pressure;
    let mut regions = system.supply.regions().iter();
    problem.cavitation.pressure().is_some_and(|pressure| pressure >= least)
        && regions.all(|region| region.pressure >= least)
}

/// The force [N] of drag through the clearance, or that of the greatest pressure given on the projected area.
fn reference_force(problem: &FilmProblem, system: &FilmSystem, centre_velocity: CentreVelocity) -> f64 {
    let bearing = &problem.bearing;
    let tilting = JournalState { velocity: [0.0; 2], ..problem.journal }.gap_speed(0.5 * bearing.length);
    let rate = problem.journal.speed.abs() + (centre_velocity.speed() + tilting) / bearing.clearance;
    let drag = problem.lubricant.viscosity * rate * (bearing.radius / bearing.clearance).powi(2);
    let given = system.supply.regions().iter().map(|region| region.pressure.abs());
    given.fold(drag, f64::max) * 2.0 * bearing.radius * bearing.length
}
