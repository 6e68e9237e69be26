//! What one sub-triangle contributes to the balance of its three cells.
//!
//! ```text
//! R = K p + B theta      outflow through the inner faces of the cells, and what they store
//! K_ab = |T| k grad l_a . grad l_b                           Poiseuille, linear elements
//! B, by faces:    C_ab = |face| F.n;   a -> b:  max(C,0) theta_a + min(C,0) theta_b
//! B, residual:    k_i = |T| U.grad l_i / 2,  u_i = h_i theta_i:  row i gets its part of k_0 u_0 + k_1 u_1 + k_2 u_2,
//!                 N: k_i^+ (u_i - u_in), u_in = sum k_j^- u_j / sum k_j^-;   LDA: k_i^+ / sum k_j^+ of it;
//!                 less what leaves through the sides of T (q = -2 k_c, opposite corner c):
//!                 q (3 u_i + u_j)/8 from row i, q (3 u_j + u_i)/8 from row j
//! B, history:     N, and a -> b:  max(d,0) theta_a + min(d,0) theta_b,   d_ab = (r_a - r_b)/3,   r = faces(1) - N(1)
//! ```
//! `1/k` and `F/k` are the means of `12 mu/h^3` and `(12 mu/h^3) U h/2` over T, which is exact along a flow that does not
//! vary (Scharfetter, Gummel, IEEE Trans. Electron Devices 16 (1969) 64, for the idea). The faces are exact and central where theta = 1. The residual distributions carry oil where theta < 1 without
//! the crosswind smearing of faces: N is positive and of first order; LDA (low diffusion, type A) is of second order
//! and keeps the edges of oil streaks sharp on any mesh, but may overshoot there. Columns sum to zero in all, but for
//! what is stored.
//!
//! A film with a history is carried by one form all along, so that what it does is continuous in time: the N scheme, with small flows that make it that of the
//! faces where theta = 1. It is positive too.
//!
//! Roe, Cranfield CoA 8703 (1987); Struijs, Deconinck, Roe, VKI LS 1991-01.

use oilwedge_fem::control_volumes::sub_triangles;
use oilwedge_fem::{ControlVolumes, Space};
use rayon::prelude::*;

use crate::film_law::{AtPoints, FilmAndFlows, FilmLaw};
use crate::{FilmChange, FilmFlow, FilmPoint};

/// Sides of a sub-triangle, from corner to corner.
pub(super) const SIDES: [(usize, usize); 3] = [(0, 1), (1, 2), (2, 0)];
/// Triangles that one task visits.
const CELLS_A_TASK: usize = 1024;

/// How the oil of a sub-triangle is carried.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AdvectionScheme {
    /// Through the faces between cells, from upstream.
    Faces,
    /// By the N scheme.
    Positive,
    /// By the LDA scheme.
    LowDiffusion,
    /// By the N scheme, corrected so that a full film is that of the faces.
    Corrected,
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
    /// h at the corners [m], of rough surfaces the mean gap.
    pub(super) thickness: [f64; 3],
    /// Volume taken up by each cell's piece while full [m3/s].
    pub(super) storage: [f64; 3],
    /// Volume of each cell's piece while full [m3].
    pub(super) volume: [f64; 3],
}

/// `K`, row by row.
pub(super) type Square = [[f64; 3]; 3];

/// The coefficients of all sub-triangles under `law`.
pub(super) fn blocks(law: &FilmLaw, space: &Space, volumes: &ControlVolumes) -> Vec<Block> {
    let mut blocks = vec![Block::default(); volumes.triangles.len()];
    let tasks = blocks.par_chunks_mut(volumes.per_triangle * CELLS_A_TASK).enumerate();
    tasks.for_each(|(task, chunk)| {
        for (k, blocks) in chunk.chunks_mut(volumes.per_triangle).enumerate() {
            let cell = task * CELLS_A_TASK + k;
            let points = Points::new(space, cell);
            let at = law.oil_and_flows(cell, points.positions());
            for (t, block) in blocks.iter_mut().enumerate() {
                *block = points.block(t, &at, None);
            }
        }
    });
    blocks
}

/// The blocks of a triangle, and how they change under a `change` of the law.
pub(super) fn blocks_and_changes(
    law: &FilmLaw,
    change: FilmChange<'_>,
    space: &Space,
    volumes: &ControlVolumes,
) -> Vec<[Block; 2]> {
    let mut blocks = vec![[Block::default(); 2]; volumes.triangles.len()];
    let tasks = blocks.par_chunks_mut(volumes.per_triangle * CELLS_A_TASK).enumerate();
    tasks.for_each(|(task, chunk)| {
        for (k, blocks) in chunk.chunks_mut(volumes.per_triangle).enumerate() {
            let cell = task * CELLS_A_TASK + k;
            let points = Points::new(space, cell);
            let [at, change] = law.oil_and_flows_with_change(change, cell, points.positions());
            for (t, block) in blocks.iter_mut().enumerate() {
                *block = [points.block(t, &at, None), points.block(t, &at, Some(&change))];
            }
        }
    });
    blocks
}

