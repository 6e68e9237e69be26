//! # Counterweights: how to move them between the webs so that the bearings fare best
//!
//! **Equation.** Mass times radius U_j of the webs at z_j may change by dU_j where the force and the moment that the
//! whole shaft puts on its bearings stay:
//! ```text
//! sum dU_j = 0,        sum z_j dU_j = 0
//! ```
//! With a basis b_k of the numbers that meet both, perpendicular to each other, `dU_j = sum_k b_kj a_k` has free
//! vectors a_k: two less than webs that may change. An objective is made greatest over them without derivatives: it is
//! a least film or a peak load, whose greatest value is a corner.
//!
//! **Source.** Constraints: definition. Search: Nelder, Mead, Computer J. 7 (1965) 308, begun anew from its best point
//! until that gains no more. **Range.** A few weights.
//! **Verified by** the tests below, and `tests/tests/shaft/weights.rs`: a crank with a rod without end and without gas,
//! whose greatest load is least, m_p r omega^2/2, with the counterweight m_r + m_p/2.

use super::matrix::product;

/// Steps of one search for each unknown.
const STEPS_EACH: usize = 200;
/// A search ends where its points are within this part of the first step.
const CLOSE: f64 = 1e-9;
/// A search is begun anew at most so many times.
const SEARCHES: usize = 12;
/// Steps of a search that is begun anew, over those before.
const SHORTER: f64 = 0.3;
/// Part of the value that a step of the search gains at least.
const GAIN: f64 = 1e-12;

/// The numbers on places z [m] that change neither sum nor moment: a basis of vectors one long and perpendicular to
/// each other.
pub fn neutral(places: &[f64]) -> Vec<Vec<f64>> {
    let n = places.len();
    let middle = places.iter().sum::<f64>() / n as f64;
    let mut basis: Vec<Vec<f64>> = Vec::new();
    let kept = [vec![1.0; n], places.iter().map(|z| z - middle).collect()];
    let units = (0..n).map(|k| (0..n).map(|j| f64::from(u8::from(j == k))).collect());
    let mut constraints = 0;
    for (number, mut vector) in (0..).zip(kept.into_iter().chain(units)) {
        let size = product(&vector, &vector).sqrt();
        // Twice, so that it is perpendicular to round-off.
        for _ in 0..2 {
            for other in &basis {
                let along = product(&vector, other);
                (vector.iter_mut().zip(other)).for_each(|(entry, part)| *entry -= along * part);
            }
        }
        let left = product(&vector, &vector).sqrt();
        if left > 1e-8 * size.max(f64::MIN_POSITIVE) {
            vector.iter_mut().for_each(|entry| *entry /= left);
            basis.push(vector);
            constraints += usize::from(number < 2);
        }
    }
    basis.split_off(constraints)
}

/// Changes [kg m] of what is out of balance on webs, by the free vectors of a [`neutral`] basis: two numbers for each
/// of its entries.
pub fn changes(basis: &[Vec<f64>], free: &[f64]) -> Vec<[f64; 2]> {
    let webs = basis.first().map_or(0, Vec::len);
    let change = |web: usize| {
        let sum = |towards: usize| {
            let parts = basis.iter().zip(free.chunks_exact(2));
            parts.map(|(vector, free)| vector[web] * free[towards]).sum()
        };
        [sum(0), sum(1)]
    };
    (0..webs).map(change).collect()
}

/// The best point found, and its value.
#[derive(Debug, Clone, PartialEq)]
pub struct Best {
    /// The unknowns.
    pub at: Vec<f64>,
    /// The objective there.
    pub value: f64,
    /// How often it was asked.
    pub asked: usize,
}

/// Where an objective is greatest near a point: steps begin with `step`, and it is asked at most `most` times. Values
/// that are no numbers count as the worst.
pub fn greatest(objective: impl Fn(&[f64]) -> f64, from: &[f64], step: f64, most: usize) -> Best {
    let value = |at: &[f64]| match objective(at) {
        value if value.is_nan() => f64::NEG_INFINITY,
        value => value,
    };
    let mut best = Best { at: from.to_vec(), value: value(from), asked: 1 };
    if from.is_empty() {
        return best;
    }
    let mut step = step;
    for _ in 0..SEARCHES {
        let before = best.value;
        best = Simplex::around(&value, &best, step).climbed(&value, step, most);
        if best.asked >= most {
            break;
        }
        let is_gain = best.value - before > GAIN * best.value.abs();
        if !is_gain && step < 1e-3 {
            break;
        }
        step *= SHORTER;
    }
    best
}

