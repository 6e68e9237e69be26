//! # Compliance of the wall: from forces on splines to the coefficients of its deflection
//!
//! **Equation.** The pressure acts on the grid by the forces `f_i = Int p B_i dA`, and the wall moves by
//! `d = Sum d_i B_i`, `d = C f`, C symmetric.
//! * A wall whose slices across the axis move by themselves, `C_n` for each wave `cos(n phi)`, is projected on the
//!   splines: with the Fourier transform b of a spline, sums over the waves n + l N that the grid does not tell apart,
//!   and the mass matrices R m(n) around and M_z along, `C = g(n)/(R m(n)^2) (x) M_z^-1`, `m = Sum b^2/w`,
//!   `g = Sum C_n b^2/w`, w the width of a cell. A Winkler layer, C_n = k, is the projection of k p.
//! * A matrix of displacements for unit forces at points of a grid: splines that interpolate there carry both,
//!   `C = E^-1 A E^-T`, E their values at the points. Forces are then those equivalent to the pressure, and the
//!   displacements at the points are those of the matrix.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | C | m/N | [`Compliance::deflection`] |
//! | C_n | m/Pa | `by_wave` |
//! | A | m/N | `displacements` |
//!
//! **Source.** Projection on splines: de Boor, A Practical Guide to Splines (1978). **Range.** Linear elasticity.
//! **Verified by** `waves_are_deflected_by_their_compliance`, `a_matrix_of_a_layer_is_that_layer`.

use nalgebra::{DMatrixView, DVectorView};

use super::dense::Dense;
use super::spline::{Along, Around};

/// Waves that the grid does not tell apart are summed to this number of times its own.
const ALIASES: i64 = 6;

/// A circulant, symmetric matrix around times one along: numbers of the grid, those of one angle a column, are
/// multiplied by the one from the right and by the other from the left.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Product {
    around: Dense,
    along: Dense,
}

/// What the wall makes of forces.
#[derive(Debug, Clone, PartialEq)]
pub struct Compliance(ComplianceForm);

#[derive(Debug, Clone, PartialEq)]
enum ComplianceForm {
    /// Slices that move by themselves.
    Slices(Product),
    /// A matrix between splines that interpolate: it, and the inverse of their values at the points; transposed along.
    Matrix { displacements: Dense, interpolation: Product, transposed: Product },
}

impl Compliance {
    /// Slices of the grid that move by `by_wave(n)` [m/Pa] under a pressure `cos(n phi)`; none on a grid that is none.
    pub fn of_slices((radius, around, along): (f64, &Around, &Along), by_wave: impl Fn(usize) -> f64) -> Option<Self> {
        let number = around.number as i64;
        let symbol = |wave: i64| {
            let aliases = (-ALIASES..=ALIASES).map(|alias| wave + alias * number);
            let (mut mass, mut deflected) = (0.0, 0.0);
            for wave in aliases {
                let square = around.transform(wave as f64).powi(2) / around.width();
                mass += square;
                if square > 0.0 {
                    deflected += square * by_wave(wave.unsigned_abs() as usize);
                }
            }
            deflected / (radius * mass * mass)
        };
        Some(Self(ComplianceForm::Slices(Product {
            around: circulant(around.number, symbol),
            along: along.mass().try_inverse()?,
        })))
    }

    /// A matrix of displacements [m] for unit forces [N] at the `points` [m] along the liner of each angle of the grid,
    /// angle by angle; none where it does not fit the grid.
    pub fn of_matrix((around, along): (&Around, &Along), points: &[f64], displacements: Dense) -> Option<Self> {
        if displacements.nrows() != around.number * along.number() || points.len() != along.number() {
            return None;
        }
        let inverse = along.collocation(points).try_inverse()?;
        Some(Self(ComplianceForm::Matrix {
            displacements,
            transposed: Product::interpolation(around, inverse.transpose()),
            interpolation: Product::interpolation(around, inverse),
        }))
    }

    /// Forces [N] that make a deflection with these coefficients [m], of slices that all waves move; none of others.
    pub fn forces(&self, coefficients: &[f64]) -> Option<Vec<f64>> {
        let ComplianceForm::Slices(product) = &self.0 else { return None };
        Some(product.inverse()?.times(coefficients))
    }

