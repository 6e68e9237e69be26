//! What one sub-triangle contributes to the balance of its three cells.
//!
//! ```text
//! R = K p + B theta      outflow through the inner faces of the cells, and what they store
//! K_ab = Int h^3/(12 mu) grad l_a . grad l_b                             Poiseuille, linear elements
//! B, by faces:    C_ab = Int_face U.n h/2;   a -> b:  max(C,0) theta_a + min(C,0) theta_b
//! B, residual:    k_i = |T| U.grad l_i / 2,  u_i = h_i theta_i:  row i gets its part of k_0 u_0 + k_1 u_1 + k_2 u_2,
//!                 N: k_i^+ (u_i - u_in), u_in = sum k_j^- u_j / sum k_j^-;   LDA: k_i^+ / sum k_j^+ of it;
//!                 less what leaves through the sides of T (q = -2 k_c, opposite corner c):
//!                 q (3 u_i + u_j)/8 from row i, q (3 u_j + u_i)/8 from row j
//! ```
//! The faces are exact and central where theta = 1. The residual distributions carry oil where theta < 1 without
//! the crosswind smearing of faces: N is positive and of first order; LDA (low diffusion, type A) is of second order
//! and keeps the edges of oil streaks sharp on any mesh, but may overshoot there. Columns sum to zero in all, but for
//! what is stored.
//!
//! Roe, Cranfield CoA 8703 (1987); Struijs, Deconinck, Roe, VKI LS 1991-01.

use oilwedge_fem::ControlVolumes;
use oilwedge_fem::control_volumes::SUB_TRIANGLES;
use oilwedge_mesh::Mesh;
use rayon::prelude::*;

use crate::film_law::FilmLaw;

/// Sides of a sub-triangle, from corner to corner.
pub(super) const SIDES: [(usize, usize); 3] = [(0, 1), (1, 2), (2, 0)];
/// Triangles that one task visits.
const CELLS_A_TASK: usize = 1024;

/// How the oil of a sub-triangle is carried.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Transport {
    /// Through the faces between cells, from upstream.
    Faces,
    /// By the N scheme.
    Positive,
    /// By the LDA scheme.
    LowDiffusion,
}

/// Coefficients of one sub-triangle.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Block {
    /// `K_ab` of each side.
    pub(super) stiffness: [f64; 3],
    /// `C_ab` of the face across each side, from its first corner to its second [m3/s].
    pub(super) couette: [f64; 3],
    /// `k_i` [m2/s].
    pub(super) weight: [f64; 3],
    /// h at the corners [m].
    pub(super) thickness: [f64; 3],
    /// Volume taken up by each cell's piece while full [m3/s].
    pub(super) storage: [f64; 3],
    /// Volume of each cell's piece while full [m3].
    pub(super) volume: [f64; 3],
}

/// `K`, row by row.
pub(super) type Square = [[f64; 3]; 3];

/// The coefficients of all sub-triangles under `law`.
pub(super) fn blocks(law: &FilmLaw, mesh: &Mesh, volumes: &ControlVolumes) -> Vec<Block> {
    let mut blocks = vec![Block::default(); volumes.triangles.len()];
    blocks
        .par_chunks_mut(4 * CELLS_A_TASK)
        .enumerate()
        .for_each(|(task, chunk)| {
            for (k, blocks) in chunk.chunks_mut(4).enumerate() {
                let cell = task * CELLS_A_TASK + k;
                let nodes = mesh.nodes(cell);
                for (block, corners) in blocks.iter_mut().zip(SUB_TRIANGLES) {
                    *block = Block::new(law, cell, corners.map(|node| nodes[node]));
                }
            }
        });
    blocks
}

