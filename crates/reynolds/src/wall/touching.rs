//! What the contact of rough surfaces exerts on the splines of the wall, and how that changes with the gap.
//!
//! The asperities press with `p_a(h)` on the wall beside the film: `f_j = Int p_a(h) B_j dA`, by the quadrature of [`crate::quantities::contact`]. Where the wall moves by
//! `Sum x_i B_i` the forces change by `A x`, `A_ij = Int p_a'(h) B_i B_j dA`: symmetric, of no positive entry.

use std::ops::AddAssign;

use super::grid::Grid;
use crate::quantities::contact::{each_point, gap_change};
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

/// Forces [N] on some splines of a grid.
#[derive(Debug, Default)]
struct Forces {
    splines: Vec<u32>,
    values: Vec<f64>,
}

impl Grid {
    /// Forces [N] of contact on the splines; none where no contact is simulated.
    pub fn contact_forces(&self, problem: &FilmProblem, system: &FilmSystem) -> Option<Vec<f64>> {
        let forces = each_point(problem, system, |points, pressures, sum: &mut Forces| {
            for (q, &position) in points.positions.iter().enumerate() {
                sum.add(self, position, points.area(q) * pressures[q].pressure);
            }
        });
        Some(forces?.on(self))
    }

    /// First-order change of the [`Self::contact_forces`] with a `change` of the journal or the gap.
    pub fn contact_forces_change(
        &self,
        problem: &FilmProblem,
        system: &FilmSystem,
        change: FilmChange<'_>,
    ) -> Option<Vec<f64>> {
        let forces = each_point(problem, system, |points, pressures, sum: &mut Forces| {
            let moved = gap_change(problem, change, points);
            for (q, &position) in points.positions.iter().enumerate() {
                sum.add(self, position, points.area(q) * pressures[q].slope * moved[q]);
            }
        });
        Some(forces?.on(self))
    }

    /// How the [`Self::contact_forces`] change with the deflection; none where no contact is simulated.
    pub fn contact_tangent(&self, problem: &FilmProblem, system: &FilmSystem) -> Option<ContactTangent> {
        each_point(problem, system, |points, pressures, sum: &mut ContactTangent| {
            if sum.blocks.is_empty() {
                sum.blocks.push(Block::default());
            }
            for (q, &position) in points.positions.iter().enumerate() {
                let stiffness = points.area(q) * pressures[q].slope;
                if stiffness != 0.0 {
                    sum.blocks[0].add(self, position, stiffness);
                }
            }
        })
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

impl Forces {
    fn add(&mut self, grid: &Grid, position: [f64; 2], force: f64) {
        if force == 0.0 {
            return;
        }
        grid.each_at(position, |spline, value| {
            let place = place(&mut self.splines, spline);
            if place == self.values.len() {
                self.values.push(0.0);
            }
            self.values[place] += force * value;
        });
    }

    /// On all splines of the grid.
    fn on(&self, grid: &Grid) -> Vec<f64> {
        let mut forces = vec![0.0; grid.number()];
        for (&spline, value) in self.splines.iter().zip(&self.values) {
            forces[spline as usize] += value;
        }
        forces
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

impl AddAssign for Forces {
    fn add_assign(&mut self, mut other: Self) {
        self.splines.append(&mut other.splines);
        self.values.append(&mut other.values);
    }
}
