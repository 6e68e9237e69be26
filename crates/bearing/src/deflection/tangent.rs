//! The tangent of film and wall: how both answer where something else changes.
//!
//! At a fixed wall the unknown of the film changes by u, and the pressure of contact by a. The wall follows, and both
//! follow the wall: `(I - C dp/dd) dd = C (dp/du u + a)`, then `du = u + (du/dd) dd`, p the sum of both pressures. One
//! product with the operator is one back-solve with the factor of the film, its cavity held, and one product each with
//! the matrices of the gap ([`GapTangent`]) and of contact.

use std::cell::RefCell;
use std::sync::Arc;

use oilwedge_fem::Error;
use oilwedge_reynolds::film_thickness::Deflection;
use oilwedge_reynolds::quantities::LoadGradient;
use oilwedge_reynolds::quantities::contact_points::ContactPoints;
use oilwedge_reynolds::quantities::load::Resultant;
use oilwedge_reynolds::wall::{ContactTangent, GapTangent};
use oilwedge_reynolds::{FilmProblem, FilmSystem, JournalChange, MixedChange, SolvedFilm};

use super::gmres::{GmresSolution, KrylovSpace};
use super::touching::SplineContact;

/// Accuracy to which the linear systems of a tangent are solved where the tangent is a result, not a step of an
/// iteration: norm of the residual over that of the right-hand side [1].
pub const EXACT: f64 = 1e-10;
/// Accuracy to which the systems of a film much like another one are solved, where they stand in for those of it.
pub(crate) const NEARLY: f64 = 1e-2;
/// Part of it to which each product with a tangent is known.
const OF_ACCURACY: f64 = 1e-3;

/// A solved film whose wall gives way.
pub(crate) struct Follower<'a> {
    pub(super) film: &'a SolvedFilm,
    pub(super) deflection: &'a Deflection,
    /// How the film answers to the wall.
    pub(super) gap: Arc<GapTangent>,
    /// None where no contact is simulated.
    contact: Option<Touch>,
    /// What systems solved have shown of `I - C dp/dd`.
    known: RefCell<KrylovSpace>,
}

/// Contact of a film.
struct Touch {
    points: Arc<ContactPoints>,
    /// How it answers to the wall.
    tangent: ContactTangent,
    /// Contact and wall alone; none where nothing touches.
    touching: Option<SplineContact>,
}

/// What a change of the journal leads to, the wall held.
pub(super) struct Free {
    /// Change of the film.
    pub(super) film: MixedChange,
    /// Change of the unknown at each dof.
    pub(super) unknown: Vec<f64>,
    /// What the journal carries by contact, and the forces [N] on the splines; none where no contact is simulated.
    pub(super) contact: Option<(Resultant, Vec<f64>)>,
}

/// What a change leads to, the wall following.
pub(crate) struct WallResponse {
    /// Change of the coefficients of the deflection [m].
    pub(crate) deflection: Vec<f64>,
    /// Change of the unknown at each dof [Pa].
    pub(crate) unknown: Vec<f64>,
    /// What contact carries with the change of the journal alone.
    by_contact: Resultant,
}

impl<'a> Follower<'a> {
    /// None where the wall is rigid.
    ///
    /// # Errors
    /// A system that does not fit in memory.
    pub(crate) fn of(film: &'a SolvedFilm) -> Result<Option<Self>, Error> {
        Self::touching(film, contact_on_wall(&film.problem, &film.system))
    }

