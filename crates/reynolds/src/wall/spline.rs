//! Quadratic B-splines on a line: values, slopes and mass matrices.
//!
//! Around the liner they are uniform and periodic; along it they have knots of their own. Both are continuously
//! differentiable, so that the slope of a deflection has no jumps inside of triangles. Source: de Boor, A Practical
//! Guide to Splines (1978), ch. IX and X.

use super::dense::Dense;

/// Splines that are not zero at one place.
pub(super) const SUPPORT: usize = 3;

/// The splines that are not zero at a place: the first of them, their values and their derivatives.
#[derive(Debug, Clone, Copy)]
pub(super) struct Local {
    pub(super) first: usize,
    pub(super) values: [f64; SUPPORT],
    pub(super) slopes: [f64; SUPPORT],
}

/// Uniform splines around a circle: number j stands on `start + j width .. start + (j + 3) width`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Around {
    /// How many there are.
    pub number: usize,
    /// Angle at which the first spline begins [rad].
    pub start: f64,
}

impl Around {
    /// The splines whose cells are centred at `number` equally spaced angles from `first` [rad] on.
    pub fn centred(number: usize, first: f64) -> Self {
        let width = std::f64::consts::TAU / number as f64;
        Self { number, start: first - 1.5 * width }
    }

    /// The middle [rad] of a spline.
    pub(super) fn middle(&self, number: usize) -> f64 {
        self.start + (number as f64 + 1.5) * self.width()
    }

    /// Width of a cell [rad].
    pub fn width(&self) -> f64 {
        std::f64::consts::TAU / self.number as f64
    }

    /// Splines at an angle [rad]; slopes by radian. Numbers from `first` on count modulo the number of splines.
    #[inline]
    pub(super) fn at(&self, angle: f64) -> Local {
        let per_width = self.number as f64 / std::f64::consts::TAU;
        let turns = (angle - self.start) / std::f64::consts::TAU;
        let place = (turns - turns.floor()) * self.number as f64;
        let cell = (place as usize).min(self.number - 1);
        let t = place - cell as f64;
        Local {
            // The spline before the last begins two cells earlier.
            first: cell + self.number - 2,
            values: [0.5 * (1.0 - t) * (1.0 - t), 0.5 + t * (1.0 - t), 0.5 * t * t],
            slopes: [-(1.0 - t) * per_width, (1.0 - 2.0 * t) * per_width, t * per_width],
        }
    }

    /// Fourier transform [rad] of a spline at the wave number `n`, but for its phase.
    pub(super) fn transform(&self, n: f64) -> f64 {
        let half = 0.5 * n * self.width();
        let ratio = if half == 0.0 { 1.0 } else { half.sin() / half };
        self.width() * ratio.powi(3)
    }
}

/// Splines along the liner on `knots` [m], the outer ones threefold.
#[derive(Debug, Clone, PartialEq)]
pub struct Along {
    knots: Vec<f64>,
    /// The cell between two knots in which each of equally long parts of the liner begins.
    cells: Vec<usize>,
    /// Parts by metre.
    per_part: f64,
    /// One over the length of each cell, and one over those of the two pairs of cells that it is in [1/m]; it is
    /// numbered as the knot before it.
    inverse: Vec<[f64; SUPPORT]>,
}

/// Parts of the liner in which its cells are looked up, for each of them.
const PARTS: usize = 4;

impl Along {
    /// The splines on these growing breaks [m], the ends of the liner first and last.
    pub fn on_breaks(breaks: &[f64]) -> Self {
        let (Some(&low), Some(&high)) = (breaks.first(), breaks.last()) else {
            return Self::on_knots(vec![0.0; 2 * SUPPORT]);
        };
        let knots = [low; SUPPORT - 1].into_iter().chain(breaks.iter().copied()).chain([high; SUPPORT - 1]);
        Self::on_knots(knots.collect())
    }

    fn on_knots(knots: Vec<f64>) -> Self {
        let last = knots.len() - SUPPORT - 1;
        let inverse = |from: usize, to: usize| 1.0 / (knots[to] - knots[from]);
        let inverse = (0..=last)
            .map(|cell| match cell < SUPPORT - 1 {
                true => [0.0; SUPPORT],
                false => [inverse(cell, cell + 1), inverse(cell - 1, cell + 1), inverse(cell, cell + 2)],
            })
            .collect();
        let (low, high) = (knots[0], knots[knots.len() - 1]);
        let parts = PARTS * (last + 1);
        let cell_at = |z: f64| (knots.partition_point(|&knot| knot <= z).max(SUPPORT) - 1).min(last);
        Self {
            cells: (0..parts).map(|part| cell_at(low + (high - low) * part as f64 / parts as f64)).collect(),
            per_part: parts as f64 / (high - low),
            inverse,
            knots,
        }
    }

    /// Number of the cell at an axial position [m] of the liner.
    #[inline]
    fn cell(&self, z: f64) -> usize {
        let part = ((z - self.knots[0]) * self.per_part) as usize;
        let mut cell = self.cells[part.min(self.cells.len() - 1)];
        while cell + 1 < self.inverse.len() && self.knots[cell + 1] <= z {
            cell += 1;
        }
        // By rounding a place just before a knot may be in the part after it.
        while cell >= SUPPORT && self.knots[cell] > z {
            cell -= 1;
        }
        cell
    }

    /// The splines that interpolate at at least three growing `points` [m] of a liner between its `ends` [m].
    pub fn through(points: &[f64], [low, high]: [f64; 2]) -> Self {
        let inner = points[1..points.len() - 1].windows(2).map(|pair| 0.5 * (pair[0] + pair[1]));
        let breaks: Vec<f64> = std::iter::once(low).chain(inner).chain(Some(high)).collect();
        Self::on_breaks(&breaks)
    }

