//! Obstacle problems: `u >= value` at some dofs, by an active set with exact tangents.
//!
//! `u_i >= value`, `R_i(u) >= 0`, one of the two an equality, at each candidate dof; `R_i = 0` at the others. A
//! step holds the contact set at the obstacle, solves the law on the rest, and lets go or takes in every
//! dof of the wrong sign (Hintermueller, Ito, Kunisch, SIAM J. Optim. 13 (2003) 865: a semismooth Newton method).
//! If a set repeats, the iteration cycles: single exchanges follow then, of which a
//! positive definite matrix needs finitely many (Murty, Linear Algebra Appl. 7 (1974) 65; Judice and Pires,
//! Comput. Oper. Res. 21 (1994) 587), until fewer signs are wrong than ever before.

use std::collections::HashSet;
use std::hash::{DefaultHasher, Hash, Hasher};

use rayon::prelude::*;

use crate::conservation_law::TangentKind;
use crate::linear_solver::Enough;
use crate::newton::{Equation, NewtonFailure, NewtonStep, Seconds, Solution, greatest};
use crate::{Constraints, Error, Linearisation, Matrix};

/// Most steps of one solve.
const MOST_STEPS: usize = 400;
/// Least dofs that one task looks at.
const DOFS_A_TASK: usize = 16_384;

/// A lower bound of the solution, and where it applies.
#[derive(Debug, Clone, PartialEq)]
pub struct Obstacle {
    /// The least value.
    pub value: f64,
    /// True for the dofs at which it applies.
    pub candidates: Vec<bool>,
}

impl Obstacle {
    /// An obstacle at every node: for linear and for cubic elements, none of whose functions has a negative mean.
    pub fn at_nodes(space: &crate::Space, value: f64) -> Self {
        Self { value, candidates: vec![true; space.dofs()] }
    }

    /// An obstacle for quadratic elements: at the middles of edges. Functions of vertices have no mean, so a
    /// multiplier there has no sign (Brezzi, Hager, Raviart, Numer. Math. 28 (1977) 431).
    pub fn at_midpoints(space: &crate::Space, value: f64) -> Self {
        let mut candidates = vec![false; space.dofs()];
        for edge in 0..space.mesh().topology().edges.len() as u32 {
            candidates[space.edge_dof(edge)] = true;
        }
        Self { value, candidates }
    }
}

/// A solution nearby.
#[derive(Debug, Clone, PartialEq)]
pub struct WarmStart {
    /// One value a dof.
    pub u: Vec<f64>,
    /// True for the dofs taken to be in contact.
    pub held: Vec<bool>,
}

/// A solution and the dofs held at the obstacle.
#[derive(Debug)]
pub struct ObstacleSolution {
    /// The solution; its linearisation has the contact set fixed.
    pub solution: Solution,
    /// True for each dof held at the obstacle.
    pub held: Vec<bool>,
}

/// Solves the obstacle problem from `guess`. Given dofs are never in contact. A linear law is assembled once.
///
/// # Errors
/// [`NewtonFailure`] with the history.
pub fn solve(equation: &Equation, obstacle: &Obstacle, guess: WarmStart) -> Result<ObstacleSolution, NewtonFailure> {
    let mut iteration = Iteration::new(equation, obstacle, guess)?;
    let mut exchange = Exchange::default();
    while iteration.history.len() < MOST_STEPS {
        let (reactions, settled) = iteration.step()?;
        let wrong = iteration.wrong_signs(&reactions);
        if wrong.is_empty() && settled && iteration.is_sure {
            return Ok(iteration.finish(reactions));
        }
        iteration.is_sure = wrong.is_empty() || equation.solver.roughly_enough(iteration.first) == 0.0;
        exchange.apply(&wrong, &mut iteration.held);
        iteration = iteration.with_contact_changed(reactions)?;
    }
    Err(NewtonFailure::TooManySteps { history: iteration.history })
}

