//! # Points across a film
//!
//! **Equation.** A temperature across the film is the polynomial of degree N through its values at the N + 1 Lobatto
//! points `eta_l` of 0..1; integrals are sums over these points, or over the N Gauss points `g`:
//! ```text
//! Int f = sum_l w_l f(eta_l)      T(g) = sum_l psi_l(g) T_l      T'(g) = sum_l psi_l'(g) T_l      Int_0^{eta_j} psi_l
//! ```
//! | symbol | unit | code |
//! |---|---|---|
//! | eta_l, w_l | 1 | `points`, `weights` |
//! | w_g | 1 | `gauss_weights` |
//! | psi_l(g), psi_l'(g) | 1 | `values`, `slopes` |
//! | Int_0^{eta_j} psi_l | 1 | `integrals` |
//!
//! In a turbulent film the layers are equal steps of a coordinate in which a temperature is linear from point to point
//! ([`crate::EddyScales`]): psi_l are hats, and the N Gauss points lie midway.
//!
//! **Source.** Canuto, Hussaini, Quarteroni, Zang, Spectral Methods (2006), ch. 2.
//! **Range.** N of 2, 3, 4, 6 or 8. Lobatto sums are exact to degree 2N - 1, sums over Gauss points likewise.
//! **Verified by** `crates/heat/tests/layers.rs`.

use std::cmp::Ordering;

use crate::small_matrix::{LARGEST, invert};

/// Numbers of layers N that may be asked for.
pub const COUNTS: [usize; 5] = [2, 3, 4, 6, 8];
/// Most points across a film.
pub const MOST_POINTS: usize = LARGEST;

/// What a temperature is between the points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum LayerShape {
    Polynomial,
    Linear,
}

/// Points across the film, from the bush (eta = 0) to the journal (eta = 1), and what is computed with them.
#[derive(Debug, Clone, PartialEq)]
pub struct Layers {
    shape: LayerShape,
    /// Lobatto points `eta_l`, N + 1 of them; both walls are points.
    pub points: Vec<f64>,
    /// Weights `w_l` of the points; they sum to 1.
    pub weights: Vec<f64>,
    /// Weights of the N Gauss points; they sum to 1.
    pub gauss_weights: Vec<f64>,
    /// Rows `psi_l(g)`, one for each Gauss point.
    pub values: Vec<Vec<f64>>,
    /// Rows `psi_l'(g)`, one for each Gauss point.
    pub slopes: Vec<Vec<f64>>,
    /// Rows `Int_0^{eta_j} psi_l`, one for each point `eta_j`.
    pub integrals: Vec<Vec<f64>>,
    /// Rows `sum_g w_g psi_j'(g) psi_l'(g)`, the conduction between the points.
    pub(crate) conduction: Vec<Vec<f64>>,
    /// Rows that give the velocity across the film at each Gauss point from the net outflow of the layers.
    pub(crate) crossing: Vec<Vec<f64>>,
}

impl Layers {
    /// The points of `count` layers; `None` for a number that is not one of [`COUNTS`].
    pub fn new(count: usize) -> Option<Self> {
        if !COUNTS.contains(&count) {
            return None;
        }
        let (points, weights) = lobatto(count);
        let (gauss, gauss_weights) = gauss(count);
        let integral = |end: f64, l: usize| -> f64 {
            let terms = gauss.iter().zip(&gauss_weights);
            terms.map(|(x, weight)| end * weight * basis(&points, l, end * x)).sum()
        };
        let integrals = points.iter().map(|&end| (0..=count).map(|l| integral(end, l)).collect()).collect();
        let rows = |of: &dyn Fn(usize, f64) -> f64| -> Vec<Vec<f64>> {
            gauss.iter().map(|&x| (0..=count).map(|l| of(l, x)).collect()).collect()
        };
        let values = rows(&|l, x| basis(&points, l, x));
        let slopes = rows(&|l, x| basis_slope(&points, l, x));
        Some(Self::of(LayerShape::Polynomial, (points, weights), (gauss_weights, values, slopes), integrals))
    }

    /// The points of `count` layers that are equal steps, between which a temperature is linear; `None` for a number
    /// that is not one of [`COUNTS`].
    pub fn linear(count: usize) -> Option<Self> {
        if !COUNTS.contains(&count) {
            return None;
        }
        let step = 1.0 / count as f64;
        let is_end = |l: usize| l == 0 || l == count;
        let points = (0..=count).map(|l| l as f64 * step).collect();
        let weights = (0..=count).map(|l| if is_end(l) { 0.5 * step } else { step }).collect();
        let rows = |left: f64, right: f64| -> Vec<Vec<f64>> {
            let at = |g: usize, l: usize| f64::from(u8::from(l == g)) * left + f64::from(u8::from(l == g + 1)) * right;
            (0..count).map(|g| (0..=count).map(|l| at(g, l)).collect()).collect()
        };
        let integral = |j: usize, l: usize| match l.cmp(&j) {
            _ if j == 0 => 0.0,
            Ordering::Less if l > 0 => step,
            Ordering::Less | Ordering::Equal => 0.5 * step,
            Ordering::Greater => 0.0,
        };
        let integrals = (0..=count).map(|j| (0..=count).map(|l| integral(j, l)).collect()).collect();
        let cells = (vec![step; count], rows(0.5, 0.5), rows(-1.0 / step, 1.0 / step));
        Some(Self::of(LayerShape::Linear, (points, weights), cells, integrals))
    }

