//! What a pressure of finite elements exerts on the splines of the wall: a sparse matrix of a mesh and a grid.
//!
//! The pressure is interpolated at the nodes, `p = Sum p_i N_i`, so that `f_j = Sum_i p_i Int N_i B_j dA`, linear in
//! the pressures, and to first order in the unknown too.

use oilwedge_fem::integrate::Rule;
use oilwedge_fem::mapping::Mapping;
use oilwedge_fem::{Quadrature, Space, integrate};

use super::blocks::Blocks;
use super::grid::Grid;

/// Most times that triangles which are wider than the cells of the grid are quartered.
const MOST_QUARTERINGS: usize = 4;
/// Most times that triangles which are wider than the cells of the grid are halved.
const MOST_HALVINGS: usize = 2 * MOST_QUARTERINGS;

/// Integrals of the products of shape functions and splines, triangle by triangle.
#[derive(Debug, Clone)]
pub(crate) struct Pressing {
    grid: Grid,
    blocks: Blocks,
}

impl Pressing {
    /// The forces of a space on a grid.
    pub(crate) fn new(space: &Space, grid: &Grid) -> Self {
        let (mesh, degree) = (space.mesh(), space.degree());
        let whole = Rule::for_degree(degree);
        let blocks = integrate(mesh, |t| {
            let mut block = Blocks::default();
            let mut add = |rule: &Rule| {
                rule.visit(mesh, t, |points| {
                    for (q, &position) in points.positions.iter().enumerate() {
                        let shares = points.shapes(q).map(|shape| points.area(q) * shape);
                        grid.each_at(position, |spline, value| block.add(spline, value, &shares, space.shapes()));
                    }
                });
            };
            match ratio(grid, &mesh.corners(t)) <= 1.0 {
                true => add(&whole),
                false => each_part(grid, &Mapping::of(mesh, t), (WHOLE, 0), &mut |part| {
                    add(&Rule::new(Quadrature::for_degree(degree).on_part(part), degree));
                }),
            }
            block.ended()
        });
        Self { grid: grid.clone(), blocks }
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

/// Corners of a part of the reference triangle.
type PartCorners = [[f64; 2]; 3];

/// All of it.
const WHOLE: PartCorners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];

/// Calls `visit` with the parts of a part of a triangle, which was halved so often, that are no wider than the cells
/// that they lie on: each is halved at the edge that is longest, in cells.
fn each_part(
    grid: &Grid,
    mapping: &Mapping,
    (part, halvings): (PartCorners, usize),
    visit: &mut impl FnMut(PartCorners),
) {
    let corners = part.map(|corner| mapping.at(corner).position);
    if halvings == MOST_HALVINGS || ratio(grid, &corners) <= 1.0 {
        return visit(part);
    }
    let cell = cell_of(grid, &corners);
    let length = |k: usize| {
        let ([x, z], [to_x, to_z]) = (corners[k], corners[(k + 1) % 3]);
        f64::max((to_x - x).abs() / cell[0], (to_z - z).abs() / cell[1])
    };
    let longest = (1..3).fold(0, |longest, k| if length(k) > length(longest) { k } else { longest });
    let [from, to, opposite] = [0, 1, 2].map(|k| part[(longest + k) % 3]);
    let middle = [0, 1].map(|d| 0.5 * (from[d] + to[d]));
    for half in [[from, middle, opposite], [middle, to, opposite]] {
        each_part(grid, mapping, (half, halvings + 1), visit);
    }
}

/// Range of a coordinate of some corners.
fn range(corners: &[[f64; 2]; 3], d: usize) -> [f64; 2] {
    let values = corners.map(|corner| corner[d]);
    [
        values.iter().fold(f64::INFINITY, |least, &v| least.min(v)),
        values.iter().fold(f64::NEG_INFINITY, |most, &v| most.max(v)),
    ]
}

/// Width and least length [m] of the cells under a triangle.
fn cell_of(grid: &Grid, corners: &[[f64; 2]; 3]) -> [f64; 2] {
    grid.cell(range(corners, 1))
}

/// Width or length of a triangle over that of the cells that it lies on, whichever is greater.
fn ratio(grid: &Grid, corners: &[[f64; 2]; 3]) -> f64 {
    let cell = cell_of(grid, corners);
    let ratio = |d: usize| {
        let [least, most] = range(corners, d);
        (most - least) / cell[d]
    };
    f64::max(ratio(0), ratio(1))
}

/// How often a triangle is quartered so that its parts are no wider than the cells that it lies on.
pub(crate) fn quarterings(grid: &Grid, corners: &[[f64; 2]; 3]) -> usize {
    let ratio = ratio(grid, corners);
    (0..MOST_QUARTERINGS).find(|&levels| ratio <= (1usize << levels) as f64).unwrap_or(MOST_QUARTERINGS)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wall::spline::{Along, Around};
    use oilwedge_mesh::{Mesh, RawMesh};

    /// Cells of 1 by 1.
    fn grid() -> Grid {
        let breaks: Vec<f64> = (0..=8).map(f64::from).collect();
        Grid {
            radius: 16.0 / std::f64::consts::TAU,
            around: Around::centred(16, 0.0),
            along: Along::on_breaks(&breaks),
        }
    }

    /// Parts of a triangle with these corners [m], in cells.
    fn parts(corners: [[f64; 2]; 3]) -> Vec<PartCorners> {
        let mesh = Mesh::build(RawMesh { points: corners.to_vec(), triangles: vec![[0, 1, 2]], ..RawMesh::default() })
            .expect("a mesh");
        let mut parts = Vec::new();
        each_part(&grid(), &Mapping::of(&mesh, 0), (WHOLE, 0), &mut |part| parts.push(part));
        parts
    }

    #[test]
    fn parts_fill_a_triangle_and_are_no_wider_than_cells() {
        let area = |[a, b, c]: &PartCorners| (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        for corners in [
            [[0.0, 1.0], [7.5, 1.0], [7.5, 1.2]],
            [[0.0, 1.0], [3.0, 1.5], [1.0, 4.5]],
            [[0.0, 1.0], [0.7, 1.5], [0.2, 1.9]],
        ] {
            let parts = parts(corners);
            let sum: f64 = parts.iter().map(area).sum();
            assert!((sum - 1.0).abs() < 1e-14 && parts.iter().all(|part| area(part) > 0.0), "{sum}");
            let [a, b, c] = corners;
            let at = |[s, t]: [f64; 2]| [0, 1].map(|d| a[d] + s * (b[d] - a[d]) + t * (c[d] - a[d]));
            assert!(parts.iter().all(|part| ratio(&grid(), &part.map(at)) <= 1.0), "{corners:?}");
        }
        // Eight cells long and a fifth of one wide: 64 parts by quarters.
        assert!(parts([[0.0, 1.0], [7.5, 1.0], [7.5, 1.2]]).len() < 32);
    }
}
