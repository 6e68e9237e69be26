//! The cavitation model, which closes the law where the film breaks: each film has exactly one.
//!
//! | model | what it does | what it gets wrong |
//! |---|---|---|
//! | none (full Sommerfeld) | nothing: pressures may fall below zero | tension that oil does not bear |
//! | Guembel (half Sommerfeld) | drops pressures below p_cav after the solve | oil is not balanced at the edge |
//! | Reynolds (Swift-Stieber) | an obstacle problem, p >= p_cav | oil appears where the film schemes again |
//! | JFO (mass conserving) | carries a film fraction through the cavity | streaks are a mixture without inertia |
//!
//! `docs/theory/cavitation.md` has the equations and how well each is solved.

mod jfo;

use oilwedge_fem::complementarity::WarmStart;
use oilwedge_fem::newton::NewtonFailure;

pub use jfo::FilmFraction;
pub(crate) use jfo::{
    Carriage, FilmSides, PointChanges, cell_volumes, check_supply, chord, film_sides, held_volume, oil_carried,
    residual_changes, spread, work,
};

use crate::film_start::StepBudget;
use crate::lubricant::PressureLaw;
use crate::{FilmProblem, FilmSolution, FilmSystem, NoFilm};

/// The cavitation model of a film.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Cavitation {
    /// Full Sommerfeld film.
    None,
    /// Guembel's half film: pressures below `pressure` [Pa gauge] are raised to it after the solve.
    Guembel {
        /// Cavitation pressure [Pa gauge].
        pressure: f64,
    },
    /// Swift-Stieber: the pressure nowhere falls below `pressure` [Pa gauge].
    Reynolds {
        /// Cavitation pressure [Pa gauge].
        pressure: f64,
    },
    /// Jakobsson-Floberg-Olsson: mass conserving, with a film fraction where the pressure is `pressure` [Pa gauge].
    Jfo {
        /// Cavitation pressure [Pa gauge].
        pressure: f64,
    },
}

impl Cavitation {
    /// The pressure [Pa] that the film exerts where the equation gives `p`.
    pub fn effective_pressure(&self, p: f64) -> f64 {
        self.kink().map_or(p, |kink| p.max(kink))
    }

    /// The cavitation pressure [Pa gauge], if the model has one.
    pub fn pressure(&self) -> Option<f64> {
        match *self {
            Self::None => None,
            Self::Guembel { pressure } | Self::Reynolds { pressure } | Self::Jfo { pressure } => Some(pressure),
        }
    }

    /// The pressure [Pa gauge] at which the effective pressure has a kink: lower ones are raised to it after the solve.
    pub fn kink(&self) -> Option<f64> {
        match *self {
            Self::Guembel { pressure } => Some(pressure),
            Self::None | Self::Reynolds { .. } | Self::Jfo { .. } => None,
        }
    }

    /// The pressure [Pa gauge] that bounds the solution of an obstacle problem from below.
    pub fn obstacle(&self) -> Option<f64> {
        match *self {
            Self::Reynolds { pressure } => Some(pressure),
            Self::None | Self::Guembel { .. } | Self::Jfo { .. } => None,
        }
    }

    /// A cheaper closure whose film has no less pressure anywhere at one position of the journal, for films that
    /// conserve oil: a guide of searches.
    pub fn guide(&self) -> Option<Self> {
        match *self {
            Self::Jfo { pressure } => Some(Self::Reynolds { pressure }),
            Self::None | Self::Guembel { .. } | Self::Reynolds { .. } => None,
        }
    }

    /// True if the film bears tension.
    pub fn bears_tension(&self) -> bool {
        matches!(self, Self::None)
    }

    /// True if oil is conserved through the cavity, by a film fraction.
    pub fn conserves_oil(&self) -> bool {
        matches!(self, Self::Jfo { .. })
    }

    /// True if the cavity bounds the pressure but has no film fraction: such a cavity makes oil.
    pub fn drops_pressures(&self) -> bool {
        matches!(self, Self::Guembel { .. } | Self::Reynolds { .. })
    }

    /// True if the edge of the cavity is part of the solution and is found by iteration.
    pub fn has_free_boundary(&self) -> bool {
        matches!(self, Self::Reynolds { .. } | Self::Jfo { .. })
    }

    /// True if the linear systems are symmetric: solved by Cholesky factors and multigrid, on quadratic and cubic
    /// elements.
    pub fn is_symmetric(&self) -> bool {
        !self.conserves_oil()
    }

    /// The order s of the bar of a load on quadratic elements, `bar ~ unknowns^-s`: 3 where the film is linear and
    /// smooth, so that the law of smooth films holds ([`crate::error_bar`]), 2 with a kink or a viscosity that grows
    /// with pressure, 7/4 where the elements meet a free boundary, 1 for control volumes.
    pub fn convergence_order(&self, pressure_law: &PressureLaw) -> f64 {
        match (self, pressure_law) {
            (Self::None, PressureLaw::Constant) => 3.0,
            (Self::None | Self::Guembel { .. }, _) => 2.0,
            (Self::Reynolds { .. }, _) => 1.75,
            (Self::Jfo { .. }, _) => 1.0,
        }
    }

    /// The order with which the bar of a load falls from a coarse mesh to one for a tolerance: that of the error or, of
    /// control volumes, 1.15. Their bar counts the places where two meshes do not agree on the cavity, too, which
    /// become fewer; of random bearings three bars in four fall so fast or faster.
    pub fn bar_order(&self, pressure_law: &PressureLaw) -> f64 {
        match self {
            Self::Jfo { .. } => 1.15,
            Self::None | Self::Guembel { .. } | Self::Reynolds { .. } => self.convergence_order(pressure_law),
        }
    }

    /// Name in reports.
    pub fn name(&self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Guembel { .. } => "guembel",
            Self::Reynolds { .. } => "reynolds",
            Self::Jfo { .. } => "jfo",
        }
    }

    /// Solves the film of a problem on a system from `start`, all motion of the journal scaled by a factor.
    pub(crate) fn solve(
        &self,
        (problem, system, motion): (&FilmProblem, &FilmSystem, f64),
        start: WarmStart,
        steps: StepBudget,
    ) -> Result<FilmSolution, NoFilm> {
        match self {
            Self::Jfo { .. } => jfo::solve((problem, system, motion), start, steps),
            _ => {
                let solver = system.solver().map_err(NewtonFailure::from)?;
                Ok(problem.pressure_film((system, &solver, motion), start, steps)?)
            }
        }
    }
}
