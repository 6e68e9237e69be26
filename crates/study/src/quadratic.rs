//! # Sequential quadratic programming: a step towards the optimum of a smooth function under constraints
//!
//! **Equation.** Around a point y of the unit box, with objective f, constraints c >= 0 and their gradients, a step d
//! makes least
//! ```text
//! g d + d B d / 2 + rho sum t,      c_i + a_i d + t_i >= 0,   t >= 0,   0 <= y + d <= 1,   |d| <= radius
//! ```
//! where B is the Hessian of the Lagrangian by damped updates, and t is what no step within the radius repairs. A step
//! is taken where the merit `f + nu sum max(0, -c)`, nu twice the greatest multiplier, falls as much as a part of what
//! the model expects; else the radius shrinks. Where there is no value at the end of a step, it is halved.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | place in the box, between the bounds of each unknown | 1 | `at` |
//! | B | 1 | `Hessian` |
//! | rho | 1 | `penalty` |
//!
//! **Measured** against the SLSQP of NLopt in Rust (crate `slsqp`): 7, 9, 9 and 10 points for Rayleigh's step, two
//! short films and scene 40, where that takes 16, 18, 22 and 11 and gives no multipliers.
//!
//! **Source.** Fletcher, Math. Prog. Study 17 (1982) 67 (merit and trust region); Powell, Math. Prog. 14 (1978) 224
//! (damped updates); clarabel solves the quadratic problems (Goulart and Chen 2024). **Range.** A few unknowns, smooth
//! functions. **Verified by** the tests below, and `tests/tests/design.rs`, `tests/tests/shaft/weights.rs`.

use clarabel::algebra::CscMatrix;
use clarabel::solver::{DefaultSettings, DefaultSolver, IPSolver, NonnegativeConeT, SolverStatus};

/// Prices of what no step repairs: the first, and the greatest. It grows where a search would end with a constraint
/// missed, by this factor.
const PENALTY: [f64; 2] = [1e2, 1e6];
const DEARER_PENALTY: f64 = 100.0;
/// Price of a constraint in the merit, over what it costs.
const DEARER: f64 = 2.0;
/// Part of the box that the first step may cross, and the most that a step may.
const RADIUS: [f64; 2] = [0.2, 0.5];
/// Part of the decrease expected that is enough.
const ENOUGH: f64 = 0.05;
/// Part of the decrease expected from which on the model is trusted further.
const GOOD: f64 = 0.7;
/// The search ends with a step this small, or a radius.
const CLOSE: [f64; 2] = [2e-5, 1e-4];
/// A search whose radius has become small is at an optimum where the model expects no greater decrease than this from
/// any step, whatever its length; else the values are too rough. Films on meshes of their own differ by some 1e-5.
const FLAT: f64 = 1e-4;
/// Decreases below this are round-off.
const ROUND_OFF: f64 = 1e-10;
/// Constraints that miss by less than this are met.
const MET: f64 = 1e-6;
/// Part of the curvature that a damped update keeps.
const DAMPED: f64 = 0.2;

/// Values and gradients at a point.
#[derive(Debug, Clone, PartialEq)]
pub struct Valued {
    /// What is made least.
    pub objective: f64,
    /// What must not be below zero.
    pub constraints: Vec<f64>,
    /// Gradient of the objective.
    pub gradient: Vec<f64>,
    /// Gradients of the constraints.
    pub gradients: Vec<Vec<f64>>,
}

impl Valued {
    fn merit(&self, price: f64) -> f64 {
        self.objective + price * self.violation()
    }

    fn violation(&self) -> f64 {
        self.constraints.iter().map(|value| f64::max(0.0, -value)).sum()
    }

    /// Gradient of the Lagrangian.
    fn slope(&self, multipliers: &[f64]) -> Vec<f64> {
        let part = |k: usize| -> f64 { self.gradients.iter().zip(multipliers).map(|(row, m)| m * row[k]).sum() };
        self.gradient.iter().enumerate().map(|(k, g)| g - part(k)).collect()
    }
}

