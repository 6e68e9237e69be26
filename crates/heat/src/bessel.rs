//! Modified Bessel functions I_n and K_n by ratios and logarithms, which no order and argument overflows.

/// I_{n+1}(x) / I_n(x) for n from 0 to `last`, by the recurrence from an order at which it is small.
fn ratios_i(last: usize, x: f64) -> Vec<f64> {
    /// Orders past the larger of n and x at which the ratio no longer matters.
    const PAST: usize = 60;
    let first = last.max(x as usize) + PAST;
    let (mut ratio, mut ratios) = (0.0, vec![0.0; last + 1]);
    for n in (0..first).rev() {
        ratio = 1.0 / (2.0 * (n + 1) as f64 / x + ratio);
        if n <= last {
            ratios[n] = ratio;
        }
    }
    ratios
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

/// A function at a place, by its logarithm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Logarithmic {
    /// Logarithm of the function.
    pub(crate) log: f64,
    /// Slope over value.
    pub(crate) slope: f64,
}

/// I_n(x) and K_n(x) with their slopes for n from 0 to `last`.
pub(crate) fn bessel(last: usize, x: f64) -> Vec<[Logarithmic; 2]> {
    let [k0, k1] = scaled_k(x);
    let of_i = ratios_i(last, x);
    // Wronskian: I_0 K_1 + I_1 K_0 = 1/x.
    let zeroth = x - (x * (k1 + of_i[0] * k0)).ln();
    let mut of_k = k1 / k0;
    // Logarithms of I_n/I_0 and K_n/K_0.
    let mut grown = [0.0, 0.0];
    (0..=last)
        .map(|n| {
            let order = n as f64 / x;
            let i = Logarithmic { log: grown[0] + zeroth, slope: of_i[n] + order };
            let k = Logarithmic { log: grown[1] + k0.ln() - x, slope: order - of_k };
            grown = [grown[0] + of_i[n].ln(), grown[1] + of_k.ln()];
            of_k = 2.0 * (n + 1) as f64 / x + 1.0 / of_k;
            [i, k]
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Abramowitz and Stegun, Handbook of Mathematical Functions (1964), tables 9.8 and 9.11.
    #[test]
    fn tables_of_abramowitz_and_stegun() {
        let near = |value: Logarithmic, table: f64| assert!((value.log.exp() / table - 1.0).abs() < 1e-9, "{table}");
        let [one, five] = [1.0, 5.0].map(|x| bessel(2, x));
        near(one[0][0], 1.266_065_877_752_008);
        near(one[1][0], 0.565_159_103_992_485);
        near(one[0][1], 0.421_024_438_240_708_3);
        near(one[1][1], 0.601_907_230_197_234_6);
        near(five[2][0], 17.505_614_966_624_236);
        near(five[2][1], 0.005_308_943_712_223_46);
    }

    #[test]
    fn wronskian_holds_for_all_orders_and_arguments() {
        for x in [1e-3, 0.1, 1.0, 10.0, 300.0] {
            for (n, [i, k]) in bessel(60, x).into_iter().enumerate() {
                let product = (i.log + k.log).exp() * (i.slope - k.slope) * x;
                assert!((product - 1.0).abs() < 1e-12, "{n} {x}: {product}");
            }
        }
    }
}
