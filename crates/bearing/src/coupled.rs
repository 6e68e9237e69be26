//! The trials of a search, and the tangent of journal and wall together at one of them.
//!
//! A trial is a film at one place of the journal under one deflection of its wall; what it leaves of both balances is
//! reduced by the one Newton's method ([`crate::newton`]). In a rigid wall the tangent is that of force and film. In a
//! wall that gives way it is a [`Joint`], the journal eliminated and the wall found by GMRES, or [`Bordered`], of the
//! film in cubic elements.

use std::borrow::Cow;

use oilwedge_fem::newton::NewtonFailure;
use oilwedge_reynolds::film_thickness::Closing;
use oilwedge_reynolds::quantities::load::{load, load_change, load_touching};
use oilwedge_reynolds::solve::Neighbour;
use oilwedge_reynolds::{
    FilmChange, FilmProblem, FilmStart, JournalChange, JournalState, MixedChange, NoFilm, SolvedFilm,
};

use crate::coordinates::{Coordinates, Vector, moved, unit};
use crate::deflection::{Bordered, Follower, Joint, Moves, NEARLY, WallResidual, contact_points, settled};
use crate::search::{Search, Trial};
use crate::stiffness::Stiffness;

/// How the film of a trial is solved.
pub(crate) enum FilmSolve<'a> {
    /// Until its cavity is settled, from a film nearby.
    Settled(Neighbour<'a>),
    /// By one step.
    Step(FilmStart),
}

/// How the journal of a film, and a wall that gives way, move where their balances are to change.
pub(crate) enum Tangents<'a> {
    /// The wall is rigid.
    Rigid(RigidTangents<'a>),
    /// The wall gives way.
    Yielding(Box<Joint<'a>>),
    /// The wall gives way, and the film in cubic elements carries the load.
    OfCubic(Box<Bordered<'a>>),
}

/// How force and film change with each coordinate of a journal in a rigid wall.
pub(crate) struct RigidTangents<'a> {
    film: &'a SolvedFilm,
    coordinates: Coordinates,
    stiffness: Stiffness,
    /// How the film changes with each coordinate and, last, with the logarithm of the viscosity, where the temperature
    /// is found.
    pub(crate) columns: Vec<MixedChange>,
}

impl RigidTangents<'_> {
    /// The change of the forces by each coordinate [N/m], and the moves of a journal by each.
    pub(crate) fn by_place(&self) -> (Stiffness, Vec<Moves>) {
        let column =
            |(k, film): (usize, &MixedChange)| Moves { place: unit(k), film: film.clone(), ..Moves::default() };
        (self.stiffness, self.columns.iter().enumerate().map(column).collect())
    }
}

impl Tangents<'_> {
    /// The moves by which forces change by `force` [N], and the wall by `wall` [m] more than film and contact bend it;
    /// `None`: as far as they bend it.
    ///
    /// # Errors
    /// The linear systems could not be solved.
    pub(crate) fn solve(&self, force: Vector, wall: Option<&[f64]>) -> Result<Moves, NoFilm> {
        match self {
            Self::Rigid(rigid) => {
                let place = rigid.stiffness.solve(force);
                let film = MixedChange::sum(place.into_iter().zip(&rigid.columns));
                Ok(Moves { place, film, ..Moves::default() })
            }
            Self::Yielding(joint) => Ok(joint.solve(force, wall).map_err(NewtonFailure::from)?),
            Self::OfCubic(bordered) => Ok(bordered.solve(force, wall).map_err(NewtonFailure::from)?),
        }
    }

    /// What a journal that moves at these rates [1/s of coordinates in m] and a wall that moves at this one [m/s] push
    /// film and wall by: forces [N], and how far the wall is bent [m].
    ///
    /// # Errors
    /// The linear systems could not be solved.
    pub(crate) fn pushed(&self, change: &JournalChange, rate: &[f64]) -> Result<(Vector, Vec<f64>), NoFilm> {
        match self {
            Self::Rigid(RigidTangents { film, coordinates, .. }) => {
                let change = FilmChange::Journal(*change);
                let columns = film.mixed_changes(&[change]).map_err(NewtonFailure::from)?;
                let unknown = MixedChange::sum(columns.iter().map(|column| (1.0, column)));
                Ok((coordinates.forces(&load_change(film, &[change], &film.unknown_in(&unknown))), Vec::new()))
            }
            Self::Yielding(joint) => Ok(joint.pushed(change, rate).map_err(NewtonFailure::from)?),
            Self::OfCubic(bordered) => Ok(bordered.near().pushed(change, rate).map_err(NewtonFailure::from)?),
        }
    }
}

