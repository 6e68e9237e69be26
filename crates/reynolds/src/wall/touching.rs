//! What the contact of rough surfaces exerts on the splines of the wall, and how that changes with the gap.
//!
//! The asperities press with `p_a(h)` on the wall beside the film: `f_j = Int p_a(h) B_j dA`, by the quadrature of [`crate::quantities::contact`]. Where the wall moves by
//! `Sum x_i B_i` the forces change by `A x`, `A_ij = Int p_a'(h) B_i B_j dA`: symmetric, of no positive entry.

use std::ops::AddAssign;

use oilwedge_fem::integrate::Points;
use oilwedge_fem::quadrature::MOST_POINTS;

use super::grid::Grid;
use super::pressing::quarterings;
use crate::angles::sines_and_cosines;
use crate::contact::ContactPressure;
use crate::quantities::contact::{by_contact, each_point, gap_change};
use crate::{FilmChange, FilmProblem, FilmSystem};

/// How the forces of contact on the splines change with the deflection: the matrix A, triangle by triangle.
#[derive(Debug, Clone, Default)]
pub struct ContactTangent {
    blocks: Vec<Block>,
}

/// What the points of one triangle add to the splines that are not zero there.
#[derive(Debug, Clone, Default)]
struct Block {
    splines: Vec<u32>,
    /// Row k of the lower half: entries with the splines 0 to k [N/m].
    rows: Vec<Vec<f64>>,
}

/// What contact presses with at the points of a batch.
type Pressures = [ContactPressure; MOST_POINTS];

/// N sums on some splines of a grid.
#[derive(Debug, Default)]
struct OnSplines<const N: usize> {
    splines: Vec<u32>,
    values: Vec<[f64; N]>,
}

impl Grid {
    /// How often triangles are quartered so that their parts are no wider than the cells.
    fn by_cells(&self) -> impl Fn(&[[f64; 2]; 3]) -> usize + Sync + '_ {
        |corners| quarterings(self, corners)
    }

    /// Forces [N] of contact on the splines; none where no contact is simulated.
    pub fn contact_forces(&self, problem: &FilmProblem, system: &FilmSystem) -> Option<Vec<f64>> {
        let add = |points: &Points<'_>, pressures: Pressures, sum: &mut OnSplines<1>| {
            for (q, &position) in points.positions.iter().enumerate() {
                sum.add(self, position, [points.area(q) * pressures[q].pressure]);
            }
        };
        let forces = each_point(problem, system, self.by_cells(), add)?;
        Some(forces.on(self).into_flattened())
    }

    /// First-order change of the [`Self::contact_forces`] with a `change` of the journal or the gap.
    pub fn contact_forces_change(
        &self,
        problem: &FilmProblem,
        system: &FilmSystem,
        change: FilmChange<'_>,
    ) -> Option<Vec<f64>> {
        let add = |points: &Points<'_>, pressures: Pressures, sum: &mut OnSplines<1>| {
            let moved = gap_change(problem, change, points);
            for (q, &position) in points.positions.iter().enumerate() {
                sum.add(self, position, [points.area(q) * pressures[q].slope * moved[q]]);
            }
        };
        let forces = each_point(problem, system, self.by_cells(), add)?;
        Some(forces.on(self).into_flattened())
    }

    /// How what contact carries changes with the coefficient of each spline: force towards x and y [N/m], and its moments [N]; none where no contact is simulated.
    pub(crate) fn contact_load(&self, problem: &FilmProblem, system: &FilmSystem) -> Option<Vec<[f64; 4]>> {
        let add = |points: &Points<'_>, pressures: Pressures, sum: &mut OnSplines<4>| {
            let [sines, cosines] = sines_and_cosines(points.positions, problem.bearing.radius);
            for (q, &position) in points.positions.iter().enumerate() {
                let stiffness = points.area(q) * pressures[q].slope;
                let [x, y] = [stiffness * cosines[q], stiffness * sines[q]];
                sum.add(self, position, [x, y, position[1] * x, position[1] * y]);
            }
        };
        Some(each_point(problem, system, by_contact, add)?.on(self))
    }

    /// How the [`Self::contact_forces`] change with the deflection; none where no contact is simulated.
    pub fn contact_tangent(&self, problem: &FilmProblem, system: &FilmSystem) -> Option<ContactTangent> {
        each_point(
            problem,
            system,
            self.by_cells(),
            |points, pressures, sum: &mut ContactTangent| {
                if sum.blocks.is_empty() {
                    sum.blocks.push(Block::default());
                }
                for (q, &position) in points.positions.iter().enumerate() {
                    let stiffness = points.area(q) * pressures[q].slope;
                    if stiffness != 0.0 {
                        sum.blocks[0].add(self, position, stiffness);
                    }
                }
            },
        )
    }
}

