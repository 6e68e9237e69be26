//! Fits of a positive function whose greatest relative error, over what is allowed at each point, is least:
//! Gauss-Newton steps with Lawson's weights, which grow where the error is large (Lawson 1961; Rice and Usow, Math.
//! Comp. 22 (1968) 118).

/// Parameters of a fit.
pub(super) const PARAMETERS: usize = 5;
/// Changes of the weights.
const ROUNDS: usize = 60;
/// Gauss-Newton steps with the same weights, at most.
const STEPS: usize = 30;
/// Part of its weight that a point keeps where its error is zero.
const KEPT: f64 = 1e-3;
/// Step of the difference quotients, over the parameter or one.
const DIFFERENCE: f64 = 1e-6;

/// Logarithm of a model at each point.
pub(super) type FitModel<'a> = &'a dyn Fn([f64; PARAMETERS]) -> Option<Vec<f64>>;

/// The parameters, from the best of several starts, and their greatest error over what is allowed. `logarithms` are
/// those of the data, `allowed` the relative error allowed at each point. `None` where no start leads to a model that
/// is positive everywhere.
pub(super) fn minimax(
    model: FitModel<'_>,
    logarithms: &[f64],
    allowed: &[f64],
    starts: &[[f64; PARAMETERS]],
) -> Option<([f64; PARAMETERS], f64)> {
    let fits = starts.iter().filter_map(|&start| from(model, logarithms, allowed, start));
    fits.min_by(|a, b| a.1.total_cmp(&b.1))
}

fn from(
    model: FitModel<'_>,
    data: &[f64],
    allowed: &[f64],
    start: [f64; PARAMETERS],
) -> Option<([f64; PARAMETERS], f64)> {
    let errors = |at| Some(errors(&model(at)?, data, allowed));
    let mut at = start;
    let mut weights = vec![1.0; data.len()];
    let mut best: Option<([f64; PARAMETERS], f64)> = None;
    for _ in 0..ROUNDS {
        at = least_squares(&errors, &weights, at)?;
        let now: Vec<f64> = errors(at)?.iter().map(|error| error.abs()).collect();
        let worst = now.iter().copied().fold(0.0, f64::max);
        if best.is_none_or(|(_, least)| worst < least) {
            best = Some((at, worst));
        }
        let scale = worst.max(f64::MIN_POSITIVE);
        weights.iter_mut().zip(&now).for_each(|(weight, error)| *weight *= error / scale + KEPT);
        let mean = weights.iter().sum::<f64>() / weights.len() as f64;
        weights.iter_mut().for_each(|weight| *weight /= mean);
    }
    best
}

/// Relative errors over those allowed.
pub(super) fn errors(model: &[f64], data: &[f64], allowed: &[f64]) -> Vec<f64> {
    let pairs = model.iter().zip(data).zip(allowed);
    pairs.map(|((model, data), allowed)| ((model - data).exp() - 1.0) / allowed).collect()
}

/// Parameters with the least weighted sum of squares, by Levenberg's damping.
fn least_squares(
    errors: &dyn Fn([f64; PARAMETERS]) -> Option<Vec<f64>>,
    weights: &[f64],
    start: [f64; PARAMETERS],
) -> Option<[f64; PARAMETERS]> {
    let square = |errors: &[f64]| errors.iter().zip(weights).map(|(e, w)| w * e * e).sum::<f64>();
    let (mut at, mut now) = (start, errors(start)?);
    let mut damping = 1e-3;
    for _ in 0..STEPS {
        let columns = slopes(errors, at)?;
        let mut matrix = [[0.0; PARAMETERS]; PARAMETERS];
        let mut right = [0.0; PARAMETERS];
        for i in 0..PARAMETERS {
            let with =
                |other: &[f64]| columns[i].iter().zip(other).zip(weights).map(|((a, b), w)| w * a * b).sum::<f64>();
            right[i] = -with(&now);
            for j in 0..PARAMETERS {
                matrix[i][j] = with(&columns[j]);
            }
        }
        let (mut moved, old) = (false, square(&now));
        while damping < 1e12 {
            let mut damped = matrix;
            (0..PARAMETERS).for_each(|i| damped[i][i] *= 1.0 + damping);
            let next = solve(damped, right).map(|step| std::array::from_fn(|i| at[i] + step[i]));
            let found = next.and_then(|next| Some((next, errors(next)?)));
            if let Some((next, then)) = found.filter(|(_, then)| square(then) < old) {
                (at, now, moved) = (next, then, true);
                damping = (0.1 * damping).max(1e-12);
                break;
            }
            damping *= 10.0;
        }
        if !moved || square(&now) > (1.0 - 1e-10) * old {
            break;
        }
    }
    Some(at)
}

/// Columns of difference quotients.
fn slopes(errors: &dyn Fn([f64; PARAMETERS]) -> Option<Vec<f64>>, at: [f64; PARAMETERS]) -> Option<Vec<Vec<f64>>> {
    let column = |k: usize| {
        let step = DIFFERENCE * at[k].abs().max(1.0);
        let beside = |sign: f64| {
            let mut beside = at;
            beside[k] += sign * step;
            errors(beside)
        };
        let (low, high) = (beside(-1.0)?, beside(1.0)?);
        Some(low.iter().zip(high).map(|(low, high)| (high - low) / (2.0 * step)).collect())
    };
    (0..PARAMETERS).map(column).collect()
}

/// Solves a symmetric positive definite system; `None` where it is singular.
fn solve(mut matrix: [[f64; PARAMETERS]; PARAMETERS], mut right: [f64; PARAMETERS]) -> Option<[f64; PARAMETERS]> {
    for k in 0..PARAMETERS {
        let pivot = matrix[k][k];
        if !(pivot.is_finite() && pivot > 0.0) {
            return None;
        }
        for i in k + 1..PARAMETERS {
            let factor = matrix[i][k] / pivot;
            let above = matrix[k];
            (k..PARAMETERS).for_each(|j| matrix[i][j] -= factor * above[j]);
            right[i] -= factor * right[k];
        }
    }
    for k in (0..PARAMETERS).rev() {
        let known: f64 = (k + 1..PARAMETERS).map(|j| matrix[k][j] * right[j]).sum();
        right[k] = (right[k] - known) / matrix[k][k];
    }
    right.iter().all(|x| x.is_finite()).then_some(right)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The quartic with the least greatest relative error of `e^x` over [0, 1] is off by about 2^-9/(5! 2^4), as
    /// Chebyshev's polynomial says.
    #[test]
    fn a_polynomial_levels_its_errors() {
        let points: Vec<f64> =
            (0..=60).map(|k| 0.5 - 0.5 * (std::f64::consts::PI * f64::from(k) / 60.0).cos()).collect();
        let model = |q: [f64; PARAMETERS]| {
            let value = |x: f64| q.iter().rev().fold(0.0, |sum, q| sum * x + q);
            points.iter().map(|&x| Some(value(x)).filter(|v| *v > 0.0).map(f64::ln)).collect::<Option<Vec<f64>>>()
        };
        let (_, worst) =
            minimax(&model, &points, &vec![1.0; points.len()], &[[1.0, 1.0, 0.5, 0.0, 0.0]]).expect("a fit");
        let mean = 0.5f64.exp();
        let wanted = mean * 2.0f64.powi(-9) / 120.0 / mean;
        assert!(worst > 0.5 * wanted && worst < 1.5 * wanted, "{worst:e} {wanted:e}");
        assert!(minimax(&|_| None, &points, &points, &[[0.0; PARAMETERS]]).is_none());
    }
}