    /// Entries of the compliance [m/N] between some splines.
    pub fn among(&self, splines: &[usize]) -> Dense {
        let mut among = Dense::zeros(splines.len(), splines.len());
        for (column, &pressed) in splines.iter().enumerate() {
            let by_one = self.by_one(pressed, splines);
            for (row, moved) in by_one.into_iter().enumerate() {
                among[(row, column)] = moved;
            }
        }
        among
    }

    /// How some splines move [m/N] by a force on one.
    fn by_one(&self, pressed: usize, splines: &[usize]) -> Vec<f64> {
        match &self.0 {
            ComplianceForm::Slices(product) => splines.iter().map(|&spline| product.at(spline, pressed)).collect(),
            ComplianceForm::Matrix { displacements, .. } => {
                let mut force = vec![0.0; displacements.nrows()];
                force[pressed] = 1.0;
                let moved = self.deflection(&force);
                splines.iter().map(|&spline| moved[spline]).collect()
            }
        }
    }

    /// Coefficients [m] of the deflection by forces [N].
    pub fn deflection(&self, forces: &[f64]) -> Vec<f64> {
        match &self.0 {
            ComplianceForm::Slices(product) => product.times(forces),
            ComplianceForm::Matrix { displacements, interpolation, transposed } => {
                let at_points = transposed.times(forces);
                let moved = displacements * DVectorView::from_slice(&at_points, at_points.len());
                interpolation.times(moved.as_slice())
            }
        }
    }
}

impl Product {
    /// What makes coefficients of values at the middles of splines around, and by the inverse `along` of their values
    /// along.
    pub(super) fn interpolation(around: &Around, along: Dense) -> Self {
        // Values at the middles: 1/8, 3/4, 1/8.
        let value = |wave: i64| 0.75 + 0.25 * (wave as f64 * around.width()).cos();
        Self { around: circulant(around.number, |wave| 1.0 / value(wave)), along }
    }

    /// Inverse of the product; none where it is singular.
    fn inverse(&self) -> Option<Self> {
        let number = self.around.nrows();
        let turn = std::f64::consts::TAU / number as f64;
        let symbol = |wave: i64| {
            let cos = |k: usize| (turn * ((wave as usize * k) % number) as f64).cos();
            let parts = self.around.column(0).into_iter().enumerate();
            parts.map(|(k, entry)| entry * cos(k)).sum::<f64>()
        };
        let symbols: Vec<f64> = (0..number as i64).map(symbol).collect();
        symbols.iter().all(|symbol| *symbol > 0.0).then_some(())?;
        Some(Self {
            around: circulant(number, |wave| 1.0 / symbols[wave as usize]),
            along: self.along.clone().try_inverse()?,
        })
    }

    /// An entry.
    fn at(&self, row: usize, column: usize) -> f64 {
        let along = self.along.nrows();
        self.around[(row / along, column / along)] * self.along[(row % along, column % along)]
    }

    pub(super) fn times(&self, x: &[f64]) -> Vec<f64> {
        let (number, along) = (self.around.nrows(), self.along.nrows());
        let product = &self.along * DMatrixView::from_slice(x, along, number) * &self.around;
        product.data.into()
    }
}

