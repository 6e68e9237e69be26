//! The tangent of journal and wall together, where both move in a stage.
//!
//! ```text
//! K x + W_d d = r        d - C (p_d d + p_x x) = s        K: at a fixed wall
//! ```
//!
//! The journal is eliminated, `x = K^-1 (r - W_d d)`, and the wall found by GMRES: one back-solve of the film a
//! product. Under a given load the wall answers less than at a given place.

use std::cell::RefCell;

use oilwedge_fem::Error;
use oilwedge_reynolds::film_thickness::Deflection;
use oilwedge_reynolds::quantities::LoadGradient;
use oilwedge_reynolds::quantities::load::Resultant;
use oilwedge_reynolds::{FilmChange, JournalChange, MixedChange};

use super::gmres::KrylovSpace;
use super::tangent::{Follower, Free};
use crate::coordinates::{Coordinates, Vector, moved};
use crate::stiffness::Stiffness;

/// Film, wall and journal.
pub(crate) struct Joint<'a> {
    follower: Follower<'a>,
    coordinates: Coordinates,
    /// What the pressures of a move by each coordinate bend the wall by, where it is held [m/m].
    bent_by_place: Vec<Vec<f64>>,
    /// How the film changes with each coordinate, the wall held.
    film_by_place: Vec<MixedChange>,
    /// By what contact then presses the wall [N/m]; none where no contact is simulated.
    contact_by_place: Vec<Vec<f64>>,
    /// K: that of the forces at a fixed wall [N/m].
    tangent: Stiffness,
    /// How forces change with film and wall.
    gradient: LoadGradient,
    /// To which its linear systems are solved: norm of the residual over that of the right-hand side [1].
    accuracy: f64,
    /// What systems solved have shown.
    known: RefCell<KrylovSpace>,
}

/// A change of the journal and of the wall.
#[derive(Debug, Clone, Default)]
pub(crate) struct Moves {
    /// Coordinates [m].
    pub(crate) place: Vector,
    /// Coefficients of the deflection [m].
    pub(crate) wall: Vec<f64>,
    /// Forces of contact on the splines of the wall [N]; none where no contact is simulated.
    pub(crate) contact: Vec<f64>,
    /// Change of the quadratic film; empty where it is not known.
    pub(crate) film: MixedChange,
    /// Step of the temperature, where that is unknown [K].
    pub(crate) kelvin: f64,
    /// Products with the tangent that they took.
    pub(crate) products: usize,
}

impl Moves {
    /// The moves divided by a number.
    pub(crate) fn over(&self, number: f64) -> Self {
        Self {
            place: self.place.map(|x| x / number),
            wall: self.wall.iter().map(|d| d / number).collect(),
            contact: self.contact.iter().map(|force| force / number).collect(),
            film: MixedChange::sum([(1.0 / number, &self.film)]),
            kelvin: self.kelvin / number,
            products: self.products,
        }
    }

    /// The sum of these moves and a part of others.
    pub(crate) fn plus(&self, part: f64, more: &Self) -> Self {
        let both = |here: &[f64], more: &[f64]| here.iter().zip(more).map(|(here, more)| here + part * more).collect();
        Self {
            place: moved(self.place, part, more.place),
            wall: both(&self.wall, &more.wall),
            contact: both(&self.contact, &more.contact),
            film: MixedChange::sum([(1.0, &self.film), (part, &more.film)]),
            kelvin: self.kelvin + part * more.kelvin,
            products: self.products + more.products,
        }
    }

    /// The moves with so much more change of the film.
    pub(crate) fn with_film(mut self, more: &MixedChange) -> Self {
        self.film = MixedChange::sum([(1.0, &self.film), (1.0, more)]);
        self
    }

    /// Where a part of them leads from a place and a wall.
    pub(crate) fn made(&self, at: Vector, wall: &Deflection, part: f64) -> (Vector, Deflection) {
        let coefficients = wall.coefficients.iter().zip(&self.wall);
        let bent = coefficients.map(|(d, more)| d + part * more).collect();
        (moved(at, part, self.place), wall.with(bent))
    }
}

impl<'a> Joint<'a> {
    /// The tangent for a journal that changes by `change(k)` with coordinate k, on whose coordinates `held` [N/m] acts
    /// too; its linear systems are solved to an `accuracy`.
    ///
    /// # Errors
    /// The linear systems could not be solved.
    pub(crate) fn of(
        follower: Follower<'a>,
        coordinates: Coordinates,
        change: impl Fn(usize) -> JournalChange,
        held: Vector,
        accuracy: f64,
    ) -> Result<Self, Error> {
        let order = coordinates.order;
        let (mut bent_by_place, mut contact_by_place) = (Vec::with_capacity(order), Vec::new());
        let mut film_by_place = Vec::with_capacity(order);
        let mut columns = [[0.0; 4]; 4];
        let gradient = follower.load_gradient();
        for (k, column) in columns.iter_mut().enumerate().take(order) {
            let free = follower.free_within(&change(k), accuracy)?;
            *column = coordinates.forces(&carried(&gradient, &free));
            bent_by_place.push(follower.image_of(&free));
            contact_by_place.extend(free.contact.map(|(_, forces)| forces));
            film_by_place.push(free.film);
        }
        let tangent = Stiffness::by_columns(order, |k| Ok::<_, Error>(columns[k]))?.with_diagonal(held);
        Ok(Self {
            gradient,
            accuracy,
            follower,
            coordinates,
            bent_by_place,
            contact_by_place,
            film_by_place,
            tangent,
            known: RefCell::default(),
        })
    }

