//! Periodic cubic splines through points at uneven distances.
//!
//! With h_i the distance from knot i to the next, d_i the slope of the chord and m_i the second derivative at a knot,
//! ```text
//! h_(i-1) m_(i-1) + 2 (h_(i-1) + h_i) m_i + h_i m_(i+1) = 6 (d_i - d_(i-1))
//! ```
//! for all knots, indices modulo their number: a cyclic tridiagonal system, diagonally dominant, solved by elimination of its last unknown. The slope at a knot is
//! `s_i = d_i - h_i (2 m_i + m_(i+1))/6`, and between knots the value is the cubic with these slopes.
//!
//! Through uneven or jumping points a spline overshoots without a limit. [`PeriodicSpline::within_points`] limits each slope: zero at a knot with a chord of each sign, else of the sign of the
//! chords and at most three times the flatter one. The cubic is then monotone between knots, so its values stay between those of the two points; where a slope is limited the second derivative
//! jumps.
//!
//! **Source.** C. de Boor, A Practical Guide to Splines, 1978, ch. IV; F. N. Fritsch, R. E. Carlson, SIAM J. Numer. Anal. 17 (1980) 238, for the limits.

/// Fewest knots of a periodic cubic.
pub const LEAST_KNOTS: usize = 3;

/// Slopes of a monotone cubic are at most so many times that of the chord.
const STEEPEST: f64 = 3.0;

/// A periodic function with continuous first and, unless it is kept within its points, second derivatives; `N` values at once.
#[derive(Debug, Clone, PartialEq)]
pub struct PeriodicSpline<const N: usize> {
    period: f64,
    knots: Vec<f64>,
    values: Vec<[f64; N]>,
    slopes: Vec<[f64; N]>,
}

/// Why there is no spline through points.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum NoSpline {
    /// There are too few points.
    #[error("there are {0} points, and a periodic cubic needs {LEAST_KNOTS}")]
    Few(usize),
    /// This knot, counted from 0, is not beyond the one before, or not less than a period beyond the first, or it is no finite number.
    #[error("point {0} is not beyond the one before it, or not less than a period beyond the first")]
    Order(usize),
    /// A value at this knot, counted from 0, is no finite number.
    #[error("a value of point {0} is not finite")]
    Value(usize),
}

impl<const N: usize> PeriodicSpline<N> {
    /// The spline through `values` at growing `knots`, the last of which is less than `period` beyond the first.
    ///
    /// # Errors
    /// [`NoSpline`]: too few knots, knots that do not grow, or values that are not finite.
    ///
    /// # Panics
    /// There are not as many values as knots.
    pub fn new(knots: Vec<f64>, values: Vec<[f64; N]>, period: f64) -> Result<Self, NoSpline> {
        assert_eq!(knots.len(), values.len(), "a value for each knot");
        if knots.len() < LEAST_KNOTS {
            return Err(NoSpline::Few(knots.len()));
        }
        let is_in_order = |k: usize| {
            let (first, knot) = (knots[0], knots[k]);
            knot.is_finite() && (k == 0 || knot > knots[k - 1]) && knot - first < period
        };
        if let Some(k) = (0..knots.len()).find(|&k| !is_in_order(k)) {
            return Err(NoSpline::Order(k));
        }
        if let Some(k) = (values.iter()).position(|value| !value.iter().all(|part| part.is_finite())) {
            return Err(NoSpline::Value(k));
        }
        let slopes = slopes(&knots, &values, period);
        Ok(Self {
            period,
            knots,
            values,
            slopes,
        })
    }

    /// This curve with limited slopes: between two points its values stay between theirs.
    #[must_use]
    pub fn within_points(mut self) -> Self {
        let count = self.knots.len();
        for part in 0..N {
            let chord = |k: usize| chord(&self.knots, &self.values, self.period, [k, part]);
            let chords: Vec<f64> = (0..count).map(chord).collect();
            for (k, slope) in self.slopes.iter_mut().enumerate() {
                let (before, after) = (chords[(k + count - 1) % count], chords[k]);
                slope[part] = match before * after > 0.0 {
                    true => {
                        let steepest = STEEPEST * before.abs().min(after.abs());
                        after.signum() * (after.signum() * slope[part]).clamp(0.0, steepest)
                    }
                    false => 0.0,
                };
            }
        }
        self
    }

    /// The points: knots and values.
    pub fn points(&self) -> impl Iterator<Item = (f64, [f64; N])> {
        self.knots.iter().copied().zip(self.values.iter().copied())
    }

    /// The values at a place.
    pub fn at(&self, place: f64) -> [f64; N] {
        let (knots, count) = (&self.knots, self.knots.len());
        let place = knots[0] + (place - knots[0]).rem_euclid(self.period);
        let k = knots.partition_point(|&knot| knot <= place).clamp(1, count) - 1;
        let next = (k + 1) % count;
        let step = distance(knots, k, self.period);
        let b = (place - knots[k]) / step;
        let a = 1.0 - b;
        std::array::from_fn(|part| {
            a * a * (1.0 + 2.0 * b) * self.values[k][part]
                + b * b * (1.0 + 2.0 * a) * self.values[next][part]
                + a * b * step * (a * self.slopes[k][part] - b * self.slopes[next][part])
        })
    }
}