/// Points of a search, the best first.
struct Simplex {
    points: Vec<(Vec<f64>, f64)>,
    asked: usize,
}

impl Simplex {
    fn around(value: &impl Fn(&[f64]) -> f64, best: &Best, step: f64) -> Self {
        let mut points = vec![(best.at.clone(), best.value)];
        for k in 0..best.at.len() {
            let mut at = best.at.clone();
            at[k] += step;
            let value = value(&at);
            points.push((at, value));
        }
        Self { asked: best.asked + best.at.len(), points }
    }

    fn climbed(mut self, value: &impl Fn(&[f64]) -> f64, step: f64, most: usize) -> Best {
        let unknowns = self.points.len() - 1;
        for _ in 0..STEPS_EACH * unknowns {
            self.points.sort_by(|a, b| b.1.total_cmp(&a.1));
            if self.asked >= most || self.size() < CLOSE * step {
                break;
            }
            self.step(value, unknowns);
        }
        self.points.sort_by(|a, b| b.1.total_cmp(&a.1));
        let (at, value) = self.points.swap_remove(0);
        Best { at, value, asked: self.asked }
    }

    /// Greatest distance of a point from the best one in one unknown.
    fn size(&self) -> f64 {
        let best = &self.points[0].0;
        let others = self.points.iter().flat_map(|(at, _)| at.iter().zip(best));
        others.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    }

    /// Replaces the worst point by one beyond the others, or draws all nearer to the best.
    fn step(&mut self, value: &impl Fn(&[f64]) -> f64, unknowns: usize) {
        let worst = self.points[unknowns].clone();
        let middle: Vec<f64> = (0..worst.0.len())
            .map(|k| self.points[..unknowns].iter().map(|(at, _)| at[k]).sum::<f64>() / unknowns as f64)
            .collect();
        let mut asked = 0;
        let mut beyond = |part: f64| {
            let at: Vec<f64> =
                middle.iter().zip(&worst.0).map(|(middle, worst)| middle + part * (middle - worst)).collect();
            asked += 1;
            let value = value(&at);
            (at, value)
        };
        let reflected = beyond(1.0);
        let next = if reflected.1 > self.points[0].1 {
            let further = beyond(2.0);
            Some(if further.1 > reflected.1 { further } else { reflected })
        } else if reflected.1 > self.points[unknowns - 1].1 {
            Some(reflected)
        } else {
            let nearer = if reflected.1 > worst.1 { beyond(0.5) } else { beyond(-0.5) };
            (nearer.1 > worst.1.max(reflected.1)).then_some(nearer)
        };
        self.asked += asked;
        match next {
            Some(point) => self.points[unknowns] = point,
            None => {
                let best = self.points[0].0.clone();
                for (at, of) in &mut self.points[1..] {
                    at.iter_mut().zip(&best).for_each(|(part, best)| *part = 0.5 * (*part + best));
                    *of = value(at);
                }
                self.asked += unknowns;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn changes_keep_force_and_moment() {
        let places = [0.03, 0.08, 0.13, 0.18, 0.24, 0.4];
        let basis = neutral(&places);
        assert_eq!(basis.len(), 4);
        let free: Vec<f64> = (0..8).map(|k| 0.01 * f64::from(k * k) - 0.2).collect();
        let changes = changes(&basis, &free);
        for towards in 0..2 {
            let sum: f64 = changes.iter().map(|change| change[towards]).sum();
            let moment: f64 = changes.iter().zip(places).map(|(change, z)| z * change[towards]).sum();
            assert!(sum.abs() < 1e-15 && moment.abs() < 1e-15, "{sum:e} {moment:e}");
        }
        assert!(neutral(&[0.1, 0.2]).is_empty());
    }

    /// Two webs, or three at one place: what stays neutral is what statics leaves.
    #[test]
    fn webs_at_one_place_exchange_their_weights() {
        assert_eq!(neutral(&[0.1, 0.1]).len(), 1);
        assert_eq!(neutral(&[0.1, 0.1, 0.3]).len(), 1);
    }
}
