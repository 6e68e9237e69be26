//! The tangent of film and wall: how both answer where something else changes.
//!
//! At a fixed wall the unknown of the film changes by u, and the pressure of contact by a. The wall follows, and both follow the wall: `(I - C dp/dd) dd = C (dp/du u + a)`,
//! then `du = u + (du/dd) dd`, p the sum of both pressures. One product with the operator is one back-solve with the factor of the film, its cavity held, and one product each with the
//! matrices of the gap ([`GapTangent`]) and of contact.

use oilwedge_fem::Error;
use oilwedge_reynolds::film_thickness::Deflection;
use oilwedge_reynolds::wall::{ContactTangent, GapTangent};
use oilwedge_reynolds::{FilmProblem, FilmSolution, FilmSystem, JournalChange};

use super::gmres::{Solved, gmres};
use super::touching::Touching;

/// Accuracy to which the linear systems of a tangent are solved where the tangent is a result, not a step of an iteration: norm of the residual over that of the right-hand side [1].
pub const EXACT: f64 = 1e-10;

/// A solved film whose wall gives way.
pub(crate) struct Follower<'a> {
    pub(super) problem: &'a FilmProblem,
    pub(super) system: &'a FilmSystem,
    pub(super) film: &'a FilmSolution,
    deflection: &'a Deflection,
    /// How the film answers to the wall.
    gap: GapTangent,
    /// How contact answers to the wall; none where surfaces do not touch.
    contact: Option<ContactTangent>,
    /// Contact and wall alone.
    touching: Option<Touching>,
}

/// What a change leads to, the wall following.
pub(crate) struct Followed {
    /// Change of the coefficients of the deflection [m].
    pub(crate) deflection: Vec<f64>,
    /// Change of the unknown at each dof [Pa].
    pub(crate) unknown: Vec<f64>,
}

impl<'a> Follower<'a> {
    /// None where the wall is rigid.
    ///
    /// # Errors
    /// A system that does not fit in memory.
    pub(crate) fn of(
        problem: &'a FilmProblem,
        system: &'a FilmSystem,
        film: &'a FilmSolution,
    ) -> Result<Option<Self>, Error> {
        let of_wall = |deflection: &'a Deflection| {
            let contact = deflection.wall.grid.contact_tangent(problem, system);
            let touching = (contact.as_ref()).and_then(|contact| Touching::of(contact, &deflection.wall.compliance));
            Ok(Self {
                problem,
                system,
                film,
                deflection,
                gap: GapTangent::of(problem, system, film, deflection)?,
                contact,
                touching,
            })
        };
        problem.deflection().map(of_wall).transpose()
    }

    /// How many coefficients a deflection has.
    pub(super) fn number(&self) -> usize {
        self.deflection.coefficients.len()
    }

    /// A change of the wall by these coefficients [m].
    pub(super) fn shape(&self, coefficients: &[f64]) -> Deflection {
        self.deflection.change(coefficients.to_vec())
    }

    /// The deflection with more of it.
    pub(super) fn added(&self, more: &[f64]) -> Deflection {
        let sum = self.deflection.coefficients.iter().zip(more).map(|(d, more)| d + more);
        self.deflection.with(sum.collect())
    }

    /// Deflection [m] by a change of the unknown, and by that of contact with a deflection `bent` [m].
    pub(super) fn image(&self, unknown: &[f64], bent: &[f64]) -> Vec<f64> {
        let contact = self.contact.as_ref().map(|contact| contact.times(bent));
        self.image_with(unknown, contact)
    }

    /// Deflection [m] by a change of the unknown, and by that of contact with a change of the journal.
    pub(super) fn image_of(&self, unknown: &[f64], change: &JournalChange) -> Vec<f64> {
        let grid = &self.deflection.wall.grid;
        let contact = grid.contact_forces_change(self.problem, self.system, change.into());
        self.image_with(unknown, contact)
    }

    fn image_with(&self, unknown: &[f64], contact: Option<Vec<f64>>) -> Vec<f64> {
        let wall = &self.deflection.wall;
        let mut forces = (wall.grid).forces_change(self.problem, self.system, &self.film.unknown, unknown);
        for (force, contact) in forces.iter_mut().zip(contact.iter().flatten()) {
            *force += contact;
        }
        wall.compliance.deflection(&forces)
    }

    /// Change of the unknown by a deflection.
    pub(super) fn by_deflection(&self, coefficients: &[f64]) -> Result<Vec<f64>, Error> {
        (self.problem).answer(self.film, &self.gap.times(self.system, coefficients))
    }

    /// Solves `(I - C dp/dd) x = b`.
    pub(super) fn solve(&self, b: &[f64], accuracy: f64) -> Result<Solved, Error> {
        let operator = |x: &[f64]| {
            let image = self.image(&self.by_deflection(x)?, x);
            Ok(x.iter().zip(image).map(|(x, image)| x - image).collect())
        };
        gmres(operator, |r| self.solve_contact(r), b, accuracy)
    }

    /// Solves `x - C A x = r`, A the tangent of contact: the system without what the film answers.
    pub(super) fn solve_contact(&self, r: &[f64]) -> Vec<f64> {
        match &self.touching {
            Some(touching) => touching.solve(&self.deflection.wall.compliance, r),
            None => r.to_vec(),
        }
    }

    /// What follows from a `change` of the journal, by which the unknown changes by `unknown` at a fixed wall, to an `accuracy`.
    pub(crate) fn followed(&self, change: &JournalChange, unknown: Vec<f64>, accuracy: f64) -> Result<Followed, Error> {
        self.bent(&self.image_of(&unknown, change), unknown, accuracy)
    }

    /// What follows from a change of the unknown by `unknown`, and of the wall by `free` [m], where neither answers to the other; to an `accuracy`.
    fn bent(&self, free: &[f64], mut unknown: Vec<f64>, accuracy: f64) -> Result<Followed, Error> {
        let deflection = self.solve(free, accuracy)?.x;
        let more = self.by_deflection(&deflection)?;
        unknown
            .iter_mut()
            .zip(more)
            .for_each(|(unknown, more)| *unknown += more);
        Ok(Followed { deflection, unknown })
    }

    /// What follows where the wall alone changes by `free` [m] under the pressure that is there.
    pub(crate) fn of_wall(&self, free: &[f64]) -> Result<Followed, Error> {
        self.bent(free, vec![0.0; self.film.unknown.len()], EXACT)
    }
}
