//! Obstacle problems: `u >= value` at some dofs, by an active set with exact tangents.
//!
//! `u_i >= value`, `R_i(u) >= 0`, one of the two an equality, at each candidate dof; `R_i = 0` at the others. A
//! step holds the contact set at the obstacle, solves the law on the rest, and lets go or takes in every
//! dof of the wrong sign (Hintermueller, Ito, Kunisch, SIAM J. Optim. 13 (2003) 865: a semismooth Newton method).
//! A set that comes back would come back for ever: single exchanges follow then, of which a
//! positive definite matrix needs finitely many (Murty, Linear Algebra Appl. 7 (1974) 65; Judice and Pires,
//! Comput. Oper. Res. 21 (1994) 587), until fewer signs are wrong than ever before.

use std::collections::HashSet;
use std::hash::{DefaultHasher, Hash, Hasher};

use rayon::prelude::*;

use crate::conservation_law::{ConservationLaw, Tangent};
use crate::newton::{Failure, HistoryStep, STEP_TOLERANCE, Seconds, Solution};
use crate::{Assembler, Constraints, Error, LinearSolver, Matrix};

/// Most steps of one solve.
const MOST_STEPS: usize = 400;

/// What the solution must not fall below, and where that is asked.
#[derive(Debug, Clone, PartialEq)]
pub struct Obstacle {
    /// The least value.
    pub value: f64,
    /// True for the dofs at which it is asked; others follow freely.
    pub candidates: Vec<bool>,
}

impl Obstacle {
    /// Asked at every node: for linear and for cubic elements, none of whose functions has a negative mean.
    pub fn at_nodes(space: &crate::Space, value: f64) -> Self {
        Self {
            value,
            candidates: vec![true; space.dofs()],
        }
    }

    /// An obstacle for quadratic elements: asked at the middles of edges. Functions of vertices have no mean, so a
    /// multiplier there has no sign (Brezzi, Hager, Raviart, Numer. Math. 28 (1977) 431).
    pub fn at_midpoints(space: &crate::Space, value: f64) -> Self {
        let mut candidates = vec![false; space.dofs()];
        for edge in 0..space.mesh().topology().edges.len() as u32 {
            candidates[space.edge_dof(edge)] = true;
        }
        Self { value, candidates }
    }
}

/// Where to start from.
#[derive(Debug, Clone, PartialEq)]
pub struct Start {
    /// One value a dof.
    pub u: Vec<f64>,
    /// Dofs taken to be in contact.
    pub held: Vec<bool>,
}

/// A solution and the dofs held at the obstacle.
#[derive(Debug)]
pub struct Contact {
    /// The solution; its linearisation has the contact set fixed.
    pub solution: Solution,
    /// True for each dof held at the obstacle.
    pub held: Vec<bool>,
}

