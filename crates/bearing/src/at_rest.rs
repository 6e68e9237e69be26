//! The balance of a mass-conserving film whose advection schemes are those of its position.
//!
//! On the way to a balance the schemes are kept, so that Newton's method has a film that changes smoothly; chosen anew at the balance they may differ, and with them the balance. So both are found in turn,
//! until a choice leaves the balance as it is, or comes back.

use std::sync::Arc;

use oilwedge_reynolds::cavitation::AdvectionScheme;
use oilwedge_reynolds::solve::Neighbour;
use oilwedge_reynolds::{Fallback, NoFilm};

use crate::NoEquilibrium;
use crate::balance::Balance;
use crate::search::{OF_BALANCE, Search, Trial};

/// A balance that round-off keeps from its accuracy is one below this part.
pub(crate) const BALANCED_ENOUGH: f64 = 1e-10;
/// Advection schemes chosen where force and load differ by less than this part of the load are those of the balanced position.
pub(crate) const SETTLED: f64 = 1e-6;
/// Until then a balance to this part of the residual at which they were chosen is enough to choose them again.
const RECHOSEN: f64 = 1e-3;
/// Most choices of the advection schemes: the last is that of the balanced position, if they settle.
const MOST_CHOICES: usize = 6;

impl Search<'_> {
    /// Balances the load and, in a film that conserves oil, chooses the advection schemes again at the balanced
    /// position until they settle.
    pub(crate) fn at_rest(&self, first: Trial) -> Result<Balance, NoEquilibrium> {
        let deadline = self.options.deadline;
        let mut tried = 1;
        // A position on a coarser mesh is only a start.
        let has_schemes = first.film.solution.film_fraction.is_some();
        let must_settle = has_schemes && !self.options.keeps_schemes() && self.options.balanced() <= BALANCED_ENOUGH;
        let at_rest = |trial: &Trial| !must_settle || trial.schemes_chosen_at < SETTLED;
        let takes_long = self.is_costly(&first) || first.film.problem.deflection().is_some();
        let part = match must_settle && takes_long {
            true => RECHOSEN,
            false => 0.0,
        };
        let (mut trial, mut tangent) = self.balanced(first, None, part, &mut tried)?;
        let mut choices: Vec<Vec<AdvectionScheme>> = Vec::new();
        while choices.len() < MOST_CHOICES && !at_rest(&trial) && !deadline.is_over() {
            tried += 1;
            // Where the choice fails the position balanced before stands, with the schemes chosen near it;
            let Ok(chosen) = self.chosen_anew(&trial) else {
                break;
            };
            // likewise where one from before the last comes back: it would do so for ever.
            let chosen_now = schemes(&chosen);
            if choices.iter().rev().skip(1).any(|choice| choice == chosen_now) {
                break;
            }
            choices.push(chosen_now.to_vec());
            match self.balanced(chosen, tangent.clone(), part, &mut tried) {
                Ok(balanced) => (trial, tangent) = balanced,
                Err(_) => break,
            }
        }
        if part > 0.0 {
            (trial, tangent) = self.balanced(trial, tangent, 0.0, &mut tried)?;
        }
        let at_rest = at_rest(&trial);
        if !at_rest && !deadline.is_over() {
            Arc::make_mut(&mut trial.film.solution).fallbacks.push(Fallback::SchemesNearPosition);
        }
        let is_closed = trial.may_leave <= self.left_at_balance().max(BALANCED_ENOUGH);
        let is_balanced = at_rest && is_closed && self.residual(&trial) < self.options.balanced().max(BALANCED_ENOUGH);
        Ok(Balance { is_ended: !is_balanced && deadline.is_over(), trial, tangent, tried })
    }

    /// The film at the place of a trial, and under its wall where that is bent, with advection schemes chosen anew.
    fn chosen_anew(&self, trial: &Trial) -> Result<Trial, NoFilm> {
        let here = self.coordinates.at(&trial.film.problem.journal);
        match self.opened(&trial.film.problem, here, Neighbour::None, self.left_at_balance()) {
            Some(opened) => Ok(opened),
            None => self.trial_within(&trial.film.problem, here, Neighbour::None, OF_BALANCE * SETTLED),
        }
    }
}

/// How the oil of each sub-triangle of a film that conserves it is carried; nothing in other films.
fn schemes(trial: &Trial) -> &[AdvectionScheme] {
    trial.film.solution.film_fraction.as_ref().map_or(&[], |film| &film.schemes)
}