/// The circulant matrix with this even symbol.
fn circulant(number: usize, symbol: impl Fn(i64) -> f64) -> Dense {
    let symbols: Vec<f64> = (0..number as i64).map(symbol).collect();
    let turn = std::f64::consts::TAU / number as f64;
    let entry = |k: usize| {
        let parts = symbols.iter().enumerate().map(|(n, s)| s * (turn * ((n * k) % number) as f64).cos());
        parts.sum::<f64>() / number as f64
    };
    let first: Vec<f64> = (0..number).map(entry).collect();
    Dense::from_fn(number, number, |row, column| first[(row + number - column) % number])
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    const RADIUS: f64 = 0.05;

    /// Forces of `cos(n phi)` on splines around, along those of a constant.
    fn forces(around: &Around, along: &Along, n: usize) -> Vec<f64> {
        let axial = along.mass().column_sum();
        let wave = |j: usize| RADIUS * around.transform(n as f64) * (n as f64 * around.middle(j)).cos();
        (0..around.number).flat_map(|j| axial.iter().map(move |part| part * wave(j))).collect()
    }

    /// Value of a spline with these coefficients.
    fn value(around: &Around, along: &Along, coefficients: &[f64], angle: f64, z: f64) -> f64 {
        let (a, b) = (around.at(angle), along.at(z));
        let term = |(i, k): (usize, usize)| {
            let place = ((a.first + i) % around.number) * along.number() + b.first + k;
            a.values[i] * b.values[k] * coefficients[place]
        };
        (0..9).map(|m| term((m / 3, m % 3))).sum()
    }

    #[test]
    fn waves_are_deflected_by_their_compliance() {
        let (around, along) = (Around::centred(96, 0.0), Along::on_breaks(&[-0.02, -0.01, 0.0, 0.01, 0.02]));
        let by_wave = |n: usize| 1e-14 / (1.0 + n as f64);
        let compliance = Compliance::of_slices((RADIUS, &around, &along), by_wave).expect("a grid");
        for n in 0..=12 {
            let found = compliance.deflection(&forces(&around, &along, n));
            for angle in [0.1, 1.7, 4.4] {
                let wanted = by_wave(n) * (n as f64 * angle).cos();
                let off = (value(&around, &along, &found, angle, 0.003) - wanted).abs() / by_wave(n);
                // Splines have the wave to the third power of the width of a cell.
                assert!(off < 0.2 * (n as f64 * around.width()).powi(3) + 1e-12, "{n} {angle}: {off:e}");
            }
        }
    }

    #[test]
    fn compliances_are_symmetric() {
        let (around, along) = (Around::centred(16, 0.2), Along::on_breaks(&[-0.02, -0.005, 0.01, 0.02]));
        let n = around.number * along.number();
        let compliance =
            Compliance::of_slices((RADIUS, &around, &along), |n| 1e-14 / (1.0 + n as f64)).expect("a grid");
        let unit = |k: usize| (0..n).map(|i| if i == k { 1.0 } else { 0.0 }).collect::<Vec<f64>>();
        let columns: Vec<Vec<f64>> = (0..n).map(|k| compliance.deflection(&unit(k))).collect();
        let greatest = columns.iter().flatten().fold(0.0f64, |most, c| most.max(c.abs()));
        for i in 0..n {
            assert!(columns[i][i] > 0.0);
            for j in 0..i {
                assert!((columns[i][j] - columns[j][i]).abs() < 1e-13 * greatest);
            }
        }
    }

    /// Unit forces on cells of a layer, as a structural program has it: the layer, and the better the finer the grid.
    #[test]
    fn a_matrix_of_a_layer_is_that_layer() {
        let mut before = f64::INFINITY;
        for number in [24usize, 48, 96] {
            let (around, points) = (Around::centred(number, 0.0), [-0.018, -0.01, 0.0, 0.01, 0.018]);
            let along = Along::through(&points, [-0.02, 0.02]);
            let inverse = along.collocation(&points).try_inverse().expect("points").transpose();
            let lengths = inverse * along.mass().column_sum();
            let mut layer = Dense::zeros(number * points.len(), number * points.len());
            for place in 0..layer.nrows() {
                layer[(place, place)] = 1e-14 / (RADIUS * TAU / number as f64 * lengths[place % points.len()]);
            }
            let compliance = Compliance::of_matrix((&around, &along), &points, layer).expect("it fits");
            let found = compliance.deflection(&forces(&around, &along, 5));
            let off = [0.1, 1.7, 4.4].map(|angle: f64| {
                let wanted = 1e-14 * (5.0 * angle).cos();
                (value(&around, &along, &found, angle, 0.003) - wanted).abs() / 1e-14
            });
            let off = off.into_iter().fold(0.0, f64::max);
            assert!(off < 0.3 * before, "{number}: {off:e}");
            before = off;
        }
        assert!(before < 1e-3, "{before:e}");
    }
}