/// One step of the active-set iteration from `guess`: held dofs whose reactions there pull are let go, and the law is
/// solved with that contact set. A law that is not linear is solved with all steps that it needs.
///
/// # Errors
/// [`NewtonFailure`] with the history.
pub fn step(
    equation: &Equation,
    obstacle: &Obstacle,
    guess: WarmStart,
) -> Result<(ObstacleSolution, Vec<usize>), NewtonFailure> {
    if equation.law.tangent() != TangentKind::Conduction {
        return Ok((solve(equation, obstacle, guess)?, Vec::new()));
    }
    let mut iteration = Iteration::released(equation, obstacle, guess)?;
    iteration.is_sure = true;
    let (reactions, _) = iteration.step()?;
    let wrong = iteration.wrong_signs(&reactions);
    Ok((iteration.finish(reactions), wrong))
}

/// The active-set iteration between two steps.
struct Iteration<'a> {
    equation: &'a Equation<'a>,
    obstacle: &'a Obstacle,
    u: Vec<f64>,
    held: Vec<bool>,
    residual: Vec<f64>,
    linearisation: Linearisation,
    /// Norm of the first residual.
    first: f64,
    /// False while linear systems are solved roughly, which is enough to find the contact set.
    is_sure: bool,
    history: Vec<NewtonStep>,
    seconds: Seconds,
}

impl<'a> Iteration<'a> {
    fn new(equation: &'a Equation, obstacle: &'a Obstacle, guess: WarmStart) -> Result<Self, NewtonFailure> {
        Self::begun(equation, obstacle, guess, false)
    }

    /// From a guess that is nearly a solution: held dofs whose reactions pull are let go.
    fn released(equation: &'a Equation, obstacle: &'a Obstacle, guess: WarmStart) -> Result<Self, NewtonFailure> {
        Self::begun(equation, obstacle, guess, true)
    }

    fn begun(
        equation: &'a Equation,
        obstacle: &'a Obstacle,
        guess: WarmStart,
        releases: bool,
    ) -> Result<Self, NewtonFailure> {
        let WarmStart { mut u, mut held } = guess;
        for (i, held) in held.iter_mut().enumerate() {
            *held &= obstacle.candidates[i] && !equation.constraints.fixed[i];
        }
        let mut seconds = Seconds::default();
        let mut masked = with_contact(equation.constraints, obstacle, &held);
        masked.impose(&mut u);
        let mut matrix = Matrix::zero(equation.assembler.pattern().clone());
        let residual = Seconds::time(&mut seconds.assemble, || {
            equation.assembler.tangent_and_residual(equation.law, &u, &mut matrix)
        });
        if releases {
            held.iter_mut().zip(&residual).for_each(|(held, reaction)| *held &= *reaction >= 0.0);
            masked = with_contact(equation.constraints, obstacle, &held);
        }
        let first = match masked.free_norm(&residual) {
            norm if !norm.is_finite() => return Err(Error::NotFinite { what: "residual" }.into()),
            norm if norm > 0.0 => norm,
            _ => 1.0,
        };
        let linearisation = Seconds::time(&mut seconds.factorise, || equation.solver.linearise(matrix, masked))?;
        Ok(Self {
            equation,
            obstacle,
            u,
            held,
            residual,
            linearisation,
            first,
            is_sure: equation.solver.roughly_enough(first) == 0.0,
            history: Vec::new(),
            seconds,
        })
    }

