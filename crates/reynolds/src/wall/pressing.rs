//! What a pressure of finite elements exerts on the splines of the wall: a sparse matrix of a mesh and a grid.
//!
//! The pressure is interpolated at the nodes, `p = Sum p_i N_i`, so that `f_j = Sum_i p_i Int N_i B_j dA`, linear in the pressures, and to first order in the
//! unknown too.

use std::ops::AddAssign;

use oilwedge_fem::integrate::{Points, Rule};
use oilwedge_fem::{Quadrature, Space, integrate};

use super::grid::Grid;

/// Most times that triangles are quartered which are wider than the cells of the grid.
const MOST_QUARTERINGS: usize = 4;

/// Integrals of the products of shape functions and splines, triangle by triangle.
#[derive(Debug, Clone)]
pub(crate) struct Pressing {
    grid: Grid,
    blocks: Blocks,
}

/// For each triangle its splines, and for each of these the integrals with all shape functions.
#[derive(Debug, Clone, Default)]
struct Blocks {
    /// Where the splines of each triangle end.
    ends: Vec<usize>,
    splines: Vec<u32>,
    /// [m2], all shapes of one spline after those of the one before.
    integrals: Vec<f64>,
}

impl Pressing {
    /// Of a space on a grid.
    pub(crate) fn new(space: &Space, grid: &Grid) -> Self {
        let (mesh, degree) = (space.mesh(), space.degree());
        let rule = |levels: usize| Rule::new(Quadrature::for_degree(degree).quartered(levels), degree);
        let rules: Vec<Rule> = (0..=MOST_QUARTERINGS).map(rule).collect();
        let blocks = integrate(mesh, |t| {
            let levels = quarterings(grid, &mesh.corners(t));
            let mut block: Blocks = rules[levels].integrate(mesh, t, |points, block: &mut Blocks| {
                block.add(grid, points, space.shapes());
            });
            block.ends.push(block.splines.len());
            block
        });
        Self {
            grid: grid.clone(),
            blocks,
        }
    }

    /// Whether it is that of a grid.
    pub(crate) fn is_on(&self, grid: &Grid) -> bool {
        self.grid == *grid
    }

    /// Forces [N] on the splines by pressures [Pa] at the dofs of the space.
    pub(crate) fn forces(&self, space: &Space, pressures: &[f64]) -> Vec<f64> {
        let (shapes, mut begin) = (space.shapes(), 0);
        let mut forces = vec![0.0; self.grid.number()];
        for (t, &end) in self.blocks.ends.iter().enumerate() {
            let dofs = &space.element_dofs(t)[..shapes];
            for k in begin..end {
                let integrals = &self.blocks.integrals[k * shapes..(k + 1) * shapes];
                let force: f64 = integrals
                    .iter()
                    .zip(dofs)
                    .map(|(part, &dof)| part * pressures[dof])
                    .sum();
                forces[self.blocks.splines[k] as usize] += force;
            }
            begin = end;
        }
        forces
    }
}

impl Blocks {
    /// Adds the products at points of one triangle.
    fn add(&mut self, grid: &Grid, points: &Points<'_>, shapes: usize) {
        for (q, &position) in points.positions.iter().enumerate() {
            let (area, values) = (points.area(q), points.shapes(q));
            grid.each_at(position, |spline, value| {
                // A triangle knows few splines.
                let place = self.splines.iter().position(|&other| other == spline as u32);
                let place = place.unwrap_or_else(|| {
                    self.splines.push(spline as u32);
                    self.integrals.extend(std::iter::repeat_n(0.0, shapes));
                    self.splines.len() - 1
                });
                let integrals = &mut self.integrals[place * shapes..(place + 1) * shapes];
                integrals
                    .iter_mut()
                    .zip(values)
                    .for_each(|(sum, shape)| *sum += area * value * shape);
            });
        }
    }
}

impl AddAssign for Blocks {
    fn add_assign(&mut self, mut other: Self) {
        let before = self.splines.len();
        self.ends.extend(other.ends.iter().map(|end| before + end));
        self.splines.append(&mut other.splines);
        self.integrals.append(&mut other.integrals);
    }
}

/// How often a triangle is quartered so that its parts are no wider than the cells that it lies on.
fn quarterings(grid: &Grid, corners: &[[f64; 2]; 3]) -> usize {
    let range = |d: usize| {
        let values = corners.map(|corner| corner[d]);
        [
            values.iter().fold(f64::INFINITY, |least, &v| least.min(v)),
            values.iter().fold(f64::NEG_INFINITY, |most, &v| most.max(v)),
        ]
    };
    let (around, along) = (range(0), range(1));
    let cell = grid.cell(along);
    let ratio = f64::max((around[1] - around[0]) / cell[0], (along[1] - along[0]) / cell[1]);
    (0..MOST_QUARTERINGS)
        .find(|&levels| ratio <= (1usize << levels) as f64)
        .unwrap_or(MOST_QUARTERINGS)
}