impl Block {
    fn new(law: &FilmLaw, cell: usize, x: [[f64; 2]; 3]) -> Self {
        let between = |a: [f64; 2], b: [f64; 2], s: f64| [a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])];
        let middles = SIDES.map(|(a, b)| between(x[a], x[b], 0.5));
        let centroid = [0, 1].map(|d| (x[0][d] + x[1][d] + x[2][d]) / 3.0);
        // Two Gauss points on each of the three faces, the corners, the middles of the sides.
        let gauss = [0.5 - 0.5 / 3f64.sqrt(), 0.5 + 0.5 / 3f64.sqrt()];
        let mut points = [[0.0; 2]; 12];
        for k in 0..3 {
            points[2 * k] = between(middles[k], centroid, gauss[0]);
            points[2 * k + 1] = between(middles[k], centroid, gauss[1]);
            points[6 + k] = x[k];
            points[9 + k] = middles[k];
        }
        let (film, flows) = law.film_and_flows(cell, &points);
        let doubled = (x[1][0] - x[0][0]) * (x[2][1] - x[0][1]) - (x[1][1] - x[0][1]) * (x[2][0] - x[0][0]);
        let area = 0.5 * doubled;
        // Gradients of the linear functions: the opposite side turned by 90 degrees.
        let gradient = [0, 1, 2].map(|i| {
            let (b, c) = (x[(i + 1) % 3], x[(i + 2) % 3]);
            [(b[1] - c[1]) / doubled, (c[0] - b[0]) / doubled]
        });
        let conductance = (flows[9].conductance + flows[10].conductance + flows[11].conductance) / 3.0;
        let velocity = law.velocity();
        let mut block = Self {
            weight: gradient.map(|g| 0.5 * area * (velocity[0] * g[0] + velocity[1] * g[1])),
            thickness: [6, 7, 8].map(|k| film[k].thickness),
            // The centroid of a cell's piece lies at (22, 7, 7)/36.
            storage: [0, 1, 2].map(|i| weighted(i, |k| flows[6 + k].storage) * area / 3.0),
            volume: [0, 1, 2].map(|i| weighted(i, |k| film[6 + k].thickness) * area / 3.0),
            ..Self::default()
        };
        for (k, (a, b)) in SIDES.into_iter().enumerate() {
            let (g, h) = (gradient[a], gradient[b]);
            block.stiffness[k] = conductance * area * (g[0] * h[0] + g[1] * h[1]);
            let along = [centroid[0] - middles[k][0], centroid[1] - middles[k][1]];
            let normal = [along[1], -along[0]];
            let (one, two) = (flows[2 * k].flux, flows[2 * k + 1].flux);
            block.couette[k] = 0.5 * (normal[0] * (one[0] + two[0]) + normal[1] * (one[1] + two[1]));
        }
        block
    }

    /// `K`.
    pub(super) fn pressure(&self) -> Square {
        let mut square = [[0.0; 3]; 3];
        for (k, (a, b)) in SIDES.into_iter().enumerate() {
            let coupling = self.stiffness[k];
            square[a][b] += coupling;
            square[b][a] += coupling;
            square[a][a] -= coupling;
            square[b][b] -= coupling;
        }
        square
    }

    /// `B`; faces take the oil from upstream as in the film `upwind` (itself, unless this is a change of it).
    pub(super) fn transport(&self, form: Transport, upwind: &Self) -> Square {
        let mut square = match form {
            Transport::Faces => self.faces(upwind),
            Transport::Positive => self.n_scheme(),
            Transport::LowDiffusion => self.low_diffusion(),
        };
        if form != Transport::Faces {
            self.take_sides(&mut square);
        }
        for i in 0..3 {
            square[i][i] += self.storage[i];
        }
        square
    }

    fn faces(&self, upwind: &Self) -> Square {
        let mut square = [[0.0; 3]; 3];
        for (k, (a, b)) in SIDES.into_iter().enumerate() {
            let from = if upwind.couette[k] > 0.0 { a } else { b };
            square[a][from] += self.couette[k];
            square[b][from] -= self.couette[k];
        }
        square
    }

    fn n_scheme(&self) -> Square {
        let (k, h) = (self.weight, self.thickness);
        let inflow = self.inflow();
        let mut square = [[0.0; 3]; 3];
        for i in (0..3).filter(|&i| k[i] > 0.0) {
            square[i][i] += k[i] * h[i];
            for j in (0..3).filter(|&j| k[j] < 0.0) {
                square[i][j] -= k[i] * k[j] / inflow * h[j];
            }
        }
        square
    }

    fn low_diffusion(&self) -> Square {
        let inflow = self.inflow();
        self.weight.map(|k| {
            let part = k.max(0.0) / -inflow;
            [0, 1, 2].map(|j| part * self.weight[j] * self.thickness[j])
        })
    }

    /// What leaves through the sides of T belongs to no inner face.
    fn take_sides(&self, square: &mut Square) {
        let h = self.thickness;
        for (i, j) in SIDES {
            let q = -2.0 * self.weight[3 - i - j];
            square[i][i] -= 0.375 * q * h[i];
            square[i][j] -= 0.125 * q * h[j];
            square[j][j] -= 0.375 * q * h[j];
            square[j][i] -= 0.125 * q * h[i];
        }
    }

    /// `sum k_j^-`.
    fn inflow(&self) -> f64 {
        self.weight.iter().map(|k| k.min(0.0)).sum()
    }

    /// True if a corner that is not downstream is in the cavity: the inflow side is starved, or the side along the flow.
    pub(super) fn is_starved(&self, cavity: [bool; 3]) -> bool {
        const ALONG: f64 = 0.1;
        let largest = self.weight.iter().fold(0.0f64, |m, k| m.max(k.abs()));
        (0..3).any(|i| cavity[i] && self.weight[i] < ALONG * largest)
    }
}

fn weighted(i: usize, value: impl Fn(usize) -> f64) -> f64 {
    (0..3).map(|k| if k == i { 22.0 } else { 7.0 } / 36.0 * value(k)).sum()
}