/// Where the film of a triangle is evaluated: at its nodes, and in the middle of every side of its sub-triangles.
pub(super) struct Points {
    positions: AtPoints<[f64; 2]>,
    number: usize,
    /// Nodes at the corners of each sub-triangle: the first points.
    pub(super) sub_triangles: &'static [[usize; 3]],
    /// The points in the middles of the sides of each sub-triangle.
    pub(super) middles: [[usize; 3]; 4],
}

impl Points {
    pub(super) fn new(space: &Space, cell: usize) -> Self {
        let nodes = space.mesh().nodes(cell);
        let mut points = Self {
            positions: AtPoints::default(),
            number: space.shapes(),
            sub_triangles: sub_triangles(space, cell),
            middles: [[0; 3]; 4],
        };
        points.positions[..points.number].copy_from_slice(&nodes[..points.number]);
        // A side inside the triangle belongs to two of them.
        let mut ends = AtPoints::<[usize; 2]>::default();
        for (t, corners) in points.sub_triangles.iter().enumerate() {
            for (k, (i, j)) in SIDES.into_iter().enumerate() {
                let (a, b) = (corners[i].min(corners[j]), corners[i].max(corners[j]));
                let known = (space.shapes()..points.number).find(|&point| ends[point] == [a, b]);
                points.middles[t][k] = known.unwrap_or_else(|| {
                    ends[points.number] = [a, b];
                    points.positions[points.number] = [0, 1].map(|d| 0.5 * (nodes[a][d] + nodes[b][d]));
                    points.number += 1;
                    points.number - 1
                });
            }
        }
        points
    }

    pub(super) fn positions(&self) -> &[[f64; 2]] {
        &self.positions[..self.number]
    }

    /// Coefficients of sub-triangle `t`, or their change with a change of film and flows.
    pub(super) fn block(&self, t: usize, at: &FilmAndFlows, change: Option<&FilmAndFlows>) -> Block {
        let (corners, middles) = (self.sub_triangles[t], self.middles[t]);
        let flow = match change {
            None => Flow::mean(&middles.map(|point| at.1[point])),
            Some(change) => Flow::change(&middles.map(|point| at.1[point]), &middles.map(|point| change.1[point])),
        };
        let (film, flows) = change.unwrap_or(at);
        let velocity = at.0[corners[0]].velocity;
        let (x, middles) = (corners.map(|point| self.positions[point]), middles.map(|point| self.positions[point]));
        Block::new(velocity, x, middles, corners.map(|point| film[point]), corners.map(|point| flows[point]), flow)
    }
}

/// What flows in a sub-triangle: conductance and flux that are exact for a flow that does not vary along it, however its
/// thickness does: `J = F - k grad p` with `1/k` and `F/k` the means of those at the points.
#[derive(Debug, Clone, Copy, Default)]
struct Flow {
    conductance: f64,
    flux: [f64; 2],
}

impl Flow {
    fn mean(points: &[FilmFlow]) -> Self {
        let resistance: f64 = points.iter().map(|flow| 1.0 / flow.conductance).sum();
        let drive = |d: usize| points.iter().map(|flow| flow.flux[d] / flow.conductance).sum::<f64>();
        Self { conductance: points.len() as f64 / resistance, flux: [drive(0) / resistance, drive(1) / resistance] }
    }

    /// First-order change of [`Flow::mean`].
    fn change(points: &[FilmFlow], changes: &[FilmFlow]) -> Self {
        let mean = Self::mean(points);
        let weights = points.iter().map(|flow| mean.conductance / flow.conductance / points.len() as f64);
        let mut change = Self::default();
        for ((weight, flow), by) in weights.zip(points).zip(changes) {
            let relative = by.conductance / flow.conductance;
            change.conductance += weight * mean.conductance * relative;
            for d in 0..2 {
                change.flux[d] += weight * (by.flux[d] - relative * (flow.flux[d] - mean.flux[d]));
            }
        }
        change
    }
}

