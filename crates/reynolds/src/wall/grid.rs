//! The grid of the wall: products of splines around and along the developed surface.

use super::compliance::Product;
use super::spline::{Along, Around, Local, SUPPORT};
use crate::{FilmPoint, FilmProblem, FilmSystem};

/// What of a spline is meant.
#[derive(Debug, Clone, Copy)]
pub(super) enum SplinePart {
    /// The value of the splines.
    Value,
    /// The slope of the splines around the liner [1/m].
    SlopeAround,
    /// The slope of the splines along the liner [1/m].
    SlopeAlong,
}

/// Splines on the developed surface; number `j along.number() + k` is the product of number j around and number k
/// along.
#[derive(Debug, Clone, PartialEq)]
pub struct Grid {
    /// Radius R of the liner [m].
    pub radius: f64,
    /// Splines around the liner.
    pub around: Around,
    /// Splines along the liner.
    pub along: Along,
}

/// The splines that are not zero at a position: first ones around and along, and values of these and the next two.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct SplinesAt {
    pub(super) first: [usize; 2],
    pub(super) around: [f64; SUPPORT],
    pub(super) along: [f64; SUPPORT],
}

impl SplinesAt {
    /// Calls `visit` with number and value of each, of so many around and along.
    #[inline]
    pub(crate) fn each(&self, [around, along]: [usize; 2], mut visit: impl FnMut(usize, f64)) {
        for (i, of_around) in self.around.into_iter().enumerate() {
            let first = once_around(self.first[0] + i, around) * along + self.first[1];
            for (k, of_along) in self.along.into_iter().enumerate() {
                visit(first + k, of_around * of_along);
            }
        }
    }

    /// Value there of the function with these coefficients, of so many splines around and along.
    #[inline]
    pub(crate) fn value(&self, numbers: [usize; 2], coefficients: &[f64]) -> f64 {
        let mut sum = 0.0;
        self.each(numbers, |spline, value| sum += value * coefficients[spline]);
        sum
    }
}

/// A number of a spline around the liner, counted on from the last to the first: numbers go once around at most.
#[inline]
pub(super) fn once_around(number: usize, splines: usize) -> usize {
    match number < splines {
        true => number,
        false => number - splines,
    }
}

impl Grid {
    /// The splines at a position [m].
    pub(crate) fn splines_at(&self, position: [f64; 2]) -> SplinesAt {
        let [around, along] = self.at(position);
        SplinesAt { first: [around.first, along.first], around: around.values, along: along.values }
    }

    /// How many splines there are around and along.
    pub(crate) fn numbers(&self) -> [usize; 2] {
        [self.around.number, self.along.number()]
    }

    /// How many splines there are.
    pub fn number(&self) -> usize {
        self.around.number * self.along.number()
    }

    /// The splines at a position [m] of the developed surface.
    fn at(&self, [x, z]: [f64; 2]) -> [Local; 2] {
        [self.around.at(x / self.radius), self.along.at(z)]
    }

    /// Number of a spline of two local ones.
    #[inline]
    fn index(&self, around: usize, along: usize) -> usize {
        once_around(around, self.around.number) * self.along.number() + along
    }

    /// Value at a position [m] of the function with these coefficients.
    pub fn value(&self, coefficients: &[f64], position: [f64; 2]) -> f64 {
        let mut point = [FilmPoint::default()];
        self.add(coefficients, &[position], &mut point);
        point[0].thickness
    }

    /// Coefficients of the function that interpolates another one in the middle of each spline; none where the splines
    /// are no grid.
    pub fn interpolated(&self, function: impl Fn([f64; 2]) -> f64) -> Option<Vec<f64>> {
        let points = self.along.middles();
        let middle = |j: usize| self.radius * self.around.middle(j);
        let values = (0..self.around.number).flat_map(|j| points.iter().map(move |&z| [middle(j), z]));
        let values: Vec<f64> = values.map(function).collect();
        Some(Product::interpolation(&self.around, self.along.collocation(&points).try_inverse()?).times(&values))
    }

