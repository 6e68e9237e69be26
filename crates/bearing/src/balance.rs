//! A balance found in a search, from which the [`Equilibrium`] is made that is reported: one on the way to it needs no
//! tangent.

use crate::NoEquilibrium;
use crate::equilibrium::Equilibrium;
use crate::search::{Search, Trial};

/// A journal in balance.
pub(crate) struct JournalBalance {
    /// Film of the journal.
    pub(crate) trial: Trial,
    /// Positions tried.
    pub(crate) tried: usize,
    /// True where the deadline passed before.
    pub(crate) is_ended: bool,
}

impl Search<'_> {
    /// A balance with its tangent.
    ///
    /// # Errors
    /// The linear systems of the tangent could not be solved.
    pub(crate) fn equilibrium(&self, balance: JournalBalance) -> Result<Equilibrium, NoEquilibrium> {
        let JournalBalance { trial, tried, is_ended } = balance;
        let tangent = self.tangent(&trial)?;
        let warming = self.found_warmth(&trial)?;
        let residual = self.residual(&trial);
        Ok(Equilibrium {
            residual,
            unbalanced: residual * self.scale,
            parts: self.parts(&trial),
            coordinates: self.coordinates,
            steps: tried,
            work: self.record().work,
            is_ended,
            stiffness: tangent.stiffness,
            wall: tangent.wall,
            warming,
            film: trial.film,
            cubic: trial.cubic,
        })
    }
}