    /// The moves by which forces change by `force` [N], and the wall by `wall` [m] more than film and contact bend it,
    /// or by no more.
    ///
    /// # Errors
    /// The linear systems could not be solved.
    pub(crate) fn solve(&self, force: Vector, wall: Option<&[f64]>) -> Result<Moves, Error> {
        let operator = |d: &[f64]| {
            let (forces, image, _) = self.by_wall(d)?;
            let place = self.tangent.solve(forces.map(|part| -part));
            Ok::<_, Error>(self.bent(d.iter().zip(&image).map(|(d, image)| d - image).collect(), place))
        };
        let pushed = self.tangent.solve(force);
        let more = wall.map_or_else(|| vec![0.0; self.follower.number()], <[f64]>::to_vec);
        let wanted: Vec<f64> = self.bent(more, pushed.map(|part| -part));
        let nearly = |d: &[f64]| Ok(self.follower.solve_contact(d));
        let solved = (self.known.borrow_mut()).solve(operator, nearly, &wanted, self.accuracy)?;
        let wall = solved.x;
        let (forces, _, by_wall) = self.by_wall(&wall)?;
        let place = self.tangent.solve(moved(force, -1.0, forces));
        let film = MixedChange::sum(place.into_iter().zip(&self.film_by_place).chain([(1.0, &by_wall)]));
        Ok(Moves { place, contact: self.contact_by(place, &wall), wall, film, products: solved.steps, kelvin: 0.0 })
    }

    /// The moves that follow, under the same load, from a change of the film other than of its gap.
    ///
    /// # Errors
    /// The linear systems could not be solved.
    pub(crate) fn following(&self, change: FilmChange) -> Result<Moves, Error> {
        let film = self.follower.film.mixed_changes(&[change])?.remove(0);
        let unknown = self.follower.film.unknown_in(&film);
        let forces = self.coordinates.forces(&self.gradient.change(&unknown, &[]));
        let moves = self.solve(forces.map(|force| -force), Some(&self.follower.image_with(&unknown, None)))?;
        Ok(moves.with_film(&film))
    }

    /// What a journal that moves at these rates [1/s of coordinates in m] and a wall that moves at this one [m/s] push
    /// film and wall by: forces [N], and how far the wall is bent [m].
    ///
    /// # Errors
    /// The linear systems could not be solved.
    pub(crate) fn pushed(&self, change: &JournalChange, rate: &[f64]) -> Result<(Vector, Vec<f64>), Error> {
        let shape = self.follower.shape(rate);
        let mut free = self.follower.free(change)?;
        let by_wall = self.follower.film.unknown_change(FilmChange::GapRate(&shape))?;
        free.unknown.iter_mut().zip(by_wall).for_each(|(a, b)| *a += b);
        Ok((self.coordinates.forces(&carried(&self.gradient, &free)), self.follower.image_of(&free)))
    }

    /// Forces [N] of film and contact by a move of the wall, the journal held; what the pressures bend the wall by [m];
    /// and the change of the film.
    fn by_wall(&self, d: &[f64]) -> Result<(Vector, Vec<f64>, MixedChange), Error> {
        let change = self.follower.film_by_deflection(d, self.accuracy)?;
        let unknown = self.follower.film.unknown_in(&change);
        let carried = self.gradient.change(&unknown, d);
        Ok((self.coordinates.forces(&carried), self.follower.image(&unknown, d), change))
    }

    /// Forces [N] of contact on the splines by a move of the journal and of the wall; none where no contact is
    /// simulated.
    fn contact_by(&self, place: Vector, wall: &[f64]) -> Vec<f64> {
        let mut forces = self.follower.contact_times(wall).unwrap_or_default();
        for (pressed, by) in self.contact_by_place.iter().zip(place) {
            forces.iter_mut().zip(pressed).for_each(|(force, pressed)| *force += by * pressed);
        }
        forces
    }

    /// `d - C p_x x`.
    fn bent(&self, mut d: Vec<f64>, place: Vector) -> Vec<f64> {
        for (bent, by) in self.bent_by_place.iter().zip(place) {
            d.iter_mut().zip(bent).for_each(|(d, bent)| *d -= by * bent);
        }
        d
    }
}

/// Change of what the journal carries, the wall held.
fn carried(gradient: &LoadGradient, free: &Free) -> Resultant {
    let mut carried = gradient.change(&free.unknown, &[]);
    carried += free.by_contact();
    carried
}
