//! The tangent of journal and wall together, nearly solved by that of a film much like it.
//!
//! ```text
//! W_x x + W_d d = r        d - C (p_d d + p_x x) = s
//! ```
//!
//! The film in cubic elements has no factor: a back-solve is iterated, and takes some fifteen times as long as one of
//! the quadratic film. So nothing is eliminated, and each direction of GMRES for x and d is the solution of the
//! [`Joint`] of the quadratic film. A product costs one back-solve.

use std::cell::RefCell;

use oilwedge_fem::Error;
use oilwedge_reynolds::quantities::LoadGradient;
use oilwedge_reynolds::{CentreVelocity, JournalChange, MixedChange};

use super::gmres::KrylovSpace;
use super::joint::{Joint, Moves};
use super::tangent::Follower;
use crate::coordinates::{Coordinates, Vector};

/// Film, wall and journal.
pub(crate) struct Bordered<'a> {
    follower: Follower<'a>,
    /// Coordinates of the journal that are free.
    coordinates: Coordinates,
    /// Velocity of its centre.
    velocity: CentreVelocity,
    /// Stiffness [N/m] that acts on its coordinates beside the film.
    held: Vector,
    /// How forces change with film and wall.
    gradient: LoadGradient,
    /// What a force counts beside a deflection [m/N].
    weight: f64,
    /// To which its linear systems are solved: norm of the residual over that of the right-hand side [1].
    accuracy: f64,
    /// Tangent of the quadratic film, which is much like this one.
    near: Joint<'a>,
    /// What systems solved have shown.
    known: RefCell<KrylovSpace>,
}

impl<'a> Bordered<'a> {
    /// The tangent for a journal with these `coordinates`, on which `held` [N/m] acts too, and whose centre moves so.
    /// One newton counts as much as `weight` [m/N]; linear systems are solved to an `accuracy`, nearly by those of
    /// another film.
    pub(crate) fn of(
        follower: Follower<'a>,
        (coordinates, velocity, held): (Coordinates, CentreVelocity, Vector),
        (weight, accuracy): (f64, f64),
        near: Joint<'a>,
    ) -> Self {
        Self {
            gradient: follower.load_gradient(),
            follower,
            coordinates,
            velocity,
            held,
            weight,
            accuracy,
            near,
            known: RefCell::default(),
        }
    }

    /// The moves by which forces change by `force` [N], and the wall by `wall` [m] more than film and contact bend it,
    /// or by no more.
    ///
    /// # Errors
    /// The linear systems could not be solved.
    pub(crate) fn solve(&self, force: Vector, wall: Option<&[f64]>) -> Result<Moves, Error> {
        let nothing = vec![0.0; self.follower.number()];
        let wanted = self.together(force.map(|part| self.weight * part), wall.unwrap_or(&nothing));
        let operator = |both: &[f64]| self.image(both);
        let nearly = |both: &[f64]| {
            let (force, wall) = self.apart(both);
            let moves = self.near.solve(force.map(|part| part / self.weight), Some(wall))?;
            Ok(self.together(moves.place, &moves.wall))
        };
        let solved = (self.known.borrow_mut()).solve(operator, nearly, &wanted, self.accuracy)?;
        let (place, wall) = self.apart(&solved.x);
        Ok(Moves {
            place,
            contact: (self.follower.contact_by_both(&self.change(place), wall))
                .map_or_else(Vec::new, |(_, forces)| forces),
            wall: wall.to_vec(),
            film: MixedChange::default(),
            kelvin: 0.0,
            products: solved.steps,
        })
    }

    /// The tangent of the film much like this one.
    pub(crate) fn near(&self) -> &Joint<'a> {
        &self.near
    }

    /// What coordinates and a move of the wall change: weighed forces [m], and the part of that move that film and
    /// contact do not make [m].
    fn image(&self, both: &[f64]) -> Result<Vec<f64>, Error> {
        let (place, wall) = self.apart(both);
        let change = self.change(place);
        let unknown = self.follower.by_both(&change, wall, self.accuracy)?;
        let mut carried = self.gradient.change(&unknown, wall);
        let contact = self.follower.contact_by_both(&change, wall).map(|(by_journal, forces)| {
            carried += by_journal;
            forces
        });
        let forces = self.coordinates.forces(&carried);
        let forces = [0, 1, 2, 3].map(|k| self.weight * (forces[k] + self.held[k] * place[k]));
        let image = self.follower.image_with(&unknown, contact.as_deref());
        let left: Vec<f64> = wall.iter().zip(image).map(|(d, image)| d - image).collect();
        Ok(self.together(forces, &left))
    }

    /// The change of a journal that moves by coordinates.
    fn change(&self, place: Vector) -> JournalChange {
        (self.coordinates).change(&self.follower.film.problem.journal, &self.velocity, place)
    }

    /// What goes with the coordinates that are free, and what goes with the wall.
    fn together(&self, of_place: Vector, of_wall: &[f64]) -> Vec<f64> {
        [&of_place[..self.coordinates.order], of_wall].concat()
    }

    fn apart<'b>(&self, both: &'b [f64]) -> (Vector, &'b [f64]) {
        let (free, of_wall) = both.split_at(self.coordinates.order);
        let mut of_place = [0.0; 4];
        of_place[..free.len()].copy_from_slice(free);
        (of_place, of_wall)
    }
}