    /// How many there are.
    pub fn number(&self) -> usize {
        self.knots.len() - SUPPORT
    }

    /// The middle [m] of each spline: a point at which functions are interpolated.
    pub(super) fn middles(&self) -> Vec<f64> {
        let middle = |k: usize| 0.5 * (self.knots[k + 1] + self.knots[k + 2]);
        (0..self.number()).map(middle).collect()
    }

    /// Breaks [m]: the knots, each once.
    pub(super) fn breaks(&self) -> &[f64] {
        &self.knots[SUPPORT - 1..=self.number()]
    }

    /// Splines at an axial position [m], that of the nearer end outside of the liner; slopes by metre.
    #[inline]
    pub(super) fn at(&self, z: f64) -> Local {
        let (knots, cell) = (&self.knots, self.cell(z));
        let z = z.clamp(knots[cell], knots[cell + 1]);
        let (left, right) = (|k: usize| z - knots[cell + 1 - k], |k: usize| knots[cell + k] - z);
        let [length, before, after] = self.inverse[cell];
        let [low, high] = [right(1) * length, left(1) * length];
        Local {
            first: cell - (SUPPORT - 1),
            values: [low * right(1) * before, low * left(2) * before + high * right(2) * after, high * left(1) * after],
            slopes: [-2.0 * low * before, 2.0 * (low * before - high * after), 2.0 * high * after],
        }
    }

    /// Integrals [m] of the products of all pairs.
    pub(super) fn mass(&self) -> Dense {
        // Gauss's rule of three points integrates their products, of degree four.
        const POINTS: [(f64, f64); 3] =
            [(-0.774_596_669_241_483_4, 5.0 / 9.0), (0.0, 8.0 / 9.0), (0.774_596_669_241_483_4, 5.0 / 9.0)];
        let mut mass = Dense::zeros(self.number(), self.number());
        for cell in self.breaks().windows(2) {
            let (middle, half) = (0.5 * (cell[0] + cell[1]), 0.5 * (cell[1] - cell[0]));
            for (place, weight) in POINTS {
                let local = self.at(middle + half * place);
                for (i, a) in local.values.iter().enumerate() {
                    for (j, b) in local.values.iter().enumerate() {
                        mass[(local.first + i, local.first + j)] += half * weight * a * b;
                    }
                }
            }
        }
        mass
    }

    /// Values of all splines at these positions [m], one row a position.
    pub(super) fn collocation(&self, points: &[f64]) -> Dense {
        let mut values = Dense::zeros(points.len(), self.number());
        for (row, &z) in points.iter().enumerate() {
            let local = self.at(z);
            for (k, value) in local.values.into_iter().enumerate() {
                values[(row, local.first + k)] = value;
            }
        }
        values
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::DVector;

    use super::*;

    #[test]
    fn splines_sum_to_one_and_slopes_are_those_of_the_values() {
        let around = Around::centred(7, 0.3);
        let along = Along::on_breaks(&[-0.02, -0.015, 0.0, 0.004, 0.02]);
        assert_eq!(along.number(), 6);
        for k in 0..40 {
            let (angle, z) = (-9.0 + 0.437 * f64::from(k), -0.0199 + 0.00099 * f64::from(k));
            for (local, slope_of_sum) in [(around.at(angle), 0.0), (along.at(z), 0.0)] {
                assert!((local.values.iter().sum::<f64>() - 1.0).abs() < 1e-14);
                assert!((local.slopes.iter().sum::<f64>() - slope_of_sum).abs() < 1e-9);
            }
            let step = 1e-7;
            let differences = |low: Local, high: Local, by: f64, at: Local| {
                if low.first == high.first {
                    for k in 0..SUPPORT {
                        let slope = (high.values[k] - low.values[k]) / by;
                        assert!((slope - at.slopes[k]).abs() < 1e-6 * (1.0 + slope.abs()), "{slope} {at:?}");
                    }
                }
            };
            differences(around.at(angle - step), around.at(angle + step), 2.0 * step, around.at(angle));
            differences(along.at(z - 1e-8), along.at(z + 1e-8), 2e-8, along.at(z));
        }
    }

    /// A quadratic is among the splines: it is found again from its values at the points that they interpolate.
    #[test]
    fn interpolation_gives_quadratics_back() {
        let points = [-0.018, -0.01, -0.004, 0.003, 0.012, 0.019];
        let along = Along::through(&points, [-0.02, 0.02]);
        assert_eq!(along.number(), points.len());
        let quadratic = |z: f64| 3.0 - 40.0 * z + 5000.0 * z * z;
        let inverse = along.collocation(&points).try_inverse().expect("points inside of their splines");
        let coefficients = inverse * DVector::from_iterator(6, points.map(quadratic));
        for z in [-0.02, -0.013, 0.0, 0.0077, 0.02] {
            let local = along.at(z);
            let value: f64 = (0..SUPPORT).map(|k| coefficients[local.first + k] * local.values[k]).sum();
            assert!((value - quadratic(z)).abs() < 1e-12, "{z}");
        }
    }

    #[test]
    fn masses_sum_to_the_length() {
        let along = Along::on_breaks(&[-0.02, -0.015, 0.0, 0.004, 0.02]);
        let mass = along.mass();
        let sums = mass.column_sum();
        assert!((sums.sum() - 0.04).abs() < 1e-16);
        // Inverse and matrix.
        let back = mass.try_inverse().expect("definite") * sums;
        assert!(back.iter().all(|one| (one - 1.0).abs() < 1e-11), "{back:?}");
    }
}
