//! Whether there is a film: the limits of the viscosity law and of the as-printed equation.

use std::sync::Arc;

use oilwedge_fem::Field;
use oilwedge_fem::newton::{NewtonFailure, NewtonStep};

use crate::lubricant::{LawKind, Lubricant, PressureLaw};
use crate::solve::Neighbour;
use crate::{FilmProblem, FilmSystem, Form, ReferenceFilm, SolvedFilm};

/// Reduced pressures beyond this many limits need no reference film.
const FAR_ABOVE: f64 = 1.2;
/// Uncertainty of the greatest reduced pressure, over its difference between film and reference film.
const SAFETY: f64 = 2.0;

/// Why there is no film to report.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum NoFilm {
    /// The viscosity law has no pressure for the reduced pressure found.
    #[error(
        "no steady film: the reduced pressure q reaches {reached:.4e} Pa, {} of the {limit:.4e} Pa at which the viscosity law makes the pressure infinite{}",
        readable(*ratio), greatest_speed.map_or(String::new(), |speed| format!(", which it reaches at {} rad/s", readable(speed)))
    )]
    AboveLimit {
        /// Greatest reduced pressure [Pa].
        reached: f64,
        /// Limit of the law [Pa].
        limit: f64,
        /// Ratio of the pressure reached to the limit.
        ratio: f64,
        /// Kind of the viscosity law.
        law: LawKind,
        /// Speed [rad/s] up to which there is a film, where it can be computed.
        greatest_speed: Option<f64>,
    },
    /// The mesh does not resolve on which side of the limit of the viscosity law the film is.
    #[error(
        "not converged: the reduced pressure q reaches {} of the {limit:.4e} Pa at which the viscosity law makes the pressure infinite, and the mesh resolves that ratio to {known_to:.1e} only, so it is not known whether there is a film",
        readable(*ratio)
    )]
    NearLimit {
        /// Limit of the law [Pa].
        limit: f64,
        /// Greatest reduced pressure over the limit, in cubic elements.
        ratio: f64,
        /// Accuracy of the ratio on this mesh.
        known_to: f64,
        /// How the film was solved.
        history: Vec<NewtonStep>,
    },
    /// Quadratic elements have a film of the as-printed equation, cubic ones on the same mesh have none.
    #[error(
        "not converged: the as-printed equation is at its fold: quadratic elements have a film at {} rad/s and cubic ones have none, so the mesh does not resolve on which side of the fold it is",
        readable(*asked)
    )]
    AtFold {
        /// Required speed [rad/s].
        asked: f64,
        /// How the film of quadratic elements was solved.
        history: Vec<NewtonStep>,
    },
    /// The pressure falls below what the viscosity law covers.
    #[error(
        "no steady film: the pressure falls below the range of the viscosity law (q = {reached:.4e} Pa below {floor:.4e} Pa)"
    )]
    BelowFloor {
        /// Least reduced pressure [Pa].
        reached: f64,
        /// Floor of the law [Pa].
        floor: f64,
    },
    /// The as-printed equation has no solution at this speed.
    #[error(
        "the as-printed equation has no solution above {} rad/s (its fold; asked for {} rad/s, {} times as much)",
        readable(*last), readable(*asked), readable(asked / last)
    )]
    Fold {
        /// Last speed with a solution [rad/s].
        last: f64,
        /// Required speed [rad/s].
        asked: f64,
    },
    /// A part of a steady mass-conserving film whose level nothing determines.
    #[error(
        "no steady film: no oil is supplied to the film near {} deg, z = {:.4} m (no feed, no flooded edge, no end above the cavitation pressure), so its level is undetermined",
        readable(angle.to_degrees()), z
    )]
    NoSupply {
        /// Angle [rad] of a place in it.
        angle: f64,
        /// Axial position [m] of that place.
        z: f64,
    },
    /// The scheme of the mass-conserving film is not positive on this mesh.
    #[error(
        "no reliable film: the film fraction is {fraction:.4} at {} deg, z = {z:.4} m, outside 0 to 1, where the scheme is not monotone ({couplings} couplings of the mesh have the wrong sign: obtuse triangles, or a film that changes much within one)",
        readable(angle.to_degrees())
    )]
    FilmFraction {
        /// The film fraction found.
        fraction: f64,
        /// Angle [rad] of its place.
        angle: f64,
        /// Axial position [m] of its place.
        z: f64,
        /// Couplings of the wrong sign in the mesh.
        couplings: usize,
    },
    /// No deflection of the wall balances the pressure of the film.
    #[error(
        "not converged: no deflection of the elastic liner was found that balances the pressure of the film: {residual:.1e} of it is left after {steps} films"
    )]
    Wall {
        /// What is left of the deflection less that by the pressure, over the deflection.
        residual: f64,
        /// Films solved.
        steps: usize,
    },
    /// The iteration failed.
    #[error("not converged: {0}")]
    NotConverged(#[from] NewtonFailure),
}

