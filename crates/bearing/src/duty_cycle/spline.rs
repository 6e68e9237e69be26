//! Periodic cubic splines through points at uneven distances.
//!
//! With h_i the distance from knot i to the next, d_i the slope of the chord and m_i the second derivative at a knot,
//! ```text
//! h_(i-1) m_(i-1) + 2 (h_(i-1) + h_i) m_i + h_i m_(i+1) = 6 (d_i - d_(i-1))
//! ```
//! for all knots, indices modulo their number: a cyclic tridiagonal system, diagonally dominant, solved by elimination
//! of its last unknown. The slope at a knot is `s_i = d_i - h_i (2 m_i + m_(i+1))/6`, and between knots the value is
//! the cubic with these slopes.
//!
//! Through uneven or jumping points a spline overshoots without a limit. [`PeriodicSpline::within_points`] limits each
//! slope by the chords beside its knot, with D_i the step of the value over h_i:
//! ```text
//! c_i = 2 (d_i - d_(i-1))/(h_(i-1) + h_i),       b_i = minmod(c_i, c_(i+1))
//! t_i = minmod(d_(i-1) + h_(i-1) b_(i-1)/2, d_i - h_i b_i/2)
//! |s_i| <= max(3 |minmod(d_(i-1), d_i)|, min(3/2 |t_i|, max(|D_(i-1)|, |D_i|)/max(h_(i-1), h_i))),  of the sign of t_i
//! ```
//! minmod is the lesser of two numbers of one sign, else zero. By the first limit the cubic is monotone between knots.
//! The second one lets a curve pass its points where they bend the same way on both sides, as at the peak of a smooth
//! function, by less than 4/27 of the steps beside; next to a step or a level stretch it is zero. Smooth points keep
//! their spline and its continuous second derivative.
//!
//! **Source.** C. de Boor, A Practical Guide to Splines, 1978, ch. IV; F. N. Fritsch, R. E. Carlson, SIAM J. Numer.
//! Anal. 17 (1980) 238, for the first limit; H. T. Huynh, SIAM J. Numer. Anal. 30 (1993) 57, for the second.

/// Fewest knots of a periodic cubic.
pub const LEAST_KNOTS: usize = 3;

/// Slopes of a monotone cubic are at most so many times that of the chord.
const STEEPEST: f64 = 3.0;
/// Slopes next to an extreme of smooth points are at most so many times those of parabolas.
const AT_EXTREMES: f64 = 1.5;

/// A periodic function with continuous first and, unless it is kept within its points, second derivatives; `N` values
/// at once.
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
    /// This knot, counted from 0, is not beyond the one before, or not less than a period beyond the first, or it is no
    /// finite number.
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
        Ok(Self { period, knots, values, slopes })
    }

    /// This curve with limited slopes: between two points its values stay between theirs, but for a smooth extreme that
    /// lies there.
    #[must_use]
    pub fn within_points(mut self) -> Self {
        let count = self.knots.len();
        let steps: Vec<f64> = (0..count).map(|k| distance(&self.knots, k, self.period)).collect();
        let (before, next) = (|k: usize| (k + count - 1) % count, |k: usize| (k + 1) % count);
        for part in 0..N {
            let chords: Vec<f64> =
                (0..count).map(|k| chord(&self.knots, &self.values, self.period, [k, part])).collect();
            let bend = |k: usize| 2.0 * (chords[k] - chords[before(k)]) / (steps[before(k)] + steps[k]);
            let even: Vec<f64> = (0..count).map(|k| minmod(bend(k), bend(next(k)))).collect();
            for (k, slope) in self.slopes.iter_mut().enumerate() {
                let j = before(k);
                let parabolas = minmod(chords[j] + 0.5 * steps[j] * even[j], chords[k] - 0.5 * steps[k] * even[k]);
                let change = (chords[j] * steps[j]).abs().max((chords[k] * steps[k]).abs());
                let passing = (AT_EXTREMES * parabolas.abs()).min(change / steps[j].max(steps[k]));
                let steepest = passing.max(STEEPEST * minmod(chords[j], chords[k]).abs());
                slope[part] = minmod(slope[part], steepest.copysign(parabolas));
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

/// The lesser of two numbers of one sign; else zero.
fn minmod(a: f64, b: f64) -> f64 {
    match a * b > 0.0 {
        true => a.signum() * a.abs().min(b.abs()),
        false => 0.0,
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
    (0..knots.len()).map(|k| std::array::from_fn(|part| slope(k, part))).collect()
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
        (0..count).map(|k| first + even(k) + 0.3 / count as f64 * (3.0 * even(k)).sin()).collect()
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
        *state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (*state >> 11) as f64 / (1u64 << 53) as f64
    }

    #[test]
    fn a_curve_within_its_points_passes_them_at_smooth_extremes_alone() {
        let mut state = 7;
        let mut overshoots = 0;
        for count in (4..40).chain([200]) {
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
            let value = |k: usize| spline.values[k % count][0];
            for k in 0..count {
                let (from, step) = (spline.knots[k], distance(&spline.knots, k, TAU));
                let [a, b, c, d] = [count - 1, count, count + 1, count + 2].map(|n| value(k + n));
                // An extreme may lie between where both points are higher, or both lower, than those beside them.
                let room = match (b - a) * (c - d) > 0.0 {
                    true => 4.0 / 27.0 * ((b - a).abs().max((c - b).abs()) + (c - d).abs().max((c - b).abs())),
                    false => 0.0,
                };
                let [low, high] = [b.min(c) - room - 1e-12, b.max(c) + room + 1e-12];
                for n in 1..20 {
                    let place = from + step * f64::from(n) / 20.0;
                    let found = within.at(place)[0];
                    assert!((low..=high).contains(&found), "{count} {k} {n}: {found} of {b} {c}");
                    overshoots += usize::from(!(low..=high).contains(&spline.at(place)[0]));
                }
            }
        }
        assert!(overshoots > 1000, "{overshoots}: the points are too tame for this test");
    }

    #[test]
    fn smooth_points_keep_their_spline_and_steps_stay_steps() {
        let spline = through_sine(40);
        assert_eq!(spline.clone().within_points(), spline);
        // 5 up to 179.9 degrees, then -5.
        let knots = [0.0, 60.0, 120.0, 179.9, 180.0, 240.0, 300.0, 359.9].map(f64::to_radians);
        let values = [5.0, 5.0, 5.0, 5.0, -5.0, -5.0, -5.0, -5.0].map(|value| [value]);
        let step = PeriodicSpline::new(knots.to_vec(), values.to_vec(), TAU).expect("a spline");
        let greatest = |curve: &PeriodicSpline<1>| {
            let values = (0..7200).map(|k| curve.at(TAU * f64::from(k) / 7200.0)[0].abs());
            values.fold(0.0, f64::max)
        };
        assert!(greatest(&step) > 1000.0);
        assert!((greatest(&step.within_points()) - 5.0).abs() < 1e-12);
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
