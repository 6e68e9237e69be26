//! The equation of motion: what the film carries, what the support of the tilt adds, and the load.
//!
//! ```text
//! m e'' + W(e, e') = F(t)                     m(e, g, ...) + k (g - g_0) = M(t)
//! ```
//!
//! with the mass m of the rotor, which is zero unless a scene gives one. The force W of a film that conserves its oil
//! depends on what it held before, too.

use std::sync::Arc;

use oilwedge_fem::newton::NewtonFailure;
use oilwedge_reynolds::film_thickness::Deflection;
use oilwedge_reynolds::quantities::load::{Resultant, load, load_touching};
use oilwedge_reynolds::solve::Neighbour;
use oilwedge_reynolds::{
    CentreVelocity, FilmProblem, FilmSystem, Gap, JournalChange, JournalState, NoFilm, SolvedFilm, Storage,
};

use super::oil::StoredOil;
use crate::coordinates::{Coordinates, Vector, length, unit};
use crate::deflection::{CLOSED, carried_changes, carried_slowly, closed_within, contact_points};
use crate::duty_cycle::{Duty, DutyCycle};
use crate::stiffness::Stiffness;

/// Accuracy to which a wall that gives way follows in the tangent of a stage: each step leaves about this part of the
/// difference.
const FOLLOWED: f64 = 1e-4;

/// Loads are sampled at so many times to find their peak.
pub(super) const SAMPLES: u32 = 1440;

/// A support that holds the shaft against its tilt.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TiltSupport {
    /// Stiffness k [N m/rad]; zero: the journal tilts freely.
    pub stiffness: f64,
    /// Slope g_0 that it would give the axis [rad].
    pub slope: [f64; 2],
}

/// A journal that moves under a load.
#[derive(Clone)]
pub struct Motion<'a> {
    /// The film; its journal gives the tilt where that is not free, and the axial velocity.
    pub problem: &'a FilmProblem,
    /// Mesh and supply of the film.
    pub system: &'a Arc<FilmSystem>,
    /// Where the film is least on that mesh.
    pub gap: Gap,
    /// What acts on the journal.
    pub cycle: &'a DutyCycle,
    /// What holds a tilt that is free; `None`: the tilt is given.
    pub support: Option<TiltSupport>,
    /// Mass of the rotor that this bearing bears [kg].
    pub mass: f64,
}

/// The journal at one time, and its film.
#[derive(Debug)]
pub struct Instant {
    /// Time [s].
    pub time: f64,
    /// Offsets of the journal [m], in the coordinates of the motion.
    pub at: Vector,
    /// Rates of the coordinates [m/s].
    pub velocity: Vector,
    /// The film at this time.
    pub film: SolvedFilm,
    /// Forces of film and support less the load [N]; what a mass would take is not in them.
    pub excess: Vector,
    /// The oil of a film that conserves it, at the end of a stage; else `None`.
    pub oil: Option<Arc<StoredOil>>,
}

impl Instant {
    /// Place [m] of the journal, and the wall that it has there.
    pub fn under_wall(&self) -> (Vector, Option<&Deflection>) {
        (self.at, self.wall())
    }

    /// The wall, if it gives way.
    pub(crate) fn wall(&self) -> Option<&Deflection> {
        self.film.problem.deflection()
    }
}

/// What film and wall have of the time before.
#[derive(Debug, Clone, Copy, Default)]
pub struct Held<'a> {
    /// Oil of a film that conserves it.
    pub storage: Option<&'a Arc<Storage>>,
    /// The wall, in the stage in which it moves, or from which it is closed; `None`: it is rigid, or at rest and not
    /// bent.
    pub wall: Option<&'a Deflection>,
}

/// A journal on its way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moving {
    /// Time [s].
    pub time: f64,
    /// Offsets [m], in the coordinates of the motion.
    pub at: Vector,
    /// Rates of the coordinates [m/s].
    pub velocity: Vector,
}