    fn of(
        shape: LayerShape,
        (points, weights): (Vec<f64>, Vec<f64>),
        (gauss_weights, values, slopes): (Vec<f64>, Vec<Vec<f64>>, Vec<Vec<f64>>),
        integrals: Vec<Vec<f64>>,
    ) -> Self {
        let count = gauss_weights.len();
        let weighted = |j: usize, of: &dyn Fn(usize) -> f64| -> f64 {
            (0..count).map(|g| gauss_weights[g] * slopes[g][j] * of(g)).sum()
        };
        let conduction = (0..=count).map(|j| (0..=count).map(|l| weighted(j, &|g| slopes[g][l])).collect()).collect();
        let mut crossing: Vec<f64> =
            (0..count * count).map(|i| gauss_weights[i % count] * slopes[i % count][i / count]).collect();
        let _is_regular = invert(&mut crossing, count);
        let crossing = crossing.chunks_exact(count).map(<[f64]>::to_vec).collect();
        Self { shape, points, weights, gauss_weights, values, slopes, integrals, conduction, crossing }
    }

    /// Layers of this kind, and of another number.
    pub fn alike(&self, count: usize) -> Option<Self> {
        match self.shape {
            LayerShape::Polynomial => Self::new(count),
            LayerShape::Linear => Self::linear(count),
        }
    }

    /// What these layers leave open over what they differ from `other` ones of the kind: all of it for polynomials,
    /// whose error falls fast; of steps, whose error falls with the square of their number N, `1/|1 - (N/M)^2|`.
    pub fn left_open(&self, other: &Self) -> f64 {
        match self.shape {
            LayerShape::Polynomial => 1.0,
            LayerShape::Linear => 1.0 / (1.0 - (self.count() as f64 / other.count() as f64).powi(2)).abs(),
        }
    }

    /// Number of the step that holds `xi`, and the part of it below.
    pub(crate) fn step(&self, xi: f64) -> (usize, f64) {
        let at = xi * self.count() as f64;
        let left = (at as usize).min(self.count() - 1);
        (left, at - left as f64)
    }

    /// Number of layers N.
    pub fn count(&self) -> usize {
        self.points.len() - 1
    }

    /// Value at `eta` of what goes through `values` at the points.
    pub fn at(&self, values: &[f64], eta: f64) -> f64 {
        match self.shape {
            LayerShape::Polynomial => {
                values.iter().enumerate().map(|(l, value)| value * basis(&self.points, l, eta)).sum()
            }
            LayerShape::Linear => {
                let (left, share) = self.step(eta);
                values[left] + share * (values[left + 1] - values[left])
            }
        }
    }
}

/// Legendre's polynomial of a degree and its slope at `x` in -1..1, both ends excluded.
fn legendre(degree: usize, x: f64) -> (f64, f64) {
    let (mut before, mut value) = (1.0, x);
    for k in 1..degree {
        let k = k as f64;
        (before, value) = (value, ((2.0 * k + 1.0) * x * value - k * before) / (k + 1.0));
    }
    (value, degree as f64 * (before - x * value) / (1.0 - x * x))
}

/// Steps of Newton's method from a guess that is near.
const STEPS: usize = 30;

/// Gauss points and weights of 0..1.
pub(crate) fn gauss(count: usize) -> (Vec<f64>, Vec<f64>) {
    let point = |i: usize| {
        let mut x = -(std::f64::consts::PI * (i as f64 + 0.75) / (count as f64 + 0.5)).cos();
        for _ in 0..STEPS {
            let (value, slope) = legendre(count, x);
            x -= value / slope;
        }
        let (_, slope) = legendre(count, x);
        (0.5 * (1.0 + x), 1.0 / ((1.0 - x * x) * slope * slope))
    };
    (0..count).map(point).unzip()
}

/// Lobatto points and weights of 0..1: the ends, and the roots of the slope of Legendre's polynomial.
fn lobatto(count: usize) -> (Vec<f64>, Vec<f64>) {
    let n = count as f64;
    let point = |i: usize| {
        if i == 0 || i == count {
            return (if i == 0 { 0.0 } else { 1.0 }, 1.0 / (n * (n + 1.0)));
        }
        let mut x = -(std::f64::consts::PI * i as f64 / n).cos();
        for _ in 0..STEPS {
            let (value, slope) = legendre(count, x);
            let bend = (2.0 * x * slope - n * (n + 1.0) * value) / (1.0 - x * x);
            x -= slope / bend;
        }
        let (value, _) = legendre(count, x);
        (0.5 * (1.0 + x), 1.0 / (n * (n + 1.0) * value * value))
    };
    (0..=count).map(point).unzip()
}

/// The polynomial through `points` that is 1 at point `l` and 0 at the others.
pub(crate) fn basis(points: &[f64], l: usize, x: f64) -> f64 {
    let others = points.iter().enumerate().filter(|(m, _)| *m != l);
    others.map(|(_, p)| (x - p) / (points[l] - p)).product()
}

/// Slope of [`basis`].
fn basis_slope(points: &[f64], l: usize, x: f64) -> f64 {
    let without = |left_out: usize| -> f64 {
        let others = points.iter().enumerate().filter(|(m, _)| *m != l && *m != left_out);
        others.map(|(_, p)| (x - p) / (points[l] - p)).product()
    };
    (0..points.len()).filter(|m| *m != l).map(|m| without(m) / (points[l] - points[m])).sum()
}
