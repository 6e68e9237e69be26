//! Damped Newton iteration on `R(u) = 0` with given dofs.
//!
//! Steps `T d = -R` are halved until the residual falls. Converged when a step no longer changes
//! the solution to [`STEP_TOLERANCE`]: the tangent is exact, so what is left is its square.
//! A linear law needs one step and nothing to test.

use crate::conservation_law::{ConservationLaw, TangentKind};
use crate::{Assembler, Constraints, Error, LinearSolver, Linearisation, Matrix};

/// Relative size (greatest value) of a step after which its square is below rounding.
pub const STEP_TOLERANCE: f64 = 1e-9;
/// Most steps of one solve.
const MOST_STEPS: usize = 40;
/// Most halvings of one step.
const MOST_HALVINGS: usize = 12;

/// One step of an iteration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NewtonStep {
    /// Norm of the residual over the free dofs, relative to the first.
    pub residual: f64,
    /// Fraction of the full step taken.
    pub damping: f64,
    /// Dofs held at an obstacle.
    pub active: usize,
}

impl NewtonStep {
    /// A full step of an active-set iteration.
    pub fn active(residual: f64, active: usize) -> Self {
        Self { residual, damping: 1.0, active }
    }
}

/// Why an iteration ended without a solution.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum NewtonFailure {
    /// Halving the step did not reduce the residual.
    #[error("the residual could not be reduced any more (after {} steps)", history.len())]
    Stagnated {
        /// What was tried.
        history: Vec<NewtonStep>,
    },
    /// The method has taken too many steps.
    #[error("no convergence within {} steps", history.len())]
    TooManySteps {
        /// What was tried.
        history: Vec<NewtonStep>,
    },
    /// The active set repeats.
    #[error("the active set is cycling (after {} steps)", history.len())]
    Cycling {
        /// What was tried.
        history: Vec<NewtonStep>,
    },
    /// A linear system could not be solved.
    #[error("{error}")]
    Linear {
        /// The cause.
        error: Error,
        /// What was tried; the last entry is where it happened.
        history: Vec<NewtonStep>,
    },
}

impl From<Error> for NewtonFailure {
    fn from(error: Error) -> Self {
        Self::Linear { error, history: Vec::new() }
    }
}

impl NewtonFailure {
    /// What was tried.
    pub fn history(&self) -> &[NewtonStep] {
        match self {
            Self::Stagnated { history }
            | Self::TooManySteps { history }
            | Self::Cycling { history }
            | Self::Linear { history, .. } => history,
        }
    }
}

/// A solution of `R(u) = 0`.
#[derive(Debug)]
pub struct Solution {
    /// One value a dof.
    pub u: Vec<f64>,
    /// `R(u)`: rounding at free dofs, the reaction at given ones.
    pub reactions: Vec<f64>,
    /// The tangent of the last step, factorised.
    pub linearisation: Linearisation,
    /// One entry a step.
    pub history: Vec<NewtonStep>,
    /// Seconds spent assembling, factorising and solving.
    pub seconds: Seconds,
}

/// Time of each part of a solution [s].
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Seconds {
    /// Element loops.
    pub assemble: f64,
    /// Numeric factorisation.
    pub factorise: f64,
    /// Triangular solves, refinement and residuals.
    pub solve: f64,
}

impl Seconds {
    pub(crate) fn time<T>(bucket: &mut f64, work: impl FnOnce() -> T) -> T {
        let start = std::time::Instant::now();
        let result = work();
        *bucket += start.elapsed().as_secs_f64();
        result
    }
}

/// A discrete equation `R(u) = 0` with given values, and how its linear systems are solved.
#[derive(Clone, Copy)]
pub struct Equation<'a> {
    /// The space and its element loop.
    pub assembler: &'a Assembler,
    /// Solver of its linear systems.
    pub solver: &'a LinearSolver,
    /// The law whose flux balances.
    pub law: &'a dyn ConservationLaw,
    /// Given values.
    pub constraints: &'a Constraints,
    /// Reference size of `u`: a nonlinear iteration has converged when its step falls below [`STEP_TOLERANCE`] of `u`
    /// or of this.
    pub scale: f64,
}