impl ContactTangent {
    /// Change of the forces [N] with a deflection of these coefficients [m].
    pub fn times(&self, coefficients: &[f64]) -> Vec<f64> {
        let mut forces = vec![0.0; coefficients.len()];
        self.each(|row, column, entry| forces[row] += entry * coefficients[column]);
        forces
    }

    /// Calls `visit` with row, column and a part of the entry [N/m] there, each entry in as many parts as triangles add to it.
    pub fn each(&self, mut visit: impl FnMut(usize, usize, f64)) {
        for Block { splines, rows } in &self.blocks {
            for (k, row) in rows.iter().enumerate() {
                let here = splines[k] as usize;
                for (&entry, &other) in row.iter().zip(splines) {
                    let other = other as usize;
                    visit(here, other, entry);
                    if other != here {
                        visit(other, here, entry);
                    }
                }
            }
        }
    }
}

impl Block {
    fn add(&mut self, grid: &Grid, position: [f64; 2], stiffness: f64) {
        let mut here = Vec::with_capacity(9);
        grid.each_at(position, |spline, value| {
            let place = place(&mut self.splines, spline);
            if place == self.rows.len() {
                self.rows.push(vec![0.0; place + 1]);
            }
            here.push((place, value));
        });
        for &(i, value) in &here {
            for &(j, other) in here.iter().filter(|(j, _)| *j <= i) {
                self.rows[i][j] += stiffness * value * other;
            }
        }
    }
}

impl<const N: usize> OnSplines<N> {
    /// Adds parts of a point, in proportion to the splines there.
    fn add(&mut self, grid: &Grid, position: [f64; 2], parts: [f64; N]) {
        if parts.iter().all(|part| *part == 0.0) {
            return;
        }
        grid.each_at(position, |spline, value| {
            let place = place(&mut self.splines, spline);
            if place == self.values.len() {
                self.values.push([0.0; N]);
            }
            let sums = &mut self.values[place];
            sums.iter_mut().zip(parts).for_each(|(sum, part)| *sum += part * value);
        });
    }

    /// On all splines of the grid.
    fn on(&self, grid: &Grid) -> Vec<[f64; N]> {
        let mut all = vec![[0.0; N]; grid.number()];
        for (&spline, values) in self.splines.iter().zip(&self.values) {
            let sums = &mut all[spline as usize];
            sums.iter_mut().zip(values).for_each(|(sum, value)| *sum += value);
        }
        all
    }
}

/// Where a spline stands in a list, at its end where it is new; a triangle knows few splines.
fn place(splines: &mut Vec<u32>, spline: usize) -> usize {
    let spline = spline as u32;
    splines.iter().position(|&other| other == spline).unwrap_or_else(|| {
        splines.push(spline);
        splines.len() - 1
    })
}

impl AddAssign for ContactTangent {
    fn add_assign(&mut self, mut other: Self) {
        self.blocks.append(&mut other.blocks);
    }
}

impl<const N: usize> AddAssign for OnSplines<N> {
    fn add_assign(&mut self, mut other: Self) {
        self.splines.append(&mut other.splines);
        self.values.append(&mut other.values);
    }
}