    /// Takes Newton's step with this contact set; the reactions that the tangent predicts, exact for a linear law, and
    /// whether `u` has settled.
    fn step(&mut self) -> Result<(Vec<f64>, bool), NewtonFailure> {
        let solver = self.equation.solver;
        let minus: Vec<f64> = self.residual.iter().map(|r| -r).collect();
        let enough = match self.is_sure {
            true => solver.balanced(self.first, &self.residual, self.linearisation.constraints()),
            false => Enough::residual(solver.roughly_enough(self.first)),
        };
        let step = Seconds::time(&mut self.seconds.solve, || self.linearisation.solve_to(minus, enough))?;
        for (u, step) in self.u.iter_mut().zip(&step) {
            *u += step;
        }
        let change = Seconds::time(&mut self.seconds.solve, || self.linearisation.matrix().multiply(&step));
        let settled = self.is_linear() || self.equation.has_converged(&step, &self.u);
        Ok((sum(&self.residual, &change), settled))
    }

    fn is_linear(&self) -> bool {
        self.equation.law.tangent() == TangentKind::Conduction
    }

    /// Dofs below the obstacle, and held dofs that the obstacle would have to pull down; by more than round-off, and
    /// more than an iterative solver leaves.
    fn wrong_signs(&self, reactions: &[f64]) -> Vec<usize> {
        let Self { equation, obstacle, .. } = self;
        let least_value = equation.solver.accuracy() * greatest(&self.u).max(equation.scale);
        let least_reaction = equation.solver.enough(self.first);
        (0..self.u.len())
            .into_par_iter()
            .with_min_len(DOFS_A_TASK)
            .filter(|&i| obstacle.candidates[i] && !equation.constraints.fixed[i])
            .filter(|&i| match self.held[i] {
                true => {
                    let by_value = least_value * self.linearisation.matrix().diagonal(i);
                    // A factor leaves round-off only.
                    let least = match least_reaction > 0.0 {
                        true => least_reaction.min(by_value),
                        false => by_value,
                    };
                    reactions[i] < -least
                }
                false => self.u[i] < obstacle.value - least_value,
            })
            .collect()
    }

    /// The linearisation and the residual with a new contact set, whose dofs are moved to the obstacle.
    fn with_contact_changed(mut self, reactions: Vec<f64>) -> Result<Self, NewtonFailure> {
        let Equation { assembler, solver, law, .. } = *self.equation;
        let masked = with_contact(self.equation.constraints, self.obstacle, &self.held);
        let before = self.u.clone();
        masked.impose(&mut self.u);
        if self.is_linear() {
            self.residual = Seconds::time(&mut self.seconds.solve, || {
                let jump: Vec<f64> = self.u.iter().zip(&before).map(|(u, before)| u - before).collect();
                sum(&reactions, &self.linearisation.matrix().multiply(&jump))
            });
            self.linearisation =
                Seconds::time(&mut self.seconds.factorise, || self.linearisation.masked_anew(solver, masked))?;
        } else {
            let mut matrix = self.linearisation.into_matrix();
            self.residual =
                Seconds::time(&mut self.seconds.assemble, || assembler.tangent_and_residual(law, &self.u, &mut matrix));
            self.linearisation = Seconds::time(&mut self.seconds.factorise, || solver.linearise(matrix, masked))?;
        }
        let norm = self.linearisation.constraints().free_norm(&self.residual) / self.first;
        if !norm.is_finite() {
            return Err(Error::NotFinite { what: "residual" }.into());
        }
        self.history.push(NewtonStep::active(norm, count(&self.held)));
        Ok(self)
    }

    fn finish(mut self, reactions: Vec<f64>) -> ObstacleSolution {
        let left = match self.is_linear() {
            true => reactions,
            false => self.equation.assembler.residual(self.equation.law, &self.u),
        };
        let left_norm = self.linearisation.constraints().free_norm(&left) / self.first;
        self.history.push(NewtonStep::active(left_norm, count(&self.held)));
        ObstacleSolution {
            solution: Solution {
                u: self.u,
                reactions: left,
                linearisation: self.linearisation,
                history: self.history,
                seconds: self.seconds,
            },
            held: self.held,
        }
    }
}

fn sum(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a + b).collect()
}

/// Rule by which dofs change sides, with a memory against cycling.
#[derive(Debug, Default)]
struct Exchange {
    seen: HashSet<u64>,
    fewest: Option<usize>,
    single: bool,
}