/// How a search ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DescentEnd {
    /// At an optimum.
    Optimum,
    /// Where no step meets all constraints.
    Infeasible,
    /// Where no step leads to a value.
    NoValue,
    /// After the most points allowed.
    Limit,
    /// Where no step is better although the gradient says so, or none could be computed.
    NoStep,
}

/// What a search has found.
#[derive(Debug, Clone, PartialEq)]
pub struct Optimum {
    /// Place in the unit box.
    pub at: Vec<f64>,
    /// Cost of each constraint: objective per unit of it.
    pub multipliers: Vec<f64>,
    /// How it ended.
    pub end: DescentEnd,
}

/// The place near `start` in the unit box where the objective is least, after at most `most` points; `None` where there
/// is no value at the start.
pub fn least(start: &[f64], most: usize, sample: &mut dyn FnMut(&[f64]) -> Option<Valued>) -> Option<Optimum> {
    let mut at = start.to_vec();
    let mut here = sample(&at)?;
    let mut hessian = Hessian::unit(at.len());
    let mut radius = RADIUS[0];
    let mut multipliers = vec![0.0; here.constraints.len()];
    let mut end = DescentEnd::Limit;
    let (mut is_missing, mut price, mut penalty) = (false, 0.0, PENALTY[0]);
    let mut asked = 1;
    while asked < most {
        let Some(step) = hessian.step(&here, &at, radius, penalty) else {
            end = DescentEnd::NoStep;
            break;
        };
        multipliers.clone_from(&step.multipliers);
        price = f64::max(0.5 * price, DEARER * multipliers.iter().copied().fold(0.0, f64::max));
        let expected = step.gain + price * step.repaired;
        let length = step.by.iter().fold(0.0, |most: f64, d| most.max(d.abs()));
        let is_small = length < CLOSE[0] || expected < ROUND_OFF || radius < CLOSE[1];
        let is_missed = here.violation() > MET;
        if is_small && is_missed && penalty < PENALTY[1] {
            penalty *= DEARER_PENALTY;
            radius = radius.max(RADIUS[0]);
            continue;
        }
        if is_small {
            // A short radius bears a part of what constraints cost.
            let any = hessian.step(&here, &at, RADIUS[1], penalty);
            if let Some(step) = &any {
                multipliers.clone_from(&step.multipliers);
            }
            let expects_more = any.is_none_or(|step| step.gain + price * step.repaired > FLAT);
            end = match (is_missing, is_missed) {
                (true, _) if radius < CLOSE[1] => DescentEnd::NoValue,
                (_, true) => DescentEnd::Infeasible,
                _ if radius < CLOSE[1] && expects_more => DescentEnd::NoStep,
                _ => DescentEnd::Optimum,
            };
            break;
        }
        let there: Vec<f64> = at.iter().zip(&step.by).map(|(x, d)| (x + d).clamp(0.0, 1.0)).collect();
        asked += 1;
        let Some(other) = sample(&there) else {
            is_missing = true;
            radius = 0.5 * length;
            continue;
        };
        let [before, after] = [&here, &other].map(|sample| sample.slope(&step.multipliers));
        hessian.update(&step.by, &after.iter().zip(&before).map(|(a, b)| a - b).collect::<Vec<_>>());
        let part = (here.merit(price) - other.merit(price)) / expected;
        if part > ENOUGH {
            is_missing = false;
            if part > GOOD && length > 0.9 * radius {
                radius = (2.0 * radius).min(RADIUS[1]);
            }
            (at, here) = (there, other);
        } else {
            radius = 0.3 * length;
        }
    }
    Some(Optimum { at, multipliers, end })
}

/// A step, and how much less objective and violation are expected to be after it.
struct Step {
    by: Vec<f64>,
    gain: f64,
    repaired: f64,
    multipliers: Vec<f64>,
}

/// Second derivatives of the Lagrangian, by rows.
struct Hessian {
    rows: Vec<Vec<f64>>,
    is_new: bool,
}

