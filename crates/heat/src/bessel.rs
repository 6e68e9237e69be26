//! Modified Bessel functions I_n and K_n by ratios and logarithms, which no order and argument overflows.

/// I_{n+1}(x) / I_n(x), by the recurrence from an order at which it is small.
fn ratio_i(n: usize, x: f64) -> f64 {
    /// Orders past the larger of n and x at which the ratio no longer matters.
    const PAST: usize = 60;
    let first = n.max(x as usize) + PAST;
    (n..first).rev().fold(0.0, |ratio, m| 1.0 / (2.0 * (m + 1) as f64 / x + ratio))
}

/// K_0(x) e^x and K_1(x) e^x: the trapezoidal rule gives Int_0^inf exp(-x (cosh t - 1)) cosh(n t) dt to rounding.
fn scaled_k(x: f64) -> [f64; 2] {
    /// Step of the rule.
    const STEP: f64 = 0.05;
    /// Exponent below which a term is nothing.
    const LEAST: f64 = -45.0;
    let mut sums = [0.5, 0.5];
    let mut t = STEP;
    loop {
        let exponent = -x * 2.0 * (0.5 * t).sinh().powi(2);
        let left = exponent + t;
        if left < LEAST || left.is_nan() {
            return sums.map(|sum| sum * STEP);
        }
        let weight = exponent.exp();
        sums[0] += weight;
        sums[1] += weight * t.cosh();
        t += STEP;
    }
}

/// K_{n+1}(x) / K_n(x) for n from 0 to `last`.
fn ratios_k(last: usize, x: f64) -> Vec<f64> {
    let [k0, k1] = scaled_k(x);
    let mut ratios = vec![k1 / k0];
    for n in 1..=last {
        ratios.push(2.0 * n as f64 / x + 1.0 / ratios[n - 1]);
    }
    ratios
}

/// A function at a place, by its logarithm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Logarithmic {
    /// Logarithm of the function.
    pub(crate) log: f64,
    /// Slope over value.
    pub(crate) slope: f64,
}

/// I_n(x) and its slope.
pub(crate) fn bessel_i(n: usize, x: f64) -> Logarithmic {
    let [k0, k1] = scaled_k(x);
    // Wronskian: I_0 K_1 + I_1 K_0 = 1/x.
    let zeroth = x - (x * (k1 + ratio_i(0, x) * k0)).ln();
    let log = (0..n).map(|m| ratio_i(m, x).ln()).sum::<f64>() + zeroth;
    Logarithmic { log, slope: ratio_i(n, x) + n as f64 / x }
}

/// K_n(x) and its slope.
pub(crate) fn bessel_k(n: usize, x: f64) -> Logarithmic {
    let ratios = ratios_k(n, x);
    let log = ratios[..n].iter().map(|ratio| ratio.ln()).sum::<f64>() + scaled_k(x)[0].ln() - x;
    Logarithmic { log, slope: n as f64 / x - ratios[n] }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Abramowitz and Stegun, Handbook of Mathematical Functions (1964), tables 9.8 and 9.11.
    #[test]
    fn tables_of_abramowitz_and_stegun() {
        let near = |value: Logarithmic, table: f64| assert!((value.log.exp() / table - 1.0).abs() < 1e-9, "{table}");
        near(bessel_i(0, 1.0), 1.266_065_877_752_008);
        near(bessel_i(1, 1.0), 0.565_159_103_992_485);
        near(bessel_k(0, 1.0), 0.421_024_438_240_708_3);
        near(bessel_k(1, 1.0), 0.601_907_230_197_234_6);
        near(bessel_i(2, 5.0), 17.505_614_966_624_236);
        near(bessel_k(2, 5.0), 0.005_308_943_712_223_46);
    }

    #[test]
    fn wronskian_holds_for_all_orders_and_arguments() {
        for n in [0, 1, 7, 24, 60] {
            for x in [1e-3, 0.1, 1.0, 10.0, 300.0] {
                let (i, k) = (bessel_i(n, x), bessel_k(n, x));
                let product = (i.log + k.log).exp() * (i.slope - k.slope) * x;
                assert!((product - 1.0).abs() < 1e-12, "{n} {x}: {product}");
            }
        }
    }
}