impl Motion<'_> {
    /// Which coordinates are free.
    pub fn coordinates(&self) -> Coordinates {
        Coordinates { order: if self.support.is_some() { 4 } else { 2 }, arm: 0.5 * self.problem.bearing.length }
    }

    /// What acts on the journal at a time [s].
    pub fn duty(&self, time: f64) -> Duty {
        self.cycle.at(self.cycle.angular_speed() * time)
    }

    /// The journal at these coordinates, moving so.
    pub fn journal(&self, time: f64, at: Vector, velocity: Vector) -> JournalState {
        let coordinates = self.coordinates();
        let journal = coordinates.placed(&self.problem.journal, at);
        JournalState { speed: self.duty(time).speed, ..coordinates.moving(journal, velocity) }
    }

    /// Least gap [m] of a journal at these coordinates in a wall that is not bent.
    pub(crate) fn least_gap(&self, at: Vector) -> f64 {
        let journal = self.coordinates().placed(&self.problem.journal, at);
        self.gap.least(&journal)
    }

    /// Least gap [m] of a journal at these coordinates under a wall, which it may press out further than the clearance.
    pub(crate) fn least_gap_under(&self, wall: Option<&Deflection>, at: Vector) -> f64 {
        let Some(wall) = wall else {
            return self.least_gap(at);
        };
        let problem = self.problem.clone().deflected(Some(wall));
        let journal = self.coordinates().placed(&problem.journal, at);
        Gap::of(&problem, self.system).least_of_one(&journal)
    }

    /// The load [N], with what the support would give the journal where it is parallel to the bearing.
    pub fn asked(&self, time: f64) -> Vector {
        let Duty { force, moment, .. } = self.duty(time);
        let arm = self.coordinates().arm;
        let tilting = self
            .support
            .map_or([0.0; 2], |support| [0, 1].map(|d| (moment[d] + support.stiffness * support.slope[d]) / arm));
        [force[0], force[1], tilting[0], tilting[1]]
    }

    /// Stiffness of the support in the coordinates of the motion [N/m].
    pub(super) fn support_stiffness(&self) -> f64 {
        let arm = self.coordinates().arm;
        self.support.map_or(0.0, |support| support.stiffness / (arm * arm))
    }

    /// Forces of film and support at an instant [N].
    pub fn response(&self, film: &SolvedFilm, at: Vector) -> Vector {
        self.response_by(&load(film).total.resultant(), at)
    }

    /// Forces of the support and of a film that carries this [N].
    fn response_by(&self, carried: &Resultant, at: Vector) -> Vector {
        let [x, y, z_x, z_y] = self.coordinates().forces(carried);
        let per_tilt = self.support_stiffness();
        [x, y, z_x + per_tilt * at[2], z_y + per_tilt * at[3]]
    }

    /// The film of a journal that moves so, and what it `held` before, started from one nearby; a wall that gives way
    /// is closed with it.
    pub(crate) fn film(&self, moving: Moving, held: Held<'_>, near: Neighbour) -> Result<Instant, NoFilm> {
        let (film, contact) = closed_within(self.problem_of(moving, held), self.system, near, CLOSED)?;
        let carried = load_touching(&film, contact.as_deref());
        Ok(self.instant(moving, film, &carried.total.resultant()))
    }

    /// What a search has found, under the viscosity law of the oil.
    pub(crate) fn accepted(&self, found: Instant) -> Result<Instant, NoFilm> {
        let law = &self.problem.lubricant.pressure_law;
        Ok(Instant { film: found.film.accepted(law)?, ..found })
    }

    /// A trial of a journal that moves so, and what it `held` before, under the wall as it is held; what is found from
    /// it is to be [accepted](Motion::accepted).
    pub(super) fn trial(&self, moving: Moving, held: Held<'_>, near: Neighbour) -> Result<Instant, NoFilm> {
        let film = self.problem_of(moving, held).tried().solve_from(self.system, near)?;
        let contact = contact_points(&film.problem, self.system);
        let carried = load_touching(&film, contact.as_deref());
        Ok(self.instant(moving, film, &carried.total.resultant()))
    }

    pub(super) fn problem_of(&self, moving: Moving, held: Held<'_>) -> FilmProblem {
        let problem = FilmProblem {
            journal: self.journal(moving.time, moving.at, moving.velocity),
            storage: held.storage.cloned(),
            ..self.problem.clone()
        };
        problem.deflected(held.wall)
    }

    /// The instant of a film that carries this.
    pub(crate) fn instant(&self, moving: Moving, film: SolvedFilm, carried: &Resultant) -> Instant {
        let Moving { time, at, velocity } = moving;
        let response = self.response_by(carried, at);
        let asked = self.asked(time);
        Instant { time, at, velocity, excess: [0, 1, 2, 3].map(|k| response[k] - asked[k]), film, oil: None }
    }

    /// The change of the journal where coordinate k changes by `per_offset` and its rate by `per_rate` [1/s].
    pub(super) fn change(&self, journal: &JournalState, k: usize, [per_offset, per_rate]: [f64; 2]) -> JournalChange {
        let of = |factor: f64| {
            let vector = unit(k).map(|part| factor * part);
            self.coordinates().change(journal, &CentreVelocity::default(), vector)
        };
        let (offset, rate) = (of(per_offset), of(per_rate));
        JournalChange { velocity: rate.offset, tilt_rate: rate.tilt, ..offset }
    }

    /// The change of the forces where each coordinate changes by `per_offset` and its rate by `per_rate` [1/s]: the
    /// cavity held, exact to first order. A wall that gives way follows, in the stage that it has.
    ///
    /// # Errors
    /// The linear systems could not be solved.
    pub fn tangent(&self, here: &Instant, per_offset: f64, per_rate: f64) -> Result<Stiffness, NoFilm> {
        let coordinates = self.coordinates();
        let change = |k: usize| self.change(&here.film.problem.journal, k, [per_offset, per_rate]);
        let changes: Vec<JournalChange> = (0..coordinates.order).map(change).collect();
        let carried = carried_changes(&here.film, &changes, FOLLOWED);
        let carried = carried.map_err(NewtonFailure::from)?;
        Stiffness::by_columns(coordinates.order, |k| {
            let mut column = coordinates.forces(&carried[k].by_film);
            if k >= 2 {
                column[k] += per_offset * self.support_stiffness();
            }
            Ok(column)
        })
    }

    /// Stiffness K [N/m] and damping C [N s/m] of film and support for slow motions; a wall that gives way follows
    /// them.
    ///
    /// # Errors
    /// The linear systems could not be solved.
    pub fn slow_tangents(&self, here: &Instant) -> Result<[Stiffness; 2], NoFilm> {
        if here.film.problem.deflection().is_none() {
            return Ok([self.tangent(here, 1.0, 0.0)?, self.tangent(here, 0.0, 1.0)?]);
        }
        let coordinates = self.coordinates();
        let film = SolvedFilm { problem: here.film.problem.clone().with_wall_at_its_rate(), ..here.film.clone() };
        let mut columns = [[[0.0; 4]; 2]; 4];
        for (k, columns) in columns.iter_mut().enumerate().take(coordinates.order) {
            let change = self.change(&film.problem.journal, k, [1.0, 0.0]);
            let carried = carried_slowly(&film, &change, FOLLOWED);
            *columns = carried.map_err(NewtonFailure::from)?.map(|carried| coordinates.forces(&carried));
            if k >= 2 {
                columns[0][k] += self.support_stiffness();
            }
        }
        let of = |part: usize| Stiffness::by_columns(coordinates.order, |k| Ok::<_, NoFilm>(columns[k][part]));
        Ok([of(0)?, of(1)?])
    }

    /// The mass in each coordinate [kg]: the tilt has none.
    pub(crate) fn masses(&self) -> Vector {
        [self.mass, self.mass, 0.0, 0.0]
    }

    /// Greatest load over the cycle [N]; where there is none, that of drag.
    pub fn peak_load(&self) -> f64 {
        let period = self.cycle.period() / self.cycle.angular_speed();
        let sampled = (0..SAMPLES).map(|k| length(self.asked(period * f64::from(k) / f64::from(SAMPLES))));
        match sampled.fold(0.0, f64::max) {
            0.0 => self.drag(),
            peak => peak,
        }
    }

    /// Load that drag through the clearance could carry [N].
    fn drag(&self) -> f64 {
        let bearing = &self.problem.bearing;
        let speed = self.duty(0.0).speed.abs().max(self.cycle.angular_speed().abs());
        let pressure = self.problem.lubricant.viscosity * speed * (bearing.radius / bearing.clearance).powi(2);
        pressure * 2.0 * bearing.radius * bearing.length
    }
}