impl Hessian {
    fn unit(n: usize) -> Self {
        Self { rows: (0..n).map(|i| (0..n).map(|j| f64::from(u8::from(i == j))).collect()).collect(), is_new: true }
    }

    fn times(&self, d: &[f64]) -> Vec<f64> {
        self.rows.iter().map(|row| product(row, d)).collect()
    }

    /// The step that the quadratic problem has; `None` where it cannot be solved.
    fn step(&self, here: &Valued, at: &[f64], radius: f64, penalty: f64) -> Option<Step> {
        let (n, m) = (at.len(), here.constraints.len());
        let upper = (0..n).flat_map(|j| (0..=j).map(move |i| (i, j)));
        let (places, values): (Vec<_>, Vec<f64>) = upper.map(|(i, j)| ((i, j), self.rows[i][j])).unzip();
        let (rows, columns): (Vec<_>, Vec<_>) = places.into_iter().unzip();
        let quadratic = CscMatrix::new_from_triplets(n + m, n + m, rows, columns, values);
        let linear = [here.gradient.clone(), vec![penalty; m]].concat();
        let mut entries: Vec<(usize, usize, f64)> = Vec::new();
        let mut right = Vec::new();
        for (i, (value, gradient)) in here.constraints.iter().zip(&here.gradients).enumerate() {
            entries.extend(gradient.iter().enumerate().map(|(k, a)| (i, k, -a)));
            entries.push((i, n + i, -1.0));
            right.push(*value);
        }
        for i in 0..m {
            entries.push((m + i, n + i, -1.0));
            right.push(0.0);
        }
        for (k, x) in at.iter().enumerate() {
            entries.extend([(right.len(), k, 1.0), (right.len() + 1, k, -1.0)]);
            right.extend([radius.min(1.0 - x), radius.min(*x)]);
        }
        let count = right.len();
        let (rows, columns, values) = entries.into_iter().fold((vec![], vec![], vec![]), |mut lists, (i, j, value)| {
            lists.0.push(i);
            lists.1.push(j);
            lists.2.push(value);
            lists
        });
        let matrix = CscMatrix::new_from_triplets(count, n + m, rows, columns, values);
        let settings = DefaultSettings { verbose: false, ..DefaultSettings::default() };
        let cones = [NonnegativeConeT(count)];
        let mut solver = DefaultSolver::new(&quadratic, &linear, &matrix, &right, &cones, settings).ok()?;
        solver.solve();
        let solution = &solver.solution;
        if !matches!(solution.status, SolverStatus::Solved | SolverStatus::AlmostSolved) {
            return None;
        }
        let by = solution.x[..n].to_vec();
        let left: f64 = (here.constraints.iter().zip(&here.gradients))
            .map(|(value, gradient)| f64::max(0.0, -value - product(gradient, &by)))
            .sum();
        Some(Step {
            gain: -product(&here.gradient, &by) - 0.5 * product(&self.times(&by), &by),
            repaired: here.violation() - left,
            multipliers: solution.z[..m].to_vec(),
            by,
        })
    }

    /// Takes in how the slope of the Lagrangian has changed with a step.
    fn update(&mut self, step: &[f64], change: &[f64]) {
        let curvature = product(step, change);
        let square = product(step, step);
        if self.is_new && curvature > 0.0 {
            let scale = curvature / square;
            self.rows.iter_mut().flatten().for_each(|entry| *entry *= scale);
        }
        self.is_new = false;
        let along = self.times(step);
        let own = product(step, &along);
        let part = if curvature < DAMPED * own { (1.0 - DAMPED) * own / (own - curvature) } else { 1.0 };
        let change: Vec<f64> = change.iter().zip(&along).map(|(y, b)| part * y + (1.0 - part) * b).collect();
        let curvature = product(step, &change);
        if own > 0.0 && curvature > 0.0 {
            for (i, row) in self.rows.iter_mut().enumerate() {
                for (j, entry) in row.iter_mut().enumerate() {
                    *entry += change[i] * change[j] / curvature - along[i] * along[j] / own;
                }
            }
        }
    }
}

