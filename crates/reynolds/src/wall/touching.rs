//! What the contact of rough surfaces exerts on the splines of the wall, and how that changes with the gap.
//!
//! The asperities press with `p_a(h)` on the wall beside the film: `f_j = Int p_a(h) B_j dA`, by the points of
//! [`crate::quantities::contact_points`]. Where the wall moves by `Sum x_i B_i` the forces change by `A x`,
//! `A_ij = Int p_a'(h) B_i B_j dA`: symmetric, of no positive entry.

use super::grid::{SplinesAt, once_around};
use super::spline::SUPPORT;
use crate::quantities::contact_points::{ContactPoint, ContactPoints};
use crate::quantities::load::Resultant;

/// Entries of a row of A from its diagonal on: with splines 0 to 2 further around, and 0 to 2, or -2 to 2, further
/// along.
const HALF: usize = 13;

/// How the forces of contact on the splines change with the deflection: the matrix A, whose splines meet their next two
/// each way.
#[derive(Debug, Clone)]
pub struct ContactTangent {
    /// How many splines there are around and along.
    numbers: [usize; 2],
    /// Numbers of splines that are touched, and the upper half of their rows [N/m].
    rows: Vec<(usize, [f64; HALF])>,
}

impl ContactPoints {
    /// Forces [N] of contact on the splines of the wall.
    pub fn forces(&self) -> Vec<f64> {
        self.pressed(|_, point| point.area * point.pressure)
    }

    /// First-order change [N] of the [`Self::forces`] where the gap changes by `moved` [m] at each point.
    pub fn forces_change(&self, moved: &[f64]) -> Vec<f64> {
        self.pressed(|number, point| point.area * point.slope * moved[number])
    }

    /// Forces [N] on the splines by a thrust [N] at each point.
    fn pressed(&self, thrust: impl Fn(usize, &ContactPoint) -> f64) -> Vec<f64> {
        let numbers = self.splines();
        let mut forces = vec![0.0; numbers[0] * numbers[1]];
        for (number, point) in self.of_wall() {
            let thrust = thrust(number, point);
            point.splines.each(numbers, |spline, value| forces[spline] += thrust * value);
        }
        forces
    }

    /// How what contact carries changes with the coefficient of each spline: force towards x and y [N/m], and its
    /// moments [N].
    pub(crate) fn load_by_wall(&self) -> Vec<[f64; 4]> {
        let numbers = self.splines();
        let mut load = vec![[0.0; 4]; numbers[0] * numbers[1]];
        if numbers == [0; 2] {
            return load;
        }
        for (_, point) in self.of_load() {
            let Resultant { force, moment } = point.carried(point.area * point.slope);
            let parts = [force[0], force[1], moment[0], moment[1]];
            point.splines.each(numbers, |spline, value| {
                let sums = load[spline].iter_mut();
                sums.zip(parts).for_each(|(sum, part)| *sum += value * part);
            });
        }
        load
    }

    /// How the [`Self::forces`] change with the deflection.
    pub fn tangent(&self) -> ContactTangent {
        let [around, along] = self.splines();
        let mut rows = vec![[0.0; HALF]; around * along];
        for (_, point) in self.of_wall() {
            add(&mut rows, [around, along], &point.splines, point.area * point.slope);
        }
        let touched = |(_, row): &(usize, [f64; HALF])| row[0] != 0.0;
        ContactTangent { numbers: [around, along], rows: rows.into_iter().enumerate().filter(touched).collect() }
    }
}

/// Adds the products of the splines at a point, times a stiffness [N/m], to the upper halves of all rows.
fn add(rows: &mut [[f64; HALF]], [around, along]: [usize; 2], at: &SplinesAt, stiffness: f64) {
    for i in 0..SUPPORT {
        let first = once_around(at.first[0] + i, around) * along + at.first[1];
        for j in i..SUPPORT {
            let of_around = stiffness * at.around[i] * at.around[j];
            for (k, row) in rows[first..first + SUPPORT].iter_mut().enumerate() {
                for l in if i == j { k } else { 0 }..SUPPORT {
                    row[place(j - i, l + SUPPORT - k)] += of_around * at.along[k] * at.along[l];
                }
            }
        }
    }
}

/// Place in a row of the entry with the spline so much further around, and so much less three further along.
fn place(around: usize, along: usize) -> usize {
    match around {
        0 => along - SUPPORT,
        _ => (2 * SUPPORT - 1) * around + along - SUPPORT,
    }
}

impl ContactTangent {
    /// Change of the forces [N] with a deflection of these coefficients [m].
    pub fn times(&self, coefficients: &[f64]) -> Vec<f64> {
        let mut forces = vec![0.0; coefficients.len()];
        self.each(|row, column, entry| forces[row] += entry * coefficients[column]);
        forces
    }

    /// Calls `visit` with row, column and entry [N/m] of all pairs of splines that meet.
    pub fn each(&self, mut visit: impl FnMut(usize, usize, f64)) {
        let [around, along] = self.numbers;
        for (number, row) in &self.rows {
            let (i, k) = (number / along, number % along);
            for further in 0..SUPPORT {
                let first = ((i + further) % around) * along;
                let least = if further == 0 { k } else { k.saturating_sub(SUPPORT - 1) };
                for l in least..(k + SUPPORT).min(along) {
                    let entry = row[place(further, l + SUPPORT - k)];
                    visit(*number, first + l, entry);
                    if (further, l) != (0, k) {
                        visit(first + l, *number, entry);
                    }
                }
            }
        }
    }
}
