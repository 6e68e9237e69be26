//! What closes the law where the film breaks: exactly one model.
//!
//! | model | what it does | what it gets wrong |
//! |---|---|---|
//! | none (full Sommerfeld) | nothing: pressures may fall below zero | tension that oil does not bear |
//! | Guembel (half Sommerfeld) | drops pressures below p_cav after the solve | oil appears and vanishes at the edge of the film |
//! | Reynolds (Swift-Stieber) | an obstacle problem, p >= p_cav | oil appears where the film forms again |
//! | JFO (mass conserving) | carries a film fraction through the cavity, [`jfo`] | streaks are a mixture without inertia |
//!
//! `docs/theory/cavitation.md` has the equations and how well each is solved.

pub mod jfo;

pub use jfo::FilmFraction;

/// The closure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Cavitation {
    /// Full Sommerfeld film.
    None,
    /// Pressure below `pressure` [Pa gauge] is raised to it after the solve.
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
        match *self {
            Self::None | Self::Reynolds { .. } | Self::Jfo { .. } => p,
            Self::Guembel { pressure } => p.max(pressure),
        }
    }

    /// The cavitation pressure [Pa gauge], if the model has one.
    pub fn pressure(&self) -> Option<f64> {
        match *self {
            Self::None => None,
            Self::Guembel { pressure } | Self::Reynolds { pressure } | Self::Jfo { pressure } => Some(pressure),
        }
    }

    /// True where it leaves the pressure of a cavity but no film fraction: such a cavity makes oil.
    pub fn drops_pressures(&self) -> bool {
        matches!(self, Self::Guembel { .. } | Self::Reynolds { .. })
    }

    /// The pressure [Pa] at which the effective pressure has a kink, if it has one.
    pub fn kink(&self) -> Option<f64> {
        match *self {
            Self::None | Self::Reynolds { .. } | Self::Jfo { .. } => None,
            Self::Guembel { pressure } => Some(pressure),
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
}