/// Six significant digits, without an exponent where that is short.
pub fn readable(value: f64) -> String {
    let rounded: f64 = format!("{value:.5e}").parse().unwrap_or(value);
    if rounded == 0.0 || (1e-4..1e7).contains(&rounded.abs()) { format!("{rounded}") } else { format!("{rounded:e}") }
}

impl NoFilm {
    /// True if there may be a film: the iteration has not found it, or the mesh does not decide it.
    pub fn is_unreached(&self) -> bool {
        match self {
            Self::NotConverged(_)
            | Self::NearLimit { .. }
            | Self::AtFold { .. }
            | Self::FilmFraction { .. }
            | Self::Wall { .. } => true,
            Self::AboveLimit { .. } | Self::BelowFloor { .. } | Self::Fold { .. } | Self::NoSupply { .. } => false,
        }
    }

    /// The iteration; empty where there was none.
    pub fn history(&self) -> &[NewtonStep] {
        match self {
            Self::NotConverged(failure) => failure.history(),
            Self::NearLimit { history, .. } | Self::AtFold { history, .. } => history,
            Self::AboveLimit { .. }
            | Self::BelowFloor { .. }
            | Self::Fold { .. }
            | Self::NoSupply { .. }
            | Self::FilmFraction { .. }
            | Self::Wall { .. } => &[],
        }
    }
}

impl FilmProblem {
    /// The problem of a film that is only tried: its viscosity saturates, so that it has a pressure beyond the limit of
    /// the viscosity law, too. That of the as-printed equation stays, whose solution is another one then.
    pub fn tried(self) -> Self {
        match self.form {
            Form::Conservative => {
                let pressure_law = self.lubricant.pressure_law.saturating();
                Self { lubricant: Lubricant { pressure_law, ..self.lubricant }, ..self }
            }
            Form::AsPrinted => self,
        }
    }
}

impl SolvedFilm {
    /// A film that was [tried](FilmProblem::tried), under the viscosity `law` of its oil.
    ///
    /// # Errors
    /// The law has no pressure for the film, or it is so near to the limit that the mesh does not tell.
    pub fn accepted(self, law: &PressureLaw) -> Result<Self, NoFilm> {
        if !matches!(self.problem.lubricant.pressure_law, PressureLaw::Saturating(_)) {
            return Ok(self);
        }
        let is_exact = self.is_within_law();
        let lubricant = Lubricant { pressure_law: law.clone(), ..self.problem.lubricant };
        let film = Self { problem: FilmProblem { lubricant, ..self.problem }, ..self };
        match is_exact {
            true => Ok(film),
            false => Err(film.beyond(law.limit())),
        }
    }

    /// Whether the viscosity law of its oil has a pressure for a film that was [tried](FilmProblem::tried): one that
    /// saturates has every pressure.
    pub fn is_within_law(&self) -> bool {
        match &self.problem.lubricant.pressure_law {
            PressureLaw::Saturating(tried) => tried.is_exact(self.greatest_unknown().value),
            _ => true,
        }
    }