impl Equation<'_> {
    /// True if a step of this size, from `u`, is the last.
    pub(crate) fn has_converged(&self, step: &[f64], u: &[f64]) -> bool {
        greatest(step) <= STEP_TOLERANCE * greatest(u).max(self.scale)
    }

    /// `u + damping * step` and its residual.
    fn stepped(&self, u: &[f64], step: &[f64], damping: f64) -> (f64, Vec<f64>, Vec<f64>) {
        let mut next = u.to_vec();
        add(&mut next, damping, step);
        let residual = self.assembler.residual(self.law, &next);
        (damping, next, residual)
    }

    /// The longest of the halved steps that reduces the residual, whose norm is `norm`.
    fn damped_step(&self, u: &[f64], step: &[f64], norm: f64) -> Option<(f64, Vec<f64>, Vec<f64>)> {
        (0..MOST_HALVINGS)
            .map(|k| self.stepped(u, step, 0.5f64.powi(k as i32)))
            .find(|(damping, _, residual)| self.constraints.free_norm(residual) < (1.0 - 1e-4 * damping) * norm)
    }

    /// The linearisation with this matrix, and Newton's step for this residual to an accuracy relative to the norm
    /// `first`.
    fn newton_step(
        &self,
        matrix: Matrix,
        residual: &[f64],
        first: f64,
        seconds: &mut Seconds,
    ) -> Result<(Linearisation, Vec<f64>), Error> {
        let Self { solver, constraints, .. } = *self;
        let linearisation = Seconds::time(&mut seconds.factorise, || solver.linearise(matrix, constraints.clone()))?;
        let minus: Vec<f64> = residual.iter().map(|r| -r).collect();
        let step = Seconds::time(&mut seconds.solve, || {
            linearisation.solve_to(minus, solver.balanced(first, residual, constraints))
        })?;
        Ok((linearisation, step))
    }
}

/// Solves an equation from the start `u`; given values are imposed first.
///
/// # Errors
/// [`NewtonFailure`] with the history.
pub fn solve(equation: &Equation, mut u: Vec<f64>) -> Result<Solution, NewtonFailure> {
    let (assembler, law, constraints) = (equation.assembler, equation.law, equation.constraints);
    constraints.impose(&mut u);
    let linear = law.tangent() == TangentKind::Conduction;
    let mut seconds = Seconds::default();
    let mut history = Vec::new();
    let mut matrix = Matrix::zero(assembler.pattern().clone());
    let mut first_norm = None;
    while history.len() < MOST_STEPS {
        let residual = Seconds::time(&mut seconds.assemble, || assembler.tangent_and_residual(law, &u, &mut matrix));
        let norm = constraints.free_norm(&residual);
        if !norm.is_finite() {
            let error = Error::NotFinite { what: "residual" };
            return Err(NewtonFailure::Linear { error, history });
        }
        let first = *first_norm.get_or_insert(if norm > 0.0 { norm } else { 1.0 });
        let (linearisation, step) = match equation.newton_step(matrix, &residual, first, &mut seconds) {
            Ok(newton) => newton,
            Err(error) => {
                history.push(NewtonStep::active(norm / first, 0));
                return Err(NewtonFailure::Linear { error, history });
            }
        };
        let converged = linear || equation.has_converged(&step, &u);
        let next = if linear {
            let change = Seconds::time(&mut seconds.solve, || linearisation.matrix().multiply(&step));
            let reactions = residual.iter().zip(change).map(|(r, c)| r + c).collect();
            add(&mut u, 1.0, &step);
            Some((1.0, u, reactions))
        } else {
            let damped = Seconds::time(&mut seconds.assemble, || equation.damped_step(&u, &step, norm));
            // At the floor of round-off a full step cannot reduce the residual; it is then the last.
            damped.or_else(|| converged.then(|| equation.stepped(&u, &step, 1.0)))
        };
        let Some((damping, next, reactions)) = next else {
            return Err(NewtonFailure::Stagnated { history });
        };
        u = next;
        history.push(NewtonStep { residual: constraints.free_norm(&reactions) / first, damping, active: 0 });
        if converged {
            return Ok(Solution { u, reactions, linearisation, history, seconds });
        }
        matrix = linearisation.into_matrix();
    }
    Err(NewtonFailure::TooManySteps { history })
}

fn add(u: &mut [f64], factor: f64, step: &[f64]) {
    for (u, step) in u.iter_mut().zip(step) {
        *u += factor * step;
    }
}

pub(crate) fn greatest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |m, v| m.max(v.abs()))
}