impl Exchange {
    fn apply(&mut self, wrong: &[usize], held: &mut [bool]) {
        let fewest = self.fewest.get_or_insert(usize::MAX);
        if wrong.len() < *fewest {
            *fewest = wrong.len();
            self.single = false;
        }
        let mut hasher = DefaultHasher::new();
        held.hash(&mut hasher);
        if !self.seen.insert(hasher.finish()) && !wrong.is_empty() {
            self.single = true;
        }
        let chosen = match self.single {
            true => &wrong[wrong.len().saturating_sub(1)..],
            false => wrong,
        };
        for &dof in chosen {
            held[dof] = !held[dof];
        }
    }
}

fn with_contact(constraints: &Constraints, obstacle: &Obstacle, held: &[bool]) -> Constraints {
    let mut masked = constraints.clone();
    for (dof, _) in held.iter().enumerate().filter(|(_, held)| **held) {
        masked.fix(dof, obstacle.value);
    }
    masked
}

fn count(held: &[bool]) -> usize {
    held.iter().filter(|held| **held).count()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `z >= 0`, `A z + q >= 0`, one of the two an equality: block exchange cycles with period four.
    const A: [[f64; 3]; 3] = [[13.0, 13.0, -7.0], [13.0, 14.0, -5.0], [-7.0, -5.0, 9.0]];
    const Q: [f64; 3] = [-3.0, -1.0, 4.0];

    /// The solution with `held` at zero, by elimination; what is wrong with it.
    fn solve(held: [bool; 3]) -> ([f64; 3], Vec<usize>) {
        let free: Vec<usize> = (0..3).filter(|&i| !held[i]).collect();
        let (mut a, mut z) = (A, Q.map(|q| -q));
        for (step, &i) in free.iter().enumerate() {
            for &j in &free[step + 1..] {
                let factor = a[j][i] / a[i][i];
                (0..3).for_each(|k| a[j][k] -= factor * a[i][k]);
                z[j] -= factor * z[i];
            }
        }
        for (step, &i) in free.iter().enumerate().rev() {
            z[i] = (z[i] - free[step + 1..].iter().map(|&k| a[i][k] * z[k]).sum::<f64>()) / a[i][i];
        }
        (0..3).filter(|&i| held[i]).for_each(|i| z[i] = 0.0);
        let reaction = |i: usize| Q[i] + (0..3).map(|k| A[i][k] * z[k]).sum::<f64>();
        let wrong = |i: usize| if held[i] { reaction(i) < -1e-12 } else { z[i] < -1e-12 };
        let wrong = (0..3).filter(|&i| wrong(i)).collect();
        (z, wrong)
    }

    #[test]
    fn single_exchanges_end_what_block_exchange_repeats() {
        let mut held = [false; 3];
        let mut sets = Vec::new();
        while !sets.contains(&held) {
            sets.push(held);
            let wrong = solve(held).1;
            assert!(!wrong.is_empty(), "block exchange alone found it: the example shows nothing");
            wrong.into_iter().for_each(|i| held[i] = !held[i]);
        }

        // A positive definite matrix has one solution, whatever the start.
        let starts = (0..8u8).map(|bits| [0, 1, 2].map(|i| bits >> i & 1 == 1));
        let mut solutions = starts.map(|start| {
            let (mut held, mut exchange) = (start, Exchange::default());
            for _ in 0..20 {
                let (z, wrong) = solve(held);
                if wrong.is_empty() {
                    return z;
                }
                exchange.apply(&wrong, &mut held);
            }
            panic!("no end from {start:?}");
        });
        let first = solutions.next().expect("eight");
        assert!(first.iter().all(|z| *z >= 0.0) && first.iter().any(|z| *z > 0.0));
        assert!(solutions.all(|z| (0..3).all(|i| (z[i] - first[i]).abs() < 1e-12)));
    }
}