impl Block {
    /// From what is at the corners `x`, and what flows on the whole.
    fn new(
        velocity: [f64; 2],
        x: [[f64; 2]; 3],
        middles: [[f64; 2]; 3],
        film: [FilmPoint; 3],
        flows: [FilmFlow; 3],
        flow: Flow,
    ) -> Self {
        let doubled = (x[1][0] - x[0][0]) * (x[2][1] - x[0][1]) - (x[1][1] - x[0][1]) * (x[2][0] - x[0][0]);
        let area = 0.5 * doubled;
        // Gradients of the linear functions: the opposite side turned by 90 degrees.
        let gradient = [0, 1, 2].map(|i| {
            let (b, c) = (x[(i + 1) % 3], x[(i + 2) % 3]);
            [(b[1] - c[1]) / doubled, (c[0] - b[0]) / doubled]
        });
        let mut block = Self {
            weight: gradient.map(|g| 0.5 * area * (velocity[0] * g[0] + velocity[1] * g[1])),
            thickness: [0, 1, 2].map(|k| film[k].thickness),
            // The centroid of a cell's piece lies at (22, 7, 7)/36.
            storage: [0, 1, 2].map(|i| weighted(i, |k| flows[k].storage) * area / 3.0),
            volume: [0, 1, 2].map(|i| weighted(i, |k| film[k].thickness) * area / 3.0),
            ..Self::default()
        };
        let centroid = [0, 1].map(|d| (x[0][d] + x[1][d] + x[2][d]) / 3.0);
        for (k, (a, b)) in SIDES.into_iter().enumerate() {
            let (g, h) = (gradient[a], gradient[b]);
            block.stiffness[k] = flow.conductance * area * (g[0] * h[0] + g[1] * h[1]);
            let along = [centroid[0] - middles[k][0], centroid[1] - middles[k][1]];
            block.couette[k] = along[1] * flow.flux[0] - along[0] * flow.flux[1];
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
    pub(super) fn transport(&self, scheme: AdvectionScheme, upwind: &Self) -> Square {
        let mut square = match scheme {
            AdvectionScheme::Faces => self.faces(upwind),
            AdvectionScheme::Positive => self.n_scheme(),
            AdvectionScheme::LowDiffusion => self.low_diffusion(),
            AdvectionScheme::Corrected => self.corrected(upwind),
        };
        if matches!(scheme, AdvectionScheme::Positive | AdvectionScheme::LowDiffusion) {
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

    pub(super) fn n_scheme(&self) -> Square {
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

    pub(super) fn low_diffusion(&self) -> Square {
        let inflow = self.inflow();
        self.weight.map(|k| {
            let part = k.max(0.0) / -inflow;
            [0, 1, 2].map(|j| part * self.weight[j] * self.thickness[j])
        })
    }

    fn corrected(&self, upwind: &Self) -> Square {
        let mut square = self.n_scheme();
        self.take_sides(&mut square);
        let (missing, of_upwind) = (self.missing(), upwind.missing());
        for (a, b) in SIDES {
            let flow = (missing[a] - missing[b]) / 3.0;
            let from = if of_upwind[a] > of_upwind[b] { a } else { b };
            square[a][from] += flow;
            square[b][from] -= flow;
        }
        square
    }

    /// Outflow of each piece of a full film by the faces, less that by the N scheme.
    fn missing(&self) -> [f64; 3] {
        let mut by_n = self.n_scheme();
        self.take_sides(&mut by_n);
        let mut missing = by_n.map(|row| -row.iter().sum::<f64>());
        for (k, (a, b)) in SIDES.into_iter().enumerate() {
            missing[a] += self.couette[k];
            missing[b] -= self.couette[k];
        }
        missing
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

    /// Thickness [m] of the oil that comes in through the corners upstream, of which a part `theta` is full.
    pub(super) fn inflowing(&self, theta: [f64; 3]) -> f64 {
        let sum: f64 = (0..3).map(|i| self.weight[i].min(0.0) * self.thickness[i] * theta[i]).sum();
        sum / self.inflow()
    }

    /// True if the inflow side is starved: a corner upstream is in the cavity; or one to the side of the flow while none
    /// downstream is (the film's edge along a supply; downstream it would be the rupture line).
    pub(super) fn is_starved(&self, cavity: [bool; 3]) -> bool {
        const ROUNDING: f64 = 1e-9;
        const ASIDE: f64 = 0.1;
        let largest = self.weight.iter().fold(0.0f64, |m, k| m.max(k.abs()));
        let any = |from: f64, to: f64| {
            (0..3).any(|i| cavity[i] && self.weight[i] >= from * largest && self.weight[i] < to * largest)
        };
        let (upstream, aside, downstream) = (any(-1.0, -ROUNDING), any(-ROUNDING, ASIDE), any(ASIDE, 2.0));
        upstream || (aside && !downstream)
    }
}

fn weighted(i: usize, value: impl Fn(usize) -> f64) -> f64 {
    (0..3).map(|k| if k == i { 22.0 } else { 7.0 } / 36.0 * value(k)).sum()
}
