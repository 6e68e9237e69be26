//! # Storage: oil that the film holds from one time to the next
//!
//! **Equation.** `div J + d(theta h)/dt = 0`. Over the cell of a node, with the volume V that it holds when it is full,
//! an implicit stage of a method in time takes up `(V theta - m)/(gamma dt)` [m3/s], m [m3] being what earlier stages
//! leave to it. Where the film is and was full this is `V dh/dt / h`, as squeeze has it; where it breaks, the film
//! fraction follows from what the cell held.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | 1/(gamma dt) | 1/s | `per_time` |
//! | m | m3 | `known` |
//! | V theta | m3 | [`SolvedFilm::oil_held`] |
//!
//! **Source.** Elrod, J. Lubr. Technol. 103 (1981) 350. **Range.** Mass-conserving films; the mesh stays.
//! **Verified by** `tests/tests/orbit/storage.rs`: plates that are squeezed, and orders in time.

use oilwedge_fem::Error;

use crate::cavitation;
use crate::{FilmProblem, FilmSystem, NoFilm, SolvedFilm};

/// What a mass-conserving film held before.
#[derive(Debug, Clone, PartialEq)]
pub struct Storage {
    /// `1/(gamma dt)` [1/s].
    pub per_time: f64,
    /// Oil m of the cell of each dof [m3].
    pub known: Vec<f64>,
}

impl SolvedFilm {
    /// Oil [m3] that the cell of each dof holds; none of films without a film fraction.
    ///
    /// # Errors
    /// The sub-mesh does not fit in memory.
    pub fn oil_held(&self) -> Result<Option<Vec<f64>>, Error> {
        let Some(fraction) = &self.solution.film_fraction else {
            return Ok(None);
        };
        let mut held = cavitation::cell_volumes(&self.problem, &self.system)?;
        held.iter_mut().zip(&fraction.values).for_each(|(held, theta)| *held *= theta);
        Ok(Some(held))
    }
}

impl FilmProblem {
    /// Oil [m3] that the cell of each dof holds where the film is full.
    ///
    /// # Errors
    /// The sub-mesh does not fit in memory.
    pub fn oil_of_full_film(&self, system: &FilmSystem) -> Result<Vec<f64>, Error> {
        cavitation::cell_volumes(self, system)
    }

    /// A place, angle [rad] and z [m], of a mass-conserving film that no feed, flooded edge or end supplies: how much
    /// oil is there follows from what was there before.
    pub fn place_without_supply(&self, system: &FilmSystem) -> Option<[f64; 2]> {
        if !self.cavitation.conserves_oil() {
            return None;
        }
        match cavitation::check_supply(self, system) {
            Err(NoFilm::NoSupply { angle, z }) => Some([angle, z]),
            _ => None,
        }
    }
}

impl Storage {
    /// What each cell takes up [m3/s] that holds `held` [m3].
    pub fn taken_up(&self, held: &[f64]) -> Vec<f64> {
        let rate = |(held, known): (&f64, &f64)| (held - known) * self.per_time;
        held.iter().zip(&self.known).map(rate).collect()
    }
}