    /// The follower of [`Self::of`] for a film with these points of contact.
    ///
    /// # Errors
    /// A system that does not fit in memory.
    pub(crate) fn touching(film: &'a SolvedFilm, contact: Option<Arc<ContactPoints>>) -> Result<Option<Self>, Error> {
        let of_wall = |deflection: &'a Deflection| {
            let touch = |points: Arc<ContactPoints>| {
                let tangent = points.tangent();
                Touch { touching: SplineContact::of(&tangent, &deflection.wall.compliance), points, tangent }
            };
            Ok(Self {
                film,
                deflection,
                gap: GapTangent::kept(film, deflection)?,
                contact: contact.map(touch),
                known: RefCell::default(),
            })
        };
        film.problem.deflection().map(of_wall).transpose()
    }

    /// How many coefficients a deflection has.
    pub(super) fn number(&self) -> usize {
        self.deflection.coefficients.len()
    }

    /// A change of the wall by these coefficients [m].
    pub(super) fn shape(&self, coefficients: &[f64]) -> Deflection {
        self.deflection.change(coefficients.to_vec())
    }

    /// Deflection [m] by a change of the unknown, and by that of contact with a deflection `bent` [m].
    pub(super) fn image(&self, unknown: &[f64], bent: &[f64]) -> Vec<f64> {
        self.image_with(unknown, self.contact_times(bent).as_deref())
    }

    /// What follows from a `change` of the journal, the wall held.
    ///
    /// # Errors
    /// The linear system could not be solved.
    pub(super) fn free(&self, change: &JournalChange) -> Result<Free, Error> {
        self.free_within(change, 0.0)
    }

    /// The change of [`Self::free`], for systems of the wall that are solved to an `accuracy`.
    pub(super) fn free_within(&self, change: &JournalChange, accuracy: f64) -> Result<Free, Error> {
        let film = match self.gap.by_journal(&self.film.system, change) {
            Some(residual) => self.film.mixed_answer(&residual, OF_ACCURACY * accuracy)?,
            None => self.film.mixed_changes(&[change.into()])?.remove(0),
        };
        Ok(Free { unknown: self.film.unknown_in(&film), film, contact: self.contact_change(change) })
    }

    /// Change of the unknown with a `change` of the journal and a deflection `bent` [m], for systems that are solved to
    /// an `accuracy`.
    ///
    /// # Errors
    /// The linear system could not be solved.
    pub(super) fn by_both(&self, change: &JournalChange, bent: &[f64], accuracy: f64) -> Result<Vec<f64>, Error> {
        let sum = |a: Vec<f64>, b: Vec<f64>| a.iter().zip(b).map(|(a, b)| a + b).collect();
        match self.gap.by_journal(&self.film.system, change) {
            Some(by_journal) => {
                let residual: Vec<f64> = sum(self.gap.times(&self.film.system, bent), by_journal);
                self.film.answer(&residual, OF_ACCURACY * accuracy)
            }
            None => {
                let by_journal = self.film.unknown_change(change)?;
                Ok(sum(self.by_deflection(bent, accuracy)?, by_journal))
            }
        }
    }

    /// What the journal carries by contact with a `change` of the journal, and the forces [N] of contact on the splines
    /// with a deflection `bent` [m] too; none where no contact is simulated.
    pub(super) fn contact_by_both(&self, change: &JournalChange, bent: &[f64]) -> Option<(Resultant, Vec<f64>)> {
        let (carried, mut forces) = self.contact_change(change)?;
        let by_wall = self.contact_times(bent)?;
        forces.iter_mut().zip(by_wall).for_each(|(force, more)| *force += more);
        Some((carried, forces))
    }

    /// What the journal carries by contact, and the forces [N] of it on the splines, more with a `change` of the
    /// journal; none where no contact is simulated.
    pub(super) fn contact_change(&self, change: &JournalChange) -> Option<(Resultant, Vec<f64>)> {
        let points = &self.contact.as_ref()?.points;
        let moved = points.gap_change(&self.film.problem, change.into());
        Some((points.load_change(&moved), points.forces_change(&moved)))
    }

    /// Deflection [m] by what follows from a change of the journal, the wall held.
    pub(super) fn image_of(&self, free: &Free) -> Vec<f64> {
        let forces = free.contact.as_ref().map(|(_, forces)| forces.as_slice());
        self.image_with(&free.unknown, forces)
    }

    /// Deflection [m] by a change of the unknown, and by these forces [N] of contact on the splines.
    pub(super) fn image_with(&self, unknown: &[f64], contact: Option<&[f64]>) -> Vec<f64> {
        let (SolvedFilm { problem, system, solution }, wall) = (self.film, &self.deflection.wall);
        let mut forces = wall.grid.forces_change(problem, system, &solution.unknown, unknown);
        for (force, contact) in forces.iter_mut().zip(contact.unwrap_or_default()) {
            *force += contact;
        }
        wall.compliance.deflection(&forces)
    }

    /// Change of the unknown by a deflection, for a system that is solved to an `accuracy`.
    pub(super) fn by_deflection(&self, coefficients: &[f64], accuracy: f64) -> Result<Vec<f64>, Error> {
        Ok(self.film.unknown_in(&self.film_by_deflection(coefficients, accuracy)?))
    }

    /// Change of the film by a deflection, for a system that is solved to an `accuracy`.
    pub(super) fn film_by_deflection(&self, coefficients: &[f64], accuracy: f64) -> Result<MixedChange, Error> {
        self.film.mixed_answer(&self.gap.times(&self.film.system, coefficients), OF_ACCURACY * accuracy)
    }

    /// Solves `(I - C dp/dd) x = b`.
    pub(super) fn solve(&self, b: &[f64], accuracy: f64) -> Result<GmresSolution, Error> {
        let operator = |x: &[f64]| {
            let image = self.image(&self.by_deflection(x, accuracy)?, x);
            Ok(x.iter().zip(image).map(|(x, image)| x - image).collect())
        };
        let nearly = |r: &[f64]| Ok(self.solve_contact(r));
        (self.known.borrow_mut()).solve(operator, nearly, b, accuracy)
    }

    /// Solves `x - C A x = r`, A the tangent of contact: the system without what the film answers.
    pub(super) fn solve_contact(&self, r: &[f64]) -> Vec<f64> {
        match self.contact.as_ref().and_then(|contact| contact.touching.as_ref()) {
            Some(touching) => touching.solve(&self.deflection.wall.compliance, r),
            None => r.to_vec(),
        }
    }

    /// Change of the forces [N] of contact on the splines by a deflection [m]; none where no contact is simulated.
    pub(super) fn contact_times(&self, bent: &[f64]) -> Option<Vec<f64>> {
        Some(self.contact.as_ref()?.tangent.times(bent))
    }

    /// What follows from a change of the journal that leads to `free` where the wall is held, to an `accuracy`.
    ///
    /// # Errors
    /// The linear systems could not be solved.
    pub(super) fn followed(&self, free: Free, accuracy: f64) -> Result<WallResponse, Error> {
        let by_contact = free.by_contact();
        Ok(WallResponse { by_contact, ..self.bent(&self.image_of(&free), free.unknown, accuracy)? })
    }

    /// What follows from a change of the unknown by `unknown`, and of the wall by `free` [m], where neither answers to
    /// the other; to an `accuracy`.
    fn bent(&self, free: &[f64], mut unknown: Vec<f64>, accuracy: f64) -> Result<WallResponse, Error> {
        let deflection = self.solve(free, accuracy)?.x;
        let more = self.by_deflection(&deflection, accuracy)?;
        unknown.iter_mut().zip(more).for_each(|(unknown, more)| *unknown += more);
        Ok(WallResponse { deflection, unknown, by_contact: Resultant::default() })
    }

    /// How what the journal carries changes with film and wall.
    pub(super) fn load_gradient(&self) -> LoadGradient {
        let contact = self.contact.as_ref().map(|contact| contact.points.as_ref());
        LoadGradient::of(self.film, contact)
    }

    /// What follows where the wall alone changes by `free` [m] under the pressure that is there, to an `accuracy`.
    pub(crate) fn of_wall(&self, free: &[f64], accuracy: f64) -> Result<WallResponse, Error> {
        self.bent(free, vec![0.0; self.film.solution.unknown.len()], accuracy)
    }
}

impl Free {
    /// What contact carries more.
    pub(super) fn by_contact(&self) -> Resultant {
        self.contact.as_ref().map_or_else(Resultant::default, |(load, _)| *load)
    }
}

impl WallResponse {
    /// Change of what the journal carries, by the `gradient` of film and wall.
    pub(super) fn carried(&self, gradient: &LoadGradient) -> Resultant {
        let mut carried = gradient.change(&self.unknown, &self.deflection);
        carried += self.by_contact;
        carried
    }
}

/// Where surfaces touch in a film; none where no contact is simulated.
pub(crate) fn contact_points(problem: &FilmProblem, system: &FilmSystem) -> Option<Arc<ContactPoints>> {
    ContactPoints::of(problem, system).map(Arc::new)
}

/// Points of contact in a wall that gives way; none in a rigid one, whose tangent has no need of them.
pub(crate) fn contact_on_wall(problem: &FilmProblem, system: &FilmSystem) -> Option<Arc<ContactPoints>> {
    problem.deflection().and_then(|_| contact_points(problem, system))
}