/// From knot k to the next.
fn distance(knots: &[f64], k: usize, period: f64) -> f64 {
    match knots.get(k + 1) {
        Some(next) => next - knots[k],
        None => knots[0] + period - knots[k],
    }
}

/// Slope of a value between knot k and the next.
fn chord<const N: usize>(knots: &[f64], values: &[[f64; N]], period: f64, [k, part]: [usize; 2]) -> f64 {
    (values[(k + 1) % knots.len()][part] - values[k][part]) / distance(knots, k, period)
}

/// Slopes of the spline at the knots.
fn slopes<const N: usize>(knots: &[f64], values: &[[f64; N]], period: f64) -> Vec<[f64; N]> {
    let bends = bends(knots, values, period);
    let slope = |k: usize, part: usize| {
        let (here, next) = (bends[k][part], bends[(k + 1) % knots.len()][part]);
        chord(knots, values, period, [k, part]) - distance(knots, k, period) * (2.0 * here + next) / 6.0
    };
    (0..knots.len())
        .map(|k| std::array::from_fn(|part| slope(k, part)))
        .collect()
}

/// The second derivatives at the knots.
fn bends<const N: usize>(knots: &[f64], values: &[[f64; N]], period: f64) -> Vec<[f64; N]> {
    let count = knots.len();
    let steps: Vec<f64> = (0..count).map(|k| distance(knots, k, period)).collect();
    let chord = |k: usize, part: usize| chord(knots, values, period, [k, part]);
    let before = |k: usize| (k + count - 1) % count;
    let right = |k: usize| -> [f64; N] { std::array::from_fn(|part| 6.0 * (chord(k, part) - chord(before(k), part))) };
    let diagonal = |k: usize| 2.0 * (steps[before(k)] + steps[k]);
    // Unknown k is `free - share * last` with the last unknown: the first count - 1 rows are tridiagonal beside it.
    let last = count - 1;
    let (mut upper, mut share) = (vec![0.0; last], vec![0.0; last]);
    let mut free = vec![[0.0; N]; last];
    for k in 0..last {
        let below = if k == 0 { 0.0 } else { steps[k - 1] };
        let (upper_above, share_above, free_above) = match k {
            0 => (0.0, 0.0, [0.0; N]),
            _ => (upper[k - 1], share[k - 1], free[k - 1]),
        };
        let pivot = diagonal(k) - below * upper_above;
        let to_last = if k == 0 { steps[last] } else { 0.0 } + if k + 1 == last { steps[k] } else { 0.0 };
        let right = right(k);
        upper[k] = steps[k] / pivot;
        share[k] = (to_last - below * share_above) / pivot;
        free[k] = std::array::from_fn(|part| (right[part] - below * free_above[part]) / pivot);
    }
    for k in (0..last.saturating_sub(1)).rev() {
        let next = free[k + 1];
        share[k] -= upper[k] * share[k + 1];
        free[k] = std::array::from_fn(|part| free[k][part] - upper[k] * next[part]);
    }
    let pivot = diagonal(last) - steps[last] * share[0] - steps[last - 1] * share[last - 1];
    let right = right(last);
    let of_last: [f64; N] = std::array::from_fn(|part| {
        (right[part] - steps[last] * free[0][part] - steps[last - 1] * free[last - 1][part]) / pivot
    });
    let bend = |k: usize| std::array::from_fn(|part| free[k][part] - share[k] * of_last[part]);
    (0..last).map(bend).chain([of_last]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    /// Uneven knots on a turn, beginning at `first`.
    fn knots(count: usize, first: f64) -> Vec<f64> {
        let even = |k: usize| TAU * k as f64 / count as f64;
        (0..count)
            .map(|k| first + even(k) + 0.3 / count as f64 * (3.0 * even(k)).sin())
            .collect()
    }

    fn through_sine(count: usize) -> PeriodicSpline<2> {
        let knots = knots(count, 0.4);
        let values = knots.iter().map(|knot| [knot.sin(), (2.0 * knot).cos()]).collect();
        PeriodicSpline::new(knots, values, TAU).expect("a spline")
    }

    fn error(count: usize) -> f64 {
        let spline = through_sine(count);
        let errors = (0..1000).map(|k| {
            let place = 0.013 * f64::from(k) - 4.0;
            let [sine, cosine] = spline.at(place);
            f64::max((sine - place.sin()).abs(), (cosine - (2.0 * place).cos()).abs())
        });
        errors.fold(0.0, f64::max)
    }

    #[test]
    fn the_error_falls_with_the_fourth_power_of_the_distance_of_knots() {
        let errors = [20, 40, 80].map(error);
        assert!(errors[2] < 1e-5, "{errors:?}");
        for pair in errors.windows(2) {
            assert!(pair[0] / pair[1] > 14.0, "{errors:?}");
        }
    }

    #[test]
    fn values_are_those_of_the_points_and_derivatives_have_no_jump() {
        for count in [3, 4, 7] {
            let spline = through_sine(count);
            for (k, &knot) in spline.knots.clone().iter().enumerate() {
                for place in [knot - TAU, knot, knot + 3.0 * TAU] {
                    let error = (spline.at(place)[0] - spline.values[k][0]).abs();
                    assert!(error < 1e-13, "{count} {k}: {error}");
                }
                let h = 1e-3;
                let at = |steps: f64| spline.at(knot + steps * h)[1];
                // One-sided first and second differences, exact for cubics where four points are taken.
                let side = |sign: f64| {
                    let [f0, f1, f2, f3] = [0.0, 1.0, 2.0, 3.0].map(|n| at(sign * n));
                    let slope = sign * (-11.0 * f0 + 18.0 * f1 - 9.0 * f2 + 2.0 * f3) / (6.0 * h);
                    [slope, (2.0 * f0 - 5.0 * f1 + 4.0 * f2 - f3) / (h * h)]
                };
                let (right, left) = (side(1.0), side(-1.0));
                assert!((right[0] - left[0]).abs() < 1e-8, "{count} {k}: {right:?} {left:?}");
                assert!((right[1] - left[1]).abs() < 1e-6, "{count} {k}: {right:?} {left:?}");
            }
        }
    }

    /// Numbers from 0 to 1 of a linear congruential generator.
    fn random(state: &mut u64) -> f64 {
        *state = state
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (*state >> 11) as f64 / (1u64 << 53) as f64
    }

    #[test]
    fn a_curve_within_its_points_never_leaves_those_beside_a_place() {
        let mut state = 7;
        let mut overshoots = 0;
        for count in (3..40).chain([200]) {
            // Distances of knots differ by four decades; values have jumps and level stretches.
            let steps: Vec<f64> = (0..count).map(|_| 10f64.powf(-4.0 * random(&mut state))).collect();
            let whole: f64 = steps.iter().sum();
            let mut place = random(&mut state) - 0.5;
            let mut knots = Vec::new();
            for step in &steps {
                knots.push(place);
                place += TAU * step / whole;
            }
            let values: Vec<[f64; 1]> = (0..count).map(|_| [(8.0 * random(&mut state)).round() - 4.0]).collect();
            let spline = PeriodicSpline::new(knots, values, TAU).expect("a spline");
            let within = spline.clone().within_points();
            for k in 0..count {
                let (from, step) = (spline.knots[k], distance(&spline.knots, k, TAU));
                let ends = [k, (k + 1) % count].map(|k| spline.values[k][0]);
                let [low, high] = [ends[0].min(ends[1]) - 1e-12, ends[0].max(ends[1]) + 1e-12];
                let mut last = ends[0];
                for n in 1..20 {
                    let place = from + step * f64::from(n) / 20.0;
                    let value = within.at(place)[0];
                    assert!((low..=high).contains(&value), "{count} {k} {n}: {value} of {ends:?}");
                    assert!((value - last) * (ends[1] - ends[0]) >= -1e-12, "{count} {k} {n}");
                    last = value;
                    overshoots += usize::from(!(low..=high).contains(&spline.at(place)[0]));
                }
            }
        }
        assert!(overshoots > 1000, "{overshoots}: the points are too tame for this test");
    }

    #[test]
    fn slopes_of_smooth_points_are_limited_next_to_their_extremes_alone() {
        let spline = through_sine(80);
        let within = spline.clone().within_points();
        let changed = |part: usize| {
            (0..80)
                .filter(|k| spline.slopes[*k][part] != within.slopes[*k][part])
                .count()
        };
        assert_eq!([changed(0), changed(1)], [2, 4]);
        let off = (0..1000).map(|k| {
            let place = 0.00628 * f64::from(k);
            (within.at(place)[0] - place.sin()).abs()
        });
        let off = off.fold(0.0, f64::max);
        assert!(off < 5e-4, "{off}");
    }

    #[test]
    fn wrong_points_are_refused() {
        let spline = |knots: &[f64], value: f64| PeriodicSpline::new(knots.to_vec(), vec![[value]; knots.len()], TAU);
        assert_eq!(spline(&[0.0, 1.0], 1.0), Err(NoSpline::Few(2)));
        assert_eq!(spline(&[0.0, 1.0, 1.0], 1.0), Err(NoSpline::Order(2)));
        assert_eq!(spline(&[0.0, 1.0, TAU], 1.0), Err(NoSpline::Order(2)));
        assert_eq!(spline(&[f64::NAN, 1.0, 2.0], 1.0), Err(NoSpline::Order(0)));
        assert_eq!(spline(&[0.0, 1.0, 2.0], f64::INFINITY), Err(NoSpline::Value(0)));
        let constant = spline(&[0.0, 1.0, 2.0], 7.0).expect("a spline");
        assert!((constant.at(-100.3)[0] - 7.0).abs() < 1e-12);
    }
}