impl Search<'_> {
    /// The film `at` these coordinates under the wall of a problem as it is, what it leaves of the balance of that wall
    /// included. Contact is integrated as finely as a balance to the `part` asks for.
    pub(crate) fn open(&self, problem: &FilmProblem, at: Vector, solve: FilmSolve, part: f64) -> Result<Trial, NoFilm> {
        let problem = self.placed(problem, at).tried().with_contact(self.fineness(part));
        let film = match solve {
            FilmSolve::Settled(near) => problem.solve_from(self.system, near)?,
            FilmSolve::Step(start) => problem.step(self.system, start)?,
        };
        let left = WallResidual::of(&film, contact_points(&problem, self.system));
        let carried = load_touching(&film, left.contact.as_deref());
        let film = SolvedFilm { problem: counted(problem, (1, 0), left.residual), ..film };
        Ok(self.recorded(Trial {
            contact: left.contact.clone(),
            left: Some(left),
            ..Trial::of(film, carried.total.resultant())
        }))
    }

    /// The film in cubic elements `at` these coordinates under the wall of a problem as it is, started from films of a
    /// neighbouring place.
    pub(crate) fn open_cubic(
        &self,
        problem: &FilmProblem,
        at: Vector,
        (film, cubic): (&SolvedFilm, Option<&SolvedFilm>),
    ) -> Result<Trial, NoFilm> {
        let problem = self.placed(problem, at);
        let film = problem.solve_from(self.system, Neighbour::Start(film))?;
        let cubic = film.cubic_film(cubic)?;
        Ok(self.of_pair(film, cubic))
    }

    /// The trial of a film and of the same film in cubic elements, whose force counts.
    pub(crate) fn of_pair(&self, film: SolvedFilm, cubic: SolvedFilm) -> Trial {
        let left = WallResidual::of(&cubic, contact_points(&film.problem, self.system));
        let problem = counted(film.problem.clone(), (1, 0), left.residual);
        let (film, cubic) = (SolvedFilm { problem: problem.clone(), ..film }, SolvedFilm { problem, ..cubic });
        let carried = load(&cubic).total.resultant();
        self.recorded(Trial {
            cubic: Some(cubic),
            contact: left.contact.clone(),
            left: Some(left),
            ..Trial::of(film, carried)
        })
    }

    /// What a trial leaves of the balance of its wall.
    pub(crate) fn left_of_wall<'t>(&self, trial: &'t Trial) -> Cow<'t, WallResidual> {
        let of = || WallResidual::of(&trial.film, contact_points(&trial.film.problem, self.system));
        trial.left.as_ref().map_or_else(|| Cow::Owned(of()), Cow::Borrowed)
    }

    /// How journal and wall of a trial move in pseudo-time, in which its `film` rests; see [`Tangents`]. Its linear
    /// systems are solved to an `accuracy`.
    ///
    /// # Errors
    /// The linear systems could not be solved.
    pub(crate) fn tangents<'t>(
        &'t self,
        trial: &'t Trial,
        film: &'t SolvedFilm,
        left: &WallResidual,
        (accuracy, rate): (f64, f64),
    ) -> Result<Tangents<'t>, NoFilm> {
        let of = |film| Follower::touching(film, left.contact.clone()).map_err(NewtonFailure::from);
        let Some(follower) = of(film)? else {
            return Ok(Tangents::Rigid(self.rigid(film, rate)?));
        };
        let (journal, velocity, held) =
            (&trial.film.problem.journal, self.options.centre_velocity, self.stiffness_beside());
        let change = |k: usize| self.change_at(journal, unit(k), rate);
        let joint =
            |accuracy| Joint::of(follower, self.coordinates, change, held, accuracy).map_err(NewtonFailure::from);
        let cubic = match &trial.cubic {
            None => None,
            Some(cubic) => of(cubic)?,
        };
        Ok(match cubic {
            None => Tangents::Yielding(Box::new(joint(accuracy)?)),
            Some(cubic) => {
                let weight = left.size.max(f64::MIN_POSITIVE) / self.scale;
                let moving = (self.coordinates, velocity, held);
                let bordered = Bordered::of(cubic, moving, (weight, accuracy), joint(NEARLY)?);
                Tangents::OfCubic(Box::new(bordered))
            }
        })
    }

    /// The tangent of a film in a rigid wall whose journal moves in pseudo-time.
    fn rigid<'t>(&self, film: &'t SolvedFilm, rate: f64) -> Result<RigidTangents<'t>, NoFilm> {
        let changes: Vec<FilmChange> = (0..self.coordinates.order)
            .map(|k| FilmChange::Journal(self.change_at(&film.problem.journal, unit(k), rate)))
            .chain(self.options.warming.map(|_| FilmChange::Viscosity(1.0)))
            .collect();
        let columns = film.mixed_changes(&changes).map_err(NewtonFailure::from)?;
        let stiffness = Stiffness::by_columns(self.coordinates.order, |k| {
            let carried = load_change(film, &changes[k..=k], &film.unknown_in(&columns[k]));
            let mut column = self.coordinates.forces(&carried);
            column[k] += self.stiffness_beside()[k];
            Ok::<_, NoFilm>(column)
        })?;
        Ok(RigidTangents { film, coordinates: self.coordinates, stiffness, columns })
    }

    /// Where a part of moves leads: the problem under the wall there, and the coordinates.
    pub(crate) fn led_to(&self, trial: &Trial, moves: &Moves, part: f64) -> (FilmProblem, Vector) {
        let (problem, at) = (trial.film.problem.clone(), self.coordinates.at(&trial.film.problem.journal));
        match trial.film.problem.deflection() {
            None => (problem, moved(at, part, moves.place)),
            Some(wall) => {
                let (at, bent) = moves.made(at, wall, part);
                (problem.deflected(Some(&bent)), at)
            }
        }
    }

    /// The problem and the coordinates to which a part of moves leads, contact settled under the wall there. None where
    /// the film along the tangent is thinner than `least` [m].
    pub(crate) fn led_on(&self, trial: &Trial, moves: &Moves, part: f64, least: f64) -> Option<(FilmProblem, Vector)> {
        let (bent, at) = self.led_to(trial, moves, part);
        let led = FilmProblem { journal: self.coordinates.placed(&trial.film.problem.journal, at), ..bent };
        (self.least_under(&led, &led.journal) >= least).then_some(())?;
        let contact = (trial.contact.clone()).or_else(|| contact_points(&trial.film.problem, self.system));
        let settled = contact.filter(|_| !moves.contact.is_empty()).and_then(|contact| {
            let along = contact.forces().into_iter().zip(&moves.contact);
            let forces: Vec<f64> = along.map(|(force, more)| force + part * more).collect();
            settled(&led, self.system, &forces)
        });
        Some(match settled {
            None => (led, at),
            Some(deflection) => (led.deflected(Some(&deflection)), at),
        })
    }

    /// Coordinates of a trial [m].
    pub(crate) fn place(&self, trial: &Trial) -> Vector {
        self.coordinates.at(&trial.film.problem.journal)
    }

    /// The change of a journal that moves by `place` [m] within the pseudo-time `1/rate` [s], and in the time of a
    /// stage.
    pub(crate) fn change_at(&self, journal: &JournalState, place: Vector, rate: f64) -> JournalChange {
        let rate = rate + self.time.map_or(0.0, |time| time.per_time);
        let steady = self.coordinates.change(journal, &self.options.centre_velocity, place);
        let [v, w] = [steady.offset, steady.tilt].map(|way| way.map(|x| rate * x));
        let sum = |a: [f64; 2], b: [f64; 2]| [a[0] + b[0], a[1] + b[1]];
        JournalChange { velocity: sum(steady.velocity, v), tilt_rate: sum(steady.tilt_rate, w), ..steady }
    }
}

/// A problem whose wall took so many films and products more, and leaves this part of its balance.
pub(crate) fn counted(problem: FilmProblem, (films, products): (usize, usize), residual: f64) -> FilmProblem {
    let before = problem.deflection().map(|deflection| deflection.closing);
    match before {
        None => problem,
        Some(before) => {
            problem.closed_by(Closing { residual, outer: before.outer + films, inner: before.inner + products })
        }
    }
}