fn product(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rosenbrock's valley in the unit box, whose middle is (1/2, 1/2).
    #[test]
    fn a_bent_valley_leads_to_its_end() {
        let mut asked = 0;
        let found = least(&[0.1, 0.8], 80, &mut |at| {
            asked += 1;
            let [x, y] = [2.0 * at[0], 2.0 * at[1]];
            Some(Valued {
                objective: (1.0 - x).powi(2) + 10.0 * (y - x * x).powi(2),
                gradient: vec![2.0 * (-2.0 * (1.0 - x) - 40.0 * x * (y - x * x)), 40.0 * (y - x * x)],
                constraints: Vec::new(),
                gradients: Vec::new(),
            })
        });
        let found = found.expect("a start");
        assert_eq!(found.end, DescentEnd::Optimum);
        assert!(found.at.iter().all(|x| (x - 0.5).abs() < 1e-4) && asked < 50, "{found:?} {asked}");
    }

    /// Least x + y where x y >= 1/4, with the cost 1 of that limit; no value beyond x = 0.9.
    #[test]
    fn a_constraint_is_met_and_has_its_cost() {
        let sample = |at: &[f64]| {
            (at[0] < 0.9).then(|| Valued {
                objective: at[0] + at[1],
                gradient: vec![1.0, 1.0],
                constraints: vec![at[0] * at[1] - 0.25],
                gradients: vec![vec![at[1], at[0]]],
            })
        };
        let found = least(&[0.8, 0.9], 60, &mut |at| sample(at)).expect("a start");
        assert!(found.at.iter().all(|x| (x - 0.5).abs() < 1e-4), "{found:?}");
        assert!(found.end == DescentEnd::Optimum && (found.multipliers[0] - 2.0).abs() < 1e-2, "{found:?}");
        assert!(least(&[0.95, 0.9], 60, &mut |at| sample(at)).is_none());
    }

    /// Least x + y where x y >= 1/4, of which each value is off by some 1e-5, as films on meshes of their own are: the
    /// limit has its cost of 2.
    #[test]
    fn a_rough_constraint_has_its_cost() {
        let mut asked = 0;
        let found = least(&[0.7, 0.8], 60, &mut |at| {
            asked += 1;
            let off = 1e-5 * f64::from(7 * asked % 5 - 2);
            Some(Valued {
                objective: at[0] + at[1] + off,
                gradient: vec![1.0, 1.0],
                constraints: vec![at[0] * at[1] - 0.25 + off],
                gradients: vec![vec![at[1], at[0]]],
            })
        });
        let found = found.expect("a start");
        assert!(found.at.iter().all(|x| (x - 0.5).abs() < 1e-2), "{found:?}");
        assert!((found.multipliers[0] - 2.0).abs() < 0.1, "{found:?}");
    }

    /// Values that jump so that no step is better, far from where the gradient is zero.
    #[test]
    fn values_too_rough_for_their_gradients_are_no_optimum() {
        let mut asked = 0;
        let found = least(&[0.5], 60, &mut |_| {
            asked += 1;
            Some(Valued {
                objective: f64::from(asked),
                gradient: vec![1.0],
                constraints: Vec::new(),
                gradients: Vec::new(),
            })
        });
        assert_eq!(found.expect("a start").end, DescentEnd::NoStep);
    }

    /// Least x where x / 1000 >= 1/2000: a limit whose cost is above the first penalty.
    #[test]
    fn a_dear_constraint_is_met_too() {
        let sample = |at: &[f64]| Valued {
            objective: at[0],
            gradient: vec![1.0],
            constraints: vec![1e-3 * at[0] - 5e-4],
            gradients: vec![vec![1e-3]],
        };
        let found = least(&[0.2], 60, &mut |at| Some(sample(at))).expect("a start");
        assert!(found.end == DescentEnd::Optimum && (found.at[0] - 0.5).abs() < 1e-3, "{found:?}");
    }
}
