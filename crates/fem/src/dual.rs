//! A value with four partial derivatives: forward differentiation at a point.
//!
//! Laws in `(u, du/dx, du/dz)` that are not linear are written once in this type; seeded with these three, a law yields
//! its Newton tangent. Verified by `derivatives_match_differences`.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number `v` and its partial derivatives `d` by four seeds.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Dual {
    /// Value.
    pub v: f64,
    /// Partial derivatives.
    pub d: [f64; 4],
}

impl Dual {
    /// A constant: all derivatives zero.
    pub const fn constant(v: f64) -> Self {
        Self { v, d: [0.0; 4] }
    }

    /// The seed number `index` (0 to 3): derivative one by itself.
    pub const fn seed(v: f64, index: usize) -> Self {
        let mut d = [0.0; 4];
        d[index] = 1.0;
        Self { v, d }
    }

    /// `f(self)` for a function with value `v` and slope `slope` here.
    pub fn chain(self, v: f64, slope: f64) -> Self {
        Self { v, d: self.d.map(|d| slope * d) }
    }

    /// `exp(self)`.
    pub fn exp(self) -> Self {
        let v = self.v.exp();
        self.chain(v, v)
    }

    /// Natural logarithm.
    pub fn ln(self) -> Self {
        self.chain(self.v.ln(), 1.0 / self.v)
    }

    /// `self^n` for an integer `n`.
    pub fn powi(self, n: i32) -> Self {
        self.chain(self.v.powi(n), f64::from(n) * self.v.powi(n - 1))
    }

    /// `self^n` for a real `n`.
    pub fn powf(self, n: f64) -> Self {
        self.chain(self.v.powf(n), n * self.v.powf(n - 1.0))
    }
}

impl From<f64> for Dual {
    fn from(v: f64) -> Self {
        Self::constant(v)
    }
}

impl Neg for Dual {
    type Output = Self;
    fn neg(self) -> Self {
        self.chain(-self.v, -1.0)
    }
}

impl Add for Dual {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { v: self.v + other.v, d: std::array::from_fn(|k| self.d[k] + other.d[k]) }
    }
}

impl Sub for Dual {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self { v: self.v - other.v, d: std::array::from_fn(|k| self.d[k] - other.d[k]) }
    }
}

impl Mul for Dual {
    type Output = Self;
    #[expect(clippy::suspicious_arithmetic_impl, reason = "the product rule is a sum")]
    fn mul(self, other: Self) -> Self {
        Self { v: self.v * other.v, d: std::array::from_fn(|k| self.d[k] * other.v + self.v * other.d[k]) }
    }
}

impl Div for Dual {
    type Output = Self;
    #[expect(clippy::suspicious_arithmetic_impl, reason = "the quotient rule is a difference")]
    fn div(self, other: Self) -> Self {
        let v = self.v / other.v;
        Self { v, d: std::array::from_fn(|k| (self.d[k] - v * other.d[k]) / other.v) }
    }
}

impl Mul<f64> for Dual {
    type Output = Self;
    fn mul(self, other: f64) -> Self {
        self.chain(self.v * other, other)
    }
}

impl Add<f64> for Dual {
    type Output = Self;
    fn add(self, other: f64) -> Self {
        self.chain(self.v + other, 1.0)
    }
}

impl Mul<Dual> for f64 {
    type Output = Dual;
    fn mul(self, other: Dual) -> Dual {
        other * self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivatives_match_differences() {
        let f = |x: Dual, y: Dual| (x * y - 2.0 * x / y).exp() + y.ln() * x.powi(3) - (x + 1.5).powf(0.6);
        let (x, y, step) = (0.7, 1.3, 1e-6);
        let exact = f(Dual::seed(x, 0), Dual::seed(y, 3));
        let at = |x: f64, y: f64| f(x.into(), y.into()).v;
        assert_eq!(exact.v, at(x, y));
        let by_x = (at(x + step, y) - at(x - step, y)) / (2.0 * step);
        let by_y = (at(x, y + step) - at(x, y - step)) / (2.0 * step);
        assert!((exact.d[0] - by_x).abs() < 1e-8 && (exact.d[3] - by_y).abs() < 1e-8);
        assert_eq!(exact.d[1], 0.0);
    }
}