/// Solves the obstacle problem from `start`. `scale` is a
/// natural size of `u`. Given dofs are never in contact. A linear law is assembled once.
///
/// # Errors
/// [`Failure`] with the history.
pub fn solve(
    assembler: &Assembler,
    solver: &LinearSolver,
    law: &dyn ConservationLaw,
    constraints: &Constraints,
    obstacle: &Obstacle,
    scale: f64,
    start: Start,
) -> Result<Contact, Failure> {
    let Start { mut u, mut held } = start;
    for (i, held) in held.iter_mut().enumerate() {
        *held &= obstacle.candidates[i] && !constraints.fixed[i];
    }
    let linear = law.tangent() == Tangent::Conduction;
    let mut seconds = Seconds::default();
    let mut history: Vec<HistoryStep> = Vec::new();
    let mut exchange = Exchange::default();
    let masked = with_contact(constraints, obstacle, &held);
    masked.impose(&mut u);
    let mut matrix = Matrix::zero(assembler.pattern().clone());
    let mut residual = Seconds::time(&mut seconds.assemble, || {
        assembler.tangent_and_residual(law, &u, &mut matrix)
    });
    let first = match masked.free_norm(&residual) {
        norm if !norm.is_finite() => return Err(Error::NotFinite { what: "residual" }.into()),
        norm if norm > 0.0 => norm,
        _ => 1.0,
    };
    // Rough solves lead to the set of contact; the last one is not rough.
    let mut sure = solver.roughly_enough(first) == 0.0;
    let mut linearisation = Seconds::time(&mut seconds.factorise, || solver.linearise(matrix, masked))?;
    while history.len() < MOST_STEPS {
        let minus: Vec<f64> = residual.iter().map(|r| -r).collect();
        let step = Seconds::time(&mut seconds.solve, || {
            linearisation.solve_to(
                &minus,
                if sure {
                    solver.enough(first)
                } else {
                    solver.roughly_enough(first)
                },
            )
        })?;
        for (u, step) in u.iter_mut().zip(&step) {
            *u += step;
        }
        // What the tangent says of the reactions; exact for a linear law.
        let change = Seconds::time(&mut seconds.solve, || linearisation.matrix().multiply(&step));
        let reactions: Vec<f64> = residual.iter().zip(&change).map(|(r, c)| r + c).collect();
        let settled = linear || largest(&step) <= STEP_TOLERANCE * largest(&u).max(scale);
        let wrong = wrong_signs(
            constraints,
            obstacle,
            &held,
            &u,
            &reactions,
            linearisation.matrix(),
            Meaningless {
                value: solver.accuracy() * largest(&u).max(scale),
                reaction: solver.enough(first),
            },
        );
        if wrong.is_empty() && settled && sure {
            let left = match linear {
                true => reactions,
                false => assembler.residual(law, &u),
            };
            let left_norm = linearisation.constraints().free_norm(&left) / first;
            history.push(HistoryStep::active(left_norm, count(&held)));
            let solution = Solution {
                u,
                reactions: left,
                linearisation,
                history,
                seconds,
            };
            return Ok(Contact { solution, held });
        }
        sure = wrong.is_empty() || solver.roughly_enough(first) == 0.0;
        exchange.apply(&wrong, &mut held);
        let masked = with_contact(constraints, obstacle, &held);
        let before = u.clone();
        masked.impose(&mut u);
        if linear {
            residual = Seconds::time(&mut seconds.solve, || {
                let jump: Vec<f64> = u.iter().zip(&before).map(|(u, before)| u - before).collect();
                let change = linearisation.matrix().multiply(&jump);
                reactions.iter().zip(change).map(|(r, c)| r + c).collect()
            });
            linearisation = Seconds::time(&mut seconds.factorise, || linearisation.masked_anew(solver, masked))?;
        } else {
            let mut matrix = linearisation.into_matrix();
            residual = Seconds::time(&mut seconds.assemble, || {
                assembler.tangent_and_residual(law, &u, &mut matrix)
            });
            linearisation = Seconds::time(&mut seconds.factorise, || solver.linearise(matrix, masked))?;
        }
        let norm = linearisation.constraints().free_norm(&residual) / first;
        if !norm.is_finite() {
            return Err(Error::NotFinite { what: "residual" }.into());
        }
        history.push(HistoryStep::active(norm, count(&held)));
    }
    Err(Failure::TooManySteps { history })
}

/// Which dofs change sides, with a memory against going round in circles.
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

/// What means nothing: less is rounding, or what an iteration leaves.
struct Meaningless {
    /// Of `u`.
    value: f64,
    /// Of a residual; zero where a factor leaves rounding only.
    reaction: f64,
}

/// Dofs below the obstacle, and held dofs that the obstacle would have to pull down; by more than what means nothing.
fn wrong_signs(
    constraints: &Constraints,
    obstacle: &Obstacle,
    held: &[bool],
    u: &[f64],
    reactions: &[f64],
    matrix: &Matrix,
    least: Meaningless,
) -> Vec<usize> {
    (0..u.len())
        .into_par_iter()
        .filter(|&i| obstacle.candidates[i] && !constraints.fixed[i])
        .filter(|&i| match held[i] {
            true => {
                let by_value = least.value * matrix.diagonal(i);
                let natural = if least.reaction > 0.0 {
                    least.reaction.min(by_value)
                } else {
                    by_value
                };
                reactions[i] < -natural
            }
            false => u[i] < obstacle.value - least.value,
        })
        .collect()
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

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |m, v| m.max(v.abs()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `z >= 0`, `A z + q >= 0`, one of the two an equality: block exchange goes round in circles of four.
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
            assert!(
                !wrong.is_empty(),
                "block exchange alone found it: the example shows nothing"
            );
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