    /// A reduced pressure at or above the limit of the viscosity law has no pressure. The unknown of the as-printed
    /// equation is the pressure itself, which may be of any size.
    pub(crate) fn check_existence(&self) -> Result<(), NoFilm> {
        let Self { problem, system, solution } = self;
        if problem.form == Form::AsPrinted {
            return Ok(());
        }
        let law = &problem.lubricant.pressure_law;
        let (limit, floor) = (law.limit(), law.floor());
        if limit == f64::INFINITY && floor == f64::NEG_INFINITY {
            return Ok(());
        }
        let reached = self.greatest_unknown().value;
        if reached >= limit {
            return Err(NoFilm::AboveLimit {
                reached,
                limit,
                ratio: reached / limit,
                law: law.kind(),
                greatest_speed: None,
            });
        }
        let field = Field { space: system.space(), values: &solution.unknown };
        let least = field.minimum().value;
        // Pressures that a cavitation model drops need no viscosity.
        let dropped = (problem.cavitation.pressure()).is_some_and(|p| problem.unknown_at(p) > floor);
        if least <= floor && !dropped {
            return Err(NoFilm::BelowFloor { reached: least, floor });
        }
        Ok(())
    }

    /// The reason where the greatest reduced pressure of the film, or that of its reference film, exceeds the `limit`
    /// [Pa] of the viscosity law: that there is no film, or that the mesh does not resolve it.
    pub(crate) fn beyond(&self, limit: f64) -> NoFilm {
        let reached = self.greatest_unknown().value;
        let plainly = NoFilm::AboveLimit {
            reached,
            limit,
            ratio: reached / limit,
            law: self.problem.lubricant.pressure_law.kind(),
            greatest_speed: None,
        };
        // What a film held before is known on its own mesh alone.
        if reached > FAR_ABOVE * limit || self.problem.storage.is_some() {
            return plainly;
        }
        let Ok(reference) = self.reference_film_unchecked() else {
            return plainly;
        };
        let other = reference.film().greatest_unknown().value;
        let (better, other) = match reference {
            ReferenceFilm::Cubic(_) => (other, reached),
            ReferenceFilm::Coarse { .. } => (reached, other),
        };
        let known_to = SAFETY * (better - other).abs() / limit;
        match better / limit - 1.0 > known_to {
            true => plainly,
            false => {
                NoFilm::NearLimit { limit, ratio: better / limit, known_to, history: self.solution.history.clone() }
            }
        }
    }

    /// Checks that a film is below the limit of the viscosity law by more than its `coarse` comparison differs from it.
    pub(crate) fn check_resolved(&self, coarse: &Self) -> Result<(), NoFilm> {
        let limit = self.problem.lubricant.pressure_law.limit();
        let reached = self.greatest_unknown().value;
        let other = coarse.greatest_unknown().value;
        let (ratio, known_to) = (reached / limit, SAFETY * (reached - other).abs() / limit);
        match limit.is_finite() && ratio + known_to > 1.0 {
            true => Err(NoFilm::NearLimit { limit, ratio, known_to, history: self.solution.history.clone() }),
            false => Ok(()),
        }
    }
}

impl FilmProblem {
    /// The greatest speed [rad/s] with a film, by regula falsi (Illinois) between a speed that has one and this one.
    pub(crate) fn greatest_speed(&self, system: &Arc<FilmSystem>, limit: f64) -> Option<f64> {
        const HALVINGS: usize = 40;
        const STEPS: usize = 60;
        if !self.journal.is_still() {
            return None;
        }
        let above = |motion: f64| {
            let solution = self.closed_film(system, motion, Neighbour::None).ok()?;
            Some(SolvedFilm::new(self.clone(), system, solution).greatest_unknown().value / limit - 1.0)
        };
        let (mut low, mut high) = (0.5, 1.0);
        let (mut at_low, mut at_high) = (above(low)?, above(high)?);
        for _ in 0..HALVINGS {
            if at_low < 0.0 {
                break;
            }
            (high, at_high) = (low, at_low);
            low *= 0.5;
            at_low = above(low)?;
        }
        let mut side = 0;
        for _ in 0..STEPS {
            let next = (low * at_high - high * at_low) / (at_high - at_low);
            let at_next = above(next)?;
            if at_next.abs() < 1e-10 || (high - low) < 1e-12 {
                return (at_low < 0.0).then_some(next * self.journal.speed.abs());
            }
            if at_next < 0.0 {
                (low, at_low) = (next, at_next);
                at_high *= if side == -1 { 0.5 } else { 1.0 };
                side = -1;
            } else {
                (high, at_high) = (next, at_next);
                at_low *= if side == 1 { 0.5 } else { 1.0 };
                side = 1;
            }
        }
        None
    }
}