    /// Adds the function with these coefficients [m] to the gap at `positions` [m].
    pub(crate) fn add(&self, coefficients: &[f64], positions: &[[f64; 2]], film: &mut [FilmPoint]) {
        for (&position, point) in positions.iter().zip(film) {
            let [around, along] = self.at(position);
            for i in 0..SUPPORT {
                let first = self.index(around.first + i, along.first);
                let row = &coefficients[first..first + SUPPORT];
                let value: f64 = row.iter().zip(along.values).map(|(c, v)| c * v).sum();
                let slope: f64 = row.iter().zip(along.slopes).map(|(c, v)| c * v).sum();
                point.thickness += around.values[i] * value;
                point.slope[0] += around.slopes[i] * value / self.radius;
                point.slope[1] += around.values[i] * slope;
            }
        }
    }

    /// Adds the function with these coefficients [m/s] to the rate of the gap at `positions` [m].
    pub(crate) fn add_rate(&self, coefficients: &[f64], positions: &[[f64; 2]], film: &mut [FilmPoint]) {
        for (&position, point) in positions.iter().zip(film) {
            self.each_at(position, |spline, value| point.rate += value * coefficients[spline]);
        }
    }

    /// Forces [N] of the pressure of a film on the splines; regions cut out of the mesh press on nothing.
    pub fn forces(&self, problem: &FilmProblem, system: &FilmSystem, unknown: &[f64]) -> Vec<f64> {
        let pressures: Vec<f64> = unknown.iter().map(|&u| problem.pressure_at(u)).collect();
        system.pressing(self).forces(system.space(), &pressures)
    }

    /// First-order change of the [`Self::forces`] where the unknown changes by `change` at each dof.
    pub fn forces_change(
        &self,
        problem: &FilmProblem,
        system: &FilmSystem,
        unknown: &[f64],
        change: &[f64],
    ) -> Vec<f64> {
        let changes = unknown.iter().zip(change).map(|(&u, change)| problem.pressure_slope_at(u) * change);
        system.pressing(self).forces(system.space(), &changes.collect::<Vec<f64>>())
    }

    /// The transposed product of [`Self::forces_change`] with a number for each spline: how the sum of these times the
    /// forces changes with the unknown at each dof.
    pub fn weights(&self, problem: &FilmProblem, system: &FilmSystem, unknown: &[f64], of_splines: &[f64]) -> Vec<f64> {
        let integrals = system.pressing(self).integrals(system.space(), of_splines);
        let weights = unknown.iter().zip(integrals);
        weights.map(|(&u, integral)| problem.pressure_slope_at(u) * integral).collect()
    }

    /// Calls `visit` with the number and the value of each spline that is not zero at a position [m].
    #[inline]
    pub(super) fn each_at(&self, position: [f64; 2], visit: impl FnMut(usize, f64)) {
        self.each_part_at(SplinePart::Value, position, visit);
    }

    /// Visits each spline at a position as [`Self::each_at`] does, with the value or a slope [1/m] of the splines.
    #[inline]
    pub(super) fn each_part_at(&self, part: SplinePart, position: [f64; 2], mut visit: impl FnMut(usize, f64)) {
        let [around, along] = self.at(position);
        let (around_parts, along_parts) = match part {
            SplinePart::Value => (around.values, along.values),
            SplinePart::SlopeAround => (around.slopes.map(|slope| slope / self.radius), along.values),
            SplinePart::SlopeAlong => (around.values, along.slopes),
        };
        for (i, of_around) in around_parts.into_iter().enumerate() {
            let first = self.index(around.first + i, along.first);
            for (k, of_along) in along_parts.into_iter().enumerate() {
                visit(first + k, of_around * of_along);
            }
        }
    }

    /// Width and least length [m] of its cells between two axial positions [m].
    pub(super) fn cell(&self, [low, high]: [f64; 2]) -> [f64; 2] {
        let cells = self.along.breaks().windows(2);
        let there = cells.filter(|pair| pair[1] > low && pair[0] < high);
        let least = there.map(|pair| pair[1] - pair[0]).fold(f64::INFINITY, f64::min);
        [self.radius * self.around.width(), least]
    }
}
