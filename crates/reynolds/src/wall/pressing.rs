//! What a pressure of finite elements exerts on the splines of the wall: a sparse matrix of a mesh and a grid.
//!
//! The pressure is interpolated at the nodes, `p = Sum p_i N_i`, so that `f_j = Sum_i p_i Int N_i B_j dA`, linear in the pressures, and to first order in the
//! unknown too.

use oilwedge_fem::integrate::Rule;
use oilwedge_fem::{Quadrature, Space, integrate};

use super::blocks::Blocks;
use super::grid::Grid;

/// Most times that triangles are quartered which are wider than the cells of the grid.
const MOST_QUARTERINGS: usize = 4;

/// Integrals of the products of shape functions and splines, triangle by triangle.
#[derive(Debug, Clone)]
pub(crate) struct Pressing {
    grid: Grid,
    blocks: Blocks,
}

impl Pressing {
    /// Of a space on a grid.
    pub(crate) fn new(space: &Space, grid: &Grid) -> Self {
        let (mesh, degree) = (space.mesh(), space.degree());
        let rule = |levels: usize| Rule::new(Quadrature::for_degree(degree).quartered(levels), degree);
        let rules: Vec<Rule> = (0..=MOST_QUARTERINGS).map(rule).collect();
        let blocks = integrate(mesh, |t| {
            let levels = quarterings(grid, &mesh.corners(t));
            let block: Blocks = rules[levels].integrate(mesh, t, |points, block: &mut Blocks| {
                for (q, &position) in points.positions.iter().enumerate() {
                    let shares = points.shapes(q).map(|shape| points.area(q) * shape);
                    grid.each_at(position, |spline, value| {
                        block.add(spline, value, &shares, space.shapes())
                    });
                }
            });
            block.ended()
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
        self.blocks.transposed(space, pressures, self.grid.number())
    }

    /// The transposed product: integral of each shape function times the function of the grid with these coefficients.
    pub(crate) fn integrals(&self, space: &Space, coefficients: &[f64]) -> Vec<f64> {
        self.blocks.times(space, coefficients)
    }
}

/// How often a triangle is quartered so that its parts are no wider than the cells that it lies on.
pub(crate) fn quarterings(grid: &Grid, corners: &[[f64; 2]; 3]) -> usize {
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
